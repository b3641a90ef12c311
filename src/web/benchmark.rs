//! The benchmark: its templates and tasks, their difficulty, its folds, and the scores for comparing agents.

use js_sys::{Array, Number};
use serde_json::json;
use wasm_bindgen::prelude::*;

use super::data::{from_js, to_js, whole_number};
use super::error::{Code, error};
use super::maps::check_size;
use crate::benchmark::difficulty;
use crate::benchmark::folds::{FOLDS, Fold, Setup};
use crate::puzzle::task::{self, TaskError, TaskId};
use crate::puzzle::templates::TEMPLATES;

thread_local! {
    static SHIPPED: difficulty::Difficulty = difficulty::Difficulty::shipped();
}

/// Returns all templates with the ids of their tasks.
#[wasm_bindgen(unchecked_return_type = "Template[]")]
pub fn templates() -> Result<JsValue, JsValue> {
    let templates = TEMPLATES.iter().map(|template| {
        let tasks: Vec<TaskId> = task::ids(template).collect();
        json!({"id": format!("{:05}", template.number), "name": template.name, "story": template.story, "tasks": tasks})
    });
    to_js(&templates.collect::<Vec<_>>())
}

/// Returns the difficulty of a task.
#[wasm_bindgen(unchecked_return_type = "Difficulty")]
pub fn difficulty(id: &str) -> Result<JsValue, JsValue> {
    let id: TaskId = id.parse().map_err(|reason: TaskError| error(Code::BadTask, reason))?;
    let (balls, rate) = SHIPPED.with(|shipped| (shipped.balls, shipped.solve_rate(id)));
    let rate = rate.ok_or_else(|| error(Code::BadTask, TaskError::NotInBenchmark(id)))?;
    to_js(&json!({"balls": balls, "solve_rate": rate}))
}

/// Returns the share of uniform valid balls that solve each task, 0..1, in the order of `templates`.
#[wasm_bindgen(js_name = solveRates)]
pub fn solve_rates() -> Vec<f64> {
    SHIPPED.with(|shipped| shipped.solve_rates().collect())
}

/// Returns the ids of the tasks of one of PHYRE's folds, each list ascending.
#[wasm_bindgen(unchecked_return_type = "Fold")]
pub fn fold(
    #[wasm_bindgen(unchecked_param_type = "Setup")] setup: JsValue,
    number: &Number,
) -> Result<JsValue, JsValue> {
    let setup: Setup = from_js(setup).map_err(|_| error(Code::BadData, "a setup is \"within\" or \"cross\""))?;
    let last = u32::from(FOLDS) - 1;
    let number = whole_number(number, 0..=last, format_args!("the folds are 0 to {last}"))?;
    let Fold { train, dev, test } = Fold::new(setup, number as u8);
    to_js(&json!({"train": train, "dev": dev, "test": test}))
}

/// Returns PHYRE's auccess, 0..=100, of an agent. The argument holds, for each task, the number (from 1) of the attempt
/// that first solved it, or null.
#[wasm_bindgen]
pub fn auccess(
    #[wasm_bindgen(unchecked_param_type = "(number | null)[]")] first_solved: &JsValue,
) -> Result<f64, JsValue> {
    const RULE: &str = "the number of the first attempt that solved the task, counted from 1, or null";
    let list = || error(Code::BadData, format!("auccess takes an array with, for each task, {RULE}"));
    let firsts: &Array = first_solved.dyn_ref().ok_or_else(list)?;
    let attempt = |(index, first): (usize, JsValue)| -> Result<Option<usize>, JsValue> {
        let first = Some(first).filter(|first| !first.is_null() && !first.is_undefined());
        let rule = format_args!("item {index} must be {RULE}");
        first.map(|first| whole_number(&first, 1..=u32::MAX, rule).map(|number| number as usize)).transpose()
    };
    let attempts = firsts.iter().enumerate().map(attempt).collect::<Result<Vec<_>, _>>()?;
    Ok(crate::benchmark::auccess::auccess(&attempts))
}

/// Returns the soft IoU of two maps of 64 x 64 values in 0..=1: from 0 (nothing in common) to 1 (equal).
#[wasm_bindgen(js_name = softIou)]
pub fn soft_iou(one: &[f32], other: &[f32]) -> Result<f64, JsValue> {
    check_size(one.len())?;
    check_size(other.len())?;
    Ok(crate::raster::soft_iou::soft_iou(one, other))
}

//! The figures that attempts and agents are compared by, soft IoU of two maps and auccess, and the folds on which
//! agents are measured.

use js_sys::Array;
use serde::Serialize;
use wasm_bindgen::prelude::*;

use super::error::{Code, error, from_js, to_js, whole_number};
use crate::benchmark::folds::{FOLDS, Fold, Setup};
use crate::raster::CELLS;

/// Returns the soft IoU of two maps of 64 x 64 values in 0..=1: from 0 (nothing in common) to 1 (equal).
///
/// # Errors
/// `bad_map` if one is not 64 x 64.
#[wasm_bindgen(js_name = softIou)]
pub fn soft_iou(one: &[f32], other: &[f32]) -> Result<f64, JsValue> {
    match [one.len(), other.len()] {
        [CELLS, CELLS] => Ok(crate::raster::soft_iou::soft_iou(one, other)),
        [a, b] => Err(error(Code::BadMap, format!("a map holds {CELLS} values, not {a} or {b}"))),
    }
}

/// Returns PHYRE's auccess, 0..=100, of an agent, from the attempt (from 1) that first solved each task, or null.
///
/// # Errors
/// `bad_data` if it is not a list of whole numbers from 1 and nulls.
#[wasm_bindgen]
pub fn auccess(
    #[wasm_bindgen(unchecked_param_type = "(number | null)[]")] first_solved: JsValue,
) -> Result<f64, JsValue> {
    const RULE: &str = "the number of the first attempt that solved the task, counted from 1, or null";
    if !Array::is_array(&first_solved) {
        return Err(error(Code::BadData, format!("auccess takes an array: for each task {RULE}")));
    }
    let attempt = |(index, first): (usize, JsValue)| -> Result<Option<usize>, JsValue> {
        if first.is_null() || first.is_undefined() {
            return Ok(None);
        }
        let number = whole_number(&first, 1..=u32::MAX, format_args!("item {index} has to be {RULE}"))?;
        Ok(Some(number as usize))
    };
    let first_solved: Array = first_solved.unchecked_into();
    let attempts = first_solved.iter().enumerate().map(attempt).collect::<Result<Vec<_>, _>>()?;
    Ok(crate::benchmark::auccess::auccess(&attempts))
}

/// Returns the ids of the tasks of one of PHYRE's folds, each list ascending.
///
/// # Errors
/// `bad_data` if there is no such setup or fold.
#[wasm_bindgen(unchecked_return_type = "Fold")]
pub fn fold(
    #[wasm_bindgen(unchecked_param_type = "Setup")] setup: JsValue,
    #[wasm_bindgen(unchecked_param_type = "number")] number: &JsValue,
) -> Result<JsValue, JsValue> {
    #[derive(Serialize)]
    struct TaskIds {
        train: Vec<String>,
        dev: Vec<String>,
        test: Vec<String>,
    }
    let setup: Setup = from_js(setup).map_err(|_| error(Code::BadData, "a setup is \"within\" or \"cross\""))?;
    let last = u32::from(FOLDS) - 1;
    let number = whole_number(number, 0..=last, format_args!("the folds are 0 to {last}"))?;
    let Fold { train, dev, test } = Fold::new(setup, number as u8);
    let [train, dev, test] = [train, dev, test].map(|tasks| tasks.into_iter().map(String::from).collect());
    to_js(&TaskIds { train, dev, test })
}

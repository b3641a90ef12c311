//! The figures that attempts and agents are compared by, soft IoU of two maps and auccess, and the folds on which
//! agents are measured.

use serde::Serialize;
use wasm_bindgen::prelude::*;

use super::error::{Code, error, from_js, to_js};
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
/// `bad_data` if it is not a list of whole numbers and nulls.
#[wasm_bindgen]
pub fn auccess(
    #[wasm_bindgen(unchecked_param_type = "(number | null)[]")] first_solved: JsValue,
) -> Result<f64, JsValue> {
    Ok(crate::benchmark::auccess::auccess(&from_js::<Vec<Option<usize>>>(first_solved)?))
}

/// Returns the ids of the tasks of one of PHYRE's folds, each list ascending.
///
/// # Errors
/// `bad_data` if there is no such setup or fold.
#[wasm_bindgen(unchecked_return_type = "Fold")]
pub fn fold(#[wasm_bindgen(unchecked_param_type = "Setup")] setup: JsValue, number: f64) -> Result<JsValue, JsValue> {
    #[derive(Serialize)]
    struct TaskIds {
        train: Vec<String>,
        dev: Vec<String>,
        test: Vec<String>,
    }
    let setup: Setup = from_js(setup).map_err(|_| error(Code::BadData, "a setup is \"within\" or \"cross\""))?;
    if number.fract() != 0.0 || !(0.0..f64::from(FOLDS)).contains(&number) {
        return Err(error(Code::BadData, format!("there is no fold {number}: use 0 to {}", FOLDS - 1)));
    }
    let Fold { train, dev, test } = Fold::new(setup, number as u8);
    let [train, dev, test] = [train, dev, test].map(|tasks| tasks.into_iter().map(String::from).collect());
    to_js(&TaskIds { train, dev, test })
}

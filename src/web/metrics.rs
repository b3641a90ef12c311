//! The figures that the page compares player and model by: soft IoU of two maps, and auccess.

use wasm_bindgen::prelude::*;

use super::error::{Code, error, from_js};
use crate::raster::CELLS;

/// Returns the soft IoU of two maps of 64 x 64 values in 0..=1: from 0 (nothing in common) to 1 (equal).
///
/// # Errors
/// `bad_map` if one is not 64 x 64.
#[wasm_bindgen(js_name = softIou)]
pub fn soft_iou(one: &[f32], other: &[f32]) -> Result<f64, JsValue> {
    match [one.len(), other.len()] {
        [CELLS, CELLS] => Ok(crate::play::soft_iou::soft_iou(one, other)),
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

//! The numbers that player and model are compared by, for the page: overlap and auccess.

use wasm_bindgen::prelude::*;

use super::error::{Code, error, from_plain};
use crate::raster::CELLS;

/// How well two pictures of 64 x 64 values in 0..=1 agree: 0 (nothing in common) to 1 (the same).
///
/// # Errors
/// `bad_map` if one is not 64 x 64.
#[wasm_bindgen]
pub fn overlap(one: &[f32], other: &[f32]) -> Result<f64, JsValue> {
    match [one.len(), other.len()] {
        [CELLS, CELLS] => Ok(crate::play::soft_iou::soft_iou(one, other)),
        [a, b] => Err(error(Code::BadMap, format!("a picture holds {CELLS} values, not {a} or {b}"))),
    }
}

/// PHYRE's auccess, 0..=100, of an agent: for each task, the attempt (from 1) that first solved it, or null.
///
/// # Errors
/// `bad_data` if it is no list of whole numbers and nulls.
#[wasm_bindgen]
pub fn auccess(first_solved: JsValue) -> Result<f64, JsValue> {
    Ok(crate::benchmark::auccess::auccess(&from_plain::<Vec<Option<usize>>>(first_solved)?))
}

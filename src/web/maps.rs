//! Draws maps on separate canvases, some of which `frame` overlays on the scene. Row 0 of a map is the bottom.

use wasm_bindgen::{Clamped, prelude::*};
use web_sys::{CanvasRenderingContext2d, ImageData};

use super::error::{Code, error};
use crate::colour::imagined_maps::ImaginedMap;
use crate::colour::outcomes::outcome_colour;
use crate::raster::{CELLS, SIDE};

/// Draws one map, 64 x 64 values with row 0 at the bottom, into a canvas of 64 x 64 pixels. The colour scale runs from
/// 0, which is transparent, to `max`.
#[wasm_bindgen(js_name = paintMap)]
pub fn paint_map(
    context: &CanvasRenderingContext2d,
    #[wasm_bindgen(unchecked_param_type = "MapName")] map: &str,
    values: &[f32],
    max: f32,
    dark: bool,
) -> Result<(), JsValue> {
    let map: ImaginedMap = map.parse().map_err(|sentence: String| error(Code::BadMap, sentence))?;
    check_size(values.len())?;
    let normalised = |value: f32| if max > 0.0 { value / max } else { 0.0 };
    let rows = values.chunks(SIDE).rev().flatten();
    let pixels: Vec<u8> = rows.flat_map(|&value| map.colour(normalised(value), dark)).collect();
    put_pixels(context, &pixels, SIDE)
}

/// Draws a map of outcomes, as returned by `SolveMap.outcomes`, into a canvas of 256 x 256 pixels: 4 x 4 for each cell,
/// so that each outcome has a pattern in addition to its colour.
#[wasm_bindgen(js_name = paintOutcomes)]
pub fn paint_outcomes(context: &CanvasRenderingContext2d, outcomes: &[u8], dark: bool) -> Result<(), JsValue> {
    check_size(outcomes.len())?;
    let pixel = |index: usize| {
        let (x, y) = (index % (4 * SIDE), index / (4 * SIDE));
        outcome_colour(outcomes[(SIDE - 1 - y / 4) * SIDE + x / 4], x % 8, y % 8, dark)
    };
    put_pixels(context, &(0..16 * CELLS).flat_map(pixel).collect::<Vec<u8>>(), 4 * SIDE)
}

/// Refuses a map that is not 64 x 64.
pub(super) fn check_size(cells: usize) -> Result<(), JsValue> {
    let refused = || error(Code::BadMap, format!("a map holds {SIDE} x {SIDE} values, not {cells}"));
    if cells == CELLS { Ok(()) } else { Err(refused()) }
}

/// Copies RGBA pixels, row by row from the top, into the upper left corner of a canvas.
fn put_pixels(context: &CanvasRenderingContext2d, pixels: &[u8], width: usize) -> Result<(), JsValue> {
    let image = ImageData::new_with_u8_clamped_array(Clamped(pixels), width as u32)?;
    context.put_image_data(&image, 0.0, 0.0)
}

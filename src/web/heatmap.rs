//! Draws maps on canvases of their own: heatmaps, their legends, outlines of masks, and maps of outcomes.
//!
//! Row 0 of a map is the bottom. `paint` draws such canvases over the scene; the page shows them beside it too.

use wasm_bindgen::{Clamped, prelude::*};
use web_sys::{CanvasRenderingContext2d, ImageData};

use super::error::{Code, error};
use crate::colour::imagined_maps::{Dashes, ImaginedMap};
use crate::colour::outcomes::outcome_colour;
use crate::raster::contour::contour;
use crate::raster::{CELLS, SIDE};

/// Length of one dash in a legend, pixels.
const DASH: usize = 2;

/// Width of an outline, cells.
const OUTLINE_WIDTH: f64 = 0.4;

/// Draws a heatmap of 64 x 64 values in 0..=max, row 0 at the bottom, into a canvas of 64 x 64 pixels.
pub(crate) fn paint(
    context: &CanvasRenderingContext2d,
    map: ImaginedMap,
    values: &[f32],
    max: f32,
    dark: bool,
) -> Result<(), JsValue> {
    check_size(values.len())?;
    let normalised = |value: f32| if max > 0.0 { value / max } else { 0.0 };
    let rows = values.chunks(SIDE).rev().flatten();
    let pixels: Vec<u8> = rows.flat_map(|&value| map.colour(normalised(value), dark)).collect();
    put_pixels(context, &pixels, SIDE)
}

/// Outlines what is strong in 64 x 64 values in 0..=1 by a smooth line; the canvas is square.
pub(crate) fn outline(
    context: &CanvasRenderingContext2d,
    values: &[f32],
    colour: &str,
    dashes: Dashes,
) -> Result<(), JsValue> {
    check_size(values.len())?;
    let (side, _) = canvas_size(context)?;
    let cell = side as f64 / SIDE as f64;
    context.begin_path();
    for (_, _, [from, to]) in contour(values).iter().filter(|(column, row, _)| dashes[(column + row) % dashes.len()]) {
        context.move_to(from[0] * cell, side as f64 - from[1] * cell);
        context.line_to(to[0] * cell, side as f64 - to[1] * cell);
    }
    context.set_line_width(cell * OUTLINE_WIDTH);
    context.set_line_cap("round");
    context.set_stroke_style_str(colour);
    context.stroke();
    Ok(())
}

/// Draws the outcomes of 64 x 64 cells, 4 x 4 pixels per cell; each outcome has its own colour and pattern.
pub(crate) fn outcomes(context: &CanvasRenderingContext2d, outcomes: &[u8], dark: bool) -> Result<(), JsValue> {
    check_size(outcomes.len())?;
    let pixel = |index: usize| {
        let (x, y) = (index % (4 * SIDE), index / (4 * SIDE));
        outcome_colour(outcomes[(SIDE - 1 - y / 4) * SIDE + x / 4], x % 8, y % 8, dark)
    };
    put_pixels(context, &(0..16 * CELLS).flat_map(pixel).collect::<Vec<u8>>(), 4 * SIDE)
}

/// Draws the colour scale of a map, 0 at the left and the maximum at the right; the lowest row of pixels, if there
/// are several, has the dashes of its outline.
pub(crate) fn legend(context: &CanvasRenderingContext2d, map: ImaginedMap, dark: bool) -> Result<(), JsValue> {
    let (width, height) = canvas_size(context)?;
    let last = width.max(2) - 1;
    let mut pixels: Vec<u8> = (0..width).flat_map(|x| map.colour(x as f32 / last as f32, dark)).collect();
    if height > 1 {
        let dashes = map.dashes();
        let dash = |x: usize| if dashes[x / DASH % dashes.len()] { map.colour(1.0, dark) } else { [0; 4] };
        pixels = pixels.repeat(height - 1);
        pixels.extend((0..width).flat_map(dash));
    }
    put_pixels(context, &pixels, width)
}

/// Refuses a map that is not 64 x 64.
fn check_size(cells: usize) -> Result<(), JsValue> {
    if cells == CELLS {
        return Ok(());
    }
    Err(error(Code::BadMap, format!("a map holds {SIDE} x {SIDE} values, not {cells}")))
}

/// Returns width and height of the canvas, pixels.
fn canvas_size(context: &CanvasRenderingContext2d) -> Result<(usize, usize), JsValue> {
    let canvas = context.canvas().ok_or_else(|| error(Code::BadData, "the context has no canvas"))?;
    Ok((canvas.width() as usize, canvas.height() as usize))
}

/// Copies RGBA pixels, row by row from the top, into the upper left corner of a canvas.
fn put_pixels(context: &CanvasRenderingContext2d, pixels: &[u8], width: usize) -> Result<(), JsValue> {
    let image = ImageData::new_with_u8_clamped_array(Clamped(pixels), width as u32)?;
    context.put_image_data(&image, 0.0, 0.0)
}

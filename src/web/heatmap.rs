//! Draws maps on canvases of their own: what a stage imagines, its legend, lines round paths, and outcomes.
//!
//! Row 0 of a map is the bottom. `paint` lays such canvases over the scene; the page shows them beside it.

use wasm_bindgen::{Clamped, prelude::*};
use web_sys::{CanvasRenderingContext2d, ImageData};

use super::colour::{Dashes, Stage};
use super::error::{Code, error};
use crate::raster::{CELLS, SIDE};

/// Length of one dash in a legend, pixels.
const DASH: usize = 2;

/// Width of a line round cells, cells.
const LINE: f64 = 0.4;

/// A map of 64 x 64 values in 0..=most, row 0 at the bottom, into a canvas of as many pixels.
pub fn map(
    context: &CanvasRenderingContext2d,
    stage: Stage,
    values: &[f32],
    most: f32,
    dark: bool,
) -> Result<(), JsValue> {
    sized(values.len())?;
    let share = |value: f32| if most > 0.0 { value / most } else { 0.0 };
    let rows = values.chunks(SIDE).rev().flatten();
    let pixels: Vec<u8> = rows.flat_map(|&value| stage.colour(share(value), dark)).collect();
    put(context, &pixels, SIDE)
}

/// A line round the cells whose value is over one half.
pub fn outlined(
    context: &CanvasRenderingContext2d,
    values: &[f32],
    colour: &str,
    dashes: Dashes,
) -> Result<(), JsValue> {
    sized(values.len())?;
    let (side, _) = size(context)?;
    let cell = side as f64 / SIDE as f64;
    let set = |column: usize, row: usize| column < SIDE && row < SIDE && values[row * SIDE + column] > 0.5;
    context.begin_path();
    for row in 0..=SIDE {
        for column in (0..=SIDE).filter(|column| dashes[(column + row) % dashes.len()]) {
            let (x, y) = (column as f64 * cell, side as f64 - row as f64 * cell);
            // Between this cell and the one to its left, and the one below: an index before the first wraps round.
            if set(column, row) != set(column.wrapping_sub(1), row) {
                context.move_to(x, y);
                context.line_to(x, y - cell);
            }
            if set(column, row) != set(column, row.wrapping_sub(1)) {
                context.move_to(x, y);
                context.line_to(x + cell, y);
            }
        }
    }
    context.set_line_width(cell * LINE);
    context.set_line_cap("square");
    context.set_stroke_style_str(colour);
    context.stroke();
    Ok(())
}

/// Outcomes of 64 x 64 cells, four pixels a cell: each has a colour and a pattern of its own.
pub fn outcomes(context: &CanvasRenderingContext2d, outcomes: &[u8], dark: bool) -> Result<(), JsValue> {
    sized(outcomes.len())?;
    let pixel = |index: usize| {
        let (x, y) = (index % (4 * SIDE), index / (4 * SIDE));
        outcome(outcomes[(SIDE - 1 - y / 4) * SIDE + x / 4], x % 8, y % 8, dark)
    };
    put(context, &(0..16 * CELLS).flat_map(pixel).collect::<Vec<u8>>(), 4 * SIDE)
}

/// Solved is filled and dotted, invalid is ruled from corner to corner, not solved has a few dots, and untried
/// is left as it is.
fn outcome(outcome: u8, x: usize, y: usize, dark: bool) -> [u8; 4] {
    const SOLVED: [u8; 4] = [240, 188, 66, 255];
    let quiet = if dark { 225 } else { 70 };
    match outcome {
        1 if (x + y).is_multiple_of(8) => [quiet, quiet, quiet, 120],
        1 => [quiet, quiet, quiet, 36],
        2 if x % 8 == 3 && y % 8 == 3 => [quiet, quiet, quiet, 150],
        3 if x % 4 == 1 && y % 4 == 1 => [40, 30, 0, 255],
        3 => SOLVED,
        _ => [0; 4],
    }
}

/// The colours of a stage, the least at the left and the most at the right; in the lowest row of pixels, if there
/// are several, the dashes of its line.
pub fn legend(context: &CanvasRenderingContext2d, stage: Stage, dark: bool) -> Result<(), JsValue> {
    let (width, height) = size(context)?;
    let last = width.max(2) - 1;
    let mut pixels: Vec<u8> = (0..width).flat_map(|x| stage.colour(x as f32 / last as f32, dark)).collect();
    if height > 1 {
        let dashes = stage.dashes();
        let dash = |x: usize| if dashes[x / DASH % dashes.len()] { stage.colour(1.0, dark) } else { [0; 4] };
        pixels = pixels.repeat(height - 1);
        pixels.extend((0..width).flat_map(dash));
    }
    put(context, &pixels, width)
}

fn sized(cells: usize) -> Result<(), JsValue> {
    if cells == CELLS {
        return Ok(());
    }
    Err(error(Code::BadMap, format!("a map holds {SIDE} x {SIDE} values, not {cells}")))
}

/// Width and height of the canvas, pixels.
fn size(context: &CanvasRenderingContext2d) -> Result<(usize, usize), JsValue> {
    let canvas = context.canvas().ok_or_else(|| error(Code::BadData, "the context has no canvas"))?;
    Ok((canvas.width() as usize, canvas.height() as usize))
}

/// Pixels, row by row from the top, into the upper left corner of a canvas.
fn put(context: &CanvasRenderingContext2d, pixels: &[u8], width: usize) -> Result<(), JsValue> {
    let image = ImageData::new_with_u8_clamped_array(Clamped(pixels), width as u32)?;
    context.put_image_data(&image, 0.0, 0.0)
}

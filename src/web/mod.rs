//! What the page and its worker call: the wasm exports.
//!
//! `puzzle` is one puzzle on the page: placing, running, comparing, drawing; `model` is the nets in the
//! worker, `solve_map` its search for all solutions; `measure` holds the numbers that agents are compared by.
//! This file holds what needs none of them: the list of templates, thumbnails, maps and their legends. Data
//! goes to JavaScript as plain objects in the words of the Rust types, or as typed arrays; an error is a real
//! `Error` with a `code`. The only user of wasm_bindgen and web_sys.

use wasm_bindgen::prelude::*;
use web_sys::CanvasRenderingContext2d;

use crate::puzzle::task::{self, Task};
use crate::puzzle::templates::TEMPLATES;

mod colour;
mod describe;
mod error;
mod frame;
mod heatmap;
mod marks;
mod metrics;
mod model;
mod paint;
mod puzzle;
mod recording;
mod solve_map;

pub use metrics::{auccess, overlap};
pub use model::{Model, Turn};
pub use puzzle::Puzzle;
pub use solve_map::SolveMap;

use colour::Stage;
use error::{Code, error, plain};
use paint::Painter;

/// The templates: `[{ id: "00007", name, story, tasks: ["00007:000", …] }]`.
#[wasm_bindgen]
pub fn templates() -> Result<JsValue, JsValue> {
    #[derive(serde::Serialize)]
    struct Entry {
        id: String,
        name: &'static str,
        story: &'static str,
        tasks: Vec<String>,
    }
    let entries = TEMPLATES.iter().map(|template| Entry {
        id: format!("{:05}", template.number),
        name: template.name,
        story: template.story,
        tasks: task::ids(template).map(String::from).collect(),
    });
    plain(&entries.collect::<Vec<_>>())
}

/// The colours of the roles and of the paper, as CSS colours: `{ green: "#009e73", … }`.
#[wasm_bindgen]
pub fn palette(dark: bool) -> Result<JsValue, JsValue> {
    plain(colour::palette(dark))
}

/// Draws a task's scene so that it fills a square canvas.
///
/// # Errors
/// `bad_task` if there is no such task.
#[wasm_bindgen(js_name = paintThumbnail)]
pub fn paint_thumbnail(context: &CanvasRenderingContext2d, id: &str, dark: bool) -> Result<(), JsValue> {
    let task = load(id)?;
    let painter = Painter::new(context, dark)?;
    for (index, body) in task.scene.bodies.iter().enumerate() {
        painter.body(body, None, index == task.scene.body2)?;
    }
    Ok(())
}

/// Draws one map, 64 x 64 values in 0..=1 with row 0 at the bottom, into a canvas of 64 x 64 pixels. The
/// scale runs from 0, which is left transparent, to `most`.
///
/// # Errors
/// `bad_map` if the stage has no such name or the values are not 64 x 64.
#[wasm_bindgen(js_name = paintMap)]
pub fn paint_map(
    context: &CanvasRenderingContext2d,
    stage: &str,
    values: &[f32],
    most: f32,
    dark: bool,
) -> Result<(), JsValue> {
    heatmap::map(context, stage_named(stage)?, values, most, dark)
}

/// Draws the colours of a stage from the least at the left to the most at the right, over the whole canvas.
///
/// # Errors
/// `bad_map` if the stage has no such name.
#[wasm_bindgen(js_name = paintLegend)]
pub fn paint_legend(context: &CanvasRenderingContext2d, stage: &str, dark: bool) -> Result<(), JsValue> {
    heatmap::legend(context, stage_named(stage)?, dark)
}

/// Draws a line round what is set (over one half) of 64 x 64 values, row 0 at the bottom, over a square canvas of
/// any size: round what was `real`, or in the name of a stage, in its colour and with dashes of its own, so that
/// stages differ without colour.
///
/// # Errors
/// `bad_map` if there is no such line or the values are not 64 x 64.
#[wasm_bindgen(js_name = paintOutline)]
pub fn paint_outline(
    context: &CanvasRenderingContext2d,
    line: &str,
    values: &[f32],
    dark: bool,
) -> Result<(), JsValue> {
    let ink = colour::palette(dark).ink.to_string();
    let (colour, dashes) = match line {
        "real" => (ink, colour::SOLID),
        stage => stage_named(stage).map(|stage| (stage.line(dark), stage.dashes()))?,
    };
    heatmap::outlined(context, values, &colour, dashes)
}

/// Draws a map of outcomes, as `SolveMap.picture` gives it, into a canvas of 256 x 256 pixels.
///
/// # Errors
/// `bad_map` if the outcomes are not 64 x 64.
#[wasm_bindgen(js_name = paintOutcomes)]
pub fn paint_outcomes(context: &CanvasRenderingContext2d, outcomes: &[u8], dark: bool) -> Result<(), JsValue> {
    heatmap::outcomes(context, outcomes, dark)
}

fn stage_named(name: &str) -> Result<Stage, JsValue> {
    name.parse().map_err(|sentence: String| error(Code::BadMap, sentence))
}

fn load(id: &str) -> Result<Task, JsValue> {
    id.parse().and_then(Task::load).map_err(|reason| error(Code::BadTask, reason))
}

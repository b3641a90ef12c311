//! The wasm exports, which the page and its worker call. The only user of wasm_bindgen and web_sys.
//!
//! `game` is one puzzle on the page, `game_view` what is drawn of it; `model` is the nets in the worker, `memory` what
//! they remember; `solve_map` searches all solutions of one radius by simulation; `scripting` is what a script asks of
//! a task, and `metrics` how agents are compared. This file holds the exports that need no state: the constants, the
//! templates, thumbnails, maps and legends. Data go to JavaScript as plain objects with the field names of the Rust
//! types (`types.d.ts` declares them), or as typed arrays; an error is an `Error` with a `code`.

use serde::Serialize;
use wasm_bindgen::prelude::*;
use web_sys::CanvasRenderingContext2d;

#[cfg(feature = "nets")]
use crate::agents;
use crate::benchmark::difficulty::Difficulty;
use crate::colour::imagined_maps::{ImaginedMap, SOLID};
use crate::colour::palette::palette as colours;
use crate::puzzle::action::RADIUS;
use crate::puzzle::dimensions;
use crate::puzzle::rollout::{GOAL_STEPS, STEPS_PER_SECOND};
use crate::puzzle::scene::{SIZE, Scene};
use crate::puzzle::task::{self, TaskError, TaskId};
use crate::puzzle::templates::TEMPLATES;
use crate::raster::{PX_PER_CELL, SIDE};
use crate::session::game::ATTEMPT_LIMIT;
use crate::simulator;

mod custom_scene;
mod describe;
mod error;
mod frame;
mod game;
mod game_view;
mod heatmap;
#[cfg(feature = "nets")]
mod imagined_ball;
mod imagined_paths;
mod marks;
#[cfg(feature = "nets")]
mod memory;
mod metrics;
#[cfg(feature = "nets")]
mod model;
mod open_puzzle;
mod paint;
mod panic;
mod puzzle_from_js;
mod recording;
mod ribbon;
mod scripting;
mod solve_map;
mod types;
mod verification;

pub use custom_scene::{custom_scene, paint_edited_scene, scene_digest, scene_limits, scene_problems};
pub use game::Game;
#[cfg(feature = "nets")]
pub use memory::Memory;
pub use metrics::{auccess, fold, soft_iou};
#[cfg(feature = "nets")]
pub use model::{Model, Turn};
pub use open_puzzle::OpenPuzzle;
pub use panic::throw_panics;
pub use scripting::{raster, scene, simulate, why_invalid};
pub use solve_map::SolveMap;
pub use verification::{SolutionSearch, attempt_line, luck, verify_attempt};

use error::{Code, error, to_js};
use paint::Painter;
use puzzle_from_js::load;

/// Returns the constants that the page shares with the Rust code. `scripts/constants.mjs` writes them to a module, so
/// that the page need not wait for the wasm.
#[wasm_bindgen(unchecked_return_type = "Constants")]
pub fn constants() -> Result<JsValue, JsValue> {
    #[derive(Serialize)]
    struct Constants {
        scene_size: f64,
        grid_side: usize,
        cell_size: usize,
        min_radius: f64,
        max_radius: f64,
        attempt_limit: usize,
        steps_per_second: usize,
        goal_steps: usize,
        maps: [&'static str; ImaginedMap::ALL.len()],
        paper_maps: Vec<&'static str>,
        simulator_version: u32,
        #[cfg(feature = "nets")]
        agents_version: u32,
        stick_lean: f64,
        half_stick: f64,
        jar_height_per_width: f64,
        jar_base: f64,
    }
    to_js(&Constants {
        scene_size: SIZE,
        grid_side: SIDE,
        cell_size: PX_PER_CELL,
        min_radius: *RADIUS.start(),
        max_radius: *RADIUS.end(),
        attempt_limit: ATTEMPT_LIMIT,
        steps_per_second: STEPS_PER_SECOND,
        goal_steps: GOAL_STEPS,
        maps: ImaginedMap::ALL.map(ImaginedMap::name),
        paper_maps: ImaginedMap::ALL.into_iter().filter(|map| map.of_paper()).map(ImaginedMap::name).collect(),
        simulator_version: simulator::VERSION,
        #[cfg(feature = "nets")]
        agents_version: agents::VERSION,
        stick_lean: dimensions::STICK_LEAN,
        half_stick: dimensions::HALF_STICK,
        jar_height_per_width: dimensions::JAR_HEIGHT_PER_WIDTH,
        jar_base: dimensions::JAR_BASE,
    })
}

/// Returns all templates with the ids of their tasks.
#[wasm_bindgen(unchecked_return_type = "Template[]")]
pub fn templates() -> Result<JsValue, JsValue> {
    #[derive(Serialize)]
    struct Template {
        id: String,
        name: &'static str,
        story: &'static str,
        tasks: Vec<String>,
    }
    let templates = TEMPLATES.iter().map(|template| Template {
        id: format!("{:05}", template.number),
        name: template.name,
        story: template.story,
        tasks: task::ids(template).map(String::from).collect(),
    });
    // As JSON, because 2,500 ids that are passed one by one hold up the first puzzle.
    let json = serde_json::to_string(&templates.collect::<Vec<_>>()).expect("texts and lists of texts are JSON");
    js_sys::JSON::parse(&json)
}

thread_local! {
    static SHIPPED: Difficulty = Difficulty::shipped();
}

/// Returns how hard a task is: how many uniformly drawn valid balls were tried, and how many of them solve it.
///
/// # Errors
/// `bad_task` if there is no such task.
#[wasm_bindgen(unchecked_return_type = "Difficulty")]
pub fn difficulty(id: &str) -> Result<JsValue, JsValue> {
    #[derive(Serialize)]
    struct Counts {
        balls: u32,
        solve_rate: f64,
    }
    let id: TaskId = id.parse().map_err(|reason: TaskError| error(Code::BadTask, reason))?;
    let counts =
        SHIPPED.with(|shipped| shipped.solve_rate(id).map(|solve_rate| Counts { balls: shipped.balls, solve_rate }));
    to_js(&counts.ok_or_else(|| error(Code::BadTask, TaskError::NotInBenchmark(id)))?)
}

/// Returns the share of uniform valid balls that solve each task, 0..1, in the order of `templates`.
#[wasm_bindgen(js_name = solveRates)]
pub fn solve_rates() -> Vec<f64> {
    SHIPPED.with(|shipped| shipped.solve_rates().collect())
}

/// Returns the colours of the roles and of the paper as CSS colours.
#[wasm_bindgen(unchecked_return_type = "Palette")]
pub fn palette(dark: bool) -> Result<JsValue, JsValue> {
    to_js(colours(dark))
}

/// Draws the scene of a task, or a custom scene, so that it fills a square canvas. For an open puzzle,
/// `Game.paintThumbnail` does not load it again.
///
/// # Errors
/// `bad_task` if there is no such task, `bad_scene` if the scene may not be played.
#[wasm_bindgen(js_name = paintThumbnail)]
pub fn paint_thumbnail(
    context: &CanvasRenderingContext2d,
    #[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue,
    dark: bool,
) -> Result<(), JsValue> {
    paint_scene(context, &load(puzzle)?.scene, dark)
}

/// Draws one map, 64 x 64 values with row 0 at the bottom, into a canvas of 64 x 64 pixels. The colour scale runs from
/// 0, which is transparent, to `max`.
///
/// # Errors
/// `bad_map` if no map has this name or the values are not 64 x 64.
#[wasm_bindgen(js_name = paintMap)]
pub fn paint_map(
    context: &CanvasRenderingContext2d,
    #[wasm_bindgen(unchecked_param_type = "MapName")] map: &str,
    values: &[f32],
    max: f32,
    dark: bool,
) -> Result<(), JsValue> {
    heatmap::paint(context, map_named(map)?, values, max, dark)
}

/// Draws the colour scale of a map, 0 at the left, over the whole canvas.
///
/// # Errors
/// `bad_map` if no map has this name.
#[wasm_bindgen(js_name = paintLegend)]
pub fn paint_legend(
    context: &CanvasRenderingContext2d,
    #[wasm_bindgen(unchecked_param_type = "MapName")] map: &str,
    dark: bool,
) -> Result<(), JsValue> {
    heatmap::legend(context, map_named(map)?, dark)
}

/// Outlines what is strong in 64 x 64 values in 0..=1, row 0 at the bottom, on a square canvas of any size. `line` is
/// `real`, or a map, each of which has a colour and dashes of its own, so that maps differ without colour too.
///
/// # Errors
/// `bad_map` if there is no such line or the values are not 64 x 64.
#[wasm_bindgen(js_name = paintOutline)]
pub fn paint_outline(
    context: &CanvasRenderingContext2d,
    #[wasm_bindgen(unchecked_param_type = "MapName | \"real\"")] line: &str,
    values: &[f32],
    dark: bool,
) -> Result<(), JsValue> {
    let (colour, dashes) = match line {
        "real" => (colours(dark).ink.to_string(), SOLID),
        name => map_named(name).map(|map| (map.line_colour(dark), map.dashes()))?,
    };
    heatmap::outline(context, values, &colour, dashes)
}

/// Draws a map of outcomes, as `SolveMap.outcomes` returns it, into a canvas of 256 x 256 pixels.
///
/// # Errors
/// `bad_map` if the outcomes are not 64 x 64.
#[wasm_bindgen(js_name = paintOutcomes)]
pub fn paint_outcomes(context: &CanvasRenderingContext2d, outcomes: &[u8], dark: bool) -> Result<(), JsValue> {
    heatmap::outcomes(context, outcomes, dark)
}

fn paint_scene(context: &CanvasRenderingContext2d, scene: &Scene, dark: bool) -> Result<(), JsValue> {
    // The caller may draw more, in units of the canvas.
    context.save();
    let painted = Painter::new(context, dark).and_then(|painter| {
        scene.bodies.iter().enumerate().try_for_each(|(index, body)| painter.body(body, None, index == scene.body2))
    });
    context.restore();
    painted
}

fn map_named(name: &str) -> Result<ImaginedMap, JsValue> {
    name.parse().map_err(|sentence: String| error(Code::BadMap, sentence))
}

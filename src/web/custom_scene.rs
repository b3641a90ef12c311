//! Exports for making scenes: a task as a custom scene, its problems, the limits, and its drawing.

use std::ops::RangeInclusive;

use serde_json::json;
use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use super::data::{self, from_js, to_js};
use super::error::{Code, error};
use super::frame::{self, View};
use super::puzzle::{JsPuzzle, bad_scene, load};
use crate::puzzle::custom_scene::{BODIES, CustomScene, MAX_OVERLAP, NAME_LENGTH};
use crate::puzzle::dimensions::{BALL_RADIUS, BAR_LENGTH, BAR_THICKNESS, JAR_HEIGHT, STICK_LENGTH};
use crate::session::puzzle::Puzzle;
use crate::session::scene_check::problems;

/// Returns a puzzle as a custom scene, which can be edited.
#[wasm_bindgen(js_name = customScene, unchecked_return_type = "CustomScene")]
pub fn custom_scene(puzzle: JsPuzzle) -> Result<JsValue, JsValue> {
    let puzzle = load(&puzzle)?;
    let custom = puzzle.custom.or_else(|| CustomScene::of(&puzzle.scene));
    to_js(&custom.ok_or_else(|| error(Code::BadScene, "the scene has a body of an unknown shape"))?)
}

/// Returns the reasons why a value cannot be played as a custom scene; an empty list if it can. Never throws: a value
/// that is not a scene at all is reported the same way.
#[wasm_bindgen(js_name = sceneProblems, unchecked_return_type = "SceneProblem[]")]
pub fn scene_problems(#[wasm_bindgen(unchecked_param_type = "unknown")] value: &JsValue) -> Result<JsValue, JsValue> {
    to_js(&CustomScene::read(data::json(value)).map_or_else(|problems| problems, |custom| problems(&custom)))
}

/// Returns the SHA-256, in hexadecimal, of a custom scene without its name. It is equal for scenes that play alike.
#[wasm_bindgen(js_name = sceneDigest)]
pub fn scene_digest(#[wasm_bindgen(unchecked_param_type = "CustomScene")] scene: &JsValue) -> Result<String, JsValue> {
    let puzzle = Puzzle::read(data::json(scene)).map_err(|problems| bad_scene(&problems))?;
    Ok(puzzle.id.digest().expect("a custom scene"))
}

/// Returns the limits of custom scenes.
#[wasm_bindgen(js_name = sceneLimits, unchecked_return_type = "SceneLimits")]
pub fn scene_limits() -> Result<JsValue, JsValue> {
    let ends = |range: RangeInclusive<f64>| [*range.start(), *range.end()];
    to_js(&json!({
        "bodies": [BODIES.start(), BODIES.end()],
        "ball_radius": ends(BALL_RADIUS),
        "bar_length": ends(BAR_LENGTH),
        "bar_thickness": ends(BAR_THICKNESS),
        "jar_height": ends(JAR_HEIGHT),
        "stick_length": ends(STICK_LENGTH),
        "max_overlap": MAX_OVERLAP,
        "name_length": NAME_LENGTH,
    }))
}

/// Draws a custom scene during editing into a square canvas: the scene, the maps over it, and the ball of the view. The
/// scene need not be playable.
#[wasm_bindgen(js_name = paintEditedScene)]
pub fn paint_edited_scene(
    context: &CanvasRenderingContext2d,
    #[wasm_bindgen(unchecked_param_type = "CustomScene")] scene: &JsValue,
    #[wasm_bindgen(unchecked_param_type = "View")] view: JsValue,
    maps: Vec<HtmlCanvasElement>,
) -> Result<(), JsValue> {
    let custom = CustomScene::read(data::json(scene)).map_err(|problems| bad_scene(&problems))?;
    if custom.bodies.len() <= custom.body1.max(custom.body2) {
        return Err(error(Code::BadScene, "the goal of the scene names a body that it does not have"));
    }
    let lengths = custom.bodies.iter().flat_map(|body| body.dimensions.lengths());
    if let Some((name, length, _)) = lengths.into_iter().find(|(_, length, _)| *length <= 0.0) {
        return Err(error(Code::BadScene, format!("the {name} of a body is {length}, but must be positive")));
    }
    let scene = custom.to_scene();
    let mut view: View = from_js(view)?;
    view.valid = view.ball.is_none_or(|ball| ball.check(&scene).is_ok());
    frame::paint(context, &scene, None, &[], &view, &maps)
}

//! What a puzzle is, as plain data, and why a ball is invalid, in words.

use serde::Serialize;
use wasm_bindgen::JsValue;

use super::error::to_js;
use crate::puzzle::action::Invalid;
use crate::puzzle::scene::Scene;
use crate::session::puzzle::Puzzle;

/// Returns what a puzzle is.
pub(crate) fn about(puzzle: &Puzzle) -> Result<JsValue, JsValue> {
    #[derive(Serialize)]
    struct About<'a> {
        id: Option<String>,
        digest: Option<String>,
        name: Option<&'a str>,
        scene: &'a Scene,
    }
    let (id, digest) = (puzzle.id.task().map(String::from), puzzle.id.digest());
    to_js(&About { id, digest, name: puzzle.name(), scene: &puzzle.scene })
}

/// Returns why a ball is invalid, with the name of the body that it overlaps.
pub(crate) fn invalid_reason(why: Invalid, scene: &Scene) -> String {
    match why {
        Invalid::Overlaps(body) => format!("the ball overlaps the {}", scene.bodies[body].name()),
        why => why.to_string(),
    }
}

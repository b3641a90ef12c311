//! A puzzle and a ball as JavaScript passes them: the id of a task or a custom scene, and three numbers.

use std::cell::RefCell;

use serde::de::DeserializeOwned;
use wasm_bindgen::prelude::*;

use super::data::{json, written};
use super::error::{Code, error};
use crate::puzzle::action::Invalid;
use crate::puzzle::custom_scene::Problem;
use crate::puzzle::scene::Scene;
use crate::puzzle::task::{Task, TaskError, TaskId};
use crate::session::puzzle::{Puzzle, PuzzleId};

#[wasm_bindgen]
extern "C" {
    /// The id of a task, or a custom scene.
    #[wasm_bindgen(typescript_type = "Puzzle")]
    pub type JsPuzzle;

    /// x, y and radius, px.
    #[wasm_bindgen(typescript_type = "Ball")]
    pub type JsBall;

    /// A ball, or null for the scene alone.
    #[wasm_bindgen(typescript_type = "Ball | null")]
    pub type JsBallOrNull;
}

thread_local! {
    /// The task that was loaded last. A script tries many balls on one task, and loading it may take longer than a
    /// rollout.
    static LAST_TASK: RefCell<Option<Puzzle>> = const { RefCell::new(None) };
}

/// Returns the task with an id, or a custom scene.
///
/// # Errors
///
/// `bad_task` if the task does not exist, `bad_scene` if the scene cannot be played.
pub(crate) fn load(puzzle: &JsValue) -> Result<Puzzle, JsValue> {
    if puzzle.is_object() {
        return Puzzle::read(json(puzzle)).map_err(|problems| bad_scene(&problems));
    }
    let text = puzzle.as_string().unwrap_or_else(|| written(puzzle));
    let id: TaskId = text.parse().map_err(|reason: TaskError| error(Code::BadTask, reason))?;
    LAST_TASK.with_borrow_mut(|last| match last {
        Some(last) if last.id == PuzzleId::Task(id) => Ok(last.clone()),
        _ => {
            let task = Task::load(id).map_err(|reason| error(Code::BadTask, reason))?;
            Ok(last.insert(task.into()).clone())
        }
    })
}

/// Returns the error for a scene that cannot be played.
pub(crate) fn bad_scene(problems: &[Problem]) -> JsValue {
    let first = problems.first().expect("a scene without problems may be played");
    match problems.len() - 1 {
        0 => error(Code::BadScene, first),
        more => error(Code::BadScene, format!("{first} ({more} more: `sceneProblems` lists them)")),
    }
}

/// Returns the ball of a JavaScript value; `T` says whether it may be null.
///
/// # Errors
///
/// `bad_data` if the value is not a ball.
pub(crate) fn ball_from<T: DeserializeOwned>(ball: impl Into<JsValue>) -> Result<T, JsValue> {
    let fault = |_| error(Code::BadData, "a ball is an array of three numbers, px: x, y and its radius");
    serde_json::from_value(json(&ball.into())).map_err(fault)
}

/// Returns the error for an invalid ball.
pub(crate) fn invalid_ball(why: Invalid, scene: &Scene) -> JsValue {
    error(Code::InvalidBall, invalid_reason(why, scene))
}

/// Returns the reason why a ball is invalid, with the name of the body that it overlaps.
pub(crate) fn invalid_reason(why: Invalid, scene: &Scene) -> String {
    match why {
        Invalid::Overlaps(body) => format!("the ball overlaps the {}", scene.bodies[body].name()),
        why => why.to_string(),
    }
}

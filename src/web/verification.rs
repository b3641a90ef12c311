//! The exports about what attempts prove: whether a scene can be solved, whether a ball that solves is lucky, and lines
//! of attempts that anyone can simulate again.

use serde_json::Value;
use wasm_bindgen::prelude::*;

use super::error::to_js;
use super::puzzle_from_js::{load, plain_scene, written};
use super::scripting::ball_from;
use crate::puzzle::action::Ball;
use crate::puzzle::rollout::Status;
use crate::puzzle::task::{TaskError, TaskId};
use crate::search::{luck, solution_search};
use crate::simulator::{Engine, UnknownEngine};
use crate::verification::{AttemptLine, LineFault, Verdict};

/// The search for solutions of a scene over the whole action space, one ball per call.
#[wasm_bindgen]
pub struct SolutionSearch(solution_search::SolutionSearch);

#[wasm_bindgen]
impl SolutionSearch {
    /// Starts a search.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played.
    #[wasm_bindgen(constructor)]
    pub fn new(#[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue) -> Result<SolutionSearch, JsValue> {
        Ok(SolutionSearch(solution_search::SolutionSearch::new(load(puzzle)?.scene)))
    }

    /// Simulates the next valid ball; returns false once all have been tried.
    pub fn advance(&mut self) -> bool {
        self.0.advance()
    }

    /// Returns what has been found so far.
    #[wasm_bindgen(unchecked_return_type = "FoundSolutions")]
    pub fn found(&self) -> Result<JsValue, JsValue> {
        to_js(&self.0.found())
    }
}

/// Returns how many of the 27 balls within a pixel in x, y and radius solve, of those that may be placed.
///
/// # Errors
/// `bad_task` if there is no such task, `bad_scene` if the scene may not be played, `bad_data` if it is not a ball.
#[wasm_bindgen(unchecked_return_type = "Luck")]
pub fn luck(
    #[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ball")] ball: JsValue,
) -> Result<JsValue, JsValue> {
    to_js(&luck::luck(&load(puzzle)?.scene, ball_from(ball)?))
}

/// Simulates a ball, or the scene alone if it is null, and returns the line that anyone can verify.
///
/// # Errors
/// `bad_task` if there is no such task, `bad_scene` if the scene may not be played, `bad_data` if it is not a ball.
#[wasm_bindgen(js_name = attemptLine, unchecked_return_type = "AttemptLine")]
pub fn attempt_line(
    #[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ball | null")] ball: JsValue,
) -> Result<JsValue, JsValue> {
    to_js(&AttemptLine::of(&load(puzzle)?, ball_from(ball)?, Engine::default()))
}

/// Simulates the attempt of a line again, and returns whether it is the same to the bit. Never fails: what is not a
/// line is `not_valid`.
#[wasm_bindgen(js_name = verifyAttempt, unchecked_return_type = "Verification")]
pub fn verify_attempt(#[wasm_bindgen(unchecked_param_type = "unknown")] line: JsValue) -> Result<JsValue, JsValue> {
    let verdict = match read_names(&line) {
        Err(unknown) => Verdict::not_valid(LineFault::Puzzle, format!("This cannot be simulated: {unknown}.")),
        Ok((task, engine)) => match read_line(&line, task, engine) {
            Some(line) => line.verify(),
            None => Verdict::not_valid(
                LineFault::Form,
                "This is not an attempt: an attempt is a JSON object with `task` or `scene`, `ball`, `simulator`, `status`, `steps` and `digest`.",
            ),
        },
    };
    to_js(&verdict)
}

/// Returns the value of a key of a line, unless it is missing or null.
fn known(line: &JsValue, key: &str) -> Option<JsValue> {
    js_sys::Reflect::get(line, &key.into()).ok().filter(|value| !value.is_undefined() && !value.is_null())
}

/// Reads the task and the engine that a line names.
///
/// # Errors
/// Which of them there is not.
fn read_names(line: &JsValue) -> Result<(Option<TaskId>, Engine), String> {
    let text = |key: &str| known(line, key).map(|value| value.as_string().unwrap_or_else(|| written(&value)));
    let task = text("task").map(|id| id.parse().map_err(|why: TaskError| why.to_string())).transpose()?;
    let engine = text("engine").map(|name| name.parse().map_err(|why: UnknownEngine| why.to_string())).transpose()?;
    Ok((task, engine.unwrap_or_default()))
}

/// Reads the rest of a line key by key: see `plain_scene`.
fn read_line(line: &JsValue, task: Option<TaskId>, engine: Engine) -> Option<AttemptLine> {
    let get = |key: &str| js_sys::Reflect::get(line, &key.into()).ok();
    let scene: Option<Value> = known(line, "scene").map(|scene| plain_scene(&scene));
    let ball: Option<Ball> = ball_from(get("ball")?).ok()?;
    let status: Status = serde_json::from_value(Value::String(get("status")?.as_string()?)).ok()?;
    let whole = |key: &str| get(key)?.as_f64().filter(|number| number.fract() == 0.0 && (0.0..1e9).contains(number));
    let (simulator, steps) = (whole("simulator")? as u32, whole("steps")? as usize);
    Some(AttemptLine { task, scene, ball, engine, simulator, status, steps, digest: get("digest")?.as_string()? })
}

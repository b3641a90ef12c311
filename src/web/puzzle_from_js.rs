//! A puzzle, as JavaScript names it: the id of a task, or a custom scene as an object.

use std::cell::RefCell;

use js_sys::{Array, Reflect};
use serde_json::{Map, Number, Value};
use wasm_bindgen::prelude::*;

use super::error::{Code, error};
use crate::puzzle::custom_scene::{BODIES, Problem};
use crate::puzzle::task::{Task, TaskError, TaskId};
use crate::session::puzzle::{Puzzle, PuzzleId};

thread_local! {
    /// The task that was loaded last: a script tries many balls on one task, and loading it may take longer than a
    /// rollout.
    static LAST_TASK: RefCell<Option<Puzzle>> = const { RefCell::new(None) };
}

/// Returns the task of an id, or a custom scene.
///
/// # Errors
/// `bad_task` if there is no such task, `bad_scene` if the scene may not be played.
pub(crate) fn load(puzzle: JsValue) -> Result<Puzzle, JsValue> {
    if puzzle.is_object() {
        return Puzzle::read(plain_scene(&puzzle)).map_err(|problems| bad_scene(&problems));
    }
    let text = puzzle.as_string().unwrap_or_else(|| written(&puzzle));
    let id: TaskId = text.parse().map_err(|reason: TaskError| error(Code::BadTask, reason))?;
    LAST_TASK.with_borrow_mut(|last| match last {
        Some(last) if last.id == PuzzleId::Task(id) => Ok(last.clone()),
        _ => {
            let task = Task::load(id).map_err(|reason| error(Code::BadTask, reason))?;
            Ok(last.insert(task.into()).clone())
        }
    })
}

/// The keys of a scene whose values are not lists.
const SCENE_KEYS: [&str; 4] = ["version", "name", "body1", "body2"];

/// The keys of a body.
const BODY_KEYS: [&str; 9] = ["shape", "radius", "length", "thickness", "height", "x", "y", "angle", "dynamic"];

/// Returns what may be a custom scene as JSON: the keys that one has and nothing else, because a foreign file may be
/// nested so deep that converting all of it overflows the stack.
pub(crate) fn plain_scene(value: &JsValue) -> Value {
    if !value.is_object() {
        return Value::Null;
    }
    let mut scene = plain_object(value, &SCENE_KEYS);
    if let Ok(bodies) = Reflect::get(value, &"bodies".into())
        && Array::is_array(&bodies)
    {
        // One more than there may be, so that a longer list is refused.
        let bodies = bodies.unchecked_into::<Array>().slice(0, *BODIES.end() as u32 + 1);
        let bodies = bodies.iter().map(|body| Value::Object(plain_object(&body, &BODY_KEYS)));
        scene.insert("bodies".to_string(), bodies.collect());
    }
    scene.into()
}

/// Returns these keys of an object as far as their values are numbers, texts or truth values; null for others that it
/// has.
fn plain_object(value: &JsValue, keys: &[&str]) -> Map<String, Value> {
    let get = |key: &str| Reflect::get(value, &key.into()).ok().filter(|value| !value.is_undefined());
    let entries = keys.iter().filter_map(|&key| Some((key.to_string(), plain(&get(key)?))));
    entries.collect()
}

fn plain(value: &JsValue) -> Value {
    let number = || value.as_f64().and_then(Number::from_f64).map(Value::Number);
    let text = || value.as_string().map(Value::String);
    number().or_else(text).or_else(|| value.as_bool().map(Value::Bool)).unwrap_or(Value::Null)
}

/// Returns the error for a scene that may not be played.
fn bad_scene(problems: &[Problem]) -> JsValue {
    let first = problems.first().expect("a scene without problems may be played");
    match problems.len() - 1 {
        0 => error(Code::BadScene, first),
        more => error(Code::BadScene, format!("{first} ({more} more: `sceneProblems` lists them)")),
    }
}

/// Returns a value that is no text as a person would write it, for the error that names it.
pub(crate) fn written(value: &JsValue) -> String {
    // JSON has no NaN and no infinity.
    if let Some(number) = value.as_f64().filter(|number| !number.is_finite()) {
        return number.to_string();
    }
    js_sys::JSON::stringify(value).ok().and_then(|text| text.as_string()).unwrap_or_else(|| "undefined".to_string())
}

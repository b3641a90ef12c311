//! The exports for scripts, which experiment with tasks without playing them: the scene of a task, its raster, why a
//! ball is invalid in it, and the rollout of a ball. Between calls only the task that was loaded last is kept, so there
//! is nothing to free.

use js_sys::{Float32Array, Object, Reflect, Uint8Array, Uint32Array};
use serde::Serialize;
use serde::de::DeserializeOwned;
use wasm_bindgen::prelude::*;

use super::describe::invalid_reason;
use super::error::{Code, error, from_js, to_js};
use super::puzzle_from_js::load;
use crate::puzzle::action::Ball;
use crate::puzzle::rollout::{Rollout, Status};
use crate::raster::scene_channels;
use crate::session::ending::Ending;
use crate::simulator;

/// Returns the scene of a task as plain data.
///
/// # Errors
/// `bad_task` if there is no such task, `bad_scene` if the scene may not be played.
#[wasm_bindgen(unchecked_return_type = "Scene")]
pub fn scene(#[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue) -> Result<JsValue, JsValue> {
    to_js(&load(puzzle)?.scene)
}

/// Returns the five channels of a scene, which the four nets see: green object, blue goal, purple
/// goal, gray, black. A Float32Array `[5, 64, 64]` of zeros and ones, row 0 at the bottom.
///
/// # Errors
/// `bad_task` if there is no such task, `bad_scene` if the scene may not be played.
#[wasm_bindgen]
pub fn raster(#[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue) -> Result<Vec<f32>, JsValue> {
    Ok(scene_channels(&load(puzzle)?.scene).iter().flat_map(|channel| channel.to_f32()).collect())
}

/// Returns why a ball is invalid in a task, as a phrase; undefined if it is valid.
///
/// # Errors
/// `bad_task` if there is no such task, `bad_scene` if the scene may not be played, `bad_data` if it is not a ball.
#[wasm_bindgen(js_name = whyInvalid)]
pub fn why_invalid(
    #[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ball")] ball: JsValue,
) -> Result<Option<String>, JsValue> {
    let scene = load(puzzle)?.scene;
    Ok(ball_from::<Ball>(ball)?.check(&scene).err().map(|why| invalid_reason(why, &scene)))
}

/// Simulates a task with a ball, or alone if the ball is null. An invalid ball is no error: it is a rollout of no steps
/// with the status `invalid` and a reason.
///
/// # Errors
/// `bad_task` if there is no such task, `bad_scene` if the scene may not be played, `bad_data` if it is not a ball.
#[wasm_bindgen(unchecked_return_type = "Rollout")]
pub fn simulate(
    #[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue,
    #[wasm_bindgen(unchecked_param_type = "Ball | null")] ball: JsValue,
) -> Result<JsValue, JsValue> {
    #[derive(Serialize)]
    struct Summary {
        status: Status,
        reason: Option<String>,
        #[serde(flatten)]
        ending: Ending,
    }
    let scene = load(puzzle)?.scene;
    let (status, reason, rollout) = match simulator::simulate(&scene, ball_from(ball)?) {
        Ok(rollout) => (rollout.status(), None, rollout),
        Err(why) => (Status::Invalid, Some(invalid_reason(why, &scene)), nothing_simulated()),
    };
    let js = Object::from(to_js(&Summary { status, reason, ending: Ending::of(&rollout) })?);
    let bodies: Vec<u32> = rollout.bodies.iter().map(|&index| index as u32).collect();
    let touching: Vec<u8> = rollout.touching.iter().copied().map(u8::from).collect();
    let arrays: [(&str, JsValue); 3] = [
        ("bodies", Uint32Array::from(bodies.as_slice()).into()),
        ("poses", Float32Array::from(rollout.poses.as_flattened()).into()),
        ("touching", Uint8Array::from(touching.as_slice()).into()),
    ];
    for (name, array) in arrays {
        Reflect::set(&js, &name.into(), &array)?;
    }
    Ok(js.into())
}

/// Returns the ball of a JavaScript value; `T` says whether there has to be one.
pub(super) fn ball_from<T: DeserializeOwned>(ball: JsValue) -> Result<T, JsValue> {
    let fault = || error(Code::BadData, "a ball is an array of three numbers, px: x, y and its radius");
    // What follows the three numbers of a tuple is not looked at otherwise.
    let has_more = ball.dyn_ref::<js_sys::Array>().is_some_and(|array| array.length() > 3);
    if has_more { Err(fault()) } else { from_js(ball).map_err(|_| fault()) }
}

/// Returns the rollout of an invalid ball.
fn nothing_simulated() -> Rollout {
    Rollout { solved: false, steps: 0, bodies: Vec::new(), poses: Vec::new(), touching: vec![false] }
}

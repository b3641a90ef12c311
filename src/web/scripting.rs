//! Functions of a puzzle for scripts: its raster, why a ball is invalid, the rollout of a ball, and a verifiable
//! attempt. Between calls, only the last task is kept, so there is nothing to free.

use js_sys::{Float32Array, Uint8Array, Uint32Array};
use serde::Serialize;
use wasm_bindgen::prelude::*;

use super::data::{Typed, json, to_js};
use super::puzzle::{JsBall, JsBallOrNull, JsPuzzle, ball_from, invalid_reason, load};
use crate::puzzle::action::Ball;
use crate::puzzle::rollout::{Rollout, Status};
use crate::raster::scene_channels;
use crate::session::ending::Ending;
use crate::simulator::{self, Engine};
use crate::verification::{AttemptLine, LineFault, Verdict};

/// Returns the five channels of a scene, the input of the four nets: green object, blue goal, purple goal, gray, black.
/// A Float32Array `[5, 64, 64]` of zeros and ones, row 0 at the bottom.
#[wasm_bindgen]
pub fn raster(puzzle: JsPuzzle) -> Result<Vec<f32>, JsValue> {
    Ok(scene_channels(&load(&puzzle)?.scene).iter().flat_map(|channel| channel.to_f32()).collect())
}

/// Returns why a ball is invalid in a puzzle, as a phrase; undefined if it is valid.
#[wasm_bindgen(js_name = whyInvalid)]
pub fn why_invalid(puzzle: JsPuzzle, ball: JsBall) -> Result<Option<String>, JsValue> {
    let scene = load(&puzzle)?.scene;
    Ok(ball_from::<Ball>(ball)?.check(&scene).err().map(|why| invalid_reason(why, &scene)))
}

/// Simulates a puzzle with a ball, or without one if the ball is null. An invalid ball is not an error: it yields a
/// rollout of no steps with the status `invalid` and a reason.
#[wasm_bindgen(unchecked_return_type = "Rollout")]
pub fn simulate(puzzle: JsPuzzle, ball: JsBallOrNull) -> Result<JsValue, JsValue> {
    #[derive(Serialize)]
    struct Simulated {
        status: Status,
        reason: Option<String>,
        #[serde(flatten)]
        ending: Ending,
        bodies: Typed<Uint32Array>,
        poses: Typed<Float32Array>,
        touching: Typed<Uint8Array>,
    }
    let scene = load(&puzzle)?.scene;
    let (reason, rollout) = match simulator::simulate(&scene, ball_from(ball)?) {
        Ok(rollout) => (None, rollout),
        Err(why) => (Some(invalid_reason(why, &scene)), nothing_simulated()),
    };
    let bodies: Vec<u32> = rollout.bodies.iter().map(|&index| index as u32).collect();
    let touching: Vec<u8> = rollout.touching.iter().copied().map(u8::from).collect();
    to_js(&Simulated {
        status: if reason.is_some() { Status::Invalid } else { rollout.status() },
        reason,
        ending: Ending::of(&rollout),
        bodies: Typed(bodies.as_slice().into()),
        poses: Typed(rollout.poses.as_flattened().into()),
        touching: Typed(touching.as_slice().into()),
    })
}

/// Simulates a ball, or the scene alone if it is null, and returns an attempt that anyone can verify.
#[wasm_bindgen(js_name = attemptLine, unchecked_return_type = "AttemptLine")]
pub fn attempt_line(puzzle: JsPuzzle, ball: JsBallOrNull) -> Result<JsValue, JsValue> {
    to_js(&AttemptLine::of(&load(&puzzle)?, ball_from(ball)?, Engine::default()))
}

/// Simulates an attempt again, and returns whether it is the same to the bit. Never throws: a value that is not an
/// attempt is `not_valid`.
#[wasm_bindgen(js_name = verifyAttempt, unchecked_return_type = "Verification")]
pub fn verify_attempt(#[wasm_bindgen(unchecked_param_type = "unknown")] line: &JsValue) -> Result<JsValue, JsValue> {
    let line: Result<AttemptLine, _> = serde_json::from_value(json(line));
    let not_one = |why| Verdict::not_valid(LineFault::Form, format!("This is not an attempt: {why}."));
    to_js(&line.map_or_else(not_one, |line| line.verify()))
}

/// Returns the rollout of an invalid ball.
fn nothing_simulated() -> Rollout {
    Rollout { solved: false, steps: 0, bodies: Vec::new(), poses: Vec::new(), touching: vec![false] }
}

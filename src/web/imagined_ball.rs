//! What the dynamics net imagines for one ball, and for those that the model considers. Called in the worker;
//! `imagined_paths` reads the result on the page, to draw it.

use js_sys::{Array, Float32Array, Object, Reflect, Uint32Array};
use wasm_bindgen::prelude::*;

use super::describe::invalid_reason;
use super::error::{Code, error, to_js};
use super::imagined_paths::paths_to_js;
use super::model::Model;
use super::puzzle_from_js::load;
use super::scripting::ball_from;
use crate::agents::online::Candidate;
use crate::agents::sigmoid;
use crate::nets::ImaginedBall;
use crate::puzzle::action::Ball;
use crate::puzzle::sampled_paths::SAMPLED_STEPS;
use crate::session::game::ATTEMPT_LIMIT;

#[wasm_bindgen]
impl Model {
    /// Imagines what a ball of a task leads to: the paths of the green object and of the ball, and the probability that
    /// it solves. Undefined if the weights have no dynamics net. What the net has read of the last task is kept, so
    /// further balls of it cost little.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played, `bad_data` if it is not a ball,
    /// `invalid_ball`.
    #[wasm_bindgen(js_name = imagineBall, unchecked_return_type = "ImaginedBall | undefined")]
    pub fn imagine_ball(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue,
        #[wasm_bindgen(unchecked_param_type = "Ball")] ball: JsValue,
    ) -> Result<JsValue, JsValue> {
        let scene = load(puzzle)?.scene;
        let ball: Ball = ball_from(ball)?;
        ball.check(&scene).map_err(|why| error(Code::InvalidBall, invalid_reason(why, &scene)))?;
        self.model.imagine(&scene, ball).map_or(Ok(JsValue::UNDEFINED), |imagined| to_object(&imagined))
    }

    /// Returns the balls that the model considers in a task before it chooses, some hundred. Undefined if the weights
    /// have no dynamics net.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played.
    #[wasm_bindgen(unchecked_return_type = "Candidate[] | undefined")]
    pub fn candidates(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue,
    ) -> Result<JsValue, JsValue> {
        let Some(candidates) = self.model.candidates(&load(puzzle)?.scene, ATTEMPT_LIMIT) else {
            return Ok(JsValue::UNDEFINED);
        };
        candidates.iter().map(candidate_to_js).collect::<Result<Array, _>>().map(Into::into)
    }
}

fn candidate_to_js(candidate: &Candidate) -> Result<JsValue, JsValue> {
    let js = Object::new();
    let object = Float32Array::from(candidate.paths.object.as_flattened());
    let fields =
        [("ball", to_js(&candidate.ball)?), ("probability", probability(candidate.logit)), ("object", object.into())];
    for (name, value) in fields {
        Reflect::set(&js, &name.into(), &value)?;
    }
    Ok(js.into())
}

fn probability(logit: f64) -> JsValue {
    JsValue::from(sigmoid(logit))
}

fn to_object(imagined: &ImaginedBall) -> Result<JsValue, JsValue> {
    let js = paths_to_js(&imagined.paths)?;
    let fields: [(&str, JsValue); 3] = [
        ("steps", Uint32Array::from(SAMPLED_STEPS.map(|step| step as u32).as_slice()).into()),
        ("errors", Float32Array::from(imagined.errors.as_slice()).into()),
        ("probability", probability(imagined.logit.into())),
    ];
    for (name, value) in fields {
        Reflect::set(&js, &name.into(), &value)?;
    }
    Ok(js.into())
}

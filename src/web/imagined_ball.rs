//! What the dynamics net imagines for one ball: asked for in the worker by `Model.imagineBall`, and drawn on the page
//! in a frame. Between the two it is a plain JavaScript object of typed arrays.

use js_sys::{Array, Float32Array, Object, Reflect, Uint32Array};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use super::describe::invalid_reason;
use super::error::{Code, error, to_js};
use super::model::Model;
use super::puzzle_from_js::load;
use super::scripting::ball_from;
use crate::agents::online::Candidate;
use crate::agents::sigmoid;
use crate::nets::ImaginedBall;
use crate::nets::ball_head::POSITIONS;
use crate::puzzle::action::Ball;
use crate::puzzle::sampled_paths::{SAMPLED_STEPS, SAMPLES, SampledPath, SampledPaths};
use crate::session::game::ATTEMPT_LIMIT;

/// The imagined paths of one ball, as a frame draws them.
#[derive(Deserialize)]
#[serde(try_from = "PlainPaths")]
pub(crate) struct ImaginedPaths {
    /// The ball that they are imagined for.
    pub of: Ball,
    pub object: SampledPath,
    pub ball: SampledPath,
    /// Expected errors of the positions, px.
    pub object_errors: [f32; SAMPLES],
    pub ball_errors: [f32; SAMPLES],
}

/// A path of the green object that is only hinted at.
#[derive(Deserialize)]
pub(crate) struct Hint {
    /// x and y in turn, px.
    pub object: Vec<f64>,
    /// 0..=1
    pub opacity: f64,
    /// Whether it was tried, by the model; else it is imagined.
    #[serde(default)]
    pub tried: bool,
}

/// `ImaginedPaths` as JavaScript has them.
#[derive(Deserialize)]
struct PlainPaths {
    of: Ball,
    object: Vec<f32>,
    ball: Vec<f32>,
    errors: Vec<f32>,
}

impl TryFrom<PlainPaths> for ImaginedPaths {
    type Error = String;

    fn try_from(plain: PlainPaths) -> Result<ImaginedPaths, String> {
        let PlainPaths { of, object, ball, errors } = plain;
        let path = |values: Vec<f32>| SampledPath::try_from(values.as_chunks().0).ok();
        let half = |index: usize| errors.chunks(SAMPLES).nth(index).and_then(|half| half.try_into().ok());
        let paths = || {
            let (object_errors, ball_errors) = (half(0)?, half(1)?);
            Some(ImaginedPaths { of, object: path(object)?, ball: path(ball)?, object_errors, ball_errors })
        };
        let wrong = || format!("imagined paths hold {SAMPLES} positions each and {POSITIONS} errors");
        paths().ok_or_else(wrong)
    }
}

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

/// Returns paths as `{ object, ball }`, x and y in turn.
pub(crate) fn paths_to_js(paths: &SampledPaths) -> Result<Object, JsValue> {
    let js = Object::new();
    for (name, path) in [("object", &paths.object), ("ball", &paths.ball)] {
        Reflect::set(&js, &name.into(), &Float32Array::from(path.as_flattened()))?;
    }
    Ok(js)
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

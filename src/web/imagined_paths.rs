//! Imagined paths as a frame draws them, read from the plain object of typed arrays that `Model.imagineBall` returns.

use js_sys::{Float32Array, Object, Reflect};
use serde::Deserialize;
use wasm_bindgen::prelude::*;

use crate::puzzle::action::Ball;
use crate::puzzle::sampled_paths::{SAMPLES, SampledPath, SampledPaths};

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
        let wrong = || format!("imagined paths hold {SAMPLES} positions each and {} errors", 2 * SAMPLES);
        paths().ok_or_else(wrong)
    }
}

/// Returns paths as `{ object, ball }`, x and y in turn.
pub(crate) fn paths_to_js(paths: &SampledPaths) -> Result<Object, JsValue> {
    let js = Object::new();
    for (name, path) in [("object", &paths.object), ("ball", &paths.ball)] {
        Reflect::set(&js, &name.into(), &Float32Array::from(path.as_flattened()))?;
    }
    Ok(js)
}

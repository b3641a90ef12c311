//! An open puzzle as a value: its valid balls, their rollouts, and every frame. No call changes the result of another;
//! the page holds the attempts.
//!
//! A rollout is identified by its ball, because the same ball always leads to the same rollout. The last few are
//! cached, so that the frames of a rollout simulate it only once.

use std::cell::RefCell;
use std::rc::Rc;

use js_sys::Float32Array;
use serde::{Deserialize, Serialize};
use serde_json::json;
use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use super::data::{Typed, TypedPaths, from_js, to_js};
use super::frame::{self, Recording};
use super::puzzle::{JsBallOrNull, JsPuzzle, ball_from, invalid_ball, load};
use super::static_layer::StaticLayer;
use crate::puzzle::action::{Ball, Invalid, Obstacles};
use crate::puzzle::nearest_place::nearest_place;
use crate::puzzle::rollout::Rollout;
use crate::puzzle::sampled_paths::SampledPaths;
use crate::puzzle::scene::Scene;
use crate::raster::{Bitmap, path_image, trail_image};
use crate::session::ending::{Ending, visible_end};
use crate::session::puzzle::Puzzle;
use crate::simulator::{ClosestApproach, Contact, Engine, closest_approach, first_contact, simulate};
use crate::verification::AttemptLine;

/// Maximum distance between the centre of an invalid ball and the place that it moves to, px.
const REACH: f64 = 64.0;

/// Number of rollouts to cache: those of a duel, and some that a person may go back to.
const KEPT_ROLLOUTS: usize = 8;

/// A puzzle that can be played.
#[wasm_bindgen]
pub struct OpenPuzzle {
    puzzle: Puzzle,
    /// The cached rollouts, latest last.
    kept: RefCell<Vec<(Option<Ball>, Rc<Rollout>)>>,
    layer: StaticLayer,
}

#[wasm_bindgen]
impl OpenPuzzle {
    /// Opens a task by its id, or a custom scene.
    #[wasm_bindgen(constructor)]
    pub fn new(puzzle: JsPuzzle) -> Result<OpenPuzzle, JsValue> {
        Ok(OpenPuzzle { puzzle: load(&puzzle)?, kept: RefCell::default(), layer: StaticLayer::default() })
    }

    /// Returns a description of the puzzle.
    #[wasm_bindgen(unchecked_return_type = "About")]
    pub fn about(&self) -> Result<JsValue, JsValue> {
        let Puzzle { id, scene, .. } = &self.puzzle;
        to_js(&json!({"id": id.task(), "digest": id.digest(), "name": self.puzzle.name(), "scene": scene}))
    }

    /// Returns why a ball is invalid; undefined if it is valid.
    #[wasm_bindgen(js_name = whyInvalid, unchecked_return_type = "InvalidBall | undefined")]
    pub fn why_invalid(&self, x: f64, y: f64, r: f64) -> Result<JsValue, JsValue> {
        to_js(&match (Ball { x, y, r }).check(&self.puzzle.scene) {
            Ok(()) => return Ok(JsValue::UNDEFINED),
            Err(Invalid::Radius) => json!({"kind": "radius"}),
            Err(Invalid::Overlaps(body)) => json!({"kind": "overlaps", "body": body}),
            // A puzzle's scene can always be simulated, so all of these mean that the ball is outside it.
            Err(Invalid::Outside | Invalid::OutOfRange | Invalid::Scene(_)) => json!({"kind": "outside"}),
        })
    }

    /// Returns the nearest valid ball of the same radius; undefined if none is near.
    #[wasm_bindgen(js_name = nearestPlace, unchecked_return_type = "Ball | undefined")]
    pub fn nearest_place(&self, x: f64, y: f64, r: f64) -> Option<Vec<f64>> {
        let place = nearest_place(Ball { x, y, r }, &Obstacles::new(&self.puzzle.scene), REACH)?;
        Some(<[f64; 3]>::from(place).to_vec())
    }

    /// Returns the rollout of a ball or, if it is null, of the scene alone. Throws `invalid_ball`.
    #[wasm_bindgen(unchecked_return_type = "RolloutFacts")]
    pub fn rollout(&self, ball: JsBallOrNull) -> Result<JsValue, JsValue> {
        #[derive(Serialize)]
        struct RolloutFacts {
            line: AttemptLine,
            ending: Ending,
            last: usize,
            nearest: ClosestApproach,
            contact: Option<Contact>,
            paths: Option<TypedPaths>,
        }
        let ball: Option<Ball> = ball_from(ball)?;
        let rollout = self.simulated(ball)?;
        let scene = &self.puzzle.scene;
        to_js(&RolloutFacts {
            line: AttemptLine::of(&self.puzzle, ball, Engine::default()),
            ending: Ending::of(&rollout),
            last: visible_end(&rollout),
            nearest: closest_approach(scene, &rollout),
            contact: ball.and_then(|ball| first_contact(scene, ball, &rollout)),
            paths: SampledPaths::of(&rollout, scene.body1, scene.bodies.len()).as_ref().map(TypedPaths::from),
        })
    }

    /// Returns the real paths of a ball's rollout as masks; if the ball is null, only that of the green object. Throws
    /// `invalid_ball`.
    #[wasm_bindgen(js_name = pathMasks, unchecked_return_type = "PathMasks")]
    pub fn path_masks(&self, ball: JsBallOrNull) -> Result<JsValue, JsValue> {
        #[derive(Serialize)]
        struct PathMasks {
            object: Typed<Float32Array>,
            #[serde(skip_serializing_if = "Option::is_none")]
            ball: Option<Typed<Float32Array>>,
        }
        let ball: Option<Ball> = ball_from(ball)?;
        let rollout = self.simulated(ball)?;
        let mask = |image: Bitmap| Typed(image.to_f32().collect::<Vec<_>>().as_slice().into());
        let Scene { bodies, body1, .. } = &self.puzzle.scene;
        to_js(&PathMasks {
            object: mask(path_image(&bodies[*body1], &rollout, *body1)),
            ball: ball.map(|ball| mask(path_image(&ball.body(), &rollout, bodies.len()))),
        })
    }

    /// Returns a path of the green object that a person has drawn (x, y, x, y, … in px) as a mask.
    #[wasm_bindgen(js_name = sketchMask)]
    pub fn sketch_mask(&self, points: &[f64]) -> Vec<f32> {
        let Scene { bodies, body1, .. } = &self.puzzle.scene;
        trail_image(&bodies[*body1], points.as_chunks().0).to_f32().collect()
    }

    /// Draws a frame into a square canvas: the scene, the maps over it, then paths, balls and the ring. The bodies are
    /// those of the first rollout; further rollouts are drawn over it. Throws `invalid_ball`.
    pub fn paint(
        &self,
        context: &CanvasRenderingContext2d,
        #[wasm_bindgen(unchecked_param_type = "ShownRollout[]")] rollouts: JsValue,
        #[wasm_bindgen(unchecked_param_type = "View")] view: JsValue,
        maps: Vec<HtmlCanvasElement>,
    ) -> Result<(), JsValue> {
        #[derive(Deserialize)]
        struct ShownRollout {
            ball: Option<Ball>,
            of_model: bool,
        }
        let shown: Vec<ShownRollout> = from_js(rollouts)?;
        let recording =
            |ShownRollout { ball, of_model }| Ok(Recording { ball, rollout: self.simulated(ball)?, of_model });
        let recordings = shown.into_iter().map(recording).collect::<Result<Vec<_>, JsValue>>()?;
        frame::paint(context, &self.puzzle.scene, Some(&self.layer), &recordings, &from_js(view)?, &maps)
    }
}

impl OpenPuzzle {
    fn simulated(&self, ball: Option<Ball>) -> Result<Rc<Rollout>, JsValue> {
        let mut kept = self.kept.borrow_mut();
        if let Some(index) = kept.iter().position(|(of, _)| *of == ball) {
            kept[index..].rotate_left(1);
        } else {
            let scene = &self.puzzle.scene;
            let rollout = simulate(scene, ball).map_err(|why| invalid_ball(why, scene))?;
            if kept.len() == KEPT_ROLLOUTS {
                kept.remove(0);
            }
            kept.push((ball, Rc::new(rollout)));
        }
        Ok(kept.last().expect("it was kept last").1.clone())
    }
}

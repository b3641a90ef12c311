//! An open puzzle as a value: which balls it admits, what a ball leads to, and every frame of it. Nothing that a caller
//! does changes an answer; the page holds the attempts.
//!
//! A rollout is named by its ball, because the same ball always leads to the same rollout. The last few are kept, so
//! that the frames of a rollout simulate it once.

use std::cell::RefCell;
use std::rc::Rc;

use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use super::describe::{about, invalid_reason};
use super::error::{Code, error, from_js, to_js};
use super::frame;
use super::game::InvalidBall;
use super::imagined_paths::paths_to_js;
use super::paint::LineStyle;
use super::puzzle_from_js::load;
use super::recording::Recording;
use super::scripting::ball_from;
use crate::puzzle::action::{Ball, Obstacles};
use crate::puzzle::nearest_place::nearest_place;
use crate::puzzle::rollout::Rollout;
use crate::puzzle::sampled_paths::SampledPaths;
use crate::raster::trail_image;
use crate::session::ending::Ending;
use crate::session::moments::visible_end;
use crate::session::puzzle::Puzzle;
use crate::simulator::{ClosestApproach, Contact, Engine, closest_approach, first_contact, simulate};
use crate::verification::AttemptLine;

/// How far the centre of an invalid ball may be from the place that it goes to instead, px.
const REACH: f64 = 64.0;

/// How many rollouts are kept: those of a duel, and some that a person may go back to.
const KEPT_ROLLOUTS: usize = 8;

/// A puzzle that can be played.
#[wasm_bindgen]
pub struct OpenPuzzle {
    puzzle: Puzzle,
    /// The latest last.
    kept: RefCell<Vec<(Option<Ball>, Rc<Rollout>)>>,
}

/// One of the rollouts of a frame.
#[derive(Deserialize)]
struct ShownRollout {
    /// `None` if the scene runs alone.
    ball: Option<Ball>,
    of_model: bool,
}

#[wasm_bindgen]
impl OpenPuzzle {
    /// Opens a task by its id, or a custom scene.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played.
    #[wasm_bindgen(constructor)]
    pub fn new(#[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue) -> Result<OpenPuzzle, JsValue> {
        Ok(OpenPuzzle { puzzle: load(puzzle)?, kept: RefCell::default() })
    }

    /// Returns what the puzzle is.
    #[wasm_bindgen(unchecked_return_type = "About")]
    pub fn about(&self) -> Result<JsValue, JsValue> {
        about(&self.puzzle)
    }

    /// Returns why a ball is invalid; undefined if it is valid.
    #[wasm_bindgen(js_name = whyInvalid, unchecked_return_type = "InvalidBall | undefined")]
    pub fn why_invalid(&self, x: f64, y: f64, r: f64) -> Result<JsValue, JsValue> {
        let fault = (Ball { x, y, r }).check(&self.puzzle.scene).err();
        fault.map_or(Ok(JsValue::UNDEFINED), |why| to_js(&InvalidBall::of(why)))
    }

    /// Returns the nearest valid ball of the same radius, if one is not far away.
    #[wasm_bindgen(js_name = nearestPlace, unchecked_return_type = "Ball | undefined")]
    pub fn nearest_place(&self, x: f64, y: f64, r: f64) -> Option<Vec<f64>> {
        let place = nearest_place(Ball { x, y, r }, &Obstacles::new(&self.puzzle.scene), REACH)?;
        Some(<[f64; 3]>::from(place).to_vec())
    }

    /// Returns what a ball leads to; without one, what the scene does alone.
    ///
    /// # Errors
    /// `bad_data` if it is not a ball, `invalid_ball`.
    #[wasm_bindgen(unchecked_return_type = "RolloutFacts")]
    pub fn rollout(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Ball | null")] ball: JsValue,
    ) -> Result<JsValue, JsValue> {
        #[derive(Serialize)]
        struct Facts {
            line: AttemptLine,
            ending: Ending,
            last: usize,
            nearest: ClosestApproach,
            contact: Option<Contact>,
        }
        let ball: Option<Ball> = ball_from(ball)?;
        let rollout = self.simulated(ball)?;
        let scene = &self.puzzle.scene;
        let facts = to_js(&Facts {
            line: AttemptLine::of(&self.puzzle, ball, Engine::default()),
            ending: Ending::of(&rollout),
            last: visible_end(&rollout),
            nearest: closest_approach(scene, &rollout),
            contact: ball.and_then(|ball| first_contact(scene, ball, &rollout)),
        })?;
        let paths = SampledPaths::of(&rollout, scene.body1, scene.bodies.len());
        let paths = paths.map_or(Ok(JsValue::NULL), |paths| paths_to_js(&paths).map(Into::into))?;
        js_sys::Reflect::set(&facts, &"paths".into(), &paths)?;
        Ok(facts)
    }

    /// Returns the real paths of what a ball leads to as masks; without a ball, that of the green object alone.
    ///
    /// # Errors
    /// `bad_data` if it is not a ball, `invalid_ball`.
    #[wasm_bindgen(js_name = pathMasks, unchecked_return_type = "PathMasks")]
    pub fn path_masks(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Ball | null")] ball: JsValue,
    ) -> Result<JsValue, JsValue> {
        let ball = ball_from(ball)?;
        let rollout = self.simulated(ball)?;
        Recording { ball, rollout, line_style: LineStyle::Solid, of_model: false }.path_masks(&self.puzzle.scene)
    }

    /// Returns what a person has drawn as the path of the green object (x, y, x, y, … in px) as a mask of its path.
    #[wasm_bindgen(js_name = sketchMask)]
    pub fn sketch_mask(&self, points: &[f64]) -> Vec<f32> {
        let points: Vec<[f64; 2]> = points.chunks_exact(2).map(|point| [point[0], point[1]]).collect();
        let Puzzle { scene, .. } = &self.puzzle;
        trail_image(&scene.bodies[scene.body1], &points).to_f32().collect()
    }

    /// Draws a frame into a square canvas: the scene, the maps over it, then paths, balls and the ring. Bodies are
    /// those of the first rollout; the others lie over it.
    ///
    /// # Errors
    /// `bad_data` if a value does not have the agreed form, `invalid_ball`.
    pub fn paint(
        &self,
        context: &CanvasRenderingContext2d,
        #[wasm_bindgen(unchecked_param_type = "ShownRollout[]")] rollouts: JsValue,
        #[wasm_bindgen(unchecked_param_type = "View")] view: JsValue,
        maps: Vec<HtmlCanvasElement>,
    ) -> Result<(), JsValue> {
        let shown: Vec<ShownRollout> = from_js(rollouts)?;
        let recording = |ShownRollout { ball, of_model }: ShownRollout| {
            let rollout = self.simulated(ball)?;
            Ok(Recording { ball, rollout, line_style: LineStyle::Solid, of_model })
        };
        let recordings = shown.into_iter().map(recording).collect::<Result<Vec<_>, JsValue>>()?;
        frame::paint(context, &self.puzzle.scene, &recordings, &from_js(view)?, &maps)
    }
}

impl OpenPuzzle {
    fn simulated(&self, ball: Option<Ball>) -> Result<Rc<Rollout>, JsValue> {
        let mut kept = self.kept.borrow_mut();
        if let Some(index) = kept.iter().position(|(of, _)| *of == ball) {
            kept[index..].rotate_left(1);
        } else {
            let scene = &self.puzzle.scene;
            let rollout = simulate(scene, ball).map_err(|why| error(Code::InvalidBall, invalid_reason(why, scene)))?;
            if kept.len() == KEPT_ROLLOUTS {
                kept.remove(0);
            }
            kept.push((ball, Rc::new(rollout)));
        }
        Ok(kept.last().expect("it was kept last").1.clone())
    }
}

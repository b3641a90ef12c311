//! The model in the worker: weights in, then imagined maps and attempts out.
//!
//! Slow work, so the page never calls it: nets take some ten milliseconds a scene, a rollout about one, and a
//! turn up to a hundred rollouts. A turn gives its attempts one by one, so that the worker can stop between.

use wasm_bindgen::prelude::*;

use super::error::{Code, error, plain};
use super::load;
use crate::agents;
use crate::agents::ranking::probability_map;
use crate::benchmark::folds::Fold;
use crate::nets::{Card, PathNet, flex};
use crate::play::ending::Ending;
use crate::play::game::{ATTEMPT_LIMIT, Attempt};
use crate::puzzle::action::Ball;
use crate::puzzle::scene::Scene;
use crate::puzzle::task::{Task, TaskId};
use crate::simulator::simulate;

/// The nets with their weights.
#[wasm_bindgen]
pub struct Model {
    net: PathNet,
    card: Card,
    /// The tasks that it was trained on or chosen by, ascending.
    seen: Vec<TaskId>,
}

/// The model's turn on one puzzle: its proposals, tried in order.
#[wasm_bindgen]
pub struct Turn {
    scene: Scene,
    balls: std::vec::IntoIter<Ball>,
    solved: bool,
}

#[wasm_bindgen]
impl Model {
    /// The nets from the bytes of a weights file.
    ///
    /// # Errors
    /// `bad_weights` if the file is damaged or belongs to other nets.
    #[wasm_bindgen(constructor)]
    pub fn new(bytes: &[u8]) -> Result<Model, JsValue> {
        let (net, card) = PathNet::load(bytes, &flex()).map_err(|why| error(Code::BadWeights, why))?;
        let seen = Fold::new(card.setup, card.fold).all_train();
        Ok(Model { net, card, seen })
    }

    /// How the weights came to be: `{ setup, fold, seed, epochs, samples, … }`.
    pub fn card(&self) -> Result<JsValue, JsValue> {
        plain(&self.card)
    }

    /// Was the model trained on this task, or its settings chosen by it?
    ///
    /// # Errors
    /// `bad_task` if there is no such task.
    pub fn saw(&self, id: &str) -> Result<bool, JsValue> {
        Ok(self.seen.binary_search(&load(id)?.id).is_ok())
    }

    /// The maps of a task: `{ base, target, action, placement }`, and `judge` if the weights have one; each a
    /// Float32Array of 64 x 64 values in 0..=1, row 0 at the bottom.
    ///
    /// # Errors
    /// `bad_task` if there is no such task.
    pub fn imagine(&self, id: &str) -> Result<JsValue, JsValue> {
        let scene = load(id)?.scene;
        let imagined = self.net.imagine(&scene);
        let judge = self.net.judge_logits(&scene).and_then(|logits| probability_map(&logits, &scene));
        let maps = js_sys::Object::new();
        let stages = [
            ("base", Some(imagined.base)),
            ("target", Some(imagined.target)),
            ("action", Some(imagined.action)),
            ("placement", Some(imagined.placement)),
            ("judge", judge),
        ];
        for (stage, map) in stages {
            let Some(map) = map else { continue };
            js_sys::Reflect::set(&maps, &stage.into(), &js_sys::Float32Array::from(map.as_slice()))?;
        }
        Ok(maps.into())
    }

    /// The balls that the model would try, in order, and where each comes from:
    /// `[{ ball, origin: { kind: "judge", probability } | { kind: "map", x, y } | { kind: "perturbed", number } |
    /// { kind: "uniform" }, rejected }, …]`;
    /// `rejected` counts the draws before it that were invalid or proposed already.
    ///
    /// # Errors
    /// `bad_task` if there is no such task.
    pub fn propose(&self, id: &str, seed: u32) -> Result<JsValue, JsValue> {
        let Task { id, scene, .. } = load(id)?;
        plain(&agents::propose(&self.net, id, &scene, seed.into(), ATTEMPT_LIMIT))
    }

    /// Begins the model's turn on a task. The same seed gives the same attempts.
    ///
    /// # Errors
    /// `bad_task` if there is no such task.
    pub fn turn(&self, id: &str, seed: u32) -> Result<Turn, JsValue> {
        let Task { id, scene, .. } = load(id)?;
        let proposals = agents::propose(&self.net, id, &scene, seed.into(), ATTEMPT_LIMIT);
        let balls: Vec<Ball> = proposals.into_iter().map(|proposal| proposal.ball).collect();
        Ok(Turn { scene, balls: balls.into_iter(), solved: false })
    }
}

#[wasm_bindgen]
impl Turn {
    /// Tries the next ball: `{ ball, ending }`; nothing once the puzzle is solved or the balls are used up.
    ///
    /// # Errors
    /// `invalid_ball` if the model proposes what may not be placed.
    pub fn attempt(&mut self) -> Result<JsValue, JsValue> {
        let ball = match self.balls.next() {
            Some(ball) if !self.solved => ball,
            _ => return Ok(JsValue::UNDEFINED),
        };
        let rollout = simulate(&self.scene, Some(ball)).map_err(|why| error(Code::InvalidBall, why))?;
        self.solved = rollout.solved;
        plain(&Attempt { ball, ending: Ending::of(&rollout) })
    }
}

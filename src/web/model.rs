//! The model in the worker: loads weights, then imagines maps, proposes balls and tries them.
//!
//! The page never calls it, because it is slow: the nets take some ten milliseconds per scene, a rollout about one, and
//! a turn simulates up to a hundred rollouts. `Turn` makes one attempt per call, so that the worker can stop in
//! between.

use serde::Serialize;
use wasm_bindgen::prelude::*;

use super::error::{Code, error, to_js};
use super::played::load;
use crate::agents::Proposal;
use crate::agents::memoized_model::MemoizedModel;
use crate::agents::ranking::probability_map;
use crate::benchmark::folds::Fold;
use crate::colour::stage::Stage;
use crate::nets::{Card, Imagined, PathNet, flex};
use crate::play::ending::Ending;
use crate::play::game::ATTEMPT_LIMIT;
use crate::play::played::Played;
use crate::play::turn;
use crate::puzzle::task::TaskId;

/// Most balls of one list of proposals, as on the command line.
const MAX_PROPOSALS: usize = 1000;

/// The nets with their weights.
#[wasm_bindgen]
pub struct Model {
    pub(super) model: MemoizedModel,
    card: Card,
    /// The tasks that it was trained on or chosen by, ascending.
    seen: Vec<TaskId>,
}

/// A ball of the model's turn: proposed, then simulated.
#[derive(Serialize)]
struct TriedProposal {
    #[serde(flatten)]
    proposal: Proposal,
    ending: Ending,
}

/// The model's turn on one puzzle.
#[wasm_bindgen]
pub struct Turn(turn::Turn);

#[wasm_bindgen]
impl Model {
    /// Loads the nets from the bytes of a weights file.
    ///
    /// # Errors
    /// `bad_weights` if the file is damaged or belongs to other nets.
    #[wasm_bindgen(constructor)]
    pub fn new(bytes: &[u8]) -> Result<Model, JsValue> {
        let (nets, card) = PathNet::load(bytes, &flex()).map_err(|why| error(Code::BadWeights, why))?;
        let seen = Fold::new(card.setup, card.fold).all_train();
        Ok(Model { model: MemoizedModel::new(nets), card, seen })
    }

    /// Returns how the weights were trained.
    #[wasm_bindgen(unchecked_return_type = "ModelCard")]
    pub fn card(&self) -> Result<JsValue, JsValue> {
        to_js(&self.card)
    }

    /// Whether the model was trained on this task or its settings were chosen on it; never for an own scene.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played.
    #[wasm_bindgen(js_name = hasSeen)]
    pub fn has_seen(&self, #[wasm_bindgen(unchecked_param_type = "Played")] played: JsValue) -> Result<bool, JsValue> {
        Ok(load(played)?.id.task().is_some_and(|task| self.seen.binary_search(&task).is_ok()))
    }

    /// Returns the maps of a task: for each stage a Float32Array of 64 x 64 values in 0..=1, row 0 at the bottom.
    /// Weights with neither a judge nor a dynamics net have no map `judge`.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played.
    #[wasm_bindgen(unchecked_return_type = "Maps")]
    pub fn imagine(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Played")] played: JsValue,
    ) -> Result<JsValue, JsValue> {
        let scene = load(played)?.scene;
        let nets = &self.model.nets;
        let imagined = nets.imagine(&scene);
        let judge = nets.cell_logits(&scene).and_then(|logits| probability_map(&logits, &scene));
        let maps = js_sys::Object::new();
        for stage in Stage::ALL {
            let map = match stage {
                Stage::Base => Some(&imagined.base),
                Stage::Target => Some(&imagined.target),
                Stage::Action => Some(&imagined.action),
                Stage::Placement => Some(&imagined.placement),
                Stage::Judge => judge.as_ref(),
            };
            if let Some(map) = map {
                js_sys::Reflect::set(&maps, &stage.name().into(), &js_sys::Float32Array::from(map.as_slice()))?;
            }
        }
        Ok(maps.into())
    }

    /// Returns the balls that the model would try, in order, each with its origin: `count` of them, 1 to 1,000; without
    /// a count as many as there are attempts.
    ///
    /// # Errors `bad_task` if there is no such task, `bad_scene` if the scene may not be played, `bad_data` if the
    /// count is out of range or not a whole number.
    #[wasm_bindgen(unchecked_return_type = "Proposal[]")]
    pub fn propose(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Played")] played: JsValue,
        seed: u32,
        count: Option<f64>,
    ) -> Result<JsValue, JsValue> {
        let Played { id, scene, .. } = load(played)?;
        let count = count.map_or(Ok(ATTEMPT_LIMIT), whole_count)?;
        to_js(&self.model.propose(&scene, id.seed(seed.into()), count))
    }

    /// Starts the model's turn on a task. The same seed leads to the same attempts.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played.
    pub fn turn(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Played")] played: JsValue,
        seed: u32,
    ) -> Result<Turn, JsValue> {
        let Played { id, scene, .. } = load(played)?;
        let agent = self.model.start(&scene, id.seed(seed.into()), ATTEMPT_LIMIT);
        Ok(Turn(turn::Turn::new(scene, agent)))
    }

    /// Returns the maps of the paper's four nets alone, without the judge: base, target, action and placement in one
    /// Float32Array `[4, 64, 64]`. `make bench` compares it with other engines, which run the same four nets.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played.
    #[wasm_bindgen(js_name = imaginePaths)]
    pub fn imagine_paths(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Played")] played: JsValue,
    ) -> Result<Vec<f32>, JsValue> {
        let Imagined { base, target, action, placement } = self.model.nets.imagine(&load(played)?.scene);
        Ok([base, target, action, placement].concat())
    }
}

#[wasm_bindgen]
impl Turn {
    /// Tries the next ball and returns the attempt; undefined once the puzzle is solved or no ball is left.
    ///
    /// # Errors
    /// `invalid_ball` if the model proposes an invalid ball.
    #[wasm_bindgen(unchecked_return_type = "TriedProposal | undefined")]
    pub fn attempt(&mut self) -> Result<JsValue, JsValue> {
        match self.0.attempt().map_err(|why| error(Code::InvalidBall, why))? {
            Some((proposal, rollout)) => to_js(&TriedProposal { proposal, ending: Ending::of(&rollout) }),
            None => Ok(JsValue::UNDEFINED),
        }
    }
}

/// Returns a number of proposals. It comes as JavaScript's number, because wasm-bindgen would wrap or truncate others.
fn whole_count(count: f64) -> Result<usize, JsValue> {
    let whole = (1.0..=MAX_PROPOSALS as f64).contains(&count) && count.fract() == 0.0;
    let refused = || error(Code::BadData, format!("the model proposes 1 to {MAX_PROPOSALS} balls, not {count}"));
    whole.then_some(count as usize).ok_or_else(refused)
}

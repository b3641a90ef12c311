//! The model in the worker: loads weights, then imagines maps, proposes balls and tries them.
//!
//! The page never calls it, because it is slow: the nets take some ten milliseconds per scene, a rollout about one, and
//! a turn simulates up to a hundred rollouts. `Turn` makes one attempt per call, so that the worker can stop in
//! between.

use serde::Serialize;
use wasm_bindgen::prelude::*;

use sha2::{Digest, Sha256};

use super::error::{Code, error, to_js, whole_number};
use super::memory::{Memory, TurnMemory};
use super::puzzle_from_js::load;
use crate::agents::Proposal;
use crate::agents::memoized_model::MemoizedModel;
use crate::agents::memory::Reminder;
use crate::agents::ranking::probability_map;
use crate::benchmark::folds::Fold;
use crate::colour::imagined_maps::ImaginedMap;
use crate::nets::{Card, PathNet};
use crate::puzzle::hex::hex;
use crate::puzzle::task::TaskId;
use crate::session::ending::Ending;
use crate::session::game::ATTEMPT_LIMIT;
use crate::session::puzzle::Puzzle;
use crate::session::turn;

/// Maximum number of balls in one list of proposals, as on the command line.
const MAX_PROPOSALS: u32 = 1000;

/// The nets with their weights.
#[wasm_bindgen]
pub struct Model {
    pub(super) model: MemoizedModel,
    card: Card,
    /// SHA-256 of the weights file, in hexadecimal.
    weights: String,
    /// The tasks that it was trained on or chosen by, ascending.
    seen: Vec<TaskId>,
}

/// A ball of the model's turn: proposed, then simulated.
#[derive(Serialize)]
struct TriedProposal {
    #[serde(flatten)]
    proposal: Proposal,
    ending: Ending,
    #[serde(skip_serializing_if = "Option::is_none")]
    reminder: Option<Reminder>,
}

/// The model's turn on one puzzle.
#[wasm_bindgen]
pub struct Turn {
    turn: turn::Turn,
    memory: Option<TurnMemory>,
}

#[wasm_bindgen]
impl Model {
    /// Loads the nets from the bytes of a weights file. Their SHA-256, in hexadecimal, is computed if it is not known.
    ///
    /// # Errors
    /// `bad_weights` if the file is damaged or belongs to other nets.
    #[wasm_bindgen(constructor)]
    pub fn new(bytes: &[u8], sha256: Option<String>) -> Result<Model, JsValue> {
        let (nets, card) = PathNet::load(bytes).map_err(|why| error(Code::BadWeights, why))?;
        let seen = Fold::new(card.setup, card.fold).all_train();
        let weights = sha256.unwrap_or_else(|| hex(Sha256::digest(bytes)));
        Ok(Model { model: MemoizedModel::new(nets), card, weights, seen })
    }

    /// Returns how the weights were trained.
    #[wasm_bindgen(unchecked_return_type = "ModelCard")]
    pub fn card(&self) -> Result<JsValue, JsValue> {
        to_js(&self.card)
    }

    /// Whether nets of the model were trained on this task or its settings were chosen on it; never for a custom scene.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played.
    #[wasm_bindgen(js_name = hasSeen)]
    pub fn has_seen(&self, #[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue) -> Result<bool, JsValue> {
        Ok(load(puzzle)?.id.task().is_some_and(|task| self.seen.binary_search(&task).is_ok()))
    }

    /// Returns the maps of a task: for each a Float32Array of 64 x 64 values in 0..=1, row 0 at the bottom.
    /// Weights with neither a success net nor a dynamics net have no map `success`.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played.
    #[wasm_bindgen(unchecked_return_type = "Maps")]
    pub fn imagine(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue,
    ) -> Result<JsValue, JsValue> {
        let scene = load(puzzle)?.scene;
        let nets = &self.model.nets;
        let imagined = nets.imagine(&scene);
        let success = nets.cell_logits(&scene).and_then(|logits| probability_map(&logits, &scene));
        let maps = js_sys::Object::new();
        for map in ImaginedMap::ALL {
            let values = match map {
                ImaginedMap::Success => success.as_deref(),
                of_paper => imagined.map(of_paper),
            };
            if let Some(values) = values {
                js_sys::Reflect::set(&maps, &map.name().into(), &js_sys::Float32Array::from(values))?;
            }
        }
        Ok(maps.into())
    }

    /// Returns the balls that the model would try, in order, each with its origin: `count` of them, 1 to 1,000; without
    /// a count as many as there are attempts.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played, `bad_data` if the seed or the
    /// count is out of range or not a whole number.
    #[wasm_bindgen(unchecked_return_type = "Proposal[]")]
    pub fn propose(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] seed: &JsValue,
        #[wasm_bindgen(unchecked_optional_param_type = "number")] count: &JsValue,
    ) -> Result<JsValue, JsValue> {
        let Puzzle { id, scene, .. } = load(puzzle)?;
        let seed = whole_seed(seed)?;
        let count = if count.is_undefined() || count.is_null() {
            ATTEMPT_LIMIT
        } else {
            whole_number(count, 1..=MAX_PROPOSALS, format_args!("the model proposes 1 to {MAX_PROPOSALS} balls"))?
                as usize
        };
        to_js(&self.model.propose(&scene, id.seed(seed), count))
    }

    /// Starts the model's turn on a task. The same seed leads to the same attempts.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played, `bad_data` if the seed is out
    /// of range or not a whole number.
    pub fn turn(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] seed: &JsValue,
    ) -> Result<Turn, JsValue> {
        let Puzzle { id, scene, .. } = load(puzzle)?;
        let agent = self.model.start(&scene, id.seed(whole_seed(seed)?), ATTEMPT_LIMIT);
        Ok(Turn { turn: turn::Turn::new(scene, agent), memory: None })
    }

    /// Returns a memory of attempts for this model: an empty one, or that of JSON which `Memory.toJson` or
    /// `pathlight agent --memory` wrote.
    ///
    /// # Errors
    /// `bad_memory` if it is damaged, of another format, or learned with other weights.
    pub fn memory(&self, json: Option<String>) -> Result<Memory, JsValue> {
        Memory::new(&self.weights, json.as_deref())
    }

    /// Starts the model's turn on a task, in which it uses what a memory holds, and remembers each attempt. Draws
    /// nothing at random.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played, `bad_memory` if the memory
    /// is of other weights, `bad_weights` if these weights have no dynamics net.
    #[wasm_bindgen(js_name = turnWith)]
    pub fn turn_with(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue,
        memory: &Memory,
    ) -> Result<Turn, JsValue> {
        let Puzzle { id, scene, .. } = load(puzzle)?;
        memory.check_weights(&self.weights)?;
        let lacking = || error(Code::BadWeights, "weights without a dynamics net cannot play with a memory");
        if self.model.nets.dynamics.is_none() {
            return Err(lacking());
        }
        let memory = memory.begin(id, &scene);
        let agent = self.model.start_with(&scene, ATTEMPT_LIMIT, &memory.recollection).ok_or_else(lacking)?;
        Ok(Turn { turn: turn::Turn::new(scene, agent), memory: Some(memory) })
    }

    /// Returns the maps of the paper's nets alone: base, target, action and placement in one Float32Array
    /// `[4, 64, 64]`. `make bench` compares it with other engines, which run the same nets.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played.
    #[wasm_bindgen(js_name = imaginePaths)]
    pub fn imagine_paths(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue,
    ) -> Result<Vec<f32>, JsValue> {
        let imagined = self.model.nets.imagine(&load(puzzle)?.scene);
        let maps: Vec<&[f32]> = ImaginedMap::ALL.into_iter().filter_map(|map| imagined.map(map)).collect();
        Ok(maps.concat())
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
        let attempt = self.turn.attempt().map_err(|why| error(Code::InvalidBall, why))?;
        let Some((proposal, rollout)) = attempt else { return Ok(JsValue::UNDEFINED) };
        let memory = self.memory.as_ref();
        let reminder = memory.and_then(|memory| memory.recollection.reminder(proposal.ball));
        if let Some(memory) = memory {
            memory.observe(&proposal, rollout.solved);
        }
        to_js(&TriedProposal { proposal, ending: Ending::of(&rollout), reminder })
    }
}

fn whole_seed(seed: &JsValue) -> Result<u64, JsValue> {
    whole_number(seed, 0..=u32::MAX, "a seed is a whole number from 0 to 2^32 - 1").map(u64::from)
}

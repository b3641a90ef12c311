//! The model in the worker: loads weights, imagines maps and paths, proposes balls and tries them.
//!
//! The page's main thread never calls it, because it is slow: the nets take some ten milliseconds per scene, a rollout
//! about one, and a turn simulates up to a hundred rollouts. `Turn` makes one attempt per call, so that the worker can
//! stop in between.

use js_sys::{Float32Array, Number, Object, Reflect, Uint32Array};
use serde::Serialize;
use sha2::{Digest, Sha256};
use wasm_bindgen::prelude::*;

use super::data::{Typed, TypedPaths, to_js, whole_number};
use super::error::{Code, error};
use super::memory::{Memory, TurnMemory};
use super::puzzle::{JsBall, JsPuzzle, ball_from, invalid_ball, load};
use crate::agents::memoized_model::MemoizedModel;
use crate::agents::memory::Reminder;
use crate::agents::online::Candidate;
use crate::agents::ranking::probability_map;
use crate::agents::{Proposal, sigmoid};
use crate::benchmark::auccess::MAX_ATTEMPTS;
use crate::benchmark::folds::Fold;
use crate::colour::imagined_maps::ImaginedMap;
use crate::nets::{Card, PathNet};
use crate::puzzle::action::Ball;
use crate::puzzle::hex::hex;
use crate::puzzle::sampled_paths::SAMPLED_STEPS;
use crate::puzzle::scene::Scene;
use crate::puzzle::task::TaskId;
use crate::session::ending::Ending;
use crate::session::puzzle::Puzzle;
use crate::session::turn;

/// Maximum number of balls in one list of proposals, as on the command line.
const MAX_PROPOSALS: u32 = 1000;

/// The nets with their weights.
#[wasm_bindgen]
pub struct Model {
    model: MemoizedModel,
    card: Card,
    /// SHA-256 of the weights file, in hexadecimal.
    weights: String,
    /// The tasks that it was trained on or that its settings were chosen on, ascending.
    seen: Vec<TaskId>,
}

/// The model's turn on one puzzle.
#[wasm_bindgen]
pub struct Turn {
    turn: turn::Turn,
    memory: Option<TurnMemory>,
}

#[wasm_bindgen]
impl Model {
    /// Loads the nets from the bytes of a weights file. Throws `bad_weights` if the file is damaged or belongs to other
    /// nets. Pass its SHA-256, in hexadecimal, if it is known; otherwise it is computed.
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

    /// Returns whether nets of the model were trained on this task or its settings were chosen on it; always false for
    /// a custom scene.
    #[wasm_bindgen(js_name = hasSeen)]
    pub fn has_seen(&self, puzzle: JsPuzzle) -> Result<bool, JsValue> {
        Ok(load(&puzzle)?.id.task().is_some_and(|task| self.seen.binary_search(&task).is_ok()))
    }

    /// Returns the maps of a puzzle, each a Float32Array of 64 x 64 values in 0..=1, row 0 at the bottom. If the
    /// weights have neither a success net nor a dynamics net, the map `success` is missing.
    #[wasm_bindgen(unchecked_return_type = "Maps")]
    pub fn imagine(&self, puzzle: JsPuzzle) -> Result<Object, JsValue> {
        let scene = load(&puzzle)?.scene;
        let nets = &self.model.nets;
        let imagined = nets.imagine(&scene);
        let success = nets.cell_logits(&scene).and_then(|logits| probability_map(&logits, &scene));
        let maps = Object::new();
        for map in ImaginedMap::ALL {
            let success = success.as_deref().filter(|_| map == ImaginedMap::Success);
            if let Some(values) = imagined.map(map).or(success) {
                Reflect::set(&maps, &map.name().into(), &Float32Array::from(values))?;
            }
        }
        Ok(maps)
    }

    /// Returns only the maps of the paper's nets: base, target, action and placement in one Float32Array `[4, 64, 64]`.
    /// `make bench` uses it for a comparison with other engines, which run the same nets.
    #[wasm_bindgen(js_name = imaginePaths)]
    pub fn imagine_paths(&self, puzzle: JsPuzzle) -> Result<Vec<f32>, JsValue> {
        let imagined = self.model.nets.imagine(&load(&puzzle)?.scene);
        let maps: Vec<&[f32]> = ImaginedMap::ALL.into_iter().filter_map(|map| imagined.map(map)).collect();
        Ok(maps.concat())
    }

    /// Imagines what a ball leads to: the paths of the green object and of the ball, and the probability that the ball
    /// solves. Returns undefined if the weights have no dynamics net; throws `invalid_ball`. The net's results for the
    /// last puzzle are kept, so further balls in it cost little.
    #[wasm_bindgen(js_name = imagineBall, unchecked_return_type = "ImaginedBall | undefined")]
    pub fn imagine_ball(&self, puzzle: JsPuzzle, ball: JsBall) -> Result<JsValue, JsValue> {
        #[derive(Serialize)]
        struct ImaginedBall {
            steps: Typed<Uint32Array>,
            #[serde(flatten)]
            paths: TypedPaths,
            errors: Typed<Float32Array>,
            probability: f64,
        }
        let scene = load(&puzzle)?.scene;
        let ball = valid_ball(ball, &scene)?;
        let Some(imagined) = self.model.imagine(&scene, ball) else { return Ok(JsValue::UNDEFINED) };
        to_js(&ImaginedBall {
            steps: Typed(SAMPLED_STEPS.map(|step| step as u32).as_slice().into()),
            paths: (&imagined.paths).into(),
            errors: Typed(imagined.errors.as_slice().into()),
            probability: sigmoid(imagined.logit.into()),
        })
    }

    /// Returns the balls that the model considers before it chooses, a few hundred; undefined if the weights have no
    /// dynamics net.
    #[wasm_bindgen(unchecked_return_type = "Candidate[] | undefined")]
    pub fn candidates(&self, puzzle: JsPuzzle) -> Result<JsValue, JsValue> {
        #[derive(Serialize)]
        struct JsCandidate {
            ball: Ball,
            probability: f64,
            object: Typed<Float32Array>,
        }
        let candidates = self.model.candidates(&load(&puzzle)?.scene, MAX_ATTEMPTS);
        let Some(candidates) = candidates else { return Ok(JsValue::UNDEFINED) };
        let candidate = |&Candidate { ball, logit, paths }: &Candidate| JsCandidate {
            ball,
            probability: sigmoid(logit),
            object: (&paths.object).into(),
        };
        to_js(&candidates.iter().map(candidate).collect::<Vec<_>>())
    }

    /// Returns the balls that the model would try, in order, each with its origin. `count` is 1 to 1,000; by default it
    /// is the number of attempts.
    #[wasm_bindgen(unchecked_return_type = "Proposal[]")]
    pub fn propose(&self, puzzle: JsPuzzle, seed: &Number, count: Option<Number>) -> Result<JsValue, JsValue> {
        let Puzzle { id, scene, .. } = load(&puzzle)?;
        let rule = format_args!("the model proposes 1 to {MAX_PROPOSALS} balls");
        let count = count.map(|count| whole_number(&count, 1..=MAX_PROPOSALS, rule)).transpose()?;
        let count = count.map_or(MAX_ATTEMPTS, |count| count as usize);
        to_js(&self.model.propose(&scene, id.seed(whole_seed(seed)?), count))
    }

    /// Starts the model's turn on a puzzle. The same seed leads to the same attempts.
    pub fn turn(&self, puzzle: JsPuzzle, seed: &Number) -> Result<Turn, JsValue> {
        let Puzzle { id, scene, .. } = load(&puzzle)?;
        let agent = self.model.start(&scene, id.seed(whole_seed(seed)?), MAX_ATTEMPTS);
        Ok(Turn { turn: turn::Turn::new(scene, agent), memory: None })
    }

    /// Starts the model's turn on a puzzle with a memory: the turn uses the memory and adds each attempt to it. Nothing
    /// is drawn at random. Throws `bad_memory` if the memory belongs to other weights, and `bad_weights` if these
    /// weights have no dynamics net.
    #[wasm_bindgen(js_name = turnWith)]
    pub fn turn_with(&self, puzzle: JsPuzzle, memory: &Memory) -> Result<Turn, JsValue> {
        let Puzzle { id, scene, .. } = load(&puzzle)?;
        memory.check_weights(&self.weights)?;
        let lacking = || error(Code::BadWeights, "weights without a dynamics net cannot play with a memory");
        if self.model.nets.dynamics.is_none() {
            return Err(lacking());
        }
        let memory = memory.begin(id, &scene);
        let agent = self.model.start_with(&scene, MAX_ATTEMPTS, &memory.recollection).ok_or_else(lacking)?;
        Ok(Turn { turn: turn::Turn::new(scene, agent), memory: Some(memory) })
    }

    /// Returns a memory of attempts for this model: empty, or read from JSON written by `Memory.toJson` or
    /// `pathlight agent --memory`. Throws `bad_memory` if the JSON is damaged, has another format, or was learned with
    /// other weights.
    pub fn memory(&self, json: Option<String>) -> Result<Memory, JsValue> {
        Memory::new(&self.weights, json.as_deref())
    }
}

#[wasm_bindgen]
impl Turn {
    /// Tries the next ball and returns the attempt; undefined once the puzzle is solved or no ball is left.
    #[wasm_bindgen(unchecked_return_type = "TriedProposal | undefined")]
    pub fn attempt(&mut self) -> Result<JsValue, JsValue> {
        #[derive(Serialize)]
        struct TriedProposal {
            #[serde(flatten)]
            proposal: Proposal,
            ending: Ending,
            #[serde(skip_serializing_if = "Option::is_none")]
            reminder: Option<Reminder>,
        }
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

/// Returns a valid ball of the scene.
///
/// # Errors
///
/// `bad_data` if the value is not a ball, `invalid_ball` if the ball is invalid.
pub(super) fn valid_ball(ball: JsBall, scene: &Scene) -> Result<Ball, JsValue> {
    let ball: Ball = ball_from(ball)?;
    ball.check(scene).map(|()| ball).map_err(|why| invalid_ball(why, scene))
}

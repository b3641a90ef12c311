//! The model's memory of attempts at earlier puzzles, as an object that JavaScript holds. Turns share it: they use it
//! and add to it.

use std::cell::RefCell;
use std::rc::Rc;

use serde::Serialize;
use wasm_bindgen::prelude::*;

use super::data::to_js;
use super::error::{Code, error};
use super::model::valid_ball;
use super::puzzle::{JsBall, JsPuzzle, load};
use crate::agents::Proposal;
use crate::agents::memory::{self, MemoryError, PuzzleSource, Recollection};
use crate::puzzle::scene::Scene;
use crate::session::puzzle::{Puzzle, PuzzleId};

/// A memory of attempts. It belongs to the weights for which it was made.
#[wasm_bindgen]
pub struct Memory {
    memory: Rc<RefCell<memory::Memory>>,
    /// SHA-256 of the weights.
    weights: String,
}

/// The parts of a memory that a turn reads and adds to.
pub(crate) struct TurnMemory {
    memory: Rc<RefCell<memory::Memory>>,
    source: PuzzleSource,
    scene: Scene,
    /// What the attempts at earlier puzzles say.
    pub recollection: Recollection,
}

impl Memory {
    pub(super) fn new(weights: &str, json: Option<&str>) -> Result<Memory, JsValue> {
        let mut memory = memory::Memory::default();
        if let Some(json) = json {
            memory.read_json(json.as_bytes(), Some(weights)).map_err(bad_memory)?;
        }
        Ok(Memory { memory: Rc::new(RefCell::new(memory)), weights: weights.to_string() })
    }

    pub(super) fn check_weights(&self, weights: &str) -> Result<(), JsValue> {
        if self.weights == weights { Ok(()) } else { Err(bad_memory(MemoryError::Weights)) }
    }

    pub(super) fn begin(&self, id: PuzzleId, scene: &Scene) -> TurnMemory {
        let source = source_of(id, scene);
        let recollection = self.memory.borrow_mut().begin(source.clone(), scene);
        TurnMemory { memory: Rc::clone(&self.memory), source, scene: scene.clone(), recollection }
    }
}

#[wasm_bindgen]
impl Memory {
    /// Returns the number of remembered attempts.
    pub fn attempts(&self) -> usize {
        self.memory.borrow().attempts()
    }

    /// Returns the remembered puzzles, in the order in which they were played.
    #[wasm_bindgen(unchecked_return_type = "RememberedPuzzle[]")]
    pub fn puzzles(&self) -> Result<JsValue, JsValue> {
        #[derive(Serialize)]
        struct RememberedPuzzle<'a> {
            number: usize,
            #[serde(flatten)]
            source: &'a PuzzleSource,
            attempts: &'a [memory::Attempt],
        }
        let memory = self.memory.borrow();
        let puzzles = memory.puzzles();
        let puzzles = puzzles.map(|(number, source, attempts)| RememberedPuzzle { number, source, attempts });
        to_js(&puzzles.collect::<Vec<_>>())
    }

    /// Remembers an attempt by someone other than the model. The attempts of a turn with this memory are remembered
    /// automatically. Throws `invalid_ball` if the ball is invalid.
    pub fn remember(&self, puzzle: JsPuzzle, ball: JsBall, solved: bool) -> Result<(), JsValue> {
        let Puzzle { id, scene, .. } = load(&puzzle)?;
        let ball = valid_ball(ball, &scene)?;
        self.memory.borrow_mut().observe_other(source_of(id, &scene), &scene, ball, solved);
        Ok(())
    }

    /// Forgets everything.
    pub fn forget(&self) {
        self.memory.borrow_mut().forget();
    }

    /// Returns the memory as JSON, which `Model.memory` can read back.
    #[wasm_bindgen(js_name = toJson)]
    pub fn to_json(&self) -> String {
        self.memory.borrow().to_json(Some(&self.weights))
    }
}

impl TurnMemory {
    /// Remembers the outcome of a ball.
    pub(crate) fn observe(&self, proposal: &Proposal, solved: bool) {
        let mut memory = self.memory.borrow_mut();
        // In the middle of a turn, everything may be forgotten, or another puzzle begun.
        if !memory.is_at(&self.source) {
            memory.begin(self.source.clone(), &self.scene);
        }
        memory.observe(proposal.ball, proposal.chance().unwrap_or_default(), solved);
    }
}

fn source_of(id: PuzzleId, scene: &Scene) -> PuzzleSource {
    id.task().map_or_else(|| PuzzleSource::Scene(Box::new(scene.clone())), PuzzleSource::Task)
}

fn bad_memory(why: MemoryError) -> JsValue {
    error(Code::BadMemory, why)
}

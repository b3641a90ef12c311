//! A memory as JSON, to keep between runs.
//!
//! `{"version","weights","forgotten","puzzles":[{"task" or "scene","attempts":[{"ball","chance","solved"},…]},…]}`. A
//! scene is kept whole, without its sketch, so that a later version can compare scenes in another way. All numbers have
//! few digits, because a parser may read longer ones one bit off.

use serde::{Deserialize, Serialize};

use super::{Attempt, CHANCES, LENGTHS, Memory, PuzzleSource, RememberedPuzzle, rounded};
use crate::puzzle::action::Ball;
use crate::puzzle::scene::SIZE;
use crate::puzzle::scene_form::FormFault;
use crate::puzzle::task::{Task, TaskError};
use crate::puzzle::utf8::{NotUtf8, utf8};

/// Version of the format.
const FORMAT: u32 = 1;

/// Upper limit on forgotten puzzles: the numbers of the puzzles that follow must fit into the 32 bits of wasm.
const MAX_FORGOTTEN: u32 = u32::MAX / 2;

/// Reasons why a memory cannot be used.
#[derive(Debug, thiserror::Error)]
#[allow(missing_docs, reason = "the messages say it")]
pub enum MemoryError {
    #[error(transparent)]
    Text(#[from] NotUtf8),
    #[error("this is not a memory, or it is damaged: {0}")]
    Json(serde_json::Error),
    #[error("this memory has format {0}, but this program reads format {FORMAT}: begin a new one")]
    Format(u32),
    #[error("this memory was learned with other weights: use those, or begin a new one")]
    Weights,
    #[error("this memory was learned by an agent without weights: use that agent, or begin a new one")]
    WithoutWeights,
    #[error("puzzle {puzzle} of this memory is damaged: {why}")]
    Task { puzzle: usize, why: TaskError },
    #[error("puzzle {puzzle} of this memory is damaged: {why}")]
    Scene { puzzle: usize, why: FormFault },
    #[error("this memory is damaged: it cannot have forgotten {0} puzzles")]
    Forgotten(u32),
    #[error(
        "attempt {attempt} at puzzle {puzzle} of this memory is damaged: the ball must be valid and the chance 0 to 1"
    )]
    Attempt { puzzle: usize, attempt: usize },
}

/// The part that all versions have in common.
#[derive(Deserialize)]
struct Head {
    version: u32,
}

#[derive(Serialize, Deserialize)]
struct Saved {
    version: u32,
    /// SHA-256 of the weights that gave the chances; absent without weights.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    weights: Option<String>,
    /// Number of puzzles forgotten before the first in `puzzles`.
    forgotten: u32,
    puzzles: Vec<SavedPuzzle>,
}

#[derive(Serialize, Deserialize)]
struct SavedPuzzle {
    #[serde(flatten)]
    source: PuzzleSource,
    attempts: Vec<Attempt>,
}

impl Memory {
    /// Returns the memory as JSON. `weights` is the SHA-256 of the weights that the memory was learned with.
    pub fn to_json(&self, weights: Option<&str>) -> String {
        let puzzles = self.puzzles.iter().filter(|puzzle| !puzzle.attempts.is_empty());
        let saved = Saved {
            version: FORMAT,
            weights: weights.map(str::to_string),
            forgotten: u32::try_from(self.forgotten).unwrap_or(u32::MAX),
            puzzles: puzzles
                .map(|RememberedPuzzle { source, attempts, .. }| SavedPuzzle {
                    source: source.clone(),
                    attempts: attempts.clone(),
                })
                .collect(),
        };
        serde_json::to_string(&saved).expect("plain data")
    }

    /// Replaces the contents by those of a memory that `to_json` wrote. If it has more than `CAPACITY` attempts, the
    /// oldest puzzles are forgotten.
    ///
    /// # Errors
    ///
    /// If the JSON is damaged, has another format, or was learned with other weights. The memory is then unchanged.
    pub fn read_json(&mut self, json: &[u8], weights: Option<&str>) -> Result<(), MemoryError> {
        let json = utf8(json)?;
        let Head { version } = serde_json::from_str(json).map_err(MemoryError::Json)?;
        if version != FORMAT {
            return Err(MemoryError::Format(version));
        }
        let saved: Saved = serde_json::from_str(json).map_err(MemoryError::Json)?;
        if saved.weights.as_deref() != weights {
            return Err(if saved.weights.is_none() { MemoryError::WithoutWeights } else { MemoryError::Weights });
        }
        if saved.forgotten > MAX_FORGOTTEN {
            return Err(MemoryError::Forgotten(saved.forgotten));
        }
        let forgotten = saved.forgotten as usize;
        let numbered = saved.puzzles.into_iter().zip(forgotten + 1..);
        self.puzzles = numbered.map(|(puzzle, number)| puzzle.check(number)).collect::<Result<_, _>>()?;
        self.forgotten = forgotten;
        self.forget_oldest();
        Ok(())
    }
}

impl SavedPuzzle {
    fn check(self, puzzle: usize) -> Result<RememberedPuzzle, MemoryError> {
        let scene = match &self.source {
            PuzzleSource::Task(id) => Task::load(*id).map_err(|why| MemoryError::Task { puzzle, why })?.scene,
            PuzzleSource::Scene(scene) => {
                scene.check_form().map_err(|why| MemoryError::Scene { puzzle, why })?;
                (**scene).clone()
            }
        };
        for (attempt, Attempt { ball, chance, .. }) in self.attempts.iter().enumerate() {
            let ball = moved_inside(*ball);
            let is_valid = match &self.source {
                PuzzleSource::Task(_) => ball.check(&scene).is_ok(),
                // The scene's numbers were rounded, so a ball that touched a body may now overlap it.
                PuzzleSource::Scene(_) => ball.check_bounds().is_ok(),
            };
            if !is_valid || !(0.0..=1.0).contains(chance) || rounded(*chance, CHANCES) != *chance {
                return Err(MemoryError::Attempt { puzzle, attempt: attempt + 1 });
            }
        }
        Ok(RememberedPuzzle { attempts: self.attempts, ..RememberedPuzzle::new(self.source, &scene) })
    }
}

/// Moves a ball that rounding put just outside the scene back inside.
fn moved_inside(ball: Ball) -> Ball {
    let moved = |place: f64| {
        let inside = place.max(ball.r).min(SIZE - ball.r);
        if (place - inside).abs() <= 2.0 / LENGTHS { inside } else { place }
    };
    Ball { x: moved(ball.x), y: moved(ball.y), r: ball.r }
}

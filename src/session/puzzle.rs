//! A puzzle: a task of the benchmark or a custom scene. The page, the API and the commands accept either.

use serde_json::Value;
use sha2::{Digest, Sha256};

use super::scene_check::checked;
use crate::puzzle::custom_scene::{CustomScene, Problem};
use crate::puzzle::hex::hex;
use crate::puzzle::scene::Scene;
use crate::puzzle::task::{Task, TaskId, goal_sentence, spread};

/// A scene to play, and its identity.
#[derive(Clone, Debug, PartialEq)]
pub struct Puzzle {
    /// The identity of the task or custom scene.
    pub id: PuzzleId,
    /// The source of a custom scene; `None` for a task.
    pub custom: Option<CustomScene>,
    /// The goal sentence.
    pub goal: String,
    /// The bodies and the goal.
    pub scene: Scene,
}

/// The identity of a task or a custom scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PuzzleId {
    /// A task of the benchmark.
    Task(TaskId),
    /// SHA-256 of a custom scene: of its compact JSON without the name, with the keys in the order of the schema.
    Custom([u8; 32]),
}

impl PuzzleId {
    /// Returns the task; `None` for a custom scene.
    pub fn task(self) -> Option<TaskId> {
        match self {
            PuzzleId::Task(task) => Some(task),
            PuzzleId::Custom(_) => None,
        }
    }

    /// Returns the digest of a custom scene in hexadecimal; `None` for a task.
    pub fn digest(self) -> Option<String> {
        match self {
            PuzzleId::Task(_) => None,
            PuzzleId::Custom(digest) => Some(hex(digest)),
        }
    }

    /// Returns the seed of the random draws, given the seed of the whole command or page: see `TaskId::seed`.
    pub fn seed(self, global_seed: u64) -> u64 {
        match self {
            PuzzleId::Task(task) => task.seed(global_seed),
            PuzzleId::Custom(digest) => {
                let first = digest.first_chunk().expect("32 bytes");
                spread(global_seed) ^ u64::from_le_bytes(*first)
            }
        }
    }
}

impl Puzzle {
    /// Checks a custom scene and returns the puzzle.
    ///
    /// # Errors
    ///
    /// The reasons why it cannot be played.
    pub fn custom(custom: &CustomScene) -> Result<Puzzle, Vec<Problem>> {
        let scene = checked(custom)?;
        let nameless = CustomScene { name: None, ..custom.clone() };
        let json = serde_json::to_vec(&nameless).expect("plain data");
        let id = PuzzleId::Custom(Sha256::digest(json).into());
        Ok(Puzzle { id, custom: Some(custom.clone()), goal: goal_sentence(&scene), scene })
    }

    /// Returns the name of a custom scene.
    pub fn name(&self) -> Option<&str> {
        self.custom.as_ref()?.name.as_deref()
    }

    /// Reads a custom scene from JSON and returns the puzzle.
    ///
    /// # Errors
    ///
    /// The reasons why it is not a scene or cannot be played.
    pub fn read(value: Value) -> Result<Puzzle, Vec<Problem>> {
        Puzzle::custom(&CustomScene::read(value)?)
    }
}

impl From<Task> for Puzzle {
    fn from(task: Task) -> Puzzle {
        Puzzle { id: PuzzleId::Task(task.id), custom: None, goal: task.goal, scene: task.scene }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_seed_of_a_custom_scene_depends_on_what_is_played_and_not_on_its_name() {
        let task = Task::load("00000:000".parse().expect("an id")).expect("a task");
        let custom = CustomScene::of(&task.scene).expect("the four shapes");
        let seed = |custom: &CustomScene, seed| Puzzle::custom(custom).expect("a scene").id.seed(seed);
        let named = CustomScene { name: Some("Two drops".to_string()), ..custom.clone() };
        assert_eq!(seed(&custom, 0), seed(&named, 0));
        assert_ne!(seed(&custom, 0), seed(&custom, 1));
        let mut moved = custom.clone();
        moved.bodies[0].x += 1.0;
        assert_ne!(seed(&custom, 0), seed(&moved, 0));
        assert_eq!(Puzzle::custom(&custom).expect("a scene").goal, task.goal);
    }
}

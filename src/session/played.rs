//! What is played: a task of the benchmark or an own scene. The page, the API and the commands take either.

use serde_json::Value;
use sha2::{Digest, Sha256};

use super::scene_check::checked;
use crate::puzzle::own_scene::{OwnScene, Problem};
use crate::puzzle::scene::Scene;
use crate::puzzle::task::{Task, TaskId, goal_sentence, spread};

/// A scene to play, and which it is.
#[derive(Clone, Debug, PartialEq)]
pub struct Played {
    pub id: PlayedId,
    /// What was made, if it is an own scene.
    pub own: Option<OwnScene>,
    /// The goal sentence.
    pub goal: String,
    pub scene: Scene,
}

/// Which task or scene is played.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlayedId {
    Task(TaskId),
    /// SHA-256 of an own scene: of its compact JSON without the name, with the keys in the order of the schema.
    Own([u8; 32]),
}

impl PlayedId {
    /// Returns the task; `None` for an own scene.
    pub fn task(self) -> Option<TaskId> {
        match self {
            PlayedId::Task(task) => Some(task),
            PlayedId::Own(_) => None,
        }
    }

    /// Returns the digest of an own scene in hexadecimal; `None` for a task.
    pub fn digest(self) -> Option<String> {
        match self {
            PlayedId::Task(_) => None,
            PlayedId::Own(digest) => Some(digest.iter().map(|byte| format!("{byte:02x}")).collect()),
        }
    }

    /// Returns the seed of the random draws, given the seed of the whole command or page: see `TaskId::seed`.
    pub fn seed(self, global_seed: u64) -> u64 {
        match self {
            PlayedId::Task(task) => task.seed(global_seed),
            PlayedId::Own(digest) => {
                let first = digest.first_chunk().expect("32 bytes");
                spread(global_seed) ^ u64::from_le_bytes(*first)
            }
        }
    }
}

impl Played {
    /// Returns an own scene to play.
    ///
    /// # Errors
    /// Why it may not be played.
    pub fn own(own: &OwnScene) -> Result<Played, Vec<Problem>> {
        let scene = checked(own)?;
        let nameless = OwnScene { name: None, ..own.clone() };
        let json = serde_json::to_vec(&nameless).expect("plain data");
        let id = PlayedId::Own(Sha256::digest(json).into());
        Ok(Played { id, own: Some(own.clone()), goal: goal_sentence(&scene), scene })
    }

    /// Returns what its maker calls an own scene.
    pub fn name(&self) -> Option<&str> {
        self.own.as_ref()?.name.as_deref()
    }

    /// Reads an own scene to play from JSON.
    ///
    /// # Errors
    /// Why it is no scene or may not be played.
    pub fn read(value: Value) -> Result<Played, Vec<Problem>> {
        Played::own(&OwnScene::read(value)?)
    }
}

impl From<Task> for Played {
    fn from(task: Task) -> Played {
        Played { id: PlayedId::Task(task.id), own: None, goal: task.goal, scene: task.scene }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_seed_of_an_own_scene_depends_on_what_is_played_and_not_on_its_name() {
        let task = Task::load("00000:000".parse().expect("an id")).expect("a task");
        let own = OwnScene::of(&task.scene).expect("the four shapes");
        let seed = |own: &OwnScene, seed| Played::own(own).expect("a scene").id.seed(seed);
        let named = OwnScene { name: Some("Two drops".to_string()), ..own.clone() };
        assert_eq!(seed(&own, 0), seed(&named, 0));
        assert_ne!(seed(&own, 0), seed(&own, 1));
        let mut moved = own.clone();
        moved.bodies[0].x += 1.0;
        assert_ne!(seed(&own, 0), seed(&moved, 0));
        assert_eq!(Played::own(&own).expect("a scene").goal, task.goal);
    }
}

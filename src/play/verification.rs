//! Attempts that anyone can verify: what was played, the ball, and the digest of the whole rollout, one JSON line for each.
//!
//! The page exports such lines and reads them back; `pathlight verify` simulates each again.

use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::played::Played;
use crate::puzzle::action::Ball;
use crate::puzzle::own_scene::sentences;
use crate::puzzle::rollout::{Status, digest_of};
use crate::puzzle::task::{Task, TaskId};
use crate::simulator::{VERSION, simulate};

/// An attempt, and what came of it. Exactly one of `task` and `scene` is there.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AttemptLine {
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub task: Option<TaskId>,
    /// An own scene.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scene: Option<Value>,
    /// px; null if the scene ran without a ball.
    pub ball: Option<Ball>,
    /// The version of the simulator.
    pub simulator: u32,
    pub status: Status,
    /// Simulated steps; 0 if the ball is invalid.
    pub steps: usize,
    /// `Rollout::digest`; that of no poses if the ball is invalid.
    pub digest: String,
}

/// What became of an attempt that was simulated again.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "verdict", content = "reason", rename_all = "snake_case")]
pub enum Verdict {
    /// Status, steps and every bit of every pose.
    Same,
    /// In which it differs.
    OtherOutcome(String),
    /// Why it cannot be simulated.
    NotValid(String),
}

impl AttemptLine {
    /// Simulates a task or an own scene, and returns the line of it.
    ///
    /// # Errors
    /// Why it cannot be played, in a sentence.
    pub fn simulated(task: Option<TaskId>, scene: Option<Value>, ball: Option<Ball>) -> Result<AttemptLine, String> {
        let played = match (task, scene.clone()) {
            (Some(task), None) => Task::load(task).map(Played::from).map_err(|why| why.to_string())?,
            (None, Some(scene)) => Played::read(scene).map_err(|problems| sentences(&problems))?,
            _ => return Err("An attempt names either a `task` or a `scene`: write one of them.".to_string()),
        };
        let (status, steps, digest) = match simulate(&played.scene, ball) {
            Ok(rollout) => (rollout.status(), rollout.steps, rollout.digest()),
            Err(_) => (Status::Invalid, 0, digest_of(&[])),
        };
        Ok(AttemptLine { task, scene, ball, simulator: VERSION, status, steps, digest })
    }

    /// Simulates the attempt again and compares.
    pub fn verify(&self) -> Verdict {
        let again = match AttemptLine::simulated(self.task, self.scene.clone(), self.ball) {
            Ok(again) => again,
            Err(why) => return Verdict::NotValid(why),
        };
        if again.status == Status::Invalid && self.status != Status::Invalid {
            return Verdict::NotValid("The ball may not be placed there.".to_string());
        }
        let version = match self.simulator {
            VERSION => String::new(),
            other => format!(" It was made by version {other} of the simulator, and this is version {VERSION}."),
        };
        let name = |status| match status {
            Status::Solved => "solved",
            Status::NotSolved => "not solved",
            Status::Invalid => "invalid",
        };
        if (again.status, again.steps) != (self.status, self.steps) {
            let [said, found] = [self, &again].map(|line| format!("{} after {} steps", name(line.status), line.steps));
            return Verdict::OtherOutcome(format!("The line says {said}, but it is {found}.{version}"));
        }
        if again.digest != self.digest {
            return Verdict::OtherOutcome(format!("The outcome is the same, but the poses differ.{version}"));
        }
        Verdict::Same
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::own_scene::OwnScene;

    fn line() -> AttemptLine {
        let task = "00000:000".parse().expect("an id");
        AttemptLine::simulated(Some(task), None, Some(Ball { x: 128.0, y: 250.0, r: 4.0 })).expect("a task")
    }

    #[test]
    fn an_attempt_is_the_same_until_a_part_of_it_changes() {
        assert_eq!(line().verify(), Verdict::Same);
        let other = |line: AttemptLine| matches!(line.verify(), Verdict::OtherOutcome(_));
        assert!(other(AttemptLine { steps: 3, ..line() }));
        assert!(other(AttemptLine { status: Status::Solved, ..line() }));
        assert!(other(AttemptLine { digest: "0".repeat(64), ..line() }));
        assert!(other(AttemptLine { ball: Some(Ball { x: 129.0, y: 250.0, r: 4.0 }), ..line() }));
        let outside = Some(Ball { x: 1.0, y: 250.0, r: 4.0 });
        assert!(matches!(AttemptLine { ball: outside, ..line() }.verify(), Verdict::NotValid(_)));
        assert!(matches!(AttemptLine { task: None, ..line() }.verify(), Verdict::NotValid(_)));
    }

    #[test]
    fn an_own_scene_is_verified_like_its_task() {
        let task = Task::load(line().task.expect("a task")).expect("a task");
        let own = serde_json::to_value(OwnScene::of(&task.scene).expect("the four shapes")).expect("plain data");
        let own = AttemptLine::simulated(None, Some(own), line().ball).expect("a scene");
        assert_eq!((&own.digest, own.verify()), (&line().digest, Verdict::Same));
        assert!(matches!(AttemptLine { scene: Some(Value::Null), ..own }.verify(), Verdict::NotValid(_)));
    }

    #[test]
    fn a_digest_is_that_of_the_bytes() {
        // SHA-256 of nothing, and of 00 00 80 3f 00 00 00 00 00 00 00 80.
        assert_eq!(digest_of(&[]), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
        assert_eq!(digest_of(&[[1.0, 0.0, -0.0]]), "fda6afb17305e3f22d8b12a768b492354e971796f0496516bc2a54d5a05e4432");
    }
}

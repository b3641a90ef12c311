//! Attempts that anyone can verify: the puzzle, the ball, and the digest of the whole rollout, one JSON line each.
//!
//! The page exports such lines and reads them back; `pathlight verify` simulates each again.

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::puzzle::action::Ball;
use crate::puzzle::custom_scene::sentences;
use crate::puzzle::rollout::Status;
use crate::puzzle::task::{Task, TaskId};
use crate::session::puzzle::Puzzle;
use crate::simulator::{Digest, Engine};

/// An attempt and its outcome. Exactly one of `task` and `scene` is present.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct AttemptLine {
    /// A task of the benchmark.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub task: Option<TaskId>,
    /// A custom scene.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub scene: Option<Value>,
    /// px; null if the scene ran without a ball, or, with the status `invalid`, if an action placed none.
    pub ball: Option<Ball>,
    /// The engine that simulated it; absent if that is `box2d`.
    #[serde(default, skip_serializing_if = "Engine::is_first")]
    pub engine: Engine,
    /// The version of the engine.
    pub simulator: u32,
    /// The status of the attempt.
    pub status: Status,
    /// Number of simulated steps; 0 if the ball is invalid.
    pub steps: usize,
    /// `simulator::Digest` of the rollout; if the ball is invalid, the digest of no steps.
    pub digest: String,
}

/// The result of simulating an attempt again. Each `reason` is a sentence.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "verdict", rename_all = "snake_case")]
#[allow(missing_docs, reason = "the fields are those of `AttemptLine`, as they are now")]
pub enum Verdict {
    /// Status, steps and every bit of every pose are the same.
    Same,
    /// Status, steps or poses differ; these are the new ones.
    OtherOutcome { status: Status, steps: usize, reason: String },
    /// The attempt cannot be simulated, for this reason.
    NotValid { fault: LineFault, reason: String },
}

/// The kind of fault of an attempt that cannot be simulated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LineFault {
    /// It does not have the form of an attempt.
    Form,
    /// Its task or scene cannot be simulated.
    Puzzle,
    /// Its ball is invalid.
    Ball,
}

impl Verdict {
    /// Returns the verdict for an attempt that cannot be simulated.
    pub fn not_valid(fault: LineFault, reason: impl Into<String>) -> Verdict {
        Verdict::NotValid { fault, reason: reason.into() }
    }
}

impl AttemptLine {
    /// Simulates a ball, or the scene alone without one, and returns the attempt.
    pub fn of(puzzle: &Puzzle, ball: Option<Ball>, engine: Engine) -> AttemptLine {
        let nothing = AttemptLine { ball, ..AttemptLine::placing_no_ball(puzzle, engine) };
        match engine.digest(&puzzle.scene, ball) {
            Ok((outcome, digest)) => {
                let status = if outcome.solved { Status::Solved } else { Status::NotSolved };
                AttemptLine { status, steps: outcome.steps, digest: digest.to_string(), ..nothing }
            }
            Err(_) => nothing,
        }
    }

    /// Returns the attempt for an action that places no ball.
    pub fn placing_no_ball(puzzle: &Puzzle, engine: Engine) -> AttemptLine {
        AttemptLine {
            task: puzzle.id.task(),
            scene: puzzle.custom.as_ref().map(|custom| serde_json::to_value(custom).expect("plain data")),
            ball: None,
            engine,
            simulator: engine.version(),
            status: Status::Invalid,
            steps: 0,
            digest: Digest::default().to_string(),
        }
    }

    /// Returns the puzzle of the attempt.
    ///
    /// # Errors
    ///
    /// The reason why it cannot be played, as a sentence.
    fn puzzle(&self) -> Result<Puzzle, String> {
        match (self.task, &self.scene) {
            (Some(task), None) => Task::load(task).map(Puzzle::from).map_err(|why| why.to_string()),
            (None, Some(scene)) => Puzzle::read(scene.clone()).map_err(|problems| sentences(&problems)),
            _ => Err("An attempt names either a `task` or a `scene`: write one of them.".to_string()),
        }
    }

    /// Simulates the attempt again and compares the results.
    ///
    /// ```
    /// use pathlight::puzzle::{action::Ball, task::Task};
    /// use pathlight::verification::{AttemptLine, Verdict};
    ///
    /// let puzzle = Task::load("00007:008".parse()?)?.into();
    /// let line = AttemptLine::of(&puzzle, Some(Ball { x: 178.0, y: 218.0, r: 19.0 }), Default::default());
    /// assert!(matches!(line.verify(), Verdict::Same));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn verify(&self) -> Verdict {
        let is_digest =
            || self.digest.len() == 16 && self.digest.bytes().all(|byte| matches!(byte, b'0'..=b'9' | b'a'..=b'f'));
        // Other versions may have written digests of another form.
        if self.simulator == self.engine.version() && !is_digest() {
            let reason = "`digest` is not valid: a digest has 16 lowercase hexadecimal digits.";
            return Verdict::not_valid(LineFault::Form, reason);
        }
        let again = match (self.puzzle(), self.ball, self.status) {
            (Err(why), ..) => return Verdict::not_valid(LineFault::Puzzle, why),
            (Ok(puzzle), None, Status::Invalid) => AttemptLine::placing_no_ball(&puzzle, self.engine),
            (Ok(puzzle), ball, _) => AttemptLine::of(&puzzle, ball, self.engine),
        };
        if again.status == Status::Invalid && self.status != Status::Invalid {
            return Verdict::not_valid(LineFault::Ball, "The ball is not valid there.");
        }
        let version = match (self.simulator, again.simulator) {
            (one, other) if one == other => String::new(),
            (one, other) => format!(" It was made by version {one} of the simulator, and this is version {other}."),
        };
        let name = |status| match status {
            Status::Solved => "solved",
            Status::NotSolved => "not solved",
            Status::Invalid => "invalid",
        };
        let AttemptLine { status, steps, .. } = again;
        if (status, steps) != (self.status, self.steps) {
            let [said, found] = [self, &again].map(|line| format!("{} after {} steps", name(line.status), line.steps));
            let reason = format!("The line says {said}, but it is {found}.{version}");
            return Verdict::OtherOutcome { status, steps, reason };
        }
        if again.digest != self.digest {
            let reason = format!("The outcome is the same, but the poses differ.{version}");
            return Verdict::OtherOutcome { status, steps, reason };
        }
        Verdict::Same
    }
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;
    use crate::puzzle::custom_scene::CustomScene;

    fn line() -> AttemptLine {
        in_engine(Engine::default())
    }

    fn in_engine(engine: Engine) -> AttemptLine {
        let task = Task::load("00000:000".parse().expect("an id")).expect("a task");
        AttemptLine::of(&task.into(), Some(Ball { x: 128.0, y: 250.0, r: 4.0 }), engine)
    }

    #[test]
    fn an_attempt_is_the_same_until_a_part_of_it_changes() {
        assert_eq!(line().verify(), Verdict::Same);
        let other = |line: AttemptLine| matches!(line.verify(), Verdict::OtherOutcome { .. });
        assert!(other(AttemptLine { steps: 3, ..line() }));
        assert!(other(AttemptLine { status: Status::Solved, ..line() }));
        assert!(other(AttemptLine { digest: "0".repeat(16), ..line() }));
        assert!(other(AttemptLine { ball: Some(Ball { x: 129.0, y: 250.0, r: 4.0 }), ..line() }));
        for digest in ["A".repeat(16), line().digest[1..].to_string(), "g".repeat(16), "é".repeat(8)] {
            let verdict = AttemptLine { digest, ..line() }.verify();
            assert!(
                matches!(&verdict, Verdict::NotValid { reason, .. } if reason.contains("16 lowercase hexadecimal digits")),
                "{verdict:?}"
            );
        }
        let outside = Some(Ball { x: 1.0, y: 250.0, r: 4.0 });
        assert!(matches!(AttemptLine { ball: outside, ..line() }.verify(), Verdict::NotValid { .. }));
        assert!(matches!(AttemptLine { task: None, ..line() }.verify(), Verdict::NotValid { .. }));
    }

    #[test]
    fn a_custom_scene_is_verified_like_its_task() {
        let task = Task::load(line().task.expect("a task")).expect("a task");
        let custom = Puzzle::custom(&CustomScene::of(&task.scene).expect("the four shapes")).expect("a scene");
        let custom = AttemptLine::of(&custom, line().ball, Engine::default());
        assert_eq!((&custom.digest, custom.verify()), (&line().digest, Verdict::Same));
        assert!(matches!(AttemptLine { scene: Some(Value::Null), ..custom }.verify(), Verdict::NotValid { .. }));
    }

    #[test]
    fn an_action_that_places_no_ball_is_verified_as_nothing_simulated() {
        let puzzle = line().puzzle().expect("a task");
        let nothing = AttemptLine::placing_no_ball(&puzzle, Engine::default());
        assert_eq!((nothing.verify(), nothing.steps), (Verdict::Same, 0));
        let alone = AttemptLine::of(&puzzle, None, Engine::default());
        assert_eq!(alone.verify(), Verdict::Same);
        for claim in [AttemptLine { steps: 3, ..nothing.clone() }, AttemptLine { digest: alone.digest, ..nothing }] {
            assert!(matches!(claim.verify(), Verdict::OtherOutcome { .. }));
        }
    }

    #[test]
    fn the_other_engine_is_named_and_verified_by_itself() {
        let (first, second) = (line(), in_engine(Engine::Rapier));
        assert_eq!(second.verify(), Verdict::Same);
        assert_ne!(first.digest, second.digest);
        assert!(matches!(
            AttemptLine { engine: Engine::Box2d, ..second.clone() }.verify(),
            Verdict::OtherOutcome { .. }
        ));
        let [first, second] = [first, second].map(|line| serde_json::to_value(line).expect("plain data"));
        assert_eq!((first.get("engine"), &second["engine"]), (None, &Value::from("rapier")));
    }

    #[test]
    fn an_attempt_of_another_version_says_so() {
        let older = AttemptLine { simulator: 3, digest: "0".repeat(64), ..line() };
        let Verdict::OtherOutcome { reason, .. } = older.verify() else { panic!("its digest was another one") };
        assert!(reason.contains("made by version 3 of the simulator, and this is version"), "{reason}");
    }
}

//! `pathlight simulate`: the outcome of a ball in a task or a custom scene, for one ball or for a file of them.
//!
//! Both modes print the same JSON line: task, action if given, ball in px, status, reason if invalid, and steps. A
//! batch puts the line number first.

use std::io::{self, Write};
use std::path::PathBuf;

use anyhow::ensure;
use clap::ArgGroup;
use pathlight::command_line::engine_arg::EngineArg;
use pathlight::puzzle::action::{Action, Ball, Invalid};
use pathlight::puzzle::recorded_paths::RecordedPaths;
use pathlight::puzzle::rollout::{Pose, Rollout, Status};
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::search::luck::{Luck, luck};
use pathlight::session::puzzle::Puzzle;
use pathlight::simulator::{Engine, Outcome};
use pathlight::verification::AttemptLine;
use serde::{Serialize, Serializer};

use super::custom_scene_file;

mod batch;
mod start;

use start::Start;

/// Simulate one ball in a task, or a batch of balls, and print the outcome as JSON
#[derive(clap::Args)]
#[command(group(ArgGroup::new("what").args(["task", "scene", "batch"]).required(true)))]
pub struct Args {
    /// Simulate this task, like 00007:008; without --action or --ball, simulate without a ball
    #[arg(long)]
    task: Option<TaskId>,

    /// Simulate the custom scene in this file ("-" is standard input), JSON as described by `tasks --schema`
    #[arg(long, value_name = "FILE")]
    scene: Option<PathBuf>,

    /// Place the ball by an action: three numbers from 0 to 1
    #[arg(long, value_name = "x,y,r", value_parser = start::parse_action, allow_hyphen_values = true, conflicts_with = "ball")]
    action: Option<Action>,

    /// Place the ball here: three whole numbers, px
    #[arg(long, value_name = "X,Y,R", value_parser = start::parse_ball, allow_hyphen_values = true)]
    ball: Option<Ball>,

    /// Also print the pose of every moving body at every step
    #[arg(long)]
    poses: bool,

    /// Also print the poses of the green object and of the ball at every tenth step, if there is a ball, for an agent
    /// that observes its attempts
    #[arg(long)]
    paths: bool,

    /// Print lines that `verify` can simulate again, including the digest of all poses
    #[arg(long, conflicts_with_all = ["poses", "paths"])]
    verifiable: bool,

    /// Also print how many of the 27 balls within a pixel in x, y and radius are valid and how many of these solve, and
    /// whether the ball itself solves with --engine rapier
    #[arg(long, conflicts_with_all = ["verifiable", "batch", "engine"])]
    luck: bool,

    /// Simulate each line of this file ("-" is standard input) on all cores
    ///
    /// A line is {"task":"00007:008","ball":[X,Y,R]}. "scene":{…} gives a custom scene instead of the task, and
    /// "action":[x,y,r] an action instead of the ball; "ball":null simulates without a ball. Each line that is not
    /// blank is answered, in order, with the outcome and "line", its number; with --verifiable, without the number. A
    /// line that cannot be used is answered with {"line","error"} and named on standard error; if there was one, the
    /// exit code is 2.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["task", "scene", "action", "ball", "poses"])]
    batch: Option<PathBuf>,

    #[command(flatten)]
    engine: EngineArg,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let is_placed = self.action.is_some() || self.ball.is_some();
        ensure!(is_placed || !self.luck, "--luck needs a ball: place one with --ball or --action");
        let start = match self.action {
            Some(action) => Start::Action(action),
            None => Start::Ball(self.ball),
        };
        let EngineArg { engine } = self.engine;
        if let Some(file) = self.batch {
            let format = if self.verifiable { Format::Verifiable } else { Format::Answer { paths: self.paths } };
            return batch::run(&file, format, engine);
        }
        let puzzle = match (self.scene, self.task) {
            (Some(file), _) => custom_scene_file::read(&file)?,
            (None, task) => Task::load(task.expect("clap requires a task, a scene or a batch"))?.into(),
        };
        let ball = start.place(&puzzle.scene);
        let line = if self.verifiable {
            serde_json::to_string(&attempt_line(&puzzle, ball, engine))
        } else {
            let rollout = ball.and_then(|ball| engine.simulate(&puzzle.scene, ball));
            let placed = ball.ok().flatten();
            let answer = Answer::of_rollout(&puzzle, start, placed, &rollout, engine, self.paths);
            let luck = placed.filter(|_| self.luck).map(|ball| luck(&puzzle.scene, ball));
            let poses = rollout.as_ref().ok().filter(|_| self.poses).map(Poses::of);
            serde_json::to_string(&ResultLine { answer, luck, poses })
        };
        Ok(writeln!(io::stdout(), "{}", line?)?)
    }
}

/// The format of a batch's answers.
#[derive(Clone, Copy)]
enum Format {
    Answer { paths: bool },
    Verifiable,
}

/// Returns the line of an attempt for `verify` to simulate again.
fn attempt_line(puzzle: &Puzzle, ball: Result<Option<Ball>, Invalid>, engine: Engine) -> AttemptLine {
    match ball {
        Ok(ball) => AttemptLine::of(puzzle, ball, engine),
        Err(_) => AttemptLine::placing_no_ball(puzzle, engine),
    }
}

/// The outcome of one ball.
#[derive(Serialize)]
struct Answer {
    /// Absent for a custom scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    task: Option<TaskId>,
    /// Absent unless an action was given.
    #[serde(skip_serializing_if = "Option::is_none")]
    action: Option<Action>,
    /// px; null if there is no ball: none was given, or the action places none.
    #[serde(serialize_with = "whole_numbers")]
    ball: Option<Ball>,
    /// Absent if it is `box2d`.
    #[serde(skip_serializing_if = "Engine::is_first")]
    engine: Engine,
    status: Status,
    /// Why the ball is invalid.
    reason: Option<String>,
    /// Steps simulated; 0 if invalid.
    steps: usize,
    /// The paths, if requested and if there is a ball.
    #[serde(skip_serializing_if = "Option::is_none")]
    paths: Option<RecordedPaths>,
}

impl Answer {
    fn of_rollout(
        puzzle: &Puzzle,
        start: Start,
        ball: Option<Ball>,
        rollout: &Result<Rollout, Invalid>,
        engine: Engine,
        with_paths: bool,
    ) -> Answer {
        let outcome = rollout.as_ref().map(|rollout| Outcome { solved: rollout.solved, steps: rollout.steps });
        let simulated = rollout.as_ref().ok().filter(|_| with_paths);
        let paths = simulated.and_then(|rollout| RecordedPaths::of(rollout, &puzzle.scene));
        Answer { paths, ..Answer::new(puzzle.id.task(), start, ball, engine, outcome.map_err(|invalid| *invalid)) }
    }

    fn new(
        task: Option<TaskId>,
        start: Start,
        ball: Option<Ball>,
        engine: Engine,
        outcome: Result<Outcome, Invalid>,
    ) -> Answer {
        let (status, reason, steps) = match outcome {
            Ok(Outcome { solved: true, steps }) => (Status::Solved, None, steps),
            Ok(Outcome { solved: false, steps }) => (Status::NotSolved, None, steps),
            Err(invalid) => (Status::Invalid, Some(invalid.to_string()), 0),
        };
        Answer { task, action: start.action(), ball, engine, status, reason, steps, paths: None }
    }
}

/// Writes a ball of whole px as integers.
pub(super) fn whole_numbers<S: Serializer>(ball: &Option<Ball>, serializer: S) -> Result<S::Ok, S::Error> {
    ball.map(|ball| <[f64; 3]>::from(ball).map(|number| number as i32)).serialize(serializer)
}

/// An answer and, if requested, its luck and its rollout.
#[derive(Serialize)]
struct ResultLine<'a> {
    #[serde(flatten)]
    answer: Answer,
    #[serde(skip_serializing_if = "Option::is_none")]
    luck: Option<Luck>,
    #[serde(flatten)]
    poses: Option<Poses<'a>>,
}

/// A `pathlight::puzzle::rollout::Rollout` with one row of poses per step.
#[derive(Serialize)]
struct Poses<'a> {
    bodies: &'a [usize],
    poses: Vec<&'a [Pose]>,
    touching: &'a [bool],
}

impl Poses<'_> {
    fn of(rollout: &Rollout) -> Poses<'_> {
        let poses = (0..=rollout.steps).map(|step| rollout.row(step)).collect();
        Poses { bodies: &rollout.bodies, poses, touching: &rollout.touching }
    }
}

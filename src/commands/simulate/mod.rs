//! `pathlight simulate`: the outcome of a ball in a task, for one ball or for a file of them.
//!
//! Both ways print the same JSON line: task, ball in px, status, reason if it is invalid, and steps.

use std::io::{self, Write};
use std::path::PathBuf;

use clap::ArgGroup;
use pathlight::play::played::Played;
use pathlight::play::verification::AttemptLine;
use pathlight::puzzle::action::{Action, Ball, Invalid};
use pathlight::puzzle::recorded_paths::RecordedPaths;
use pathlight::puzzle::rollout::{Pose, Rollout, Status};
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::simulator::{Outcome, simulate};
use serde::{Serialize, Serializer};
use serde_json::Value;

use super::own_scene_file;

mod batch;
mod start;

use start::Start;

/// Simulate one ball in a task, or a batch of them, and print the outcome as JSON
#[derive(clap::Args)]
#[command(group(ArgGroup::new("what").args(["task", "scene", "batch"]).required(true)))]
pub struct Args {
    /// Simulate this task, like 00007:008; with neither --action nor --ball, without a ball
    #[arg(long)]
    task: Option<TaskId>,

    /// Simulate the own scene of this file, JSON as `tasks --schema` describes it
    #[arg(long, value_name = "FILE")]
    scene: Option<PathBuf>,

    /// Place the ball by an action: three numbers in 0..1
    #[arg(long, value_name = "x,y,r", value_parser = start::parse_action, allow_hyphen_values = true, conflicts_with = "ball")]
    action: Option<Action>,

    /// Place the ball here: three whole numbers, px
    #[arg(long, value_name = "X,Y,R", value_parser = start::parse_ball, allow_hyphen_values = true)]
    ball: Option<Ball>,

    /// Also print the pose of every moving body at every step
    #[arg(long)]
    poses: bool,

    /// Also print the poses of the green object and of the ball at every tenth step, for an agent that observes its
    /// attempts; without a ball there are none
    #[arg(long)]
    paths: bool,

    /// Print lines that `verify` simulates again, with the digest of all poses
    #[arg(long, conflicts_with_all = ["poses", "paths"])]
    verifiable: bool,

    /// Simulate each line of this file ("-" is standard input) on all cores: {"task":"00007:008","ball":[X,Y,R]},
    /// with "action":[x,y,r] instead of "ball", or with "ball":null for no ball
    #[arg(long, value_name = "FILE", conflicts_with_all = ["task", "scene", "action", "ball", "poses"])]
    batch: Option<String>,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let start = match self.action {
            Some(action) => Start::Action(action),
            None => Start::Ball(self.ball),
        };
        if let Some(file) = self.batch {
            return batch::run(
                &file,
                if self.verifiable { Format::Verifiable } else { Format::Answer { paths: self.paths } },
            );
        }
        let (scene, played) = match (self.scene, self.task) {
            (Some(file), _) => own_scene_file::read(&file).map(|(scene, played)| (Some(scene), played))?,
            (None, task) => (None, Task::load(task.expect("clap requires a task, a scene or a batch"))?.into()),
        };
        if self.verifiable {
            return verifiable(&played, scene, start);
        }
        one(&played, start, self.paths, self.poses)
    }
}

/// What a batch answers with.
#[derive(Clone, Copy)]
enum Format {
    Answer { paths: bool },
    Verifiable,
}

/// Prints the line of an attempt that `verify` simulates again.
fn verifiable(played: &Played, scene: Option<Value>, start: Start) -> anyhow::Result<()> {
    let ball = start.place(&played.scene)?;
    let line = AttemptLine::simulated(played.id.task(), scene, ball).map_err(anyhow::Error::msg)?;
    Ok(writeln!(io::stdout(), "{}", serde_json::to_string(&line)?)?)
}

fn one(played: &Played, start: Start, with_paths: bool, with_poses: bool) -> anyhow::Result<()> {
    let ball = start.place(&played.scene);
    let rollout = ball.and_then(|ball| simulate(&played.scene, ball));
    let answer = Answer::of_rollout(played, ball.ok().flatten(), &rollout, with_paths);
    let poses = rollout.as_ref().ok().filter(|_| with_poses).map(Poses::of);
    Ok(writeln!(io::stdout(), "{}", serde_json::to_string(&ResultLine { answer, poses })?)?)
}

/// The outcome of one ball.
#[derive(Serialize)]
struct Answer {
    /// Absent for an own scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    task: Option<TaskId>,
    /// px; null if there is none: none was asked for, or the action places none.
    #[serde(serialize_with = "whole_numbers")]
    ball: Option<Ball>,
    status: Status,
    /// Why it is invalid.
    reason: Option<String>,
    /// Steps simulated; 0 if invalid.
    steps: usize,
    /// What happened, if it was asked for and there is a ball.
    #[serde(skip_serializing_if = "Option::is_none")]
    paths: Option<RecordedPaths>,
}

impl Answer {
    fn of_rollout(played: &Played, ball: Option<Ball>, rollout: &Result<Rollout, Invalid>, with_paths: bool) -> Answer {
        let outcome = rollout.as_ref().map(|rollout| Outcome { solved: rollout.solved, steps: rollout.steps });
        let simulated = rollout.as_ref().ok().filter(|_| with_paths);
        let paths = simulated.and_then(|rollout| RecordedPaths::of(rollout, &played.scene));
        Answer { paths, ..Answer::new(played.id.task(), ball, outcome.map_err(|invalid| *invalid)) }
    }

    fn new(task: Option<TaskId>, ball: Option<Ball>, outcome: Result<Outcome, Invalid>) -> Answer {
        let (status, reason, steps) = match outcome {
            Ok(Outcome { solved: true, steps }) => (Status::Solved, None, steps),
            Ok(Outcome { solved: false, steps }) => (Status::NotSolved, None, steps),
            Err(invalid) => (Status::Invalid, Some(invalid.to_string()), 0),
        };
        Answer { task, ball, status, reason, steps, paths: None }
    }
}

/// Writes a ball of whole px as integers.
pub(super) fn whole_numbers<S: Serializer>(ball: &Option<Ball>, serializer: S) -> Result<S::Ok, S::Error> {
    ball.map(|ball| <[f64; 3]>::from(ball).map(|number| number as i32)).serialize(serializer)
}

/// An answer and, if asked for, its rollout.
#[derive(Serialize)]
struct ResultLine<'a> {
    #[serde(flatten)]
    answer: Answer,
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

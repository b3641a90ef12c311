//! `pathlight agent`: an agent that plays against any simulator, over JSON lines. `simulate --batch - --paths` is the
//! other side: it reads the agent's lines and writes the lines that the agent reads.
//!
//! `json_lines` has the protocol. A line that cannot be used changes nothing.

use std::io::{self, Write};

use anyhow::ensure;
use pathlight::agents::agent_name::{AgentName, Loaded};
use pathlight::agents::{Agent, Observation};
use pathlight::benchmark::auccess::MAX_ATTEMPTS;
use pathlight::nets::{Dqn, PathNet};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::rollout::Status;
use pathlight::puzzle::sampled_paths::SampledPaths;
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::{Task, TaskId};
use serde::Serialize;

use super::agent_arg::agent;
use super::fold_args::FoldArgs;
use super::json_lines::{Lines, Numbered, Refusal};
use super::model_args::{DqnArgs, ModelArgs};
use super::simulate::whole_numbers;
use lines::{Line, MAX_LINE};

mod lines;

/// Balls that an agent has ready for one puzzle: another simulator may find some of them invalid, which are no
/// attempts.
const BALLS: usize = 2 * MAX_ATTEMPTS;

/// Play against any simulator: read tasks and outcomes as JSON lines, and answer each with the next ball
///
/// {"task":"00007:008"} begins a puzzle. So does {"scene":{…}}, with a scene as `tasks --json` or `tasks --custom`
/// prints it. The answer is {"line","task","ball":[x,y,r]}: the number of the line, and the first ball in px.
///
/// {"status":"solved"}, "not_solved" or "invalid" is the outcome of that ball. The line may also have
/// "paths":{"object":[[x,y,angle],…],"ball":[…]}, the poses of the green object and of the ball at the start and at
/// every tenth step, in px and radians. The answer is the next ball, or "ball":null once the puzzle is solved, 100
/// attempts are made or no ball is left.
///
/// A line that cannot be used changes nothing and is answered with {"line","error"}; if there was one, the exit code is
/// 2. Blank lines are not answered.
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    fold: FoldArgs,

    /// Agent that plays [default: online; from weights without a dynamics net success, without a success net paper]
    #[arg(long, value_parser = agent())]
    agent: Option<AgentName>,

    /// Seed of all random draws
    #[arg(long, default_value_t = 0)]
    seed: u64,

    #[command(flatten)]
    model: ModelArgs,

    #[command(flatten)]
    dqn: DqnArgs,
}

/// The answer to a line.
#[derive(Serialize)]
struct Answer {
    /// Absent if the puzzle was given as a scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    task: Option<TaskId>,
    /// Null if there is nothing more to try.
    #[serde(serialize_with = "whole_numbers")]
    ball: Option<Ball>,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let fold = self.fold.into();
        let (agent, nets, dqn) = if self.agent == Some(AgentName::Random) {
            (AgentName::Random, None, None)
        } else if self.agent == Some(AgentName::Dqn) {
            (AgentName::Dqn, None, Some(self.dqn.load(fold)?))
        } else {
            let nets = self.model.load(fold)?;
            let default = match (&nets.dynamics, &nets.success) {
                (Some(_), _) => AgentName::Online,
                (None, Some(_)) => AgentName::Success,
                (None, None) => AgentName::Paper,
            };
            let agent = self.agent.unwrap_or(default);
            agent.check(&nets)?;
            (agent, Some(nets), None)
        };
        let mut player = Player { agent, nets, dqn, seed: self.seed, puzzle: None };
        let mut out = io::stdout().lock();
        let mut refused = 0;
        for read in Lines::new(io::stdin().lock(), MAX_LINE) {
            let read = read?;
            if read.is_blank() {
                continue;
            }
            let line = read.number;
            match read.text.and_then(|text| player.answer(Line::parse(&text)?)) {
                Ok(answer) => serde_json::to_writer(&mut out, &Numbered { line, answer })?,
                Err(error) => {
                    refused += 1;
                    serde_json::to_writer(&mut out, &Numbered { line, answer: Refusal::from(&error) })?;
                }
            }
            writeln!(out)?;
            out.flush()?;
        }
        ensure!(
            refused == 0,
            "{refused} line{} could not be used; the answers say why",
            if refused == 1 { "" } else { "s" }
        );
        Ok(())
    }
}

/// The agent, and the puzzle that it is at work on.
struct Player {
    agent: AgentName,
    nets: Option<PathNet>,
    dqn: Option<Dqn>,
    seed: u64,
    puzzle: Option<OpenPuzzle>,
}

struct OpenPuzzle {
    task: Option<TaskId>,
    agent: Box<dyn Agent>,
    /// The ball whose outcome is awaited.
    ball: Option<Ball>,
    /// Attempts made; invalid balls are none.
    used: usize,
}

impl Player {
    fn answer(&mut self, line: Line) -> anyhow::Result<Answer> {
        let puzzle = match line {
            Line::Task(id) => self.begin(Some(id), id.seed(self.seed), &Task::load(id)?.scene),
            Line::Scene(scene) => self.begin(None, self.seed, &scene),
            Line::Custom(puzzle) => self.begin(None, puzzle.id.seed(self.seed), &puzzle.scene),
            Line::Outcome { task, ball, status, paths } => {
                let Some(OpenPuzzle { task: own, ball: Some(asked), .. }) = &self.puzzle else {
                    anyhow::bail!("no ball is waiting for its outcome: begin a puzzle with {{\"task\":\"00007:008\"}}");
                };
                ensure!(task.is_none() || task == *own, "this is the outcome of another task");
                ensure!(
                    ball.is_none_or(|ball| ball == *asked),
                    "this is the outcome of another ball: the one that waits is {asked}"
                );
                let puzzle = self.puzzle.as_mut().expect("looked at above");
                puzzle.observe(status, paths.map(|paths| *paths));
                puzzle
            }
        };
        Ok(Answer { task: puzzle.task, ball: puzzle.ball })
    }

    fn begin(&mut self, task: Option<TaskId>, seed: u64, scene: &Scene) -> &OpenPuzzle {
        let loaded = Loaded { nets: self.nets.as_ref(), dqn: self.dqn.as_ref() };
        let agent = self.agent.start(loaded, scene, seed, BALLS);
        let mut puzzle = OpenPuzzle { task, agent, ball: None, used: 0 };
        puzzle.propose();
        self.puzzle.insert(puzzle)
    }
}

impl OpenPuzzle {
    /// Takes the outcome of the ball that is waiting for it, and proposes the next.
    fn observe(&mut self, status: Status, paths: Option<SampledPaths>) {
        if status != Status::Invalid {
            self.agent.observe(&Observation { solved: status == Status::Solved, paths });
            self.used += 1;
        }
        self.ball = None;
        if status != Status::Solved {
            self.propose();
        }
    }

    fn propose(&mut self) {
        if self.used < MAX_ATTEMPTS {
            self.ball = self.agent.propose().map(|proposal| proposal.ball);
        }
    }
}

//! Answers the lines: the agent, the puzzle that it is working on, and its memory of earlier puzzles.

use anyhow::ensure;
use pathlight::agents::agent_name::{AgentName, Loaded};
use pathlight::agents::memory::{Memory, PuzzleSource, Recollection, Reminder};
use pathlight::agents::{Agent, Observation, Proposal};
use pathlight::benchmark::auccess::MAX_ATTEMPTS;
use pathlight::nets::{Dqn, PathNet};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::rollout::Status;
use pathlight::puzzle::sampled_paths::SampledPaths;
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::{Task, TaskId};
use serde::Serialize;

use super::super::simulate::whole_numbers;
use super::lines::{Begun, Line};

/// Number of balls that an agent prepares for one puzzle. Another simulator may find some of them invalid, and those
/// are not attempts.
const BALLS: usize = 2 * MAX_ATTEMPTS;

/// The answer to a line.
#[derive(Serialize)]
#[serde(untagged)]
pub enum Answer {
    Ball {
        /// Absent if the puzzle was given as a scene.
        #[serde(skip_serializing_if = "Option::is_none")]
        task: Option<TaskId>,
        /// Null if no ball is left to try.
        #[serde(serialize_with = "whole_numbers")]
        ball: Option<Ball>,
        /// The remembered puzzle that changed the chance of the ball most, if the change is noticeable.
        #[serde(skip_serializing_if = "Option::is_none")]
        reminder: Option<Reminder>,
    },
    Forgot {
        /// Number of remembered attempts.
        remembered: usize,
    },
}

impl Answer {
    /// Returns whether the puzzle is over, or everything was forgotten.
    pub fn ends_puzzle(&self) -> bool {
        matches!(self, Answer::Ball { ball: None, .. } | Answer::Forgot { .. })
    }
}

/// The agent, and the puzzle that it is working on.
pub struct Player {
    pub agent: AgentName,
    pub nets: Option<PathNet>,
    pub dqn: Option<Dqn>,
    pub seed: u64,
    pub memory: Memory,
    pub puzzle: Option<OpenPuzzle>,
}

/// A puzzle that is being played.
pub struct OpenPuzzle {
    task: Option<TaskId>,
    agent: Box<dyn Agent>,
    /// What earlier puzzles say about its balls, if it is played with the memory.
    recollection: Option<Recollection>,
    /// The source and the scene to remember it by, if it is played with the memory.
    remembered: Option<(PuzzleSource, Scene)>,
    /// The ball whose outcome is pending.
    proposal: Option<Proposal>,
    /// Number of attempts made, not counting invalid balls.
    used: usize,
}

impl Player {
    /// Answers a line.
    ///
    /// # Errors
    ///
    /// If the line cannot be used. Nothing has then changed.
    pub fn answer(&mut self, line: Line) -> anyhow::Result<Answer> {
        let puzzle = match line {
            Line::Begin { puzzle, remember } => match puzzle {
                Begun::Task(id) => self.begin(
                    Some(id),
                    id.seed(self.seed),
                    Task::load(id)?.scene,
                    remember.then_some(PuzzleSource::Task(id)),
                )?,
                Begun::Scene(scene) => self.begin_scene(self.seed, scene, remember)?,
                Begun::Custom(puzzle) => self.begin_scene(puzzle.id.seed(self.seed), puzzle.scene, remember)?,
            },
            Line::Forget => {
                self.memory.forget();
                if let Some(puzzle) = &mut self.puzzle {
                    puzzle.recollection = None;
                }
                return Ok(Answer::Forgot { remembered: self.memory.attempts() });
            }
            Line::Outcome { task, ball, status, paths } => {
                let waiting = self.puzzle.as_mut().and_then(|puzzle| puzzle.proposal.map(|asked| (puzzle, asked)));
                let Some((puzzle, asked)) = waiting else {
                    anyhow::bail!("no ball is waiting for its outcome: begin a puzzle with {{\"task\":\"00007:008\"}}");
                };
                ensure!(task.is_none() || task == puzzle.task, "this is the outcome of another task");
                ensure!(
                    ball.is_none_or(|ball| ball == asked.ball),
                    "this is the outcome of another ball: send that of {}",
                    asked.ball
                );
                if let Some((source, scene)) = puzzle.remembered.as_ref().filter(|_| status != Status::Invalid) {
                    // Everything may have been forgotten in the middle of the puzzle.
                    if !self.memory.is_at(source) {
                        self.memory.begin(source.clone(), scene);
                    }
                    self.memory.observe(asked.ball, asked.chance().unwrap_or_default(), status == Status::Solved);
                }
                puzzle.observe(status, paths.map(|paths| *paths));
                puzzle
            }
        };
        Ok(puzzle.answer())
    }

    fn begin_scene(&mut self, seed: u64, scene: Scene, remember: bool) -> anyhow::Result<&OpenPuzzle> {
        let source = remember.then(|| PuzzleSource::Scene(Box::new(scene.clone())));
        self.begin(None, seed, scene, source)
    }

    /// Begins a puzzle; with the memory if `source` is given.
    fn begin(
        &mut self,
        task: Option<TaskId>,
        seed: u64,
        scene: Scene,
        source: Option<PuzzleSource>,
    ) -> anyhow::Result<&OpenPuzzle> {
        let loaded = Loaded { nets: self.nets.as_ref(), dqn: self.dqn.as_ref() };
        let (agent, recollection) = match &source {
            Some(source) => {
                self.agent.check_remembers()?;
                let recollection = self.memory.begin(source.clone(), &scene);
                (self.agent.start_with(loaded, &scene, seed, BALLS, &recollection), Some(recollection))
            }
            None => (self.agent.start(loaded, &scene, seed, BALLS), None),
        };
        let remembered = source.map(|source| (source, scene));
        let mut puzzle = OpenPuzzle { task, agent, recollection, remembered, proposal: None, used: 0 };
        puzzle.propose();
        Ok(self.puzzle.insert(puzzle))
    }
}

impl OpenPuzzle {
    /// Records the outcome of the pending ball, and proposes the next.
    fn observe(&mut self, status: Status, paths: Option<SampledPaths>) {
        if status != Status::Invalid {
            self.agent.observe(&Observation { solved: status == Status::Solved, paths });
            self.used += 1;
        }
        self.proposal = None;
        if status != Status::Solved {
            self.propose();
        }
    }

    fn propose(&mut self) {
        if self.used < MAX_ATTEMPTS {
            self.proposal = self.agent.propose();
        }
    }

    fn answer(&self) -> Answer {
        let ball = self.proposal.map(|proposal| proposal.ball);
        let reminder =
            self.recollection.as_ref().zip(ball).and_then(|(recollection, ball)| recollection.reminder(ball));
        Answer::Ball { task: self.task, ball, reminder }
    }
}

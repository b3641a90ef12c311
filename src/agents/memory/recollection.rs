//! What a memory says about the balls of one puzzle.

use serde::Serialize;

use super::{Memory, RememberedPuzzle, Settings};
use crate::agents::imagined_candidates::CANDIDATES;
use crate::agents::online::Candidate;
use crate::agents::{Proposal, random, sigmoid};
use crate::puzzle::action::{Ball, Obstacles};
use crate::puzzle::sampled_paths::{SAMPLES, SampledPaths};
use crate::puzzle::scene::{SIZE, Scene};
use crate::puzzle::task::TaskId;

/// A similarity of exp(-6.9), 0.001, or less counts as 0.
const NEGLIGIBLE: f64 = 6.9;

/// The logit of a random ball without prior knowledge: a chance of 1.8 %.
const RANDOM_LOGIT: f64 = -4.0;

/// A puzzle is named as a reminder only if it changed the logit of a ball by at least this much.
const NOTICEABLE: f64 = 0.25;

/// What the attempts at earlier puzzles say about the balls of a puzzle.
#[derive(Clone, Debug)]
pub struct Recollection {
    settings: Settings,
    /// Attempts in scenes similar to this one.
    attempts: Vec<Recalled>,
}

/// An attempt in a scene similar to this one.
#[derive(Clone, Copy, Debug)]
struct Recalled {
    /// The number of its puzzle in the memory, from 1.
    puzzle: usize,
    /// The puzzle, if it is a task.
    task: Option<TaskId>,
    /// Whether this scene resembles the mirror image of that one.
    mirrored: bool,
    /// The ball as it was tried there.
    ball: Ball,
    solved: bool,
    /// The similarity of the scenes, 0..=1.
    similarity: f64,
    /// By how much the attempt changes the logit of an identical ball.
    weight: f64,
    /// The matching positions in this scene, px: the same position, the same offset from the green object, and the same
    /// offset from the goal.
    places: [[f64; 2]; 3],
}

/// The puzzle that changed the logit of a ball most.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Reminder {
    /// The puzzle's number in the memory, from 1.
    pub puzzle: usize,
    /// Absent if the puzzle is not a task.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub task: Option<TaskId>,
    /// By how much the puzzle's attempts changed the logit of the ball.
    pub change: f64,
    /// The ball of the attempt with the largest effect, as it was tried there.
    pub ball: Ball,
    /// Whether that attempt solved its puzzle.
    pub solved: bool,
    /// Whether the scene resembles the mirror image of the puzzle's scene.
    pub mirrored: bool,
}

impl Memory {
    pub(super) fn recall(&self, puzzle: &RememberedPuzzle) -> Recollection {
        let mut attempts = Vec::new();
        let mirrored_sketch = puzzle.sketch.mirrored();
        let length = self.settings.scene_length;
        for (number, earlier) in (self.forgotten + 1..).zip(&self.puzzles) {
            for (mirrored, sketch) in [(false, &puzzle.sketch), (true, &mirrored_sketch)] {
                let similarity = gaussian(earlier.sketch.squared_distance(sketch), length);
                if similarity == 0.0 {
                    continue;
                }
                let seen = |[x, y]: [f64; 2]| if mirrored { [SIZE - x, y] } else { [x, y] };
                attempts.extend(earlier.attempts.iter().map(|attempt| {
                    let [x, y] = seen([attempt.ball.x, attempt.ball.y]);
                    let [to_object, to_goal] = [0, 1].map(|anchor| {
                        let ([here_x, here_y], [there_x, there_y]) =
                            (puzzle.anchors[anchor], seen(earlier.anchors[anchor]));
                        [x + here_x - there_x, y + here_y - there_y]
                    });
                    Recalled {
                        puzzle: number,
                        task: earlier.source.task(),
                        mirrored,
                        ball: attempt.ball,
                        solved: attempt.solved,
                        similarity,
                        weight: similarity * self.settings.weight(attempt),
                        places: [[x, y], to_object, to_goal],
                    }
                }));
            }
        }
        Recollection { settings: self.settings, attempts }
    }
}

impl Recollection {
    /// Returns by how much the memory changes the logit of a ball.
    pub fn change(&self, ball: Ball) -> f64 {
        self.attempts.iter().map(|attempt| self.change_by(attempt, ball)).sum()
    }

    /// Returns the chance, 0..=1, of a ball, based on the memory alone.
    pub fn chance_of_random(&self, ball: Ball) -> f64 {
        sigmoid(RANDOM_LOGIT + self.change(ball))
    }

    /// Returns the puzzle that changed the logit of a ball most, if the change is noticeable.
    pub fn reminder(&self, ball: Ball) -> Option<Reminder> {
        let mut most: Option<Reminder> = None;
        for of_puzzle in self.attempts.chunk_by(|a, b| a.puzzle == b.puzzle) {
            let changes: Vec<f64> = of_puzzle.iter().map(|attempt| self.change_by(attempt, ball)).collect();
            let change: f64 = changes.iter().sum();
            if change.abs() < most.map_or(NOTICEABLE, |most| most.change.abs()) {
                continue;
            }
            let with_changes = of_puzzle.iter().zip(&changes);
            let (attempt, _) = with_changes.max_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs())).expect("an attempt");
            most = Some(Reminder {
                puzzle: attempt.puzzle,
                task: attempt.task,
                change,
                ball: attempt.ball,
                solved: attempt.solved,
                mirrored: attempt.mirrored,
            });
        }
        most
    }

    /// Adds the memory's changes to the logits of candidates.
    pub fn change_logits(&self, candidates: &mut [Candidate]) {
        for candidate in candidates {
            candidate.logit += self.change(candidate.ball);
        }
    }

    /// Returns balls that solved the scenes most like this one, at their matching positions in this scene. They are
    /// valid, distinct, and not yet known.
    pub fn suggestions(&self, scene: &Scene, is_known: impl Fn(&Ball) -> bool) -> Vec<Ball> {
        let mut solved: Vec<&Recalled> = self.attempts.iter().filter(|attempt| attempt.solved).collect();
        // The sort is stable, so among equals the later attempt comes first.
        solved.reverse();
        solved.sort_by(|a, b| b.similarity.total_cmp(&a.similarity));
        let obstacles = Obstacles::new(scene);
        let mut balls: Vec<Ball> = Vec::new();
        for Recalled { ball, places, .. } in solved {
            for [x, y] in places {
                let ball = Ball { x: x.round(), y: y.round(), r: ball.r.round() };
                if balls.len() < self.settings.suggestions
                    && !balls.contains(&ball)
                    && !is_known(&ball)
                    && obstacles.check(&ball).is_ok()
                {
                    balls.push(ball);
                }
            }
        }
        balls
    }

    /// Returns the candidates of an agent without a net: random balls, then the suggestions.
    pub fn random_candidates(&self, scene: &Scene, seed: u64, count: usize) -> Vec<Candidate> {
        self.candidates(scene, random(scene, seed, count.max(CANDIDATES)), |_| RANDOM_LOGIT)
    }

    /// Returns the balls of a list, then the suggestions, as candidates without imagined paths. `prior` gives the logit
    /// of a ball by its rank in the list, from 1.
    pub fn candidates(&self, scene: &Scene, list: Vec<Proposal>, prior: impl Fn(usize) -> f64) -> Vec<Candidate> {
        let mut balls: Vec<Ball> = Vec::new();
        for proposal in list {
            if !balls.contains(&proposal.ball) {
                balls.push(proposal.ball);
            }
        }
        balls.extend(self.suggestions(scene, |ball| balls.contains(ball)));
        let nowhere = [[0.0; 2]; SAMPLES];
        let paths = SampledPaths { object: nowhere, ball: nowhere };
        let ranked = (1..).zip(balls);
        let mut candidates: Vec<Candidate> =
            ranked.map(|(rank, ball)| Candidate { ball, logit: prior(rank), paths }).collect();
        self.change_logits(&mut candidates);
        candidates
    }

    /// Returns by how much an attempt changes the logit of a ball.
    fn change_by(&self, attempt: &Recalled, ball: Ball) -> f64 {
        let dr = ball.r - attempt.ball.r;
        let similarity = self.settings.shares.iter().zip(attempt.places).map(|(&share, [x, y])| {
            let [dx, dy] = [ball.x - x, ball.y - y];
            if share == 0.0 { 0.0 } else { share * gaussian(dx * dx + dy * dy + dr * dr, self.settings.ball_length) }
        });
        attempt.weight * similarity.sum::<f64>()
    }
}

/// Returns a Gaussian of a distance, 1 at 0, and exactly 0 where it is negligible.
fn gaussian(squared_distance: f64, length: f64) -> f64 {
    let exponent = squared_distance / (2.0 * length * length);
    if exponent > NEGLIGIBLE { 0.0 } else { libm::exp(-exponent) }
}

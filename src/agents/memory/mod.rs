//! A memory of attempts that outlives the puzzle. Each attempt changes the chances of similar balls in similar scenes
//! of later puzzles.
//!
//! The method is kernel logistic regression, learned online (Kivinen, Smola and Williamson 2004). The logit of a ball
//! is the prior's logit plus one term for each remembered attempt: the attempt's weight times the similarity of the two
//! scenes times the similarity of the two balls. The weight expresses how unexpected the outcome was. Mirrored scenes
//! count too. The sums are the same to the bit natively and in wasm: they use libm and a fixed order, and files keep
//! all numbers exactly. Uses no simulator and no net.

use serde::{Deserialize, Serialize};

use crate::puzzle::action::Ball;
use crate::puzzle::scene::{Body, Scene, Shape};
use crate::puzzle::task::TaskId;
pub use recollection::{Recollection, Reminder};
pub use saved::MemoryError;
use scene_sketch::SceneSketch;
pub use settings::Settings;

mod recollection;
mod saved;
mod scene_sketch;
mod settings;

/// Version of a memory's effect. Raise it whenever the same attempts make an agent with a memory propose other balls or
/// another order. Results of such agents record it together with `agents::VERSION`, and those of other versions are not
/// comparable. `tests/memory_golden.rs` fails when the random agent's proposals change.
pub const VERSION: u32 = 2;

/// Number of attempts to remember. The oldest puzzles are forgotten first, but the last one keeps its latest attempts.
pub const CAPACITY: usize = 4000;

/// The source of a puzzle: a task, or another scene.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PuzzleSource {
    /// A task of the benchmark.
    Task(TaskId),
    /// A scene that is not a task.
    Scene(Box<Scene>),
}

impl PuzzleSource {
    /// Returns the task; `None` for another scene.
    pub fn task(&self) -> Option<TaskId> {
        match self {
            PuzzleSource::Task(task) => Some(*task),
            PuzzleSource::Scene(_) => None,
        }
    }

    /// Rounds the numbers of a scene, so that every parser reads the same bits.
    fn rounded(mut self) -> PuzzleSource {
        if let PuzzleSource::Scene(scene) = &mut self {
            for Body { x, y, angle, shapes, .. } in &mut scene.bodies {
                let of_shapes = shapes.iter_mut().flat_map(|shape| match shape {
                    Shape::Circle(radius) => std::slice::from_mut(radius),
                    Shape::Polygon(corners) => corners.as_flattened_mut(),
                });
                for number in [x, y, angle].into_iter().chain(of_shapes) {
                    *number = rounded(*number, LENGTHS);
                }
            }
        }
        self
    }
}

/// A remembered attempt.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Attempt {
    /// The ball, px.
    pub ball: Ball,
    /// The chance that the agent gave the ball beforehand, 0..=1, rounded to `CHANCES`, so that every parser reads the
    /// same bits.
    pub chance: f64,
    /// Whether it solved the puzzle.
    pub solved: bool,
}

/// Steps per unit to which chances are rounded.
const CHANCES: f64 = 10_000.0;

/// Steps per px and per radian to which scenes are rounded.
const LENGTHS: f64 = 1_000_000.0;

#[derive(Clone, Debug, PartialEq)]
struct RememberedPuzzle {
    source: PuzzleSource,
    sketch: SceneSketch,
    anchors: Anchors,
    attempts: Vec<Attempt>,
}

/// Centres of the green object and of its goal, px.
type Anchors = [[f64; 2]; 2];

/// All remembered attempts.
#[derive(Clone, Debug)]
pub struct Memory {
    settings: Settings,
    /// In the order of play; the last puzzle may still be in progress.
    puzzles: Vec<RememberedPuzzle>,
    /// Number of puzzles forgotten before the first in `puzzles`.
    forgotten: usize,
}

impl Default for Memory {
    fn default() -> Memory {
        Memory::new(Settings::DEFAULT)
    }
}

impl Memory {
    /// Creates an empty memory.
    pub fn new(settings: Settings) -> Memory {
        Memory { settings, puzzles: Vec::new(), forgotten: 0 }
    }

    /// Begins a puzzle. Returns what the attempts at earlier puzzles say about its balls.
    pub fn begin(&mut self, source: PuzzleSource, scene: &Scene) -> Recollection {
        self.puzzles.retain(|puzzle| !puzzle.attempts.is_empty());
        let puzzle = RememberedPuzzle::new(source, scene);
        let recollection = self.recall(&puzzle);
        self.puzzles.push(puzzle);
        recollection
    }

    /// Remembers an attempt at the puzzle that was begun last, with the chance that the agent gave it.
    pub fn observe(&mut self, ball: Ball, chance: f64, solved: bool) {
        let Some(puzzle) = self.puzzles.last_mut() else { return };
        let ball = Ball { x: rounded(ball.x, LENGTHS), y: rounded(ball.y, LENGTHS), r: rounded(ball.r, LENGTHS) };
        puzzle.attempts.push(Attempt { ball, chance: rounded(chance, CHANCES), solved });
        self.forget_oldest();
    }

    /// Returns whether this puzzle was begun last.
    pub fn is_at(&self, source: &PuzzleSource) -> bool {
        self.puzzles.last().is_some_and(|last| last.source == source.clone().rounded())
    }

    /// Remembers another player's attempt at any puzzle. The ball's chance is that of a random ball, given the attempts
    /// at earlier puzzles.
    pub fn observe_other(&mut self, source: PuzzleSource, scene: &Scene, ball: Ball, solved: bool) {
        let going_on = if self.is_at(&source) { self.puzzles.pop() } else { None };
        let puzzle = going_on.unwrap_or_else(|| RememberedPuzzle::new(source, scene));
        let chance = self.recall(&puzzle).chance_of_random(ball);
        self.puzzles.push(puzzle);
        self.observe(ball, chance, solved);
    }

    /// Forgets everything.
    pub fn forget(&mut self) {
        *self = Memory::new(self.settings);
    }

    /// Returns the puzzles with attempts, each with its number from 1.
    pub fn puzzles(&self) -> impl Iterator<Item = (usize, &PuzzleSource, &[Attempt])> {
        let tried = self.puzzles.iter().filter(|puzzle| !puzzle.attempts.is_empty());
        let numbered = tried.zip(self.forgotten + 1..);
        numbered.map(|(RememberedPuzzle { source, attempts, .. }, number)| (number, source, attempts.as_slice()))
    }

    /// Forgets the oldest puzzles until at most `CAPACITY` attempts are left. If the last puzzle alone has more,
    /// forgets its oldest attempts.
    fn forget_oldest(&mut self) {
        let mut attempts = self.attempts();
        let Some((last, earlier)) = self.puzzles.split_last_mut() else { return };
        let surplus = last.attempts.len().saturating_sub(CAPACITY);
        last.attempts.drain(..surplus);
        attempts -= surplus;
        let oldest = earlier.iter().take_while(|puzzle| {
            let too_many = attempts > CAPACITY;
            attempts -= puzzle.attempts.len();
            too_many
        });
        let count = oldest.count();
        self.puzzles.drain(..count);
        self.forgotten += count;
    }

    /// Returns the number of remembered attempts.
    pub fn attempts(&self) -> usize {
        self.puzzles.iter().map(|puzzle| puzzle.attempts.len()).sum()
    }
}

impl RememberedPuzzle {
    fn new(source: PuzzleSource, scene: &Scene) -> RememberedPuzzle {
        let source = source.rounded();
        let scene = if let PuzzleSource::Scene(rounded) = &source { rounded } else { scene };
        let centre = |body: usize| [scene.bodies[body].x, scene.bodies[body].y];
        let anchors = [scene.body1, scene.body2].map(centre);
        let sketch = SceneSketch::of(scene);
        RememberedPuzzle { source, sketch, anchors, attempts: Vec::new() }
    }
}

fn rounded(number: f64, steps: f64) -> f64 {
    (number * steps).round() / steps
}

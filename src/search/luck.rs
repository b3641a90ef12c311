//! Luck or plan: how robust a solution is. Counts how many of the balls within a pixel of it also solve, and tries the
//! ball itself in the second engine, which the wasm lacks.

use serde::Serialize;

use crate::puzzle::action::{Ball, Obstacles};
use crate::puzzle::scene::Scene;
#[cfg(not(target_arch = "wasm32"))]
use crate::simulator::Engine;
use crate::simulator::outcome;

/// The outcomes of a ball and of the balls within a pixel of it in x, y and radius.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Luck {
    /// Number of valid balls among the 27.
    pub valid: usize,
    /// Number of balls that solve.
    pub solved: usize,
    /// Whether the ball itself solves under rapier2d's own pipeline; false if it is invalid.
    #[cfg(not(target_arch = "wasm32"))]
    pub rapier: bool,
}

/// Tries a ball and the 26 around it.
///
/// ```
/// use pathlight::puzzle::{action::Ball, task::Task};
/// use pathlight::search::luck::luck;
///
/// let task = Task::load("00007:008".parse()?)?;
/// let around = luck(&task.scene, Ball { x: 178.0, y: 218.0, r: 19.0 });
/// assert!(around.solved >= 1 && around.valid <= 27);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn luck(scene: &Scene, ball: Ball) -> Luck {
    let obstacles = Obstacles::new(scene);
    const STEPS: [f64; 3] = [-1.0, 0.0, 1.0];
    let shifts = STEPS.iter().flat_map(|dx| STEPS.iter().flat_map(move |dy| STEPS.iter().map(move |dr| [dx, dy, dr])));
    let around = shifts.map(|[dx, dy, dr]| Ball { x: ball.x + dx, y: ball.y + dy, r: ball.r + dr });
    let outcomes: Vec<bool> = around
        .filter(|ball| obstacles.check(ball).is_ok())
        .filter_map(|ball| Some(outcome(scene, Some(ball)).ok()?.solved))
        .collect();
    Luck {
        valid: outcomes.len(),
        solved: outcomes.iter().filter(|&&solved| solved).count(),
        #[cfg(not(target_arch = "wasm32"))]
        rapier: Engine::Rapier.outcome(scene, Some(ball)).is_ok_and(|outcome| outcome.solved),
    }
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;
    use crate::puzzle::rollout::Status;
    use crate::puzzle::task::Task;
    use crate::verification::AttemptLine;

    #[test]
    fn the_balls_within_a_pixel_are_tried_one_by_one() {
        let mut lines = include_str!("../../assets/attempts.jsonl").lines();
        let solving = lines.find_map(|line| {
            let attempt: AttemptLine = serde_json::from_str(line).expect("an attempt");
            (attempt.status == Status::Solved).then_some(attempt)
        });
        let AttemptLine { task, ball, .. } = solving.expect("one of the shipped attempts solves");
        let (scene, ball) = (Task::load(task.expect("a task")).expect("a task").scene, ball.expect("a ball"));
        let rapier = Engine::Rapier.simulate(&scene, Some(ball)).expect("a valid ball").solved;
        let mut expected = Luck { valid: 0, solved: 0, rapier };
        for (dx, dy, dr) in (0..27).map(|index| (index % 3 - 1, index / 3 % 3 - 1, index / 9 - 1)) {
            let near = Ball { x: ball.x + f64::from(dx), y: ball.y + f64::from(dy), r: ball.r + f64::from(dr) };
            let Ok(outcome) = outcome(&scene, Some(near)) else { continue };
            expected.valid += 1;
            expected.solved += usize::from(outcome.solved);
        }
        assert!(expected.solved > 0);
        assert_eq!(luck(&scene, ball), expected);
    }

    #[test]
    fn only_balls_that_may_be_placed_count() {
        let scene = Task::load("00000:000".parse().expect("an id")).expect("a task").scene;
        // The smallest ball in the upper left corner: no smaller one is valid, and none farther out.
        let corner = luck(&scene, Ball { x: 2.0, y: 254.0, r: 2.0 });
        assert_eq!(corner, Luck { valid: 5, solved: 0, rapier: false });
    }
}

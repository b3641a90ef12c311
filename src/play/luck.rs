//! Luck or plan: whether a ball that solves does so by a hair. Of the balls within a pixel of it, how many solve too, and does
//! it solve in a second engine?

use serde::Serialize;

use crate::puzzle::action::{Ball, Obstacles};
use crate::puzzle::scene::Scene;
use crate::simulator::outcome;

/// What becomes of a ball and of the balls within a pixel of it in x, y and radius.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Luck {
    /// Of the 27 balls, those that may be placed.
    pub valid: usize,
    /// Those that solve.
    pub solved: usize,
}

/// Tries a ball and the 26 around it.
pub fn luck(scene: &Scene, ball: Ball) -> Luck {
    let obstacles = Obstacles::new(scene);
    const STEPS: [f64; 3] = [-1.0, 0.0, 1.0];
    let shifts = STEPS.iter().flat_map(|dx| STEPS.iter().flat_map(move |dy| STEPS.iter().map(move |dr| [dx, dy, dr])));
    let around = shifts.map(|[dx, dy, dr]| Ball { x: ball.x + dx, y: ball.y + dy, r: ball.r + dr });
    let outcomes: Vec<bool> = around
        .filter(|ball| obstacles.check(ball).is_ok())
        .filter_map(|ball| Some(outcome(scene, Some(ball)).ok()?.solved))
        .collect();
    Luck { valid: outcomes.len(), solved: outcomes.iter().filter(|&&solved| solved).count() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::Task;

    #[test]
    fn only_balls_that_may_be_placed_count() {
        let scene = Task::load("00000:000".parse().expect("an id")).expect("a task").scene;
        // The smallest ball in the upper left corner: neither smaller, nor farther out.
        let corner = luck(&scene, Ball { x: 2.0, y: 254.0, r: 2.0 });
        assert_eq!(corner, Luck { valid: 5, solved: 0 });
    }
}

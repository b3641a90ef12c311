//! PHYRE's test of a solution: whether it survives small shifts of the ball.
//!
//! PHYRE calls it `stable`; a task of its benchmark has at least one stable solution.

use crate::puzzle::action::{Ball, Invalid};
use crate::puzzle::scene::Scene;
use crate::simulator::outcome;

/// Shifts of the ball along each axis, px.
const SHIFTS: [f64; 3] = [-0.5, 0.0, 0.5];

/// Returns whether a ball that solves the scene also solves it from the eight positions half a px away. Positions where
/// it would be invalid do not count against it.
///
/// ```
/// use pathlight::puzzle::{action::Ball, task::Task};
/// use pathlight::search::stability::is_stable;
///
/// let scene = Task::load("00007:008".parse()?)?.scene;
/// assert!(is_stable(&scene, Ball { x: 166.0, y: 211.0, r: 9.0 })?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// The reason why the scene cannot be simulated.
pub fn is_stable(scene: &Scene, ball: Ball) -> Result<bool, Invalid> {
    for (dx, dy) in SHIFTS.into_iter().flat_map(|dx| SHIFTS.map(|dy| (dx, dy))).filter(|&shift| shift != (0.0, 0.0)) {
        match outcome(scene, Some(Ball { x: ball.x + dx, y: ball.y + dy, ..ball })) {
            Ok(outcome) if !outcome.solved => return Ok(false),
            Err(Invalid::Scene(fault)) => return Err(fault.into()),
            Ok(_) | Err(_) => {}
        }
    }
    Ok(true)
}

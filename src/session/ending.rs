//! A summary of the end of a rollout: whether it solved the puzzle, how long the object touched the goal, and when the
//! visible motion is over.
//!
//! The page lists endings, and shows the touch while a rollout plays.

use serde::Serialize;

use crate::puzzle::rollout::{GOAL_STEPS, Pose, Rollout};

/// A body that moves less than this in a step looks still, px.
const STILL: f32 = 0.05;
/// A body that turns less than this in a step looks still, radians.
const STILL_ANGLE: f32 = 0.005;
/// Time that a viewer needs to see that everything has come to rest, steps.
const REST: usize = 24;

/// How a rollout ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct Ending {
    /// Whether the puzzle was solved.
    pub solved: bool,
    /// Number of simulated steps.
    pub steps: usize,
    /// The longest uninterrupted time for which the green object touched the goal, steps.
    pub longest_touch: usize,
    /// How long it had been touching at the end of the rollout, steps; 0 if it was not.
    pub final_touch: usize,
}

impl Ending {
    /// Returns the ending of a rollout.
    pub fn of(rollout: &Rollout) -> Ending {
        let longest_touch = (0..=rollout.steps).map(|step| touch_streak(rollout, step)).max().unwrap_or(0);
        let final_touch = touch_streak(rollout, rollout.steps);
        Ending { solved: rollout.solved, steps: rollout.steps, longest_touch, final_touch }
    }
}

/// Returns for how many consecutive steps, up to and including this one, the green object has touched the goal; at most
/// `GOAL_STEPS`.
pub fn touch_streak(rollout: &Rollout, step: usize) -> usize {
    rollout.touching[..=step.min(rollout.steps)].iter().rev().take(GOAL_STEPS).take_while(|&&touches| touches).count()
}

/// Returns the step after which nothing visible happens: a moment after everything has come to rest.
pub fn visible_end(rollout: &Rollout) -> usize {
    let still = |(before, after): (&Pose, &Pose)| {
        let [x, y, angle] = std::array::from_fn(|axis| (after[axis] - before[axis]).abs());
        x < STILL && y < STILL && angle < STILL_ANGLE
    };
    let is_quiet =
        |step: usize| !rollout.touching[step] && rollout.row(step - 1).iter().zip(rollout.row(step)).all(still);
    let still_from = (1..=rollout.steps).rev().find(|&step| !is_quiet(step)).unwrap_or(0);
    (still_from + REST).min(rollout.still_from())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rollout(touching: &[bool], solved: bool) -> Rollout {
        let steps = touching.len() - 1;
        Rollout { solved, steps, bodies: Vec::new(), poses: Vec::new(), touching: touching.to_vec() }
    }

    #[test]
    fn the_longest_touch_and_the_last_are_counted() {
        let touches = |touching: &[bool], solved| {
            let Ending { longest_touch, final_touch, .. } = Ending::of(&rollout(touching, solved));
            (longest_touch, final_touch)
        };
        let (yes, no) = ([true; 84], [false; 10]);
        assert_eq!(touches(&no, false), (0, 0));
        assert_eq!(touches(&[&no[..], &yes, &no, &yes[..6], &no].concat(), false), (84, 0));
        assert_eq!(touches(&[&no[..], &yes[..6], &no, &yes].concat(), false), (84, 84));
        assert_eq!(touches(&[&[false; 133][..], &[true; GOAL_STEPS]].concat(), true), (GOAL_STEPS, GOAL_STEPS));
    }

    #[test]
    fn the_streak_starts_again_after_a_break() {
        let rollout = rollout(&[true, true, false, true, true, true], false);
        let streaks: Vec<_> = (0..=5).map(|step| touch_streak(&rollout, step)).collect();
        assert_eq!(streaks, [1, 2, 0, 1, 2, 3]);
    }

    #[test]
    fn a_rollout_that_only_creeps_on_ends_a_moment_after_it_has_come_to_rest() {
        let creeping = |step: usize| [step.min(9) as f32 + 0.01 * step as f32, 0.0, 0.0];
        let of = |steps: usize, touches: bool| Rollout {
            bodies: vec![0],
            poses: (0..=steps).map(creeping).collect(),
            ..rollout(&vec![touches; steps + 1], false)
        };
        assert_eq!(visible_end(&of(200, false)), 9 + REST);
        assert_eq!(visible_end(&of(20, false)), 20);
        assert_eq!(visible_end(&of(200, true)), 200);
    }
}

//! The end of a rollout in brief: whether it solved the puzzle and how long the object touched the goal.
//!
//! Used by `game`, and by the page to show the touch while a rollout plays.

use serde::{Deserialize, Serialize};

use crate::puzzle::rollout::{GOAL_STEPS, Rollout};

/// How a rollout ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Ending {
    /// Whether the puzzle was solved.
    pub solved: bool,
    /// Number of simulated steps.
    pub steps: usize,
    /// The longest time for which the green object touched the goal without a break, steps.
    pub longest_touch: usize,
    /// For how long it had been touching at the end of the rollout, steps; 0 if it was not.
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
}

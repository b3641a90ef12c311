//! The end of a rollout in brief: whether it solved the puzzle and how long the object touched the goal, in numbers and
//! in words.
//!
//! Used by `game`, and by the page to show the touch while a rollout plays.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::puzzle::rollout::{GOAL_STEPS, Rollout, STEPS_PER_SECOND};

/// How a rollout ended. Its `Display` is the result in words.
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

impl fmt::Display for Ending {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let seconds = |steps: usize| match steps as f64 / STEPS_PER_SECOND as f64 {
            short if short < 0.05 => "a moment".to_string(),
            long => format!("{long:.1} s"),
        };
        match self {
            Ending { solved: true, steps, .. } => write!(f, "solved after {}", seconds(*steps)),
            Ending { longest_touch: 0, .. } => write!(f, "never touched"),
            Ending { final_touch, .. } if *final_touch > 0 => {
                write!(f, "touching for {} when time ran out", seconds(*final_touch))
            }
            Ending { longest_touch, .. } => write!(f, "touched for {}, then lost", seconds(*longest_touch)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rollout(touching: &[bool], solved: bool) -> Rollout {
        let steps = touching.len() - 1;
        Rollout { solved, steps, bodies: Vec::new(), poses: Vec::new(), touching: touching.to_vec() }
    }

    #[test]
    fn an_ending_in_words() {
        let words = |touching: &[bool], solved| Ending::of(&rollout(touching, solved)).to_string();
        let (yes, no) = ([true; 84], [false; 10]);
        assert_eq!(words(&no, false), "never touched");
        assert_eq!(words(&[&no[..], &yes, &no, &yes[..6], &no].concat(), false), "touched for 1.4 s, then lost");
        assert_eq!(words(&[&no[..], &yes[..1], &no].concat(), false), "touched for a moment, then lost");
        assert_eq!(words(&[&no[..], &yes].concat(), false), "touching for 1.4 s when time ran out");
        assert_eq!(words(&[&[false; 133][..], &[true; GOAL_STEPS]].concat(), true), "solved after 5.2 s");
    }

    #[test]
    fn the_streak_starts_again_after_a_break() {
        let rollout = rollout(&[true, true, false, true, true, true], false);
        let streaks: Vec<_> = (0..=5).map(|step| touch_streak(&rollout, step)).collect();
        assert_eq!(streaks, [1, 2, 0, 1, 2, 3]);
    }
}

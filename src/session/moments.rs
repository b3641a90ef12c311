//! Finds the stretches of a rollout in which nothing moves, and the start of the touch that solves the puzzle. Playback
//! hurries through the former and slows down at the latter.

use crate::puzzle::rollout::{GOAL_STEPS, Pose, Rollout};

/// A body that moves less than this in a step looks still, px.
const STILL: f32 = 0.05;
/// So does one that turns less than this, radians.
const STILL_ANGLE: f32 = 0.005;
/// For how long the eye sees that everything has come to rest, steps.
const REST: usize = 24;
/// Shorter stretches are not worth hurrying through, steps.
const LEAST: usize = 45;

/// Returns the stretches, as first and last step, in which nothing moves in any of some rollouts, and no object is on
/// its goal.
pub fn quiet_stretches<'a>(rollouts: impl Iterator<Item = &'a Rollout> + Clone) -> Vec<[usize; 2]> {
    let last = rollouts.clone().map(|rollout| rollout.steps).max().unwrap_or(0);
    let mut stretches: Vec<[usize; 2]> = Vec::new();
    for step in (1..=last).filter(|&step| rollouts.clone().all(|rollout| is_quiet(rollout, step))) {
        match stretches.last_mut() {
            Some([_, end]) if *end + 1 == step => *end = step,
            _ => stretches.push([step, step]),
        }
    }
    stretches.retain(|[first, end]| end - first + 1 >= LEAST);
    stretches
}

/// Returns the step after which nothing that can be seen happens any more: a moment after all has come to rest.
pub fn visible_end(rollout: &Rollout) -> usize {
    let still_from = (1..=rollout.steps).rev().find(|&step| !is_quiet(rollout, step)).unwrap_or(0);
    (still_from + REST).min(rollout.still_from())
}

/// Returns the step at which the touch begins that solves the puzzle; `None` if it is not solved.
pub fn deciding_touch(rollout: &Rollout) -> Option<usize> {
    rollout.solved.then(|| (rollout.steps + 1).saturating_sub(GOAL_STEPS))
}

fn is_quiet(rollout: &Rollout, step: usize) -> bool {
    if step > rollout.steps {
        return true;
    }
    let still = |(before, after): (&Pose, &Pose)| {
        let moved = [0, 1].map(|axis| (after[axis] - before[axis]).abs());
        moved[0] < STILL && moved[1] < STILL && (after[2] - before[2]).abs() < STILL_ANGLE
    };
    !rollout.touching[step] && rollout.row(step - 1).iter().zip(rollout.row(step)).all(still)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A rollout of one body that moves, rests for `rest` steps, and moves again.
    fn rollout(rest: usize) -> Rollout {
        let xs = (0..10).chain(std::iter::repeat_n(9, rest)).chain(9..20);
        let poses: Vec<Pose> = xs.map(|x| [x as f32, 0.0, 0.0]).collect();
        let touching = vec![false; poses.len()];
        Rollout { solved: false, steps: poses.len() - 1, bodies: vec![0], poses, touching }
    }

    #[test]
    fn a_rollout_that_only_creeps_on_ends_a_moment_after_it_has_come_to_rest() {
        let creeping = |step: usize| [step.min(9) as f32 + 0.01 * step as f32, 0.0, 0.0];
        let of = |steps: usize, touching: bool| Rollout {
            solved: false,
            steps,
            bodies: vec![0],
            poses: (0..=steps).map(creeping).collect(),
            touching: vec![touching; steps + 1],
        };
        assert_eq!(visible_end(&of(200, false)), 9 + REST);
        assert_eq!(visible_end(&of(20, false)), 20);
        assert_eq!(visible_end(&of(200, true)), 200);
    }

    #[test]
    fn a_long_rest_is_quiet_and_a_short_one_is_not() {
        let (long, short) = (rollout(60), rollout(20));
        assert_eq!(quiet_stretches([&long].into_iter()), [[10, 70]]);
        assert_eq!(quiet_stretches([&short].into_iter()), [[0; 2]; 0]);
        assert_eq!(quiet_stretches([&long, &short].into_iter()), [[0; 2]; 0]);
    }

    #[test]
    fn an_object_on_its_goal_is_not_quiet() {
        let mut touches = rollout(60);
        touches.touching.fill(true);
        assert_eq!(quiet_stretches([&touches].into_iter()), [[0; 2]; 0]);
        assert_eq!(deciding_touch(&touches), None);
        touches.solved = true;
        assert_eq!(deciding_touch(&touches), Some(0));
    }
}

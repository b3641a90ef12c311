//! From the judge's maps to balls: the likeliest first, each next one away from those that have been tried.
//!
//! A ball that failed says that balls like it fail too, so every proposal lowers the judge's opinion of its
//! neighbourhood. No call of the simulator, and nothing drawn at random.

use crate::action::Ball;
use crate::pathnet::judge;
use crate::placement::{Origin, Proposal};
use crate::scene::Scene;

/// How far the doubt about a ball that was tried reaches: standard deviation of a Gaussian in x, y and r, px.
const REACH: f64 = 10.0;

/// How much lower a logit falls where a ball was tried.
const DOUBT: f64 = 3.0;

/// Up to `attempts` valid balls, the likeliest first. `logits` holds the judge's `[RADII, 64, 64]` maps.
pub fn ranked(logits: &[f32], scene: &Scene, attempts: usize) -> Vec<Proposal> {
    let mut candidates: Vec<(Ball, f64)> = (0..logits.len())
        .filter(|&index| logits[index].is_finite())
        .filter_map(|index| Some((judge::ball(index).action().place(scene).ok()?, logits[index].into())))
        .collect();
    let mut found = Vec::with_capacity(attempts);
    while found.len() < attempts {
        let Some(best) = (0..candidates.len()).max_by(|&a, &b| candidates[a].1.total_cmp(&candidates[b].1)) else {
            break;
        };
        let (ball, _) = candidates.swap_remove(best);
        for (other, logit) in &mut candidates {
            let apart = (ball.x - other.x).powi(2) + (ball.y - other.y).powi(2) + (ball.r - other.r).powi(2);
            if apart < (4.0 * REACH).powi(2) {
                *logit -= DOUBT * libm::exp(-apart / (2.0 * REACH * REACH));
            }
        }
        found.push(Proposal { ball, origin: Origin::Judge, passed: 0 });
    }
    found
}

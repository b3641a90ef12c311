//! From the judge's maps to balls: the likeliest first, each next one away from those that have been tried.
//!
//! A ball that failed says that balls like it fail too, so every proposal lowers the judge's opinion of its
//! neighbourhood. No call of the simulator, and nothing drawn at random.

use crate::action::Ball;
use crate::pathnet::judge;
use crate::placement::{Origin, Proposal};
use crate::scene::Scene;

/// How far the doubt about a ball that was tried reaches: standard deviation of a Gaussian in x, y and r, px.
const REACH: f64 = 5.0;

/// How much lower a logit falls where a ball was tried.
const DOUBT: f64 = 2.0;

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
        let (ball, logit) = candidates.swap_remove(best);
        for (other, logit) in &mut candidates {
            let apart = (ball.x - other.x).powi(2) + (ball.y - other.y).powi(2) + (ball.r - other.r).powi(2);
            if apart < (4.0 * REACH).powi(2) {
                *logit -= DOUBT * libm::exp(-apart / (2.0 * REACH * REACH));
            }
        }
        found.push(Proposal { ball, origin: Origin::Judge { chance: 1.0 / (1.0 + libm::exp(-logit)) }, passed: 0 });
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pathnet::judge::RADII;
    use crate::raster::CELLS;
    use crate::task::Task;

    #[test]
    fn the_likeliest_valid_ball_comes_first_and_its_neighbours_wait() {
        let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
        let valid = |index: &usize| judge::ball(*index).action().place(&scene).ok();
        let free: Vec<usize> = (0..RADII * CELLS).filter(|index| valid(index).is_some()).collect();
        let blocked = (0..RADII * CELLS).find(|index| valid(index).is_none()).expect("a place that is taken");
        let (first, second) = (free[free.len() / 2], free[0]);
        let mut logits = vec![-9.0; RADII * CELLS];
        (logits[blocked], logits[first], logits[first + 1], logits[second]) = (9.0, 4.0, 3.9, 3.0);
        let found = ranked(&logits, &scene, 100);
        assert_eq!(found.len(), 100);
        assert_eq!(Some(found[0].ball), valid(&first));
        assert_eq!(Some(found[1].ball), valid(&second), "the neighbour of a ball that was tried has lost");
        assert!(matches!(found[0].origin, Origin::Judge { chance } if (0.97..0.99).contains(&chance)));
        for (index, one) in found.iter().enumerate() {
            assert_eq!(one.ball.check(&scene), Ok(()));
            assert!(found[..index].iter().all(|before| before.ball != one.ball), "{} twice", one.ball);
        }
        assert!(ranked(&vec![f32::NAN; RADII * CELLS], &scene, 5).is_empty());
    }
}

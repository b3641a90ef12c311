//! From the judge's maps to balls: the likeliest first, each next one away from those that have been tried; and to
//! one map that people can look at.
//!
//! A ball that failed says that balls like it fail too, so every proposal lowers the judge's opinion of its
//! neighbourhood. No call of the simulator, and nothing drawn at random.

use super::proposal::{Origin, Proposal};
use crate::nets::judge::{self, RADII};
use crate::puzzle::action::Ball;
use crate::puzzle::scene::Scene;
use crate::raster::CELLS;

/// How far the doubt about a ball that was tried reaches: standard deviation of a Gaussian in x, y and r, px.
const REACH: f64 = 5.0;

/// How much lower a logit falls where a ball was tried.
const DOUBT: f64 = 2.0;

/// Up to `attempts` valid balls, the likeliest first. `logits` holds the judge's `[RADII, 64, 64]` maps.
pub fn ranked(logits: &[f32], scene: &Scene, attempts: usize) -> Vec<Proposal> {
    let mut candidates: Vec<(Ball, f64)> =
        candidates(logits, scene).map(|(index, ball)| (ball, logits[index].into())).collect();
    let mut found = Vec::with_capacity(attempts);
    while found.len() < attempts {
        let Some(best) = (0..candidates.len()).max_by(|&a, &b| candidates[a].1.total_cmp(&candidates[b].1)) else {
            break;
        };
        let (ball, logit) = candidates.swap_remove(best);
        for (other, logit) in &mut candidates {
            let [dx, dy, dr] = [ball.x - other.x, ball.y - other.y, ball.r - other.r];
            let apart = dx * dx + dy * dy + dr * dr;
            if apart < 16.0 * REACH * REACH {
                *logit -= DOUBT * libm::exp(-apart / (2.0 * REACH * REACH));
            }
        }
        found.push(Proposal { ball, origin: Origin::Judge { chance: chance(logit) }, passed: 0 });
    }
    found
}

/// For each of the 64 x 64 cells, row 0 at the bottom, the judge's chance, 0..=1, of the best ball that may be placed
/// there; 0 where none may be. None if no logit is a number: such a judge orders nothing.
pub fn chances(logits: &[f32], scene: &Scene) -> Option<Vec<f32>> {
    let mut map = vec![0.0_f32; CELLS];
    for (index, _) in candidates(logits, scene) {
        let cell = &mut map[index % CELLS];
        *cell = cell.max(chance(logits[index].into()) as f32);
    }
    logits.iter().any(|logit| logit.is_finite()).then_some(map)
}

/// The balls that may be placed, each with its index among the logits.
fn candidates(logits: &[f32], scene: &Scene) -> impl Iterator<Item = (usize, Ball)> {
    // Where a ball fits, every smaller one does, so that few have to be tried: for each cell the number of radii that
    // fit, and the largest such ball.
    let radii: [usize; RADII] = std::array::from_fn(|radius| radius);
    let fitting: Vec<(usize, Option<Ball>)> = (0..CELLS.min(logits.len()))
        .map(|cell| {
            let placed = |radius: usize| judge::ball(radius * CELLS + cell).action().place(scene).ok();
            let count = radii.partition_point(|&radius| placed(radius).is_some());
            (count, count.checked_sub(1).and_then(placed))
        })
        .collect();
    (0..logits.len()).filter(|&index| logits[index].is_finite()).filter_map(move |index| {
        let (count, largest) = fitting[index % CELLS];
        let r = judge::ball(index).r.round_ties_even();
        (index / CELLS < count).then_some((index, Ball { r, ..largest? }))
    })
}

fn chance(logit: f64) -> f64 {
    1.0 / (1.0 + libm::exp(-logit))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::Task;

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

        assert_eq!(chances(&[f32::NAN], &scene), None);
        let map = chances(&logits, &scene).expect("a map");
        assert_eq!(map.len(), CELLS);
        assert_eq!(map[first % CELLS], chance(4.0) as f32, "the best radius counts");
        assert!(map.iter().all(|&chance| chance < 0.99), "a place that is taken has no chance");
        let wall = (0..CELLS).find(|cell| free.iter().all(|index| index % CELLS != *cell)).expect("a cell in a body");
        assert_eq!(map[wall], 0.0);
    }
}

//! From the judge's maps to balls: greedy selection of the most probable ball with soft non-maximum suppression; and to
//! one map that people can look at.
//!
//! A ball that failed makes its neighbours less likely to solve, so each selected ball lowers the logits around it, by
//! a Gaussian of the distance (soft-NMS, Bodla et al. 2017, on logits instead of scores). Does not call the simulator
//! and draws nothing at random.

use super::{Origin, Proposal};
use crate::nets::judge::{RADII, ball_at};
use crate::puzzle::action::{Ball, Obstacles};
use crate::puzzle::scene::Scene;
use crate::raster::CELLS;

/// How much a selected ball lowers the logit of a ball at the same place and of the same radius.
const SUPPRESSION: f64 = 2.0;

/// Standard deviation of the Gaussian by which the suppression falls with the distance in x, y and r, px.
const SUPPRESSION_SIGMA: f64 = 5.0;

/// Returns up to `attempts` valid, distinct balls, the most probable first. `logits` holds the judge's
/// `[RADII, 64, 64]` maps; values that are not finite are left out.
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
            let squared_distance = dx * dx + dy * dy + dr * dr;
            // Beyond four deviations the suppression is below 0.001.
            if squared_distance < 16.0 * SUPPRESSION_SIGMA * SUPPRESSION_SIGMA {
                *logit -= SUPPRESSION * libm::exp(-squared_distance / (2.0 * SUPPRESSION_SIGMA * SUPPRESSION_SIGMA));
            }
        }
        found.push(Proposal { ball, origin: Origin::Judge { probability: sigmoid(logit) }, rejected: 0 });
    }
    found
}

/// Returns for each of the 64 x 64 cells, row 0 at the bottom, the probability, 0..=1, that the best valid ball there
/// solves the scene, 0 where no ball is valid; `None` if no logit is finite.
pub fn probability_map(logits: &[f32], scene: &Scene) -> Option<Vec<f32>> {
    let mut map = vec![0.0_f32; CELLS];
    for (index, _) in candidates(logits, scene) {
        let cell = &mut map[index % CELLS];
        *cell = cell.max(sigmoid(logits[index].into()) as f32);
    }
    logits.iter().any(|logit| logit.is_finite()).then_some(map)
}

/// The valid balls with a finite logit, each with its index among the logits.
fn candidates(logits: &[f32], scene: &Scene) -> impl Iterator<Item = (usize, Ball)> {
    // Where a ball fits, every smaller one fits too, so a binary search over the radii needs few checks: for each cell
    // the number of radii that fit, and the largest such ball.
    let obstacles = Obstacles::new(scene);
    let radii: [usize; RADII] = std::array::from_fn(|radius| radius);
    let fitting: Vec<(usize, Option<Ball>)> = (0..CELLS.min(logits.len()))
        .map(|cell| {
            let placed = |radius: usize| obstacles.place(ball_at(radius * CELLS + cell).action()).ok();
            let count = radii.partition_point(|&radius| placed(radius).is_some());
            (count, count.checked_sub(1).and_then(placed))
        })
        .collect();
    (0..logits.len()).filter(|&index| logits[index].is_finite()).filter_map(move |index| {
        let (count, largest) = fitting[index % CELLS];
        let r = ball_at(index).rounded().r;
        (index / CELLS < count).then_some((index, Ball { r, ..largest? }))
    })
}

fn sigmoid(logit: f64) -> f64 {
    1.0 / (1.0 + libm::exp(-logit))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::Task;

    #[test]
    fn the_most_probable_valid_ball_comes_first_and_suppresses_its_neighbours() {
        let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
        let valid = |index: &usize| ball_at(*index).action().place(&scene).ok();
        let free: Vec<usize> = (0..RADII * CELLS).filter(|index| valid(index).is_some()).collect();
        let blocked = (0..RADII * CELLS).find(|index| valid(index).is_none()).expect("an occupied place");
        let (first, second) = (free[free.len() / 2], free[0]);
        let mut logits = vec![-9.0; RADII * CELLS];
        (logits[blocked], logits[first], logits[first + 1], logits[second]) = (9.0, 4.0, 3.9, 3.0);
        let found = ranked(&logits, &scene, 100);
        assert_eq!(found.len(), 100);
        assert_eq!(Some(found[0].ball), valid(&first));
        assert_eq!(Some(found[1].ball), valid(&second), "the neighbour of the first ball is suppressed");
        assert!(matches!(found[0].origin, Origin::Judge { probability } if (0.97..0.99).contains(&probability)));
        for (index, one) in found.iter().enumerate() {
            assert_eq!(one.ball.check(&scene), Ok(()));
            assert!(found[..index].iter().all(|before| before.ball != one.ball), "{} twice", one.ball);
        }
        assert!(ranked(&vec![f32::NAN; RADII * CELLS], &scene, 5).is_empty());

        assert_eq!(probability_map(&[f32::NAN], &scene), None);
        let map = probability_map(&logits, &scene).expect("a map");
        assert_eq!(map.len(), CELLS);
        assert_eq!(map[first % CELLS], sigmoid(4.0) as f32, "the best radius counts");
        assert!(map.iter().all(|&probability| probability < 0.99), "a ball that overlaps a body has no probability");
        let wall = (0..CELLS).find(|cell| free.iter().all(|index| index % CELLS != *cell)).expect("a cell in a body");
        assert_eq!(map[wall], 0.0);
    }
}

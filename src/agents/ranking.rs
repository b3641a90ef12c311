//! From the success net's maps to balls: greedy selection of the most probable ball with soft non-maximum suppression;
//! and to one map that people can look at.
//!
//! A ball that failed makes its neighbours less likely to solve, so each selected ball lowers the logits around it, by
//! a Gaussian of the distance (soft-NMS, Bodla et al. 2017, on logits instead of scores). Does not call the simulator
//! and draws nothing at random.

use std::cmp::Ordering;
use std::collections::BinaryHeap;

use super::fitting_balls::FittingBalls;
use super::{Origin, Proposal, sigmoid};
use crate::nets::success_net::RADII;
use crate::puzzle::scene::Scene;
use crate::raster::{CELLS, PX_PER_CELL, SIDE};

/// How much a selected ball lowers the logit of a ball at the same place and of the same radius.
const SUPPRESSION: f64 = 2.0;

/// Standard deviation of the Gaussian by which the suppression falls with the distance in x, y and r, px.
const SUPPRESSION_SIGMA: f64 = 5.0;

/// Distance in x, y and r from which there is no suppression, px: beyond four deviations it is below 0.001.
const SUPPRESSION_REACH: usize = 20;

/// Cells to each side of a selected ball that it may reach; rounding moves a ball by less than one px within its cell.
const REACHED_CELLS: usize = (SUPPRESSION_REACH + 1) / PX_PER_CELL;

/// Returns up to `attempts` valid, distinct balls, the most probable first. `logits` holds the success net's
/// `[RADII, 64, 64]` maps; values that are not finite are left out.
pub fn ranked(logits: &[f32], scene: &Scene, attempts: usize) -> Vec<Proposal> {
    let balls = FittingBalls::new(scene);
    let suppression = suppression_by_squared_distance();
    let mut logits: Vec<f64> = logits.iter().map(|&logit| logit.into()).collect();
    let valid = (0..CELLS).flat_map(|cell| (0..balls.count(cell)).map(move |radius| radius * CELLS + cell));
    let finite = valid.filter(|&index| logits[index].is_finite());
    let mut queue: BinaryHeap<Candidate> = finite.map(|index| Candidate { logit: logits[index], index }).collect();
    let mut found = Vec::with_capacity(attempts);
    while found.len() < attempts
        && let Some(Candidate { logit, index }) = queue.pop()
    {
        // Logits only fall. One that has fallen since it was queued comes out too early, and is queued again (lazy
        // evaluation, as in Minoux's accelerated greedy algorithm).
        if logits[index] < logit {
            queue.push(Candidate { logit: logits[index], index });
            continue;
        }
        let ball = balls.ball(index);
        for near_index in neighbours(index) {
            let near = balls.ball(near_index);
            let [dx, dy, dr] = [ball.x - near.x, ball.y - near.y, ball.r - near.r];
            let squared_distance = (dx * dx + dy * dy + dr * dr) as usize;
            if let Some(suppression) = suppression.get(squared_distance) {
                logits[near_index] -= suppression;
            }
        }
        found.push(Proposal { ball, origin: Origin::Success { probability: sigmoid(logit) }, rejected: 0 });
    }
    found
}

/// A ball that has not been selected, with the logit that it had when it was queued. Of equal logits, as the two halves
/// of a symmetric scene have them, the one with the higher index is greater.
struct Candidate {
    logit: f64,
    index: usize,
}

impl Ord for Candidate {
    fn cmp(&self, other: &Candidate) -> Ordering {
        self.logit.total_cmp(&other.logit).then(self.index.cmp(&other.index))
    }
}

impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Candidate) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Candidate) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Candidate {}

/// How much a logit falls, by the squared distance of its ball from the selected one, px²: a whole number, because
/// balls have whole coordinates and radii.
fn suppression_by_squared_distance() -> [f64; SUPPRESSION_REACH * SUPPRESSION_REACH] {
    std::array::from_fn(|squared_distance| {
        SUPPRESSION * libm::exp(-(squared_distance as f64) / (2.0 * SUPPRESSION_SIGMA * SUPPRESSION_SIGMA))
    })
}

/// The indices of the logits, of any radius, on the cells that a selected ball may reach.
fn neighbours(index: usize) -> impl Iterator<Item = usize> {
    let around = |at: usize| at.saturating_sub(REACHED_CELLS)..(at + REACHED_CELLS + 1).min(SIDE);
    let columns = around(index % SIDE);
    let rows = around(index % CELLS / SIDE);
    (0..RADII).flat_map(move |radius| {
        let columns = columns.clone();
        rows.clone().flat_map(move |row| columns.clone().map(move |column| radius * CELLS + row * SIDE + column))
    })
}

/// Returns for each of the 64 x 64 cells, row 0 at the bottom, the probability that the best valid ball there solves
/// the scene, 0 where no ball is valid; `None` if no logit is finite.
pub fn probability_map(logits: &[f32], scene: &Scene) -> Option<Vec<f32>> {
    let balls = FittingBalls::new(scene);
    let probability = |cell: usize| {
        let logits = (0..balls.count(cell)).map(|radius| logits[radius * CELLS + cell]);
        let best = logits.filter(|logit| logit.is_finite()).reduce(f32::max);
        best.map_or(0.0, |logit| sigmoid(logit.into()) as f32)
    };
    logits.iter().any(|logit| logit.is_finite()).then(|| (0..CELLS).map(probability).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::nets::success_net::ball_at;
    use crate::puzzle::task::Task;

    #[test]
    fn the_most_probable_valid_ball_comes_first_and_suppresses_its_neighbours() {
        let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
        let valid = |index: &usize| ball_at(*index).action().place(&scene).ok();
        let free: Vec<usize> = (0..RADII * CELLS).filter(|index| valid(index).is_some()).collect();
        let blocked = (0..RADII * CELLS).find(|index| valid(index).is_none()).expect("an occupied place");
        let first = free[free.len() / 2];
        let second = free[0];
        let mut logits = vec![-9.0; RADII * CELLS];
        for (index, logit) in [(blocked, 9.0), (first, 4.0), (first + 1, 3.9), (second, 3.0)] {
            logits[index] = logit;
        }
        let found = ranked(&logits, &scene, 100);
        assert_eq!(found.len(), 100);
        assert_eq!(Some(found[0].ball), valid(&first));
        assert_eq!(Some(found[1].ball), valid(&second), "the neighbour of the first ball is suppressed");
        assert!(matches!(found[0].origin, Origin::Success { probability } if (0.97..0.99).contains(&probability)));
        for (index, Proposal { ball, .. }) in found.iter().enumerate() {
            assert_eq!(ball.check(&scene), Ok(()));
            assert!(found[..index].iter().all(|before| before.ball != *ball), "{ball} twice");
        }
        assert!(ranked(&vec![f32::NAN; RADII * CELLS], &scene, 5).is_empty());

        assert_eq!(probability_map(&vec![f32::NAN; RADII * CELLS], &scene), None);
        let map = probability_map(&logits, &scene).expect("a map");
        assert_eq!(map.len(), CELLS);
        assert_eq!(map[first % CELLS], sigmoid(4.0) as f32, "the best radius counts");
        assert!(map.iter().all(|&probability| probability < 0.99), "a ball that overlaps a body has no probability");
        let wall = (0..CELLS).find(|cell| free.iter().all(|index| index % CELLS != *cell)).expect("a cell in a body");
        assert_eq!(map[wall], 0.0);
    }
}

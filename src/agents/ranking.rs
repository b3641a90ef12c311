//! Ranks balls by the success net's maps: greedy selection of the most probable ball with soft non-maximum suppression.
//! Also reduces the maps to one that people can read.
//!
//! A failed ball makes its neighbours less likely to solve, so each selected ball lowers the logits around it, by a
//! Gaussian of the distance (soft-NMS, Bodla et al. 2017, on logits instead of scores). Does not call the simulator and
//! draws nothing at random.

use std::cmp::Ordering;

use super::fitting_balls::FittingBalls;
use super::{Origin, Proposal, sigmoid};
use crate::nets::success_net::RADII;
use crate::puzzle::scene::Scene;
use crate::raster::{CELLS, PX_PER_CELL, SIDE};

/// How much a selected ball lowers the logit of a ball at the same place and of the same radius.
const SUPPRESSION: f64 = 2.0;

/// Standard deviation of the Gaussian by which the suppression falls with the distance in x, y and r, px.
const SUPPRESSION_SIGMA: f64 = 5.0;

/// Distance in x, y and r from which there is no suppression, px. Beyond four standard deviations it is below 0.001.
const SUPPRESSION_REACH: usize = 20;

/// Cells to each side of a selected ball that it may reach; rounding moves a ball by less than one px within its cell.
const REACHED_CELLS: usize = (SUPPRESSION_REACH + 1) / PX_PER_CELL;

/// Side length of a block, cells.
const BLOCK: usize = 8;
const BLOCKS: usize = SIDE / BLOCK;

/// Returns up to `attempts` valid, distinct balls, the most probable first. `logits` holds the success net's
/// `[RADII, 64, 64]` maps; values that are not finite are omitted.
pub fn ranked(logits: &[f32], scene: &Scene, attempts: usize) -> Vec<Proposal> {
    let balls = FittingBalls::new(scene);
    let mut queue = Queue::new(logits, &balls);
    let found = std::iter::from_fn(|| queue.select(&balls)).take(attempts);
    let proposal = |Ranked { logit, index }| Proposal {
        ball: balls.ball(index),
        origin: Origin::Success { probability: sigmoid(logit) },
    };
    found.map(proposal).collect()
}

/// A ball and its logit. If logits are equal, as in the two halves of a symmetric scene, the ball with the higher index
/// is greater.
#[derive(Clone, Copy)]
struct Ranked {
    logit: f64,
    index: usize,
}

impl Ranked {
    fn compare(&self, other: &Ranked) -> Ordering {
        self.logit.total_cmp(&other.logit).then(self.index.cmp(&other.index))
    }
}

/// The balls that have not been selected.
struct Queue {
    /// The logits; negative infinity for invalid or selected balls.
    logits: Vec<f64>,
    /// The greatest ball of each block of cells, as of the last comparison of its logits.
    greatest: [Ranked; BLOCKS * BLOCKS],
    /// Blocks whose logits have fallen since then.
    is_stale: [bool; BLOCKS * BLOCKS],
    /// Suppression by the squared distance of two balls, px²: a whole number, because coordinates and radii are whole.
    suppression: [f64; SUPPRESSION_REACH * SUPPRESSION_REACH],
}

impl Queue {
    fn new(logits: &[f32], balls: &FittingBalls) -> Queue {
        let logit = |(index, &logit): (usize, &f32)| {
            let is_queued = index / CELLS < balls.count(index % CELLS) && logit.is_finite();
            // Adding 0.0 turns negative zero into zero.
            if is_queued { f64::from(logit) + 0.0 } else { f64::NEG_INFINITY }
        };
        Queue {
            logits: logits.iter().enumerate().map(logit).collect(),
            greatest: [Ranked { logit: f64::INFINITY, index: 0 }; BLOCKS * BLOCKS],
            is_stale: [true; BLOCKS * BLOCKS],
            suppression: std::array::from_fn(|squared_distance| {
                SUPPRESSION * libm::exp(-(squared_distance as f64) / (2.0 * SUPPRESSION_SIGMA * SUPPRESSION_SIGMA))
            }),
        }
    }

    /// Removes the greatest ball and lowers the logits around it; `None` if no ball is left.
    fn select(&mut self, balls: &FittingBalls) -> Option<Ranked> {
        loop {
            let block = (0..self.greatest.len()).max_by(|&a, &b| self.greatest[a].compare(&self.greatest[b]))?;
            // Logits only fall, so if the block with the greatest ball is not stale, that ball is the greatest of all
            // (lazy evaluation, as in Minoux's accelerated greedy algorithm).
            if self.is_stale[block] {
                self.greatest[block] = self.greatest_in(block);
                self.is_stale[block] = false;
                continue;
            }
            let selected = self.greatest[block];
            if selected.logit == f64::NEG_INFINITY {
                return None;
            }
            self.logits[selected.index] = f64::NEG_INFINITY;
            self.suppress_around(selected.index, balls);
            return Some(selected);
        }
    }

    fn greatest_in(&self, block: usize) -> Ranked {
        let corner = block / BLOCKS * BLOCK * SIDE + block % BLOCKS * BLOCK;
        let rows = (0..RADII).flat_map(|radius| (0..BLOCK).map(move |row| radius * CELLS + corner + row * SIDE));
        let row = |first: usize| &self.logits[first..first + BLOCK];
        // Column by column, so that the columns are compared in parallel.
        let mut greatest = [f64::NEG_INFINITY; BLOCK];
        for first in rows.clone() {
            for (greatest, &logit) in greatest.iter_mut().zip(row(first)) {
                *greatest = if logit > *greatest { logit } else { *greatest };
            }
        }
        let logit = greatest.into_iter().fold(f64::NEG_INFINITY, f64::max);
        let last = rows.rev().find_map(|first| Some(first + row(first).iter().rposition(|&other| other == logit)?));
        Ranked { logit, index: last.unwrap_or_default() }
    }

    fn suppress_around(&mut self, index: usize, balls: &FittingBalls) {
        let around = |at: usize| at.saturating_sub(REACHED_CELLS)..(at + REACHED_CELLS + 1).min(SIDE);
        let (columns, rows) = (around(index % SIDE), around(index % CELLS / SIDE));
        let selected = balls.ball(index);
        let square = |distance: f64| (distance * distance) as usize;
        let of_radius: [usize; RADII] =
            std::array::from_fn(|radius| square(selected.r - balls.ball(radius * CELLS + index % CELLS).r));
        for row in rows {
            for column in columns.clone() {
                self.is_stale[row / BLOCK * BLOCKS + column / BLOCK] = true;
                let cell = row * SIDE + column;
                let near = balls.ball(cell);
                let of_place = square(selected.x - near.x) + square(selected.y - near.y);
                if of_place >= self.suppression.len() {
                    continue;
                }
                for (radius, of_radius) in of_radius.iter().enumerate() {
                    if let Some(suppression) = self.suppression.get(of_place + of_radius) {
                        self.logits[radius * CELLS + cell] -= suppression;
                    }
                }
            }
        }
    }
}

/// Returns, for each of the 64 x 64 cells, row 0 at the bottom, the probability that the best valid ball there solves
/// the scene; 0 where no ball is valid. `None` if no logit is finite.
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

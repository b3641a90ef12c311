//! The solve map shows where a ball of one radius solves a scene. It takes one rollout for each of 64 x 64 cells,
//! coarse to fine.
//!
//! Every eighth cell across and up is tried first, then every fourth, every second and every one, so that a coarse map
//! is available at once and becomes finer (progressive refinement). An untried cell has the outcome of the smallest
//! block around it that was tried. Used by the page's worker, which tries one cell after another and can stop between
//! any two.

use crate::puzzle::action::{Ball, Invalid, RADIUS};
use crate::puzzle::scene::Scene;
use crate::raster::{CELLS, SIDE, cell_centre};
use crate::simulator::outcome;

/// Side lengths, in cells, of the blocks in which one cell is tried, from the coarsest round to the finest.
const STRIDES: [usize; 4] = [8, 4, 2, 1];

/// The outcome of a ball at the centre of a cell. The page receives these numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum CellOutcome {
    /// No ball was tried there yet.
    Untried = 0,
    /// A ball there is invalid.
    Invalid = 1,
    /// The ball does not solve the scene.
    NotSolved = 2,
    /// The ball solves the scene.
    Solved = 3,
}

/// A solve map, as far as it has been computed.
pub struct SolveMap {
    scene: Scene,
    radius: f64,
    cells: Vec<CellOutcome>,
    /// All cells in the order of trial.
    order: Vec<usize>,
    tried: usize,
}

impl SolveMap {
    /// Creates a map in which no cell has been tried.
    ///
    /// # Errors
    ///
    /// If the radius is outside `RADIUS`.
    pub fn new(scene: Scene, radius: f64) -> Result<SolveMap, Invalid> {
        if !RADIUS.contains(&radius) {
            return Err(Invalid::Radius);
        }
        let mut order = Vec::with_capacity(CELLS);
        for (round, stride) in STRIDES.into_iter().enumerate() {
            let done = |cell: usize| round > 0 && block(cell, STRIDES[round - 1]) == cell;
            order.extend((0..CELLS).filter(|&cell| block(cell, stride) == cell && !done(cell)));
        }
        Ok(SolveMap { scene, radius, cells: vec![CellOutcome::Untried; CELLS], order, tried: 0 })
    }

    /// Returns the ball to try in a cell: at the cell's centre, px.
    pub fn ball(&self, cell: usize) -> Ball {
        let [x, y] = cell_centre(cell);
        Ball { x, y, r: self.radius }
    }

    /// Tries the next cell. Returns `false` if all have been tried.
    pub fn advance(&mut self) -> bool {
        let Some(&cell) = self.order.get(self.tried) else { return false };
        self.cells[cell] = match outcome(&self.scene, Some(self.ball(cell))) {
            Err(_) => CellOutcome::Invalid,
            Ok(outcome) if outcome.solved => CellOutcome::Solved,
            Ok(_) => CellOutcome::NotSolved,
        };
        self.tried += 1;
        true
    }

    /// Returns the fraction of the cells that have been tried, 0..=1.
    pub fn progress(&self) -> f64 {
        self.tried as f64 / CELLS as f64
    }

    /// Returns the known outcome of each cell, row 0 at the bottom; an untried cell has that of its block.
    pub fn outcomes(&self) -> Vec<CellOutcome> {
        let known = |cell| {
            let blocks = STRIDES.iter().rev().map(|&stride| self.cells[block(cell, stride)]);
            blocks.into_iter().find(|&outcome| outcome != CellOutcome::Untried).unwrap_or(CellOutcome::Untried)
        };
        (0..CELLS).map(known).collect()
    }
}

/// Returns the lower left cell of the block around a cell; `stride` is the side of the block, cells.
fn block(cell: usize, stride: usize) -> usize {
    let corner = |index: usize| index - index % stride;
    corner(cell / SIDE) * SIDE + corner(cell % SIDE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::Task;
    use crate::simulator::simulate;

    fn map(radius: f64) -> SolveMap {
        let task = Task::load("00000:000".parse().expect("an id")).expect("a task");
        SolveMap::new(task.scene, radius).expect("a radius that a ball may have")
    }

    #[test]
    fn every_cell_is_tried_once_and_the_coarse_ones_first() {
        let map = map(10.0);
        let mut cells = map.order.clone();
        cells.sort_unstable();
        assert_eq!(cells, (0..CELLS).collect::<Vec<_>>());
        assert!(map.order[..64].iter().all(|&cell| block(cell, 8) == cell));
        assert!(map.order[CELLS / 4..].iter().all(|cell| cell % 2 == 1 || cell / SIDE % 2 == 1));
    }

    #[test]
    fn a_cell_has_the_outcome_of_its_ball() {
        let mut map = map(30.0);
        assert!(map.outcomes().iter().all(|&outcome| outcome == CellOutcome::Untried));
        while map.tried < 256 {
            assert!(map.advance());
        }
        assert_eq!(map.progress(), 256.0 / CELLS as f64);
        let outcomes = map.outcomes();
        assert!(!outcomes.contains(&CellOutcome::Untried), "coarse blocks cover the scene");
        // A ball of radius 30 in a corner sticks out.
        assert_eq!(outcomes[0], CellOutcome::Invalid);
        for &cell in &map.order[..256] {
            let expected = match simulate(&map.scene, Some(map.ball(cell))).map(|rollout| rollout.solved) {
                Err(_) => CellOutcome::Invalid,
                Ok(false) => CellOutcome::NotSolved,
                Ok(true) => CellOutcome::Solved,
            };
            assert_eq!(outcomes[cell], expected, "cell {cell}");
        }
    }

    #[test]
    fn the_last_cell_ends_it() {
        // Balls so large that almost none are valid, so that this takes little time.
        let mut map = map(32.0);
        map.tried = CELLS - 1;
        assert!(map.advance());
        assert!(!map.advance());
        assert_eq!(map.progress(), 1.0);
    }

    #[test]
    fn a_radius_out_of_range_is_refused() {
        for radius in [0.0, 1.9, 33.0, f64::NAN, f64::INFINITY] {
            let task = Task::load("00000:000".parse().expect("an id")).expect("a task");
            assert_eq!(SolveMap::new(task.scene, radius).err(), Some(Invalid::Radius), "{radius}");
        }
    }
}

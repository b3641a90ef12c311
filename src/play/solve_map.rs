//! Where a ball of one radius solves a scene: one rollout for each of 64 x 64 cells, coarse to fine.
//!
//! First every eighth cell across and up is tried, then every fourth, every second and every one, so that a
//! rough picture is there at once and grows sharper. A cell that has not been tried yet shows what is known of
//! the coarser block it lies in. Used by the page's worker, which asks for one cell after another and may stop
//! between any two.

use crate::puzzle::action::{Ball, Invalid, RADIUS};
use crate::puzzle::scene::{SIZE, Scene};
use crate::raster::{CELLS, SIDE};
use crate::simulator::simulate;

/// Cells between two that are tried, from the coarsest round to the finest.
const STRIDES: [usize; 4] = [8, 4, 2, 1];

/// What a ball that starts in a cell comes to. The numbers are those that the page is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u8)]
pub enum Outcome {
    Untried = 0,
    Invalid = 1,
    NotSolved = 2,
    Solved = 3,
}

pub struct SolveMap {
    scene: Scene,
    radius: f64,
    cells: Vec<Outcome>,
    /// All cells in the order in which they are tried.
    order: Vec<usize>,
    tried: usize,
}

impl SolveMap {
    /// A map on which nothing has been tried.
    ///
    /// # Errors
    /// Refuses a radius that no ball has.
    pub fn new(scene: Scene, radius: f64) -> Result<SolveMap, Invalid> {
        if !RADIUS.contains(&radius) {
            return Err(Invalid::Radius);
        }
        let mut order = Vec::with_capacity(CELLS);
        for (round, stride) in STRIDES.into_iter().enumerate() {
            let done = |cell: usize| round > 0 && block(cell, STRIDES[round - 1]) == cell;
            order.extend((0..CELLS).filter(|&cell| block(cell, stride) == cell && !done(cell)));
        }
        Ok(SolveMap { scene, radius, cells: vec![Outcome::Untried; CELLS], order, tried: 0 })
    }

    /// The ball that is tried in a cell: at its middle, in px.
    pub fn ball(&self, cell: usize) -> Ball {
        let middle = |index: usize| (index as f64 + 0.5) * SIZE / SIDE as f64;
        Ball { x: middle(cell % SIDE), y: middle(cell / SIDE), r: self.radius }
    }

    /// Tries the next cell; `false` once all have been tried.
    pub fn advance(&mut self) -> bool {
        let Some(&cell) = self.order.get(self.tried) else { return false };
        self.cells[cell] = match simulate(&self.scene, Some(self.ball(cell))) {
            Err(_) => Outcome::Invalid,
            Ok(rollout) if rollout.solved => Outcome::Solved,
            Ok(_) => Outcome::NotSolved,
        };
        self.tried += 1;
        true
    }

    /// Share of the cells that have been tried, 0..=1.
    pub fn progress(&self) -> f64 {
        self.tried as f64 / CELLS as f64
    }

    /// What is known so far: an outcome for each cell, row 0 at the bottom; coarse where not tried yet.
    pub fn picture(&self) -> Vec<Outcome> {
        let known = |cell| {
            let blocks = STRIDES.iter().rev().map(|&stride| self.cells[block(cell, stride)]);
            blocks.into_iter().find(|&outcome| outcome != Outcome::Untried).unwrap_or(Outcome::Untried)
        };
        (0..CELLS).map(known).collect()
    }
}

/// The lower left cell of the block of so many cells across that a cell lies in.
fn block(cell: usize, stride: usize) -> usize {
    let corner = |index: usize| index - index % stride;
    corner(cell / SIDE) * SIDE + corner(cell % SIDE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::Task;

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
    fn a_cell_says_what_its_ball_comes_to() {
        let mut map = map(30.0);
        assert!(map.picture().iter().all(|&outcome| outcome == Outcome::Untried));
        while map.tried < 256 {
            assert!(map.advance());
        }
        assert_eq!(map.progress(), 256.0 / CELLS as f64);
        let picture = map.picture();
        assert!(!picture.contains(&Outcome::Untried), "coarse blocks cover the scene");
        // A ball of radius 30 in a corner sticks out.
        assert_eq!(picture[0], Outcome::Invalid);
        for &cell in &map.order[..256] {
            let solved = simulate(&map.scene, Some(map.ball(cell))).map(|rollout| rollout.solved);
            let told = [Outcome::Invalid, Outcome::NotSolved, Outcome::Solved][solved.map_or(0, |s| 1 + s as usize)];
            assert_eq!(picture[cell], told, "cell {cell}");
        }
    }

    #[test]
    fn the_last_cell_ends_it() {
        // Balls so large that nearly none may be placed, so that this takes no time.
        let mut map = map(32.0);
        map.tried = CELLS - 1;
        assert!(map.advance());
        assert!(!map.advance());
        assert_eq!(map.progress(), 1.0);
    }

    #[test]
    fn a_radius_that_no_ball_has_is_refused() {
        for radius in [0.0, 1.9, 33.0, f64::NAN, f64::INFINITY] {
            let task = Task::load("00000:000".parse().expect("an id")).expect("a task");
            assert_eq!(SolveMap::new(task.scene, radius).err(), Some(Invalid::Radius), "{radius}");
        }
    }
}

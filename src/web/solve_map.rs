//! The search for all solutions of one radius, for the worker: one cell per call, so that it can stop in between.

use wasm_bindgen::prelude::*;

use super::error::{Code, error};
use super::puzzle_from_js::load;
use crate::search::solve_map;

/// A map of 64 x 64 cells of one task: the outcome of a ball of this radius that starts in the cell.
#[wasm_bindgen]
pub struct SolveMap(solve_map::SolveMap);

#[wasm_bindgen]
impl SolveMap {
    /// Returns a map without outcomes. The radius is in px.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played, `invalid_ball` if the radius is
    /// not a ball's.
    #[wasm_bindgen(constructor)]
    pub fn new(
        #[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue,
        radius: f64,
    ) -> Result<SolveMap, JsValue> {
        let map = solve_map::SolveMap::new(load(puzzle)?.scene, radius);
        map.map(SolveMap).map_err(|why| error(Code::InvalidBall, why))
    }

    /// Simulates the next cell; returns false once all cells have been tried.
    pub fn advance(&mut self) -> bool {
        self.0.advance()
    }

    /// Returns the fraction of the cells that have been tried, 0..=1.
    pub fn progress(&self) -> f64 {
        self.0.progress()
    }

    /// Returns the outcomes so far, row 0 at the bottom: 0 untried, 1 invalid, 2 not solved, 3 solved.
    pub fn outcomes(&self) -> Vec<u8> {
        self.0.outcomes().into_iter().map(|outcome| outcome as u8).collect()
    }
}

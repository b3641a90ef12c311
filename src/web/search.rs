//! Searches for solutions, one ball per call, so that a worker can stop in between, and measures luck.

use wasm_bindgen::prelude::*;

use super::data::to_js;
use super::error::{Code, error};
use super::puzzle::{JsBall, JsPuzzle, ball_from, load};
use crate::search::{luck, solution_search, solve_map};

/// A map of 64 x 64 cells of one puzzle: the outcome of a ball of this radius that starts in the cell.
#[wasm_bindgen]
pub struct SolveMap(solve_map::SolveMap);

#[wasm_bindgen]
impl SolveMap {
    /// Creates a map without outcomes. The radius is in px; throws `invalid_ball` if no ball may have it.
    #[wasm_bindgen(constructor)]
    pub fn new(puzzle: JsPuzzle, radius: f64) -> Result<SolveMap, JsValue> {
        let map = solve_map::SolveMap::new(load(&puzzle)?.scene, radius);
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

/// A search for solutions of a scene over the whole action space.
#[wasm_bindgen]
pub struct SolutionSearch(solution_search::SolutionSearch);

#[wasm_bindgen]
impl SolutionSearch {
    /// Starts a search.
    #[wasm_bindgen(constructor)]
    pub fn new(puzzle: JsPuzzle) -> Result<SolutionSearch, JsValue> {
        Ok(SolutionSearch(solution_search::SolutionSearch::new(load(&puzzle)?.scene)))
    }

    /// Simulates the next valid ball; returns false once all have been tried.
    pub fn advance(&mut self) -> bool {
        self.0.advance()
    }

    /// Returns the results so far.
    #[wasm_bindgen(unchecked_return_type = "FoundSolutions")]
    pub fn found(&self) -> Result<JsValue, JsValue> {
        to_js(&self.0.found())
    }
}

/// Returns how many of the 27 balls within a pixel in x, y and radius are valid, and how many of these solve.
#[wasm_bindgen(unchecked_return_type = "Luck")]
pub fn luck(puzzle: JsPuzzle, ball: JsBall) -> Result<JsValue, JsValue> {
    to_js(&luck::luck(&load(&puzzle)?.scene, ball_from(ball)?))
}

//! Searches for solutions of a scene: tries a grid of balls over the whole action space, in an order that makes every
//! part of the search an even sample of the grid.
//!
//! Used by the page's worker, which tries one ball after another and can stop between any two.

use serde::Serialize;

use crate::benchmark::difficulty::Difficulty;
use crate::puzzle::action::{Ball, Obstacles};
use crate::puzzle::scene::{SIZE, Scene};
use crate::simulator::outcome;

/// Grid positions along x and along y, each in the middle of its 8 px.
const PLACES: usize = 32;

/// Radii of the grid, px: near the middles of four equal parts of 2..=32.
const RADII: [f64; 4] = [6.0, 13.0, 21.0, 28.0];

/// All balls of the grid, including invalid ones.
const BALLS: usize = PLACES * PLACES * RADII.len();

/// Step from one ball to the next, modulo `BALLS`: close to the golden section of `BALLS`, so that each new ball lies
/// in a gap between earlier ones (Kronecker sequence). Odd, so that every ball is reached.
const STRIDE: usize = 2531;

/// The results so far.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Found {
    /// The fraction of the balls that have been examined, 0..=1.
    pub progress: f64,
    /// Number of valid balls; all of them were simulated.
    pub valid: usize,
    /// Number of balls that solve.
    pub solved: usize,
    /// The share of the benchmark's tasks that are harder, judged by the share of valid balls that solve, 0..=1; `None`
    /// without a valid ball.
    pub rank: Option<f64>,
    /// The solving ball with the most solving neighbours in the grid; `None` if no ball solves.
    pub easiest: Option<Ball>,
    /// Whether the scene solves itself without a ball.
    pub solves_itself: bool,
}

/// A search for the balls that solve a scene, ball by ball.
pub struct SolutionSearch {
    scene: Scene,
    obstacles: Obstacles,
    difficulty: Difficulty,
    /// Whether each ball of the grid solves; `None` if it is invalid or has not been tried.
    solves: Vec<Option<bool>>,
    looked_at: usize,
    solves_itself: bool,
}

impl SolutionSearch {
    /// Creates a search in which only the scene without a ball has been tried.
    pub fn new(scene: Scene) -> SolutionSearch {
        let solves_itself = outcome(&scene, None).is_ok_and(|outcome| outcome.solved);
        let obstacles = Obstacles::new(&scene);
        SolutionSearch {
            scene,
            obstacles,
            difficulty: Difficulty::shipped(),
            solves: vec![None; BALLS],
            looked_at: 0,
            solves_itself,
        }
    }

    /// Tries the next valid ball. Returns `false` if all have been tried.
    pub fn advance(&mut self) -> bool {
        while self.looked_at < BALLS {
            let index = self.looked_at * STRIDE % BALLS;
            self.looked_at += 1;
            let ball = ball(index);
            if self.obstacles.check(&ball).is_ok() {
                self.solves[index] = outcome(&self.scene, Some(ball)).ok().map(|outcome| outcome.solved);
                return true;
            }
        }
        false
    }

    /// Returns the results so far.
    pub fn found(&self) -> Found {
        let valid = self.solves.iter().flatten().count();
        let solved = self.solves.iter().flatten().filter(|&&solves| solves).count();
        Found {
            progress: self.looked_at as f64 / BALLS as f64,
            valid,
            solved,
            rank: (valid > 0).then(|| self.difficulty.rank(solved as f64 / valid as f64)),
            easiest: self.easiest(),
            solves_itself: self.solves_itself,
        }
    }

    /// Returns the solving ball with the most solving neighbours; the first if several are equal.
    fn easiest(&self) -> Option<Ball> {
        let solving = (0..BALLS).filter(|&index| self.solves[index] == Some(true));
        let solving_neighbours =
            |&index: &usize| neighbours(index).filter(|&neighbour| self.solves[neighbour] == Some(true)).count();
        // `max_by_key` returns the last of equals, which in reverse order is the first.
        solving.rev().max_by_key(solving_neighbours).map(ball)
    }
}

/// Returns the coordinates of a ball in the grid: column, row and radius.
fn coordinates(index: usize) -> [usize; 3] {
    [index % PLACES, index / PLACES % PLACES, index / (PLACES * PLACES)]
}

fn ball(index: usize) -> Ball {
    let [column, row, radius] = coordinates(index);
    let place = |step: usize| (step as f64 + 0.5) * SIZE / PLACES as f64;
    Ball { x: place(column), y: place(row), r: RADII[radius] }
}

/// Returns the up to 26 balls around one in the grid.
fn neighbours(index: usize) -> impl Iterator<Item = usize> {
    let [column, row, radius] = coordinates(index);
    let near = |at: usize, end: usize| at.saturating_sub(1)..=(at + 1).min(end - 1);
    near(radius, RADII.len())
        .flat_map(move |radius| near(row, PLACES).map(move |row| [row, radius]))
        .flat_map(move |[row, radius]| {
            near(column, PLACES).map(move |column| (radius * PLACES + row) * PLACES + column)
        })
        .filter(move |&neighbour| neighbour != index)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::Task;
    use crate::simulator::simulate;

    fn scene(id: &str) -> Scene {
        Task::load(id.parse().expect("an id")).expect("a task").scene
    }

    #[test]
    fn every_ball_of_the_grid_has_its_turn_once() {
        let mut order: Vec<usize> = (0..BALLS).map(|turn| turn * STRIDE % BALLS).collect();
        order.sort_unstable();
        assert_eq!(order, (0..BALLS).collect::<Vec<_>>());
        assert_eq!([neighbours(0).count(), neighbours(PLACES * PLACES + PLACES + 1).count()], [7, 26]);
    }

    #[test]
    fn it_counts_what_the_simulator_says() {
        let scene = scene("00000:000");
        let mut search = SolutionSearch::new(scene.clone());
        for _ in 0..200 {
            assert!(search.advance());
        }
        let found = search.found();
        let tried: Vec<Ball> = (0..search.looked_at).map(|turn| ball(turn * STRIDE % BALLS)).collect();
        let rollouts: Vec<bool> =
            tried.iter().filter_map(|&ball| Some(simulate(&scene, Some(ball)).ok()?.solved)).collect();
        assert_eq!((found.valid, found.solved), (200, rollouts.iter().filter(|&&solved| solved).count()));
        assert_eq!(rollouts.len(), 200);
        assert!(found.progress < 0.1 && !found.solves_itself);
    }

    #[test]
    fn the_easiest_ball_has_the_most_solving_neighbours() {
        let mut search = SolutionSearch::new(scene("00000:000"));
        assert_eq!(search.found().easiest, None);
        let middle = PLACES * PLACES + 9 * PLACES + 9;
        for index in [3, middle - 1, middle, middle + 1, BALLS - 1] {
            search.solves[index] = Some(true);
        }
        assert_eq!(search.found().easiest, Some(ball(middle)));
    }
}

//! Finds the balls that fit into a scene among those that the success net scores, one for each radius and cell.
//!
//! Where a ball fits, every smaller one fits too. So it is enough to count the radii that fit on each cell, and one
//! clearance per cell determines that count. Used by `ranking`.

use crate::nets::success_net::{RADII, ball_at};
use crate::puzzle::action::{Ball, Obstacles, overlaps};
use crate::puzzle::scene::Scene;
use crate::raster::{CELLS, SIDE};

/// The valid balls among those that the success net scores, each identified by the index of its logit.
pub(crate) struct FittingBalls {
    /// The number of radii that fit, for each cell.
    counts: Vec<usize>,
    /// x of the balls in a column, and y of those in a row, px; NaN where no ball fits into any scene.
    coordinates: [f64; SIDE],
    /// Ascending, px.
    radii: [f64; RADII],
}

impl FittingBalls {
    pub(crate) fn new(scene: &Scene) -> FittingBalls {
        let obstacles = Obstacles::new(scene);
        // x and y follow the same rule, so the balls on the diagonal of an empty scene determine both.
        let nothing = Obstacles::default();
        let placed =
            |index: usize, radius: usize| nothing.place(ball_at(radius * CELLS + index * SIDE + index).action()).ok();
        let all: [usize; RADII] = std::array::from_fn(|radius| radius);
        let inside: [usize; SIDE] =
            std::array::from_fn(|index| all.partition_point(|&radius| placed(index, radius).is_some()));
        let coordinates: [f64; SIDE] = std::array::from_fn(|index| placed(index, 0).map_or(f64::NAN, |ball| ball.x));
        let radii = all.map(|radius| placed(SIDE / 2, radius).map_or(f64::NAN, |ball| ball.r));
        let count = |cell: usize| {
            let column = cell % SIDE;
            let row = cell / SIDE;
            let inside = &radii[..inside[column].min(inside[row])];
            let Some(&largest) = inside.last() else { return 0 };
            let clearance = obstacles.clearance([coordinates[column], coordinates[row]], largest);
            inside.partition_point(|&radius| !overlaps(clearance, radius))
        };
        FittingBalls { counts: (0..CELLS).map(count).collect(), coordinates, radii }
    }

    /// Returns how many radii fit on a cell. These are the smallest ones.
    pub(crate) fn count(&self, cell: usize) -> usize {
        self.counts[cell]
    }

    /// Returns the ball of a logit. It is valid if its radius is among those that fit on its cell.
    pub(crate) fn ball(&self, index: usize) -> Ball {
        let (radius, cell) = (index / CELLS, index % CELLS);
        Ball { x: self.coordinates[cell % SIDE], y: self.coordinates[cell / SIDE], r: self.radii[radius] }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::{Task, ids};
    use crate::puzzle::templates::TEMPLATES;

    /// Compares with the rule for all actions, for one task of each template and every ball that the success net
    /// scores.
    #[test]
    fn the_balls_that_fit_are_those_that_their_actions_place() {
        for (number, template) in TEMPLATES.iter().enumerate() {
            let id = ids(template).nth(4 * number).expect("a hundred tasks");
            let scene = Task::load(id).expect("an id of the template").scene;
            let balls = FittingBalls::new(&scene);
            let obstacles = Obstacles::new(&scene);
            for index in 0..RADII * CELLS {
                let placed = obstacles.place(ball_at(index).action()).ok();
                let fits = index / CELLS < balls.count(index % CELLS);
                assert_eq!(fits.then(|| balls.ball(index)), placed, "{id}, {index}");
            }
        }
    }
}

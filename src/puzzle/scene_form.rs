//! Checks that a scene has the form that simulation and images rely on: finite numbers, and convex shapes.
//!
//! The templates' scenes and custom scenes within their limits have this form. A scene that is built by a caller or
//! sent by a program is checked before it is used.

use super::scene::{Body, Role, Scene, Shape};

/// Largest coordinate, length or angle, px and radians: far outside any scene.
pub const FARTHEST: f64 = 1e4;

/// Smallest radius of a circle and length of an edge, px. Smaller shapes have almost no mass in single precision.
pub const SMALLEST: f64 = 0.1;

/// Largest number of corners of a polygon (Box2D's b2_maxPolygonVertices).
pub const MAX_CORNERS: usize = 8;

/// Smallest sine of the angle by which the outline of a polygon turns at a corner. rapier drops corners that turn by
/// less than 1.5 degrees, a sine of 0.026, in single precision; the difference is a margin for its rounding.
const LEAST_TURN: f64 = 0.05;

/// Why a scene cannot be simulated. Bodies are identified by their indices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[allow(missing_docs, reason = "the messages say it")]
pub enum FormFault {
    #[error("`body1` and `body2` of the scene are the indices of two of its bodies, from 0: correct them")]
    Goal,
    #[error(
        "body {0} of the scene has the wrong role: `body1` is green and dynamic, `body2` blue if dynamic and \
         purple if not, every other body gray if dynamic and black if not"
    )]
    Role(usize),
    #[error("body {0} of the scene has no shape: give it circles or polygons")]
    NoShape(usize),
    #[error("body {0} of the scene has a number beyond ±{FARTHEST}: lengths are px, angles are radians")]
    Number(usize),
    #[error(
        "body {0} of the scene has an invalid shape: a circle has a radius of at least {SMALLEST} px, a polygon is convex, with three \
         to {MAX_CORNERS} corners counter-clockwise and at least {SMALLEST} px from one another"
    )]
    Shape(usize),
}

impl Scene {
    /// Checks the form of the scene.
    ///
    /// # Errors
    /// The first fault found.
    pub fn check_form(&self) -> Result<(), FormFault> {
        if self.body1 == self.body2 || self.body1.max(self.body2) >= self.bodies.len() {
            return Err(FormFault::Goal);
        }
        for (index, body) in self.bodies.iter().enumerate() {
            if body.role != self.role_of(index) || (index == self.body1 && !body.dynamic) {
                return Err(FormFault::Role(index));
            }
            check_body(index, body)?;
        }
        Ok(())
    }

    /// Returns the role that a body must have, which nets see, given the goal that is simulated.
    fn role_of(&self, index: usize) -> Role {
        match (index, self.bodies[index].dynamic) {
            (body, _) if body == self.body1 => Role::Green,
            (body, true) if body == self.body2 => Role::Blue,
            (body, false) if body == self.body2 => Role::Purple,
            (_, true) => Role::Gray,
            (_, false) => Role::Black,
        }
    }
}

fn check_body(index: usize, body: &Body) -> Result<(), FormFault> {
    let is_near = |number: &f64| number.abs() <= FARTHEST;
    let lengths_are_near = |shape: &Shape| match shape {
        Shape::Circle(radius) => is_near(radius),
        Shape::Polygon(corners) => corners.as_flattened().iter().all(is_near),
    };
    let is_shape = |shape: &Shape| match shape {
        Shape::Circle(radius) => *radius >= SMALLEST,
        Shape::Polygon(corners) => is_convex(corners),
    };
    if body.shapes.is_empty() {
        Err(FormFault::NoShape(index))
    } else if ![body.x, body.y, body.angle].iter().all(is_near) || !body.shapes.iter().all(lengths_are_near) {
        Err(FormFault::Number(index))
    } else if !body.shapes.iter().all(is_shape) {
        Err(FormFault::Shape(index))
    } else {
        Ok(())
    }
}

/// Returns whether the outline has three to `MAX_CORNERS` corners and turns left at each, once around in total.
fn is_convex(corners: &[[f64; 2]]) -> bool {
    let edge = |index: usize| {
        let ([x, y], [u, v]) = (corners[index], corners[(index + 1) % corners.len()]);
        [u - x, v - y]
    };
    let squared = |[x, y]: [f64; 2]| x * x + y * y;
    let mut rounds = 0;
    for index in 0..corners.len() {
        let (before, after) = (edge(index), edge((index + 1) % corners.len()));
        let cross = before[0] * after[1] - before[1] * after[0];
        let is_left = cross > 0.0 && cross * cross >= LEAST_TURN * LEAST_TURN * squared(before) * squared(after);
        if squared(before) < SMALLEST * SMALLEST || !is_left {
            return false;
        }
        // In an outline with only left turns, each round turns from downwards to upwards once.
        let is_upwards = |[x, y]: [f64; 2]| y > 0.0 || (y == 0.0 && x > 0.0);
        rounds += usize::from(!is_upwards(before) && is_upwards(after));
    }
    rounds == 1 && corners.len() <= MAX_CORNERS
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::Task;
    use crate::puzzle::templates::TEMPLATES;

    fn scene() -> Scene {
        Task::load("00007:008".parse().expect("an id")).expect("a task").scene
    }

    /// Returns the fault of a scene whose first body has this shape.
    fn fault(shape: Shape) -> Option<FormFault> {
        let mut scene = scene();
        scene.bodies[0].shapes = vec![shape];
        scene.check_form().err()
    }

    #[test]
    fn every_task_has_the_form() {
        for task in TEMPLATES.into_iter().flat_map(Task::of) {
            assert_eq!(task.scene.check_form(), Ok(()), "{}", task.id);
        }
    }

    #[test]
    fn a_goal_that_is_no_pair_of_bodies_is_refused() {
        for (body1, body2) in [(0, 0), (0, 1000), (usize::MAX, 0)] {
            assert_eq!(Scene { body1, body2, ..scene() }.check_form(), Err(FormFault::Goal));
        }
    }

    #[test]
    fn roles_are_those_that_the_goal_gives() {
        let Scene { body1, body2, .. } = scene();
        for (body, role) in [(body1, Role::Gray), (body2, Role::Black), (body2, Role::Red)] {
            let mut wrong = scene();
            wrong.bodies[body].role = role;
            assert_eq!(wrong.check_form(), Err(FormFault::Role(body)));
        }
        let other = (0..).find(|&body| body != body1 && body != body2).expect("a number");
        let moved = Scene { body2: other, ..scene() };
        assert!(matches!(moved.check_form(), Err(FormFault::Role(_))));
        let mut still = scene();
        still.bodies[body1].dynamic = false;
        assert_eq!(still.check_form(), Err(FormFault::Role(body1)));
    }

    #[test]
    fn shapes_are_circles_or_convex_polygons() {
        let triangle = [[0.0, 0.0], [10.0, 0.0], [0.0, 10.0]];
        let polygon = |corners: &[[f64; 2]]| fault(Shape::Polygon(corners.to_vec()));
        assert_eq!(polygon(&triangle), None);
        let [a, b, c] = triangle;
        let star: Vec<[f64; 2]> =
            [0.0, 4.0, 8.0, 12.0, 16.0].map(|fifth: f64| [libm::cos(fifth * 0.314), libm::sin(fifth * 0.314)]).to_vec();
        let pentagram: Vec<[f64; 2]> = [0, 2, 4, 1, 3].map(|corner| star[corner].map(|part| 10.0 * part)).to_vec();
        let wrong: [&[[f64; 2]]; 9] = [
            &[],
            &[a, b],
            &[c, b, a],
            &[a, b, b, c],
            &[a, [5.0, 0.0], b, c],
            &[a, b, [1.0, 1.0], c],
            &[[0.0, 0.0], [0.01, 0.0], [0.0, 0.01]],
            &[[256.0, 54.0], [36.0, 48.19], [48.0, 48.21]],
            &pentagram,
        ];
        for corners in wrong {
            assert_eq!(polygon(corners), Some(FormFault::Shape(0)), "{corners:?}");
        }
        assert_eq!(fault(Shape::Circle(-1.0)), Some(FormFault::Shape(0)));
        let regular = |corners: usize| {
            let angle = |index| std::f64::consts::TAU * index as f64 / corners as f64;
            polygon(&(0..corners).map(|index| [libm::cos(angle(index)), libm::sin(angle(index))]).collect::<Vec<_>>())
        };
        assert_eq!((regular(MAX_CORNERS), regular(MAX_CORNERS + 1)), (None, Some(FormFault::Shape(0))));
        for number in [f64::NAN, f64::INFINITY, 2e4] {
            assert_eq!(fault(Shape::Circle(number)), Some(FormFault::Number(0)));
            assert_eq!(polygon(&[a, b, [0.0, number]]), Some(FormFault::Number(0)));
        }
        let mut empty = scene();
        empty.bodies[1].shapes.clear();
        assert_eq!(empty.check_form(), Err(FormFault::NoShape(1)));
    }
}

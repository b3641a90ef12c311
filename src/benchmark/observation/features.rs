//! PHYRE's features of an object: 14 numbers that describe it and its pose.
//!
//! | index | feature |
//! | --- | --- |
//! | 0, 1 | x and y of the centre, in widths of the scene; for a jar, of the centre of mass |
//! | 2 | angle, in turns, 0..1 |
//! | 3 | diameter, in widths of the scene |
//! | 4..8 | shape, one-hot: ball, bar, jar, standing sticks |
//! | 8..14 | colour, one-hot: red, green, blue, purple, gray, black |
//!
//! Every rounding is PHYRE's, to f32 at each step, with correctly rounded sine and cosine.

use std::f64::consts::TAU;

use super::colour_codes::colour_code;
use crate::puzzle::dimensions::{Dimensions, JAR_BASE, JAR_HEIGHT_PER_WIDTH, THICKNESS};
use crate::puzzle::scene::{Body, Role, SIZE, Shape, ShapeType};

/// Number of features of an object.
pub const FEATURES: usize = 14;

/// Index of the first feature of the shape.
const SHAPE: usize = 4;

/// Index of the first feature of the colour.
const COLOUR: usize = 8;

/// Largest diameter of a body made from features, px.
const LARGEST: f64 = 4.0 * SIZE;

/// Length of the two sticks, in multiples of the width from which PHYRE computes their diameter.
const STICK_PER_WIDTH: f64 = 2.0 / 3.0;

/// The width of a jar over its height in PHYRE's diameter, which runs from an upper corner to the opposite lower one.
const JAR_SPREAD: f64 = (1.0 + JAR_BASE) / 2.0 / JAR_HEIGHT_PER_WIDTH;

/// Features that do not describe an object.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs, reason = "the messages say it")]
pub enum BadFeatures {
    #[error("the features of an object must be finite numbers")]
    NotFinite,
    #[error("only a ball can be red: red is the colour of the action")]
    RedShape,
    #[error("feature 3, the diameter in widths of the scene, must be above {least} px and at most {LARGEST} px here")]
    Diameter { least: f64 },
}

/// The features of a body that do not depend on its pose, and its centre.
pub struct ObjectFeatures {
    /// The features of the body at the origin.
    constant: [f32; FEATURES],
    /// Distance from the origin up to the centre, in the frame of the body, px; 0 except for a jar.
    centre: f64,
}

impl ObjectFeatures {
    /// Returns the features of a body; `None` if its shape is not one of PHYRE's.
    pub fn of(body: &Body) -> Option<ObjectFeatures> {
        let mut constant = [0.0; FEATURES];
        let diameter = diameter(Dimensions::of(body)?) as f32;
        constant[3] = diameter / SIZE as f32;
        constant[SHAPE + body.shape_type as usize] = 1.0;
        constant[COLOUR + usize::from(colour_code(body.role)) - 1] = 1.0;
        let centre = match body.shape_type {
            ShapeType::Jar => jar_centre(diameter.into()),
            ShapeType::Ball | ShapeType::Bar | ShapeType::StandingSticks => 0.0,
        };
        Some(ObjectFeatures { constant, centre })
    }

    /// Returns all features of the body at a pose: x and y of its origin, px, and its angle, radians.
    pub fn at(&self, [x, y, angle]: [f64; 3]) -> [f32; FEATURES] {
        let mut features = self.constant;
        let turns = (f64::from(wrapped(angle as f32)) / TAU) as f32;
        let shift = shift(turns, self.centre);
        let [x, y] = [x, y].map(|coordinate| coordinate as f32 / SIZE as f32);
        features[..3].copy_from_slice(&[moved(x, shift[0]), moved(y, shift[1]), turns]);
        features
    }

    /// Returns the centre of the body at a pose, px, as in the first two features.
    pub fn centre_at(&self, [x, y, angle]: [f64; 3]) -> [f64; 2] {
        [x - self.centre * libm::sin(angle), y + self.centre * libm::cos(angle)]
    }
}

/// Returns the body that has these features.
///
/// # Errors
///
/// If no body has them.
pub fn body_of(features: &[f32; FEATURES]) -> Result<Body, BadFeatures> {
    if !features.iter().all(|value| value.is_finite()) {
        return Err(BadFeatures::NotFinite);
    }
    let shape_type =
        [ShapeType::Ball, ShapeType::Bar, ShapeType::Jar, ShapeType::StandingSticks][largest(&features[SHAPE..COLOUR])];
    let role =
        [Role::Red, Role::Green, Role::Blue, Role::Purple, Role::Gray, Role::Black][largest(&features[COLOUR..])];
    let diameter = f64::from(features[3]) * SIZE;
    let least = match shape_type {
        ShapeType::Ball => 0.0,
        ShapeType::Bar | ShapeType::StandingSticks => THICKNESS,
        // The walls of a smaller jar would have no thickness.
        ShapeType::Jar => libm::sqrt(1.0 + JAR_SPREAD * JAR_SPREAD),
    };
    if diameter <= least || diameter > LARGEST {
        return Err(BadFeatures::Diameter { least });
    }
    let length = || libm::sqrt(diameter * diameter - THICKNESS * THICKNESS);
    let dimensions = match (shape_type, role) {
        (ShapeType::Ball, Role::Red) => Dimensions::Ball { radius: diameter / 2.0 },
        (_, Role::Red) => return Err(BadFeatures::RedShape),
        (ShapeType::Ball, _) => Dimensions::Ball { radius: (diameter / 2.0 - 0.5).trunc() + 0.5 },
        (ShapeType::Bar, _) => Dimensions::Bar { length: length(), thickness: THICKNESS },
        (ShapeType::StandingSticks, _) => Dimensions::StandingSticks { length: length() * STICK_PER_WIDTH },
        (ShapeType::Jar, _) => Dimensions::Jar { height: jar_height(diameter) },
    };
    let centre = if shape_type == ShapeType::Jar { jar_centre(diameter) } else { 0.0 };
    let turns = features[2];
    let shift = shift(turns, -centre);
    let [x, y] = [0, 1].map(|axis| f64::from(moved(features[axis], shift[axis])) * SIZE);
    let angle = f64::from(turns) * 360.0 / 180.0 * std::f64::consts::PI;
    let dynamic = !matches!(role, Role::Purple | Role::Black);
    Ok(Body { x, y, angle, dynamic, shape_type, role, shapes: dimensions.shapes() })
}

/// Returns PHYRE's diameter of a shape, px.
fn diameter(dimensions: Dimensions) -> f64 {
    let diagonal = |a: f64, b: f64| libm::sqrt(a * a + b * b);
    match dimensions {
        Dimensions::Ball { radius } => 2.0 * radius,
        Dimensions::Bar { length, thickness } => diagonal(length, thickness),
        Dimensions::Jar { height } => diagonal(height * JAR_SPREAD, height),
        Dimensions::StandingSticks { length } => diagonal(length / STICK_PER_WIDTH, THICKNESS),
    }
}

/// Returns the height of a jar with this diameter, px.
fn jar_height(diameter: f64) -> f64 {
    libm::sqrt(diameter * diameter / (1.0 + JAR_SPREAD * JAR_SPREAD))
}

/// Returns how far the centre of mass of a jar with this diameter is above its origin, px.
fn jar_centre(diameter: f64) -> f64 {
    let (mut moment, mut area) = (0.0, 0.0);
    for shape in (Dimensions::Jar { height: jar_height(diameter) }).shapes() {
        let Shape::Polygon(corners) = shape else { continue };
        for pair in corners[1..].windows(2) {
            let [a, b, c] = [corners[0], pair[0], pair[1]];
            let doubled = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
            moment += doubled * (a[1] + b[1] + c[1]) / 3.0;
            area += doubled;
        }
    }
    moment / area
}

/// Returns the vector from the origin of a body to a point `height` (px) above it in its frame, in widths of the scene.
fn shift(turns: f32, height: f64) -> [f64; 2] {
    let angle = f64::from(turns * 2.0 * std::f32::consts::PI);
    let [sin, cos] = [libm::sin(angle), libm::cos(angle)].map(|value| f64::from(value as f32));
    [-height * sin / SIZE, height * cos / SIZE]
}

/// Returns a coordinate moved by a shift.
fn moved(coordinate: f32, shift: f64) -> f32 {
    (f64::from(coordinate) + shift) as f32
}

/// Returns an angle in 0..2π, radians.
fn wrapped(angle: f32) -> f32 {
    let rest = (f64::from(angle) % TAU) as f32;
    if rest < 0.0 { (f64::from(rest) + TAU) as f32 } else { rest }
}

/// Returns the index of the largest value; the first if several are equal.
fn largest(values: &[f32]) -> usize {
    (0..values.len()).rev().max_by(|&a, &b| values[a].total_cmp(&values[b])).expect("there are values")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::Task;
    use crate::puzzle::templates::TEMPLATES;

    #[test]
    fn the_bodies_of_all_tasks_are_found_again_from_their_features() {
        for template in TEMPLATES {
            for body in Task::of(template).flat_map(|task| task.scene.bodies) {
                let features = ObjectFeatures::of(&body).expect("PHYRE's shapes").at([body.x, body.y, body.angle]);
                let found = body_of(&features).expect("a body");
                assert_eq!((found.shape_type, found.role, found.dynamic), (body.shape_type, body.role, body.dynamic));
                assert!((found.x - body.x).abs() < 1e-4 && (found.y - body.y).abs() < 1e-4, "{body:?}");
                let [a, b] = [found.bounds(), body.bounds()];
                assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-3), "{a:?} {b:?}: {body:?}");
            }
        }
    }

    #[test]
    fn what_no_body_has_is_refused() {
        let ball = |features: &[(usize, f32)]| {
            let mut of_ball = [0.5, 0.5, 0.0, 0.1, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0];
            features.iter().for_each(|&(index, value)| of_ball[index] = value);
            body_of(&of_ball).map(|body| body.shapes)
        };
        assert_eq!(ball(&[]), Ok(vec![Shape::Circle(f64::from(0.1f32) * 128.0)]));
        assert_eq!(ball(&[(0, f32::NAN)]), Err(BadFeatures::NotFinite));
        assert_eq!(ball(&[(4, 0.0), (6, 1.0)]), Err(BadFeatures::RedShape));
        assert_eq!(ball(&[(3, -1.0)]), Err(BadFeatures::Diameter { least: 0.0 }));
    }
}

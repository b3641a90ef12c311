//! The four shapes of bodies and their adjustable lengths: the radius of a ball, the length and thickness of a bar, the
//! height of a jar, the length of standing sticks.
//!
//! Used by `layout` for templates and by `custom_scene` for the scenes that people make. Depends on `scene` only. The
//! formulas are PHYRE's (v0.2.2, `creator`).

use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

use super::scene::{Body, SIZE, Shape, ShapeType, rectangle};

/// Thickness of the benchmark's bars, px; also scales the walls of a jar and the sticks.
pub const THICKNESS: f64 = 5.12;

/// Allowed radii of balls in custom scenes, px.
pub const BALL_RADIUS: RangeInclusive<f64> = 2.0..=64.0;
/// Allowed lengths of bars, px. Static bars may stick out of the scene.
pub const BAR_LENGTH: RangeInclusive<f64> = 2.0..=512.0;
/// Allowed thicknesses of bars, px.
pub const BAR_THICKNESS: RangeInclusive<f64> = 2.0..=256.0;
/// Allowed heights of jars, px.
pub const JAR_HEIGHT: RangeInclusive<f64> = 10.0..=200.0;
/// Allowed lengths of each of the two sticks, px.
pub const STICK_LENGTH: RangeInclusive<f64> = 8.0..=200.0;

/// Angle of standing sticks from the horizontal, degrees.
pub const STICK_LEAN: f64 = 77.5;
/// Half the thickness of a stick, px.
pub const HALF_STICK: f64 = THICKNESS / 3.0;
/// Height of a jar, in multiples of the width of its rim.
pub const JAR_HEIGHT_PER_WIDTH: f64 = 1.2;
/// Width of a jar's base, in multiples of the width of its rim.
pub const JAR_BASE: f64 = 0.8;

/// Maximum rounding error of an estimated length, units in the last place.
const ROUNDING: usize = 16;

/// A kind of shape with its lengths, px. Its JSON is the key `shape` with a key for each length.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
#[serde(tag = "shape", rename_all = "snake_case")]
pub enum Dimensions {
    /// A circle. The origin is its centre.
    Ball {
        /// Radius, px.
        #[cfg_attr(not(target_arch = "wasm32"), schemars(range(min = *BALL_RADIUS.start(), max = *BALL_RADIUS.end())))]
        radius: f64,
    },
    /// A rectangle. The origin is its centre, and its length lies along x at angle 0.
    Bar {
        /// Length, px.
        #[cfg_attr(not(target_arch = "wasm32"), schemars(range(min = *BAR_LENGTH.start(), max = *BAR_LENGTH.end())))]
        length: f64,
        /// Thickness, px.
        #[cfg_attr(not(target_arch = "wasm32"), schemars(range(min = *BAR_THICKNESS.start(), max = *BAR_THICKNESS.end())))]
        thickness: f64,
    },
    /// A base and two walls that lean outwards. At the rim its width is 5/6 of the height. The origin is the middle of
    /// the base.
    Jar {
        /// Height, px.
        #[cfg_attr(not(target_arch = "wasm32"), schemars(range(min = *JAR_HEIGHT.start(), max = *JAR_HEIGHT.end())))]
        height: f64,
    },
    /// Two crossed sticks that lean 12.5 degrees from the vertical. The origin is where they cross.
    StandingSticks {
        /// Length of each stick, px.
        #[cfg_attr(not(target_arch = "wasm32"), schemars(range(min = *STICK_LENGTH.start(), max = *STICK_LENGTH.end())))]
        length: f64,
    },
}

impl Dimensions {
    /// Returns the kind of the body.
    pub fn shape_type(self) -> ShapeType {
        match self {
            Dimensions::Ball { .. } => ShapeType::Ball,
            Dimensions::Bar { .. } => ShapeType::Bar,
            Dimensions::Jar { .. } => ShapeType::Jar,
            Dimensions::StandingSticks { .. } => ShapeType::StandingSticks,
        }
    }

    /// Returns the convex shapes, in body coordinates.
    pub fn shapes(self) -> Vec<Shape> {
        match self {
            Dimensions::Ball { radius } => vec![Shape::Circle(radius)],
            Dimensions::Bar { length, thickness } => vec![rectangle(length, thickness)],
            Dimensions::Jar { height } => jar(height),
            Dimensions::StandingSticks { length } => vec![stick(length, -STICK_LEAN), stick(length, STICK_LEAN)],
        }
    }

    /// Returns the lengths: the key of each, its value, and the values allowed in custom scenes, px.
    pub fn lengths(self) -> Vec<(&'static str, f64, RangeInclusive<f64>)> {
        match self {
            Dimensions::Ball { radius } => vec![("radius", radius, BALL_RADIUS)],
            Dimensions::Bar { length, thickness } => {
                vec![("length", length, BAR_LENGTH), ("thickness", thickness, BAR_THICKNESS)]
            }
            Dimensions::Jar { height } => vec![("height", height, JAR_HEIGHT)],
            Dimensions::StandingSticks { length } => vec![("length", length, STICK_LENGTH)],
        }
    }

    /// Returns the dimensions that have exactly the shapes of a body; `None` if there are none, as for a body from
    /// another program.
    pub fn of(body: &Body) -> Option<Dimensions> {
        let has_its_shapes = |dimensions: &Dimensions| dimensions.shapes() == body.shapes;
        match (body.shape_type, body.shapes.as_slice()) {
            (ShapeType::Ball, [Shape::Circle(radius)]) => {
                Some(Dimensions::Ball { radius: *radius }).filter(has_its_shapes)
            }
            (ShapeType::Bar, [Shape::Polygon(corners)]) => {
                let [w, h] = *corners.first()?;
                Some(Dimensions::Bar { length: 2.0 * w, thickness: 2.0 * h }).filter(has_its_shapes)
            }
            (ShapeType::Jar, [_, Shape::Polygon(wall), _]) => {
                let width = -2.0 * wall.first()?[0];
                near(JAR_HEIGHT_PER_WIDTH * width).map(|height| Dimensions::Jar { height }).find(has_its_shapes)
            }
            (ShapeType::StandingSticks, [_, Shape::Polygon(stick)]) => {
                let [[x, y], [u, v]] = [stick.first()?, stick.get(1)?];
                let length = libm::hypot(x - u, y - v);
                near(length).map(|length| Dimensions::StandingSticks { length }).find(has_its_shapes)
            }
            _ => None,
        }
    }
}

/// Returns a number and its neighbours, nearest first.
fn near(number: f64) -> impl Iterator<Item = f64> {
    let above = std::iter::successors(Some(number), |number| Some(number.next_up()));
    let below = std::iter::successors(Some(number), |number| Some(number.next_down()));
    above.zip(below).take(ROUNDING).flat_map(|(above, below)| [above, below])
}

/// Returns the base and the two walls of a jar of this height, px. They overlap in the lower corners.
fn jar(height: f64) -> Vec<Shape> {
    let width = height / JAR_HEIGHT_PER_WIDTH;
    let base = JAR_BASE * width;
    let t = THICKNESS * libm::log(height) / libm::log(0.3 * SIZE);
    let lean = (width - base) / 2.0;
    let slant = libm::sqrt(height * height + lean * lean);
    // Thickness of the leaning wall: p along the base and v above it at the foot, q along the rim.
    let (p, q, v) = (t * height / slant, t * slant / height, t * lean / slant);
    let (w, b) = (width / 2.0, base / 2.0);
    let (rim, foot) = (height - t / 2.0, -t / 2.0);
    vec![
        rectangle(base, t),
        Shape::Polygon(vec![[-w, rim], [-b, foot], [-b + p, v + foot], [-w + q, rim]]),
        Shape::Polygon(vec![[w, rim], [w - q, rim], [b - p, v + foot], [b, foot]]),
    ]
}

fn stick(length: f64, degrees: f64) -> Shape {
    let (a, b) = (length / 2.0, HALF_STICK);
    let (sin, cos) = (libm::sin(radians(degrees)), libm::cos(radians(degrees)));
    let rotated = |a: f64, b: f64| [a * cos - b * sin, a * sin + b * cos];
    Shape::Polygon(vec![rotated(a, b), rotated(-a, b), rotated(-a, -b), rotated(a, -b)])
}

/// Converts degrees to radians with the same rounding as PHYRE.
pub fn radians(degrees: f64) -> f64 {
    degrees / 180.0 * std::f64::consts::PI
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;
    use crate::puzzle::scene::Role;

    fn body(dimensions: Dimensions) -> Body {
        let (shape_type, shapes) = (dimensions.shape_type(), dimensions.shapes());
        Body { x: 0.0, y: 0.0, angle: 0.0, dynamic: true, shape_type, role: Role::Gray, shapes }
    }

    #[test]
    fn shapes_of_other_bodies_have_no_dimensions() {
        let mut bent = body(Dimensions::Jar { height: 50.0 });
        bent.shapes[0] = rectangle(3.0, 3.0);
        assert_eq!(Dimensions::of(&bent), None);
        let mut two = body(Dimensions::Ball { radius: 5.0 });
        two.shapes.push(Shape::Circle(6.0));
        assert_eq!(Dimensions::of(&two), None);
        let mut empty = body(Dimensions::Bar { length: 9.0, thickness: 3.0 });
        empty.shapes = vec![Shape::Polygon(Vec::new())];
        assert_eq!(Dimensions::of(&empty), None);
    }

    proptest::proptest! {
        #[test]
        fn the_shapes_of_any_dimensions_are_found_again(length in 2.0..512.0, thickness in 2.0..256.0) {
            let all = [
                Dimensions::Ball { radius: length },
                Dimensions::Bar { length, thickness },
                Dimensions::Jar { height: length },
                Dimensions::StandingSticks { length },
            ];
            for dimensions in all {
                let body = body(dimensions);
                let found = Dimensions::of(&body).expect("dimensions");
                proptest::prop_assert_eq!(found.shapes(), body.shapes);
            }
        }
    }
}

//! Any scene from bytes: most are of shapes near enough to real ones to be simulated, some hold what no scene may.

use arbitrary::{Arbitrary, Result, Unstructured};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::scene::{Body, Role, Scene, Shape, ShapeType};

/// Most bodies. The time of a step grows with the square of those that touch.
const BODIES: usize = 8;

/// Returns a scene, and perhaps a ball.
///
/// # Errors
/// If the bytes are not enough.
pub fn from_bytes(bytes: &[u8]) -> Result<(Scene, Option<Ball>)> {
    let mut bytes = Unstructured::new(bytes);
    let bodies = (0..bytes.int_in_range(0..=BODIES)?).map(|_| body(&mut bytes)).collect::<Result<_>>()?;
    let (body1, body2) = (index(&mut bytes)?, index(&mut bytes)?);
    let ball = <Option<[u8; 3]>>::arbitrary(&mut bytes)?.map(|[x, y, r]| Ball::from([x, y, r / 8].map(f64::from)));
    Ok((Scene { body1, body2, bodies }, ball))
}

fn index(bytes: &mut Unstructured) -> Result<usize> {
    if bytes.ratio(1, 16)? { usize::arbitrary(bytes) } else { bytes.int_in_range(0..=BODIES - 1) }
}

fn body(bytes: &mut Unstructured) -> Result<Body> {
    let (x, y, angle) = (length(bytes)?, length(bytes)?, length(bytes)? / 64.0);
    let shapes = (0..bytes.int_in_range(0..=3)?).map(|_| shape(bytes)).collect::<Result<_>>()?;
    let shape_type = *bytes.choose(&[ShapeType::Ball, ShapeType::Bar, ShapeType::Jar, ShapeType::StandingSticks])?;
    let role = *bytes.choose(&[Role::Green, Role::Blue, Role::Purple, Role::Gray, Role::Black, Role::Red])?;
    Ok(Body { x, y, angle, dynamic: bool::arbitrary(bytes)?, shape_type, role, shapes })
}

fn shape(bytes: &mut Unstructured) -> Result<Shape> {
    match u8::arbitrary(bytes)? % 4 {
        0 => Ok(Shape::Circle(length(bytes)?)),
        1 => {
            let (width, height) = (length(bytes)?, length(bytes)?);
            Ok(Shape::Polygon(vec![[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]]))
        }
        2 => {
            // Corners on a circle, in order, are convex.
            let radius = length(bytes)?;
            let corners = bytes.int_in_range(3..=12)?;
            let corner = |index| {
                let (sin, cos) = libm::sincos(std::f64::consts::TAU * f64::from(index) / f64::from(corners));
                [radius * cos, radius * sin]
            };
            Ok(Shape::Polygon((0..corners).map(corner).collect()))
        }
        _ => {
            let corners = bytes.int_in_range(0..=6)?;
            Ok(Shape::Polygon((0..corners).map(|_| Ok([length(bytes)?, length(bytes)?])).collect::<Result<_>>()?))
        }
    }
}

/// A coordinate or length, px: one of a scene, one of another scale, or any number at all.
fn length(bytes: &mut Unstructured) -> Result<f64> {
    match u8::arbitrary(bytes)? {
        0 => f64::arbitrary(bytes),
        1 => Ok(f64::from(i16::arbitrary(bytes)?)),
        2 => Ok(f64::from(u16::arbitrary(bytes)?) / 8192.0),
        3 => Ok(-f64::from(u16::arbitrary(bytes)?) / 256.0),
        _ => Ok(f64::from(u16::arbitrary(bytes)?) / 256.0),
    }
}

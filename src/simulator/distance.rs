//! The distance between two bodies of a scene, as they stand there. Not part of a step.

use rapier2d::math::{Pose, Rotation, Vector};
use rapier2d::parry::query;
use rapier2d::parry::shape::SharedShape;

use crate::puzzle::scene::{Body, Shape};

/// Returns the distance between the outlines of two bodies, px; zero if they overlap.
pub fn distance(a: &Body, b: &Body) -> f64 {
    let (pose_a, pose_b, shapes_of_b) = (pose(a), pose(b), shapes(b));
    let mut nearest = f64::INFINITY;
    for shape in shapes(a) {
        for other in &shapes_of_b {
            if let Ok(found) = query::distance(&pose_a, &*shape, &pose_b, &**other) {
                nearest = nearest.min(f64::from(found.distance));
            }
        }
    }
    nearest
}

fn pose(body: &Body) -> Pose {
    let (sin, cos) = (libm::sin(body.angle) as f32, libm::cos(body.angle) as f32);
    let rotation = Rotation::from_cos_sin_unchecked(cos, sin);
    Pose { rotation, translation: Vector::new(body.x as f32, body.y as f32) }
}

/// The convex shapes of a body, px; without those that have no area.
fn shapes(body: &Body) -> Vec<SharedShape> {
    let shape = |shape: &Shape| match shape {
        Shape::Circle(radius) => Some(SharedShape::ball(*radius as f32)),
        Shape::Polygon(corners) => {
            SharedShape::convex_polyline(corners.iter().map(|&[x, y]| Vector::new(x as f32, y as f32)).collect())
        }
    };
    body.shapes.iter().filter_map(shape).collect()
}

//! Distances between bodies at given poses. Not part of a step.
//!
//! Distances are rapier's, between the surfaces as drawn: without the skin of polygons.

use rapier2d::geometry::SharedShape;
use rapier2d::math::{Pose as Frame, Rotation, Vector};
use rapier2d::parry::query::{ClosestPoints, closest_points};

use super::units::{PX_PER_METRE, metres, point_in_metres};
use crate::puzzle::rollout::Pose;
use crate::puzzle::scene::{Body, Shape};

/// The shapes of a body in rapier's form, each with its position in the frame of the body's origin.
pub(super) struct Outline(pub(super) Vec<(SharedShape, Frame)>);

impl Outline {
    pub(super) fn of(body: &Body) -> Outline {
        let part = |shape: &Shape| match shape {
            Shape::Circle(radius) => (SharedShape::ball(metres(*radius)), Frame::IDENTITY),
            Shape::Polygon(corners) => polygon(corners.iter().copied().map(point_in_metres).collect()),
        };
        Outline(body.shapes.iter().map(part).collect())
    }

    /// Returns the nearest points of this body and another at these poses, m, if they are less than `limit` apart, m;
    /// the same point twice if they overlap.
    pub(super) fn nearest_points(
        &self,
        pose: Pose,
        other: &Outline,
        other_pose: Pose,
        limit: f32,
    ) -> Option<[Vector; 2]> {
        let (frame, other_frame) = (frame(pose), frame(other_pose));
        let (mut nearest, mut limit) = (None, limit);
        for (a, b) in self.0.iter().flat_map(|a| other.0.iter().map(move |b| (a, b))) {
            let ((shape_a, local_a), (shape_b, local_b)) = (a, b);
            let (frame_a, frame_b) = (frame * *local_a, other_frame * *local_b);
            // Pairs that are farther apart than the nearest so far need not be measured exactly.
            match closest_points(&frame_a, &**shape_a, &frame_b, &**shape_b, limit) {
                Ok(ClosestPoints::WithinMargin(p, q)) if (q - p).length() < limit => {
                    (nearest, limit) = (Some([p, q]), (q - p).length());
                }
                Ok(ClosestPoints::Intersecting) => return Some([frame_a.translation; 2]),
                Ok(_) => {}
                Err(_) => unreachable!("rapier supports balls and convex polygons"),
            }
        }
        nearest
    }

    /// Returns the point on the surface of this body at a pose that is nearest to another point, m.
    pub(super) fn nearest_on_surface(&self, pose: Pose, point: Vector) -> Option<Vector> {
        let frame = frame(pose);
        let on_surface =
            |(shape, local): &(SharedShape, Frame)| shape.project_point(&(frame * *local), point, false).point;
        self.0.iter().map(on_surface).min_by(|a, b| (*a - point).length().total_cmp(&(*b - point).length()))
    }
}

/// Returns the distance between the surfaces of two bodies of a scene, px; zero if they overlap.
pub fn distance(a: &Body, b: &Body) -> f64 {
    let nearest = Outline::of(a).nearest_points(pose_of(a), &Outline::of(b), pose_of(b), f32::MAX);
    nearest.map_or(f64::INFINITY, |[p, q]| f64::from((q - p).length() * PX_PER_METRE))
}

/// Returns the pose of a body at the start of its scene.
pub(super) fn pose_of(body: &Body) -> Pose {
    [body.x, body.y, body.angle].map(|value| value as f32)
}

/// Returns the frame at the origin of a body, m.
pub(super) fn frame([x, y, angle]: Pose) -> Frame {
    let (sin, cos) = libm::sincosf(angle);
    Frame::from_parts(Vector::new(x, y) / PX_PER_METRE, Rotation::from_cos_sin_unchecked(cos, sin))
}

/// Returns rapier's cuboid for a rectangle, which is exact and fast, and a convex polygon for anything else.
fn polygon(corners: Vec<Vector>) -> (SharedShape, Frame) {
    if let [a, b, c, d] = corners[..] {
        let (along, across) = (b - a, d - a);
        let is_rectangle = (a + c - b - d).length() < 1e-5 && along.dot(across).abs() < 1e-5;
        if is_rectangle {
            let (width, height) = (along.length(), across.length());
            let axis = along / width;
            let rotation = Rotation::from_cos_sin_unchecked(axis.x, axis.y);
            return (SharedShape::cuboid(width / 2.0, height / 2.0), Frame::from_parts((a + c) / 2.0, rotation));
        }
    }
    let shape = SharedShape::convex_polyline(corners).expect("the shapes of a body are convex polygons");
    (shape, Frame::IDENTITY)
}

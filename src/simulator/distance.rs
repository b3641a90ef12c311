//! Distances between bodies where they stand. Not part of a step.
//!
//! Distances are rapier's, between the surfaces as they are drawn: without the skin of polygons.

use rapier2d::math::{Pose as Frame, Vector};
use rapier2d::parry::query::{ClosestPoints, closest_points};

use super::body::{Position, metres};
use super::constants::PX_PER_METRE;
use super::fixture::Fixture;
use crate::puzzle::rollout::Pose;
use crate::puzzle::scene::Body;

/// The shapes of a body, to be measured from wherever it stands.
pub(super) struct Outline(Vec<Fixture>);

impl Outline {
    pub(super) fn of(body: &Body) -> Outline {
        Outline(body.shapes.iter().map(|shape| Fixture::new(shape, 0)).collect())
    }

    /// Returns the nearest points of this body and another at these poses, m, if they are nearer than `limit`, m; the
    /// same point twice if they overlap.
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
            let (frame_a, frame_b) = (frame * a.local, other_frame * b.local);
            // Pairs that are farther apart than the nearest so far need not be measured exactly.
            match closest_points(&frame_a, &*a.shape, &frame_b, &*b.shape, limit) {
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
        let on_surface = |part: &Fixture| part.shape.project_point(&(frame * part.local), point, false).point;
        self.0.iter().map(on_surface).min_by(|a, b| (*a - point).length().total_cmp(&(*b - point).length()))
    }
}

/// Returns the distance between the surfaces of two bodies of a scene, px; zero if they overlap.
pub fn distance(a: &Body, b: &Body) -> f64 {
    let nearest = Outline::of(a).nearest_points(pose_of(a), &Outline::of(b), pose_of(b), f32::MAX);
    nearest.map_or(f64::INFINITY, |[p, q]| f64::from((q - p).length()) * PX_PER_METRE)
}

/// Returns where a body stands in its scene.
pub(super) fn pose_of(body: &Body) -> Pose {
    [body.x, body.y, body.angle].map(|value| value as f32)
}

/// Returns the frame at the origin of a body, m.
fn frame([x, y, angle]: Pose) -> Frame {
    Position { centre: metres([x.into(), y.into()]), angle }.pose()
}

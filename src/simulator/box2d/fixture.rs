//! The shapes of bodies with their bounding boxes: b2Fixture and b2FixtureProxy.

use rapier2d::geometry::Aabb;
use rapier2d::math::Vector;
use rapier2d::parry::bounding_volume::BoundingVolume;

use super::math::Transform;
use super::shape::Shape;
use crate::simulator::constants::{AABB_EXTENSION, AABB_MULTIPLIER};

/// A shape of a body. Its index in the world is its proxy id in Box2D.
pub(super) struct Fixture {
    pub(super) body: usize,
    pub(super) shape: Shape,
    /// Maximum distance of its vertices from the body's centre of mass, m.
    pub(super) reach: f32,
    /// The bounding box at the body's current position.
    pub(super) aabb: Aabb,
    /// The bounding box over the last step.
    pub(super) swept_aabb: Aabb,
    /// The bounding box in the broad phase: larger, so that it seldom changes.
    pub(super) fat_aabb: Aabb,
    /// Whether the fat AABB has changed since the last search for new pairs.
    pub(super) moved: bool,
}

impl Fixture {
    /// Returns a fixture of the body with this index, whose centre of mass is at `local_centre`, m, in its frame.
    pub(super) fn new(body: usize, shape: Shape, local_centre: Vector, transform: &Transform) -> Fixture {
        let aabb = shape.aabb(transform);
        let (reach, fat_aabb) = (shape.reach(local_centre), aabb.loosened(AABB_EXTENSION));
        Fixture { body, shape, reach, aabb, swept_aabb: aabb, fat_aabb, moved: true }
    }

    /// Updates the AABBs after the body has moved (b2Fixture::Synchronize). Without `start`, the motion began where the
    /// AABBs were last updated. `displacement` is that of the body's origin, m. Returns whether the fat AABB changed.
    pub(super) fn synchronize(&mut self, start: Option<&Transform>, end: &Transform, displacement: Vector) -> bool {
        let start_aabb = start.map_or(self.aabb, |start| self.shape.aabb(start));
        self.aabb = self.shape.aabb(end);
        self.swept_aabb = start_aabb.merged(&self.aabb);
        if self.fat_aabb.contains(&self.swept_aabb) {
            return false;
        }
        let predicted = AABB_MULTIPLIER * displacement;
        self.fat_aabb = self.swept_aabb.loosened(AABB_EXTENSION);
        self.fat_aabb.mins += predicted.min(Vector::ZERO);
        self.fat_aabb.maxs += predicted.max(Vector::ZERO);
        self.moved = true;
        true
    }
}

//! Fixtures: the convex shapes of the bodies with their bounds (b2Fixture and b2FixtureProxy of Box2D 2.3).
//!
//! Shapes are rapier's. Used only by the rest of the simulator.

use rapier2d::geometry::{Aabb, SharedShape};
use rapier2d::math::{Pose, Rotation, Vector};
use rapier2d::parry::bounding_volume::BoundingVolume;

use super::body::metres;
use super::constants::{AABB_EXTENSION, AABB_MULTIPLIER, POLYGON_RADIUS, PX_PER_METRE};
use crate::puzzle::scene::Shape;

/// One convex shape of a body (b2Fixture with its b2FixtureProxy).
pub struct Fixture {
    pub body: usize,
    pub shape: SharedShape,
    /// Transforms from the frame of the shape to the body's frame at its centre of mass.
    pub local: Pose,
    /// The radius of a circle, m; `None` for a polygon.
    pub circle_radius: Option<f32>,
    /// Distance of its farthest point from the body's centre of mass, m.
    pub bounding_radius: f32,
    /// AABB of the shape and its skin when the AABBs were last updated.
    aabb: Aabb,
    /// The same over the last step.
    pub swept_aabb: Aabb,
    /// AABB of the broad phase: larger, so that it changes seldom.
    pub fat_aabb: Aabb,
    /// Whether the fat AABB has changed since the broad phase looked for new pairs.
    pub moved: bool,
}

impl Fixture {
    /// Returns a fixture in the frame of its body's origin; `attach` completes it.
    pub fn new(shape: &Shape, body: usize) -> Fixture {
        let (shape, local, circle_radius) = match shape {
            Shape::Circle(radius) => {
                let radius = (radius / PX_PER_METRE) as f32;
                (SharedShape::ball(radius), Pose::IDENTITY, Some(radius))
            }
            Shape::Polygon(corners) => {
                let corners: Vec<Vector> = corners.iter().copied().map(metres).collect();
                let (shape, local) = polygon(corners);
                (shape, local, None)
            }
        };
        let aabb = shape.compute_aabb(&local);
        Fixture {
            body,
            shape,
            local,
            circle_radius,
            bounding_radius: 0.0,
            aabb,
            swept_aabb: aabb,
            fat_aabb: aabb,
            moved: true,
        }
    }

    /// Moves the fixture to the frame at the body's centre of mass and computes its bounds.
    pub fn attach(&mut self, local_centre: Vector, body: &Pose) {
        self.local.translation -= local_centre;
        let sphere = self.shape.compute_bounding_sphere(&self.local);
        self.bounding_radius = sphere.center.length() + sphere.radius;
        self.aabb = self.aabb_at(body);
        self.swept_aabb = self.aabb;
        self.fat_aabb = self.swept_aabb.loosened(AABB_EXTENSION);
    }

    /// Returns the radius around the vertices of the shape, m: of a circle, or of the skin of a polygon (m_radius of
    /// b2Shape).
    pub fn radius(&self) -> f32 {
        self.circle_radius.unwrap_or(POLYGON_RADIUS)
    }

    /// Returns how far the surface is outside of rapier's shape, m. rapier's balls include their radius.
    pub fn skin(&self) -> f32 {
        if self.circle_radius.is_some() { 0.0 } else { POLYGON_RADIUS }
    }

    /// Whether it is a circle about the centre of mass, which does not move as the body turns.
    pub fn turns_in_place(&self) -> bool {
        self.circle_radius.is_some() && self.local.translation == Vector::ZERO
    }

    /// Returns the least coordinate of rapier's shape along a direction, a unit vector, m.
    pub fn lowest(&self, body: &Pose, direction: Vector) -> f32 {
        let pose = *body * self.local;
        match (self.circle_radius, self.shape.as_support_map()) {
            (None, Some(polygon)) => polygon.support_point(&pose, -direction).dot(direction),
            (radius, _) => pose.translation.dot(direction) - radius.unwrap_or(0.0),
        }
    }

    fn aabb_at(&self, body: &Pose) -> Aabb {
        self.shape.compute_aabb(&(*body * self.local)).loosened(self.skin())
    }

    /// Updates the AABBs after the body has moved from `start` to `end` (b2Fixture::Synchronize). Without `start`, it
    /// has moved from the `end` of the last time. `displacement` is that of the body's origin, m.
    pub fn synchronize(&mut self, start: Option<&Pose>, end: &Pose, displacement: impl Fn() -> Vector) {
        let start_aabb = start.map_or(self.aabb, |start| self.aabb_at(start));
        self.aabb = self.aabb_at(end);
        self.swept_aabb = self.aabb.merged(&start_aabb);
        if self.fat_aabb.contains(&self.swept_aabb) {
            return;
        }
        let predicted = displacement() * AABB_MULTIPLIER;
        self.fat_aabb = self.swept_aabb.loosened(AABB_EXTENSION);
        self.fat_aabb.mins += predicted.min(Vector::ZERO);
        self.fat_aabb.maxs += predicted.max(Vector::ZERO);
        self.moved = true;
    }
}

/// Returns rapier's cuboid for a rectangle, whose contacts are exact and fast, and a convex polygon for anything else.
fn polygon(corners: Vec<Vector>) -> (SharedShape, Pose) {
    if let [a, b, c, d] = corners[..] {
        let (along, across) = (b - a, d - a);
        let rectangle = (a + c - b - d).length() < 1e-5 && along.dot(across).abs() < 1e-5;
        if rectangle {
            let (width, height) = (along.length(), across.length());
            let axis = along / width;
            let rotation = Rotation::from_cos_sin_unchecked(axis.x, axis.y);
            return (SharedShape::cuboid(width / 2.0, height / 2.0), Pose::from_parts((a + c) / 2.0, rotation));
        }
    }
    let shape = SharedShape::convex_polyline(corners).expect("the shapes of a body are convex polygons");
    (shape, Pose::IDENTITY)
}

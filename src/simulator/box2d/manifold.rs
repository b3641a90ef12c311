//! The contact points of two shapes: b2Manifold with its points (b2Collision.h), and b2WorldManifold, the same in world
//! coordinates.

use rapier2d::math::Vector;

use super::collide_circle::{collide_circles, collide_polygon_and_circle};
use super::collide_polygon::collide_polygons;
use super::math::{Transform, normalized};
use super::shape::Shape;

/// The contact of two shapes, A and B, in the frames of their bodies, so that the solver can move the bodies
/// (b2Manifold).
#[derive(Clone, Copy, Debug)]
pub(super) struct Manifold {
    pub(super) kind: Kind,
    /// The reference: a normal and a point of its face, m. For two circles, the centre of A without a normal.
    pub(super) local_normal: Vector,
    pub(super) local_point: Vector,
    points: [ManifoldPoint; 2],
    count: usize,
}

/// The body that the reference of a manifold belongs to (b2Manifold::Type).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Kind {
    Circles,
    FaceA,
    FaceB,
}

/// A point of the other shape (b2ManifoldPoint).
#[derive(Clone, Copy, Debug)]
pub(super) struct ManifoldPoint {
    /// In the frame of its body, m.
    pub(super) local: Vector,
    pub(super) id: ContactId,
    /// The accumulated impulse of the last step, kg m/s, from which the solver starts (warm starting).
    pub(super) impulse: Impulse,
}

/// The impulse of a contact point, kg m/s.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Impulse {
    pub(super) normal: f32,
    pub(super) tangent: f32,
}

/// The features of A and B that meet at a point. The same point has the same id in the next step (b2ContactID).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct ContactId {
    pub(super) a: Feature,
    pub(super) b: Feature,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Feature {
    Vertex(u8),
    Face(u8),
}

impl Default for Feature {
    fn default() -> Feature {
        Feature::Vertex(0)
    }
}

impl Manifold {
    /// The manifold of shapes that do not touch.
    pub(super) const EMPTY: Manifold = {
        let id = ContactId { a: Feature::Vertex(0), b: Feature::Vertex(0) };
        let point = ManifoldPoint { local: Vector::ZERO, id, impulse: Impulse { normal: 0.0, tangent: 0.0 } };
        Manifold {
            kind: Kind::Circles,
            local_normal: Vector::ZERO,
            local_point: Vector::ZERO,
            points: [point; 2],
            count: 0,
        }
    };

    /// Returns a manifold without points.
    pub(super) fn with_reference(kind: Kind, local_normal: Vector, local_point: Vector) -> Manifold {
        Manifold { kind, local_normal, local_point, ..Manifold::EMPTY }
    }

    /// Returns the manifold of two shapes (b2Contact::Evaluate). A circle comes after a polygon.
    #[inline]
    pub(super) fn new(a: &Shape, transform_a: &Transform, b: &Shape, transform_b: &Transform) -> Manifold {
        match (a.is_circle(), b.is_circle()) {
            (true, true) => collide_circles(a, transform_a, b, transform_b),
            (false, true) => collide_polygon_and_circle(a, transform_a, b, transform_b),
            (_, false) => collide_polygons(a, transform_a, b, transform_b),
        }
    }

    pub(super) fn points(&self) -> &[ManifoldPoint] {
        &self.points[..self.count]
    }

    pub(super) fn points_mut(&mut self) -> &mut [ManifoldPoint] {
        &mut self.points[..self.count]
    }

    pub(super) fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Adds a point; there are at most two.
    pub(super) fn push(&mut self, local: Vector, id: ContactId) {
        self.points[self.count] = ManifoldPoint { local, id, impulse: Impulse::default() };
        self.count += 1;
    }

    /// Returns the manifold with the centre of a circle as its only point.
    pub(super) fn with_centre(mut self) -> Manifold {
        self.push(Vector::ZERO, ContactId::default());
        self
    }
}

/// The contact of two shapes in world coordinates (b2WorldManifold).
pub(super) struct WorldManifold {
    /// From A to B, a unit vector.
    pub(super) normal: Vector,
    /// Halfway between the two surfaces, m.
    pub(super) points: [Vector; 2],
    /// Separations of the two surfaces at the points, m; negative where they overlap.
    pub(super) separations: [f32; 2],
}

impl WorldManifold {
    #[inline]
    pub(super) fn new(
        manifold: &Manifold,
        [transform_a, transform_b]: [&Transform; 2],
        [radius_a, radius_b]: [f32; 2],
    ) -> WorldManifold {
        let (mut points, mut separations) = ([Vector::ZERO; 2], [0.0; 2]);
        let normal = match manifold.kind {
            Kind::Circles => {
                let centre_a = transform_a.to_world(manifold.local_point);
                let centre_b = transform_b.to_world(manifold.points[0].local);
                let is_apart = (centre_a - centre_b).length_squared() > f32::EPSILON * f32::EPSILON;
                let normal = if is_apart { normalized(centre_b - centre_a) } else { Vector::X };
                let (on_a, on_b) = (centre_a + radius_a * normal, centre_b - radius_b * normal);
                points[0] = 0.5 * (on_a + on_b);
                separations[0] = (on_b - on_a).dot(normal);
                normal
            }
            Kind::FaceA => {
                let normal = transform_a.rotation.rotate(manifold.local_normal);
                let plane_point = transform_a.to_world(manifold.local_point);
                for (index, point) in manifold.points().iter().enumerate() {
                    let clip = transform_b.to_world(point.local);
                    let on_a = clip + (radius_a - (clip - plane_point).dot(normal)) * normal;
                    let on_b = clip - radius_b * normal;
                    points[index] = 0.5 * (on_a + on_b);
                    separations[index] = (on_b - on_a).dot(normal);
                }
                normal
            }
            Kind::FaceB => {
                let normal = transform_b.rotation.rotate(manifold.local_normal);
                let plane_point = transform_b.to_world(manifold.local_point);
                for (index, point) in manifold.points().iter().enumerate() {
                    let clip = transform_a.to_world(point.local);
                    let on_b = clip + (radius_b - (clip - plane_point).dot(normal)) * normal;
                    let on_a = clip - radius_a * normal;
                    points[index] = 0.5 * (on_a + on_b);
                    separations[index] = (on_a - on_b).dot(normal);
                }
                -normal
            }
        };
        WorldManifold { normal, points, separations }
    }
}

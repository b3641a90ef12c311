//! A contact of two fixtures: where they touch and how deep (b2Contact, b2Manifold and b2WorldManifold of Box2D 2.3).
//!
//! rapier's narrow phase computes the manifold; this file reduces it to what the solver needs, in the frames of the two
//! bodies, and keeps the impulses of the solver for warm starting.

use rapier2d::math::{Pose, Vector};
use rapier2d::parry::bounding_volume::BoundingVolume;
use rapier2d::parry::query::{ContactManifold, DefaultQueryDispatcher, PersistentQueryDispatcher};

use super::body::RigidBody;
use super::fixture::Fixture;
use super::scalar::length;

/// The accumulated impulse of a contact point, kg m/s. The solver of the next step starts from it (warm starting).
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Impulse {
    pub normal: f32,
    pub tangent: f32,
}

/// A contact point: for each body the point of its shape, from its centre of mass, in its own frame, m.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ContactPoint {
    pub local_point_a: Vector,
    pub local_point_b: Vector,
    /// Its index in rapier's manifold.
    index: usize,
}

pub(crate) struct Contact {
    /// The two fixtures. A polygon comes before a circle.
    pub fixtures: [usize; 2],
    /// Their bodies.
    pub bodies: [usize; 2],
    /// How far the surface of each fixture is outside of its points, m: the radius of a circle or of a polygon's skin.
    pub radii: [f32; 2],
    /// Both are circles: the normal is the line of their centres.
    pub both_circles: bool,
    manifold: ContactManifold<(), Impulse>,
    points: [ContactPoint; 2],
    point_count: usize,
    /// From a to b, in the frame of a.
    pub local_normal: Vector,
    pub touching: bool,
    /// Cleared for the rest of a step if the two do not touch at their time of impact.
    pub enabled: bool,
    /// The time of impact as a fraction of the step, once it is known; 1 if there is none.
    pub toi: Option<f32>,
    /// Times of impact handled in this step.
    pub toi_count: u32,
    /// Whether it already belongs to an island.
    pub in_island: bool,
}

impl Contact {
    pub(crate) fn new(fixtures: [usize; 2], all: &[Fixture]) -> Contact {
        let [mut a, mut b] = fixtures;
        if all[a].circle_radius.is_some() && all[b].circle_radius.is_none() {
            (a, b) = (b, a);
        }
        let (first, second) = (&all[a], &all[b]);
        Contact {
            fixtures: [a, b],
            bodies: [first.body, second.body],
            radii: [first.radius(), second.radius()],
            both_circles: first.circle_radius.is_some(),
            manifold: ContactManifold::new(),
            points: Default::default(),
            point_count: 0,
            local_normal: Vector::ZERO,
            touching: false,
            enabled: true,
            toi: None,
            toi_count: 0,
            in_island: false,
        }
    }

    pub(crate) fn points(&self) -> &[ContactPoint] {
        &self.points[..self.point_count]
    }

    /// Returns the other body of the contact if `body` is one of its two.
    pub(crate) fn other_body(&self, body: usize) -> Option<usize> {
        match self.bodies {
            [a, b] if a == body => Some(b),
            [a, b] if b == body => Some(a),
            _ => None,
        }
    }

    /// Returns the accumulated impulse of a point in the last step.
    pub(crate) fn impulse(&self, point: usize) -> Impulse {
        self.manifold.points[self.points[point].index].data
    }

    pub(crate) fn store_impulse(&mut self, point: usize, impulse: Impulse) {
        self.manifold.points[self.points[point].index].data = impulse;
    }

    /// Computes the manifold for the present positions of the bodies (b2Contact::Update).
    pub(crate) fn update(&mut self, fixtures: &[Fixture], bodies: &[RigidBody]) {
        let [a, b] = self.fixtures.map(|fixture| &fixtures[fixture]);
        self.enabled = true;
        self.point_count = 0;
        self.touching = false;
        if !a.swept_aabb.intersects(&b.swept_aabb) {
            self.manifold.clear();
            return;
        }
        let [body_a, body_b] = self.bodies.map(|body| bodies[body].pose());
        let relative_pose = (body_a * a.local).inv_mul(&(body_b * b.local));
        let skins = a.skin() + b.skin();
        // Without this rapier would keep points that have hardly moved; here every step computes them.
        self.manifold.mark_shapes_deformed();
        DefaultQueryDispatcher
            .contact_manifold_convex_convex(&relative_pose, &*a.shape, &*b.shape, None, None, skins, &mut self.manifold)
            .expect("rapier supports balls and convex polygons");
        self.local_normal = a.local.rotation * self.manifold.local_n1;
        for (index, point) in self.manifold.points.iter_mut().enumerate() {
            if point.dist > skins {
                point.data = Impulse::default();
                continue;
            }
            // The point of a circle is its centre.
            let local_point = |fixture: &Fixture, point| {
                if fixture.circle_radius.is_some() { fixture.local.translation } else { fixture.local * point }
            };
            self.points[self.point_count] = ContactPoint {
                local_point_a: local_point(a, point.local_p1),
                local_point_b: local_point(b, point.local_p2),
                index,
            };
            self.point_count += 1;
        }
        self.touching = self.point_count > 0;
    }

    /// Returns the world normal from a to b, given the frames of the two bodies.
    pub(crate) fn normal(&self, a: &Pose, b: &Pose) -> Vector {
        if self.both_circles {
            let delta = b.translation - a.translation;
            let length = length(delta);
            // As in b2WorldManifold for two circles with the same centre.
            if length > f32::EPSILON { delta / length } else { Vector::X }
        } else {
            a.rotation * self.local_normal
        }
    }

    /// Returns the separation of the surfaces at a point, along the normal, m; negative if they overlap.
    pub(crate) fn separation(&self, point: &ContactPoint, normal: Vector, a: &Pose, b: &Pose) -> f32 {
        (*b * point.local_point_b - *a * point.local_point_a).dot(normal) - self.radii[0] - self.radii[1]
    }
}

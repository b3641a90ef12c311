//! A contact: two fixtures that are near each other, and where and how deep they touch.
//!
//! rapier's narrow phase finds the points; this file reduces them to what the solver needs, in the frames of
//! the two bodies, and keeps what the solver learnt about them for the next step.

use rapier2d::math::{Pose, Vector};
use rapier2d::parry::bounding_volume::BoundingVolume;
use rapier2d::parry::query::{ContactManifold, DefaultQueryDispatcher, PersistentQueryDispatcher};

use super::body::{Fixture, Rigid};

/// What a point has carried so far; the solver starts from it. kg m/s.
#[derive(Clone, Copy, Debug, Default)]
pub struct Impulse {
    pub normal: f32,
    pub tangent: f32,
}

/// A touching point: of each body the point of its shape, from its centre of mass, in its own frame, m.
#[derive(Clone, Copy, Debug, Default)]
pub struct Point {
    pub on_a: Vector,
    pub on_b: Vector,
    /// Its number in the manifold.
    index: usize,
}

pub struct Contact {
    /// The two fixtures. A polygon comes before a ball.
    pub fixtures: [usize; 2],
    /// Their bodies.
    pub bodies: [usize; 2],
    /// How far the surface of each lies outside the points, m: the skin, or the radius of a ball.
    pub margins: [f32; 2],
    /// Both are balls: the normal follows their centres.
    pub round: bool,
    manifold: ContactManifold<(), Impulse>,
    points: [Point; 2],
    count: usize,
    /// From a to b, in the frame of a.
    pub local_normal: Vector,
    pub touching: bool,
    /// Cleared for the rest of a step when a moment of impact proves false.
    pub enabled: bool,
    /// The share of the step at which the two meet, once it is known; 1 if they do not.
    pub impact: Option<f32>,
    pub impacts: u32,
    /// Already among those to be solved.
    pub taken: bool,
}

impl Contact {
    pub fn new(fixtures: [usize; 2], all: &[Fixture]) -> Contact {
        let [mut a, mut b] = fixtures;
        if all[a].ball.is_some() && all[b].ball.is_none() {
            (a, b) = (b, a);
        }
        let (first, second) = (&all[a], &all[b]);
        Contact {
            fixtures: [a, b],
            bodies: [first.body, second.body],
            margins: [first, second].map(|fixture| fixture.ball.unwrap_or(fixture.skin())),
            round: first.ball.is_some(),
            manifold: ContactManifold::new(),
            points: Default::default(),
            count: 0,
            local_normal: Vector::ZERO,
            touching: false,
            enabled: true,
            impact: None,
            impacts: 0,
            taken: false,
        }
    }

    pub fn points(&self) -> &[Point] {
        &self.points[..self.count]
    }

    /// What the point carried in the last step.
    pub fn impulse(&self, point: usize) -> Impulse {
        self.manifold.points[self.points[point].index].data
    }

    pub fn remember(&mut self, point: usize, impulse: Impulse) {
        self.manifold.points[self.points[point].index].data = impulse;
    }

    /// Finds the points anew, where the bodies are now.
    pub fn update(&mut self, fixtures: &[Fixture], bodies: &[Rigid]) {
        let [a, b] = self.fixtures.map(|fixture| &fixtures[fixture]);
        self.enabled = true;
        self.count = 0;
        self.touching = false;
        if !a.swept.intersects(&b.swept) {
            self.manifold.clear();
            return;
        }
        let [body_a, body_b] = self.bodies.map(|body| bodies[body].pose());
        let between = (body_a * a.local).inv_mul(&(body_b * b.local));
        let skins = a.skin() + b.skin();
        // Without this rapier would keep points that have hardly moved; here every step is exact.
        self.manifold.mark_shapes_deformed();
        DefaultQueryDispatcher
            .contact_manifold_convex_convex(&between, &*a.shape, &*b.shape, None, None, skins, &mut self.manifold)
            .expect("rapier knows balls and convex polygons");
        self.local_normal = a.local.rotation * self.manifold.local_n1;
        for (index, point) in self.manifold.points.iter_mut().enumerate() {
            if point.dist > skins {
                point.data = Impulse::default();
                continue;
            }
            // A ball counts as its centre.
            let on = |fixture: &Fixture, at| {
                if fixture.ball.is_some() { fixture.local.translation } else { fixture.local * at }
            };
            self.points[self.count] = Point { on_a: on(a, point.local_p1), on_b: on(b, point.local_p2), index };
            self.count += 1;
        }
        self.touching = self.count > 0;
    }

    /// The world normal from a to b, given the frames of the two bodies.
    pub fn normal(&self, a: &Pose, b: &Pose) -> Vector {
        if self.round {
            let way = b.translation - a.translation;
            let length = way.length();
            // Box2D's own answer for two balls on one spot.
            if length > f32::EPSILON { way / length } else { Vector::X }
        } else {
            a.rotation * self.local_normal
        }
    }

    /// Gap of a point along the normal, less the margins, m; negative if they overlap.
    pub fn gap(&self, point: &Point, normal: Vector, a: &Pose, b: &Pose) -> f32 {
        (*b * point.on_b - *a * point.on_a).dot(normal) - self.margins[0] - self.margins[1]
    }
}

//! Rigid bodies and their fixtures, built from the scene: where they stand, how they move, what they weigh.
//!
//! Shapes and mass properties are rapier's. A body moves about its centre of mass; a fixture is one convex
//! part of a body. Used by the rest of the simulator only.

use rapier2d::geometry::{Aabb, ColliderBuilder, SharedShape};
use rapier2d::math::{Pose, Rotation, Vector};
use rapier2d::parry::bounding_volume::BoundingVolume;
use rapier2d::parry::mass_properties::MassProperties;

use super::constants::{BOX_AHEAD, BOX_MARGIN, DENSITY, SCALE, SKIN};
use crate::puzzle::scene::{Body, Shape};

/// Where a body's centre of mass is, m, and its angle, radians, not wrapped.
#[derive(Clone, Copy, Debug)]
pub struct Stance {
    pub com: Vector,
    pub angle: f32,
}

impl Stance {
    pub fn rotation(&self) -> Rotation {
        let (sin, cos) = libm::sincosf(self.angle);
        Rotation::from_cos_sin_unchecked(cos, sin)
    }

    /// On the straight way from here to there; `share` in 0..=1.
    pub fn towards(&self, there: &Stance, share: f32) -> Stance {
        Stance {
            com: self.com * (1.0 - share) + there.com * share,
            angle: self.angle * (1.0 - share) + there.angle * share,
        }
    }
}

pub struct Rigid {
    pub dynamic: bool,
    /// The centre of mass in body coordinates, m.
    pub local_com: Vector,
    /// Where the step began, or its last moment of impact, and what share of the step that was.
    pub start: Stance,
    pub start_time: f32,
    pub now: Stance,
    /// Of `now`; kept because it is asked for far more often than it changes.
    rotation: Rotation,
    pub awake: bool,
    /// How long it has been still, s.
    pub still: f32,
    /// Its fixtures, as a range of the world's.
    pub fixtures: std::ops::Range<usize>,
}

impl Rigid {
    /// The body of a scene, at rest, and its fixtures, which will have the numbers from `first` on.
    pub fn new(body: &Body, number: usize, first: usize) -> (Rigid, Motion, Vec<Fixture>) {
        let mut fixtures: Vec<Fixture> = body.shapes.iter().map(|shape| Fixture::new(shape, number)).collect();
        let mass = |fixture: &Fixture| {
            let collider = ColliderBuilder::new(fixture.shape.clone()).density(DENSITY).build();
            collider.mass_properties().transform_by(&fixture.local)
        };
        let mass = fixtures.iter().map(mass).fold(MassProperties::default(), |sum, part| sum + part);
        let (inv_mass, inv_inertia, local_com) = if body.dynamic {
            (mass.inv_mass, mass.inv_principal_inertia, mass.local_com)
        } else {
            (0.0, 0.0, Vector::ZERO)
        };
        let origin = Stance { com: metres([body.x, body.y]), angle: body.angle as f32 };
        let now = Stance { com: origin.com + origin.rotation() * local_com, ..origin };
        let rigid = Rigid {
            dynamic: body.dynamic,
            local_com,
            start: now,
            start_time: 0.0,
            now,
            rotation: now.rotation(),
            awake: body.dynamic,
            still: 0.0,
            fixtures: first..first + fixtures.len(),
        };
        let pose = rigid.pose();
        for fixture in &mut fixtures {
            fixture.local.translation -= local_com;
            fixture.place(&pose);
            fixture.roomy = fixture.swept.loosened(BOX_MARGIN);
        }
        (rigid, Motion { velocity: Vector::ZERO, spin: 0.0, inv_mass, inv_inertia }, fixtures)
    }

    /// The frame at the centre of mass.
    pub fn pose(&self) -> Pose {
        Pose::from_parts(self.now.com, self.rotation)
    }

    /// Where the origin of the body is, m.
    pub fn origin(&self) -> Vector {
        self.now.com - self.rotation * self.local_com
    }

    /// Moves the start of the step forward to this share of it.
    pub fn advance_start(&mut self, time: f32) {
        let share = (time - self.start_time) / (1.0 - self.start_time);
        self.start = self.start.towards(&self.now, share);
        self.start_time = time;
    }

    /// Goes back to where it was at this share of the step.
    pub fn rewind(&mut self, time: f32) {
        self.advance_start(time);
        self.stand(self.start);
    }

    /// What `rewind` changes.
    pub fn sweep(&self) -> (Stance, f32, Stance) {
        (self.start, self.start_time, self.now)
    }

    /// Undoes a `rewind`.
    pub fn restore(&mut self, (start, start_time, now): (Stance, f32, Stance)) {
        (self.start, self.start_time) = (start, start_time);
        self.stand(now);
    }

    pub fn stand(&mut self, now: Stance) {
        if now.angle != self.now.angle {
            self.rotation = now.rotation();
        }
        self.now = now;
    }

    pub fn wake(&mut self) {
        if self.dynamic && !self.awake {
            self.awake = true;
            self.still = 0.0;
        }
    }

    pub fn sleep(&mut self) {
        self.awake = false;
        self.still = 0.0;
    }
}

/// How a body moves, and how it answers to impulses. Apart from the rest because the solver reads nothing else, often.
#[derive(Clone, Copy, Debug)]
pub struct Motion {
    /// m/s and radians/s.
    pub velocity: Vector,
    pub spin: f32,
    /// 1/kg and 1/(kg m^2); 0 for static bodies.
    pub inv_mass: f32,
    pub inv_inertia: f32,
}

impl Motion {
    pub fn stop(&mut self) {
        self.velocity = Vector::ZERO;
        self.spin = 0.0;
    }

    pub fn push(&mut self, impulse: Vector, at: Vector) {
        self.velocity += self.inv_mass * impulse;
        self.spin += self.inv_inertia * at.perp_dot(impulse);
    }

    /// The velocity of a point of the body, given from the centre of mass.
    pub fn at(&self, at: Vector) -> Vector {
        self.velocity + self.spin * at.perp()
    }

    /// How much an impulse along `direction` at `at` changes the velocity there.
    pub fn response(&self, at: Vector, direction: Vector) -> f32 {
        let arm = at.perp_dot(direction);
        self.inv_mass + self.inv_inertia * arm * arm
    }
}

/// One convex part of a body.
pub struct Fixture {
    pub body: usize,
    pub shape: SharedShape,
    /// From the frame of the shape to the body's frame at its centre of mass.
    pub local: Pose,
    /// Of a ball, m.
    pub ball: Option<f32>,
    /// Farthest point from the body's centre of mass, m.
    pub reach: f32,
    /// Box around the shape and its skin, wherever it was during the last step.
    pub swept: Aabb,
    /// A larger box; pairs whose larger boxes overlap are looked at.
    pub roomy: Aabb,
    /// Whether the larger box is new.
    pub moved: bool,
}

impl Fixture {
    fn new(shape: &Shape, body: usize) -> Fixture {
        let (shape, local, ball) = match shape {
            Shape::Circle(r) => {
                let radius = (r / SCALE) as f32;
                (SharedShape::ball(radius), Pose::IDENTITY, Some(radius))
            }
            Shape::Polygon(corners) => {
                let corners: Vec<Vector> = corners.iter().copied().map(metres).collect();
                let (shape, local) = polygon(corners);
                (shape, local, None)
            }
        };
        let bounds = shape.compute_aabb(&local);
        Fixture { body, shape, local, ball, reach: 0.0, swept: bounds, roomy: bounds, moved: true }
    }

    /// How far its surface lies outside its shape, m.
    pub fn skin(&self) -> f32 {
        if self.ball.is_some() { 0.0 } else { SKIN }
    }

    fn place(&mut self, body: &Pose) {
        self.swept = self.bounds_at(body);
        let sphere = self.shape.compute_bounding_sphere(&self.local);
        self.reach = sphere.center.length() + sphere.radius;
    }

    fn bounds_at(&self, body: &Pose) -> Aabb {
        self.shape.compute_aabb(&(*body * self.local)).loosened(self.skin())
    }

    /// Follows the body, which has come from `start` by `way`; a larger box that it has left is made anew.
    pub fn follow(&mut self, start: &Pose, now: &Pose, way: Vector) {
        self.swept = self.bounds_at(now).merged(&self.bounds_at(start));
        if self.roomy.contains(&self.swept) {
            return;
        }
        let ahead = way * BOX_AHEAD;
        self.roomy = self.swept.loosened(BOX_MARGIN);
        self.roomy.mins += ahead.min(Vector::ZERO);
        self.roomy.maxs += ahead.max(Vector::ZERO);
        self.moved = true;
    }
}

/// A rectangle becomes rapier's cuboid, whose contacts are exact and fast; anything else a convex polygon.
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
    let shape = SharedShape::convex_polyline(corners).expect("the parts of a body are convex polygons");
    (shape, Pose::IDENTITY)
}

fn metres([x, y]: [f64; 2]) -> Vector {
    Vector::new((x / SCALE) as f32, (y / SCALE) as f32)
}

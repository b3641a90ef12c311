//! Rigid bodies and their fixtures, built from the scene: b2Body, b2Fixture and b2Sweep of Box2D 2.3.
//!
//! Shapes and mass properties are rapier's. A body moves about its centre of mass; a fixture is one convex shape of a
//! body. Used only by the rest of the simulator.

use rapier2d::geometry::{Aabb, ColliderBuilder, SharedShape};
use rapier2d::math::{Pose, Rotation, Vector};
use rapier2d::parry::bounding_volume::BoundingVolume;
use rapier2d::parry::mass_properties::MassProperties;

use super::constants::{AABB_EXTENSION, AABB_MULTIPLIER, DENSITY, POLYGON_RADIUS, PX_PER_METRE};
use crate::puzzle::scene::{Body, Shape};

/// Centre of mass, m, and angle of a body, radians, not wrapped (b2Position).
#[derive(Clone, Copy, Debug)]
pub struct Position {
    pub centre: Vector,
    pub angle: f32,
}

impl Position {
    pub fn rotation(&self) -> Rotation {
        let (sin, cos) = libm::sincosf(self.angle);
        Rotation::from_cos_sin_unchecked(cos, sin)
    }

    /// Returns the frame at the centre of mass.
    pub fn pose(&self) -> Pose {
        Pose::from_parts(self.centre, self.rotation())
    }

    /// Interpolates linearly from this position to another; `t` in 0..=1.
    pub fn lerp(&self, other: &Position, t: f32) -> Position {
        Position { centre: self.centre * (1.0 - t) + other.centre * t, angle: self.angle * (1.0 - t) + other.angle * t }
    }
}

/// The motion of a body over a step (b2Sweep).
#[derive(Clone, Copy, Debug)]
pub struct Sweep {
    /// Position at `alpha0`: at the start of the step, or at its last time of impact (c0 and a0 in Box2D).
    pub position0: Position,
    /// The fraction of the step to which `position0` belongs.
    pub alpha0: f32,
    /// Position at the end of the step (c and a in Box2D).
    pub position: Position,
}

impl Sweep {
    /// Returns the position at a fraction of the rest of the step, 0..=1.
    pub fn position_at(&self, beta: f32) -> Position {
        self.position0.lerp(&self.position, beta)
    }

    /// Moves the start of the sweep forward to a fraction of the step.
    pub fn advance(&mut self, alpha: f32) {
        let beta = (alpha - self.alpha0) / (1.0 - self.alpha0);
        self.position0 = self.position_at(beta);
        self.alpha0 = alpha;
    }
}

/// A rigid body without its velocity and mass, which are in its `SolverBody`.
pub struct RigidBody {
    pub dynamic: bool,
    /// The centre of mass in body coordinates, m.
    pub local_centre: Vector,
    pub sweep: Sweep,
    /// The rotation of `sweep.position`, cached because it is read far more often than it changes.
    rotation: Rotation,
    pub awake: bool,
    /// For how long it has been slower than the sleep tolerances, s.
    pub sleep_time: f32,
    /// Its fixtures: a range of the world's.
    pub fixtures: std::ops::Range<usize>,
}

impl RigidBody {
    /// Returns a body of a scene at rest, with its velocity and mass and its fixtures. `index` is the body's index in the
    /// world, `first` that of its first fixture.
    pub fn new(body: &Body, index: usize, first: usize) -> (RigidBody, SolverBody, Vec<Fixture>) {
        let mut fixtures: Vec<Fixture> = body.shapes.iter().map(|shape| Fixture::new(shape, index)).collect();
        let mass = |fixture: &Fixture| {
            let collider = ColliderBuilder::new(fixture.shape.clone()).density(DENSITY).build();
            collider.mass_properties().transform_by(&fixture.local)
        };
        let mass = fixtures.iter().map(mass).fold(MassProperties::default(), |sum, shape| sum + shape);
        let (inv_mass, inv_inertia, local_centre) = if body.dynamic {
            (mass.inv_mass, mass.inv_principal_inertia, mass.local_com)
        } else {
            (0.0, 0.0, Vector::ZERO)
        };
        let origin = Position { centre: metres([body.x, body.y]), angle: body.angle as f32 };
        let position = Position { centre: origin.centre + origin.rotation() * local_centre, ..origin };
        let rigid_body = RigidBody {
            dynamic: body.dynamic,
            local_centre,
            sweep: Sweep { position0: position, alpha0: 0.0, position },
            rotation: position.rotation(),
            awake: body.dynamic,
            sleep_time: 0.0,
            fixtures: first..first + fixtures.len(),
        };
        let pose = rigid_body.pose();
        for fixture in &mut fixtures {
            fixture.attach(local_centre, &pose);
        }
        let solver_body = SolverBody { velocity: Vector::ZERO, angular_velocity: 0.0, inv_mass, inv_inertia };
        (rigid_body, solver_body, fixtures)
    }

    /// Returns the frame at the centre of mass.
    pub fn pose(&self) -> Pose {
        Pose::from_parts(self.sweep.position.centre, self.rotation)
    }

    /// Returns the origin of the body, m.
    pub fn origin(&self) -> Vector {
        self.sweep.position.centre - self.rotation * self.local_centre
    }

    pub fn set_position(&mut self, position: Position) {
        if position.angle != self.sweep.position.angle {
            self.rotation = position.rotation();
        }
        self.sweep.position = position;
    }

    /// Moves the body back to its position at a fraction of the step (b2Body::Advance).
    pub fn advance(&mut self, alpha: f32) {
        self.sweep.advance(alpha);
        self.set_position(self.sweep.position0);
    }

    /// Undoes `advance`, given the sweep before it.
    pub fn restore_sweep(&mut self, sweep: Sweep) {
        self.set_position(sweep.position);
        self.sweep = sweep;
    }

    pub fn wake(&mut self) {
        if self.dynamic && !self.awake {
            self.awake = true;
            self.sleep_time = 0.0;
        }
    }

    pub fn sleep(&mut self) {
        self.awake = false;
        self.sleep_time = 0.0;
    }
}

/// Velocity and mass of a body. Apart from `RigidBody` because the velocity solver reads nothing else, very often.
#[derive(Clone, Copy, Debug)]
pub struct SolverBody {
    /// Of the centre of mass, m/s.
    pub velocity: Vector,
    /// radians/s
    pub angular_velocity: f32,
    /// 1/kg; 0 for static bodies.
    pub inv_mass: f32,
    /// 1/(kg m^2); 0 for static bodies.
    pub inv_inertia: f32,
}

impl SolverBody {
    pub fn stop(&mut self) {
        self.velocity = Vector::ZERO;
        self.angular_velocity = 0.0;
    }

    /// Applies an impulse, kg m/s, at a point `arm` away from the centre of mass, m.
    pub fn apply_impulse(&mut self, impulse: Vector, arm: Vector) {
        self.velocity += self.inv_mass * impulse;
        self.angular_velocity += self.inv_inertia * arm.perp_dot(impulse);
    }

    /// Returns the velocity of the point `arm` away from the centre of mass, m/s.
    pub fn velocity_at(&self, arm: Vector) -> Vector {
        self.velocity + self.angular_velocity * arm.perp()
    }

    /// Returns by how much a unit impulse along `direction` at `arm` changes the velocity of this point in this direction,
    /// 1/kg: this body's part of K in Box2D.
    pub fn inv_effective_mass(&self, arm: Vector, direction: Vector) -> f32 {
        let lever = arm.perp_dot(direction);
        self.inv_mass + self.inv_inertia * lever * lever
    }
}

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
    /// AABB of the shape and its skin over the last step.
    pub swept_aabb: Aabb,
    /// AABB of the broad phase: larger, so that it changes seldom.
    pub fat_aabb: Aabb,
    /// Whether the fat AABB has changed since the broad phase looked for new pairs.
    pub moved: bool,
}

impl Fixture {
    fn new(shape: &Shape, body: usize) -> Fixture {
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
            swept_aabb: aabb,
            fat_aabb: aabb,
            moved: true,
        }
    }

    /// Moves the fixture to the frame at the body's centre of mass and computes its bounds.
    fn attach(&mut self, local_centre: Vector, body: &Pose) {
        self.local.translation -= local_centre;
        let sphere = self.shape.compute_bounding_sphere(&self.local);
        self.bounding_radius = sphere.center.length() + sphere.radius;
        self.swept_aabb = self.aabb_at(body);
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

    fn aabb_at(&self, body: &Pose) -> Aabb {
        self.shape.compute_aabb(&(*body * self.local)).loosened(self.skin())
    }

    /// Updates the AABBs after the body has moved from `start` to `end` (b2Fixture::Synchronize). `displacement` is that
    /// of the body's origin, m.
    pub fn synchronize(&mut self, start: &Pose, end: &Pose, displacement: Vector) {
        self.swept_aabb = self.aabb_at(end).merged(&self.aabb_at(start));
        if self.fat_aabb.contains(&self.swept_aabb) {
            return;
        }
        let predicted = displacement * AABB_MULTIPLIER;
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

fn metres([x, y]: [f64; 2]) -> Vector {
    Vector::new((x / PX_PER_METRE) as f32, (y / PX_PER_METRE) as f32)
}

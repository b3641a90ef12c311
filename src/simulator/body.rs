//! Rigid bodies and their motion, built from the scene: b2Body and b2Sweep of Box2D 2.3.
//!
//! Mass properties are rapier's. A body moves about its centre of mass. Used only by the rest of the simulator.

use rapier2d::geometry::ColliderBuilder;
use rapier2d::math::{Pose, Rotation, Vector};
use rapier2d::parry::mass_properties::MassProperties;

use super::constants::{DENSITY, PX_PER_METRE};
use super::fixture::Fixture;
use crate::puzzle::scene::Body;

/// Centre of mass, m, and angle of a body, radians, not wrapped (b2Position).
#[derive(Clone, Copy, Debug, PartialEq)]
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
    /// The position of the last update of its fixtures' AABBs.
    pub synchronized: Position,
    pub awake: bool,
    /// For how long it has been slower than the sleep tolerances, s.
    pub sleep_time: f32,
    /// Its fixtures: a range of the world's.
    pub fixtures: std::ops::Range<usize>,
}

impl RigidBody {
    /// Returns a body of a scene at rest, with its velocity and mass and its fixtures. `index` is the body's index in
    /// the world, `first` that of its first fixture.
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
            synchronized: position,
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

    /// Returns by how much a unit impulse along `direction` at `arm` changes the velocity of this point in this
    /// direction, 1/kg: this body's part of K in Box2D.
    pub fn inv_effective_mass(&self, arm: Vector, direction: Vector) -> f32 {
        let lever = arm.perp_dot(direction);
        self.inv_mass + self.inv_inertia * lever * lever
    }
}

/// Converts a point from px.
pub(crate) fn metres([x, y]: [f64; 2]) -> Vector {
    Vector::new((x / PX_PER_METRE) as f32, (y / PX_PER_METRE) as f32)
}

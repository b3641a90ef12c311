//! Rigid bodies, built from the scene: b2Body.

use std::ops::Range;

use rapier2d::math::Vector;

use super::fixture::Fixture;
use super::math::{Rotation, Transform};
use super::shape::{MassData, Shape};
use super::sweep::Sweep;
use crate::puzzle::scene;
use crate::simulator::constants::DENSITY;
use crate::simulator::units::point_in_metres;

pub(super) struct Body {
    pub(super) dynamic: bool,
    /// Whether it is awake. Meaningless for static bodies.
    pub(super) awake: bool,
    /// How long it has been slower than the sleep tolerances, s.
    pub(super) sleep_time: f32,
    /// The position and rotation of its origin.
    pub(super) transform: Transform,
    pub(super) sweep: Sweep,
    /// Velocity of the centre of mass, m/s.
    pub(super) velocity: Vector,
    /// radians/s
    pub(super) angular_velocity: f32,
    /// 1/kg; 0 for static bodies.
    pub(super) inv_mass: f32,
    /// 1/(kg m^2); 0 for static bodies.
    pub(super) inv_inertia: f32,
    /// The range of its fixtures in the world's list.
    pub(super) fixtures: Range<usize>,
    /// Its contacts, oldest first. Box2D's list has the newest first.
    pub(super) contacts: Vec<usize>,
    pub(super) in_island: bool,
    /// Its index in the island that is being solved.
    pub(super) island_index: usize,
    /// The end of the sweep for which the AABBs of its fixtures were last updated.
    synchronized: Option<(Vector, f32)>,
}

impl Body {
    /// Returns a body at rest and its fixtures, whose indices will start at `first`.
    pub(super) fn new(body: &scene::Body, index: usize, first: usize) -> (Body, Vec<Fixture>) {
        let shapes: Vec<Shape> = body.shapes.iter().map(Shape::new).collect();
        let (origin, angle) = (point_in_metres([body.x, body.y]), body.angle as f32);
        let is_round = shapes.iter().all(Shape::is_circle);
        let rotation = if is_round { Rotation::IDENTITY } else { Rotation::new(angle) };
        let transform = Transform { position: origin, rotation };
        let mut mass = InverseMass::default();
        let mut centre = origin;
        if body.dynamic {
            mass = InverseMass::of(&shapes);
            centre = transform.to_world(mass.local_centre);
        }
        let InverseMass { inv_mass, inv_inertia, local_centre } = mass;
        let fixture = |shape| Fixture::new(index, shape, local_centre, &transform);
        let fixtures: Vec<Fixture> = shapes.into_iter().map(fixture).collect();
        let body = Body {
            dynamic: body.dynamic,
            awake: true,
            sleep_time: 0.0,
            transform,
            sweep: Sweep { local_centre, centre0: centre, centre, angle0: angle, angle, alpha0: 0.0, is_round },
            velocity: Vector::ZERO,
            angular_velocity: 0.0,
            inv_mass,
            inv_inertia,
            fixtures: first..first + fixtures.len(),
            contacts: Vec::new(),
            in_island: false,
            island_index: 0,
            synchronized: None,
        };
        (body, fixtures)
    }

    /// Returns whether it is moving now.
    pub(super) fn is_active(&self) -> bool {
        self.dynamic && self.awake
    }

    /// Wakes the body (SetAwake). Box2D of 2018 resets the sleep timer even if the body is awake.
    pub(super) fn wake(&mut self) {
        self.awake = true;
        self.sleep_time = 0.0;
    }

    /// Stops the body and lets it sleep (SetAwake).
    pub(super) fn sleep(&mut self) {
        self.awake = false;
        self.sleep_time = 0.0;
        self.velocity = Vector::ZERO;
        self.angular_velocity = 0.0;
    }

    /// Moves the body to the end of its sweep; `rotation` is the rotation there (SynchronizeTransform).
    pub(super) fn synchronize_transform(&mut self, rotation: Rotation) {
        self.transform = Transform::about(self.sweep.centre, self.sweep.local_centre, rotation);
    }

    /// Moves the body back to a fraction of the step (Advance).
    pub(super) fn advance(&mut self, alpha: f32) {
        self.sweep.advance(alpha);
        let has_turned = self.sweep.angle0 != self.sweep.angle;
        (self.sweep.centre, self.sweep.angle) = (self.sweep.centre0, self.sweep.angle0);
        let rotation = if has_turned { self.sweep.rotation(self.sweep.angle) } else { self.transform.rotation };
        self.synchronize_transform(rotation);
    }

    /// Undoes `advance`, given the previous sweep.
    pub(super) fn restore_sweep(&mut self, sweep: Sweep) {
        self.sweep = sweep;
        self.synchronize_transform(sweep.rotation(sweep.angle));
    }

    /// Updates the AABBs of the body's fixtures after it has moved (SynchronizeFixtures). `fixtures` are all fixtures
    /// of the world. Returns whether any fat AABB changed.
    pub(super) fn synchronize_fixtures(&mut self, fixtures: &mut [Fixture]) -> bool {
        let sweep = &self.sweep;
        let rotation = if sweep.angle0 == sweep.angle { self.transform.rotation } else { sweep.rotation(sweep.angle0) };
        let start = Transform::about(sweep.centre0, sweep.local_centre, rotation);
        let is_known = self.synchronized == Some((sweep.centre0, sweep.angle0));
        let start_if_new = (!is_known).then_some(&start);
        let displacement = self.transform.position - start.position;
        self.synchronized = Some((sweep.centre, sweep.angle));
        let mut any_moved = false;
        for fixture in &mut fixtures[self.fixtures.clone()] {
            any_moved |= fixture.synchronize(start_if_new, &self.transform, displacement);
        }
        any_moved
    }
}

/// The inverse mass and inertia of a body, with the centre of mass.
#[derive(Default)]
struct InverseMass {
    inv_mass: f32,
    inv_inertia: f32,
    local_centre: Vector,
}

impl InverseMass {
    /// b2Body::ResetMassData. The fixtures are summed newest first, the order of Box2D's list.
    fn of(shapes: &[Shape]) -> InverseMass {
        let (mut mass, mut moment, mut inertia) = (0.0, Vector::ZERO, 0.0);
        for shape in shapes.iter().rev() {
            let data: MassData = shape.mass_data(DENSITY);
            mass += data.mass;
            moment += data.mass * data.centre;
            inertia += data.inertia;
        }
        let inv_mass = 1.0 / mass;
        let local_centre = inv_mass * moment;
        inertia -= mass * local_centre.dot(local_centre);
        InverseMass { inv_mass, inv_inertia: 1.0 / inertia, local_centre }
    }
}

//! Bodies connected by touching contacts, which are solved and put to sleep together: b2Island.

use rapier2d::math::Vector;

use super::body::Body;
use super::contact_manager::ContactManager;
use super::contact_solver::{
    Position, PositionConstraint, Velocity, VelocityConstraint, solve_position_constraints, solve_velocity_constraints,
};
use super::fixture::Fixture;
use super::math::{length, min};
use crate::simulator::constants::{
    ANGULAR_DAMPING, ANGULAR_SLEEP_TOLERANCE, BAUMGARTE, GRAVITY, LINEAR_SLEEP_TOLERANCE, LINEAR_SLOP, MAX_ROTATION,
    MAX_TRANSLATION, POSITION_ITERATIONS, TIME_STEP, TIME_TO_SLEEP, TOI_BAUMGARTE,
};

/// An island. Between two steps, only its allocated memory is kept.
#[derive(Default)]
pub(super) struct Island {
    /// Indices of its bodies in the world.
    pub(super) bodies: Vec<usize>,
    /// Ids of its contacts.
    pub(super) contacts: Vec<usize>,
    positions: Vec<Position>,
    velocities: Vec<Velocity>,
    velocity_constraints: Vec<VelocityConstraint>,
    position_constraints: Vec<PositionConstraint>,
}

impl Island {
    pub(super) fn clear(&mut self) {
        self.bodies.clear();
        self.contacts.clear();
    }

    /// Adds a body and sets its index in the island.
    pub(super) fn add(&mut self, index: usize, body: &mut Body) {
        body.island_index = self.bodies.len();
        self.bodies.push(index);
    }

    /// Integrates forces, solves velocities, integrates positions and corrects them: one step of the island (Solve).
    pub(super) fn solve(&mut self, bodies: &mut [Body], fixtures: &[Fixture], contacts: &mut ContactManager) {
        self.positions.clear();
        self.velocities.clear();
        for &index in &self.bodies {
            let body = &mut bodies[index];
            (body.sweep.centre0, body.sweep.angle0) = (body.sweep.centre, body.sweep.angle);
            let mut velocity = Velocity::new(body.velocity, body.angular_velocity);
            if body.dynamic {
                velocity.linear += TIME_STEP * Vector::new(0.0, GRAVITY);
                velocity.angular *= 1.0 / (1.0 + TIME_STEP * ANGULAR_DAMPING);
            }
            self.positions.push(Position::new(body));
            self.velocities.push(velocity);
        }
        self.prepare_positions(bodies, fixtures, contacts);
        self.prepare_velocities(bodies, fixtures, contacts, true);
        self.velocity_constraints.iter().for_each(|constraint| constraint.warm_start(&mut self.velocities));
        solve_velocity_constraints(&mut self.velocity_constraints, &mut self.velocities);
        for (constraint, &contact) in self.velocity_constraints.iter().zip(&self.contacts) {
            constraint.store_impulses(&mut contacts[contact].manifold);
        }
        self.integrate_positions(TIME_STEP);
        let is_solved = self.solve_positions(BAUMGARTE, -3.0 * LINEAR_SLOP);
        self.move_bodies(bodies);
        self.update_sleep(bodies, is_solved);
    }

    /// Solves the two bodies of a time of impact, the first two of the island, at their current positions, and moves
    /// them for the rest of the step, s (SolveTOI). All other bodies are static, so they need not be held.
    pub(super) fn solve_toi(
        &mut self,
        bodies: &mut [Body],
        fixtures: &[Fixture],
        contacts: &ContactManager,
        time: f32,
    ) {
        self.positions.clear();
        self.velocities.clear();
        for &index in &self.bodies {
            let body = &bodies[index];
            self.positions.push(Position::new(body));
            self.velocities.push(Velocity::new(body.velocity, body.angular_velocity));
        }
        self.prepare_positions(bodies, fixtures, contacts);
        self.solve_positions(TOI_BAUMGARTE, -1.5 * LINEAR_SLOP);
        for (&index, position) in self.bodies.iter().zip(&self.positions).take(2) {
            let sweep = &mut bodies[index].sweep;
            (sweep.centre0, sweep.angle0) = (position.centre, position.angle);
        }
        // No warm starting, and no impulses are stored for it.
        self.prepare_velocities(bodies, fixtures, contacts, false);
        solve_velocity_constraints(&mut self.velocity_constraints, &mut self.velocities);
        self.integrate_positions(time);
        self.move_bodies(bodies);
    }

    fn prepare_positions(&mut self, bodies: &[Body], fixtures: &[Fixture], contacts: &ContactManager) {
        self.position_constraints.clear();
        self.position_constraints.extend(self.contacts.iter().map(|&id| {
            let contact = &contacts[id];
            let fixtures = contact.fixtures.map(|fixture| &fixtures[fixture]);
            PositionConstraint::new(&contact.manifold, fixtures, contact.bodies.map(|body| &bodies[body]))
        }));
    }

    fn prepare_velocities(
        &mut self,
        bodies: &[Body],
        fixtures: &[Fixture],
        contacts: &ContactManager,
        warm_starting: bool,
    ) {
        let (positions, velocities) = (&self.positions, &self.velocities);
        self.velocity_constraints.clear();
        self.velocity_constraints.extend(self.contacts.iter().map(|&id| {
            let contact = &contacts[id];
            let fixtures = contact.fixtures.map(|fixture| &fixtures[fixture]);
            let bodies = contact.bodies.map(|body| &bodies[body]);
            VelocityConstraint::new(&contact.manifold, fixtures, bodies, positions, velocities, warm_starting)
        }));
    }

    /// Moves the positions by the velocities, which are limited first, for a time, s.
    fn integrate_positions(&mut self, time: f32) {
        for (position, velocity) in self.positions.iter_mut().zip(&mut self.velocities) {
            let translation = time * velocity.linear;
            if translation.dot(translation) > MAX_TRANSLATION * MAX_TRANSLATION {
                velocity.linear *= MAX_TRANSLATION / length(translation);
            }
            let rotation = time * velocity.angular;
            if rotation * rotation > MAX_ROTATION * MAX_ROTATION {
                velocity.angular *= MAX_ROTATION / rotation.abs();
            }
            position.centre += time * velocity.linear;
            position.turn_to(position.angle + time * velocity.angular);
        }
    }

    /// Iterates until no separation is below `tolerance`, m. Returns whether this was reached.
    fn solve_positions(&mut self, baumgarte: f32, tolerance: f32) -> bool {
        (0..POSITION_ITERATIONS).any(|_| {
            solve_position_constraints(&self.position_constraints, &mut self.positions, baumgarte) >= tolerance
        })
    }

    /// Copies positions and velocities back to the bodies.
    fn move_bodies(&self, bodies: &mut [Body]) {
        for ((&index, position), velocity) in self.bodies.iter().zip(&self.positions).zip(&self.velocities) {
            let body = &mut bodies[index];
            (body.sweep.centre, body.sweep.angle) = (position.centre, position.angle);
            (body.velocity, body.angular_velocity) = (velocity.linear, velocity.angular);
            body.synchronize_transform(position.rotation());
        }
    }

    /// Puts the island to sleep if all its bodies have been slow for long enough.
    fn update_sleep(&self, bodies: &mut [Body], is_solved: bool) {
        let mut min_sleep_time = f32::MAX;
        for &index in &self.bodies {
            let body = &mut bodies[index];
            if !body.dynamic {
                continue;
            }
            let (v, w) = (body.velocity, body.angular_velocity);
            let is_slow = w * w <= ANGULAR_SLEEP_TOLERANCE * ANGULAR_SLEEP_TOLERANCE
                && v.dot(v) <= LINEAR_SLEEP_TOLERANCE * LINEAR_SLEEP_TOLERANCE;
            body.sleep_time = if is_slow { body.sleep_time + TIME_STEP } else { 0.0 };
            min_sleep_time = min(min_sleep_time, body.sleep_time);
        }
        if min_sleep_time >= TIME_TO_SLEEP && is_solved {
            self.bodies.iter().for_each(|&index| bodies[index].sleep());
        }
    }
}

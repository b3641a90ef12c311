//! The world and its step: b2World::Step and b2ContactManager of Box2D 2.3.
//!
//! A step finds new contacts, updates all, solves the islands (`island`) and then the times of impact (`toi_solver`).
//! rapier's own pipeline (`rapier_world`) solves softer contacts in another order, which no parameter changes;
//! therefore only its geometry is used here. The orders of bodies and contacts are those of Box2D's lists (newest
//! first), because the result of a Gauss-Seidel solver depends on the order.

use rapier2d::math::{Pose, Vector};
use rapier2d::parry::bounding_volume::BoundingVolume;

use super::body::{RigidBody, SolverBody};
use super::contact::Contact;
use super::contact_solver::VelocityConstraint;
use super::fixture::Fixture;
use super::island::Island;
use super::simulation::EngineWorld;
use crate::puzzle::scene::Body;

#[derive(Default)]
pub struct World {
    pub bodies: Vec<RigidBody>,
    /// One for each body.
    pub(super) solver_bodies: Vec<SolverBody>,
    pub(super) fixtures: Vec<Fixture>,
    /// Oldest first.
    pub(super) contacts: Vec<Contact>,
    // Kept from step to step only to save allocations.
    pub(super) constraints: Vec<VelocityConstraint>,
    pub(super) island: Island,
    pub(super) in_island: Vec<bool>,
    pub(super) stack: Vec<usize>,
    moved: Vec<usize>,
}

impl EngineWorld for World {
    fn add(&mut self, body: &Body) -> usize {
        let index = self.bodies.len();
        let (body, solver_body, fixtures) = RigidBody::new(body, index, self.fixtures.len());
        self.bodies.push(body);
        self.solver_bodies.push(solver_body);
        self.fixtures.extend(fixtures);
        index
    }

    fn is_awake(&self) -> bool {
        self.bodies.iter().any(|body| body.awake)
    }

    fn has_touching_contact(&self, a: usize, b: usize) -> bool {
        self.contacts.iter().any(|contact| contact.touching && (contact.bodies == [a, b] || contact.bodies == [b, a]))
    }

    fn step(&mut self) {
        self.find_new_contacts();
        self.update_contacts();
        self.solve_islands();
        self.find_new_contacts();
        self.solve_toi();
    }

    fn origin(&self, body: usize) -> Vector {
        self.bodies[body].origin()
    }

    fn angle(&self, body: usize) -> f32 {
        self.bodies[body].sweep.position.angle
    }
}

impl World {
    /// The broad phase: adds a contact for every new pair of fixtures whose fat AABBs overlap.
    pub(super) fn find_new_contacts(&mut self) {
        self.moved.clear();
        self.moved.extend((0..self.fixtures.len()).filter(|&fixture| self.fixtures[fixture].moved));
        if self.moved.is_empty() {
            return;
        }
        let moved = std::mem::take(&mut self.moved);
        for a in 0..self.fixtures.len() {
            // Two fixtures that have not moved are no new pair.
            if self.fixtures[a].moved {
                (a + 1..self.fixtures.len()).for_each(|b| self.add_contact_if_near(a, b));
            } else {
                moved.iter().filter(|&&b| b > a).for_each(|&b| self.add_contact_if_near(a, b));
            }
        }
        moved.iter().for_each(|&fixture| self.fixtures[fixture].moved = false);
        self.moved = moved;
    }

    fn add_contact_if_near(&mut self, a: usize, b: usize) {
        let (first, second) = (&self.fixtures[a], &self.fixtures[b]);
        if first.fat_aabb.intersects(&second.fat_aabb)
            && first.body != second.body
            && (self.bodies[first.body].dynamic || self.bodies[second.body].dynamic)
            && !self.contacts.iter().any(|contact| contact.fixtures == [a, b] || contact.fixtures == [b, a])
        {
            self.contacts.push(Contact::new([a, b], &self.fixtures));
        }
    }

    /// The narrow phase: removes contacts whose fat AABBs no longer overlap, and updates the others of bodies that are
    /// awake.
    fn update_contacts(&mut self) {
        let mut index = self.contacts.len();
        while index > 0 {
            index -= 1;
            let contact = &self.contacts[index];
            if !contact.bodies.iter().any(|&body| self.bodies[body].awake) {
                continue;
            }
            let [a, b] = contact.fixtures.map(|fixture| &self.fixtures[fixture].fat_aabb);
            if a.intersects(b) {
                self.update_contact(index);
            } else {
                let contact = self.contacts.remove(index);
                if contact.touching {
                    self.wake(contact.bodies);
                }
            }
        }
    }

    pub(super) fn update_contact(&mut self, index: usize) {
        let contact = &mut self.contacts[index];
        let was_touching = contact.touching;
        contact.update(&self.fixtures, &self.bodies);
        let bodies = contact.bodies;
        if contact.touching != was_touching {
            self.wake(bodies);
        }
    }

    pub(super) fn wake(&mut self, bodies: [usize; 2]) {
        bodies.iter().for_each(|&body| self.bodies[body].wake());
    }

    /// Updates the AABBs of a body's fixtures after it has moved (b2Body::SynchronizeFixtures).
    pub(super) fn synchronize_fixtures(&mut self, body: usize) {
        let body = &mut self.bodies[body];
        if !body.dynamic {
            return;
        }
        let start = body.sweep.position0;
        let start_pose = (start != body.synchronized).then(|| start.pose());
        let displacement = || {
            let Pose { rotation, translation } = start_pose.unwrap_or_else(|| start.pose());
            body.origin() - (translation - rotation * body.local_centre)
        };
        for fixture in &mut self.fixtures[body.fixtures.clone()] {
            fixture.synchronize(start_pose.as_ref(), &body.pose(), displacement);
        }
        body.synchronized = body.sweep.position;
    }
}

#[cfg(test)]
mod tests {
    use super::super::constants::{GRAVITY, TIME_STEP, TIME_TO_SLEEP};
    use super::*;
    use crate::puzzle::action::Ball;
    use crate::puzzle::scene::walls;

    /// A world of balls, px, with their velocities, m/s; without walls.
    fn flying(balls: &[(Ball, Vector)]) -> World {
        let mut world = World::default();
        for &(ball, velocity) in balls {
            let index = world.add(&ball.body());
            world.solver_bodies[index].velocity = velocity;
        }
        world
    }

    /// Total mass, linear momentum and angular momentum about the origin, SI units.
    fn momentum(world: &World) -> (f32, Vector, f32) {
        let bodies = world.bodies.iter().zip(&world.solver_bodies);
        bodies.fold((0.0, Vector::ZERO, 0.0), |(mass, linear, angular), (body, solver_body)| {
            let momentum = solver_body.velocity / solver_body.inv_mass;
            let spin = solver_body.angular_velocity / solver_body.inv_inertia;
            let orbital = body.sweep.position.centre.perp_dot(momentum);
            (mass + 1.0 / solver_body.inv_mass, linear + momentum, angular + orbital + spin)
        })
    }

    #[test]
    fn a_free_collision_conserves_momentum() {
        // Off-centre, so that friction spins the balls; slow, so that the position correction stays small.
        let left = Ball { x: 100.0, y: 100.0, r: 6.0 };
        let right = Ball { x: 119.5, y: 105.0, r: 12.0 };
        let mut world = flying(&[(left, Vector::new(2.0, 0.0)), (right, Vector::new(-1.0, 0.5))]);
        let relative_velocity = |world: &World| world.solver_bodies[1].velocity - world.solver_bodies[0].velocity;
        let ((mass, linear, _), before) = (momentum(&world), relative_velocity(&world));
        let mut touched = false;
        for step in 1..=30 {
            // Gravity is a force from outside; its torque is that on the centre of mass.
            let (_, _, angular) = momentum(&world);
            let torque = world
                .bodies
                .iter()
                .zip(&world.solver_bodies)
                .map(|(body, solver_body)| body.sweep.position.centre.x * GRAVITY / solver_body.inv_mass);
            let expected_angular = angular + TIME_STEP * torque.sum::<f32>();
            let expected_linear = linear + Vector::new(0.0, mass * GRAVITY * TIME_STEP * step as f32);
            world.step();
            touched |= world.has_touching_contact(0, 1);
            let (_, linear, angular) = momentum(&world);
            assert!((linear - expected_linear).length() < 1e-3 * expected_linear.length(), "step {step}");
            assert!(
                (angular - expected_angular).abs() < 2e-3 * expected_angular.abs(),
                "step {step}: {angular} {expected_angular}"
            );
        }
        assert!(touched, "the balls collide");
        assert!(world.solver_bodies.iter().any(|body| body.angular_velocity.abs() > 0.1), "friction spins them");
        assert!((relative_velocity(&world) - before).length() > 1.0, "the collision changes their velocities");
    }

    #[test]
    fn a_head_on_collision_separates_by_the_restitution_unless_it_is_slow() {
        for (approach, separation) in [(20.0, 0.2 * 20.0), (1.1, 0.2 * 1.1), (0.9, 0.0)] {
            let ball = |x, r| Ball { x, y: 100.0, r };
            let velocity = Vector::new(approach / 2.0, 0.0);
            let mut world = flying(&[(ball(100.0, 6.0), velocity), (ball(118.1, 12.0), -velocity)]);
            for _ in 0..30 {
                world.step();
            }
            let found = world.solver_bodies[1].velocity.x - world.solver_bodies[0].velocity.x;
            assert!((found - separation).abs() < 1e-3, "{found} m/s after {approach} m/s");
        }
    }

    #[test]
    fn a_body_at_rest_falls_asleep_and_wakes_when_it_is_hit() {
        let mut world = World::default();
        for wall in walls() {
            world.add(&wall);
        }
        let resting = world.add(&Ball { x: 100.0, y: 10.05, r: 10.0 }.body());
        let mut asleep_after = 0;
        while world.is_awake() {
            world.step();
            asleep_after += 1;
            assert!(asleep_after < 120, "it stays awake");
        }
        assert!(asleep_after as f32 * TIME_STEP >= TIME_TO_SLEEP, "asleep after {asleep_after} steps");
        let at_rest = world.bodies[resting].sweep.position.centre;

        let falling = world.add(&Ball { x: 103.0, y: 100.0, r: 10.0 }.body());
        while !world.has_touching_contact(resting, falling) {
            assert!(!world.bodies[resting].awake && world.bodies[falling].awake);
            assert_eq!(world.bodies[resting].sweep.position.centre, at_rest, "a sleeping body does not move");
            world.step();
        }
        assert!(world.bodies[resting].awake, "a new contact wakes it");
        for _ in 0..30 {
            world.step();
        }
        assert!(world.bodies[resting].sweep.position.centre.x < at_rest.x, "it is pushed aside");
    }
}

//! The world and its step: b2World::Step and b2ContactManager of Box2D 2.3.
//!
//! A step finds new contacts, updates all, solves the islands (`island`) and then the times of impact (`toi_solver`).
//! rapier's own pipeline solves softer contacts in another order, which no parameter changes; therefore only its geometry
//! is used. The orders of bodies and contacts are those of Box2D's lists (newest first), because the result of a
//! Gauss-Seidel solver depends on the order.

use rapier2d::parry::bounding_volume::BoundingVolume;

use super::body::{Fixture, RigidBody, SolverBody};
use super::contact::Contact;
use super::contact_solver::VelocityConstraint;
use super::island::Island;
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
}

impl World {
    /// Adds a body; returns its index.
    pub fn add(&mut self, body: &Body) -> usize {
        let index = self.bodies.len();
        let (body, solver_body, fixtures) = RigidBody::new(body, index, self.fixtures.len());
        self.bodies.push(body);
        self.solver_bodies.push(solver_body);
        self.fixtures.extend(fixtures);
        index
    }

    /// Whether any body is awake. Nothing moves otherwise.
    pub fn is_awake(&self) -> bool {
        self.bodies.iter().any(|body| body.awake)
    }

    /// Whether two bodies had a touching contact when it was last updated.
    pub fn has_touching_contact(&self, a: usize, b: usize) -> bool {
        self.contacts.iter().any(|contact| contact.touching && (contact.bodies == [a, b] || contact.bodies == [b, a]))
    }

    /// Simulates one `TIME_STEP`.
    pub fn step(&mut self) {
        self.find_new_contacts();
        self.update_contacts();
        self.solve_islands();
        self.find_new_contacts();
        self.solve_toi();
    }

    /// The broad phase: adds a contact for every new pair of fixtures whose fat AABBs overlap.
    pub(super) fn find_new_contacts(&mut self) {
        if !self.fixtures.iter().any(|fixture| fixture.moved) {
            return;
        }
        for a in 0..self.fixtures.len() {
            for b in a + 1..self.fixtures.len() {
                let (first, second) = (&self.fixtures[a], &self.fixtures[b]);
                let candidates = (first.moved || second.moved) && first.body != second.body;
                let dynamic = self.bodies[first.body].dynamic || self.bodies[second.body].dynamic;
                if candidates
                    && dynamic
                    && first.fat_aabb.intersects(&second.fat_aabb)
                    && !self.contacts.iter().any(|contact| contact.fixtures == [a, b] || contact.fixtures == [b, a])
                {
                    self.contacts.push(Contact::new([a, b], &self.fixtures));
                }
            }
        }
        self.fixtures.iter_mut().for_each(|fixture| fixture.moved = false);
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
        let body = &self.bodies[body];
        if !body.dynamic {
            return;
        }
        let start = body.sweep.position0.pose();
        let origin = start.translation - start.rotation * body.local_centre;
        let displacement = body.origin() - origin;
        for fixture in &mut self.fixtures[body.fixtures.clone()] {
            fixture.synchronize(&start, &body.pose(), displacement);
        }
    }
}

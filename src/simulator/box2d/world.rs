//! The world and its step: b2World.
//!
//! A step finds new contacts, updates all contacts, and solves first the islands and then the times of impact. Bodies
//! and contacts are in the order of Box2D's lists, newest first, because the result of a Gauss-Seidel solver depends on
//! the order.

use rapier2d::math::Vector;
use rapier2d::parry::bounding_volume::BoundingVolume;

use super::body::Body;
use super::contact_manager::ContactManager;
use super::fixture::Fixture;
use super::island::Island;
use super::manifold::Kind;
use super::math::{max, min};
use super::time_of_impact::{MARGIN, arc_height, stays_apart, time_of_impact};
use crate::puzzle::scene;
use crate::simulator::constants::{MAX_TOI_CONTACTS, MAX_TOI_SUBSTEPS, TIME_STEP};
use crate::simulator::simulation::EngineWorld;

#[derive(Default)]
pub struct World {
    pub(super) bodies: Vec<Body>,
    pub(super) fixtures: Vec<Fixture>,
    pub(super) contact_manager: ContactManager,
    // Kept from step to step only to save allocations.
    island: Island,
    stack: Vec<usize>,
}

impl EngineWorld for World {
    fn add(&mut self, body: &scene::Body) -> usize {
        let index = self.bodies.len();
        let (body, fixtures) = Body::new(body, index, self.fixtures.len());
        self.bodies.push(body);
        self.fixtures.extend(fixtures);
        self.contact_manager.any_moved = true;
        index
    }

    fn is_awake(&self) -> bool {
        self.bodies.iter().any(Body::is_active)
    }

    fn has_touching_contact(&self, a: usize, b: usize) -> bool {
        let mut contacts = self.bodies[a].contacts.iter().map(|&id| &self.contact_manager[id]);
        contacts.any(|contact| contact.touching && contact.other(a) == b)
    }

    fn step(&mut self) {
        self.contact_manager.find_new_contacts(&mut self.bodies, &mut self.fixtures);
        self.contact_manager.collide(&mut self.bodies, &self.fixtures);
        self.solve();
        self.contact_manager.find_new_contacts(&mut self.bodies, &mut self.fixtures);
        self.solve_toi();
    }

    fn origin(&self, body: usize) -> Vector {
        self.bodies[body].transform.position
    }

    fn angle(&self, body: usize) -> f32 {
        self.bodies[body].sweep.angle
    }
}

impl World {
    /// Returns the bodies of each touching contact. A pair occurs once for each pair of its fixtures that touch.
    pub(crate) fn touching_pairs(&self) -> impl Iterator<Item = [usize; 2]> {
        let contacts = self.contact_manager.order.iter().map(|&id| &self.contact_manager[id]);
        contacts.filter(|contact| contact.touching).map(|contact| contact.bodies)
    }

    /// Returns the pairs of bodies in contact before the first step, by their indices, ascending, and the depth by
    /// which the shapes of each contact overlap, m.
    pub(crate) fn depths(&mut self) -> Vec<([usize; 2], f32)> {
        self.contact_manager.find_new_contacts(&mut self.bodies, &mut self.fixtures);
        let order = self.contact_manager.order.clone();
        let contacts = order.into_iter().map(|id| {
            let contact = &mut self.contact_manager[id];
            contact.update(&mut self.bodies, &self.fixtures);
            let [a, b] = contact.bodies;
            ([a.min(b), a.max(b)], contact.depth(&self.bodies, &self.fixtures))
        });
        contacts.collect()
    }

    /// Solves the islands one by one (Solve).
    fn solve(&mut self) {
        self.bodies.iter_mut().for_each(|body| body.in_island = false);
        self.contact_manager.contacts_mut().for_each(|contact| contact.in_island = false);
        for seed in (0..self.bodies.len()).rev() {
            if self.bodies[seed].in_island || !self.bodies[seed].is_active() {
                continue;
            }
            self.build_island(seed);
            self.island.solve(&mut self.bodies, &self.fixtures, &mut self.contact_manager);
            // A static body may belong to several islands.
            for &body in &self.island.bodies {
                self.bodies[body].in_island &= self.bodies[body].dynamic;
            }
        }
        for body in self.bodies.iter_mut().filter(|body| body.in_island) {
            self.contact_manager.any_moved |= body.synchronize_fixtures(&mut self.fixtures);
        }
    }

    /// Collects the island of a body by depth-first search over its touching contacts. Static bodies end a branch.
    fn build_island(&mut self, seed: usize) {
        self.island.clear();
        self.stack.push(seed);
        self.bodies[seed].in_island = true;
        while let Some(index) = self.stack.pop() {
            let body = &mut self.bodies[index];
            self.island.add(index, body);
            // The sleep timer continues.
            body.awake = true;
            if !body.dynamic {
                continue;
            }
            for at in (0..self.bodies[index].contacts.len()).rev() {
                let id = self.bodies[index].contacts[at];
                let contact = &mut self.contact_manager[id];
                if contact.in_island || !contact.enabled || !contact.touching {
                    continue;
                }
                contact.in_island = true;
                self.island.contacts.push(id);
                let other = contact.other(index);
                if !std::mem::replace(&mut self.bodies[other].in_island, true) {
                    self.stack.push(other);
                }
            }
        }
    }

    /// Continuous collision: handles, one after another, the times within the step at which a dynamic body meets a
    /// static one (SolveTOI).
    fn solve_toi(&mut self) {
        for body in &mut self.bodies {
            body.in_island = false;
            body.sweep.alpha0 = 0.0;
        }
        for contact in self.contact_manager.contacts_mut() {
            (contact.toi, contact.toi_count, contact.in_island) = (None, 0, false);
        }
        while let Some((contact, alpha)) = self.min_toi_contact() {
            self.solve_toi_event(contact, alpha);
        }
    }

    /// Returns the contact with the earliest time of impact, and that time as a fraction of the step.
    fn min_toi_contact(&mut self) -> Option<(usize, f32)> {
        let (mut min_contact, mut min_alpha) = (None, 1.0);
        for index in (0..self.contact_manager.order.len()).rev() {
            let id = self.contact_manager.order[index];
            let contact = &self.contact_manager[id];
            if !contact.enabled || contact.toi_count > MAX_TOI_SUBSTEPS {
                continue;
            }
            let alpha = match contact.toi {
                Some(alpha) => alpha,
                None => {
                    let [a, b] = contact.bodies.map(|body| &self.bodies[body]);
                    // Contacts of two dynamic bodies are left to the discrete solver.
                    if a.dynamic == b.dynamic || !(a.is_active() || b.is_active()) {
                        continue;
                    }
                    let alpha = self.contact_toi(id);
                    self.contact_manager[id].toi = Some(alpha);
                    alpha
                }
            };
            if alpha < min_alpha {
                (min_contact, min_alpha) = (Some(id), alpha);
            }
        }
        let contact = min_contact.filter(|_| min_alpha <= 1.0 - 10.0 * f32::EPSILON)?;
        Some((contact, min_alpha))
    }

    /// Returns the time of impact of a contact as a fraction of the step; 1 if there is none.
    fn contact_toi(&mut self, id: usize) -> f32 {
        let contact = &self.contact_manager[id];
        let [a, b] = contact.bodies;
        // Both sweeps must begin at the same time, even if there is no impact.
        let alpha0 = max(self.bodies[a].sweep.alpha0, self.bodies[b].sweep.alpha0);
        for body in [a, b] {
            if self.bodies[body].sweep.alpha0 < alpha0 {
                self.bodies[body].sweep.advance(alpha0);
            }
        }
        if self.stays_apart(id) {
            return 1.0;
        }
        let [shape_a, shape_b] = contact.fixtures.map(|fixture| &self.fixtures[fixture].shape);
        match time_of_impact(shape_a, &self.bodies[a].sweep, shape_b, &self.bodies[b].sweep) {
            Some(beta) => min(alpha0 + (1.0 - alpha0) * beta, 1.0),
            None => 1.0,
        }
    }

    /// Returns whether a contact certainly has no time of impact. This is a shortcut that tests the bounding boxes,
    /// then the direction of the contact's normal.
    fn stays_apart(&self, id: usize) -> bool {
        let contact = &self.contact_manager[id];
        let normal = match contact.manifold.kind {
            _ if contact.manifold.is_empty() => Vector::ZERO,
            Kind::Circles => Vector::ZERO,
            Kind::FaceA => self.bodies[contact.bodies[0]].transform.rotation.rotate(contact.manifold.local_normal),
            Kind::FaceB => -self.bodies[contact.bodies[1]].transform.rotation.rotate(contact.manifold.local_normal),
        };
        let [a, b] = contact.bodies.map(|body| &self.bodies[body]);
        let [fixture_a, fixture_b] = contact.fixtures.map(|fixture| &self.fixtures[fixture]);
        let (fixed, fixed_fixture, moving, moving_fixture, normal) =
            if a.dynamic { (b, fixture_b, a, fixture_a, -normal) } else { (a, fixture_a, b, fixture_b, normal) };
        let margin = MARGIN + arc_height(&moving.sweep, moving_fixture.reach);
        // A NaN rotation has no bounds.
        if margin.is_nan() {
            return false;
        }
        !fixed_fixture.aabb.loosened(margin).intersects(&moving_fixture.swept_aabb)
            || stays_apart(
                (&fixed_fixture.shape, &fixed.transform),
                (&moving_fixture.shape, &moving.sweep, &moving.transform),
                moving_fixture.reach,
                normal,
            )
    }

    /// Moves the two bodies of a contact back to their time of impact, solves them there with the static bodies that
    /// they touch, and completes their step.
    fn solve_toi_event(&mut self, id: usize, alpha: f32) {
        let bodies = self.contact_manager[id].bodies;
        let backups = bodies.map(|body| self.bodies[body].sweep);
        bodies.iter().for_each(|&body| self.bodies[body].advance(alpha));
        let contact = &mut self.contact_manager[id];
        contact.update(&mut self.bodies, &self.fixtures);
        contact.toi = None;
        contact.toi_count += 1;
        if !contact.touching {
            contact.enabled = false;
            bodies.into_iter().zip(backups).for_each(|(body, sweep)| self.bodies[body].restore_sweep(sweep));
            return;
        }
        contact.in_island = true;
        self.island.clear();
        self.island.contacts.push(id);
        for body in bodies {
            self.bodies[body].wake();
            self.bodies[body].in_island = true;
            self.island.add(body, &mut self.bodies[body]);
        }
        for body in bodies {
            if self.bodies[body].dynamic {
                self.add_touched_static_bodies(body, alpha);
            }
        }
        self.island.solve_toi(&mut self.bodies, &self.fixtures, &self.contact_manager, (1.0 - alpha) * TIME_STEP);
        for &index in &self.island.bodies {
            let body = &mut self.bodies[index];
            body.in_island = false;
            if !body.dynamic {
                continue;
            }
            self.contact_manager.any_moved |= body.synchronize_fixtures(&mut self.fixtures);
            for &id in &body.contacts {
                let contact = &mut self.contact_manager[id];
                (contact.toi, contact.in_island) = (None, false);
            }
        }
        self.contact_manager.find_new_contacts(&mut self.bodies, &mut self.fixtures);
    }

    /// Adds the static bodies that a body touches at a fraction of the step to the island, with their contacts.
    fn add_touched_static_bodies(&mut self, body: usize, alpha: f32) {
        for at in (0..self.bodies[body].contacts.len()).rev() {
            if self.island.contacts.len() == MAX_TOI_CONTACTS {
                break;
            }
            let id = self.bodies[body].contacts[at];
            let contact = &mut self.contact_manager[id];
            let other = contact.other(body);
            if contact.in_island || self.bodies[other].dynamic {
                continue;
            }
            let backup = self.bodies[other].sweep;
            if !self.bodies[other].in_island {
                self.bodies[other].advance(alpha);
            }
            contact.update(&mut self.bodies, &self.fixtures);
            if !contact.touching {
                self.bodies[other].restore_sweep(backup);
                continue;
            }
            contact.in_island = true;
            self.island.contacts.push(id);
            if !std::mem::replace(&mut self.bodies[other].in_island, true) {
                self.island.add(other, &mut self.bodies[other]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::action::Ball;
    use crate::puzzle::scene::walls;
    use crate::simulator::constants::{GRAVITY, TIME_TO_SLEEP};

    /// A world of balls, px, with their velocities, m/s, without walls.
    fn flying(balls: &[(Ball, Vector)]) -> World {
        let mut world = World::default();
        for &(ball, velocity) in balls {
            let index = world.add(&ball.body());
            world.bodies[index].velocity = velocity;
        }
        world
    }

    /// Returns the total mass, linear momentum and angular momentum about the origin, SI units.
    fn momentum(world: &World) -> (f32, Vector, f32) {
        world.bodies.iter().fold((0.0, Vector::ZERO, 0.0), |(mass, linear, angular), body| {
            let momentum = body.velocity / body.inv_mass;
            let spin = body.angular_velocity / body.inv_inertia;
            let orbital = body.sweep.centre.perp_dot(momentum);
            (mass + 1.0 / body.inv_mass, linear + momentum, angular + orbital + spin)
        })
    }

    #[test]
    fn a_free_collision_conserves_momentum() {
        // Off-centre, so that friction spins the balls; slow, so that the position correction stays small.
        let left = Ball { x: 100.0, y: 100.0, r: 6.0 };
        let right = Ball { x: 119.5, y: 105.0, r: 12.0 };
        let mut world = flying(&[(left, Vector::new(2.0, 0.0)), (right, Vector::new(-1.0, 0.5))]);
        let relative_velocity = |world: &World| world.bodies[1].velocity - world.bodies[0].velocity;
        let ((mass, linear, _), before) = (momentum(&world), relative_velocity(&world));
        let mut touched = false;
        for step in 1..=30 {
            // Gravity is an external force; its torque is that on the centre of mass.
            let (_, _, angular) = momentum(&world);
            let torque = world.bodies.iter().map(|body| body.sweep.centre.x * GRAVITY / body.inv_mass);
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
        assert!(world.bodies.iter().any(|body| body.angular_velocity.abs() > 0.1), "friction spins them");
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
            let found = world.bodies[1].velocity.x - world.bodies[0].velocity.x;
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
        let at_rest = world.bodies[resting].sweep.centre;

        let falling = world.add(&Ball { x: 103.0, y: 100.0, r: 10.0 }.body());
        while !world.bodies[resting].awake {
            assert_eq!(world.bodies[resting].sweep.centre, at_rest, "a sleeping body does not move");
            world.step();
        }
        assert!(!world.has_touching_contact(resting, falling), "a body that comes near wakes it");
        while !world.has_touching_contact(resting, falling) {
            world.step();
        }
        for _ in 0..30 {
            world.step();
        }
        assert!(world.bodies[resting].sweep.centre.x < at_rest.x, "it is pushed aside");
    }
}

//! Islands: bodies that are connected by touching contacts, solved and put to sleep together (b2World::Solve and
//! b2Island::Solve of Box2D 2.3).

use super::body::Position;
use super::constants::{
    ANGULAR_DAMPING, ANGULAR_SLEEP_TOLERANCE, BAUMGARTE, GRAVITY, LINEAR_SLEEP_TOLERANCE, LINEAR_SLOP, MAX_ROTATION,
    MAX_TRANSLATION, POSITION_ITERATIONS, TIME_STEP, TIME_TO_SLEEP,
};
use super::contact_solver::{VelocityConstraint, solve_velocity_constraints, store_impulses};
use super::position_solver::solve_position_constraint;
use super::scalar::{length, min};
use super::world::World;

/// Bodies and contacts of an island, in the order in which they are solved.
#[derive(Default)]
pub(crate) struct Island {
    pub bodies: Vec<usize>,
    pub contacts: Vec<usize>,
}

impl World {
    pub(super) fn solve_islands(&mut self) {
        self.contacts.iter_mut().for_each(|contact| contact.in_island = false);
        let (mut in_island, mut island) = (std::mem::take(&mut self.in_island), std::mem::take(&mut self.island));
        in_island.clear();
        in_island.resize(self.bodies.len(), false);
        for seed in (0..self.bodies.len()).rev() {
            if !in_island[seed] && self.bodies[seed].awake {
                self.build_island(seed, &mut in_island, &mut island);
                self.solve_island(&island);
                // A static body may belong to several islands.
                for &body in island.bodies.iter().filter(|&&body| !self.bodies[body].dynamic) {
                    in_island[body] = false;
                }
            }
        }
        self.island = island;
        for (body, _) in in_island.iter().enumerate().filter(|&(_, &in_island)| in_island) {
            self.synchronize_fixtures(body);
        }
        self.in_island = in_island;
    }

    /// Collects the island of a body by depth-first search over its touching contacts. Static bodies end a branch.
    fn build_island(&mut self, seed: usize, in_island: &mut [bool], island: &mut Island) {
        island.bodies.clear();
        island.contacts.clear();
        let mut stack = std::mem::take(&mut self.stack);
        stack.push(seed);
        in_island[seed] = true;
        while let Some(body) = stack.pop() {
            island.bodies.push(body);
            if !self.bodies[body].dynamic {
                continue;
            }
            self.bodies[body].wake();
            for (index, contact) in self.contacts.iter_mut().enumerate().rev() {
                let Some(other) = contact.other_body(body) else { continue };
                if contact.in_island || !contact.enabled || !contact.touching {
                    continue;
                }
                contact.in_island = true;
                island.contacts.push(index);
                if !in_island[other] {
                    in_island[other] = true;
                    stack.push(other);
                }
            }
        }
        self.stack = stack;
    }

    /// Integrates forces, solves velocities, integrates positions and corrects them: one step of an island.
    fn solve_island(&mut self, island: &Island) {
        for &body in &island.bodies {
            let (body, solver_body) = (&mut self.bodies[body], &mut self.solver_bodies[body]);
            if body.dynamic {
                body.sweep.position0 = body.sweep.position;
                solver_body.velocity.y += TIME_STEP * GRAVITY;
                solver_body.angular_velocity *= 1.0 / (1.0 + TIME_STEP * ANGULAR_DAMPING);
            }
        }
        self.solve_velocities(island, true);
        store_impulses(&self.constraints, &mut self.contacts);
        self.integrate_positions(island, TIME_STEP);
        let position_solved = self.solve_positions(island, BAUMGARTE, -3.0 * LINEAR_SLOP, |_| true);
        self.update_sleep(island, position_solved);
    }

    pub(super) fn solve_velocities(&mut self, island: &Island, warm_starting: bool) {
        self.constraints.clear();
        self.constraints.extend(island.contacts.iter().map(|&index| {
            let contact = &self.contacts[index];
            VelocityConstraint::new(index, contact, &self.bodies, &self.solver_bodies, warm_starting)
        }));
        solve_velocity_constraints(&mut self.constraints, &mut self.solver_bodies);
    }

    /// Iterates over the positions until no separation is below `tolerance`, m. Returns whether this was reached.
    pub(super) fn solve_positions(
        &mut self,
        island: &Island,
        baumgarte: f32,
        tolerance: f32,
        movable: impl Fn(usize) -> bool,
    ) -> bool {
        for _ in 0..POSITION_ITERATIONS {
            let mut min_separation = 0.0_f32;
            for &contact in &island.contacts {
                let contact = &self.contacts[contact];
                let (bodies, solver_bodies) = (&mut self.bodies, &self.solver_bodies);
                let separation = solve_position_constraint(contact, bodies, solver_bodies, baumgarte, &movable);
                min_separation = min(min_separation, separation);
            }
            if min_separation >= tolerance {
                return true;
            }
        }
        false
    }

    /// Moves the bodies of an island for a time, s, by their velocities, which it limits first.
    pub(super) fn integrate_positions(&mut self, island: &Island, time: f32) {
        for &body in &island.bodies {
            let (body, solver_body) = (&mut self.bodies[body], &mut self.solver_bodies[body]);
            if !body.dynamic {
                continue;
            }
            let translation = length(solver_body.velocity * time);
            if translation > MAX_TRANSLATION {
                solver_body.velocity *= MAX_TRANSLATION / translation;
            }
            let rotation = (solver_body.angular_velocity * time).abs();
            if rotation > MAX_ROTATION {
                solver_body.angular_velocity *= MAX_ROTATION / rotation;
            }
            let Position { centre, angle } = body.sweep.position;
            body.set_position(Position {
                centre: centre + solver_body.velocity * time,
                angle: angle + solver_body.angular_velocity * time,
            });
        }
    }

    /// Puts an island to sleep when all its bodies have been slow for long enough.
    fn update_sleep(&mut self, island: &Island, position_solved: bool) {
        let mut min_sleep_time = f32::MAX;
        for &body in &island.bodies {
            let (body, solver_body) = (&mut self.bodies[body], &self.solver_bodies[body]);
            if !body.dynamic {
                continue;
            }
            let moves = solver_body.angular_velocity.abs() > ANGULAR_SLEEP_TOLERANCE
                || solver_body.velocity.length_squared() > LINEAR_SLEEP_TOLERANCE * LINEAR_SLEEP_TOLERANCE;
            body.sleep_time = if moves { 0.0 } else { body.sleep_time + TIME_STEP };
            min_sleep_time = min_sleep_time.min(body.sleep_time);
        }
        if min_sleep_time >= TIME_TO_SLEEP && position_solved {
            for &body in &island.bodies {
                if self.bodies[body].dynamic {
                    self.bodies[body].sleep();
                    self.solver_bodies[body].stop();
                }
            }
        }
    }
}

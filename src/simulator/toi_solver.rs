//! Continuous collision: handles, one after the other, the times within a step at which a dynamic body meets a static
//! one (b2World::SolveTOI and b2Island::SolveTOI of Box2D 2.3).

use rapier2d::parry::bounding_volume::BoundingVolume;

use super::constants::{LINEAR_SLOP, MAX_TOI_SUBSTEPS, TIME_STEP, TOI_BAUMGARTE};
use super::island::Island;
use super::time_of_impact::time_of_impact;
use super::world::World;

impl World {
    pub(super) fn solve_toi(&mut self) {
        self.bodies.iter_mut().for_each(|body| body.sweep.alpha0 = 0.0);
        for contact in &mut self.contacts {
            (contact.toi, contact.toi_count, contact.in_island) = (None, 0, false);
        }
        while let Some((contact, alpha)) = self.min_toi_contact() {
            self.solve_toi_event(contact, alpha);
        }
    }

    /// Returns the contact with the earliest time of impact, and this time as a fraction of the step.
    fn min_toi_contact(&mut self) -> Option<(usize, f32)> {
        let mut min_contact = None;
        let mut min_alpha = 1.0;
        for index in (0..self.contacts.len()).rev() {
            let contact = &self.contacts[index];
            if !contact.enabled || contact.toi_count > MAX_TOI_SUBSTEPS {
                continue;
            }
            let alpha = match contact.toi {
                Some(alpha) => alpha,
                None => {
                    let [a, b] = contact.bodies.map(|body| &self.bodies[body]);
                    // Two dynamic bodies are left to the discrete solver.
                    if a.dynamic == b.dynamic || !(a.awake || b.awake) {
                        continue;
                    }
                    let alpha = self.contact_toi(index);
                    self.contacts[index].toi = Some(alpha);
                    alpha
                }
            };
            if alpha < min_alpha {
                min_contact = Some((index, alpha));
                min_alpha = alpha;
            }
        }
        min_contact.filter(|_| min_alpha <= 1.0 - 10.0 * f32::EPSILON)
    }

    /// Returns the time of impact of a contact as a fraction of the step; 1 if there is none.
    fn contact_toi(&mut self, index: usize) -> f32 {
        let [a, b] = self.contacts[index].bodies;
        let alpha0 = self.bodies[a].sweep.alpha0.max(self.bodies[b].sweep.alpha0);
        for body in [a, b] {
            if self.bodies[body].sweep.alpha0 < alpha0 {
                self.bodies[body].sweep.advance(alpha0);
            }
        }
        let fixtures = self.contacts[index].fixtures.map(|fixture| &self.fixtures[fixture]);
        // Apart during the whole step.
        if !fixtures[0].swept_aabb.intersects(&fixtures[1].swept_aabb) {
            return 1.0;
        }
        let normal = self.bodies[a].pose().rotation * self.contacts[index].local_normal;
        match time_of_impact(fixtures, [&self.bodies[a], &self.bodies[b]], normal) {
            Some(beta) => (alpha0 + (1.0 - alpha0) * beta).min(1.0),
            None => 1.0,
        }
    }

    /// Moves the two bodies of a contact back to their time of impact, solves them there, and completes their step.
    fn solve_toi_event(&mut self, index: usize, alpha: f32) {
        let bodies = self.contacts[index].bodies;
        let backups = bodies.map(|body| self.bodies[body].sweep);
        bodies.iter().for_each(|&body| self.bodies[body].advance(alpha));
        self.update_contact(index);
        let contact = &mut self.contacts[index];
        contact.toi = None;
        contact.toi_count += 1;
        if !contact.touching {
            contact.enabled = false;
            bodies.into_iter().zip(backups).for_each(|(body, sweep)| self.bodies[body].restore_sweep(sweep));
            return;
        }
        contact.in_island = true;
        self.wake(bodies);
        let island = self.build_toi_island(index);
        self.solve_positions(&island, TOI_BAUMGARTE, -1.5 * LINEAR_SLOP, |body| bodies.contains(&body));
        for body in bodies {
            self.bodies[body].sweep.position0 = self.bodies[body].sweep.position;
        }
        self.solve_velocities(&island, false);
        self.integrate_positions(&island, (1.0 - alpha) * TIME_STEP);
        for &body in &island.bodies {
            if !self.bodies[body].dynamic {
                continue;
            }
            self.synchronize_fixtures(body);
            for contact in &mut self.contacts {
                if contact.other_body(body).is_some() {
                    (contact.toi, contact.in_island) = (None, false);
                }
            }
        }
        self.find_new_contacts();
    }

    /// Returns the two bodies of a contact and the static bodies that they touch, with these contacts.
    fn build_toi_island(&mut self, index: usize) -> Island {
        let bodies = self.contacts[index].bodies;
        let mut island = Island { bodies: bodies.to_vec(), contacts: vec![index] };
        for body in bodies {
            if !self.bodies[body].dynamic {
                continue;
            }
            for index in (0..self.contacts.len()).rev() {
                let contact = &self.contacts[index];
                let Some(other) = contact.other_body(body) else { continue };
                if contact.in_island || self.bodies[other].dynamic {
                    continue;
                }
                self.update_contact(index);
                let contact = &mut self.contacts[index];
                if contact.touching {
                    contact.in_island = true;
                    island.contacts.push(index);
                    if !island.bodies.contains(&other) {
                        island.bodies.push(other);
                    }
                }
            }
        }
        island
    }
}

//! The world and its step, in Box2D's order: contacts, islands, sleep, then moments of impact.
//!
//! rapier's own pipeline solves softer contacts in another order, which no parameter undoes, so the step is
//! ours; shapes, mass properties, contact points and distances stay rapier's. Orders of bodies and contacts
//! follow Box2D's lists (newest first), because a solver that sweeps gives each order its own result.

use rapier2d::parry::bounding_volume::BoundingVolume;

use super::body::{Fixture, Motion, Rigid, Stance};
use super::constants::{
    ANGULAR_DAMPING, GRAVITY, IMPACT_PUSH, MAX_IMPACTS, MAX_ROTATION, MAX_TRANSLATION, POSITION_SWEEPS, PUSH, SLOP,
    STEP, STILL_SPEED, STILL_SPIN, STILL_TIME,
};
use super::contact::Contact;
use super::contact_solver::{Constraint, remember, solve_velocities, sweep_positions};
use super::time_of_impact;
use crate::puzzle::scene::Body;

#[derive(Default)]
pub struct World {
    pub bodies: Vec<Rigid>,
    /// One for each body.
    motions: Vec<Motion>,
    fixtures: Vec<Fixture>,
    /// Oldest first.
    contacts: Vec<Contact>,
    // Kept from step to step only to save allocations.
    constraints: Vec<Constraint>,
    island: Island,
}

/// Bodies that hang together by contacts, and the contacts, in the order in which they are solved.
#[derive(Default)]
struct Island {
    bodies: Vec<usize>,
    contacts: Vec<usize>,
}

impl World {
    /// Adds a body; returns its number.
    pub fn add(&mut self, body: &Body) -> usize {
        let number = self.bodies.len();
        let (rigid, motion, fixtures) = Rigid::new(body, number, self.fixtures.len());
        self.bodies.push(rigid);
        self.motions.push(motion);
        self.fixtures.extend(fixtures);
        number
    }

    /// Whether anything can still move.
    pub fn is_awake(&self) -> bool {
        self.bodies.iter().any(|body| body.awake)
    }

    /// Whether two bodies had a touching contact when it was last looked at.
    pub fn touch(&self, a: usize, b: usize) -> bool {
        self.contacts.iter().any(|contact| contact.touching && (contact.bodies == [a, b] || contact.bodies == [b, a]))
    }

    /// One 60th of a second.
    pub fn step(&mut self) {
        self.pair_up();
        self.update_contacts();
        self.solve_islands();
        self.pair_up();
        self.solve_impacts();
    }

    /// Adds a contact for every new pair of fixtures whose larger boxes overlap.
    fn pair_up(&mut self) {
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
                    && first.roomy.intersects(&second.roomy)
                    && !self.contacts.iter().any(|contact| contact.fixtures == [a, b] || contact.fixtures == [b, a])
                {
                    self.contacts.push(Contact::new([a, b], &self.fixtures));
                }
            }
        }
        self.fixtures.iter_mut().for_each(|fixture| fixture.moved = false);
    }

    /// Drops contacts whose fixtures are far apart, looks at all others of bodies that are awake.
    fn update_contacts(&mut self) {
        let mut index = self.contacts.len();
        while index > 0 {
            index -= 1;
            let contact = &self.contacts[index];
            if !contact.bodies.iter().any(|&body| self.bodies[body].awake) {
                continue;
            }
            let [a, b] = contact.fixtures.map(|fixture| &self.fixtures[fixture].roomy);
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

    fn update_contact(&mut self, index: usize) {
        let contact = &mut self.contacts[index];
        let before = contact.touching;
        contact.update(&self.fixtures, &self.bodies);
        let bodies = contact.bodies;
        if contact.touching != before {
            self.wake(bodies);
        }
    }

    fn wake(&mut self, bodies: [usize; 2]) {
        bodies.iter().for_each(|&body| self.bodies[body].wake());
    }

    fn solve_islands(&mut self) {
        self.contacts.iter_mut().for_each(|contact| contact.taken = false);
        let mut taken = vec![false; self.bodies.len()];
        let mut island = std::mem::take(&mut self.island);
        for seed in (0..self.bodies.len()).rev() {
            if !taken[seed] && self.bodies[seed].awake {
                self.gather(seed, &mut taken, &mut island);
                self.solve_island(&island);
                // A static body may belong to several islands.
                island.bodies.iter().filter(|&&body| !self.bodies[body].dynamic).for_each(|&body| taken[body] = false);
            }
        }
        self.island = island;
        for (body, taken) in taken.into_iter().enumerate() {
            if taken {
                self.follow(body);
            }
        }
    }

    /// Everything that hangs together with a body, depth first; static bodies end a branch.
    fn gather(&mut self, seed: usize, taken: &mut [bool], island: &mut Island) {
        island.bodies.clear();
        island.contacts.clear();
        let mut stack = vec![seed];
        taken[seed] = true;
        while let Some(body) = stack.pop() {
            island.bodies.push(body);
            if !self.bodies[body].dynamic {
                continue;
            }
            self.bodies[body].wake();
            for (index, contact) in self.contacts.iter_mut().enumerate().rev() {
                let Some(other) = other(contact, body) else { continue };
                if contact.taken || !contact.enabled || !contact.touching {
                    continue;
                }
                contact.taken = true;
                island.contacts.push(index);
                if !taken[other] {
                    taken[other] = true;
                    stack.push(other);
                }
            }
        }
    }

    fn solve_island(&mut self, island: &Island) {
        for &body in &island.bodies {
            let (body, motion) = (&mut self.bodies[body], &mut self.motions[body]);
            if body.dynamic {
                body.start = body.now;
                motion.velocity.y += STEP * GRAVITY;
                motion.spin *= 1.0 / (1.0 + STEP * ANGULAR_DAMPING);
            }
        }
        self.solve_contacts(island, true);
        remember(&self.constraints, &mut self.contacts);
        self.move_bodies(island, STEP);
        let mut settled = false;
        for _ in 0..POSITION_SWEEPS {
            let deepest = self.sweep_positions(island, PUSH, |_| true);
            settled = deepest >= -3.0 * SLOP;
            if settled {
                break;
            }
        }
        self.let_sleep(island, settled);
    }

    fn solve_contacts(&mut self, island: &Island, warm: bool) {
        self.constraints.clear();
        let constraint =
            |&index: &usize| Constraint::new(index, &self.contacts[index], &self.bodies, &self.motions, warm);
        self.constraints.extend(island.contacts.iter().map(constraint));
        solve_velocities(&mut self.constraints, &mut self.motions);
    }

    fn sweep_positions(&mut self, island: &Island, share: f32, movable: impl Fn(usize) -> bool) -> f32 {
        sweep_positions(&island.contacts, &self.contacts, &mut self.bodies, &self.motions, share, movable)
    }

    fn move_bodies(&mut self, island: &Island, time: f32) {
        for &body in &island.bodies {
            let (body, motion) = (&mut self.bodies[body], &mut self.motions[body]);
            if !body.dynamic {
                continue;
            }
            let way = (motion.velocity * time).length();
            if way > MAX_TRANSLATION {
                motion.velocity *= MAX_TRANSLATION / way;
            }
            let turn = (motion.spin * time).abs();
            if turn > MAX_ROTATION {
                motion.spin *= MAX_ROTATION / turn;
            }
            let com = body.now.com + motion.velocity * time;
            let angle = body.now.angle + motion.spin * time;
            body.stand(Stance { com, angle });
        }
    }

    /// An island sleeps once all of it has been still for long enough.
    fn let_sleep(&mut self, island: &Island, settled: bool) {
        let mut least = f32::MAX;
        for &body in &island.bodies {
            let (body, motion) = (&mut self.bodies[body], &self.motions[body]);
            if !body.dynamic {
                continue;
            }
            let moves = motion.spin.abs() > STILL_SPIN || motion.velocity.length_squared() > STILL_SPEED * STILL_SPEED;
            body.still = if moves { 0.0 } else { body.still + STEP };
            least = least.min(body.still);
        }
        if least >= STILL_TIME && settled {
            for &body in &island.bodies {
                if self.bodies[body].dynamic {
                    self.bodies[body].sleep();
                    self.motions[body].stop();
                }
            }
        }
    }

    /// Lets the fixtures follow their body.
    fn follow(&mut self, body: usize) {
        let body = &self.bodies[body];
        if !body.dynamic {
            return;
        }
        let start = rapier2d::math::Pose::from_parts(body.start.com, body.start.rotation());
        let origin = start.translation - start.rotation * body.local_com;
        let way = body.origin() - origin;
        for fixture in &mut self.fixtures[body.fixtures.clone()] {
            fixture.follow(&start, &body.pose(), way);
        }
    }

    /// Handles, one after the other, the moments at which a dynamic body meets a static one on its way.
    fn solve_impacts(&mut self) {
        self.bodies.iter_mut().for_each(|body| body.start_time = 0.0);
        for contact in &mut self.contacts {
            (contact.impact, contact.impacts, contact.taken) = (None, 0, false);
        }
        while let Some((index, time)) = self.first_impact() {
            self.solve_impact(index, time);
        }
    }

    /// The contact that meets first, and when, as a share of the step.
    fn first_impact(&mut self) -> Option<(usize, f32)> {
        let mut first = None;
        let mut least = 1.0;
        for index in (0..self.contacts.len()).rev() {
            let contact = &self.contacts[index];
            if !contact.enabled || contact.impacts > MAX_IMPACTS {
                continue;
            }
            let time = match contact.impact {
                Some(time) => time,
                None => {
                    let [a, b] = contact.bodies.map(|body| &self.bodies[body]);
                    // Two dynamic bodies are left to the solver.
                    if a.dynamic == b.dynamic || !(a.awake || b.awake) {
                        continue;
                    }
                    let time = self.impact_of(index);
                    self.contacts[index].impact = Some(time);
                    time
                }
            };
            if time < least {
                first = Some((index, time));
                least = time;
            }
        }
        first.filter(|_| least <= 1.0 - 10.0 * f32::EPSILON)
    }

    fn impact_of(&mut self, index: usize) -> f32 {
        let [a, b] = self.contacts[index].bodies;
        let since = self.bodies[a].start_time.max(self.bodies[b].start_time);
        for body in [a, b] {
            if self.bodies[body].start_time < since {
                self.bodies[body].advance_start(since);
            }
        }
        let fixtures = self.contacts[index].fixtures.map(|fixture| &self.fixtures[fixture]);
        // Apart on the whole way?
        if !fixtures[0].swept.intersects(&fixtures[1].swept) {
            return 1.0;
        }
        match time_of_impact::moment(fixtures, [&self.bodies[a], &self.bodies[b]]) {
            Some(share) => (since + (1.0 - since) * share).min(1.0),
            None => 1.0,
        }
    }

    /// Takes the two bodies back to the moment, solves their contacts there, and lets them go on from it.
    fn solve_impact(&mut self, index: usize, time: f32) {
        let bodies = self.contacts[index].bodies;
        let before = bodies.map(|body| self.bodies[body].sweep());
        bodies.iter().for_each(|&body| self.bodies[body].rewind(time));
        self.update_contact(index);
        let contact = &mut self.contacts[index];
        contact.impact = None;
        contact.impacts += 1;
        if !contact.touching {
            contact.enabled = false;
            bodies.into_iter().zip(before).for_each(|(body, sweep)| self.bodies[body].restore(sweep));
            return;
        }
        contact.taken = true;
        self.wake(bodies);

        let mut island = Island { bodies: bodies.to_vec(), contacts: vec![index] };
        for body in bodies {
            if !self.bodies[body].dynamic {
                continue;
            }
            for index in (0..self.contacts.len()).rev() {
                let contact = &self.contacts[index];
                let Some(other) = other(contact, body) else { continue };
                if contact.taken || self.bodies[other].dynamic {
                    continue;
                }
                self.update_contact(index);
                let contact = &mut self.contacts[index];
                if contact.touching {
                    contact.taken = true;
                    island.contacts.push(index);
                    if !island.bodies.contains(&other) {
                        island.bodies.push(other);
                    }
                }
            }
        }
        for _ in 0..POSITION_SWEEPS {
            let movable = |body: usize| bodies.contains(&body);
            let deepest = self.sweep_positions(&island, IMPACT_PUSH, movable);
            if deepest >= -1.5 * SLOP {
                break;
            }
        }
        for body in bodies {
            self.bodies[body].start = self.bodies[body].now;
        }
        self.solve_contacts(&island, false);
        self.move_bodies(&island, (1.0 - time) * STEP);
        for &body in &island.bodies {
            if !self.bodies[body].dynamic {
                continue;
            }
            self.follow(body);
            for contact in &mut self.contacts {
                if other(contact, body).is_some() {
                    (contact.impact, contact.taken) = (None, false);
                }
            }
        }
        self.pair_up();
    }
}

/// The other body of a contact, if it is one of this body's.
fn other(contact: &Contact, body: usize) -> Option<usize> {
    match contact.bodies {
        [a, b] if a == body => Some(b),
        [a, b] if b == body => Some(a),
        _ => None,
    }
}

//! The contact solver: impulses first, then positions, in Box2D's order.
//!
//! Velocities: friction, then non-penetration, sweep by sweep; two points of a contact together. Positions:
//! overlap beyond the slop is pushed out without adding speed. It sees bodies and contacts, nothing of shapes.

use rapier2d::math::Vector;

use super::body::{Motion, Rigid, Stance};
use super::constants::{BOUNCE_SPEED, FRICTION, MAX_CONDITION, MAX_PUSH, RESTITUTION, SLOP, VELOCITY_SWEEPS};
use super::contact::{Contact, Impulse};

/// A contact as the velocity solver sees it.
pub struct Constraint {
    contact: usize,
    bodies: [usize; 2],
    normal: Vector,
    rows: [Row; 2],
    count: usize,
    /// Solved jointly: how each normal impulse changes both normal velocities (k11, k12, k22), and the inverse.
    pair: Option<[[f32; 3]; 2]>,
}

#[derive(Clone, Copy, Default)]
struct Row {
    /// From the centres of mass to the point, m.
    arms: [Vector; 2],
    impulse: Impulse,
    /// Impulse per velocity.
    normal_mass: f32,
    tangent_mass: f32,
    /// Normal velocity to leave with, m/s.
    bounce: f32,
}

impl Constraint {
    /// Looks at the bodies as they are now. `warm`: start from the impulses of the last step.
    pub fn new(index: usize, contact: &Contact, bodies: &[Rigid], motions: &[Motion], warm: bool) -> Constraint {
        let [pose_a, pose_b] = contact.bodies.map(|body| bodies[body].pose());
        let [a, b] = contact.bodies.map(|body| &motions[body]);
        let normal = contact.normal(&pose_a, &pose_b);
        let tangent = -normal.perp();
        let mut rows = [Row::default(); 2];
        for (i, point) in contact.points().iter().enumerate() {
            let gap = contact.gap(point, normal, &pose_a, &pose_b);
            // Halfway between the two surfaces.
            let at = pose_b * point.on_b - normal * (contact.margins[1] + gap / 2.0);
            let arms = [at - pose_a.translation, at - pose_b.translation];
            let mass = |along| {
                let response = a.response(arms[0], along) + b.response(arms[1], along);
                if response > 0.0 { 1.0 / response } else { 0.0 }
            };
            let approach = (b.at(arms[1]) - a.at(arms[0])).dot(normal);
            rows[i] = Row {
                arms,
                impulse: if warm { contact.impulse(i) } else { Impulse::default() },
                normal_mass: mass(normal),
                tangent_mass: mass(tangent),
                bounce: if approach < -BOUNCE_SPEED { -RESTITUTION * approach } else { 0.0 },
            };
        }
        let mut count = contact.points().len();
        let mut pair = None;
        if count == 2 {
            let arm = |row: usize, side: usize| rows[row].arms[side].perp_dot(normal);
            let mass = a.inv_mass + b.inv_mass;
            let k = |i, j| mass + a.inv_inertia * arm(i, 0) * arm(j, 0) + b.inv_inertia * arm(i, 1) * arm(j, 1);
            let (k11, k12, k22) = (k(0, 0), k(0, 1), k(1, 1));
            let determinant = k11 * k22 - k12 * k12;
            if k11 * k11 < MAX_CONDITION * determinant {
                pair = Some([[k11, k12, k22], [k22, -k12, k11].map(|entry| entry / determinant)]);
            } else {
                // The second point says nothing new.
                count = 1;
            }
        }
        Constraint { contact: index, bodies: contact.bodies, normal, rows, count, pair }
    }

    fn tangent(&self) -> Vector {
        -self.normal.perp()
    }

    /// Applies the impulses that it starts from.
    fn warm_start(&self, motions: &mut [Motion]) {
        let [mut a, mut b] = self.bodies.map(|body| motions[body]);
        for row in &self.rows[..self.count] {
            row.push(&mut a, &mut b, self.normal * row.impulse.normal + self.tangent() * row.impulse.tangent);
        }
        self.put_back(motions, a, b);
    }

    /// Solves the contact by itself. Returns whether any impulse changed.
    fn sweep(&mut self, motions: &mut [Motion]) -> bool {
        let [mut a, mut b] = self.bodies.map(|body| motions[body]);
        let tangent = self.tangent();
        let mut changed = false;
        for row in &mut self.rows[..self.count] {
            let slip = row.approach(&a, &b).dot(tangent);
            let limit = FRICTION * row.impulse.normal;
            let wanted = (row.impulse.tangent - row.tangent_mass * slip).max(-limit).min(limit);
            let change = wanted - row.impulse.tangent;
            row.impulse.tangent = wanted;
            row.push(&mut a, &mut b, tangent * change);
            changed |= change != 0.0;
        }
        match self.pair {
            Some(pair) => changed |= self.sweep_pair(pair, &mut a, &mut b),
            None => {
                for row in &mut self.rows[..self.count] {
                    let speed = row.approach(&a, &b).dot(self.normal);
                    let wanted = (row.impulse.normal - row.normal_mass * (speed - row.bounce)).max(0.0);
                    let change = wanted - row.impulse.normal;
                    row.impulse.normal = wanted;
                    row.push(&mut a, &mut b, self.normal * change);
                    changed |= change != 0.0;
                }
            }
        }
        self.put_back(motions, a, b);
        changed
    }

    /// Two impulses, none pulling, each zero unless its point would otherwise sink in: tries which of the two act.
    fn sweep_pair(&mut self, [[k11, k12, k22], inverse]: [[f32; 3]; 2], a: &mut Motion, b: &mut Motion) -> bool {
        let [first, second] = &mut self.rows;
        let (old1, old2) = (first.impulse.normal, second.impulse.normal);
        let rest = |row: &Row| row.approach(a, b).dot(self.normal) - row.bounce;
        let b1 = rest(first) - (k11 * old1 + k12 * old2);
        let b2 = rest(second) - (k12 * old1 + k22 * old2);
        let both = [-(inverse[0] * b1 + inverse[1] * b2), -(inverse[1] * b1 + inverse[2] * b2)];
        let (only1, only2) = (-first.normal_mass * b1, -second.normal_mass * b2);
        let [new1, new2] = if both[0] >= 0.0 && both[1] >= 0.0 {
            both
        } else if only1 >= 0.0 && k12 * only1 + b2 >= 0.0 {
            [only1, 0.0]
        } else if only2 >= 0.0 && k12 * only2 + b1 >= 0.0 {
            [0.0, only2]
        } else if b1 >= 0.0 && b2 >= 0.0 {
            [0.0, 0.0]
        } else {
            return false;
        };
        first.push(a, b, self.normal * (new1 - old1));
        second.push(a, b, self.normal * (new2 - old2));
        first.impulse.normal = new1;
        second.impulse.normal = new2;
        new1 != old1 || new2 != old2
    }

    fn put_back(&self, motions: &mut [Motion], a: Motion, b: Motion) {
        motions[self.bodies[0]] = a;
        motions[self.bodies[1]] = b;
    }
}

impl Row {
    /// How fast b moves away from a at the point.
    fn approach(&self, a: &Motion, b: &Motion) -> Vector {
        b.at(self.arms[1]) - a.at(self.arms[0])
    }

    fn push(&self, a: &mut Motion, b: &mut Motion, impulse: Vector) {
        a.push(-impulse, self.arms[0]);
        b.push(impulse, self.arms[1]);
    }
}

/// Changes the velocities so that no point sinks in further.
pub fn solve_velocities(constraints: &mut [Constraint], motions: &mut [Motion]) {
    for constraint in &*constraints {
        constraint.warm_start(motions);
    }
    for _ in 0..VELOCITY_SWEEPS {
        let mut changed = false;
        for constraint in &mut *constraints {
            changed |= constraint.sweep(motions);
        }
        // The next sweep would find what this one found: stopping here changes no bit.
        if !changed {
            break;
        }
    }
}

/// Keeps the impulses for the next step.
pub fn remember(constraints: &[Constraint], contacts: &mut [Contact]) {
    for constraint in constraints {
        for (i, row) in constraint.rows[..constraint.count].iter().enumerate() {
            contacts[constraint.contact].remember(i, row.impulse);
        }
    }
}

/// One sweep over the positions: pushes each point out by `share` of its overlap. Only bodies that `movable` allows
/// give way. Returns the deepest overlap met, m (negative, or 0).
pub fn sweep_positions(
    chosen: &[usize],
    contacts: &[Contact],
    bodies: &mut [Rigid],
    motions: &[Motion],
    share: f32,
    movable: impl Fn(usize) -> bool,
) -> f32 {
    let mut deepest = 0.0_f32;
    for &index in chosen {
        let contact = &contacts[index];
        let [ia, ib] = contact.bodies;
        let give = |body: usize| if movable(body) { 1.0 } else { 0.0 };
        let (give_a, give_b) = (give(ia), give(ib));
        for point in contact.points() {
            let (pose_a, pose_b) = (bodies[ia].pose(), bodies[ib].pose());
            let normal = contact.normal(&pose_a, &pose_b);
            let gap = contact.gap(point, normal, &pose_a, &pose_b);
            deepest = deepest.min(gap);
            let at = if contact.round { (pose_a.translation + pose_b.translation) / 2.0 } else { pose_b * point.on_b };
            let (arm_a, arm_b) = (at - pose_a.translation, at - pose_b.translation);
            let wanted = (share * (gap + SLOP)).clamp(-MAX_PUSH, 0.0);
            let (a, b) = (&motions[ia], &motions[ib]);
            let response = give_a * a.response(arm_a, normal) + give_b * b.response(arm_b, normal);
            if wanted == 0.0 || response <= 0.0 {
                continue;
            }
            let push = normal * (-wanted / response);
            let mut shift = |body: usize, arm: Vector, push: Vector| {
                let (motion, body) = (&motions[body], &mut bodies[body]);
                let com = body.now.com + motion.inv_mass * push;
                let angle = body.now.angle + motion.inv_inertia * arm.perp_dot(push);
                body.stand(Stance { com, angle });
            };
            if give_a > 0.0 {
                shift(ia, arm_a, -push);
            }
            if give_b > 0.0 {
                shift(ib, arm_b, push);
            }
        }
    }
    deepest
}

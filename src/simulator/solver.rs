//! The contact solver: impulses first, then positions, in Box2D's order.
//!
//! Velocities: friction, then non-penetration, sweep by sweep; two points of a contact together. Positions:
//! overlap beyond the slop is pushed out without adding speed. It sees bodies and contacts, nothing of shapes.

use rapier2d::math::Vector;

use super::body::{Rigid, Stance};
use super::contact::{Contact, Impulse};
use super::settings::{BOUNCE_SPEED, FRICTION, MAX_CONDITION, MAX_PUSH, RESTITUTION, SLOP, VELOCITY_SWEEPS};

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
    pub fn new(index: usize, contact: &Contact, bodies: &[Rigid], warm: bool) -> Constraint {
        let [a, b] = contact.bodies.map(|body| &bodies[body]);
        let (pose_a, pose_b) = (a.pose(), b.pose());
        let normal = contact.normal(&pose_a, &pose_b);
        let tangent = -normal.perp();
        let mut rows = [Row::default(); 2];
        for (i, point) in contact.points().iter().enumerate() {
            let gap = contact.gap(point, normal, &pose_a, &pose_b);
            // Halfway between the two surfaces.
            let at = pose_b * point.on_b - normal * (contact.margins[1] + gap / 2.0);
            let arms = [at - a.now.com, at - b.now.com];
            let mass = |along| {
                let response = a.response(arms[0], along) + b.response(arms[1], along);
                if response > 0.0 { 1.0 / response } else { 0.0 }
            };
            let approach = (b.velocity_at(arms[1]) - a.velocity_at(arms[0])).dot(normal);
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
    fn warm_start(&self, bodies: &mut [Rigid]) {
        for row in &self.rows[..self.count] {
            let impulse = self.normal * row.impulse.normal + self.tangent() * row.impulse.tangent;
            push(bodies, self.bodies, row, impulse);
        }
    }

    fn sweep(&mut self, bodies: &mut [Rigid]) {
        let tangent = self.tangent();
        for i in 0..self.count {
            let row = &mut self.rows[i];
            let slip = approach(bodies, self.bodies, row).dot(tangent);
            let limit = FRICTION * row.impulse.normal;
            let wanted = (row.impulse.tangent - row.tangent_mass * slip).max(-limit).min(limit);
            let change = wanted - row.impulse.tangent;
            row.impulse.tangent = wanted;
            push(bodies, self.bodies, row, tangent * change);
        }
        let Some([[k11, k12, k22], inverse]) = self.pair else {
            for i in 0..self.count {
                let row = &mut self.rows[i];
                let speed = approach(bodies, self.bodies, row).dot(self.normal);
                let wanted = (row.impulse.normal - row.normal_mass * (speed - row.bounce)).max(0.0);
                let change = wanted - row.impulse.normal;
                row.impulse.normal = wanted;
                push(bodies, self.bodies, row, self.normal * change);
            }
            return;
        };
        // Two impulses, none pulling, each zero unless its point would otherwise sink in: try which of the two act.
        let [first, second] = self.rows;
        let (old1, old2) = (first.impulse.normal, second.impulse.normal);
        let rest = |row: &Row| approach(bodies, self.bodies, row).dot(self.normal) - row.bounce;
        let b1 = rest(&first) - (k11 * old1 + k12 * old2);
        let b2 = rest(&second) - (k12 * old1 + k22 * old2);
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
            return;
        };
        push(bodies, self.bodies, &first, self.normal * (new1 - old1));
        push(bodies, self.bodies, &second, self.normal * (new2 - old2));
        self.rows[0].impulse.normal = new1;
        self.rows[1].impulse.normal = new2;
    }
}

fn approach(bodies: &[Rigid], [a, b]: [usize; 2], row: &Row) -> Vector {
    bodies[b].velocity_at(row.arms[1]) - bodies[a].velocity_at(row.arms[0])
}

fn push(bodies: &mut [Rigid], [a, b]: [usize; 2], row: &Row, impulse: Vector) {
    bodies[a].push(-impulse, row.arms[0]);
    bodies[b].push(impulse, row.arms[1]);
}

/// Changes the velocities so that no point sinks in further.
pub fn solve_velocities(constraints: &mut [Constraint], bodies: &mut [Rigid]) {
    for constraint in &*constraints {
        constraint.warm_start(bodies);
    }
    for _ in 0..VELOCITY_SWEEPS {
        for constraint in &mut *constraints {
            constraint.sweep(bodies);
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
            let (a, b) = (&bodies[ia], &bodies[ib]);
            let (pose_a, pose_b) = (a.pose(), b.pose());
            let normal = contact.normal(&pose_a, &pose_b);
            let gap = contact.gap(point, normal, &pose_a, &pose_b);
            deepest = deepest.min(gap);
            let at = if contact.round { (pose_a.translation + pose_b.translation) / 2.0 } else { pose_b * point.on_b };
            let (arm_a, arm_b) = (at - a.now.com, at - b.now.com);
            let wanted = (share * (gap + SLOP)).clamp(-MAX_PUSH, 0.0);
            let response = give_a * a.response(arm_a, normal) + give_b * b.response(arm_b, normal);
            if wanted == 0.0 || response <= 0.0 {
                continue;
            }
            let push = normal * (-wanted / response);
            let mut shift = |body: usize, arm: Vector, push: Vector| {
                let body = &mut bodies[body];
                let com = body.now.com + body.inv_mass * push;
                let angle = body.now.angle + body.inv_inertia * arm.perp_dot(push);
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

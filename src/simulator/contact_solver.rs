//! The contact solver for the velocities: sequential impulses (b2ContactSolver of Box2D 2.3).
//!
//! Friction first, then the normal impulses; the two points of a contact are solved together as a block. Depends on
//! bodies and contacts, not on shapes.

use rapier2d::math::Vector;

use super::body::{RigidBody, SolverBody};
use super::constants::{
    FRICTION, MAX_CONDITION_NUMBER, MAX_WARM_STARTING_IMPULSE, RESTITUTION, RESTITUTION_THRESHOLD, VELOCITY_ITERATIONS,
};
use super::contact::{Contact, Impulse};
use super::scalar::{max, min};

/// A contact as the velocity solver sees it (b2ContactVelocityConstraint).
pub(crate) struct VelocityConstraint {
    contact: usize,
    bodies: [usize; 2],
    normal: Vector,
    points: [VelocityConstraintPoint; 2],
    point_count: usize,
    /// Set if the two points are solved together.
    block: Option<Block>,
}

/// A contact point as the velocity solver sees it (b2VelocityConstraintPoint).
#[derive(Clone, Copy, Default)]
struct VelocityConstraintPoint {
    /// From the centres of mass of a and b to the point, m (rA and rB).
    arms: [Vector; 2],
    /// Accumulated so far.
    impulse: Impulse,
    /// Effective masses, kg.
    normal_mass: f32,
    tangent_mass: f32,
    /// Normal velocity after the contact, by restitution, m/s.
    velocity_bias: f32,
}

/// The symmetric 2 x 2 matrix K of the block solver: the change of both normal velocities per normal impulse.
#[derive(Clone, Copy)]
struct Block {
    /// k11, k12 and k22, 1/kg.
    k: [f32; 3],
    /// The inverse of K, in the same order, kg.
    inverse: [f32; 3],
}

impl VelocityConstraint {
    /// Prepares a contact for the present positions and velocities. With `warm_starting`, it starts from the impulses
    /// of the last step.
    pub(crate) fn new(
        index: usize,
        contact: &Contact,
        bodies: &[RigidBody],
        solver_bodies: &[SolverBody],
        warm_starting: bool,
    ) -> VelocityConstraint {
        let [pose_a, pose_b] = contact.bodies.map(|body| bodies[body].pose());
        let [a, b] = contact.bodies.map(|body| &solver_bodies[body]);
        let normal = contact.normal(&pose_a, &pose_b);
        let tangent = -normal.perp();
        let mut points = [VelocityConstraintPoint::default(); 2];
        for (i, point) in contact.points().iter().enumerate() {
            let separation = contact.separation(point, normal, &pose_a, &pose_b);
            // Halfway between the two surfaces.
            let world_point = pose_b * point.local_point_b - normal * (contact.radii[1] + separation / 2.0);
            let arms = [world_point - pose_a.translation, world_point - pose_b.translation];
            let effective_mass = |direction| {
                let k = a.inv_effective_mass(arms[0], direction) + b.inv_effective_mass(arms[1], direction);
                if k > 0.0 { 1.0 / k } else { 0.0 }
            };
            points[i] = VelocityConstraintPoint {
                arms,
                impulse: if warm_starting { contact.impulse(i) } else { Impulse::default() },
                normal_mass: effective_mass(normal),
                tangent_mass: effective_mass(tangent),
                velocity_bias: 0.0,
            };
            let normal_velocity = points[i].relative_velocity(a, b).dot(normal);
            if normal_velocity < -RESTITUTION_THRESHOLD {
                points[i].velocity_bias = -RESTITUTION * normal_velocity;
            }
        }
        let mut point_count = contact.points().len();
        let mut block = None;
        if point_count == 2 {
            let lever = |point: usize, side: usize| points[point].arms[side].perp_dot(normal);
            let inv_mass = a.inv_mass + b.inv_mass;
            let k =
                |i, j| inv_mass + a.inv_inertia * lever(i, 0) * lever(j, 0) + b.inv_inertia * lever(i, 1) * lever(j, 1);
            let (k11, k12, k22) = (k(0, 0), k(0, 1), k(1, 1));
            let determinant = k11 * k22 - k12 * k12;
            if k11 * k11 < MAX_CONDITION_NUMBER * determinant {
                let inverse = [k22, -k12, k11].map(|entry| entry / determinant);
                block = Some(Block { k: [k11, k12, k22], inverse });
            } else {
                // The constraints are redundant: one point is enough.
                point_count = 1;
            }
        }
        VelocityConstraint { contact: index, bodies: contact.bodies, normal, points, point_count, block }
    }

    fn tangent(&self) -> Vector {
        -self.normal.perp()
    }

    /// Applies the impulses from which the solver starts.
    fn warm_start(&self, solver_bodies: &mut [SolverBody]) {
        let [mut a, mut b] = self.bodies.map(|body| solver_bodies[body]);
        for point in &self.points[..self.point_count] {
            let impulse = self.normal * point.impulse.normal + self.tangent() * point.impulse.tangent;
            point.apply_impulse(&mut a, &mut b, impulse);
        }
        self.store_velocities(solver_bodies, a, b);
    }

    /// Solves the constraint by itself. Returns whether any impulse has changed.
    fn solve(&mut self, solver_bodies: &mut [SolverBody]) -> bool {
        let [a, b] = self.bodies.map(|body| solver_bodies[body].inv_mass > 0.0);
        match (a, b) {
            (false, true) => self.solve_moving::<false, true>(solver_bodies),
            (true, false) => self.solve_moving::<true, false>(solver_bodies),
            _ => self.solve_moving::<true, true>(solver_bodies),
        }
    }

    /// Solves the constraint for bodies of which at least one moves: `A` and `B` tell which. A static body takes up no
    /// impulse, and what is not computed for it would be exactly zero.
    fn solve_moving<const A: bool, const B: bool>(&mut self, solver_bodies: &mut [SolverBody]) -> bool {
        let [mut a, mut b] = self.bodies.map(|body| solver_bodies[body]);
        let tangent = self.tangent();
        let mut changed = false;
        for point in &mut self.points[..self.point_count] {
            let tangent_velocity = point.relative_velocity_of::<A, B>(&a, &b).dot(tangent);
            let max_friction = FRICTION * point.impulse.normal;
            let unlimited = point.impulse.tangent - point.tangent_mass * tangent_velocity;
            let impulse = min(max(unlimited, -max_friction), max_friction);
            let change = impulse - point.impulse.tangent;
            point.impulse.tangent = impulse;
            point.apply_impulse_to::<A, B>(&mut a, &mut b, tangent * change);
            changed |= change != 0.0;
        }
        match self.block {
            Some(block) => changed |= self.solve_block::<A, B>(block, &mut a, &mut b),
            None => {
                for point in &mut self.points[..self.point_count] {
                    let normal_velocity = point.relative_velocity_of::<A, B>(&a, &b).dot(self.normal);
                    let error = normal_velocity - point.velocity_bias;
                    let impulse = max(point.impulse.normal - point.normal_mass * error, 0.0);
                    let change = impulse - point.impulse.normal;
                    point.impulse.normal = impulse;
                    point.apply_impulse_to::<A, B>(&mut a, &mut b, self.normal * change);
                    changed |= change != 0.0;
                }
            }
        }
        if A {
            solver_bodies[self.bodies[0]] = a;
        }
        if B {
            solver_bodies[self.bodies[1]] = b;
        }
        changed
    }

    /// The block solver: solves the linear complementarity problem of two normal impulses by total enumeration of its
    /// four cases. Both impulses are at least zero, and an impulse is zero unless its point would otherwise approach.
    fn solve_block<const A: bool, const B: bool>(
        &mut self,
        block: Block,
        a: &mut SolverBody,
        b: &mut SolverBody,
    ) -> bool {
        let Block { k: [k11, k12, k22], inverse } = block;
        let [first, second] = &mut self.points;
        let (old1, old2) = (first.impulse.normal, second.impulse.normal);
        let error = |point: &VelocityConstraintPoint| {
            point.relative_velocity_of::<A, B>(a, b).dot(self.normal) - point.velocity_bias
        };
        let b1 = error(first) - (k11 * old1 + k12 * old2);
        let b2 = error(second) - (k12 * old1 + k22 * old2);
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
        first.apply_impulse_to::<A, B>(a, b, self.normal * (new1 - old1));
        second.apply_impulse_to::<A, B>(a, b, self.normal * (new2 - old2));
        first.impulse.normal = new1;
        second.impulse.normal = new2;
        new1 != old1 || new2 != old2
    }

    fn store_velocities(&self, solver_bodies: &mut [SolverBody], a: SolverBody, b: SolverBody) {
        solver_bodies[self.bodies[0]] = a;
        solver_bodies[self.bodies[1]] = b;
    }
}

impl VelocityConstraintPoint {
    /// Returns the velocity of b relative to a at the point, m/s: positive along the normal if they separate.
    fn relative_velocity(&self, a: &SolverBody, b: &SolverBody) -> Vector {
        self.relative_velocity_of::<true, true>(a, b)
    }

    fn apply_impulse(&self, a: &mut SolverBody, b: &mut SolverBody, impulse: Vector) {
        self.apply_impulse_to::<true, true>(a, b, impulse);
    }

    fn relative_velocity_of<const A: bool, const B: bool>(&self, a: &SolverBody, b: &SolverBody) -> Vector {
        match (A, B) {
            (false, _) => b.velocity_at(self.arms[1]),
            (_, false) => -a.velocity_at(self.arms[0]),
            _ => b.velocity_at(self.arms[1]) - a.velocity_at(self.arms[0]),
        }
    }

    fn apply_impulse_to<const A: bool, const B: bool>(&self, a: &mut SolverBody, b: &mut SolverBody, impulse: Vector) {
        if A {
            a.apply_impulse(-impulse, self.arms[0]);
        }
        if B {
            b.apply_impulse(impulse, self.arms[1]);
        }
    }
}

/// Changes the velocities so that no contact point approaches (WarmStart and SolveVelocityConstraints).
pub(crate) fn solve_velocity_constraints(constraints: &mut [VelocityConstraint], solver_bodies: &mut [SolverBody]) {
    for constraint in &*constraints {
        constraint.warm_start(solver_bodies);
    }
    for _ in 0..VELOCITY_ITERATIONS {
        let mut changed = false;
        for constraint in &mut *constraints {
            changed |= constraint.solve(solver_bodies);
        }
        // A further iteration would change nothing either: to stop here changes no bit of the result.
        if !changed {
            break;
        }
    }
}

/// Stores the impulses for the warm starting of the next step, which starts from none where they grow without limit.
pub(crate) fn store_impulses(constraints: &[VelocityConstraint], contacts: &mut [Contact]) {
    for constraint in constraints {
        for (i, point) in constraint.points[..constraint.point_count].iter().enumerate() {
            // The tangent impulse is at most the normal one times the friction coefficient.
            let limited = point.impulse.normal <= MAX_WARM_STARTING_IMPULSE;
            contacts[constraint.contact].store_impulse(i, if limited { point.impulse } else { Impulse::default() });
        }
    }
}

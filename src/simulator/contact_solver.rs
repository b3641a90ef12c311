//! The contact solver: sequential impulses for the velocities, then nonlinear Gauss-Seidel for the positions
//! (b2ContactSolver of Box2D 2.3).
//!
//! Velocities: friction first, then the normal impulses; the two points of a contact are solved together as a block.
//! Positions: overlap beyond the slop is resolved without adding velocity. Depends on bodies and contacts, not on shapes.

use rapier2d::math::Vector;

use super::body::{Position, RigidBody, SolverBody};
use super::constants::{
    FRICTION, LINEAR_SLOP, MAX_CONDITION_NUMBER, MAX_LINEAR_CORRECTION, RESTITUTION, RESTITUTION_THRESHOLD,
    VELOCITY_ITERATIONS,
};
use super::contact::{Contact, Impulse};

/// A contact as the velocity solver sees it (b2ContactVelocityConstraint).
pub struct VelocityConstraint {
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
    /// Prepares a contact for the present positions and velocities. With `warm_starting`, it starts from the impulses of
    /// the last step.
    pub fn new(
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
        let [mut a, mut b] = self.bodies.map(|body| solver_bodies[body]);
        let tangent = self.tangent();
        let mut changed = false;
        for point in &mut self.points[..self.point_count] {
            let tangent_velocity = point.relative_velocity(&a, &b).dot(tangent);
            let max_friction = FRICTION * point.impulse.normal;
            let impulse =
                (point.impulse.tangent - point.tangent_mass * tangent_velocity).max(-max_friction).min(max_friction);
            let change = impulse - point.impulse.tangent;
            point.impulse.tangent = impulse;
            point.apply_impulse(&mut a, &mut b, tangent * change);
            changed |= change != 0.0;
        }
        match self.block {
            Some(block) => changed |= self.solve_block(block, &mut a, &mut b),
            None => {
                for point in &mut self.points[..self.point_count] {
                    let normal_velocity = point.relative_velocity(&a, &b).dot(self.normal);
                    let impulse =
                        (point.impulse.normal - point.normal_mass * (normal_velocity - point.velocity_bias)).max(0.0);
                    let change = impulse - point.impulse.normal;
                    point.impulse.normal = impulse;
                    point.apply_impulse(&mut a, &mut b, self.normal * change);
                    changed |= change != 0.0;
                }
            }
        }
        self.store_velocities(solver_bodies, a, b);
        changed
    }

    /// The block solver: solves the linear complementarity problem of two normal impulses by total enumeration of its four
    /// cases. Both impulses are at least zero, and an impulse is zero unless its point would otherwise approach.
    fn solve_block(&mut self, block: Block, a: &mut SolverBody, b: &mut SolverBody) -> bool {
        let Block { k: [k11, k12, k22], inverse } = block;
        let [first, second] = &mut self.points;
        let (old1, old2) = (first.impulse.normal, second.impulse.normal);
        let error =
            |point: &VelocityConstraintPoint| point.relative_velocity(a, b).dot(self.normal) - point.velocity_bias;
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
        first.apply_impulse(a, b, self.normal * (new1 - old1));
        second.apply_impulse(a, b, self.normal * (new2 - old2));
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
        b.velocity_at(self.arms[1]) - a.velocity_at(self.arms[0])
    }

    fn apply_impulse(&self, a: &mut SolverBody, b: &mut SolverBody, impulse: Vector) {
        a.apply_impulse(-impulse, self.arms[0]);
        b.apply_impulse(impulse, self.arms[1]);
    }
}

/// Changes the velocities so that no contact point approaches (WarmStart and SolveVelocityConstraints).
pub fn solve_velocity_constraints(constraints: &mut [VelocityConstraint], solver_bodies: &mut [SolverBody]) {
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

/// Stores the impulses for the warm starting of the next step.
pub fn store_impulses(constraints: &[VelocityConstraint], contacts: &mut [Contact]) {
    for constraint in constraints {
        for (i, point) in constraint.points[..constraint.point_count].iter().enumerate() {
            contacts[constraint.contact].store_impulse(i, point.impulse);
        }
    }
}

/// One position iteration for a contact (SolvePositionConstraints): resolves the fraction `baumgarte` of the overlap at
/// each of its points. A body that is not `movable` counts as static. Returns the smallest separation that it met, m, at
/// most 0.
pub fn solve_position_constraint(
    contact: &Contact,
    bodies: &mut [RigidBody],
    solver_bodies: &[SolverBody],
    baumgarte: f32,
    movable: impl Fn(usize) -> bool,
) -> f32 {
    let mut min_separation = 0.0_f32;
    let [index_a, index_b] = contact.bodies;
    let mass_scale = |body: usize| if movable(body) { 1.0 } else { 0.0 };
    let (scale_a, scale_b) = (mass_scale(index_a), mass_scale(index_b));
    for point in contact.points() {
        let (pose_a, pose_b) = (bodies[index_a].pose(), bodies[index_b].pose());
        let normal = contact.normal(&pose_a, &pose_b);
        let separation = contact.separation(point, normal, &pose_a, &pose_b);
        min_separation = min_separation.min(separation);
        let world_point = if contact.both_circles {
            (pose_a.translation + pose_b.translation) / 2.0
        } else {
            pose_b * point.local_point_b
        };
        let (arm_a, arm_b) = (world_point - pose_a.translation, world_point - pose_b.translation);
        let correction = (baumgarte * (separation + LINEAR_SLOP)).clamp(-MAX_LINEAR_CORRECTION, 0.0);
        let (a, b) = (&solver_bodies[index_a], &solver_bodies[index_b]);
        let k = scale_a * a.inv_effective_mass(arm_a, normal) + scale_b * b.inv_effective_mass(arm_b, normal);
        if correction == 0.0 || k <= 0.0 {
            continue;
        }
        let impulse = normal * (-correction / k);
        let mut displace = |body: usize, arm: Vector, impulse: Vector| {
            let (solver_body, body) = (&solver_bodies[body], &mut bodies[body]);
            let Position { centre, angle } = body.sweep.position;
            body.set_position(Position {
                centre: centre + solver_body.inv_mass * impulse,
                angle: angle + solver_body.inv_inertia * arm.perp_dot(impulse),
            });
        };
        if scale_a > 0.0 {
            displace(index_a, arm_a, -impulse);
        }
        if scale_b > 0.0 {
            displace(index_b, arm_b, impulse);
        }
    }
    min_separation
}

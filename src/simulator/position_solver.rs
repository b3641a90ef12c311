//! The position solver: nonlinear Gauss-Seidel on the positions (b2ContactSolver of Box2D 2.3).
//!
//! Overlap beyond the slop is resolved without adding velocity. Depends on bodies and contacts, not on shapes.

use rapier2d::math::Vector;

use super::body::{Position, RigidBody, SolverBody};
use super::constants::{LINEAR_SLOP, MAX_LINEAR_CORRECTION};
use super::contact::Contact;
use super::scalar::min;

/// One position iteration for a contact (SolvePositionConstraints): resolves the fraction `baumgarte` of the overlap at
/// each of its points. A body that is not `movable` counts as static. Returns the smallest separation that it met, m,
/// at most 0.
pub(crate) fn solve_position_constraint(
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
        min_separation = min(min_separation, separation);
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

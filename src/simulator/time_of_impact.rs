//! Time of impact by conservative advancement (b2TimeOfImpact of Box2D 2.3, with another root finder).
//!
//! Conservative advancement (Mirtich 1996) moves time forward by the distance over an upper bound of the approach
//! speed, so that it can never step past the impact. Box2D 2.3 finds the same time by root finding along separating
//! axes. Distances are rapier's. Without it fast bodies would sink into static ones, or tunnel through thin bars.

use rapier2d::math::{Pose, Vector};
use rapier2d::parry::query::{ClosestPoints, closest_points};

use super::body::RigidBody;
use super::constants::LINEAR_SLOP;
use super::fixture::Fixture;
use super::scalar::{length, max, min};

/// Enough for a long bar that rotates fast; a ball needs two or three.
const MAX_ITERATIONS: usize = 40;

/// Fixtures that stay this much farther apart than where they meet are not examined further, m: far more than the
/// rounding errors of all distances within a scene.
const MARGIN: f32 = 1e-3;

/// Returns the fraction of the rest of the sweeps after which two fixtures meet; `None` if they do not meet, or overlap
/// from the start. `normal` is a guess of the direction from the first to the second, that of their contact: a unit
/// vector, or zero for a contact that was never updated, which disables the shortcut.
pub(crate) fn time_of_impact(fixtures: [&Fixture; 2], bodies: [&RigidBody; 2], normal: Vector) -> Option<f32> {
    // Box2D's target: the radii overlap by three slops, to within a quarter of a slop.
    let radii: f32 = fixtures.iter().map(|fixture| fixture.radius()).sum();
    let circle_radii: f32 = fixtures.iter().filter_map(|fixture| fixture.circle_radius).sum();
    let target = max(radii - 3.0 * LINEAR_SLOP, LINEAR_SLOP) - circle_radii;
    let met = target + 0.25 * LINEAR_SLOP;

    let sweeps = bodies.map(|body| &body.sweep);
    let [displacement_a, displacement_b] = sweeps.map(|sweep| sweep.position.centre - sweep.position0.centre);
    let angular_bound =
        |i: usize| (sweeps[i].position.angle - sweeps[i].position0.angle).abs() * fixtures[i].bounding_radius;
    // A circle about the centre of mass does not move as it turns.
    let turn_bound = |i: usize| if fixtures[i].turns_in_place() { 0.0 } else { angular_bound(i) };
    let turn_bound = turn_bound(0) + turn_bound(1);
    let angular_bound = angular_bound(0) + angular_bound(1);
    let approach = (displacement_a - displacement_b).dot(normal);
    // Bound from the end of the sweeps, whose rotations are already computed.
    if separation_at_end(fixtures, bodies, normal) + min(approach, 0.0) - turn_bound > met + MARGIN {
        return None;
    }
    let speed_bound = length(displacement_b - displacement_a) + angular_bound;
    let mut time = 0.0;
    for _ in 0..MAX_ITERATIONS {
        let poses = [0, 1].map(|i| sweeps[i].position_at(time).pose() * fixtures[i].local);
        // From farther away they cannot meet in the rest of the step.
        let max_distance = met + speed_bound * (1.0 - time);
        let (distance, normal) = distance(fixtures, poses, max_distance)?;
        if distance + circle_radii <= 0.0 {
            return None;
        }
        if distance < met {
            return Some(time);
        }
        let approach = (displacement_a - displacement_b).dot(normal);
        // They cannot meet along this normal; stop early.
        if distance - max(approach + turn_bound, 0.0) * (1.0 - time) > met + MARGIN {
            return None;
        }
        let approach_bound = approach + angular_bound;
        if approach_bound <= 0.0 {
            return None;
        }
        time += (distance - target) / approach_bound;
        if time >= 1.0 {
            return None;
        }
    }
    None
}

/// Returns the separation of two fixtures along a direction at the end of their sweeps, m: a lower bound of their
/// distance.
fn separation_at_end([a, b]: [&Fixture; 2], [body_a, body_b]: [&RigidBody; 2], normal: Vector) -> f32 {
    b.lowest(&body_b.pose(), normal) + a.lowest(&body_a.pose(), -normal)
}

/// Returns the distance between two shapes and the direction from the first to the second; `None` beyond
/// `max_distance`.
fn distance([a, b]: [&Fixture; 2], [pose_a, pose_b]: [Pose; 2], max_distance: f32) -> Option<(f32, Vector)> {
    // Circles are measured from their centres, because they may overlap by the target.
    if let Some(radius) = b.circle_radius {
        let nearest = match a.circle_radius {
            Some(_) => pose_a.translation,
            None => a.shape.project_point(&pose_a, pose_b.translation, true).point,
        };
        let (length, normal) = length_and_direction(pose_b.translation - nearest);
        return Some((length - radius - a.circle_radius.unwrap_or(0.0), normal));
    }
    match closest_points(&pose_a, &*a.shape, &pose_b, &*b.shape, max_distance.max(0.0)) {
        Ok(ClosestPoints::WithinMargin(p, q)) => Some(length_and_direction(q - p)),
        Ok(ClosestPoints::Intersecting) => Some((f32::MIN, Vector::ZERO)),
        Ok(ClosestPoints::Disjoint) => None,
        Err(_) => unreachable!("rapier supports balls and convex polygons"),
    }
}

fn length_and_direction(delta: Vector) -> (f32, Vector) {
    let length = length(delta);
    (length, if length > 0.0 { delta / length } else { Vector::ZERO })
}

//! The moment of impact: when, within a step, two moving fixtures first come close.
//!
//! Advances by steps that can never jump past it: the gap to go over the fastest that any point can close it.
//! Distances are rapier's. Without it, fast bodies would sink into the static ones, or pass through thin bars.

use rapier2d::math::{Pose, Vector};
use rapier2d::parry::query::{ClosestPoints, closest_points};

use super::body::{Fixture, Rigid, Stance};
use super::constants::SLOP;

/// The share of the rest of the step after which `a` and `b` meet; `None` if they do not, or overlap from the start.
pub fn moment(fixtures: [&Fixture; 2], bodies: [&Rigid; 2]) -> Option<f32> {
    // Box2D's target: the margins may overlap by three slops, and a quarter of a slop is near enough.
    let margins: f32 = fixtures.iter().map(|fixture| fixture.ball.unwrap_or(fixture.skin())).sum();
    let balls: f32 = fixtures.iter().filter_map(|fixture| fixture.ball).sum();
    let target = (margins - 3.0 * SLOP).max(SLOP) - balls;
    let near = target + 0.25 * SLOP;

    let [way_a, way_b] = bodies.map(|body| body.now.com - body.start.com);
    let turn = |i: usize| (bodies[i].now.angle - bodies[i].start.angle).abs() * fixtures[i].reach;
    let turns = turn(0) + turn(1);
    let fastest = (way_b - way_a).length() + turns;
    let mut time = 0.0;
    for _ in 0..MAX_ADVANCES {
        let poses = [0, 1].map(|i| frame(bodies[i].start.towards(&bodies[i].now, time)) * fixtures[i].local);
        // Farther than this they cannot meet any more.
        let far = near + fastest * (1.0 - time);
        let (gap, normal) = gap(fixtures, poses, far)?;
        if gap + balls <= 0.0 {
            return None;
        }
        if gap < near {
            return Some(time);
        }
        let closing = (way_a - way_b).dot(normal) + turns;
        if closing <= 0.0 {
            return None;
        }
        time += (gap - target) / closing;
        if time >= 1.0 {
            return None;
        }
    }
    None
}

/// Enough for a long bar that turns fast; a ball needs two or three.
const MAX_ADVANCES: usize = 40;

fn frame(stance: Stance) -> Pose {
    Pose::from_parts(stance.com, stance.rotation())
}

/// Distance between two shapes and the direction from the first to the second; `None` beyond `far`.
fn gap([a, b]: [&Fixture; 2], [pose_a, pose_b]: [Pose; 2], far: f32) -> Option<(f32, Vector)> {
    // Balls may overlap by then, so they count from their centres.
    if let Some(radius) = b.ball {
        let nearest = match a.ball {
            Some(_) => pose_a.translation,
            None => a.shape.project_point(&pose_a, pose_b.translation, true).point,
        };
        let way = pose_b.translation - nearest;
        let distance = way.length();
        let gap = distance - radius - a.ball.unwrap_or(0.0);
        return Some((gap, if distance > 0.0 { way / distance } else { Vector::ZERO }));
    }
    match closest_points(&pose_a, &*a.shape, &pose_b, &*b.shape, far.max(0.0)) {
        Ok(ClosestPoints::WithinMargin(p, q)) => {
            let way = q - p;
            let distance = way.length();
            Some((distance, if distance > 0.0 { way / distance } else { Vector::ZERO }))
        }
        Ok(ClosestPoints::Intersecting) => Some((f32::MIN, Vector::ZERO)),
        Ok(ClosestPoints::Disjoint) => None,
        Err(_) => unreachable!("rapier knows balls and convex polygons"),
    }
}

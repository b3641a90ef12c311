//! When and where the ball first touches the green object in a rollout. The page draws a spark there.

use rapier2d::math::Vector;
use serde::Serialize;

use super::constants::PX_PER_METRE;
use super::distance::{Outline, pose_of};
use crate::puzzle::action::Ball;
use crate::puzzle::rollout::Rollout;
use crate::puzzle::scene::Scene;

/// Surfaces that are nearer than this touch, px. Between two steps a fast ball goes farther.
const TOUCHING: f64 = 0.5;

/// A contact of the ball with the green object.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Contact {
    /// The first such step.
    pub step: usize,
    /// Where, on the surface of the ball, px.
    pub point: [f64; 2],
}

/// Returns the first contact of the ball with the green object; `None` if they never touch.
pub fn first_contact(scene: &Scene, ball: Ball, rollout: &Rollout) -> Option<Contact> {
    let object = &scene.bodies[scene.body1];
    let (outline, ball_outline) = (Outline::of(object), Outline::of(&ball.body()));
    let limit = (TOUCHING / PX_PER_METRE) as f32;
    (0..=rollout.steps).find_map(|step| {
        let object_pose = rollout.pose(step, scene.body1).unwrap_or_else(|| pose_of(object));
        let ball_pose = rollout.pose(step, scene.bodies.len())?;
        let [nearest, _] = outline.nearest_points(object_pose, &ball_outline, ball_pose, limit)?;
        let centre = Vector::new(ball_pose[0], ball_pose[1]);
        let towards = nearest * PX_PER_METRE as f32 - centre;
        let point = centre + towards * (ball.r as f32 / towards.length().max(f32::EPSILON));
        Some(Contact { step, point: [point.x.into(), point.y.into()] })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::Task;
    use crate::simulator::simulate;

    #[test]
    fn a_ball_that_falls_on_the_object_touches_it_from_above_and_one_far_away_never() {
        let scene = Task::load("00000:000".parse().expect("an id")).expect("a task").scene;
        let object = &scene.bodies[scene.body1];
        let above = Ball { x: object.x, y: 240.0, r: 8.0 };
        let contact = first_contact(&scene, above, &simulate(&scene, Some(above)).expect("valid")).expect("a contact");
        assert!((contact.point[0] - object.x).abs() < 1.0, "{contact:?}");
        assert!(contact.step > 10);
        let far = Ball { x: 250.0, y: 5.0, r: 3.0 };
        assert_eq!(first_contact(&scene, far, &simulate(&scene, Some(far)).expect("valid")), None);
    }
}

//! The first contact of the ball with the green object in a rollout: when and where. The page draws a spark there.

use rapier2d::math::Vector;
use serde::{Deserialize, Serialize};

use super::distance::{Outline, pose_of};
use super::units::{PX_PER_METRE, metres};
use crate::puzzle::action::Ball;
use crate::puzzle::rollout::Rollout;
use crate::puzzle::scene::Scene;

/// Surfaces that are closer than this touch, px. Between two steps, a fast ball moves farther.
const TOUCHING: f64 = 0.5;

/// A contact of the ball with the green object.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Contact {
    /// The step of the contact.
    pub step: usize,
    /// The point of contact on the surface of the ball, px.
    pub point: [f64; 2],
}

/// Returns the first contact of the ball with the green object; `None` if they never touch.
pub fn first_contact(scene: &Scene, ball: Ball, rollout: &Rollout) -> Option<Contact> {
    let object = &scene.bodies[scene.body1];
    let (outline, ball_outline) = (Outline::of(object), Outline::of(&ball.body()));
    let limit = metres(TOUCHING);
    (0..=rollout.steps).find_map(|step| {
        let object_pose = rollout.pose(step, scene.body1).unwrap_or_else(|| pose_of(object));
        let ball_pose = rollout.pose(step, scene.bodies.len())?;
        outline.nearest_points(object_pose, &ball_outline, ball_pose, limit)?;
        let centre = Vector::new(ball_pose[0], ball_pose[1]);
        // The ball may have penetrated the object within a step.
        let nearest = outline.nearest_on_surface(object_pose, centre / PX_PER_METRE)?;
        let towards = nearest * PX_PER_METRE - centre;
        let point = centre + towards * (ball.r as f32 / towards.length().max(f32::EPSILON));
        Some(Contact { step, point: [point.x.into(), point.y.into()] })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::scene::Shape;
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
        // At this step, the ball has already penetrated the bar.
        let scene = Task::load("00003:005".parse().expect("an id")).expect("a task").scene;
        let ball = Ball { x: 119.0, y: 150.0, r: 19.0 };
        let rollout = simulate(&scene, Some(ball)).expect("valid");
        let Contact { step, point: [x, y] } = first_contact(&scene, ball, &rollout).expect("a contact");
        let [bar_x, bar_y, angle] = rollout.pose(step, scene.body1).expect("it moves").map(f64::from);
        let Shape::Polygon(corners) = &scene.bodies[scene.body1].shapes[0] else { panic!("a bar") };
        let half_height = corners.iter().map(|[_, y]| y.abs()).fold(0.0, f64::max);
        let above = (y - bar_y) * libm::cos(angle) - (x - bar_x) * libm::sin(angle);
        assert!((above.abs() - half_height).abs() < 2.0, "{above} px above the middle of a bar of {half_height}");
        let far = Ball { x: 250.0, y: 5.0, r: 3.0 };
        assert_eq!(first_contact(&scene, far, &simulate(&scene, Some(far)).expect("valid")), None);
    }
}

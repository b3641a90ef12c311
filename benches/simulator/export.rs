//! Writes the rollouts as text, for implementations in other languages.

use std::fmt::Write;

use pathlight::puzzle::action::Ball;
use pathlight::puzzle::rollout::{GOAL_STEPS, MAX_STEPS};
use pathlight::puzzle::scene::{Scene, Shape, walls};
use pathlight::simulator::constants::{
    ANGULAR_DAMPING, BALL_TOUCH_DISTANCE, DENSITY, FRICTION, GRAVITY, POSITION_ITERATIONS, RESTITUTION, TIME_STEP,
    VELOCITY_ITERATIONS,
};
use pathlight::simulator::units::PX_PER_METRE;

/// Returns the rollouts as text. The first line holds the parameters. Then follow, for each rollout, its goal and its
/// number of bodies, and for each body its pose and shapes. Values that a shape does not have are 0.
pub fn export(rollouts: &[(Scene, Ball)]) -> String {
    let mut text = format!(
        "{MAX_STEPS} {GOAL_STEPS} {VELOCITY_ITERATIONS} {POSITION_ITERATIONS} {PX_PER_METRE} {TIME_STEP} {GRAVITY} {DENSITY} \
         {FRICTION} {RESTITUTION} {ANGULAR_DAMPING}\n"
    );
    let mut line = |line: String| writeln!(text, "{line}").expect("text has no end");
    for (scene, ball) in rollouts {
        let bodies: Vec<_> = walls().into_iter().chain(scene.bodies.iter().cloned()).chain([ball.body()]).collect();
        let [object, goal] = [scene.body1, scene.body2].map(|body| scene.bodies[body].ball_radius());
        let touch_distance = object.zip(goal).map_or(0.0, |(r1, r2)| r1 + r2 + BALL_TOUCH_DISTANCE);
        let first = walls().len();
        line(format!("{} {} {touch_distance} {}", first + scene.body1, first + scene.body2, bodies.len()));
        for body in bodies {
            let dynamic = u8::from(body.dynamic);
            line(format!("{dynamic} {} {} {} {}", body.x, body.y, body.angle, body.shapes.len()));
            for shape in body.shapes {
                line(match shape {
                    Shape::Circle(radius) => format!("{radius} 0"),
                    Shape::Polygon(corners) => {
                        let corners: Vec<String> = corners.iter().map(|[x, y]| format!("{x} {y}")).collect();
                        format!("0 {} {}", corners.len(), corners.join(" "))
                    }
                });
            }
        }
    }
    text
}

//! The mechanics of a rollout: friction, restitution, stacks and thin walls behave as in textbooks.
//!
//! px and seconds throughout, 6 px to the metre. Momentum, the restitution threshold and sleep need access to the
//! world's internals: they are tested in `simulator/world.rs`.
#![cfg(not(target_arch = "wasm32"))]

use pathlight::puzzle::rollout::{MAX_STEPS, Pose, Rollout, STEPS_PER_SECOND};
use pathlight::puzzle::scene::{Body, Role, Scene, Shape, ShapeType, rectangle};
use pathlight::simulator::simulate;

/// 9.8 m/s^2 in px/s^2.
const GRAVITY: f64 = 9.8 * 6.0;

/// PHYRE's friction coefficient and restitution.
const FRICTION: f64 = 0.5;
const RESTITUTION: f64 = 0.2;

/// Radius of the skin around polygons, px: a body rests this far from a polygon.
const SKIN: f64 = 0.06;

fn body(shape: Shape, [x, y]: [f64; 2], degrees: f64, dynamic: bool) -> Body {
    let role = if dynamic { Role::Gray } else { Role::Black };
    Body { x, y, angle: degrees.to_radians(), dynamic, shape_type: ShapeType::Bar, role, shapes: vec![shape] }
}

/// Simulates these bodies. The goal is out of reach: a green and a blue ball stay apart on the floor.
fn rollout_of(bodies: Vec<Body>) -> Rollout {
    let ball = |x, role| Body { role, ..body(Shape::Circle(2.0), [x, 2.0 + SKIN], 0.0, true) };
    let (body1, body2) = (bodies.len(), bodies.len() + 1);
    let bodies = bodies.into_iter().chain([ball(4.0, Role::Green), ball(252.0, Role::Blue)]).collect();
    let rollout = simulate(&Scene { body1, body2, bodies }, None).expect("no ball to refuse");
    assert_eq!(rollout.steps, MAX_STEPS);
    rollout
}

/// Returns the poses of one body, step by step.
fn path(rollout: &Rollout, body: usize) -> Vec<Pose> {
    (0..=rollout.steps).map(|step| rollout.pose(step, body).expect("a dynamic body")).collect()
}

/// Returns how far a block that starts at rest on a slope of this angle has slid after each step, px.
fn slide(degrees: f64) -> Vec<f64> {
    let (sin, cos) = degrees.to_radians().sin_cos();
    let (length, thickness) = (20.0, 6.0);
    // The block starts high on the slope, on its surface.
    let (along, above) = (60.0, thickness + 2.0 * SKIN);
    let start = [128.0 + along * cos - above * sin, 128.0 + along * sin + above * cos];
    let block = body(rectangle(length, thickness), start, degrees, true);
    let slope = body(rectangle(220.0, thickness), [128.0, 128.0], degrees, false);
    let moved = |[x, y, _]: Pose| (start[0] - f64::from(x)) * cos + (start[1] - f64::from(y)) * sin;
    path(&rollout_of(vec![block, slope]), 0).into_iter().map(moved).collect()
}

#[test]
fn a_block_sticks_below_the_friction_angle() {
    let friction_angle = FRICTION.atan().to_degrees();
    for degrees in [5.0, 15.0, friction_angle - 1.0] {
        let slid = slide(degrees);
        assert!(slid[MAX_STEPS].abs() < 0.5, "at {degrees} degrees it slides by {} px", slid[MAX_STEPS]);
        assert_eq!(slid[MAX_STEPS], slid[MAX_STEPS / 2], "at {degrees} degrees it comes to rest");
    }
}

#[test]
fn a_block_slides_above_the_friction_angle_as_friction_says() {
    let friction_angle = FRICTION.atan().to_degrees();
    for degrees in [friction_angle + 1.0, 35.0, 45.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let acceleration = GRAVITY * (sin - FRICTION * cos);
        let slid = slide(degrees);
        let expected = acceleration / 2.0;
        let after_a_second = slid[STEPS_PER_SECOND];
        assert!(
            (after_a_second - expected).abs() < 0.04 * expected + 0.1,
            "{degrees}: {after_a_second}, not {expected}"
        );
    }
}

/// Returns the heights of the lowest point of a ball above the skin of the floor, dropped from this height, px.
fn drop_from(height: f64) -> Vec<f64> {
    let radius = 8.0;
    let ball = body(Shape::Circle(radius), [128.0, radius + SKIN + height], 0.0, true);
    path(&rollout_of(vec![ball]), 0).into_iter().map(|[_, y, _]| f64::from(y) - radius - SKIN).collect()
}

/// Returns the highest point after the ball has first turned upwards, px; its last height if it never does.
fn rebound(heights: &[f64]) -> f64 {
    let lowest = heights.windows(2).position(|pair| pair[1] > pair[0]).unwrap_or(heights.len() - 1);
    heights[lowest..].iter().copied().fold(f64::MIN, f64::max)
}

#[test]
fn a_fast_ball_bounces_by_its_restitution() {
    for height in [60.0, 120.0, 200.0] {
        let expected = RESTITUTION * RESTITUTION * height;
        let rebound = rebound(&drop_from(height));
        assert!((rebound - expected).abs() < 0.1 * expected + 0.2, "from {height} px: {rebound} px, not {expected}");
    }
}

#[test]
fn no_ball_tunnels_through_a_thin_bar() {
    // A ball falls by up to 2.6 px in a step, more than the combined thickness of the ball and the bar.
    let (radius, thickness, bar) = (0.5, 0.2, 10.0);
    let balls = (0..20)
        .map(|i| body(Shape::Circle(radius), [30.0 + 10.0 * f64::from(i), 150.3 + 5.0 * f64::from(i)], 0.0, true));
    let count = balls.len();
    let rollout = rollout_of(balls.chain([body(rectangle(240.0, thickness), [128.0, bar], 0.0, false)]).collect());
    for index in 0..count {
        let path = path(&rollout, index);
        let lowest = path.iter().map(|[_, y, _]| f64::from(*y)).fold(f64::MAX, f64::min);
        let fastest = path.windows(2).map(|pair| f64::from(pair[0][1] - pair[1][1])).fold(0.0, f64::max);
        assert!(fastest > 2.0 * radius + thickness, "ball {index} moves by only {fastest} px in a step");
        assert!(lowest > bar, "ball {index} falls through the bar, to {lowest}");
    }
}

#[test]
fn a_stack_of_boxes_stands() {
    let side = 20.0;
    let height = |i: usize| side / 2.0 + SKIN + i as f64 * (side + 2.0 * SKIN);
    let boxes: Vec<Body> = (0..6).map(|i| body(rectangle(side, side), [128.0, height(i)], 0.0, true)).collect();
    let count = boxes.len();
    let rollout = rollout_of(boxes);
    for index in 0..count {
        let path = path(&rollout, index);
        let [x, y, angle] = path[MAX_STEPS].map(f64::from);
        assert!((x - 128.0).abs() < 0.1 && angle.abs() < 0.01, "box {index} leans: {x} px, {angle} radians");
        // Each contact yields by at most the slop, 0.03 px, and a little more under load.
        assert!((y - height(index)).abs() < 0.05 * (index + 1) as f64, "box {index} is at {y}, not {}", height(index));
        assert_eq!(path[MAX_STEPS], path[MAX_STEPS / 2], "box {index} comes to rest");
    }
}

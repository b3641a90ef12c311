//! PHYRE's rule for valid actions and the balls that they place, at its edges.
#![cfg(not(target_arch = "wasm32"))]

use pathlight::puzzle::action::{Action, Ball, Invalid, Obstacles, RADIUS, overlaps};
use pathlight::puzzle::scene::{Body, Role, SIZE, Scene, Shape, ShapeType, rectangle};
use pathlight::puzzle::task::{self, Task, TaskId};
use pathlight::puzzle::templates::TEMPLATES;
use proptest::prelude::*;

/// A scene of one static body in the middle, or of no body for `None`.
fn scene_with(shape: Option<Shape>) -> Scene {
    let body = |shape| Body {
        x: 128.0,
        y: 128.0,
        angle: 0.0,
        dynamic: false,
        shape_type: ShapeType::Bar,
        role: Role::Black,
        shapes: vec![shape],
    };
    Scene { body1: 0, body2: 0, bodies: shape.into_iter().map(body).collect() }
}

/// Returns the action whose ball has this centre and radius before rounding, px.
fn action(x: f64, y: f64, r: f64) -> Action {
    Action { x: x / 255.0, y: y / 255.0, r: (r - 2.0) / 30.0 }
}

#[test]
fn an_action_out_of_range_is_invalid() {
    let empty = scene_with(None);
    let good = Action { x: 0.5, y: 0.5, r: 0.5 };
    assert!(good.place(&empty).is_ok());
    for bad in [-1e-9, 1.0 + 1e-9, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for action in [Action { x: bad, ..good }, Action { y: bad, ..good }, Action { r: bad, ..good }] {
            assert_eq!(action.place(&empty), Err(Invalid::OutOfRange), "{action:?}");
        }
    }
}

#[test]
fn the_centre_is_truncated_and_the_radius_rounded_half_to_even() {
    let empty = scene_with(None);
    for (r, rounded) in [(2.5, 2.0), (3.5, 4.0), (2.51, 3.0), (3.49, 3.0)] {
        let action = action(100.9, 99.999, r);
        assert_eq!(2.0 + 30.0 * action.r, r, "the radius before rounding is exact");
        assert_eq!(action.place(&empty), Ok(Ball { x: 100.0, y: 99.0, r: rounded }));
    }
}

#[test]
fn a_ball_may_touch_the_edges_of_the_scene() {
    let empty = scene_with(None);
    for (at, valid) in [(2.0, true), (1.99, false), (254.0, true), (254.01, false)] {
        assert_eq!(action(at, 100.0, 2.0).place(&empty).is_ok(), valid, "x = {at}");
        assert_eq!(action(100.0, at, 2.0).place(&empty).is_ok(), valid, "y = {at}");
    }
}

#[test]
fn a_ball_is_inside_the_scene_before_and_after_rounding() {
    let empty = scene_with(None);
    // Inside before rounding: 5.4 <= 5.7. After rounding, the radius 5 is inside, the radius 6 is not.
    assert_eq!(action(5.7, 100.0, 5.4).place(&empty), Ok(Ball { x: 5.0, y: 100.0, r: 5.0 }));
    assert_eq!(action(5.7, 100.0, 5.6).place(&empty), Err(Invalid::Outside));
    // Outside before rounding, although the rounded ball would be inside.
    assert_eq!(action(5.1, 100.0, 5.4).place(&empty), Err(Invalid::Outside));
}

#[test]
fn touching_a_body_is_valid_and_overlapping_it_is_not() {
    let (circle, square) = (scene_with(Some(Shape::Circle(10.0))), scene_with(Some(rectangle(20.0, 20.0))));
    for scene in [circle, square] {
        // The surfaces are at 118 and at x + 5; PHYRE tolerates an overlap of 1e-5.
        let ball = |x| Ball { x, y: 128.0, r: 5.0 };
        for (overlap, result) in [(-1.0, Ok(())), (0.0, Ok(())), (0.9e-5, Ok(())), (1.1e-5, Err(Invalid::Overlaps(0)))]
        {
            assert_eq!(ball(113.0 + overlap).check(&scene), result, "overlap {overlap}");
        }
        assert_eq!(ball(128.0).check(&scene), Err(Invalid::Overlaps(0)), "a ball within the body");
    }
}

#[test]
fn a_ball_touches_the_corner_of_a_polygon_at_its_distance() {
    let square = scene_with(Some(rectangle(20.0, 20.0)));
    // The corner is at (138, 138); 3, 4 and 5 are a right-angled triangle.
    assert_eq!(Ball { x: 141.0, y: 142.0, r: 5.0 }.check(&square), Ok(()));
    assert_eq!(Ball { x: 141.0, y: 141.9, r: 5.0 }.check(&square), Err(Invalid::Overlaps(0)));
}

#[test]
fn the_first_body_that_the_ball_overlaps_is_named() {
    let mut scene = scene_with(Some(Shape::Circle(10.0)));
    let other = Body { x: 60.0, ..scene.bodies[0].clone() };
    scene.bodies.extend([other.clone(), other]);
    assert_eq!(Ball { x: 60.0, y: 120.0, r: 8.0 }.check(&scene), Err(Invalid::Overlaps(1)));
}

#[test]
fn a_radius_out_of_range_is_invalid() {
    for r in [1.99, 32.01, f64::NAN] {
        assert_eq!(Ball { x: 100.0, y: 100.0, r }.check(&scene_with(None)), Err(Invalid::Radius));
    }
}

/// Returns the exact distance between a point and a body, px, by the textbook formula; not positive inside.
fn distance_to_body([x, y]: [f64; 2], body: &Body) -> f64 {
    let to_shape = |shape: &Shape| match shape {
        Shape::Circle(radius) => libm::hypot(x - body.x, y - body.y) - radius,
        Shape::Polygon(corners) => {
            let corners: Vec<[f64; 2]> = corners.iter().map(|&corner| body.to_scene(corner)).collect();
            let edges = || corners.iter().zip(corners.iter().cycle().skip(1));
            let to_edge = |(a, b): (&[f64; 2], &[f64; 2])| {
                let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
                let along = (((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
                libm::hypot(a[0] + along * dx - x, a[1] + along * dy - y)
            };
            let left_of =
                |(a, b): (&[f64; 2], &[f64; 2])| (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) >= 0.0;
            if edges().all(left_of) { 0.0 } else { edges().map(to_edge).fold(f64::INFINITY, f64::min) }
        }
    };
    body.shapes.iter().map(to_shape).fold(f64::INFINITY, f64::min)
}

/// A task of any template.
fn tasks() -> impl Strategy<Value = Task> {
    (0..TEMPLATES.len(), any::<prop::sample::Index>()).prop_map(|(template, index)| {
        let ids: Vec<TaskId> = task::ids(TEMPLATES[template]).collect();
        Task::load(*index.get(&ids)).expect("an id of the template")
    })
}

fn actions() -> impl Strategy<Value = Action> {
    (0.0..=1.0, 0.0..=1.0, 0.0..=1.0).prop_map(|(x, y, r)| Action { x, y, r })
}

proptest! {
    #[test]
    fn in_an_empty_scene_only_the_edges_matter(action in actions()) {
        let inside = |x: f64, y: f64, r: f64| [x, y].iter().all(|at| r <= *at && *at <= 256.0 - r);
        let (x, y, r) = (255.0 * action.x, 255.0 * action.y, 2.0 + 30.0 * action.r);
        let rounded = [x.floor(), y.floor(), r.round_ties_even()];
        let valid = inside(x, y, r) && inside(rounded[0], rounded[1], rounded[2]);
        let expected = if valid { Ok(Ball::from(rounded)) } else { Err(Invalid::Outside) };
        prop_assert_eq!(action.place(&scene_with(None)), expected);
    }

    #[test]
    fn a_placed_ball_overlaps_a_circle_if_the_centres_are_near(action in actions()) {
        let scene = scene_with(Some(Shape::Circle(20.5)));
        let Ok(ball) = action.place(&scene_with(None)) else { return Ok(()) };
        let distance = libm::hypot(ball.x - 128.0, ball.y - 128.0);
        let expected = if distance + 1e-5 < ball.r + 20.5 { Err(Invalid::Overlaps(0)) } else { Ok(ball) };
        prop_assert_eq!(action.place(&scene), expected);
    }

    #[test]
    fn a_placed_ball_is_valid_and_its_own_action_places_it_again(action in actions()) {
        let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
        if let Ok(ball) = action.place(&scene) {
            prop_assert!(RADIUS.contains(&ball.r) && ball.x < SIZE && ball.y < SIZE);
            prop_assert_eq!(ball.check(&scene), Ok(()));
            prop_assert_eq!(ball.action().place(&scene), Ok(ball));
            prop_assert_eq!(ball.rounded(), ball);
            prop_assert_eq!(Obstacles::new(&scene).place(action), Ok(ball));
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn one_clearance_decides_for_all_radii_like_the_distances_to_all_bodies(task in tasks(), action in actions()) {
        let Ok(Ball { x, y, .. }) = (Action { r: 0.0, ..action }).place(&scene_with(None)) else { return Ok(()) };
        let obstacles = Obstacles::new(&task.scene);
        let clearance = obstacles.clearance([x, y], *RADIUS.end());
        for r in (2..=32).map(f64::from) {
            let ball = Ball { x, y, r };
            if ball.check(&scene_with(None)).is_err() { continue }
            let first = task.scene.bodies.iter().position(|body| distance_to_body([x, y], body) + 1e-5 < r);
            prop_assert_eq!(obstacles.check(&ball), first.map_or(Ok(()), |index| Err(Invalid::Overlaps(index))));
            prop_assert_eq!(overlaps(clearance, r), first.is_some(), "{}", ball);
        }
    }
}

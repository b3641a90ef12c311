//! Random scenes: bodies and goal drawn at random, in any topology, without a template's script. Nets train on them to
//! learn physics, and are measured on them.
//!
//! Static bars, pegs, jars and shelves are placed first and may overlap, as they do in the benchmark. Dynamic bodies
//! are then dropped onto them or hang in the air. A scene may have no solution.

use std::f64::consts::{FRAC_PI_2, PI};

use pathlight::puzzle::dimensions::{Dimensions, THICKNESS};
use pathlight::puzzle::scene::{Body, Role, SIZE, Scene, ShapeType};
use pathlight::simulator::distance::distance;
use pathlight::simulator::outcome;
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Minimum distance between a dynamic body and any other body, px.
const CLEARANCE: f64 = 0.5;

/// Minimum distance between object and goal, px.
const APART: f64 = 8.0;

/// Probability that the goal may lie above the object; hardly any ball can lift the object.
const LIFTED: f64 = 0.2;

/// Positions tried for a dynamic body.
const PLACES: usize = 30;

/// Distance that a body falls between two collision checks, px.
const FALL: f64 = 1.0;

/// Mixed into the number of a scene, so that its draws differ from those of a task with the same seed.
const SALT: u64 = 0x72616e646f6d;

/// Returns the random scene with this number. It is not solved without a ball.
pub fn random_scene(number: u32) -> Scene {
    let mut rng = Pcg64Mcg::seed_from_u64(u64::from(number) ^ SALT << 32);
    let mut scenes = std::iter::repeat_with(|| drawn(&mut rng)).flatten();
    scenes.find(|scene| outcome(scene, None).is_ok_and(|alone| !alone.solved)).expect("draws do not end")
}

/// Draws a scene; `None` if no two of its bodies can be object and goal.
fn drawn(rng: &mut Pcg64Mcg) -> Option<Scene> {
    let mut bodies = Vec::new();
    for _ in 0..rng.random_range(1..=6) {
        bodies.extend(static_bodies(rng));
    }
    for _ in 0..rng.random_range(1..=4) {
        let dynamic = dynamic_body(&bodies, rng);
        bodies.extend(dynamic);
    }
    with_goal(bodies, rng)
}

/// A body at the origin.
fn body(dimensions: Dimensions, dynamic: bool) -> Body {
    let role = if dynamic { Role::Gray } else { Role::Black };
    let (shape_type, shapes) = (dimensions.shape_type(), dimensions.shapes());
    Body { x: 0.0, y: 0.0, angle: 0.0, dynamic, shape_type, role, shapes }
}

/// Draws a ball whose radius is a half-integer, as in PHYRE's scenes.
fn ball(radii: std::ops::Range<f64>, rng: &mut Pcg64Mcg) -> Dimensions {
    Dimensions::Ball { radius: rng.random_range(radii).floor() + 0.5 }
}

fn bar(lengths: std::ops::Range<f64>, rng: &mut Pcg64Mcg) -> Dimensions {
    Dimensions::Bar { length: rng.random_range(lengths), thickness: THICKNESS }
}

/// Draws the angle of a static bar: level, upright or tilted.
fn bar_angle(rng: &mut Pcg64Mcg) -> f64 {
    match rng.random_range(0..10) {
        0..4 => 0.0,
        4..6 => FRAC_PI_2,
        _ => rng.random_range(-PI / 3.0..PI / 3.0),
    }
}

/// Draws one static body or a group of them.
fn static_bodies(rng: &mut Pcg64Mcg) -> Vec<Body> {
    let anywhere = |rng: &mut Pcg64Mcg| [(); 2].map(|()| rng.random_range(0.0..SIZE));
    let at = |dimensions, [x, y]: [f64; 2], angle| Body { x, y, angle, ..body(dimensions, false) };
    match rng.random_range(0..13) {
        0..5 => vec![at(bar(20.0..180.0, rng), anywhere(rng), bar_angle(rng))],
        5 => vec![at(Dimensions::Bar { length: SIZE, thickness: THICKNESS }, [SIZE / 2.0, THICKNESS / 2.0], 0.0)],
        6 | 7 => {
            // A shelf ends at a side wall.
            let shelf = bar(30.0..130.0, rng);
            let angle = if rng.random() { 0.0 } else { rng.random_range(-PI / 4.0..PI / 4.0) };
            let mut shelf = at(shelf, anywhere(rng), angle);
            let [left, _, right, _] = shelf.bounds();
            shelf.x += if rng.random() { -left } else { SIZE - right };
            vec![shelf]
        }
        8 | 9 => {
            let (peg, [mut x, mut y]) = (ball(4.0..9.0, rng), anywhere(rng));
            let (step, mut angle) = (rng.random_range(16.0..40.0), rng.random_range(0.0..2.0 * PI));
            let chain = (0..rng.random_range(3..12)).map(|_| {
                (x, y) = (x + step * libm::cos(angle), y + step * libm::sin(angle));
                angle += rng.random_range(-0.6..0.6);
                at(peg, [x, y], 0.0)
            });
            chain.filter(|peg| (0.0..SIZE).contains(&peg.x) && (0.0..SIZE).contains(&peg.y)).collect()
        }
        10 => {
            // Parallel bars, in a row or a column.
            let (slat, angle, [x, y]) = (bar(20.0..90.0, rng), bar_angle(rng), anywhere(rng));
            let (gap, column) = (rng.random_range(18.0..45.0), rng.random());
            let offset = |index: i32| gap * f64::from(index);
            let place = |index| if column { [x, y + offset(index)] } else { [x + offset(index), y] };
            (0..rng.random_range(2..6)).map(|index| at(slat, place(index), angle)).collect()
        }
        11 => vec![at(ball(6.0..30.0, rng), anywhere(rng), 0.0)],
        _ => vec![at(Dimensions::Jar { height: rng.random_range(25.0..80.0) }, anywhere(rng), 0.0)],
    }
}

/// Draws a dynamic body that rests on other bodies or hangs in the air; `None` if there is no room.
fn dynamic_body(others: &[Body], rng: &mut Pcg64Mcg) -> Option<Body> {
    let (dimensions, angle) = match rng.random_range(0..10) {
        0..6 => (ball(5.0..26.0, rng), 0.0),
        6 => (bar(20.0..110.0, rng), 0.0),
        7 => (bar(20.0..90.0, rng), FRAC_PI_2),
        8 => (Dimensions::Jar { height: rng.random_range(20.0..70.0) }, if rng.random_bool(0.7) { 0.0 } else { PI }),
        _ if rng.random_bool(0.3) => (Dimensions::StandingSticks { length: rng.random_range(20.0..70.0) }, 0.0),
        _ => (bar(20.0..90.0, rng), rng.random_range(-PI / 2.0..PI / 2.0)),
    };
    let mut body = Body { angle, ..body(dimensions, true) };
    let clear = |body: &Body| {
        let [left, bottom, right, top] = body.bounds();
        let inside = left >= CLEARANCE && bottom >= CLEARANCE && right <= SIZE - CLEARANCE && top <= SIZE - CLEARANCE;
        inside && others.iter().all(|other| distance(body, other) >= CLEARANCE)
    };
    let found = (0..PLACES).any(|_| {
        (body.x, body.y) = (rng.random_range(0.0..SIZE), rng.random_range(0.0..SIZE));
        clear(&body)
    });
    if !found {
        return None;
    }
    if rng.random_bool(0.7) {
        while clear(&body) {
            body.y -= FALL;
        }
        body.y += FALL;
    }
    Some(body)
}

/// Makes one body the object and another the goal; `None` if no two qualify.
fn with_goal(mut bodies: Vec<Body>, rng: &mut Pcg64Mcg) -> Option<Scene> {
    let movable: Vec<usize> = (0..bodies.len()).filter(|&index| bodies[index].dynamic).collect();
    let balls: Vec<usize> =
        movable.iter().copied().filter(|&index| bodies[index].shape_type == ShapeType::Ball).collect();
    let candidates = if rng.random_bool(0.8) && !balls.is_empty() { balls } else { movable };
    let body1 = *candidates.choose(rng)?;
    let visible = |body: &Body| (0.0..SIZE).contains(&body.x) && (0.0..SIZE).contains(&body.y);
    let [_, _, _, top] = bodies[body1].bounds();
    let lifted = rng.random_bool(LIFTED);
    let goals = |dynamic: bool| -> Vec<usize> {
        let may_be = |index: usize| {
            let body: &Body = &bodies[index];
            let kind = index != body1 && body.dynamic == dynamic && visible(body);
            kind && (lifted || body.bounds()[1] < top) && distance(&bodies[body1], body) >= APART
        };
        (0..bodies.len()).filter(|&index| may_be(index)).collect()
    };
    let kinds: Vec<Vec<usize>> = [goals(true), goals(false)].into_iter().filter(|goals| !goals.is_empty()).collect();
    let body2 = *kinds.choose(rng)?.choose(rng)?;
    bodies[body1].role = Role::Green;
    bodies[body2].role = if bodies[body2].dynamic { Role::Blue } else { Role::Purple };
    Some(Scene { body1, body2, bodies })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_gives_the_same_scene_every_time_and_another_number_another() {
        assert_eq!(random_scene(3), random_scene(3));
        assert_ne!(random_scene(3), random_scene(4));
    }

    #[test]
    fn dynamic_bodies_touch_nothing_at_the_start_and_the_goal_is_not_reached_alone() {
        for scene in (0..200).map(random_scene) {
            let Scene { body1, body2, bodies } = &scene;
            assert!(bodies[*body1].dynamic && bodies[*body1].role == Role::Green && body1 != body2);
            assert!(matches!(
                (bodies[*body2].dynamic, bodies[*body2].role),
                (true, Role::Blue) | (false, Role::Purple)
            ));
            for (index, body) in bodies.iter().enumerate().filter(|(_, body)| body.dynamic) {
                let near = bodies.iter().enumerate().filter(|&(other, _)| other != index);
                assert!(near.map(|(_, other)| distance(body, other)).all(|apart| apart >= CLEARANCE - 1e-3));
            }
            assert!(!outcome(&scene, None).expect("no ball, so none is invalid").solved);
        }
    }
}

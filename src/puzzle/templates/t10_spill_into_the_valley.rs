//! 00010 Spill into the Valley.

use super::{Lin, Params, Template, task_numbers};
use crate::puzzle::layout::{Ball, Bar, Jar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 10,
    name: "Spill into the Valley",
    story: "A jar with a ball inside lies on the left slope of a valley; get the ball to the right slope.",
    grid: &[
        ("bar_angle", Lin(75.0, 105.0, 5)),
        ("center_point", Lin(0.2, 0.6, 6)),
        ("jar_vertical_top_offset", Lin(15.0, 35.0, 3)),
        ("right_bar_angle", Lin(10.0, 50.0, 6)),
    ],
    script,
    task_numbers: task_numbers(
        "25 48 51 59 71 87 102 108 113 119 147 155 175 178 188 190 191 219 230 237 253 259 261 \
         263 272 273 276 278 285 286 292 298 301 303 308 320 325-330 332 360 364 366 367 370 379 \
         381 386 387 395 397 403 405 408 411 421 422 427 428 431 438-441 443 448 454 455 459 464 \
         465 469 470 472-474 476 478 482 484 487 488 490 493 495 497 501 502 504 505 508 509 517 \
         519 521 527 534",
    ),
    combinations: [
        521, 303, 527, 212, 400, 436, 394, 515, 333, 28, 424, 340, 182, 382, 491, 539, 322, 431, 111, 250, 497, 89,
        272, 70, 112, 459, 338, 455, 489, 197, 406, 471, 268, 179, 244, 213, 52, 447, 231, 448, 130, 365, 291, 142,
        107, 14, 467, 315, 496, 502, 327, 412, 161, 232, 219, 442, 534, 490, 124, 104, 328, 183, 520, 479, 225, 418,
        129, 296, 449, 345, 53, 388, 435, 533, 483, 509, 71, 97, 34, 454, 242, 466, 218, 117, 211, 518, 220, 98, 309,
        472, 351, 106, 464, 241, 516, 256, 430, 482, 335, 437,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let right_angle = p.num("right_bar_angle");
    let tilt = right_angle - p.num("bar_angle");
    let right = static_body(Bar(1.0)).rotated(right_angle).at_left(SIZE * p.num("center_point")).at_bottom(-2.0);
    let left = static_body(Bar(1.0)).rotated(tilt).at_right(right.left()).at_bottom(-2.0);
    // A valley that ends short of a wall is moved to it.
    let shift = if right.right() < SIZE {
        SIZE - right.right()
    } else if left.left() > 0.0 {
        -left.left()
    } else {
        0.0
    };
    let (right, left) = (right.shifted(shift), left.shifted(shift));
    let jar = dynamic_body(Jar(0.2)).rotated(tilt).at_left(5.0).at_top(SIZE - p.num("jar_vertical_top_offset"));
    // The helper bar is on the slope and ends where the slope passes the level of the jar.
    let over = tilt.abs() > 90.0;
    let level = if over { jar.top() } else { jar.bottom() };
    let helper = static_body(Bar((level - left.bottom()) / (left.top() - left.bottom())))
        .rotated(tilt)
        .at_right(left.right())
        .at_bottom(left.bottom());
    let slope_edge = if over { helper.right() } else { helper.left() };
    let jar_left = jar.left().max(slope_edge + 5.0);
    let jar = jar.at_left(jar_left);
    let ball = dynamic_body(Ball(0.08)).at_cx(jar.cx()).at_cy(jar.cy());
    Some(scene([right.goal(), left, jar, helper, ball.object()]))
}

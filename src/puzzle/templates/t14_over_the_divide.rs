//! 00014 Over the Divide.

use super::{Flag, Lin, Params, Template, task_numbers};
use crate::puzzle::layout::{Ball, Bar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 14,
    name: "Over the Divide",
    story: "A ball lands beside a thin post; get it past the hanging divider to the other half of the floor.",
    grid: &[
        ("ball_size", Lin(0.05, 0.15, 5)),
        ("height", Lin(0.3, 0.7, 8)),
        ("hole_left", Lin(0.1, 0.3, 8)),
        ("left", Flag),
    ],
    script,
    task_numbers: task_numbers(
        "6 9 11 26 50 75 94 96 123 148 154 165 183 191 194 206 214 241 251 256 267 273 275 282 \
         288 301 315 316 318 334 346 352 357 358 376 381 394 402 404 407 408 411 418 421 424 435 \
         448 452 454 456 466 470 471 478 479 488 489 493 496 498 501 514-516 518 519 523 525 528 \
         531 534 543 551 555 562 564 568 569 576 577 583 585 586 595 596 603 605-607 613-617 625 \
         629 631 633 634 636",
    ),
    combinations: [
        138, 134, 27, 126, 141, 6, 154, 24, 155, 78, 152, 137, 136, 9, 284, 26, 522, 110, 11, 414, 111, 157, 45, 29,
        393, 128, 61, 112, 95, 90, 25, 268, 143, 287, 93, 447, 350, 42, 108, 171, 260, 38, 511, 4, 142, 238, 153, 22,
        160, 398, 222, 383, 174, 12, 253, 13, 254, 16, 2, 124, 8, 0, 190, 478, 75, 479, 79, 73, 10, 40, 264, 388, 385,
        139, 97, 281, 5, 265, 64, 205, 127, 220, 3, 351, 80, 241, 516, 49, 94, 44, 256, 392, 430, 266, 335, 76, 65,
        577, 255, 83,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let (on_left, hole) = (p.flag("left"), p.num("hole_left"));
    let x = if on_left { hole } else { 1.0 - hole };
    let ball = dynamic_body(Ball(p.num("ball_size"))).at_cx(SIZE * x).at_bottom(SIZE * p.num("height"));
    let post_x = if on_left { ball.right() } else { ball.left() };
    let post = static_body(Bar(0.75 * hole)).rotated(90.0).at_bottom(0.0).at_cx(post_x);
    let divider = static_body(Bar(0.7)).rotated(90.0).at_left(SIZE / 2.0).at_top(SIZE);
    let left_floor = static_body(Bar(0.5)).at_left(0.0).at_bottom(0.0);
    let right_floor = static_body(Bar(0.5)).at_left(left_floor.right()).at_bottom(0.0);
    let (left_floor, right_floor) =
        if on_left { (left_floor, right_floor.goal()) } else { (left_floor.goal(), right_floor) };
    Some(scene([ball.object(), post, divider, left_floor, right_floor]))
}

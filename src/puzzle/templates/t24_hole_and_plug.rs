//! 00024 Hole and Plug.

use super::{Flag, Lin, Params, Template, skip, task_numbers};
use crate::puzzle::layout::{Ball, Bar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 24,
    name: "Hole and Plug",
    story: "A slightly larger ball drops into the hole of a raised floor first; get the other ball down to the ground.",
    grid: &[
        ("ball_distance", Lin(0.1, 0.3, 4)),
        ("bar_height", Lin(0.15, 0.6, 10)),
        ("confounder", Flag),
        ("hole_left", Lin(0.2, 0.8, 12)),
    ],
    script,
    task_numbers: task_numbers(
        "6 10 24 36 40 48 50 62 78 79 95 97 98 113 116 118 132 139 145 146 172 184 190 199 205 \
         221 222 224 246 251 285 296 302 306 309 315 316 321 342 345 347 350 360 362 376 381 384 \
         395 409 410 415 417 421 432 435 440 455 456 471 481 482 494 499 503 508 518 524 536 537 \
         542 543 552 553 559 562 569 576 577 583 585 587 602 618 619 628 636 637 640 642 643 653 \
         664 666 671 672 674 682 685 687 693",
    ),
    combinations: [
        138, 27, 126, 196, 208, 413, 198, 353, 411, 43, 19, 172, 123, 51, 77, 642, 834, 66, 41, 30, 137, 125, 136, 626,
        148, 640, 258, 293, 554, 745, 402, 184, 29, 18, 17, 113, 67, 89, 112, 401, 812, 162, 197, 90, 147, 307, 387,
        280, 544, 186, 52, 643, 15, 390, 42, 171, 4, 578, 99, 209, 306, 160, 327, 364, 161, 788, 602, 16, 547, 124,
        571, 328, 619, 259, 75, 279, 40, 530, 53, 603, 257, 533, 242, 5, 64, 102, 3, 267, 740, 185, 149, 375, 256, 482,
        173, 100, 423, 76, 65, 506,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let (y, hole_left) = (p.num("bar_height"), p.num("hole_left"));
    let hole_right = hole_left + 0.1;
    skip(hole_right >= 1.0)?;
    let ball = dynamic_body(Ball(0.1)).at_cx(SIZE / 2.0).at_bottom(SIZE * 0.8);
    let plug = dynamic_body(Ball(0.1 + 0.01)).at_bottom((y + p.num("ball_distance")) * SIZE);
    let plug = if p.flag("confounder") {
        plug.at_left((hole_left + 0.025) * SIZE)
    } else {
        plug.at_right((hole_right - 0.025) * SIZE)
    };
    let left = static_body(Bar(hole_left)).at_left(0.0).at_bottom(SIZE * y);
    let right = static_body(Bar(1.0 - hole_right)).at_right(SIZE).at_bottom(SIZE * y);
    skip(ball.left() >= left.right() && ball.right() <= right.left())?;
    skip(plug.top() >= ball.bottom())?;
    let floor = static_body(Bar(1.0)).at_left(0.0).at_bottom(0.0);
    Some(scene([ball.object(), plug, left, right, floor.goal()]))
}

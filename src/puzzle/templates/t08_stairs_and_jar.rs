//! 00008 Stairs and Jar.

use super::{Ints, Lin, Params, Template, Words, skip, task_numbers};
use crate::puzzle::layout::{Ball, Bar, Jar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 8,
    name: "Stairs and Jar",
    story: "Tilted steps lead down to the right; guide the ball into the guarded jar below one of them.",
    grid: &[
        ("align", Words(&["left", "right"])),
        ("ball_scale", Lin(0.05, 0.1, 1)),
        ("ball_x", Lin(0.1, 0.9, 10)),
        ("jar_scale", Lin(0.3, 0.4, 2)),
        ("target_index", Ints(1, 4)),
        ("y_span", Lin(0.4, 0.6, 10)),
    ],
    script,
    task_numbers: task_numbers(
        "29 59 62 70 73 75 82 97 118 120 132 144 169 177 197 200 203 206 208 213 218 222 256-258 \
         263 270 271 273 276-278 288 293 313 318 326 329 335 342 343 355 388 389 398 399 408 411 \
         413 415 432 439 442 445 457 460 462 466 472 475 482 483 485 487 488 492 494 497 499 503 \
         510 511 519 522 525 527 532 533 537 540 553 559 563 566 570 571 575 577 586 588 589 601 \
         603 604 607 610 611 618 619 627",
    ),
    combinations: [
        1388, 801, 251, 1221, 1100, 880, 883, 1155, 1067, 320, 1386, 1222, 1066, 1152, 258, 1591, 1078, 1068, 293,
        1153, 322, 1557, 1063, 882, 250, 783, 886, 1074, 781, 782, 497, 881, 800, 887, 1251, 1423, 325, 1146, 263, 268,
        7, 851, 1113, 291, 42, 1147, 326, 4, 440, 780, 853, 1555, 1253, 496, 327, 323, 1590, 383, 442, 253, 1227, 1,
        254, 1102, 1101, 2, 1214, 8, 321, 328, 0, 418, 40, 703, 1592, 345, 257, 1398, 588, 804, 1156, 5, 700, 1154,
        1228, 1511, 3, 267, 1151, 613, 324, 256, 612, 1210, 422, 290, 1273, 423, 666, 255,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let step = |i: usize| {
        let i = i as f64;
        let top = 0.8 * SIZE - i / 5.0 * p.num("y_span") * SIZE;
        // Rotated about its middle after placement.
        static_body(Bar(0.7 / 5.0)).at_top(top).at_left(i / 5.0 * SIZE).rotated(-5.0)
    };
    let jar = static_body(Jar(p.num("jar_scale"))).at_bottom(0.0);
    skip(jar.top() > step(4).bottom())?;
    let above = step(p.int("target_index"));
    let jar = if p.word("align") == "left" { jar.at_left(above.left()) } else { jar.at_right(above.right()) };
    let guard = || static_body(Bar(p.num("jar_scale"))).rotated(90.0);
    let left_guard = guard().at_right(jar.left()).at_bottom(0.0);
    let right_guard = guard().at_left(jar.right()).at_bottom(0.0);
    skip(right_guard.right() > SIZE)?;
    let ball = dynamic_body(Ball(p.num("ball_scale"))).at_top(SIZE).at_cx(SIZE * p.num("ball_x"));
    skip(ball.left() > jar.right())?;
    Some(scene((0..5).map(step).chain([jar.goal(), left_guard, right_guard, ball.object()])))
}

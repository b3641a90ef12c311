//! 00008 Stairs and Jar.

use super::{Ints, Lin, Params, Template, Words, kept, skip};
use crate::puzzle::layout::{Ball, Bar, Jar, dynamic, fixed, scene};
use crate::puzzle::scene::{SIZE, Scene};

pub static TEMPLATE: Template = Template {
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
    selected: kept(
        "29 59 62 70 73 75 82 97 118 120 132 144 169 177 197 200 203 206 208 213 218 222 256-258 \
         263 270 271 273 276-278 288 293 313 318 326 329 335 342 343 355 388 389 398 399 408 411 \
         413 415 432 439 442 445 457 460 462 466 472 475 482 483 485 487 488 492 494 497 499 503 \
         510 511 519 522 525 527 532 533 537 540 553 559 563 566 570 571 575 577 586 588 589 601 \
         603 604 607 610 611 618 619 627",
    ),
};

fn script(p: &Params) -> Option<Scene> {
    let step = |i: usize| {
        let i = i as f64;
        let top = 0.8 * SIZE - i / 5.0 * p.num("y_span") * SIZE;
        // Tilted after it was placed, about its middle.
        fixed(Bar(0.7 / 5.0)).at_top(top).at_left(i / 5.0 * SIZE).turned(-5.0)
    };
    let jar = fixed(Jar(p.num("jar_scale"))).at_bottom(0.0);
    skip(jar.top() > step(4).bottom())?;
    let above = step(p.int("target_index"));
    let jar = if p.word("align") == "left" { jar.at_left(above.left()) } else { jar.at_right(above.right()) };
    let guard = || fixed(Bar(p.num("jar_scale"))).turned(90.0);
    let left_guard = guard().at_right(jar.left()).at_bottom(0.0);
    let right_guard = guard().at_left(jar.right()).at_bottom(0.0);
    skip(right_guard.right() > SIZE)?;
    let ball = dynamic(Ball(p.num("ball_scale"))).at_top(SIZE).at_cx(SIZE * p.num("ball_x"));
    skip(ball.left() > jar.right())?;
    Some(scene((0..5).map(step).chain([jar.goal(), left_guard, right_guard, ball.object()])))
}

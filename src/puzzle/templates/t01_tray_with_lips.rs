//! 00001 Tray with Lips.

use super::{Flag, Lin, Params, Template, kept, skip};
use crate::puzzle::layout::{Ball, Bar, dynamic, fixed, scene};
use crate::puzzle::scene::{SIZE, Scene};

pub static TEMPLATE: Template = Template {
    number: 1,
    name: "Tray with Lips",
    story: "A ball drops onto a shelf with flared ends; get it over the lip and against the tall strip at the wall.",
    grid: &[
        ("ball_r", Lin(0.05, 0.12, 5)),
        ("ball_x", Lin(0.1, 0.9, 32)),
        ("ball_y", Lin(0.0, 40.0, 8)),
        ("left", Flag),
    ],
    script,
    selected: kept("0-99"),
};

fn script(p: &Params) -> Option<Scene> {
    let r = p.num("ball_r");
    let strip = fixed(Bar(1.0)).turned(90.0).at_bottom(0.0);
    let strip = if p.flag("left") { strip.at_left(0.0) } else { strip.at_right(SIZE) };
    let shelf = fixed(Bar(0.99 - 2.0 * r)).at_top(20.0).at_cx(SIZE / 2.0);
    let left_lip = fixed(Bar(0.2)).turned(65.0).at_right(shelf.left() + 5.0).at_top(shelf.top());
    let right_lip = fixed(Bar(0.2)).turned(-65.0).at_left(shelf.right() - 5.0).at_top(shelf.top());
    let ball = dynamic(Ball(r)).at_left(SIZE * p.num("ball_x")).at_bottom(p.num("ball_y") + shelf.top());
    skip(ball.cx() <= shelf.left() || ball.cx() >= shelf.right())?;
    skip((ball.cx() - strip.cx()).abs() > SIZE * 0.7)?;
    Some(scene([strip.goal(), shelf, left_lip, right_lip, ball.object()]))
}

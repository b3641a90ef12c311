//! 00001 Tray with Lips.

use super::{Flag, Lin, Params, Template, skip, task_numbers};
use crate::puzzle::layout::{Ball, Bar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
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
    task_numbers: task_numbers("0-99"),
    combinations: [
        363, 168, 2184, 610, 1164, 381, 236, 348, 833, 138, 899, 1195, 2213, 1283, 433, 2491, 1457, 1700, 1329, 2226,
        550, 2419, 1024, 2262, 2176, 1467, 134, 245, 841, 2215, 1707, 2327, 195, 461, 252, 339, 2223, 933, 180, 2311,
        2259, 1911, 367, 2048, 629, 1792, 1338, 1799, 744, 1895, 2212, 1909, 221, 269, 2389, 158, 126, 1997, 1830, 762,
        580, 1844, 2205, 310, 60, 1795, 2273, 594, 1632, 163, 249, 889, 689, 713, 2072, 278, 119, 1289, 723, 196, 590,
        682, 1677, 208, 1925, 1811, 1149, 1863, 144, 1173, 1455, 2371, 2190, 191, 2351, 349, 1158, 1388, 369, 1503,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let r = p.num("ball_r");
    let strip = static_body(Bar(1.0)).rotated(90.0).at_bottom(0.0);
    let strip = if p.flag("left") { strip.at_left(0.0) } else { strip.at_right(SIZE) };
    let shelf = static_body(Bar(0.99 - 2.0 * r)).at_top(20.0).at_cx(SIZE / 2.0);
    let left_lip = static_body(Bar(0.2)).rotated(65.0).at_right(shelf.left() + 5.0).at_top(shelf.top());
    let right_lip = static_body(Bar(0.2)).rotated(-65.0).at_left(shelf.right() - 5.0).at_top(shelf.top());
    let ball = dynamic_body(Ball(r)).at_left(SIZE * p.num("ball_x")).at_bottom(p.num("ball_y") + shelf.top());
    skip(ball.cx() <= shelf.left() || ball.cx() >= shelf.right())?;
    skip((ball.cx() - strip.cx()).abs() > SIZE * 0.7)?;
    Some(scene([strip.goal(), shelf, left_lip, right_lip, ball.object()]))
}

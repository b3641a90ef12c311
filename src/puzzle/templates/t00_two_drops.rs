//! 00000 Two Drops.

use super::{Lin, Params, Template, kept, skip};
use crate::puzzle::layout::{Ball, dynamic, scene};
use crate::puzzle::scene::{SIZE, Scene};

pub static TEMPLATE: Template = Template {
    number: 0,
    name: "Two Drops",
    story: "Two balls fall side by side from the same height; bring them together.",
    grid: &[
        ("ball1_r", Lin(0.06, 0.12, 3)),
        ("ball1_x", Lin(0.05, 0.95, 19)),
        ("ball2_r", Lin(0.06, 0.12, 3)),
        ("ball2_x", Lin(0.05, 0.95, 19)),
        ("height", Lin(0.2, 0.8, 5)),
    ],
    script,
    selected: kept("0-99"),
};

fn script(p: &Params) -> Option<Scene> {
    let (r1, r2) = (p.num("ball1_r"), p.num("ball2_r"));
    skip(p.num("ball2_x") <= p.num("ball1_x"))?;
    let bottom = SIZE * p.num("height");
    let left = dynamic(Ball(r1)).at_cx(SIZE * p.num("ball1_x")).at_bottom(bottom);
    let right = dynamic(Ball(r2)).at_cx(SIZE * p.num("ball2_x")).at_bottom(bottom);
    skip(right.left() - left.right() < SIZE * r1.max(r2))?;
    skip(left.left() <= 0.0 || right.right() >= 255.0)?;
    Some(scene([left.object(), right.goal()]))
}

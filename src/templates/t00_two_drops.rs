//! 00000 Two Drops.

use super::{Grid::Lin, Params, Template};
use crate::layout::{Goal, Layout, ball, dynamic};
use crate::scene::SIZE;

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
    selected: [
        0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29,
        30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57,
        58, 59, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83, 84, 85,
        86, 87, 88, 89, 90, 91, 92, 93, 94, 95, 96, 97, 98, 99,
    ],
};

fn script(p: &Params, s: &mut Layout) -> Option<Goal> {
    let (r1, r2) = (p.num("ball1_r"), p.num("ball2_r"));
    if p.num("ball2_x") <= p.num("ball1_x") {
        return None;
    }
    let bottom = SIZE * p.num("height");
    let a = s.add(dynamic(ball(r1)).at_cx(SIZE * p.num("ball1_x")).at_bottom(bottom));
    let b = s.add(dynamic(ball(r2)).at_cx(SIZE * p.num("ball2_x")).at_bottom(bottom));
    if s[b].left() - s[a].right() < SIZE * r1.max(r2) || s[a].left() <= 0.0 || s[b].right() >= 255.0 {
        return None;
    }
    Some(Goal { object: a, target: b })
}

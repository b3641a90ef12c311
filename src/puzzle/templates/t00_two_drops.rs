//! 00000 Two Drops.

use super::{Lin, Params, Template, skip, task_numbers};
use crate::puzzle::layout::{Ball, dynamic_body, scene};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
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
    task_numbers: task_numbers("0-99"),
    combinations: [
        1970, 11205, 363, 12223, 11860, 11348, 7024, 168, 2081, 13013, 6449, 6918, 2184, 610, 12039, 12498, 12221,
        5959, 236, 6401, 348, 833, 138, 3509, 7374, 899, 1195, 2045, 1283, 433, 3125, 13762, 12514, 1700, 1329, 550,
        1024, 7779, 6627, 6451, 2262, 2176, 1467, 5729, 6067, 890, 134, 245, 7762, 841, 4082, 27, 6218, 11737, 13006,
        2751, 8721, 11633, 6514, 5584, 461, 13104, 13101, 6991, 63, 5484, 3035, 12613, 252, 11265, 1019, 2454, 1089,
        6121, 339, 3228, 12324, 933, 2754, 180, 5675, 7758, 13665, 5668, 11544, 2259, 7674, 13568, 6709, 595, 367,
        14046, 2048, 629, 1792, 1799, 744, 9304, 5880, 1895,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let (r1, r2) = (p.num("ball1_r"), p.num("ball2_r"));
    skip(p.num("ball2_x") <= p.num("ball1_x"))?;
    let bottom = SIZE * p.num("height");
    let left = dynamic_body(Ball(r1)).at_cx(SIZE * p.num("ball1_x")).at_bottom(bottom);
    let right = dynamic_body(Ball(r2)).at_cx(SIZE * p.num("ball2_x")).at_bottom(bottom);
    skip(right.left() - left.right() < SIZE * r1.max(r2))?;
    skip(left.left() <= 0.0 || right.right() >= 255.0)?;
    Some(scene([left.object(), right.goal()]))
}

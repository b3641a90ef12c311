//! 00003 Topple to the Wall.

use super::{Lin, Params, Template, skip, task_numbers};
use crate::puzzle::layout::{Bar, Jar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 3,
    name: "Topple to the Wall",
    story: "A pole stands upright in a small jar; knock it against the strip on the nearer side wall.",
    grid: &[("bar_scale", Lin(0.2, 0.5, 4)), ("jar_x", Lin(0.05, 0.95, 20)), ("jitter_x", Lin(-2.0, 2.0, 5))],
    script,
    task_numbers: task_numbers("0-11 13-15 17-23 25-28 30 31 33-35 37 38 40-44 46 47 49-59 61-65 67-69 71-111"),
    combinations: [
        363, 168, 381, 236, 348, 138, 134, 245, 27, 252, 339, 180, 384, 221, 269, 126, 310, 163, 249, 278, 119, 208,
        191, 349, 369, 285, 283, 223, 353, 346, 224, 376, 170, 212, 313, 6, 286, 292, 251, 131, 19, 24, 172, 123, 277,
        372, 109, 234, 77, 394, 88, 115, 334, 333, 187, 320, 72, 240, 28, 337, 78, 169, 262, 352, 23, 176, 246, 270,
        386, 137, 343, 215, 21, 247, 341, 125, 85, 316, 340, 371, 136, 318, 81, 9, 216, 284, 273, 288, 305, 121, 182,
        26, 382, 258, 361, 237, 293, 91, 239, 322,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let jar = dynamic_body(Jar(0.1)).at_bottom(0.0).at_cx(SIZE * p.num("jar_x"));
    let pole = dynamic_body(Bar(p.num("bar_scale"))).rotated(90.0).at_bottom(4.0).at_cx(jar.cx() + p.num("jitter_x"));
    skip(jar.left() <= pole.width() || jar.right() >= 255.0 - pole.width())?;
    let max_distance = pole.height() + 40.0;
    let near_left = max_distance > pole.left();
    let near_right = max_distance > SIZE - pole.right();
    skip(!near_left && !near_right)?;
    let strip = static_body(Bar(1.0)).rotated(90.0).at_bottom(0.0);
    let strip = if near_left { strip.at_left(0.0) } else { strip.at_right(SIZE) };
    Some(scene([jar, pole.object(), strip.goal()]))
}

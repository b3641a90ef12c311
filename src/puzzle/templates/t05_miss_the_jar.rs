//! 00005 Miss the Jar.

use super::{Mul, Params, Template, skip, task_numbers};
use crate::puzzle::layout::{Ball, Bar, Jar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 5,
    name: "Miss the Jar",
    story: "A ball hangs right over a jar; make it land on the floor instead.",
    grid: &[
        ("ball_y", Mul(0.1, 7, 9)),
        ("jar_scale", Mul(0.05, 3, 8)),
        ("jar_x", Mul(0.1, 2, 7)),
        ("jar_y", Mul(0.1, 0, 2)),
    ],
    script,
    task_numbers: task_numbers(
        "6 14 18 20-22 24-26 29 30 34-39 43 54 58-61 63 66 68 71-74 76-78 80-82 86 89-92 94-97 \
         100 102 104 108 109 111 112 114-116 121 123 128 130 131 133 135 136 138 141 142 144 145 \
         149-151 153 154 156 160 162 164-169 171 173-178 180 181 183 184 186 187 191 192 196 197 \
         199",
    ),
    combinations: [
        195, 310, 278, 196, 208, 59, 191, 285, 198, 223, 303, 170, 69, 212, 313, 6, 286, 36, 96, 51, 234, 77, 88, 145,
        320, 72, 41, 30, 301, 78, 200, 262, 23, 304, 176, 101, 21, 85, 316, 136, 318, 62, 9, 216, 284, 288, 305, 182,
        293, 91, 302, 235, 167, 192, 317, 32, 217, 47, 84, 103, 207, 157, 45, 184, 210, 18, 17, 57, 201, 314, 89, 272,
        70, 206, 61, 95, 162, 289, 199, 202, 197, 90, 319, 25, 307, 268, 7, 179, 178, 287, 244, 92, 86, 312, 177, 93,
        20, 15, 291, 188,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let floor = static_body(Bar(1.0)).at_bottom(0.0).at_left(0.0);
    let jar = dynamic_body(Jar(p.num("jar_scale")))
        .at_left(SIZE * p.num("jar_x"))
        .at_bottom(floor.top() + SIZE * p.num("jar_y"));
    skip(jar.left() < 0.0 || jar.right() > SIZE)?;
    let ball = dynamic_body(Ball(0.1)).at_bottom(SIZE * p.num("ball_y")).at_cx(jar.left() + jar.width() / 2.0);
    Some(scene([floor.goal(), jar, ball.object()]))
}

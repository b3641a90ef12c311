//! 00005 Miss the Jar.

use super::{Mul, Params, Template, kept, skip};
use crate::puzzle::layout::{Ball, Bar, Jar, dynamic, fixed, scene};
use crate::puzzle::scene::{SIZE, Scene};

pub static TEMPLATE: Template = Template {
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
    selected: kept(
        "6 14 18 20-22 24-26 29 30 34-39 43 54 58-61 63 66 68 71-74 76-78 80-82 86 89-92 94-97 \
         100 102 104 108 109 111 112 114-116 121 123 128 130 131 133 135 136 138 141 142 144 145 \
         149-151 153 154 156 160 162 164-169 171 173-178 180 181 183 184 186 187 191 192 196 197 \
         199",
    ),
};

fn script(p: &Params) -> Option<Scene> {
    let floor = fixed(Bar(1.0)).at_bottom(0.0).at_left(0.0);
    let jar =
        dynamic(Jar(p.num("jar_scale"))).at_left(SIZE * p.num("jar_x")).at_bottom(floor.top() + SIZE * p.num("jar_y"));
    skip(jar.left() < 0.0 || jar.right() > SIZE)?;
    let ball = dynamic(Ball(0.1)).at_bottom(SIZE * p.num("ball_y")).at_cx(jar.left() + jar.width() / 2.0);
    Some(scene([floor.goal(), jar, ball.object()]))
}

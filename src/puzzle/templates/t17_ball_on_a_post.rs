//! 00017 Ball on a Post.

use super::{Lin, Params, Template, kept};
use crate::puzzle::layout::{Ball, Bar, dynamic, fixed, scene};
use crate::puzzle::scene::{SIZE, Scene};

pub static TEMPLATE: Template = Template {
    number: 17,
    name: "Ball on a Post",
    story: "A ball is balanced on an upright pole right below a ceiling; tip it down to the floor.",
    grid: &[
        ("ball_size", Lin(0.05, 0.25, 5)),
        ("bar_height", Lin(0.2, 0.5, 5)),
        ("bar_x", Lin(0.2, 0.8, 5)),
        ("ramp_size", Lin(0.05, 0.2, 5)),
    ],
    script,
    selected: kept(
        "2 5 7 13 19-21 26 27 29-31 38 43 44 46 47 53 55 58 60 61 64 65 68-70 72-74 76 77 81 85 \
         87 88 94 96 98-103 105 106 110 116 121 123-125 128 129 137-142 145-147 149-155 157 159 \
         161-169 172-179 182 183 186 190-194 197-199",
    ),
};

fn script(p: &Params) -> Option<Scene> {
    let floor = fixed(Bar(1.0)).at_left(0.0).at_bottom(0.0);
    let pole = dynamic(Bar(p.num("bar_height"))).turned(90.0).at_bottom(floor.top()).at_cx(SIZE * p.num("bar_x"));
    let ball = dynamic(Ball(p.num("ball_size"))).at_bottom(pole.top()).at_cx(pole.cx());
    let ceiling = fixed(Bar(1.0)).at_left(0.0).at_bottom(ball.top() + 0.01 * SIZE);
    let ramp = |degrees: f64| fixed(Bar(p.num("ramp_size"))).turned(degrees).at_bottom(floor.top());
    let (left_ramp, right_ramp) = (ramp(315.0).at_left(0.0), ramp(45.0).at_right(SIZE));
    Some(scene([floor.goal(), pole, ball.object(), ceiling, left_ramp, right_ramp]))
}

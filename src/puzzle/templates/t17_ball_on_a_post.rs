//! 00017 Ball on a Post.

use super::{Lin, Params, Template, task_numbers};
use crate::puzzle::layout::{Ball, Bar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
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
    task_numbers: task_numbers(
        "2 5 7 13 19-21 26 27 29-31 38 43 44 46 47 53 55 58 60 61 64 65 68-70 72-74 76 77 81 85 \
         87 88 94 96 98-103 105 106 110 116 121 123-125 128 129 137-142 145-147 149-155 157 159 \
         161-169 172-179 182 183 186 190-194 197-199",
    ),
    combinations: [
        610, 348, 433, 461, 367, 384, 498, 580, 310, 521, 594, 163, 597, 349, 369, 413, 285, 512, 556, 353, 443, 346,
        376, 170, 395, 313, 441, 438, 6, 286, 292, 564, 427, 446, 558, 494, 172, 473, 485, 436, 432, 372, 456, 579,
        474, 470, 204, 532, 515, 507, 334, 493, 187, 320, 599, 591, 301, 495, 399, 337, 200, 262, 352, 152, 304, 529,
        622, 517, 508, 176, 246, 386, 559, 343, 215, 21, 424, 247, 499, 513, 341, 316, 340, 417, 371, 463, 457, 136,
        415, 606, 62, 582, 624, 288, 295, 305, 453, 562, 26, 404,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let floor = static_body(Bar(1.0)).at_left(0.0).at_bottom(0.0);
    let pole = dynamic_body(Bar(p.num("bar_height"))).rotated(90.0).at_bottom(floor.top()).at_cx(SIZE * p.num("bar_x"));
    let ball = dynamic_body(Ball(p.num("ball_size"))).at_bottom(pole.top()).at_cx(pole.cx());
    let ceiling = static_body(Bar(1.0)).at_left(0.0).at_bottom(ball.top() + 0.01 * SIZE);
    let ramp = |degrees: f64| static_body(Bar(p.num("ramp_size"))).rotated(degrees).at_bottom(floor.top());
    let (left_ramp, right_ramp) = (ramp(315.0).at_left(0.0), ramp(45.0).at_right(SIZE));
    Some(scene([floor.goal(), pole, ball.object(), ceiling, left_ramp, right_ramp]))
}

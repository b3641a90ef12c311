//! 00021 Teeter Gap.

use super::{Lin, Params, Template, skip, task_numbers};
use crate::puzzle::dimensions::radians;
use crate::puzzle::layout::{Ball, Bar, Jar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 21,
    name: "Teeter Gap",
    story: "A ball rolls from a ramp over a plank on two round supports; get it across to the fixed jar.",
    grid: &[
        ("angle", Lin(10.0, 20.0, 3)),
        ("h0", Lin(0.2, 0.5, 15)),
        ("w1", Lin(0.1, 0.2, 3)),
        ("w2", Lin(0.15, 0.3, 3)),
    ],
    script,
    task_numbers: task_numbers(
        "2 4 5 7-10 12 15 18 21 23 24 26-29 31-33 36-38 40 41 43 44 46-48 50-57 59-63 65-90 \
         93-107 110-125",
    ),
    combinations: [
        138, 63, 252, 126, 163, 208, 144, 198, 19, 298, 334, 66, 72, 30, 399, 262, 352, 270, 343, 21, 81, 9, 216, 361,
        237, 235, 342, 118, 217, 48, 84, 111, 207, 282, 45, 210, 18, 57, 201, 135, 162, 199, 90, 378, 147, 354, 307,
        387, 244, 300, 165, 82, 93, 291, 226, 297, 390, 379, 189, 108, 171, 37, 54, 99, 315, 261, 306, 153, 55, 219,
        12, 253, 243, 183, 0, 190, 75, 225, 129, 73, 279, 39, 264, 370, 388, 120, 397, 360, 64, 117, 127, 102, 3, 309,
        351, 324, 100, 396, 181, 255,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let (angle, w1, w2) = (p.num("angle"), p.num("w1"), p.num("w2"));
    let eps = 0.005 * SIZE;
    let ramp = || static_body(Bar(w1 / libm::cos(radians(angle)))).rotated(360.0 - angle);
    let first = ramp().at_left(0.0).at_bottom(SIZE * p.num("h0"));
    let plank = dynamic_body(Bar(w2)).at_left(first.right() + eps).at_bottom(first.bottom());
    let left_support = static_body(Ball(0.05)).at_top(plank.bottom()).at_cx(plank.cx());
    let right_support = static_body(Ball(0.05)).at_right(plank.right()).at_top(plank.bottom());
    let base = static_body(Bar(w2)).at_left(plank.left()).at_top(left_support.bottom());
    let second = ramp().at_left(plank.right() + eps).at_top(plank.top());
    let jar = static_body(Jar(w2)).at_left(second.right() + eps).at_top(second.bottom());
    let third = ramp().at_left(jar.right() + eps).at_top(jar.top());
    let rest = 1.0 - w1 - w2 - w1 - w2 - w1 - 5.0 * eps / SIZE;
    skip(rest < 0.2)?;
    let exit = static_body(Bar(rest)).at_left(third.right() + eps).at_bottom(third.bottom());
    let ball = dynamic_body(Ball(0.05)).at_left(0.0).at_bottom(first.top());
    let ceiling = static_body(Bar(1.0)).at_left(0.0).at_top(ball.top() + 0.1 * SIZE);
    skip(ceiling.top() > SIZE || exit.bottom() < 0.0 || jar.bottom() < 0.0)?;
    let path = [first, plank, left_support, right_support, base, second, jar.goal(), third, exit];
    Some(scene(path.into_iter().chain([ball.object(), ceiling])))
}

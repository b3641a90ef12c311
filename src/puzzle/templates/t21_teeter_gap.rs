//! 00021 Teeter Gap.

use super::{Lin, Params, Template, kept, skip};
use crate::puzzle::layout::{Ball, Bar, Jar, dynamic, fixed, radians, scene};
use crate::puzzle::scene::{SIZE, Scene};

pub static TEMPLATE: Template = Template {
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
    selected: kept(
        "2 4 5 7-10 12 15 18 21 23 24 26-29 31-33 36-38 40 41 43 44 46-48 50-57 59-63 65-90 \
         93-107 110-125",
    ),
};

fn script(p: &Params) -> Option<Scene> {
    let (angle, w1, w2) = (p.num("angle"), p.num("w1"), p.num("w2"));
    let eps = 0.005 * SIZE;
    let ramp = || fixed(Bar(w1 / libm::cos(radians(angle)))).turned(360.0 - angle);
    let first = ramp().at_left(0.0).at_bottom(SIZE * p.num("h0"));
    let plank = dynamic(Bar(w2)).at_left(first.right() + eps).at_bottom(first.bottom());
    let left_support = fixed(Ball(0.05)).at_top(plank.bottom()).at_cx(plank.cx());
    let right_support = fixed(Ball(0.05)).at_right(plank.right()).at_top(plank.bottom());
    let base = fixed(Bar(w2)).at_left(plank.left()).at_top(left_support.bottom());
    let second = ramp().at_left(plank.right() + eps).at_top(plank.top());
    let jar = fixed(Jar(w2)).at_left(second.right() + eps).at_top(second.bottom());
    let third = ramp().at_left(jar.right() + eps).at_top(jar.top());
    let rest = 1.0 - w1 - w2 - w1 - w2 - w1 - 5.0 * eps / SIZE;
    skip(rest < 0.2)?;
    let exit = fixed(Bar(rest)).at_left(third.right() + eps).at_bottom(third.bottom());
    let ball = dynamic(Ball(0.05)).at_left(0.0).at_bottom(first.top());
    let ceiling = fixed(Bar(1.0)).at_left(0.0).at_top(ball.top() + 0.1 * SIZE);
    skip(ceiling.top() > SIZE || exit.bottom() < 0.0 || jar.bottom() < 0.0)?;
    let path = [first, plank, left_support, right_support, base, second, jar.goal(), third, exit];
    Some(scene(path.into_iter().chain([ball.object(), ceiling])))
}

//! 00002 Awning.

use super::{Mul, Params, Template, kept, skip};
use crate::puzzle::layout::{Ball, Bar, dynamic, fixed, scene};
use crate::puzzle::scene::{SIZE, Scene};

pub static TEMPLATE: Template = Template {
    number: 2,
    name: "Awning",
    story: "A ball drops onto the middle of a ledge; make it reach the floor instead of resting there.",
    grid: &[("obstacle_width", Mul(0.1, 1, 7)), ("obstacle_x", Mul(0.1, 0, 10)), ("obstacle_y", Mul(0.1, 3, 7))],
    script,
    selected: kept(
        "7 11 15 17 23 26 28 29 31 41 44-47 50 52 55 59 63 64 66 68-70 78-80 82 85 86 89 92 93 \
         96-105 109-111 113 115 119-121 123 126 129 130 134 135 137-140 144 146 148 149 152 153 \
         160-162 164-166 168-172 174-182 185-187 189-197 199",
    ),
};

fn script(p: &Params) -> Option<Scene> {
    let (x, width) = (p.num("obstacle_x"), p.num("obstacle_width"));
    skip(x + width > 1.0)?;
    let ledge = fixed(Bar(width)).at_left(SIZE * x).at_bottom(SIZE * p.num("obstacle_y"));
    let ball = dynamic(Ball(0.1)).at_cx(SIZE * x + ledge.width() / 2.0).at_bottom(SIZE * 0.9);
    let floor = fixed(Bar(1.0)).at_bottom(0.0).at_left(0.0);
    Some(scene([ledge, ball.object(), floor.goal()]))
}

//! 00002 Awning.

use super::{Mul, Params, Template, skip, task_numbers};
use crate::puzzle::layout::{Ball, Bar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 2,
    name: "Awning",
    story: "A ball drops onto the middle of a ledge; make it reach the floor instead of resting there.",
    grid: &[("obstacle_width", Mul(0.1, 1, 7)), ("obstacle_x", Mul(0.1, 0, 10)), ("obstacle_y", Mul(0.1, 3, 7))],
    script,
    task_numbers: task_numbers(
        "7 11 15 17 23 26 28 29 31 41 44-47 50 52 55 59 63 64 66 68-70 78-80 82 85 86 89 92 93 \
         96-105 109-111 113 115 119-121 123 126 129 130 134 135 137-140 144 146 148 149 152 153 \
         160-162 164-166 168-172 174-182 185-187 189-197 199",
    ),
    combinations: [
        195, 221, 278, 196, 198, 223, 346, 224, 69, 24, 277, 96, 298, 234, 145, 334, 66, 41, 169, 23, 246, 343, 21,
        247, 9, 284, 148, 295, 26, 237, 239, 342, 167, 110, 114, 248, 32, 275, 48, 11, 132, 58, 47, 111, 282, 45, 331,
        29, 57, 113, 67, 89, 166, 112, 95, 199, 197, 147, 25, 7, 179, 244, 92, 177, 165, 93, 20, 56, 133, 297, 42, 189,
        68, 38, 194, 37, 146, 4, 14, 238, 99, 74, 344, 55, 22, 222, 193, 332, 31, 12, 1, 13, 347, 16, 87, 2, 124, 8,
        243, 0,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let (x, width) = (p.num("obstacle_x"), p.num("obstacle_width"));
    skip(x + width > 1.0)?;
    let ledge = static_body(Bar(width)).at_left(SIZE * x).at_bottom(SIZE * p.num("obstacle_y"));
    let ball = dynamic_body(Ball(0.1)).at_cx(SIZE * x + ledge.width() / 2.0).at_bottom(SIZE * 0.9);
    let floor = static_body(Bar(1.0)).at_bottom(0.0).at_left(0.0);
    Some(scene([ledge, ball.object(), floor.goal()]))
}

//! 00020 Louvers.

use super::{Ints, Lin, Params, Template, skip, task_numbers};
use crate::puzzle::layout::{Ball, Bar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 20,
    name: "Louvers",
    story: "A ball falls down the slot between a stack of louvers and a split wall; get it to the floor behind the wall.",
    grid: &[
        ("angle", Lin(10.0, 45.0, 5)),
        ("bar_y", Ints(0, 9)),
        ("distance_to_wall", Lin(0.01, 0.05, 2)),
        ("vbar_x_scale", Lin(0.5, 0.6, 4)),
    ],
    script,
    task_numbers: task_numbers("0-99"),
    combinations: [
        363, 168, 348, 27, 195, 252, 339, 180, 367, 269, 126, 249, 278, 119, 196, 191, 349, 285, 198, 283, 353, 346,
        170, 286, 43, 33, 36, 251, 35, 19, 24, 172, 123, 277, 96, 109, 204, 88, 115, 334, 333, 187, 28, 41, 30, 337,
        169, 200, 262, 352, 23, 176, 101, 270, 343, 21, 341, 125, 340, 9, 284, 273, 121, 182, 26, 258, 361, 91, 342,
        192, 118, 366, 110, 114, 248, 32, 275, 11, 105, 47, 336, 103, 111, 207, 282, 356, 45, 250, 184, 331, 29, 18,
        329, 17, 113, 201, 89, 272, 206, 271,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let (wall_x, distance) = (SIZE * p.num("vbar_x_scale"), p.num("distance_to_wall"));
    let ball = dynamic_body(Ball(0.08)).at_right(wall_x - 1.0).at_bottom(SIZE * 0.9);
    let slats_right = ball.left() - 2.0 - SIZE * distance;
    let slat = |i: usize| {
        let bottom = i as f64 * 0.15 * SIZE;
        static_body(Bar(0.3)).rotated(-p.num("angle")).at_right(slats_right).at_bottom(bottom)
    };
    let ball = ball.at_left(slat(1).right() + 1.0);
    // The hole in the wall ends at the foot of one of the slats above the lowest.
    let below = p.int("bar_y");
    skip(below >= 9)?;
    let hole_top = slat(below + 1).bottom() / SIZE - distance;
    skip(!(0.2 < hole_top && hole_top < 0.9))?;
    let upper_wall = static_body(Bar(1.0 - hole_top)).rotated(90.0).at_left(wall_x).at_top(SIZE);
    let lower_wall =
        static_body(Bar(hole_top - ball.width() / SIZE * 2.0)).rotated(90.0).at_left(wall_x).at_bottom(0.0);
    // PHYRE tests hole_top < 0.7. At `bar_y` 4 the two are equal and rounding could decide, so `bar_y` is compared.
    let other_y = if below <= 3 { 0.9 } else { 0.3 };
    let other = dynamic_body(Ball(0.1)).at_left(wall_x + 8.0).at_bottom(SIZE * other_y);
    let floor = static_body(Bar(1.0)).at_left(wall_x + 4.0).at_bottom(0.0);
    let behind = [upper_wall, lower_wall, other, floor.goal()];
    Some(scene([ball.object()].into_iter().chain((0..10).map(slat)).chain(behind)))
}

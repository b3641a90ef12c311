//! 00006 Jar through the Gap.

use super::{Lin, Params, Template, skip, task_numbers};
use crate::puzzle::layout::{Ball, Bar, Jar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 6,
    name: "Jar through the Gap",
    story: "An upturned jar falls through the gap in a floor; bring the ball that lies on that floor to it.",
    grid: &[("ball_left", Lin(0.2, 0.8, 20)), ("bar_height", Lin(0.3, 0.6, 16)), ("hole_left", Lin(0.2, 0.8, 20))],
    script,
    task_numbers: task_numbers(
        "3 4 7 10 16 26 28 33 38 43-47 52 55 56 60 62 64-66 71 87 88 90 92 94 96 98 101 103 106 \
         108 113 115 117-121 123-127 131-133 136-147 149 151-155 157 160 162-164 166-170 172-175 \
         179-184 186-192 194-199",
    ),
    combinations: [
        27, 1707, 5087, 126, 5067, 3526, 3626, 5407, 527, 1667, 6, 286, 5106, 6326, 427, 6267, 446, 4786, 5047, 3666,
        1807, 927, 3586, 507, 6247, 4966, 6147, 187, 66, 3786, 5007, 787, 246, 386, 1747, 1287, 6126, 6166, 4947, 4986,
        3966, 606, 626, 4086, 1407, 3706, 1587, 4386, 4106, 1507, 966, 4466, 1207, 26, 1187, 3987, 1387, 3926, 707,
        4926, 4927, 1727, 3986, 4906, 5747, 6227, 6287, 167, 6087, 1527, 3886, 3806, 366, 586, 786, 907, 3846, 6207,
        3566, 5746, 6167, 4166, 5346, 4006, 5387, 1127, 47, 4246, 6106, 207, 1366, 4387, 967, 1487, 1466, 807, 426,
        4727, 4447, 886,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    // Rotated about the middle of its base after alignment, so it extends downwards from there.
    let jar = dynamic_body(Jar(0.15)).at_cx(SIZE / 2.0).at_top(SIZE * 0.95).rotated(180.0);
    let (hole_left, hole_right) = (p.num("hole_left"), p.num("hole_left") + 0.2);
    let height = SIZE * p.num("bar_height");
    let left_floor = static_body(Bar(hole_left)).at_left(0.0).at_bottom(height);
    skip(hole_right >= 1.0)?;
    let right_floor = static_body(Bar(1.0 - hole_right)).at_right(SIZE).at_bottom(height);
    let ball = dynamic_body(Ball(0.1)).at_bottom(right_floor.top()).at_left(SIZE * p.num("ball_left"));
    skip(jar.left() < left_floor.right() || jar.right() > right_floor.left())?;
    skip(left_floor.right() < ball.cx() && ball.cx() < right_floor.left())?;
    let slope = static_body(Bar(2.0)).rotated(10.0).at_left(0.0).at_bottom(-2.0);
    Some(scene([jar.goal(), left_floor, right_floor, ball.object(), slope]))
}

//! 00022 Tip into the Jar.

use super::{Lin, Params, Template, skip, task_numbers};
use crate::puzzle::layout::{Ball, Bar, Jar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 22,
    name: "Tip into the Jar",
    story: "A ball lies on a small tilted plate; bring it to the ball in the jar below.",
    grid: &[
        ("angle", Lin(45.0, 60.0, 5)),
        ("ball_offset", Lin(5.0, 15.0, 2)),
        ("jar_position", Lin(0.4, 0.6, 10)),
        ("jar_scale", Lin(0.2, 0.3, 4)),
        ("obstacle_angle", Lin(-10.0, 10.0, 3)),
        ("radius", Lin(5.0, 12.0, 5)),
        ("shift_right", Lin(0.4, 0.6, 3)),
        ("x_offset", Lin(0.0, 0.1, 2)),
    ],
    script,
    task_numbers: task_numbers(
        "4 52 54 77 118 119 123 147 167 176 208 222 258 260 268 318 320 322 324 356 389 403 406 \
         410 414 421 430 436 437 439 447 484 492 507 510 518 528 537 549 559 578 588 604 620 628 \
         638 639 649 659 660 663 669 670 672 674 678 684 687 691 695 696 698 710 715 723 730 741 \
         746 751 755 763 780 783 792 796 807 809 823 824 842 849 850 871 875 882 892 895 897 903 \
         910 911 915 920 929 935 958 976 978 988 997",
    ),
    combinations: [
        25593, 16034, 33785, 22227, 21774, 30935, 19295, 138, 35080, 16901, 4745, 15701, 17003, 2951, 4843, 4872,
        19199, 4082, 7318, 11737, 6514, 13744, 12636, 24898, 22362, 35500, 15392, 24658, 20966, 5103, 5001, 17715,
        33561, 8586, 7052, 4463, 21642, 18753, 29700, 23367, 21644, 34007, 27161, 26876, 30376, 384, 13894, 6640, 9045,
        9073, 19405, 20417, 11642, 20055, 8885, 10498, 498, 12393, 11474, 4890, 23328, 26222, 31544, 158, 33449, 7675,
        26705, 11553, 10944, 126, 34158, 33804, 26534, 26934, 34050, 28191, 4091, 8805, 29212, 23366, 15584, 26157,
        594, 13856, 29901, 3659, 32630, 33645, 19734, 15427, 35402, 27369, 2072, 9586, 15036, 19392, 15279, 12397,
        20228, 10762,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let (angle, radius) = (p.num("angle"), p.num("radius"));
    let (jar_scale, offset) = (p.num("jar_scale"), p.num("x_offset"));
    let left = static_body(Bar(0.5)).rotated(-angle).at_right(0.2 * SIZE).at_bottom(0.0);
    let right = static_body(Bar(0.5)).rotated(angle).at_left(0.8 * SIZE).at_bottom(0.0);
    let jar = dynamic_body(Jar(jar_scale)).at_bottom(0.0).at_cx((p.num("jar_position") + offset) * SIZE);
    let plate = static_body(Bar(90.0 / SIZE))
        .rotated(p.num("obstacle_angle"))
        .at_bottom((0.3 * SIZE).max(jar.top() + 4.0 * radius))
        .at_cx((p.num("shift_right") + offset) * SIZE);
    skip(jar.right() > plate.right() + 10.0)?;
    let jar_ball = dynamic_body(Ball(0.05 + jar_scale / 5.0)).at_bottom(10.0).at_cx(jar.cx());
    let ball = dynamic_body(Ball(radius / SIZE * 2.0))
        .at_left(plate.left() + p.num("ball_offset"))
        .at_bottom(plate.top() + radius);
    Some(scene([left, right, jar, plate, jar_ball.goal(), ball.object()]))
}

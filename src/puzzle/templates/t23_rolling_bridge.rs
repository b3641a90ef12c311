//! 00023 Rolling Bridge.

use super::{Lin, Params, Template, skip, task_numbers};
use crate::puzzle::layout::{Ball, Bar, Jar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 23,
    name: "Rolling Bridge",
    story: "A plank with a small ball on its end lies on a big loose ball; get the small one to the ball in the far jar.",
    grid: &[
        ("jar_angle", Lin(-10.0, 10.0, 13)),
        ("jar_right", Lin(0.9, 0.98, 3)),
        ("jar_scale", Lin(0.15, 0.3, 3)),
        ("left_side", Lin(0.05, 0.2, 5)),
        ("step_base", Lin(0.01, 0.1, 2)),
        ("step_diff", Lin(-0.3, 0.3, 10)),
    ],
    script,
    task_numbers: task_numbers(
        "8 17 31 64 111 112 134 153 202 223 233 240 241 245 261 269 310 316 320 377 385 402 428 \
         438 441 470 471 490 493 506 507 513 522 523 534 535 538 543 566 584 614 625 636 644 655 \
         666 680 689 704 728 736 740 745 751 754 757 767 771 778 797 800 801 812 817-821 829 839 \
         848 850 857 859 873 875 878 879 883 884 898 899 901 913 918 925 926 930 936 946 948 950 \
         952 957 959 960 963 972 974 990",
    ),
    combinations: [
        9491, 6449, 10546, 6451, 8590, 1950, 4961, 10951, 4091, 249, 119, 4640, 8743, 4030, 7070, 3761, 191, 9192,
        10981, 4330, 8454, 7554, 6663, 2281, 7050, 1641, 2462, 9945, 2290, 6730, 10515, 4960, 5218, 6782, 2219, 9317,
        11172, 2210, 9393, 1670, 7682, 441, 10971, 6190, 7149, 6118, 2580, 5763, 5707, 10006, 10215, 2242, 9460, 3062,
        8309, 7380, 9450, 8270, 9982, 5541, 7080, 6916, 3107, 4215, 11462, 11561, 8840, 154, 7040, 1010, 4845, 7362,
        1319, 10882, 4342, 4545, 5870, 11182, 9052, 11583, 7252, 3771, 8146, 10514, 11571, 11407, 10350, 9410, 5455,
        5591, 9605, 10980, 9162, 4008, 7282, 4513, 3751, 9441, 8871, 7660,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let (base, rise) = (p.num("step_base"), p.num("step_diff"));
    let (left_y, right_y) = if rise > 0.0 { (base, base + rise) } else { (base - rise, base) };
    let scale = p.num("jar_scale");
    skip(scale < 0.19 && rise.abs() > 0.19)?;
    skip(scale > 0.26 && (rise.abs() < 0.19 || rise < -0.19))?;
    let left = static_body(Bar(0.3)).at_left(SIZE * p.num("left_side")).at_bottom(SIZE * left_y);
    let big = dynamic_body(Ball(0.15)).at_left(left.left()).at_bottom(left.top());
    let plank = dynamic_body(Bar(0.4)).at_left(5.0).at_bottom(big.top());
    let ball = dynamic_body(Ball(0.05)).at_left(0.02 * SIZE).at_bottom(plank.top());
    let knob = static_body(Ball(0.1)).at_top(SIZE).at_cx(big.cx());
    let right = static_body(Bar(0.3)).rotated(p.num("jar_angle")).at_right(SIZE).at_bottom(SIZE * right_y);
    let jar = dynamic_body(Jar(scale)).at_right(SIZE * p.num("jar_right")).at_bottom(right.top());
    let jar_ball = dynamic_body(Ball(0.05 + scale / 8.0)).at_bottom(jar.bottom() + 10.0).at_cx(jar.cx());
    Some(scene([left, big, plank, ball.object(), knob, right, jar, jar_ball.goal()]))
}

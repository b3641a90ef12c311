//! 00023 Rolling Bridge.

use super::{Lin, Params, Template, kept, skip};
use crate::puzzle::layout::{Ball, Bar, Jar, dynamic, fixed, scene};
use crate::puzzle::scene::{SIZE, Scene};

pub static TEMPLATE: Template = Template {
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
    selected: kept(
        "8 17 31 64 111 112 134 153 202 223 233 240 241 245 261 269 310 316 320 377 385 402 428 \
         438 441 470 471 490 493 506 507 513 522 523 534 535 538 543 566 584 614 625 636 644 655 \
         666 680 689 704 728 736 740 745 751 754 757 767 771 778 797 800 801 812 817-821 829 839 \
         848 850 857 859 873 875 878 879 883 884 898 899 901 913 918 925 926 930 936 946 948 950 \
         952 957 959 960 963 972 974 990",
    ),
};

fn script(p: &Params) -> Option<Scene> {
    let (base, rise) = (p.num("step_base"), p.num("step_diff"));
    let (left_y, right_y) = if rise > 0.0 { (base, base + rise) } else { (base - rise, base) };
    let scale = p.num("jar_scale");
    skip(scale < 0.19 && rise.abs() > 0.19)?;
    skip(scale > 0.26 && (rise.abs() < 0.19 || rise < -0.19))?;
    let left = fixed(Bar(0.3)).at_left(SIZE * p.num("left_side")).at_bottom(SIZE * left_y);
    let big = dynamic(Ball(0.15)).at_left(left.left()).at_bottom(left.top());
    let plank = dynamic(Bar(0.4)).at_left(5.0).at_bottom(big.top());
    let ball = dynamic(Ball(0.05)).at_left(0.02 * SIZE).at_bottom(plank.top());
    let knob = fixed(Ball(0.1)).at_top(SIZE).at_cx(big.cx());
    let right = fixed(Bar(0.3)).turned(p.num("jar_angle")).at_right(SIZE).at_bottom(SIZE * right_y);
    let jar = dynamic(Jar(scale)).at_right(SIZE * p.num("jar_right")).at_bottom(right.top());
    let held = dynamic(Ball(0.05 + scale / 8.0)).at_bottom(jar.bottom() + 10.0).at_cx(jar.cx());
    Some(scene([left, big, plank, ball.object(), knob, right, jar, held.goal()]))
}

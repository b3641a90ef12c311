//! 00011 Two Slopes.

use super::{Lin, Params, Template, kept, skip};
use crate::puzzle::layout::{Ball, Bar, dynamic, fixed, scene};
use crate::puzzle::scene::{SIZE, Scene};

pub static TEMPLATE: Template = Template {
    number: 11,
    name: "Two Slopes",
    story: "A ball falls onto the upper left or the lower right of two slopes; make it rest against the right one.",
    grid: &[
        ("angle_left", Lin(15.0, 30.0, 5)),
        ("angle_right", Lin(15.0, 30.0, 5)),
        ("ball_x", Lin(0.2, 0.8, 10)),
        ("bar_y", Lin(0.1, 0.5, 10)),
        ("length_left", Lin(0.2, 0.8, 4)),
    ],
    script,
    selected: kept(
        "4 20 49 72 91 93 95 108 111 126 132 136 145 178 216 226 227 258 262 274 282 301 304 336 \
         341 342 347 350 352 370 376 391 399 404 410 448 451 457 461 491 520 528 537 538 586 599 \
         626 632 633 645 661 667 669 670 678 683 688 704-706 712 740 741 752 776 784 785 791 801 \
         802 816 822 828 840 841 854 861 872 875 881 898 908 916 918 922 923 931 937 938 944 950 \
         953 957 964 966 967 969 977 991 993",
    ),
};

fn script(p: &Params) -> Option<Scene> {
    let (length, y) = (p.num("length_left"), p.num("bar_y"));
    // PHYRE's names are crossed: `angle_left` turns the right slope and `angle_right` the left one.
    let right = fixed(Bar(1.0 - length)).turned(p.num("angle_left")).at_bottom(SIZE * y).at_right(1.01 * SIZE);
    let left = fixed(Bar(length)).turned(-p.num("angle_right")).at_bottom((y + 0.2) * SIZE).at_left(-0.01 * SIZE);
    let ball = dynamic(Ball(0.1)).at_cx(SIZE * p.num("ball_x")).at_bottom(SIZE * 0.9);
    skip(ball.left() < left.right() && left.top() > SIZE * 0.9)?;
    Some(scene([right.goal(), left, ball.object()]))
}

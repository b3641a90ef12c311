//! 00011 Two Slopes.

use super::{Lin, Params, Template, skip, task_numbers};
use crate::puzzle::layout::{Ball, Bar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
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
    task_numbers: task_numbers(
        "4 20 49 72 91 93 95 108 111 126 132 136 145 178 216 226 227 258 262 274 282 301 304 336 \
         341 342 347 350 352 370 376 391 399 404 410 448 451 457 461 491 520 528 537 538 586 599 \
         626 632 633 645 661 667 669 670 678 683 688 704-706 712 740 741 752 776 784 785 791 801 \
         802 816 822 828 840 841 854 861 872 875 881 898 908 916 918 922 923 931 937 938 944 950 \
         953 957 964 966 967 969 977 991 993",
    ),
    combinations: [
        6095, 8547, 6551, 6627, 4872, 8587, 27, 195, 5797, 5103, 6195, 8590, 8099, 9478, 6823, 5232, 8543, 9753, 6593,
        3659, 6367, 8743, 8060, 59, 7107, 9299, 9918, 6415, 8655, 6231, 8278, 4832, 2351, 7683, 6113, 8986, 5661, 8836,
        8143, 2147, 6187, 4907, 6731, 5749, 9295, 4472, 7067, 3676, 6828, 8432, 9139, 2375, 4983, 5317, 2876, 3232,
        7393, 7163, 9346, 8076, 4371, 6303, 9599, 9705, 6323, 395, 8275, 6912, 5918, 8997, 6859, 9147, 5739, 2063,
        8190, 4431, 8507, 9556, 7914, 8528, 2463, 427, 8487, 1567, 4634, 9518, 6267, 7866, 6233, 9826, 36, 4551, 2111,
        6987, 8867, 5619, 8674, 6739, 9228, 8270,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let (length, y) = (p.num("length_left"), p.num("bar_y"));
    // PHYRE's names are crossed: `angle_left` rotates the right slope and `angle_right` the left one.
    let right = static_body(Bar(1.0 - length)).rotated(p.num("angle_left")).at_bottom(SIZE * y).at_right(1.01 * SIZE);
    let left =
        static_body(Bar(length)).rotated(-p.num("angle_right")).at_bottom((y + 0.2) * SIZE).at_left(-0.01 * SIZE);
    let ball = dynamic_body(Ball(0.1)).at_cx(SIZE * p.num("ball_x")).at_bottom(SIZE * 0.9);
    skip(ball.left() < left.right() && left.top() > SIZE * 0.9)?;
    Some(scene([right.goal(), left, ball.object()]))
}

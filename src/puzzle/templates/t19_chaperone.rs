//! 00019 Chaperone.

use super::{Lin, List, Params, Template, skip, task_numbers};
use crate::puzzle::layout::{Ball, Bar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 19,
    name: "Chaperone",
    story: "Two balls fall one above the other; make the upper one come to rest on the raised pad with little rims.",
    grid: &[
        ("ball_x", Lin(0.0, 1.0, 128)),
        ("lower_ball_y", List(&[0.7, 0.5])),
        ("target_size", Lin(0.1, 0.2, 2)),
        ("target_x", Lin(0.0, 1.0, 128)),
    ],
    script,
    task_numbers: task_numbers(
        "13 38 64 68 103 143 146 184 215 219 244 249 252 261 273 287 296 311 316 321 332 337 339 \
         348 351 364 369 372 388 410 415 434 439 460 479 484 502 518 543 562 563 584 593 597 598 \
         606 608 611 612 620 633 646 660 661 679 681 684 690 694 695 705 709 726 728 745 757 762 \
         769 770 791 805 811 812 835 852 853 865 867 871 877 879 884 885 896 909 918 923 928 935 \
         938 944 955 960 967 970 974 987 991 994 998",
    ),
    combinations: [
        50738, 39833, 8206, 8006, 11860, 24805, 60599, 57024, 44961, 10185, 26622, 50583, 21234, 28793, 29504, 45964,
        36895, 37455, 18516, 33041, 45329, 31851, 57590, 4029, 41098, 61179, 39729, 36420, 40522, 10960, 22005, 33304,
        12362, 13791, 54321, 47667, 30957, 24313, 24431, 8582, 26594, 43940, 53062, 15719, 63221, 134, 37119, 61760,
        58227, 58484, 59382, 60792, 17116, 27478, 4872, 39570, 52126, 48019, 44815, 44810, 43909, 26381, 63989, 18385,
        2569, 26854, 46621, 59707, 59001, 5385, 8721, 40791, 6784, 54572, 16078, 18916, 32096, 14421, 38661, 22362,
        41622, 42257, 28595, 18977, 33023, 4617, 43399, 38521, 21731, 55732, 5001, 28156, 20207, 53294, 44072, 57716,
        58303, 44590, 14550, 54834,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let x = SIZE * p.num("ball_x");
    let ball = dynamic_body(Ball(0.1)).at_bottom(SIZE * 0.9).at_cx(x);
    let lower = dynamic_body(Ball(0.1)).at_bottom(SIZE * p.num("lower_ball_y")).at_cx(x);
    skip(ball.left() >= 253.0)?;
    let floor = static_body(Bar(1.0)).at_left(0.0).at_bottom(0.0);
    let pad = static_body(Bar(p.num("target_size"))).at_bottom(floor.top()).at_cx(SIZE * p.num("target_x"));
    let rim = || static_body(Bar(0.02)).rotated(90.0).at_bottom(pad.top());
    let left_rim = || rim().at_right(pad.left());
    let right_rim = || rim().at_left(pad.right());
    // One of the two rims is listed twice.
    let twice = if pad.left() < ball.left() { left_rim() } else { right_rim() };
    let rims = [left_rim(), right_rim(), twice];
    Some(scene([ball.object(), lower, floor, pad.goal()].into_iter().chain(rims)))
}

//! 00018 Covered Ball.

use super::{Lin, Params, Template, skip, task_numbers};
use crate::puzzle::layout::{Ball, Bar, Jar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 18,
    name: "Covered Ball",
    story: "A small ball sits under an upturned jar on a shelf; get it to the ball that the jar on the ground holds.",
    grid: &[
        ("bar_offset", Lin(0.1, 0.2, 3)),
        ("bar_y", Lin(0.4, 0.65, 10)),
        ("bottom_jar_scale", Lin(0.15, 0.2, 3)),
        ("bottom_jar_x", Lin(0.25, 0.5, 5)),
        ("right_diag_angle", Lin(30.0, 70.0, 3)),
    ],
    script,
    task_numbers: task_numbers(
        "7 9 13 15 23 28 33 35 36 38-40 44 46 49 52 53 55-57 61 63 66 67 69 70 72 77 79 82 85 89 \
         91 93 95 98 99 101 105 107 108 110 111 114-116 118-120 122 125-131 134-137 139 144-147 \
         150 152 154-162 164-167 171-174 178-180 183-185 187-189 192 193 195-198",
    ),
    combinations: [
        833, 1195, 890, 245, 1089, 367, 221, 1077, 158, 762, 580, 310, 594, 249, 713, 723, 196, 590, 597, 682, 1149,
        1173, 996, 349, 696, 1265, 408, 1183, 1117, 1166, 639, 1044, 686, 512, 223, 140, 353, 443, 376, 1202, 170, 212,
        395, 313, 681, 441, 1190, 438, 6, 286, 292, 564, 1261, 670, 411, 43, 1327, 627, 746, 1175, 427, 668, 251, 803,
        131, 1071, 951, 1241, 930, 963, 1282, 1221, 154, 918, 1169, 1010, 1100, 19, 927, 24, 172, 1047, 1112, 277, 738,
        870, 625, 1005, 436, 683, 915, 579, 425, 474, 656, 1258, 633, 298, 1219, 109,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let (jar_scale, jar_x) = (p.num("bottom_jar_scale"), p.num("bottom_jar_x"));
    let y = p.num("bar_y");
    skip(y >= 0.6 && jar_x > 0.4)?;
    let jar = dynamic_body(Jar(jar_scale)).at_bottom(0.0).at_cx(SIZE * jar_x);
    let jar_ball = dynamic_body(Ball(0.05 + jar_scale / 8.0)).at_bottom(10.0).at_cx(jar.cx());
    let shelf = static_body(Bar(1.0)).at_left(jar.left() + SIZE * p.num("bar_offset")).at_bottom(SIZE * y);
    let cover = dynamic_body(Jar(0.12)).rotated(180.0).at_left(shelf.left()).at_bottom(shelf.top());
    let ball = dynamic_body(Ball(0.05)).at_bottom(shelf.top()).at_cx(cover.left() + 0.5 * cover.width());
    skip(shelf.left() < 3.0 * ball.width())?;
    let diagonal = static_body(Bar(1.0))
        .rotated(p.num("right_diag_angle"))
        .at_left((0.7 * SIZE).max(cover.right() + 10.0))
        .at_bottom(shelf.bottom());
    Some(scene([jar, jar_ball.goal(), shelf, cover, ball.object(), diagonal]))
}

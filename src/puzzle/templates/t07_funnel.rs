//! 00007 Funnel.

use super::{Lin, Params, Template, Words, skip, task_numbers};
use crate::puzzle::layout::{Ball, Bar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 7,
    name: "Funnel",
    story: "A ball falls through a funnel; make it land on the short pad in the corner, behind the raised block.",
    grid: &[
        ("angle", Lin(20.0, 30.0, 10)),
        ("ball_scale", Lin(0.05, 0.1, 1)),
        ("ball_x", Lin(0.4, 0.6, 20)),
        ("target_side", Words(&["left", "right"])),
    ],
    script,
    task_numbers: task_numbers(
        "8 30 36 39 47 48 57 59 63 78 81 85 90-92 100 101 109-111 113 115 116 121 124 125 127 133 \
         135 136 139 147 152 163 175 176 181 185 188 194 198 204 205 213 215 224 232 233 240 241 \
         243 244 248 253 254 260 265 269 270 274-281 286 287 291 292 295 297 298 300 305 307 311 \
         316-319 323 324 328-330 333 336 337 339 340 342 345 346 351 352 355 357 358",
    ),
    combinations: [
        195, 349, 223, 353, 395, 313, 123, 372, 204, 240, 399, 200, 176, 101, 246, 125, 85, 216, 284, 273, 288, 305,
        121, 237, 239, 322, 235, 317, 366, 110, 275, 294, 282, 393, 206, 150, 95, 355, 202, 319, 387, 244, 280, 213,
        93, 311, 189, 108, 54, 142, 151, 107, 315, 306, 344, 364, 193, 332, 359, 362, 116, 254, 347, 87, 389, 124, 104,
        183, 368, 225, 129, 73, 279, 40, 370, 46, 120, 233, 397, 242, 265, 360, 117, 211, 98, 267, 309, 351, 149, 324,
        49, 94, 44, 266, 173, 164, 357, 65, 330, 83,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let scale = p.num("ball_scale");
    let ball = dynamic_body(Ball(scale)).at_top(SIZE).at_cx(SIZE * p.num("ball_x"));
    let pad = static_body(Bar(0.2)).at_bottom(0.0);
    let floor = static_body(Bar(0.8)).at_bottom(0.0);
    let block = static_body(Bar(0.2)).at_bottom(floor.top());
    let (pad, floor, block) = if p.word("target_side") == "left" {
        let pad = pad.at_left(0.0);
        let edge = pad.right();
        (pad, floor.at_left(edge), block.at_left(edge))
    } else {
        let pad = pad.at_right(SIZE);
        let edge = pad.left();
        (pad, floor.at_right(edge), block.at_right(edge))
    };
    let angle = p.num("angle");
    let left_side = static_body(Bar(0.5)).rotated(-angle).at_left(0.0).at_top(SIZE * 0.9);
    let right_side = static_body(Bar(0.5)).rotated(angle).at_right(SIZE).at_top(SIZE * 0.9);
    skip(right_side.left() - left_side.right() <= SIZE * scale)?;
    Some(scene([ball.object(), pad.goal(), floor, block, left_side, right_side]))
}

//! 00015 Cradle.

use super::{Lin, Params, Template, task_numbers};
use crate::puzzle::dimensions::radians;
use crate::puzzle::layout::{Ball, Bar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 15,
    name: "Cradle",
    story: "A ball sits in a tiny cradle in mid-air; kick it out and down to the floor.",
    grid: &[("bar_size", Lin(0.05, 0.1, 5)), ("x", Lin(0.2, 0.8, 10)), ("y", Lin(0.2, 0.5, 10))],
    script,
    task_numbers: task_numbers(
        "14 16 20 35 58 69 134 154 171 185 189 197 211 223 230 236 240 242 243 249 257 263 \
         267-270 274 276 278-280 282 288 291 296 297 301 303 309 311 316 319 325 330 337 339 341 \
         348 349 352 357-359 362 371 372 374 379 386 390 397 399 400 403 404 406-409 414 416 418 \
         421 424 426 429 431 432 442 447 448 452 454 457 459 460 462 464 467 469 472 474 480 481 \
         485 486 490 491 495 496",
    ),
    combinations: [
        339, 367, 269, 369, 438, 446, 247, 148, 239, 475, 248, 431, 157, 329, 497, 89, 486, 206, 419, 459, 289, 468,
        406, 319, 147, 428, 307, 268, 179, 178, 416, 287, 452, 312, 186, 460, 447, 448, 188, 311, 379, 189, 487, 326,
        409, 358, 467, 209, 306, 496, 398, 327, 412, 403, 332, 359, 219, 488, 347, 389, 328, 368, 259, 478, 458, 479,
        225, 418, 129, 279, 449, 39, 345, 257, 388, 469, 435, 139, 397, 466, 218, 211, 127, 3, 267, 309, 439, 472, 106,
        149, 49, 407, 430, 266, 100, 396, 423, 357, 437, 255,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let (size, x) = (p.num("bar_size"), SIZE * p.num("x"));
    let floor = static_body(Bar(1.0)).at_left(0.0).at_bottom(0.0);
    let left = static_body(Bar(size)).rotated(355.0).at_right(x).at_bottom(SIZE * p.num("y"));
    let right = static_body(Bar(size)).rotated(5.0).at_left(left.right()).at_bottom(left.bottom());
    let dip = (size * libm::sin(radians(5.0)) - 0.001) * SIZE;
    let ball = dynamic_body(Ball(0.1)).at_bottom(right.top() - dip).at_cx(x);
    Some(scene([floor.goal(), left, right, ball.object()]))
}

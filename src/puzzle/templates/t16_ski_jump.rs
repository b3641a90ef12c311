//! 00016 Ski Jump.

use std::iter::successors;

use super::{Lin, Params, Template, skip, task_numbers};
use crate::puzzle::dimensions::radians;
use crate::puzzle::layout::{Ball, Bar, BodyBuilder, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 16,
    name: "Ski Jump",
    story: "A ball rolls down a ramp behind a smaller one and over a kicker; make it land on the short strip of floor.",
    grid: &[
        ("angle", Lin(30.0, 50.0, 6)),
        ("buffer", Lin(0.0, 0.1, 3)),
        ("radius", Lin(5.0, 12.0, 5)),
        ("target_position", Lin(0.35, 0.65, 10)),
    ],
    script,
    task_numbers: task_numbers(
        "10 16 54 55 89 100 111 116 117 126 146 184 191 194 197 200 201 215 225 226 233 253 268 \
         271 311 327 328 353 357 377 380 383 384 392 399 436 452 494 500 517 538 540 545 549 553 \
         563 569 571 579-581 583 594 609 610 635 636 646 648 651 664 675 680 681 692 695 701 722 \
         724 743 746 750 751 758 765 774 778 783 796 801 809 816 823 825 830 831 834 844 851 859 \
         862 870 873 879 885 888 890 891 895 898",
    ),
    combinations: [
        550, 195, 144, 888, 170, 541, 400, 36, 251, 709, 432, 493, 187, 809, 240, 41, 30, 262, 101, 246, 343, 136, 284,
        148, 649, 731, 391, 275, 11, 84, 111, 635, 282, 250, 807, 70, 95, 147, 830, 92, 20, 698, 231, 130, 291, 133,
        42, 189, 38, 194, 37, 146, 440, 721, 632, 657, 701, 398, 771, 412, 797, 31, 892, 605, 347, 547, 571, 190, 458,
        730, 530, 370, 609, 46, 592, 435, 139, 233, 695, 700, 742, 117, 220, 546, 740, 185, 299, 149, 49, 44, 430, 100,
        290, 840, 181, 860, 680, 437, 849, 373,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let (angle, radius) = (p.num("angle"), p.num("radius"));
    let target = p.num("target_position");
    let left_floor = static_body(Bar(target)).at_left(0.0).at_bottom(0.0);
    let strip = static_body(Bar(0.1)).at_left(left_floor.right()).at_bottom(0.0);
    let right_floor = static_body(Bar(1.0 - 0.1 - target)).at_left(strip.right()).at_bottom(0.0);
    let fence = static_body(Bar(0.1)).rotated(90.0).at_right(strip.left()).at_bottom(0.0);
    let slab_on = |below: &BodyBuilder| static_body(Bar(0.1)).at_left(below.left()).at_bottom(below.top());
    let slabs: Vec<BodyBuilder> =
        successors(Some(slab_on(&right_floor)), |below| Some(slab_on(below))).take(5).collect();
    let parallel = |raised: f64| {
        static_body(Bar(0.5)).rotated(-angle).at_right(fence.left() - 0.1 * SIZE).at_bottom(0.3 * SIZE + raised)
    };
    let ramp = parallel(0.0);
    let kicker = static_body(Bar(0.1)).rotated(10.0).at_left(ramp.right() - 0.02 * SIZE).at_bottom(ramp.bottom());
    let (lid, upper_lid) = (parallel(6.0 * radius), parallel(10.0 * radius));
    let mast = static_body(Bar(0.1)).rotated(90.0).at_left(slabs[4].left()).at_bottom(slabs[4].top());
    let baffle = static_body(Bar(0.5)).rotated(-30.0).at_left(kicker.right()).at_top(lid.bottom() + 0.1 * SIZE);
    // The height of the ramp at x.
    let slope = libm::tan(radians(angle));
    let ramp_at = |x: f64| ramp.bottom() + (ramp.right() - x) * slope;
    let x = (0.05 * SIZE).max(ramp.left() + 0.01 * SIZE) + p.num("buffer") * SIZE;
    let ball = dynamic_body(Ball(radius / SIZE * 2.0)).at_cx(x + radius).at_cy(ramp_at(x) + 1.7 * radius);
    let x = ball.cx() + 4.0 * radius;
    let small = dynamic_body(Ball(radius / SIZE)).at_cx(x).at_cy(ramp_at(x) + 2.6 * radius);
    let small = if small.right() >= kicker.left() {
        let bottom = kicker.top().max(small.bottom());
        small.at_bottom(bottom)
    } else {
        small
    };
    skip(ball.width() >= strip.width())?;
    let ground = [left_floor, strip.goal(), right_floor, fence];
    let track = [ramp, kicker, lid, upper_lid, mast, baffle, ball.object(), small];
    Some(scene(ground.into_iter().chain(slabs).chain(track)))
}

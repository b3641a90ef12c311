//! 00004 Seesaw Catch.

use super::{Lin, Params, Template, skip, task_numbers};
use crate::puzzle::layout::{Ball, Bar, BodyBuilder, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 4,
    name: "Seesaw Catch",
    story: "A ball falls towards a beam that lies across a round pivot; make it stay on the beam.",
    grid: &[
        ("ball_x", Lin(0.2, 0.8, 14)),
        ("bar_center", Lin(0.25, 0.65, 5)),
        ("bar_scale", Lin(0.3, 0.45, 8)),
        ("bar_y", Lin(0.1, 0.6, 12)),
    ],
    script,
    task_numbers: task_numbers(
        "63 71 92 94 95 110 137 139 147 186 189 200 219 232 243 268 271 286 292 305 313 316 326 \
         331 336 358 393 398 415 433 436 438 445 471 478 483 487 490 505 506 523 537 548 560 567 \
         593 603 606 611 612 619 627 642 645 654 660 662 670 680 690 695 730 731 744 759 764 766 \
         767 774 775 777 778 785 792 795 800 805 818 823 839 840 846 848 858 860 862 864 865 868 \
         883 889 904 931 938 947 958 960 967 978 985",
    ),
    combinations: [
        252, 6121, 1792, 1338, 1799, 2389, 4506, 6593, 689, 4503, 3445, 3496, 6112, 3985, 726, 3507, 3304, 283, 6090,
        2391, 691, 2462, 6611, 3970, 2826, 2856, 1814, 2948, 286, 2921, 1762, 1327, 746, 4551, 2242, 2867, 131, 3489,
        4000, 3981, 4014, 5047, 5064, 1807, 1946, 277, 5591, 738, 4008, 1771, 2849, 2811, 1754, 5075, 2727, 2249, 5546,
        2443, 4002, 1758, 5056, 2819, 2452, 6107, 3467, 1320, 2231, 2427, 719, 5603, 145, 3274, 2927, 3976, 2832, 6066,
        2447, 6101, 6654, 3447, 5034, 5077, 6695, 4541, 2446, 6657, 5021, 4508, 2854, 6613, 4575, 2870, 5556, 2916,
        1174, 2837, 1325, 5063, 262, 1775,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let center = SIZE * p.num("bar_center");
    let floor = static_body(Bar(1.0)).at_bottom(SIZE * p.num("bar_y")).at_left(0.0);
    let pivot = static_body(Ball(0.1)).at_bottom(floor.top()).at_cx(center);
    let beam = dynamic_body(Bar(p.num("bar_scale"))).at_cx(center).at_bottom(pivot.top());
    let ball = dynamic_body(Ball(0.1)).at_cx(SIZE * p.num("ball_x")).at_bottom(SIZE * 0.9);
    let gap = SIZE * 0.15;
    let guard = || static_body(Bar(0.2)).rotated(90.0);
    let left_guard = guard().at_left(beam.left() - gap).at_top(ball.bottom() - gap);
    let right_guard = guard().at_right(beam.right() + gap).at_top(ball.bottom() - gap);
    skip(ball.bottom() < floor.top())?;
    skip(ball.right() < beam.left() || ball.left() > beam.right())?;
    let sunk = left_guard.bottom() < floor.top();
    let raised = |guard: BodyBuilder| if sunk { guard.at_bottom(floor.top()) } else { guard };
    let (left_guard, right_guard) = (raised(left_guard), raised(right_guard));
    Some(scene([floor, pivot, beam.goal(), ball.object(), left_guard, right_guard]))
}

//! 00009 Off the Ledge.

use super::{Lin, Params, Template, skip, task_numbers};
use crate::puzzle::layout::{Bar, dynamic_body, scene, static_body};
use crate::puzzle::scene::{SIZE, Scene};

pub(crate) static TEMPLATE: Template = Template {
    number: 9,
    name: "Off the Ledge",
    story: "A pole stands on the outer end of a ledge under a low ceiling; push it down to the floor.",
    grid: &[
        ("bar_scale", Lin(0.2, 0.3, 2)),
        ("obstacle_width", Lin(0.4, 0.6, 4)),
        ("obstacle_x", Lin(0.0, 1.0, 64)),
        ("platform_y", Lin(0.2, 0.5, 5)),
    ],
    script,
    task_numbers: task_numbers(
        "13 27 96 119 173 231 238 357 359 365 367 406 432 449 464 478 488 508 521 558-560 585 589 \
         602 618 626 629 636 646 656 672 678 691 693 707 710 722 726 763 765 767 782 783 800 808 \
         810 816 820 822 826 832 836 838 848 851 857 858 863 869 872 874 877 879-882 887 891 897 \
         903 906 909 913 914 920 930 933 934 936 940 945 946 949 954 957-959 961 962 970 971 976 \
         981 982 985 987 988 992 996",
    ),
    combinations: [
        1024, 2311, 2296, 2295, 2294, 2301, 2305, 2300, 2292, 2310, 1989, 2269, 651, 2287, 1999, 2307, 1020, 2317,
        1013, 1728, 781, 2283, 2316, 1306, 1689, 1960, 1687, 2284, 401, 1025, 1029, 1723, 2315, 1986, 644, 1334, 968,
        1006, 994, 2291, 988, 1032, 15, 976, 2007, 1673, 2319, 1367, 1035, 2271, 68, 2047, 1298, 1704, 2320, 1061,
        1711, 409, 1000, 1734, 721, 1720, 74, 374, 708, 2285, 1688, 1444, 750, 2347, 1981, 657, 55, 1686, 2338, 160,
        1759, 1379, 1324, 405, 380, 1651, 2329, 758, 690, 50, 1736, 775, 31, 1645, 1943, 2288, 1, 1993, 1998, 1326, 16,
        1622, 2011, 1464,
    ],
};

fn script(p: &Params) -> Option<Scene> {
    let (x, width) = (p.num("obstacle_x"), p.num("obstacle_width"));
    skip(x + width > 1.0)?;
    let ledge = static_body(Bar(width)).at_left(SIZE * x).at_bottom(SIZE * p.num("platform_y"));
    let pole = dynamic_body(Bar(p.num("bar_scale"))).rotated(90.0).at_bottom(ledge.top());
    // The outer end is the one with more space next to it.
    let pole =
        if ledge.left() > SIZE - ledge.right() { pole.at_left(ledge.left()) } else { pole.at_right(ledge.right()) };
    let floor = static_body(Bar(1.0)).at_bottom(0.0).at_left(0.0);
    let ceiling = static_body(Bar(1.0)).at_left(0.0).at_bottom(pole.top() + 0.2 * SIZE);
    Some(scene([ledge, pole.object(), floor.goal(), ceiling]))
}

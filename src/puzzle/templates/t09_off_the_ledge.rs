//! 00009 Off the Ledge.

use super::{Lin, Params, Template, kept, skip};
use crate::puzzle::layout::{Bar, dynamic, fixed, scene};
use crate::puzzle::scene::{SIZE, Scene};

pub static TEMPLATE: Template = Template {
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
    selected: kept(
        "13 27 96 119 173 231 238 357 359 365 367 406 432 449 464 478 488 508 521 558-560 585 589 \
         602 618 626 629 636 646 656 672 678 691 693 707 710 722 726 763 765 767 782 783 800 808 \
         810 816 820 822 826 832 836 838 848 851 857 858 863 869 872 874 877 879-882 887 891 897 \
         903 906 909 913 914 920 930 933 934 936 940 945 946 949 954 957-959 961 962 970 971 976 \
         981 982 985 987 988 992 996",
    ),
};

fn script(p: &Params) -> Option<Scene> {
    let (x, width) = (p.num("obstacle_x"), p.num("obstacle_width"));
    skip(x + width > 1.0)?;
    let ledge = fixed(Bar(width)).at_left(SIZE * x).at_bottom(SIZE * p.num("platform_y"));
    let pole = dynamic(Bar(p.num("bar_scale"))).turned(90.0).at_bottom(ledge.top());
    // The outer end is the one with more room beside it.
    let pole =
        if ledge.left() > SIZE - ledge.right() { pole.at_left(ledge.left()) } else { pole.at_right(ledge.right()) };
    let floor = fixed(Bar(1.0)).at_bottom(0.0).at_left(0.0);
    let ceiling = fixed(Bar(1.0)).at_left(0.0).at_bottom(pole.top() + 0.2 * SIZE);
    Some(scene([ledge, pole.object(), floor.goal(), ceiling]))
}

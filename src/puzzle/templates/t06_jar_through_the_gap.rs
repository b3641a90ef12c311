//! 00006 Jar through the Gap.

use super::{Lin, Params, Template, kept, skip};
use crate::puzzle::layout::{Ball, Bar, Jar, dynamic, fixed, scene};
use crate::puzzle::scene::{SIZE, Scene};

pub static TEMPLATE: Template = Template {
    number: 6,
    name: "Jar through the Gap",
    story: "An upturned jar falls through the gap in a floor; bring the ball that lies on that floor to it.",
    grid: &[("ball_left", Lin(0.2, 0.8, 20)), ("bar_height", Lin(0.3, 0.6, 16)), ("hole_left", Lin(0.2, 0.8, 20))],
    script,
    selected: kept(
        "3 4 7 10 16 26 28 33 38 43-47 52 55 56 60 62 64-66 71 87 88 90 92 94 96 98 101 103 106 \
         108 113 115 117-121 123-127 131-133 136-147 149 151-155 157 160 162-164 166-170 172-175 \
         179-184 186-192 194-199",
    ),
};

fn script(p: &Params) -> Option<Scene> {
    // Turned about the middle of its base after it was placed, so it hangs down from there.
    let jar = dynamic(Jar(0.15)).at_cx(SIZE / 2.0).at_top(SIZE * 0.95).turned(180.0);
    let (hole_left, hole_right) = (p.num("hole_left"), p.num("hole_left") + 0.2);
    let height = SIZE * p.num("bar_height");
    let left_floor = fixed(Bar(hole_left)).at_left(0.0).at_bottom(height);
    skip(hole_right >= 1.0)?;
    let right_floor = fixed(Bar(1.0 - hole_right)).at_right(SIZE).at_bottom(height);
    let ball = dynamic(Ball(0.1)).at_bottom(right_floor.top()).at_left(SIZE * p.num("ball_left"));
    skip(jar.left() < left_floor.right() || jar.right() > right_floor.left())?;
    skip(left_floor.right() < ball.cx() && ball.cx() < right_floor.left())?;
    let slope = fixed(Bar(2.0)).turned(10.0).at_left(0.0).at_bottom(-2.0);
    Some(scene([jar.goal(), left_floor, right_floor, ball.object(), slope]))
}

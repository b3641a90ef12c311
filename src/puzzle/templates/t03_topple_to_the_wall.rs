//! 00003 Topple to the Wall.

use super::{Lin, Params, Template, kept, skip};
use crate::puzzle::layout::{Bar, Jar, dynamic, fixed, scene};
use crate::puzzle::scene::{SIZE, Scene};

pub static TEMPLATE: Template = Template {
    number: 3,
    name: "Topple to the Wall",
    story: "A pole stands upright in a small jar; knock it against the strip on the nearer side wall.",
    grid: &[("bar_scale", Lin(0.2, 0.5, 4)), ("jar_x", Lin(0.05, 0.95, 20)), ("jitter_x", Lin(-2.0, 2.0, 5))],
    script,
    selected: kept("0-11 13-15 17-23 25-28 30 31 33-35 37 38 40-44 46 47 49-59 61-65 67-69 71-111"),
};

fn script(p: &Params) -> Option<Scene> {
    let jar = dynamic(Jar(0.1)).at_bottom(0.0).at_cx(SIZE * p.num("jar_x"));
    let pole = dynamic(Bar(p.num("bar_scale"))).turned(90.0).at_bottom(4.0).at_cx(jar.cx() + p.num("jitter_x"));
    skip(jar.left() <= pole.width() || jar.right() >= 255.0 - pole.width())?;
    let reach = pole.height() + 40.0;
    let near_left = reach > pole.left();
    let near_right = reach > SIZE - pole.right();
    skip(!near_left && !near_right)?;
    let strip = fixed(Bar(1.0)).turned(90.0).at_bottom(0.0);
    let strip = if near_left { strip.at_left(0.0) } else { strip.at_right(SIZE) };
    Some(scene([jar, pole.object(), strip.goal()]))
}

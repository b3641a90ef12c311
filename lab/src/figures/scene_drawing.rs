//! Draws scenes, balls, paths and maps as SVG, as the page does on a canvas (`src/web/paint.rs`).
//!
//! All coordinates are those of the scene: px, origin at the bottom left, y up. `window` places a drawing in a figure.

use std::collections::BTreeMap;

use pathlight::colour::imagined_maps::ImaginedMap;
use pathlight::colour::palette::palette;
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::rollout::{Pose, Rollout};
use pathlight::puzzle::scene::{Body, Role, SIZE, Scene, Shape};
use pathlight::raster::{PX_PER_CELL, SIDE};
use svg::Document;
use svg::node::element::path::Data;
use svg::node::element::{Circle, Group, Line, Path, Pattern, Rectangle};

use super::picture::{FAINT, px};

/// Distance between the lines of a hatched goal, and their width, px.
const HATCH: (f64, f64) = (4.5, 1.2);

/// Width of a path and of the rim around it, px.
const PATH: (f64, f64) = (3.0, 1.5);

/// Number of levels of a map above zero.
const LEVELS: u8 = 20;

/// Simulation steps between two points of a path.
const STRIDE: usize = 4;

/// How a path is drawn.
#[derive(Clone, Copy)]
pub enum LineStyle {
    Real,
    Imagined,
}

/// Returns a framed view of a scene, `side` px wide and high. Content outside the frame is clipped.
pub fn window([x, y]: [f64; 2], side: f64, content: Vec<Group>) -> Group {
    let up = content.into_iter().fold(Group::new().set("transform", "matrix(1 0 0 -1 0 256)"), Group::add);
    let view = Document::new().set("viewBox", (0, 0, SIZE, SIZE)).set("x", px(x)).set("y", px(y));
    let frame = Rectangle::new().set("x", px(x)).set("y", px(y)).set("width", px(side)).set("height", px(side));
    Group::new()
        .add(view.set("width", px(side)).set("height", px(side)).add(up))
        .add(frame.set("fill", "none").set("stroke", FAINT))
}

/// Returns the hatch pattern of goal bodies, to be added to the definitions of a figure.
pub fn hatch() -> Pattern {
    let (spacing, width) = HATCH;
    let stripe = Line::new().set("x1", 0).set("x2", 0).set("y2", spacing).set("stroke", palette(false).paper);
    let pattern = Pattern::new().set("id", "hatch").set("width", spacing).set("height", spacing);
    pattern
        .set("patternUnits", "userSpaceOnUse")
        .set("patternTransform", "rotate(-45)")
        .add(stripe.set("stroke-width", 2.0 * width).set("stroke-opacity", 0.55))
}

/// Returns all bodies of a scene in their initial positions.
pub fn scene(scene: &Scene) -> Group {
    bodies(scene, |_| None)
}

/// Returns all bodies and the ball in their final positions of a rollout.
pub fn last_frame(scene: &Scene, ball: Ball, rollout: &Rollout) -> Group {
    let pose = |index| rollout.pose(rollout.steps, index);
    bodies(scene, pose).add(body(&ball.body(), pose(scene.bodies.len()), false))
}

fn bodies(scene: &Scene, pose: impl Fn(usize) -> Option<Pose>) -> Group {
    let drawn = scene.bodies.iter().enumerate().map(|(index, one)| body(one, pose(index), index == scene.body2));
    drawn.fold(Group::new(), Group::add)
}

/// Returns the action ball.
pub fn ball(ball: Ball) -> Group {
    body(&ball.body(), None, false)
}

/// Returns the outline of the action ball.
pub fn ball_outline(ball: Ball) -> Group {
    let circle = Circle::new().set("cx", px(ball.x)).set("cy", px(ball.y)).set("r", px(ball.r)).set("fill", "none");
    Group::new().add(circle.set("stroke", palette(false).ink).set("stroke-width", 2))
}

fn body(body: &Body, pose: Option<Pose>, goal: bool) -> Group {
    let colours = palette(false);
    let [x, y, angle] = pose.map_or([body.x, body.y, body.angle], |pose| pose.map(f64::from)).map(px3);
    let degrees = px(angle.to_degrees());
    let turned = if degrees == 0.0 { String::new() } else { format!(" rotate({degrees})") };
    let group = Group::new().set("transform", format!("translate({} {}){turned}", px(x), px(y)));
    let filled = group.add(outline(body).set("fill", colours.role(body.role)));
    let filled = if goal { filled.add(outline(body).set("fill", "url(#hatch)")) } else { filled };
    let paper = |shape: Circle| shape.set("fill", colours.paper);
    match (body.role, body.ball_radius()) {
        (Role::Green, Some(radius)) => {
            filled.add(paper(Circle::new()).set("cx", px(0.4 * radius)).set("r", px((0.26 * radius).max(1.6))))
        }
        (Role::Green, None) => filled.add(paper(Circle::new()).set("r", 1.7)),
        (Role::Red | Role::Gray | Role::Blue, Some(radius)) => {
            let spoke = Line::new().set("x1", px(0.35 * radius)).set("x2", px(0.75 * radius));
            let spoke = spoke.set("stroke", colours.paper).set("stroke-opacity", 0.75).set("stroke-linecap", "round");
            filled.add(spoke.set("stroke-width", px((0.12 * radius).max(0.8))))
        }
        _ => filled,
    }
}

/// Rounds to a thousandth: for an angle, less than a tenth of a degree.
fn px3(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0
}

fn outline(body: &Body) -> Path {
    let data = body.shapes.iter().fold(Data::new(), |data, shape| match shape {
        &Shape::Circle(radius) => {
            let r = px(radius);
            let half = |data: Data, x: f64| data.elliptical_arc_to((r, r, 0, 1, 1, x, 0));
            half(half(data.move_to((r, 0)), -r), r).close()
        }
        Shape::Polygon(corners) => {
            let mut corners = corners.iter().map(|&[x, y]| (px(x), px(y)));
            let first = corners.next().unwrap_or_default();
            corners.fold(data.move_to(first), Data::line_to).close()
        }
    });
    Path::new().set("d", data)
}

/// Returns the positions of a body during a rollout.
pub fn positions(rollout: &Rollout, body: usize) -> Vec<[f64; 2]> {
    let steps = (0..rollout.steps).step_by(STRIDE).chain([rollout.steps]);
    steps.filter_map(|step| rollout.pose(step, body)).map(|[x, y, _]| [x.into(), y.into()]).collect()
}

/// Returns a path through these points in the colour of a role, with a rim that keeps it visible on a body of the same
/// colour.
pub fn path(points: &[[f64; 2]], role: Role, style: LineStyle) -> Group {
    let mut rounded: Vec<(f64, f64)> = points.iter().map(|&[x, y]| (tenth(x), tenth(y))).collect();
    rounded.dedup();
    let Some((&first, rest)) = rounded.split_first() else { return Group::new() };
    let data = rest.iter().fold(Data::new().move_to(first), |data, &point| data.line_to(point));
    let (width, rim) = PATH;
    let stroke = |colour: &str, width: f64| {
        let path = Path::new().set("d", data.clone()).set("stroke", colour).set("stroke-width", px(width));
        path.set("stroke-linejoin", "round").set("stroke-linecap", "round")
    };
    let colours = palette(false);
    let coloured = stroke(colours.role(role), width);
    let coloured = match style {
        LineStyle::Real => coloured,
        // Round caps turn each dash into a dot.
        LineStyle::Imagined => coloured.set("stroke-dasharray", "0.1 5.4"),
    };
    let rim = stroke(colours.paper, width + 2.0 * rim).set("stroke-opacity", 0.75);
    Group::new().set("fill", "none").add(rim).add(coloured)
}

fn tenth(value: f64) -> f64 {
    (value * 10.0).round() / 10.0 + 0.0
}

/// Returns a map over the whole scene; the colour scale runs from 0, transparent, to `max`. All cells of a level share
/// one path, which is no larger than a base64 PNG and sharp at any size.
pub fn map(which: ImaginedMap, values: &[f32], max: f32) -> Group {
    let level = |value: f32| {
        (value / max.max(f32::MIN_POSITIVE) * f32::from(LEVELS)).round().clamp(0.0, f32::from(LEVELS)) as u8
    };
    let mut paths: BTreeMap<u8, Data> = BTreeMap::new();
    for (row, cells) in values.chunks(SIDE).enumerate() {
        let mut column = 0;
        for run in cells.chunk_by(|&one, &other| level(one) == level(other)) {
            if level(run[0]) > 0 {
                let data = paths.remove(&level(run[0])).unwrap_or_default();
                let data = data.move_to((column, row)).horizontal_line_by(run.len()).vertical_line_by(1);
                paths.insert(level(run[0]), data.horizontal_line_by(-(run.len() as f32)).close());
            }
            column += run.len();
        }
    }
    // Leave no seam between neighbouring cells.
    let group = Group::new().set("transform", format!("scale({PX_PER_CELL})")).set("shape-rendering", "crispEdges");
    paths.into_iter().fold(group.set("class", "map"), |group, (level, data)| {
        let [r, g, b, opacity] = which.colour(f32::from(level) / f32::from(LEVELS), false);
        let path = Path::new().set("d", data).set("fill", format!("#{r:02x}{g:02x}{b:02x}"));
        group.add(path.set("fill-opacity", px(f64::from(opacity) / 255.0)))
    })
}

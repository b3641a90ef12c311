//! One frame of the page: the order in which its layers are drawn.
//!
//! From the bottom: ribbons, static bodies, maps, imagined paths, paths, dynamic bodies, balls, ghosts, the spark,
//! marks, the sketch, and the ring or the knob. Used by `game_view` and `custom_scene`; `paint`, `ribbon` and `marks`
//! do the drawing.

use serde::Deserialize;
use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use super::imagined_paths::{Hint, ImaginedPaths};
use super::marks::NAME_HEIGHT;
use super::paint::{LineStyle, Painter, bounding_radius};
use super::recording::Recording;
use crate::puzzle::action::Ball;
use crate::puzzle::rollout::GOAL_STEPS;
use crate::puzzle::scene::{Role, Scene};
use crate::session::ending::touch_streak;

/// Opacity of the static bodies that are drawn again over the maps, 0..=1.
const STATIC_OPACITY: f64 = 0.6;

/// How far poses of a body are apart that lies elsewhere: x and y, px, and the angle, radians.
const APART: [f32; 3] = [1.0, 1.0, 0.03];

/// How long a spark is seen, steps.
const SPARK_STEPS: f64 = 20.0;

/// What a frame shows.
#[derive(Deserialize)]
pub(crate) struct View {
    /// Steps since the start; a fraction lies between two steps.
    step: f64,
    /// The ball being placed.
    ball: Option<Ball>,
    /// Whether that ball may be placed there.
    valid: bool,
    /// The radius of the knob on that ball, px; 0 draws none.
    knob: f64,
    /// Draws whole paths and not only up to the step.
    whole: bool,
    /// Opacity of the maps, 0..=1.
    opacity: f64,
    dark: bool,
    /// The balls of other attempts.
    #[serde(default)]
    marks: Vec<Mark>,
    /// What a person has drawn as the path of the green object, px.
    #[serde(default)]
    sketch: Vec<[f64; 2]>,
    /// What the model imagines for a ball.
    #[serde(default)]
    imagined: Option<ImaginedPaths>,
    #[serde(default)]
    hints: Vec<Hint>,
    /// Where the first rollout came nearest to the goal.
    #[serde(default)]
    approach: Option<Approach>,
    /// A contact that sparks.
    #[serde(default)]
    spark: Option<Spark>,
    /// Whose ball is whose, beside the balls of the recordings in order.
    #[serde(default)]
    names: Vec<String>,
}

/// A contact that sparks for a moment after its step.
#[derive(Deserialize)]
struct Spark {
    step: f64,
    point: [f64; 2],
}

/// A closest approach that is shown: how object and goal lay, and the gap between them.
#[derive(Deserialize)]
struct Approach {
    step: f64,
    points: [[f64; 2]; 2],
}

/// A ball that is only marked.
#[derive(Deserialize)]
struct Mark {
    ball: Ball,
    /// The place that it comes from, px.
    from: Option<[f64; 2]>,
    /// Whether it is the selected one.
    chosen: bool,
}

impl View {
    /// A view of the end of the current recordings: every body in its last pose, whole paths.
    pub(crate) fn ended(dark: bool) -> View {
        View {
            step: f64::INFINITY,
            ball: None,
            valid: true,
            knob: 0.0,
            whole: true,
            opacity: 0.0,
            dark,
            marks: Vec::new(),
            sketch: Vec::new(),
            imagined: None,
            hints: Vec::new(),
            approach: None,
            spark: None,
            names: Vec::new(),
        }
    }

    /// This view of another scene, in which the ball may or may not be placed.
    pub(crate) fn checked_in(self, scene: &Scene) -> View {
        View { valid: self.ball.is_none_or(|ball| ball.check(scene).is_ok()), ..self }
    }
}

/// Draws a frame: the first of `recordings` with its bodies, the others as outlines over it.
pub(crate) fn paint(
    context: &CanvasRenderingContext2d,
    scene: &Scene,
    recordings: &[Recording],
    view: &View,
    maps: &[HtmlCanvasElement],
) -> Result<(), JsValue> {
    let painter = Painter::new(context, view.dark)?;
    let first = recordings.first();
    let bodies = |dynamic| {
        let mut bodies = scene.bodies.iter().enumerate().filter(|(_, body)| body.dynamic == dynamic);
        bodies.try_for_each(|(index, body)| {
            let pose = first.and_then(|recording| recording.pose(view.step, index));
            painter.body(body, pose, index == scene.body2)
        })
    };
    // Over a rollout, ribbons and ghosts would hide what really happens.
    let placing = view.imagined.as_ref().filter(|_| first.is_none());
    if let Some(imagined) = placing {
        painter.ribbons(scene, imagined)?;
    }
    bodies(false)?;
    for map in maps {
        painter.overlay(map, view.opacity)?;
    }
    if !maps.is_empty() {
        painter.set_alpha(STATIC_OPACITY);
        bodies(false)?;
        painter.set_alpha(1.0);
    }
    view.hints.iter().try_for_each(|hint| painter.hint(scene, hint))?;
    if let Some(imagined) = &view.imagined {
        painter.imagined_paths(scene, imagined)?;
    }
    let until = if view.whole { f64::INFINITY } else { view.step };
    for recording in recordings {
        if recording.of_model {
            painter.model_path(recording.path(until, scene.body1))?;
            painter.model_path(recording.path(until, scene.bodies.len()))?;
        }
        painter.path(recording.path(until, scene.body1), Role::Green, recording.line_style)?;
        painter.path(recording.path(until, scene.bodies.len()), Role::Red, recording.line_style)?;
    }
    bodies(true)?;
    for (index, recording) in recordings.iter().enumerate() {
        if index > 0 && recording.of_model {
            draw_moved_bodies(&painter, scene, recording, &recordings[0], view.step)?;
        }
        draw_ball(&painter, scene, recording, view.step, index > 0)?;
    }
    for (index, (recording, name)) in recordings.iter().zip(&view.names).enumerate() {
        if let (Some(ball), Some([x, y, _])) = (recording.ball, recording.pose(view.step, scene.bodies.len())) {
            // Above the first ball and below the second, so that names of balls at one place are both read.
            let away = if index == 0 { ball.r } else { -ball.r - NAME_HEIGHT };
            painter.name(name, [x.into(), f64::from(y) + away])?;
        }
    }
    if let (Some(recording), Some(approach)) = (first, &view.approach) {
        draw_approach(&painter, scene, recording, approach)?;
    }
    if let Some(imagined) = placing {
        painter.ghosts(scene, imagined)?;
    }
    if let Some(Spark { step, point }) = view.spark {
        painter.spark(point, (view.step - step) / SPARK_STEPS)?;
    }
    for mark in &view.marks {
        painter.mark(mark.ball, mark.from, mark.chosen)?;
    }
    if !view.sketch.is_empty() {
        painter.sketch(&view.sketch)?;
    }
    match first {
        Some(recording) => draw_ring(&painter, scene, recording, view.step),
        None => draw_placed_ball(&painter, view),
    }
}

/// Draws the ball of one rollout; with `outlined`, the outlines of the ball and of the green object instead.
fn draw_ball(
    painter: &Painter,
    scene: &Scene,
    recording: &Recording,
    step: f64,
    outlined: bool,
) -> Result<(), JsValue> {
    if outlined
        && !recording.of_model
        && let Some(pose) = recording.pose(step, scene.body1)
    {
        painter.outline(&scene.bodies[scene.body1], pose, recording.line_style)?;
    }
    let (Some(ball), Some(pose)) = (recording.ball, recording.pose(step, scene.bodies.len())) else {
        return Ok(());
    };
    let [x, y, angle] = pose.map(f64::from);
    if recording.of_model {
        painter.model_rim([x, y], ball.r)?;
    }
    if outlined {
        painter.outline(&ball.body(), pose, recording.line_style)
    } else {
        painter.ball(Ball { x, y, ..ball }, angle, true)
    }
}

/// Draws the bodies that the model's rollout has moved elsewhere than the rollout under it, as ghosts.
fn draw_moved_bodies(
    painter: &Painter,
    scene: &Scene,
    of_model: &Recording,
    under: &Recording,
    step: f64,
) -> Result<(), JsValue> {
    for (index, body) in scene.bodies.iter().enumerate() {
        if let (Some(pose), Some(below)) = (of_model.pose(step, index), under.pose(step, index))
            && pose.iter().zip(below).zip(APART).any(|((one, other), apart)| (one - other).abs() > apart)
        {
            painter.ghost_body(body, pose)?;
        }
    }
    Ok(())
}

/// Draws the outlines of object and goal where they came nearest, and the gap between them.
fn draw_approach(painter: &Painter, scene: &Scene, recording: &Recording, approach: &Approach) -> Result<(), JsValue> {
    for index in [scene.body1, scene.body2] {
        if let Some(pose) = recording.pose(approach.step, index) {
            painter.outline(&scene.bodies[index], pose, LineStyle::Dotted)?;
        }
    }
    painter.gap(approach.points)
}

/// Draws the progress ring round the green object while it touches the goal.
fn draw_ring(painter: &Painter, scene: &Scene, recording: &Recording, step: f64) -> Result<(), JsValue> {
    let streak = touch_streak(&recording.rollout, step as usize);
    match recording.pose(step, scene.body1) {
        Some([x, y, _]) if streak > 0 => {
            // On the object also where the edge of the scene cuts the ring off.
            let radius = bounding_radius(&scene.bodies[scene.body1]).min(24.0) + 5.0;
            painter.ring([x.into(), y.into()], radius, streak as f64 / GOAL_STEPS as f64)
        }
        _ => Ok(()),
    }
}

/// Draws the ball being placed, with its knob.
fn draw_placed_ball(painter: &Painter, view: &View) -> Result<(), JsValue> {
    let Some(ball) = view.ball else { return Ok(()) };
    painter.ball(ball, 0.0, view.valid)?;
    if view.knob > 0.0 { painter.knob(ball, view.knob) } else { Ok(()) }
}

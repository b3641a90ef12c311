//! One frame of the page: what is drawn over what.
//!
//! From the bottom: what stands still, the maps, the paths, what moves, the balls, marks, what a person has drawn,
//! and the ring or the knob.
//! Used by `puzzle`; it decides nothing but the order, and `paint` does the drawing.

use serde::Deserialize;
use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use super::paint::{Painter, reach};
use super::recording::Take;
use crate::play::ending::touch_streak;
use crate::puzzle::action::Ball;
use crate::puzzle::rollout::GOAL_STEPS;
use crate::puzzle::scene::{Role, Scene};

/// How much of what stands still shows through the maps, 0..=1.
const THROUGH: f64 = 0.6;

/// What a frame shows.
#[derive(Deserialize)]
pub struct View {
    /// Steps since the start; may lie between two.
    step: f64,
    /// The ball being placed.
    ball: Option<Ball>,
    /// The radius of the knob on that ball, px; 0 draws none.
    knob: f64,
    /// Draws paths whole and not only up to the step.
    whole: bool,
    /// How much the maps cover, 0..=1.
    opacity: f64,
    dark: bool,
    /// The balls of other attempts, with where they come from.
    #[serde(default)]
    marks: Vec<Mark>,
    /// What a person has drawn as the path of the green object, px.
    #[serde(default)]
    sketch: Vec<[f64; 2]>,
}

/// A ball that is only marked.
#[derive(Deserialize)]
struct Mark {
    ball: Ball,
    /// The place that it comes from, px.
    from: Option<[f64; 2]>,
    /// Is it the one that is looked at?
    chosen: bool,
}

impl View {
    /// How what is shown has ended: everything in its last place, paths whole.
    pub fn ended(dark: bool) -> View {
        let (marks, sketch) = (Vec::new(), Vec::new());
        View { step: f64::INFINITY, ball: None, knob: 0.0, whole: true, opacity: 0.0, dark, marks, sketch }
    }
}

/// Draws a frame. `takes` are the rollouts being shown, the first with its bodies, a second as outlines over it.
pub fn paint(
    context: &CanvasRenderingContext2d,
    scene: &Scene,
    takes: &[Take],
    view: &View,
    maps: &[HtmlCanvasElement],
) -> Result<(), JsValue> {
    let painter = Painter::new(context, view.dark)?;
    let main = takes.first();
    let bodies = |dynamic| {
        let mut bodies = scene.bodies.iter().enumerate().filter(|(_, body)| body.dynamic == dynamic);
        bodies.try_for_each(|(index, body)| {
            let pose = main.and_then(|take| take.pose(view.step, index));
            painter.body(body, pose, index == scene.body2)
        })
    };
    bodies(false)?;
    for map in maps {
        painter.layer(map, view.opacity)?;
    }
    if !maps.is_empty() {
        painter.cover(THROUGH);
        bodies(false)?;
        painter.cover(1.0);
    }
    let until = if view.whole { f64::INFINITY } else { view.step };
    for take in takes {
        painter.path(take.path(until, scene.body1), Role::Green, take.line)?;
        painter.path(take.path(until, scene.bodies.len()), Role::Red, take.line)?;
    }
    bodies(true)?;
    for (place, take) in takes.iter().enumerate() {
        ball(&painter, scene, take, view.step, place > 0)?;
    }
    for mark in &view.marks {
        painter.mark(mark.ball, mark.from, mark.chosen)?;
    }
    if !view.sketch.is_empty() {
        painter.sketch(&view.sketch)?;
    }
    match main {
        Some(take) => ring(&painter, scene, take, view.step),
        None => placing(&painter, scene, view),
    }
}

/// The ball of one rollout; of one that is only laid over another, the green object too, both as outlines.
fn ball(painter: &Painter, scene: &Scene, take: &Take, step: f64, outlined: bool) -> Result<(), JsValue> {
    if outlined && let Some(pose) = take.pose(step, scene.body1) {
        painter.ghost(&scene.bodies[scene.body1], pose, take.line)?;
    }
    match (take.attempt, take.pose(step, scene.bodies.len())) {
        (Some((_, ball)), Some(pose)) if outlined => painter.ghost(&ball.body(), pose, take.line),
        (Some((_, ball)), Some([x, y, angle])) => {
            painter.ball(Ball { x: x.into(), y: y.into(), ..ball }, angle.into(), true)
        }
        _ => Ok(()),
    }
}

/// The ring round the green object while it touches the goal.
fn ring(painter: &Painter, scene: &Scene, take: &Take, step: f64) -> Result<(), JsValue> {
    let held = touch_streak(&take.rollout, step as usize);
    match take.pose(step, scene.body1) {
        Some([x, y, _]) if held > 0 => {
            let radius = reach(&scene.bodies[scene.body1]).min(24.0) + 5.0;
            painter.ring([x.into(), y.into()], radius, held as f64 / GOAL_STEPS as f64)
        }
        _ => Ok(()),
    }
}

/// The ball being placed, with its knob.
fn placing(painter: &Painter, scene: &Scene, view: &View) -> Result<(), JsValue> {
    let Some(ball) = view.ball else { return Ok(()) };
    painter.ball(ball, 0.0, ball.check(scene).is_ok())?;
    if view.knob > 0.0 { painter.handle(ball, view.knob) } else { Ok(()) }
}

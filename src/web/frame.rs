//! A frame: its content, and the order in which its layers are drawn. `paint`, `marks` and `imagined` do the drawing.
//!
//! From the bottom: ribbons, static bodies, maps, imagined paths, paths, dynamic bodies, balls, names, the closest
//! approach, ghosts, the spark, marks, the sketch, and the ring or the ball that is being placed.

use std::rc::Rc;

use serde::Deserialize;
use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use super::imagined::{Hint, Imagined};
use super::marks::NAME_HEIGHT;
use super::paint::{Line, Painter, bounding_radius};
use super::puzzle::{JsPuzzle, load};
use super::static_layer::StaticLayer;
use crate::puzzle::action::Ball;
use crate::puzzle::rollout::{GOAL_STEPS, Pose, Rollout};
use crate::puzzle::scene::{Role, Scene};
use crate::session::ending::touch_streak;
use crate::simulator::{ClosestApproach, Contact};

/// Opacity of the static bodies that are drawn again over the maps, 0..=1.
const STATIC_OPACITY: f64 = 0.6;

/// Difference from which two poses of a body count as apart: x and y, px, and the angle, radians.
const APART: [f32; 3] = [1.0, 1.0, 0.03];

/// Time for which a spark is visible, steps.
const SPARK_STEPS: f64 = 20.0;

/// The content of a frame; documented in `types.d.ts`.
#[derive(Default, Deserialize)]
#[serde(default)]
pub(crate) struct View {
    step: f64,
    pub ball: Option<Ball>,
    pub valid: bool,
    knob: f64,
    whole: bool,
    opacity: f64,
    dark: bool,
    marks: Vec<Ball>,
    sketch: Vec<[f64; 2]>,
    imagined: Option<Imagined>,
    hints: Vec<Hint>,
    approach: Option<ClosestApproach>,
    spark: Option<Contact>,
    names: Vec<String>,
}

/// A rollout to show.
pub(crate) struct Recording {
    /// `None` if the scene runs without a ball.
    pub ball: Option<Ball>,
    pub rollout: Rc<Rollout>,
    /// Whether the ball is the model's.
    pub of_model: bool,
}

impl Recording {
    /// Returns the pose of a dynamic body at a step. Fractional steps are interpolated, and the last step holds
    /// afterwards.
    fn pose(&self, step: f64, body: usize) -> Option<Pose> {
        let step = step.clamp(0.0, self.rollout.steps as f64);
        let before = self.rollout.pose(step.floor() as usize, body)?;
        let after = self.rollout.pose(step.ceil() as usize, body)?;
        let fraction = step.fract() as f32;
        Some(std::array::from_fn(|axis| before[axis] + fraction * (after[axis] - before[axis])))
    }

    /// Returns the path of a body's origin from the start to a step, px.
    fn path(&self, step: f64, body: usize) -> impl Iterator<Item = [f64; 2]> {
        let last = (step.max(0.0) as usize).min(self.rollout.steps);
        let points = (0..=last).filter_map(move |step| self.rollout.pose(step, body));
        points.map(|[x, y, _]| [x.into(), y.into()])
    }
}

/// Draws the scene of a puzzle to fill a square canvas.
#[wasm_bindgen(js_name = paintThumbnail)]
pub fn paint_thumbnail(context: &CanvasRenderingContext2d, puzzle: JsPuzzle, dark: bool) -> Result<(), JsValue> {
    paint(context, &load(&puzzle)?.scene, None, &[], &View { dark, ..View::default() }, &[])
}

/// Draws a frame: the first of `recordings` with its bodies, and any further ones as outlines over it. The context
/// keeps its settings, so the caller can draw more, in units of the canvas. `layer` has the static bodies of a scene
/// that is painted again and again.
pub(crate) fn paint(
    context: &CanvasRenderingContext2d,
    scene: &Scene,
    layer: Option<&StaticLayer>,
    recordings: &[Recording],
    view: &View,
    maps: &[HtmlCanvasElement],
) -> Result<(), JsValue> {
    context.save();
    let painted = Painter::new(context, view.dark)
        .and_then(|painter| Frame { painter: &painter, scene, layer, recordings, view }.paint(maps));
    context.restore();
    painted
}

struct Frame<'a> {
    painter: &'a Painter<'a>,
    scene: &'a Scene,
    layer: Option<&'a StaticLayer>,
    recordings: &'a [Recording],
    view: &'a View,
}

impl Frame<'_> {
    fn paint(&self, maps: &[HtmlCanvasElement]) -> Result<(), JsValue> {
        let &Frame { painter, scene, layer, recordings, view } = self;
        painter.background();
        let ball = scene.bodies.len();
        // Over a rollout, ribbons and ghosts would hide what really happens.
        let placing = view.imagined.as_ref().filter(|_| recordings.is_empty());
        if let Some(imagined) = placing {
            painter.ribbons(scene, imagined)?;
        }
        let statics = || match layer {
            Some(layer) => layer.draw(painter, scene),
            None => painter.bodies(scene, false, |_| None),
        };
        statics()?;
        for map in maps {
            painter.overlay(map, view.opacity)?;
        }
        if !maps.is_empty() {
            painter.faded(STATIC_OPACITY, statics)?;
        }
        view.hints.iter().try_for_each(|hint| painter.hint(scene, hint))?;
        if let Some(imagined) = &view.imagined {
            painter.imagined_paths(scene, imagined)?;
        }
        let until = if view.whole { f64::INFINITY } else { view.step };
        for recording in recordings {
            let paths = [(scene.body1, Role::Green), (ball, Role::Red)];
            if recording.of_model {
                paths.iter().try_for_each(|&(body, _)| painter.model_path(recording.path(until, body)))?;
            }
            paths.iter().try_for_each(|&(body, role)| painter.path(recording.path(until, body), role, Line::Solid))?;
        }
        let first = recordings.first();
        painter.bodies(scene, true, |index| first.and_then(|first| first.pose(view.step, index)))?;
        for (index, recording) in recordings.iter().enumerate() {
            self.ball(recording, index > 0)?;
        }
        let height = |index: usize| recordings.get(index)?.pose(view.step, ball).map(|[_, y, _]| y);
        let upper = usize::from(height(1) > height(0));
        for (index, (recording, name)) in recordings.iter().zip(&view.names).enumerate() {
            if let (Some(Ball { r, .. }), Some([x, y, _])) = (recording.ball, recording.pose(view.step, ball)) {
                // Above the upper ball and below the other, so that the names of close balls are both readable.
                let away = if index == upper { r } else { -r - NAME_HEIGHT };
                painter.name(name, [x.into(), f64::from(y) + away])?;
            }
        }
        if let (Some(recording), Some(approach)) = (recordings.first(), &view.approach) {
            for body in [scene.body1, scene.body2] {
                if let Some(pose) = recording.pose(approach.step as f64, body) {
                    let body = &scene.bodies[body];
                    painter.outline(body, pose, painter.palette.role(body.role), Line::Dotted)?;
                }
            }
            painter.gap(approach.points)?;
        }
        if let Some(imagined) = placing {
            painter.ghosts(scene, imagined)?;
        }
        if let Some(Contact { step, point }) = view.spark {
            painter.spark(point, (view.step - step as f64) / SPARK_STEPS)?;
        }
        view.marks.iter().try_for_each(|&mark| painter.mark(mark))?;
        painter.sketch(&view.sketch)?;
        match (recordings.first(), view.ball) {
            (Some(recording), _) => self.ring(recording),
            (None, Some(ball)) => {
                painter.ball(ball, 0.0, view.valid)?;
                if view.knob > 0.0 { painter.knob(ball, view.knob) } else { Ok(()) }
            }
            (None, None) => Ok(()),
        }
    }

    /// Draws the ball of a rollout. Over the first rollout, draws only its outline, with the bodies that lie elsewhere
    /// as ghosts.
    fn ball(&self, recording: &Recording, is_over: bool) -> Result<(), JsValue> {
        let Frame { painter, scene, view, .. } = self;
        for (index, body) in scene.bodies.iter().enumerate().filter(|_| is_over) {
            if let (Some(pose), Some(below)) =
                (recording.pose(view.step, index), self.recordings[0].pose(view.step, index))
                && pose.iter().zip(below).zip(APART).any(|((one, other), apart)| (one - other).abs() > apart)
            {
                painter.ghost_body(body, pose)?;
            }
        }
        let (Some(ball), Some(pose)) = (recording.ball, recording.pose(view.step, scene.bodies.len())) else {
            return Ok(());
        };
        let [x, y, angle] = pose.map(f64::from);
        if recording.of_model {
            painter.model_rim([x, y], ball.r)?;
        }
        if is_over {
            painter.outline(&ball.body(), pose, painter.palette.red, Line::Solid)
        } else {
            painter.ball(Ball { x, y, ..ball }, angle, true)
        }
    }

    /// Draws the progress ring around the green object while it touches the goal.
    fn ring(&self, recording: &Recording) -> Result<(), JsValue> {
        let streak = touch_streak(&recording.rollout, self.view.step as usize);
        match recording.pose(self.view.step, self.scene.body1) {
            Some([x, y, _]) if streak > 0 => {
                // Capped, so that the ring lies on the object even where the edge of the scene cuts it off.
                let radius = bounding_radius(&self.scene.bodies[self.scene.body1]).min(24.0) + 5.0;
                self.painter.ring([x.into(), y.into()], radius, streak as f64 / GOAL_STEPS as f64)
            }
            _ => Ok(()),
        }
    }
}

//! Marks on top of a scene: other balls, names, contacts and gaps, and drawings by people.

use std::f64::consts::TAU;

use wasm_bindgen::prelude::*;

use super::paint::{Line, Painter};
use crate::puzzle::action::Ball;
use crate::puzzle::rollout::Pose;
use crate::puzzle::scene::{Body, SIZE};

/// Rays of a spark.
const RAYS: u32 = 8;

/// Width and opacity of the band under a path of the model, and width of the rim around its ball, px.
const MODEL_BAND: (f64, f64) = (6.0, 0.35);
const MODEL_RIM: f64 = 3.0;

/// Opacity of a body that the model has moved, 0..=1.
const GHOST_BODY_OPACITY: f64 = 0.3;

/// Height of a name, px of the scene.
pub(super) const NAME_HEIGHT: f64 = 9.0;

impl Painter<'_> {
    /// Marks a ball with a small ring.
    pub(crate) fn mark(&self, ball: Ball) -> Result<(), JsValue> {
        self.circle([ball.x, ball.y], 2.2)?;
        self.stroke(self.palette.paper, 2.2, Line::Solid)?;
        self.stroke(self.palette.ink, 0.9, Line::Solid)
    }

    /// Marks a path of the model with a band in the model's colour; the path itself is drawn on top.
    pub(crate) fn model_path(&self, points: impl Iterator<Item = [f64; 2]>) -> Result<(), JsValue> {
        let (width, opacity) = MODEL_BAND;
        self.lines(points);
        self.faded(opacity, || self.stroke(self.palette.model, width, Line::Solid))
    }

    /// Marks the model's ball with a rim in the model's colour.
    pub(crate) fn model_rim(&self, place: [f64; 2], radius: f64) -> Result<(), JsValue> {
        self.circle(place, radius + MODEL_RIM / 2.0)?;
        self.stroke(self.palette.model, MODEL_RIM, Line::Solid)
    }

    /// Draws a body at the pose to which the model's rollout has moved it: pale, with a rim in the model's colour.
    pub(crate) fn ghost_body(&self, body: &Body, pose: Pose) -> Result<(), JsValue> {
        self.faded(GHOST_BODY_OPACITY, || self.body(body, Some(pose), false))?;
        self.outline(body, pose, self.palette.model, Line::Solid)
    }

    /// Draws the gap between two points: a line with a dot at either end.
    pub(crate) fn gap(&self, points: [[f64; 2]; 2]) -> Result<(), JsValue> {
        for (colour, width, radius) in [(self.palette.paper, 3.4, 2.8), (self.palette.ink, 1.4, 1.9)] {
            self.lines(points);
            self.stroke(colour, width, Line::Solid)?;
            points.into_iter().try_for_each(|point| self.disc(point, radius, colour))?;
        }
        Ok(())
    }

    /// Writes a name at a point, keeping it inside the scene.
    pub(crate) fn name(&self, name: &str, [x, y]: [f64; 2]) -> Result<(), JsValue> {
        let context = self.context;
        context.set_font(&format!("600 {}px system-ui, sans-serif", NAME_HEIGHT * self.scale));
        context.set_text_align("center");
        let half = context.measure_text(name)?.width() / 2.0 / self.scale;
        let x = x.clamp(half + 2.0, (SIZE - half - 2.0).max(half + 2.0));
        let y = (y + NAME_HEIGHT / 3.0).clamp(NAME_HEIGHT / 3.0, SIZE - NAME_HEIGHT);
        // The scene's y points up, which would turn text upside down.
        context.set_transform(1.0, 0.0, 0.0, 1.0, x * self.scale, (SIZE - y) * self.scale)?;
        self.set_stroke(self.palette.paper, 3.0 * self.scale, Line::Solid)?;
        context.stroke_text(name, 0.0, 0.0)?;
        context.set_fill_style_str(self.palette.ink);
        context.fill_text(name, 0.0, 0.0)?;
        self.set_scene_units()
    }

    /// Draws the spark of a contact at a point: rays that fly apart. `fraction` is the elapsed part of its time, 0..=1.
    pub(crate) fn spark(&self, [x, y]: [f64; 2], fraction: f64) -> Result<(), JsValue> {
        if !(0.0..=1.0).contains(&fraction) {
            return Ok(());
        }
        self.context.begin_path();
        for ray in 0..RAYS {
            let (sin, cos) = (TAU * f64::from(ray) / f64::from(RAYS)).sin_cos();
            let [inner, outer] = [2.0 + 12.0 * fraction, 5.0 + 17.0 * fraction.sqrt()];
            self.context.move_to(x + inner * cos, y + inner * sin);
            self.context.line_to(x + outer * cos, y + outer * sin);
        }
        self.faded(2.0 - 2.0 * fraction, || {
            self.stroke(self.palette.ink, 3.2, Line::Solid)?;
            self.stroke(self.palette.ring, 1.8, Line::Solid)
        })
    }

    /// Draws the path that a person has drawn, with a dot at its end.
    pub(crate) fn sketch(&self, points: &[[f64; 2]]) -> Result<(), JsValue> {
        let Some(&end) = points.last() else { return Ok(()) };
        self.lines(points.iter().copied());
        self.stroke(self.palette.ink, 2.0, Line::Dotted)?;
        self.disc(end, 3.0, self.palette.ink)
    }
}

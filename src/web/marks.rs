//! Marks on top of a scene: the balls of other attempts, and the path that a person has drawn.

use std::f64::consts::TAU;

use wasm_bindgen::prelude::*;

use super::paint::{LineStyle, Painter};
use crate::puzzle::action::Ball;
use crate::puzzle::rollout::Pose;
use crate::puzzle::scene::{Body, Role, SIZE};

/// Of a spark.
const RAYS: u32 = 8;

/// Width and opacity of the band under a path of the model's, and width of the rim round its ball, px.
const MODEL_BAND: (f64, f64) = (6.0, 0.35);
const MODEL_RIM: f64 = 3.0;

/// Of a body that the model has moved, 0..=1.
const GHOST_BODY_OPACITY: f64 = 0.3;

/// px of the scene
pub(super) const NAME_HEIGHT: f64 = 9.0;

impl Painter<'_> {
    /// Marks the ball of another attempt with a small ring; the selected one also with its rim and a line from the
    /// place that it comes from.
    pub(crate) fn mark(&self, ball: Ball, from: Option<[f64; 2]>, chosen: bool) -> Result<(), JsValue> {
        let context = self.context;
        let circle = |radius: f64, colour: &str, width: f64, style| {
            context.begin_path();
            context.arc(ball.x, ball.y, radius, 0.0, TAU)?;
            self.set_stroke(colour, width, style)?;
            context.stroke();
            Ok::<(), JsValue>(())
        };
        circle(2.2, self.palette.paper, 2.2, LineStyle::Solid)?;
        circle(2.2, self.palette.ink, 0.9, LineStyle::Solid)?;
        if !chosen {
            return Ok(());
        }
        circle(ball.r, self.palette.ink, 1.6, LineStyle::Dashed)?;
        if let Some([x, y]) = from {
            self.path([[x, y], [ball.x, ball.y]].into_iter(), Role::Red, LineStyle::Solid)?;
            context.set_fill_style_str(self.palette.ink);
            context.fill_rect(x - 2.2, y - 2.2, 4.4, 4.4);
        }
        Ok(())
    }

    /// Marks a path of the model's with a band in its colour, on which the path itself is drawn.
    pub(crate) fn model_path(&self, points: impl Iterator<Item = [f64; 2]>) -> Result<(), JsValue> {
        let (width, opacity) = MODEL_BAND;
        self.context.begin_path();
        points.for_each(|[x, y]| self.context.line_to(x, y));
        self.set_stroke(self.palette.model, width, LineStyle::Solid)?;
        self.set_alpha(opacity);
        self.context.stroke();
        self.set_alpha(1.0);
        Ok(())
    }

    /// Marks the model's ball with a rim in its colour.
    pub(crate) fn model_rim(&self, [x, y]: [f64; 2], radius: f64) -> Result<(), JsValue> {
        self.context.begin_path();
        self.context.arc(x, y, radius + MODEL_RIM / 2.0, 0.0, TAU)?;
        self.set_stroke(self.palette.model, MODEL_RIM, LineStyle::Solid)?;
        self.context.stroke();
        Ok(())
    }

    /// Draws a body where the model's rollout has moved it: pale, with a rim in the model's colour.
    pub(crate) fn ghost_body(&self, body: &Body, pose: Pose) -> Result<(), JsValue> {
        self.set_alpha(GHOST_BODY_OPACITY);
        self.body(body, Some(pose), false)?;
        self.set_alpha(1.0);
        self.outline_in(self.palette.model, body, pose, LineStyle::Solid)
    }

    /// Draws the gap between two points: a line with a dot at either end.
    pub(crate) fn gap(&self, points: [[f64; 2]; 2]) -> Result<(), JsValue> {
        let context = self.context;
        for (colour, width, radius) in [(self.palette.paper, 3.4, 2.8), (self.palette.ink, 1.4, 1.9)] {
            context.begin_path();
            points.iter().for_each(|&[x, y]| context.line_to(x, y));
            self.set_stroke(colour, width, LineStyle::Solid)?;
            context.stroke();
            context.set_fill_style_str(colour);
            for [x, y] in points {
                context.begin_path();
                context.arc(x, y, radius, 0.0, TAU)?;
                context.fill();
            }
        }
        Ok(())
    }

    /// Writes a name at a point, inside of the scene.
    pub(crate) fn name(&self, name: &str, [x, y]: [f64; 2]) -> Result<(), JsValue> {
        let context = self.context;
        context.set_font(&format!("600 {}px system-ui, sans-serif", NAME_HEIGHT * self.scale));
        context.set_text_align("center");
        let half = context.measure_text(name)?.width() / 2.0 / self.scale;
        let x = x.clamp(half + 2.0, (SIZE - half - 2.0).max(half + 2.0));
        let y = (y + NAME_HEIGHT / 3.0).clamp(NAME_HEIGHT / 3.0, SIZE - NAME_HEIGHT);
        // The scene's y points up; text would stand on its head.
        context.set_transform(1.0, 0.0, 0.0, 1.0, x * self.scale, (SIZE - y) * self.scale)?;
        self.set_stroke(self.palette.paper, 3.0 * self.scale, LineStyle::Solid)?;
        context.stroke_text(name, 0.0, 0.0)?;
        context.set_fill_style_str(self.palette.ink);
        context.fill_text(name, 0.0, 0.0)?;
        self.set_scene_units()
    }

    /// Draws the spark of a contact at a point: rays that fly apart, over a fraction of its time, 0..=1.
    pub(crate) fn spark(&self, [x, y]: [f64; 2], fraction: f64) -> Result<(), JsValue> {
        if !(0.0..=1.0).contains(&fraction) {
            return Ok(());
        }
        self.set_alpha((2.0 - 2.0 * fraction).min(1.0));
        for (colour, width) in [(self.palette.ink, 3.2), (self.palette.ring, 1.8)] {
            self.context.begin_path();
            for ray in 0..RAYS {
                let (sin, cos) = (TAU * f64::from(ray) / f64::from(RAYS)).sin_cos();
                let [inner, outer] = [2.0 + 12.0 * fraction, 5.0 + 17.0 * fraction.sqrt()];
                self.context.move_to(x + inner * cos, y + inner * sin);
                self.context.line_to(x + outer * cos, y + outer * sin);
            }
            self.set_stroke(colour, width, LineStyle::Solid)?;
            self.context.stroke();
        }
        self.set_alpha(1.0);
        Ok(())
    }

    /// Draws the path that a person has drawn, with a dot at its end.
    pub(crate) fn sketch(&self, points: &[[f64; 2]]) -> Result<(), JsValue> {
        self.path(points.iter().copied(), Role::Green, LineStyle::Dotted)?;
        let Some(&[x, y]) = points.last() else { return Ok(()) };
        self.context.begin_path();
        self.context.arc(x, y, 3.0, 0.0, TAU)?;
        self.context.set_fill_style_str(self.palette.ink);
        self.context.fill();
        Ok(())
    }
}

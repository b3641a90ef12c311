//! Draws scenes, balls, paths, rings and overlaid maps on a canvas.
//!
//! A `Painter` transforms the canvas so that one unit is one px of the scene, origin bottom left, y up, at any
//! resolution of the canvas; then each call draws one thing. It must not depend on attempts or on time.

use std::f64::consts::TAU;

use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement, Path2d};

use super::error::{Code, error};
use crate::colour::palette::{Palette, palette};
use crate::puzzle::action::Ball;
use crate::puzzle::rollout::Pose;
use crate::puzzle::scene::{Body, Role, SIZE, Shape};

/// Distance between the lines of a hatched goal, px.
const HATCH_SPACING: f64 = 4.5;

/// Width of those lines, px.
const HATCH_WIDTH: f64 = 1.2;

/// Largest radius that is hatched, px. Bodies that may be played are smaller, but the editor also draws others.
const MAX_HATCHED_RADIUS: f64 = 512.0;

/// Width of the rim of black bodies, px.
const RIM_WIDTH: f64 = 1.0;

/// Width of a path, px.
const PATH_WIDTH: f64 = 1.6;

/// Minimum width of a path, pixels of the canvas: `PATH_WIDTH` is hardly visible in a thumbnail.
const MIN_PATH_PIXELS: f64 = 1.2;

pub(crate) struct Painter<'a> {
    pub(super) context: &'a CanvasRenderingContext2d,
    pub(super) palette: &'static Palette,
    /// Canvas pixels per px of the scene.
    pub(super) scale: f64,
}

/// Line style: solid for the player, dashed for the model, dotted for what is imagined.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum LineStyle {
    Solid,
    Dashed,
    Dotted,
}

impl<'a> Painter<'a> {
    /// Fills the whole canvas with the colour of the paper and sets the scene's units.
    pub(crate) fn new(context: &'a CanvasRenderingContext2d, dark: bool) -> Result<Painter<'a>, JsValue> {
        let canvas = context.canvas().ok_or_else(|| error(Code::BadData, "the context has no canvas"))?;
        let side = f64::from(canvas.width());
        let painter = Painter { context, palette: palette(dark), scale: side / SIZE };
        context.set_transform(1.0, 0.0, 0.0, 1.0, 0.0, 0.0)?;
        context.set_global_alpha(1.0);
        context.set_fill_style_str(painter.palette.paper);
        context.fill_rect(0.0, 0.0, side, f64::from(canvas.height()));
        painter.set_scene_units()?;
        context.set_line_join("round");
        context.set_line_cap("round");
        Ok(painter)
    }

    /// Sets the opacity of the next bodies, 0..=1.
    pub(crate) fn set_alpha(&self, alpha: f64) {
        self.context.set_global_alpha(alpha);
    }

    /// Draws a body in the colour of its role, at a pose or where the scene has it. A goal is hatched, the green object
    /// dotted.
    pub(crate) fn body(&self, body: &Body, pose: Option<Pose>, goal: bool) -> Result<(), JsValue> {
        let [x, y, angle] = pose.map_or([body.x, body.y, body.angle], |pose| pose.map(f64::from));
        let context = self.context;
        let outline = body_path(body)?;
        context.save();
        context.translate(x, y)?;
        context.rotate(angle)?;
        context.set_fill_style_str(self.palette.role(body.role));
        context.fill_with_path_2d(&outline);
        if body.role == Role::Black {
            self.set_stroke(self.palette.rim, RIM_WIDTH, LineStyle::Solid)?;
            context.stroke_with_path(&outline);
        }
        if goal {
            self.hatch(body, &outline)?;
        }
        if let (Role::Gray | Role::Blue, Some(radius)) = (body.role, body.ball_radius()) {
            self.spoke(radius)?;
        }
        if body.role == Role::Green {
            self.dot(body)?;
        }
        context.restore();
        Ok(())
    }

    /// Draws the outline of a body at a pose.
    pub(crate) fn outline(&self, body: &Body, pose: Pose, style: LineStyle) -> Result<(), JsValue> {
        self.outline_in(self.palette.role(body.role), body, pose, style)
    }

    /// Draws the outline of a body at a pose in a colour.
    pub(super) fn outline_in(&self, colour: &str, body: &Body, pose: Pose, style: LineStyle) -> Result<(), JsValue> {
        let [x, y, angle] = pose.map(f64::from);
        self.context.save();
        self.context.translate(x, y)?;
        self.context.rotate(angle)?;
        self.set_stroke(colour, 1.4, style)?;
        self.context.stroke_with_path(&body_path(body)?);
        self.context.restore();
        Ok(())
    }

    /// Draws the action ball; an invalid one is only outlined.
    pub(crate) fn ball(&self, ball: Ball, angle: f64, valid: bool) -> Result<(), JsValue> {
        let context = self.context;
        context.save();
        context.translate(ball.x, ball.y)?;
        context.rotate(angle)?;
        context.begin_path();
        context.arc(0.0, 0.0, ball.r, 0.0, TAU)?;
        context.set_fill_style_str(self.palette.red);
        context.set_global_alpha(if valid { 1.0 } else { 0.3 });
        context.fill();
        context.set_global_alpha(1.0);
        if valid {
            self.spoke(ball.r)?;
        } else {
            self.set_stroke(self.palette.red, 2.0, LineStyle::Dashed)?;
            context.stroke();
            // A bar across it marks it without colour too.
            let half = ball.r * 0.7;
            context.begin_path();
            context.move_to(-half, half);
            context.line_to(half, -half);
            self.set_stroke(self.palette.ink, 1.5, LineStyle::Solid)?;
            context.stroke();
        }
        context.restore();
        Ok(())
    }

    /// Draws the knob that changes the radius of the ball, at its right.
    pub(crate) fn knob(&self, ball: Ball, radius: f64) -> Result<(), JsValue> {
        self.context.begin_path();
        self.context.arc(ball.x + ball.r, ball.y, radius, 0.0, TAU)?;
        self.context.set_fill_style_str(self.palette.paper);
        self.context.fill();
        self.set_stroke(self.palette.ink, 1.0, LineStyle::Solid)?;
        self.context.stroke();
        Ok(())
    }

    /// Draws a path through points of the scene, px.
    pub(crate) fn path(
        &self,
        points: impl Iterator<Item = [f64; 2]>,
        role: Role,
        style: LineStyle,
    ) -> Result<(), JsValue> {
        self.context.begin_path();
        for [x, y] in points {
            self.context.line_to(x, y);
        }
        let width = PATH_WIDTH.max(MIN_PATH_PIXELS / self.scale);
        // A rim in the colour of the paper keeps the path visible where it crosses a body of its own colour.
        self.set_stroke(self.palette.paper, width + 1.4, LineStyle::Solid)?;
        self.context.set_global_alpha(0.7);
        self.context.stroke();
        self.context.set_global_alpha(1.0);
        self.set_stroke(self.palette.role(role), width, style)?;
        self.context.stroke();
        Ok(())
    }

    /// Draws a progress ring round a point, filled to a fraction clockwise from the top.
    pub(crate) fn ring(&self, [x, y]: [f64; 2], radius: f64, fraction: f64) -> Result<(), JsValue> {
        let top = TAU / 4.0;
        for (colour, width, fraction) in [(self.palette.ink, 5.0, 1.0), (self.palette.ring, 3.4, fraction)] {
            self.context.begin_path();
            self.context.arc_with_anticlockwise(x, y, radius, top, top - TAU * fraction, true)?;
            self.set_stroke(colour, width, LineStyle::Solid)?;
            self.context.stroke();
        }
        Ok(())
    }

    /// Draws the canvas of a map over the whole scene.
    pub(crate) fn overlay(&self, map: &HtmlCanvasElement, opacity: f64) -> Result<(), JsValue> {
        let side = self.scale * SIZE;
        self.context.set_transform(1.0, 0.0, 0.0, 1.0, 0.0, 0.0)?;
        self.context.set_global_alpha(opacity.clamp(0.0, 1.0));
        self.context.draw_image_with_html_canvas_element_and_dw_and_dh(map, 0.0, 0.0, side, side)?;
        self.context.set_global_alpha(1.0);
        self.set_scene_units()
    }

    pub(super) fn set_scene_units(&self) -> Result<(), JsValue> {
        self.context.set_transform(self.scale, 0.0, 0.0, -self.scale, 0.0, self.scale * SIZE)
    }

    /// Sets colour, width (px) and style of the next strokes.
    pub(super) fn set_stroke(&self, colour: &str, width: f64, style: LineStyle) -> Result<(), JsValue> {
        self.context.set_stroke_style_str(colour);
        self.context.set_line_width(width);
        let dashes: &[f64] = match style {
            LineStyle::Solid => &[],
            LineStyle::Dashed => &[4.0, 4.0],
            // The round caps make a dot of each dash.
            LineStyle::Dotted => &[0.1, 3.6],
        };
        let dashes: js_sys::Array = dashes.iter().copied().map(JsValue::from).collect();
        self.context.set_line_dash(&dashes)
    }

    /// Draws the hatching of a goal, which rotates with it.
    fn hatch(&self, body: &Body, outline: &Path2d) -> Result<(), JsValue> {
        let context = self.context;
        let radius = bounding_radius(body).min(MAX_HATCHED_RADIUS);
        context.save();
        context.clip_with_path_2d(outline);
        context.begin_path();
        let lines = (2.0 * radius / HATCH_SPACING) as i32;
        for line in -lines..=lines {
            let offset = f64::from(line) * HATCH_SPACING;
            context.move_to(offset - radius, -radius);
            context.line_to(offset + radius, radius);
        }
        context.set_global_alpha(0.55);
        self.set_stroke(self.palette.paper, HATCH_WIDTH, LineStyle::Solid)?;
        context.stroke();
        context.restore();
        Ok(())
    }

    /// Draws a mark on a ball that shows how it rolls.
    fn spoke(&self, radius: f64) -> Result<(), JsValue> {
        let context = self.context;
        context.save();
        context.begin_path();
        context.move_to(radius * 0.35, 0.0);
        context.line_to(radius * 0.75, 0.0);
        context.set_global_alpha(0.75);
        self.set_stroke(self.palette.paper, (radius * 0.12).max(0.8), LineStyle::Solid)?;
        context.stroke();
        context.restore();
        Ok(())
    }

    /// Draws the dot of the green object, off the centre of a ball, so that it shows how the ball rolls.
    fn dot(&self, body: &Body) -> Result<(), JsValue> {
        let (x, radius) = match body.ball_radius() {
            Some(radius) => (0.4 * radius, (0.26 * radius).max(1.6)),
            None => (0.0, 1.7),
        };
        self.context.begin_path();
        self.context.arc(x, 0.0, radius, 0.0, TAU)?;
        self.context.set_fill_style_str(self.palette.paper);
        self.context.fill();
        Ok(())
    }
}

/// Returns all shapes of a body as one path, in body coordinates.
fn body_path(body: &Body) -> Result<Path2d, JsValue> {
    let path = Path2d::new()?;
    for shape in &body.shapes {
        match shape {
            Shape::Circle(radius) => {
                path.move_to(*radius, 0.0);
                path.arc(0.0, 0.0, *radius, 0.0, TAU)?;
            }
            Shape::Polygon(corners) => {
                for (index, &[x, y]) in corners.iter().enumerate() {
                    if index == 0 { path.move_to(x, y) } else { path.line_to(x, y) }
                }
            }
        }
        path.close_path();
    }
    Ok(path)
}

/// Returns the largest distance of a point of a body from its origin, px.
pub(crate) fn bounding_radius(body: &Body) -> f64 {
    let extent = |shape: &Shape| match shape {
        Shape::Circle(radius) => *radius,
        Shape::Polygon(corners) => corners.iter().map(|[x, y]| libm::hypot(*x, *y)).fold(0.0, f64::max),
    };
    body.shapes.iter().map(extent).fold(0.0, f64::max)
}

//! Draws scenes, balls, paths, rings and laid-over maps on a canvas.
//!
//! A painter sets the canvas up so that one unit is one px of the scene, origin bottom left, y up, whatever
//! the canvas's own resolution; then each call draws one thing. It is told what to draw and where, and knows
//! nothing of attempts or of time.

use std::f64::consts::TAU;

use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement, Path2d};

use super::colour::{Palette, palette};
use super::error::{Code, error};
use crate::puzzle::action::Ball;
use crate::puzzle::rollout::Pose;
use crate::puzzle::scene::{Body, Role, SIZE, Shape};

/// Distance between the lines of a hatched goal, and their width, px.
const HATCH: (f64, f64) = (4.5, 1.2);

/// Width of the rim of black bodies, px.
const RIM: f64 = 0.8;

/// Width of a path, px.
const PATH: f64 = 1.6;

/// The least width of a path, pixels of the canvas: in a small picture `PATH` alone is a hair.
const PATH_PIXELS: f64 = 1.2;

pub struct Painter<'a> {
    pub(super) context: &'a CanvasRenderingContext2d,
    pub(super) palette: &'static Palette,
    /// Canvas pixels in one px of the scene.
    scale: f64,
}

/// How a line is drawn: solid for the player, dashed for the model.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Line {
    Solid,
    Dashed,
}

impl<'a> Painter<'a> {
    /// Lays out the scene's paper over the whole canvas.
    pub fn new(context: &'a CanvasRenderingContext2d, dark: bool) -> Result<Painter<'a>, JsValue> {
        let canvas = context.canvas().ok_or_else(|| error(Code::BadData, "the context has no canvas"))?;
        let side = f64::from(canvas.width());
        let painter = Painter { context, palette: palette(dark), scale: side / SIZE };
        context.set_transform(1.0, 0.0, 0.0, 1.0, 0.0, 0.0)?;
        context.set_global_alpha(1.0);
        context.set_fill_style_str(painter.palette.paper);
        context.fill_rect(0.0, 0.0, side, f64::from(canvas.height()));
        painter.scene_units()?;
        context.set_line_join("round");
        context.set_line_cap("round");
        Ok(painter)
    }

    /// How much of what is underneath the next bodies hide, 0..=1.
    pub fn cover(&self, share: f64) {
        self.context.set_global_alpha(share);
    }

    /// A body by its role; where it stands in the scene, or at a pose. A goal is hatched, the green object dotted.
    pub fn body(&self, body: &Body, pose: Option<Pose>, goal: bool) -> Result<(), JsValue> {
        let [x, y, angle] = pose.map_or([body.x, body.y, body.angle], |pose| pose.map(f64::from));
        let context = self.context;
        let outline = outline(body)?;
        context.save();
        context.translate(x, y)?;
        context.rotate(angle)?;
        context.set_fill_style_str(self.palette.role(body.role));
        context.fill_with_path_2d(&outline);
        if body.role == Role::Black {
            self.stroke(self.palette.rim, RIM, Line::Solid)?;
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

    /// The outline of a body at a pose: where another rollout has it.
    pub fn ghost(&self, body: &Body, pose: Pose, line: Line) -> Result<(), JsValue> {
        let [x, y, angle] = pose.map(f64::from);
        self.context.save();
        self.context.translate(x, y)?;
        self.context.rotate(angle)?;
        self.stroke(self.palette.role(body.role), 1.4, line)?;
        self.context.stroke_with_path(&outline(body)?);
        self.context.restore();
        Ok(())
    }

    /// The action ball; one that is invalid is only outlined.
    pub fn ball(&self, ball: Ball, angle: f64, valid: bool) -> Result<(), JsValue> {
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
            self.stroke(self.palette.red, 2.0, Line::Dashed)?;
            context.stroke();
            // A bar across it says "not here" without colour.
            let reach = ball.r * 0.7;
            context.begin_path();
            context.move_to(-reach, reach);
            context.line_to(reach, -reach);
            self.stroke(self.palette.ink, 1.5, Line::Solid)?;
            context.stroke();
        }
        context.restore();
        Ok(())
    }

    /// The knob that changes the radius of the ball, at its right.
    pub fn handle(&self, ball: Ball, radius: f64) -> Result<(), JsValue> {
        self.context.begin_path();
        self.context.arc(ball.x + ball.r, ball.y, radius, 0.0, TAU)?;
        self.context.set_fill_style_str(self.palette.paper);
        self.context.fill();
        self.stroke(self.palette.ink, 1.0, Line::Solid)?;
        self.context.stroke();
        Ok(())
    }

    /// A path through points of the scene, px.
    pub fn path(&self, points: impl Iterator<Item = [f64; 2]>, role: Role, line: Line) -> Result<(), JsValue> {
        self.context.begin_path();
        for [x, y] in points {
            self.context.line_to(x, y);
        }
        let width = PATH.max(PATH_PIXELS / self.scale);
        // A rim in the colour of the paper keeps the path in sight where it crosses a body of its own colour.
        self.stroke(self.palette.paper, width + 1.4, Line::Solid)?;
        self.context.set_global_alpha(0.7);
        self.context.stroke();
        self.context.set_global_alpha(1.0);
        self.stroke(self.palette.role(role), width, line)?;
        self.context.stroke();
        Ok(())
    }

    /// A ring round a point, filled to a share of its turn, clockwise from the top.
    pub fn ring(&self, [x, y]: [f64; 2], radius: f64, share: f64) -> Result<(), JsValue> {
        let top = TAU / 4.0;
        for (colour, width, share) in [(self.palette.ink, 5.0, 1.0), (self.palette.ring, 3.4, share)] {
            self.context.begin_path();
            self.context.arc_with_anticlockwise(x, y, radius, top, top - TAU * share, true)?;
            self.stroke(colour, width, Line::Solid)?;
            self.context.stroke();
        }
        Ok(())
    }

    /// A map, drawn by `map`, over the whole scene.
    pub fn layer(&self, map: &HtmlCanvasElement, opacity: f64) -> Result<(), JsValue> {
        let side = self.scale * SIZE;
        self.context.set_transform(1.0, 0.0, 0.0, 1.0, 0.0, 0.0)?;
        self.context.set_global_alpha(opacity.clamp(0.0, 1.0));
        self.context.draw_image_with_html_canvas_element_and_dw_and_dh(map, 0.0, 0.0, side, side)?;
        self.context.set_global_alpha(1.0);
        self.scene_units()
    }

    fn scene_units(&self) -> Result<(), JsValue> {
        self.context.set_transform(self.scale, 0.0, 0.0, -self.scale, 0.0, self.scale * SIZE)
    }

    pub(super) fn stroke(&self, colour: &str, width: f64, line: Line) -> Result<(), JsValue> {
        self.context.set_stroke_style_str(colour);
        self.context.set_line_width(width);
        let dashes = match line {
            Line::Solid => js_sys::Array::new(),
            Line::Dashed => [4.0, 4.0].into_iter().map(JsValue::from).collect(),
        };
        self.context.set_line_dash(&dashes)
    }

    /// Lines across the goal, which turn with it.
    fn hatch(&self, body: &Body, outline: &Path2d) -> Result<(), JsValue> {
        let context = self.context;
        let reach = reach(body);
        context.save();
        context.clip_with_path_2d(outline);
        context.begin_path();
        let lines = (2.0 * reach / HATCH.0) as i32;
        for line in -lines..=lines {
            let offset = f64::from(line) * HATCH.0;
            context.move_to(offset - reach, -reach);
            context.line_to(offset + reach, reach);
        }
        context.set_global_alpha(0.55);
        self.stroke(self.palette.paper, HATCH.1, Line::Solid)?;
        context.stroke();
        context.restore();
        Ok(())
    }

    /// A mark on a ball that shows how it rolls.
    fn spoke(&self, radius: f64) -> Result<(), JsValue> {
        let context = self.context;
        context.save();
        context.begin_path();
        context.move_to(radius * 0.35, 0.0);
        context.line_to(radius * 0.75, 0.0);
        context.set_global_alpha(0.75);
        self.stroke(self.palette.paper, (radius * 0.12).max(0.8), Line::Solid)?;
        context.stroke();
        context.restore();
        Ok(())
    }

    /// The dot of the green object; off the middle of a ball, so that it shows how the ball rolls.
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

/// All parts of a body as one path, in body coordinates.
fn outline(body: &Body) -> Result<Path2d, JsValue> {
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

/// How far a body reaches from its origin, px.
pub fn reach(body: &Body) -> f64 {
    let extent = |shape: &Shape| match shape {
        Shape::Circle(radius) => *radius,
        Shape::Polygon(corners) => corners.iter().map(|[x, y]| libm::hypot(*x, *y)).fold(0.0, f64::max),
    };
    body.shapes.iter().map(extent).fold(0.0, f64::max)
}

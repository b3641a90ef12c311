//! Draws scenes, balls, paths, rings and overlaid maps on a canvas.
//!
//! A `Painter` transforms the canvas so that one unit is one px of the scene, origin bottom left, y up, at any
//! resolution of the canvas. Each call then draws one thing. It must not depend on attempts or on time.

use std::f64::consts::TAU;

use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement, Path2d};

use super::error::{Code, error};
use crate::colour::palette::{Palette, palette};
use crate::puzzle::action::Ball;
use crate::puzzle::rollout::Pose;
use crate::puzzle::scene::{Body, Role, SIZE, Scene, Shape};

/// Distance between the lines of a hatched goal, and their width, px.
const HATCH_SPACING: f64 = 4.5;
const HATCH_WIDTH: f64 = 1.2;

/// Largest radius to hatch, px. Playable bodies are smaller, but the editor also draws larger ones.
const MAX_HATCHED_RADIUS: f64 = 512.0;

/// Widths of the rim of black bodies and of a path, px.
const RIM_WIDTH: f64 = 1.0;
const PATH_WIDTH: f64 = 1.6;

/// Minimum width of a path, pixels of the canvas: `PATH_WIDTH` would be hardly visible in a thumbnail.
const MIN_PATH_PIXELS: f64 = 1.2;

pub(crate) struct Painter<'a> {
    pub(super) context: &'a CanvasRenderingContext2d,
    pub(super) palette: &'static Palette,
    pub(super) dark: bool,
    /// Canvas pixels per px of the scene.
    pub(super) scale: f64,
}

/// The style of a line.
#[derive(Clone, Copy)]
pub(crate) enum Line {
    /// Something real.
    Solid,
    /// Something invalid.
    Dashed,
    /// Something imagined, drawn by hand, or past.
    Dotted,
}

impl<'a> Painter<'a> {
    /// Sets the scene's units and the style of lines.
    pub(crate) fn new(context: &'a CanvasRenderingContext2d, dark: bool) -> Result<Painter<'a>, JsValue> {
        let canvas = context.canvas().ok_or_else(|| error(Code::BadData, "the context has no canvas"))?;
        let painter = Painter { context, palette: palette(dark), dark, scale: f64::from(canvas.width()) / SIZE };
        painter.set_scene_units()?;
        context.set_global_alpha(1.0);
        context.set_line_join("round");
        context.set_line_cap("round");
        Ok(painter)
    }

    /// Returns the side of the canvas, pixels.
    pub(super) fn side(&self) -> f64 {
        self.scale * SIZE
    }

    /// Fills the scene with the background colour.
    pub(crate) fn background(&self) {
        self.context.set_fill_style_str(self.palette.paper);
        self.context.fill_rect(0.0, 0.0, SIZE, SIZE);
    }

    /// Draws the static or the dynamic bodies, at their poses or, where there is none, as in the scene.
    pub(crate) fn bodies(
        &self,
        scene: &Scene,
        dynamic: bool,
        pose: impl Fn(usize) -> Option<Pose>,
    ) -> Result<(), JsValue> {
        let mut bodies = scene.bodies.iter().enumerate().filter(|(_, body)| body.dynamic == dynamic);
        bodies.try_for_each(|(index, body)| self.body(body, pose(index), index == scene.body2))
    }

    /// Draws a body in the colour of its role, at a pose or at its pose in the scene. A goal is hatched, the green
    /// object dotted.
    pub(crate) fn body(&self, body: &Body, pose: Option<Pose>, goal: bool) -> Result<(), JsValue> {
        let outline = body_path(body)?;
        self.placed(pose.map_or([body.x, body.y, body.angle], |pose| pose.map(f64::from)), || {
            self.context.set_fill_style_str(self.palette.role(body.role));
            self.context.fill_with_path_2d(&outline);
            if body.role == Role::Black {
                self.set_stroke(self.palette.rim, RIM_WIDTH, Line::Solid)?;
                self.context.stroke_with_path(&outline);
            }
            if goal {
                self.hatch(body, &outline)?;
            }
            match (body.role, body.ball_radius()) {
                (Role::Gray | Role::Blue, Some(radius)) => self.spoke(radius),
                // Off the ball's centre, so that it shows how the ball rolls.
                (Role::Green, Some(radius)) => {
                    self.disc([0.4 * radius, 0.0], (0.26 * radius).max(1.6), self.palette.paper)
                }
                (Role::Green, None) => self.disc([0.0, 0.0], 1.7, self.palette.paper),
                _ => Ok(()),
            }
        })
    }

    /// Draws the outline of a body at a pose.
    pub(crate) fn outline(&self, body: &Body, pose: Pose, colour: &str, line: Line) -> Result<(), JsValue> {
        self.placed(pose.map(f64::from), || {
            self.set_stroke(colour, 1.4, line)?;
            self.context.stroke_with_path(&body_path(body)?);
            Ok(())
        })
    }

    /// Draws the action ball; an invalid one is only outlined.
    pub(crate) fn ball(&self, ball: Ball, angle: f64, valid: bool) -> Result<(), JsValue> {
        self.placed([ball.x, ball.y, angle], || {
            if valid {
                self.disc([0.0, 0.0], ball.r, self.palette.red)?;
                return self.spoke(ball.r);
            }
            self.faded(0.3, || self.disc([0.0, 0.0], ball.r, self.palette.red))?;
            self.stroke(self.palette.red, 2.0, Line::Dashed)?;
            // A bar across the ball marks it independently of colour.
            let half = ball.r * 0.7;
            self.lines([[-half, half], [half, -half]]);
            self.stroke(self.palette.ink, 1.5, Line::Solid)
        })
    }

    /// Draws the knob that changes the radius of the ball, to its right.
    pub(crate) fn knob(&self, ball: Ball, radius: f64) -> Result<(), JsValue> {
        self.disc([ball.x + ball.r, ball.y], radius, self.palette.paper)?;
        self.stroke(self.palette.ink, 1.0, Line::Solid)
    }

    /// Draws a path through points of the scene, px.
    pub(crate) fn path(&self, points: impl Iterator<Item = [f64; 2]>, role: Role, line: Line) -> Result<(), JsValue> {
        self.lines(points);
        let width = PATH_WIDTH.max(MIN_PATH_PIXELS / self.scale);
        // A rim in the background colour keeps the path visible where it crosses a body of the same colour.
        self.faded(0.7, || self.stroke(self.palette.paper, width + 1.4, Line::Solid))?;
        self.stroke(self.palette.role(role), width, line)
    }

    /// Draws a progress ring around a point, filled to a fraction clockwise from the top.
    pub(crate) fn ring(&self, [x, y]: [f64; 2], radius: f64, fraction: f64) -> Result<(), JsValue> {
        let top = TAU / 4.0;
        for (colour, width, fraction) in [(self.palette.ink, 5.0, 1.0), (self.palette.ring, 3.4, fraction)] {
            self.context.begin_path();
            self.context.arc_with_anticlockwise(x, y, radius, top, top - TAU * fraction, true)?;
            self.stroke(colour, width, Line::Solid)?;
        }
        Ok(())
    }

    /// Draws a picture over the whole scene.
    pub(crate) fn overlay(&self, picture: &HtmlCanvasElement, opacity: f64) -> Result<(), JsValue> {
        let side = self.side();
        self.context.set_transform(1.0, 0.0, 0.0, 1.0, 0.0, 0.0)?;
        self.faded(opacity, || {
            self.context.draw_image_with_html_canvas_element_and_dw_and_dh(picture, 0.0, 0.0, side, side)
        })?;
        self.set_scene_units()
    }

    pub(super) fn set_scene_units(&self) -> Result<(), JsValue> {
        self.context.set_transform(self.scale, 0.0, 0.0, -self.scale, 0.0, self.side())
    }

    /// Draws at an opacity, 0..=1.
    pub(super) fn faded(&self, opacity: f64, draw: impl FnOnce() -> Result<(), JsValue>) -> Result<(), JsValue> {
        let before = self.context.global_alpha();
        self.context.set_global_alpha(opacity.clamp(0.0, 1.0));
        draw()?;
        self.context.set_global_alpha(before);
        Ok(())
    }

    /// Draws in the coordinates of a body at x, y and an angle.
    fn placed(&self, [x, y, angle]: [f64; 3], draw: impl FnOnce() -> Result<(), JsValue>) -> Result<(), JsValue> {
        self.context.save();
        self.context.translate(x, y)?;
        self.context.rotate(angle)?;
        draw()?;
        self.context.restore();
        Ok(())
    }

    /// Begins a circle as the current path, to be stroked next.
    pub(super) fn circle(&self, [x, y]: [f64; 2], radius: f64) -> Result<(), JsValue> {
        self.context.begin_path();
        self.context.arc(x, y, radius, 0.0, TAU)
    }

    /// Fills a disc. Its outline becomes the current path, to be stroked next.
    pub(super) fn disc(&self, place: [f64; 2], radius: f64, colour: &str) -> Result<(), JsValue> {
        self.circle(place, radius)?;
        self.context.set_fill_style_str(colour);
        self.context.fill();
        Ok(())
    }

    /// Begins a line through points as the current path, to be stroked next.
    pub(super) fn lines(&self, points: impl IntoIterator<Item = [f64; 2]>) {
        self.context.begin_path();
        points.into_iter().for_each(|[x, y]| self.context.line_to(x, y));
    }

    /// Strokes the current path; the width is in px.
    pub(super) fn stroke(&self, colour: &str, width: f64, line: Line) -> Result<(), JsValue> {
        self.set_stroke(colour, width, line)?;
        self.context.stroke();
        Ok(())
    }

    /// Sets colour, width (px) and style of the next strokes.
    pub(super) fn set_stroke(&self, colour: &str, width: f64, line: Line) -> Result<(), JsValue> {
        self.context.set_stroke_style_str(colour);
        self.context.set_line_width(width);
        let dashes: &[f64] = match line {
            Line::Solid => &[],
            Line::Dashed => &[4.0, 4.0],
            // The round caps make a dot of each dash.
            Line::Dotted => &[0.1, 3.6],
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
        self.faded(0.55, || self.stroke(self.palette.paper, HATCH_WIDTH, Line::Solid))?;
        context.restore();
        Ok(())
    }

    /// Draws a mark on a ball that shows how it rolls.
    fn spoke(&self, radius: f64) -> Result<(), JsValue> {
        self.lines([[radius * 0.35, 0.0], [radius * 0.75, 0.0]]);
        self.faded(0.75, || self.stroke(self.palette.paper, (radius * 0.12).max(0.8), Line::Solid))
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

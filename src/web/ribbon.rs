//! Draws what the model imagines for a ball: each path as a dotted line in a ribbon as wide as it is expected to be
//! wrong, and ghosts of the bodies on it. Real paths are solid or dashed and have no ribbon.

use std::f64::consts::TAU;

use wasm_bindgen::prelude::*;

use super::imagined_paths::{Hint, ImaginedPaths};
use super::paint::{LineStyle, Painter, bounding_radius};
use crate::puzzle::sampled_paths::{SAMPLES, SampledPath};
use crate::puzzle::scene::{Body, Scene};

/// The parts of a ribbon: width, in expected errors, and opacity, 0..=1. They lie over each other, so that it fades
/// outwards.
const RIBBON_PARTS: [(f64, f64); 2] = [(1.0, 0.1), (0.5, 0.12)];

/// Opacity of a ghost, 0..=1.
const GHOST_OPACITY: f64 = 0.75;

/// Distance between ghosts, in radii of the body.
const GHOST_SPACING: f64 = 3.0;

/// Radius of the dot that stands for a body whose rotation is not imagined, px.
const DOT_RADIUS: f64 = 2.4;

/// Width of a path that is only hinted at, px.
const HINT_WIDTH: f64 = 1.2;

/// The imagined path of one body, from its start.
struct Track {
    body: Body,
    points: [[f64; 2]; SAMPLES + 1],
    /// Expected errors, px; none at the start.
    errors: [f64; SAMPLES + 1],
}

impl Track {
    fn new(body: Body, path: &SampledPath, path_errors: &[f32; SAMPLES]) -> Track {
        let mut points = [[body.x, body.y]; SAMPLES + 1];
        let mut errors = [0.0; SAMPLES + 1];
        for sample in 0..SAMPLES {
            points[sample + 1] = path[sample].map(f64::from);
            errors[sample + 1] = f64::from(path_errors[sample]).max(0.0);
        }
        Track { body, points, errors }
    }

    /// Returns the positions of its ghosts: some distance apart, and the last.
    fn ghosts(&self) -> Vec<[f64; 2]> {
        let spacing = GHOST_SPACING * bounding_radius(&self.body);
        let far = |[x, y]: [f64; 2], [u, v]: [f64; 2]| libm::hypot(x - u, y - v) >= spacing;
        let (mut ghosts, mut last) = (Vec::new(), self.points[0]);
        let end = self.points[SAMPLES];
        for &point in &self.points[1..SAMPLES] {
            if far(point, last) && far(point, end) {
                ghosts.push(point);
                last = point;
            }
        }
        ghosts.push(end);
        ghosts
    }
}

fn tracks(scene: &Scene, imagined: &ImaginedPaths) -> [Track; 2] {
    let object = scene.bodies[scene.body1].clone();
    let ImaginedPaths { of, object: path, ball, object_errors, ball_errors } = imagined;
    [Track::new(object, path, object_errors), Track::new(of.body(), ball, ball_errors)]
}

impl Painter<'_> {
    /// Draws the ribbons of the imagined paths of the green object and of the ball.
    pub(crate) fn ribbons(&self, scene: &Scene, imagined: &ImaginedPaths) -> Result<(), JsValue> {
        let parts =
            |track: Track| RIBBON_PARTS.iter().try_for_each(|&(width, opacity)| self.ribbon(&track, width, opacity));
        tracks(scene, imagined).into_iter().try_for_each(parts)
    }

    /// Draws the lines of these paths.
    pub(crate) fn imagined_paths(&self, scene: &Scene, imagined: &ImaginedPaths) -> Result<(), JsValue> {
        let line = |track: Track| self.path(track.points.into_iter(), track.body.role, LineStyle::Dotted);
        tracks(scene, imagined).into_iter().try_for_each(line)
    }

    /// Draws an imagined path of the green object, without a ribbon.
    pub(crate) fn hint(&self, scene: &Scene, hint: &Hint) -> Result<(), JsValue> {
        let object = &scene.bodies[scene.body1];
        self.context.begin_path();
        self.context.move_to(object.x, object.y);
        hint.object.chunks_exact(2).for_each(|point| self.context.line_to(point[0], point[1]));
        // Forty dotted lines over each other would be a cloud.
        let style = if hint.tried { LineStyle::Dashed } else { LineStyle::Solid };
        self.set_stroke(self.palette.role(object.role), HINT_WIDTH, style)?;
        self.set_alpha(hint.opacity);
        self.context.stroke();
        self.set_alpha(1.0);
        Ok(())
    }

    /// Draws ghosts of the green object and of the ball all along their paths.
    pub(crate) fn ghosts(&self, scene: &Scene, imagined: &ImaginedPaths) -> Result<(), JsValue> {
        self.set_alpha(GHOST_OPACITY);
        for track in tracks(scene, imagined) {
            track.ghosts().into_iter().try_for_each(|position| self.ghost(&track.body, position))?;
        }
        self.set_alpha(1.0);
        Ok(())
    }

    /// Draws the outline of a ball; of another body only a dot, because its rotation is not imagined.
    fn ghost(&self, body: &Body, [x, y]: [f64; 2]) -> Result<(), JsValue> {
        if body.ball_radius().is_some() {
            return self.outline(body, [x as f32, y as f32, 0.0], LineStyle::Solid);
        }
        self.context.begin_path();
        self.context.arc(x, y, DOT_RADIUS, 0.0, TAU)?;
        self.context.set_fill_style_str(self.palette.role(body.role));
        self.context.fill();
        self.set_stroke(self.palette.paper, 1.0, LineStyle::Solid)?;
        self.context.stroke();
        Ok(())
    }

    /// Fills discs around the points of a path, and what lies between them. Their radii are a multiple of the expected
    /// errors.
    fn ribbon(&self, track: &Track, width: f64, opacity: f64) -> Result<(), JsValue> {
        let context = self.context;
        context.begin_path();
        for sample in 0..=SAMPLES {
            let ([x, y], radius) = (track.points[sample], width * track.errors[sample]);
            context.move_to(x + radius, y);
            context.arc(x, y, radius, 0.0, TAU)?;
            let Some(&[u, v]) = track.points.get(sample + 1) else { break };
            let (end_radius, length) = (width * track.errors[sample + 1], libm::hypot(u - x, v - y));
            if length > 0.0 {
                // Wound in the same direction as the discs, so that overlaps are filled too.
                let (across, up) = ((y - v) / length, (u - x) / length);
                context.move_to(x - across * radius, y - up * radius);
                context.line_to(u - across * end_radius, v - up * end_radius);
                context.line_to(u + across * end_radius, v + up * end_radius);
                context.line_to(x + across * radius, y + up * radius);
                context.close_path();
            }
        }
        self.set_alpha(opacity);
        context.set_fill_style_str(self.palette.role(track.body.role));
        context.fill();
        self.set_alpha(1.0);
        Ok(())
    }
}

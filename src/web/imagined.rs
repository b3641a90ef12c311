//! Draws what the model imagines for a ball: each path as a dotted line in a ribbon whose width is the expected error,
//! and ghosts of the bodies along it. Real paths are solid and have no ribbon.

use std::f64::consts::TAU;
use std::iter;

use serde::Deserialize;
use wasm_bindgen::prelude::*;

use super::paint::{Line, Painter, bounding_radius};
use crate::puzzle::action::Ball;
use crate::puzzle::scene::{Body, Scene};

/// The parts of a ribbon: width, in expected errors, and opacity, 0..=1. They overlap, so that the ribbon fades
/// outwards.
const RIBBON_PARTS: [(f64, f64); 2] = [(1.0, 0.1), (0.5, 0.12)];

/// Opacity of a ghost, 0..=1.
const GHOST_OPACITY: f64 = 0.75;

/// Distance between ghosts, in multiples of the body's radius.
const GHOST_SPACING: f64 = 3.0;

/// Radius of the dot for a body whose rotation is not imagined, px.
const DOT_RADIUS: f64 = 2.4;

/// Width of a faint path, px.
const HINT_WIDTH: f64 = 1.2;

/// The imagined paths of one ball, as returned by `Model.imagineBall`: x and y alternating, px.
#[derive(Deserialize)]
pub(crate) struct Imagined {
    /// The ball of these paths.
    of: Ball,
    object: Vec<f32>,
    ball: Vec<f32>,
    /// Expected errors of the object's positions, then of the ball's, px.
    errors: Vec<f32>,
}

/// An imagined path of the green object to draw faintly: x and y alternating, px.
#[derive(Deserialize)]
pub(crate) struct Hint {
    object: Vec<f64>,
    /// 0..=1
    opacity: f64,
}

/// The imagined path of one body, from its start.
struct Track {
    body: Body,
    /// The imagined positions of the body, and their expected errors, px.
    places: Vec<[f64; 2]>,
    errors: Vec<f64>,
}

impl Track {
    fn new(body: Body, path: &[f32], errors: &[f32]) -> Track {
        let places = path.as_chunks().0.iter().map(|place: &[f32; 2]| place.map(f64::from));
        let errors = errors.iter().map(|&error| f64::from(error).max(0.0));
        let (places, errors) = (iter::once([body.x, body.y]).chain(places), iter::once(0.0).chain(errors));
        Track { places: places.collect(), errors: errors.collect(), body }
    }

    /// Returns the positions of its ghosts: some distance apart, including the last.
    fn ghosts(&self) -> Vec<[f64; 2]> {
        let spacing = GHOST_SPACING * bounding_radius(&self.body);
        let far = |[x, y]: [f64; 2], [u, v]: [f64; 2]| libm::hypot(x - u, y - v) >= spacing;
        let (mut last, end) = (self.places[0], self.places[self.places.len() - 1]);
        let mut ghosts = Vec::new();
        for &place in &self.places[1..] {
            if far(place, last) && far(place, end) {
                ghosts.push(place);
                last = place;
            }
        }
        ghosts.push(end);
        ghosts
    }
}

fn tracks(scene: &Scene, Imagined { of, object, ball, errors }: &Imagined) -> [Track; 2] {
    let (object_errors, ball_errors) = errors.split_at(errors.len() / 2);
    let body = scene.bodies[scene.body1].clone();
    [Track::new(body, object, object_errors), Track::new(of.body(), ball, ball_errors)]
}

impl Painter<'_> {
    /// Draws the ribbons of the imagined paths of the green object and of the ball.
    pub(crate) fn ribbons(&self, scene: &Scene, imagined: &Imagined) -> Result<(), JsValue> {
        for track in tracks(scene, imagined) {
            for (width, opacity) in RIBBON_PARTS {
                self.faded(opacity, || self.ribbon(&track, width))?;
            }
        }
        Ok(())
    }

    /// Draws the lines of these paths.
    pub(crate) fn imagined_paths(&self, scene: &Scene, imagined: &Imagined) -> Result<(), JsValue> {
        let line = |track: Track| self.path(track.places.into_iter(), track.body.role, Line::Dotted);
        tracks(scene, imagined).into_iter().try_for_each(line)
    }

    /// Draws an imagined path of the green object faintly, without a ribbon.
    pub(crate) fn hint(&self, scene: &Scene, hint: &Hint) -> Result<(), JsValue> {
        let object = &scene.bodies[scene.body1];
        self.lines(iter::once([object.x, object.y]).chain(hint.object.as_chunks().0.iter().copied()));
        // Forty dotted lines on top of each other would blur into a cloud.
        self.faded(hint.opacity, || self.stroke(self.palette.role(object.role), HINT_WIDTH, Line::Solid))
    }

    /// Draws ghosts of the green object and of the ball along their paths. A ball has an outline; any other body is
    /// only a dot, because its rotation is not imagined.
    pub(crate) fn ghosts(&self, scene: &Scene, imagined: &Imagined) -> Result<(), JsValue> {
        for track in tracks(scene, imagined) {
            let colour = self.palette.role(track.body.role);
            let ghost = |place @ [x, y]: [f64; 2]| {
                if track.body.ball_radius().is_some() {
                    return self.outline(&track.body, [x as f32, y as f32, 0.0], colour, Line::Solid);
                }
                self.disc(place, DOT_RADIUS, colour)?;
                self.stroke(self.palette.paper, 1.0, Line::Solid)
            };
            self.faded(GHOST_OPACITY, || track.ghosts().into_iter().try_for_each(ghost))?;
        }
        Ok(())
    }

    /// Fills discs around the points of a path, and the areas between them. Their radii are a multiple of the expected
    /// errors.
    fn ribbon(&self, track: &Track, width: f64) -> Result<(), JsValue> {
        let context = self.context;
        context.begin_path();
        let radii: Vec<f64> = track.errors.iter().map(|error| width * error).collect();
        for (&[x, y], &radius) in track.places.iter().zip(&radii) {
            context.move_to(x + radius, y);
            context.arc(x, y, radius, 0.0, TAU)?;
        }
        for (places, radii) in track.places.array_windows().zip(radii.array_windows()) {
            let ([[x, y], [u, v]], [radius, end_radius]) = (places, radii);
            let length = libm::hypot(u - x, v - y);
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
        context.set_fill_style_str(self.palette.role(track.body.role));
        context.fill();
        Ok(())
    }
}

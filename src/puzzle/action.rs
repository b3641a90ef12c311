//! Actions: three numbers in 0..1 that place the red ball, and the one rule that says whether it may be there.
//!
//! Page, wasm and command line all come here, so a ball is valid everywhere or nowhere. Only valid balls
//! count as attempts. Mapping and rule are PHYRE's (v0.2.2, ball tier).

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::puzzle::scene::{Body, Part, Role, SIZE, Scene, Shape};

/// Smallest and largest radius of the action ball, px.
pub const RADIUS: std::ops::RangeInclusive<f64> = 2.0..=32.0;

/// How much nearer than touching counts as overlap, px.
const TOLERANCE: f64 = 1e-5;

/// A point of the action space: x, y and radius, each in 0..=1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(into = "[f64; 3]", from = "[f64; 3]")]
pub struct Action {
    pub x: f64,
    pub y: f64,
    pub r: f64,
}

/// The red ball in the scene: whole numbers of px once it comes from an action.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(into = "[f64; 3]", from = "[f64; 3]")]
pub struct Ball {
    pub x: f64,
    pub y: f64,
    pub r: f64,
}

/// Why a ball may not be placed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Invalid {
    #[error("x, y and r of an action must lie between 0 and 1")]
    OutOfRange,
    #[error("the radius of the ball must lie between 2 and 32 px")]
    Radius,
    #[error("the ball sticks out of the scene")]
    Outside,
    /// The index of a body of the scene.
    #[error("the ball overlaps body {0}")]
    Overlaps(usize),
}

impl Action {
    /// The ball that this action places in a scene.
    ///
    /// # Errors
    /// Says why the action is invalid there.
    pub fn place(self, scene: &Scene) -> Result<Ball, Invalid> {
        if ![self.x, self.y, self.r].iter().all(|value| (0.0..=1.0).contains(value)) {
            return Err(Invalid::OutOfRange);
        }
        let (x, y, r) = (self.x * (SIZE - 1.0), self.y * (SIZE - 1.0), 2.0 + 30.0 * self.r);
        // PHYRE asks whether the ball is inside the scene before it rounds, and what it overlaps after.
        inside(x, y, r)?;
        let ball = Ball { x: x.trunc(), y: y.trunc(), r: r.round_ties_even() };
        ball.check(scene)?;
        Ok(ball)
    }
}

impl Ball {
    /// Whether this ball may be placed in a scene: inside it, and clear of every body and wall.
    ///
    /// # Errors
    /// Says why not.
    pub fn check(&self, scene: &Scene) -> Result<(), Invalid> {
        if !RADIUS.contains(&self.r) {
            return Err(Invalid::Radius);
        }
        // The walls begin where the scene ends: a ball inside is clear of them.
        inside(self.x, self.y, self.r)?;
        match scene.bodies.iter().position(|body| self.overlaps(body)) {
            Some(body) => Err(Invalid::Overlaps(body)),
            None => Ok(()),
        }
    }

    /// The ball as a body, at rest.
    pub fn body(&self) -> Body {
        let parts = vec![Part::Circle(self.r)];
        Body { x: self.x, y: self.y, angle: 0.0, dynamic: true, shape: Shape::Ball, role: Role::Red, parts }
    }

    /// The action whose ball this is, up to rounding.
    pub fn action(&self) -> Action {
        Action { x: self.x / (SIZE - 1.0), y: self.y / (SIZE - 1.0), r: (self.r - 2.0) / 30.0 }
    }

    /// Touching is not overlapping.
    fn overlaps(&self, body: &Body) -> bool {
        body.parts.iter().any(|part| match part {
            Part::Circle(r) => libm::hypot(self.x - body.x, self.y - body.y) + TOLERANCE < self.r + r,
            Part::Polygon(corners) => {
                let corners: Vec<_> = corners.iter().map(|&corner| body.to_scene(corner)).collect();
                distance_to_polygon([self.x, self.y], &corners) + TOLERANCE < self.r
            }
        })
    }
}

fn inside(x: f64, y: f64, r: f64) -> Result<(), Invalid> {
    let span = r..=SIZE - r;
    if span.contains(&x) && span.contains(&y) { Ok(()) } else { Err(Invalid::Outside) }
}

/// Distance from a point to a convex, counter-clockwise polygon; 0 inside. Any length unit.
fn distance_to_polygon([x, y]: [f64; 2], corners: &[[f64; 2]]) -> f64 {
    let edges = || corners.iter().zip(corners.iter().cycle().skip(1));
    let left_of = |a: &[f64; 2], b: &[f64; 2]| (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]) >= 0.0;
    if edges().all(|(a, b)| left_of(a, b)) {
        return 0.0;
    }
    let to_edge = |a: &[f64; 2], b: &[f64; 2]| {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let along = (((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
        libm::hypot(a[0] + along * dx - x, a[1] + along * dy - y)
    };
    edges().map(|(a, b)| to_edge(a, b)).fold(f64::INFINITY, f64::min)
}

impl fmt::Display for Ball {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{},{},{}", self.x, self.y, self.r)
    }
}

impl From<[f64; 3]> for Ball {
    fn from([x, y, r]: [f64; 3]) -> Ball {
        Ball { x, y, r }
    }
}

impl From<Ball> for [f64; 3] {
    fn from(ball: Ball) -> [f64; 3] {
        [ball.x, ball.y, ball.r]
    }
}

impl From<[f64; 3]> for Action {
    fn from([x, y, r]: [f64; 3]) -> Action {
        Action { x, y, r }
    }
}

impl From<Action> for [f64; 3] {
    fn from(action: Action) -> [f64; 3] {
        [action.x, action.y, action.r]
    }
}

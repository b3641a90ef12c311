//! Actions: three numbers in 0..=1 that place the red ball, and the one rule that decides whether it is valid.
//!
//! The page, the wasm exports and the commands all use this rule, so that a ball is valid in all of them or in none.
//! Only valid balls count as attempts. The mapping and the rule are PHYRE's (v0.2.2, ball tier). Code that checks
//! many balls in one scene prepares its `Obstacles` once.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::puzzle::scene::{Body, Role, SIZE, Scene, Shape, ShapeType};

/// Smallest and largest radius of the action ball, px.
pub const RADIUS: std::ops::RangeInclusive<f64> = 2.0..=32.0;

/// Two bodies overlap if they are nearer than touching by more than this, px (PHYRE).
const TOLERANCE: f64 = 1e-5;

/// A point of the action space: x, y and radius, each in 0..=1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(into = "[f64; 3]", from = "[f64; 3]")]
pub struct Action {
    pub x: f64,
    pub y: f64,
    pub r: f64,
}

/// The red ball in the scene, px: its centre and its radius. Whole numbers if an action placed it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(into = "[f64; 3]", from = "[f64; 3]")]
pub struct Ball {
    pub x: f64,
    pub y: f64,
    pub r: f64,
}

/// Why an action or a ball is invalid.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Invalid {
    #[error("x, y and r of an action must be between 0 and 1")]
    OutOfRange,
    #[error("the radius of the ball must be between 2 and 32 px")]
    Radius,
    #[error("the ball sticks out of the scene")]
    Outside,
    /// The index of a body of the scene.
    #[error("the ball overlaps body {0}")]
    Overlaps(usize),
}

impl Action {
    /// Returns the ball that this action places in a scene.
    ///
    /// # Errors
    /// The reason why the action is invalid in this scene.
    pub fn place(self, scene: &Scene) -> Result<Ball, Invalid> {
        Obstacles::new(scene).place(self)
    }

    /// Returns the ball of this action before rounding, px.
    fn unrounded(self) -> Ball {
        Ball {
            x: self.x * (SIZE - 1.0),
            y: self.y * (SIZE - 1.0),
            r: RADIUS.start() + (RADIUS.end() - RADIUS.start()) * self.r,
        }
    }
}

impl Ball {
    /// Checks that this ball is valid in a scene: inside it, and overlapping no body.
    ///
    /// # Errors
    /// The reason why it is invalid.
    pub fn check(&self, scene: &Scene) -> Result<(), Invalid> {
        Obstacles::new(scene).check(self)
    }

    /// Returns this ball with PHYRE's rounding: the centre truncated, the radius rounded half to even. Does not check
    /// that it is valid.
    pub fn rounded(&self) -> Ball {
        Ball { x: self.x.trunc(), y: self.y.trunc(), r: self.r.round_ties_even() }
    }

    /// Returns the ball as a body at rest.
    pub fn body(&self) -> Body {
        let shapes = vec![Shape::Circle(self.r)];
        Body { x: self.x, y: self.y, angle: 0.0, dynamic: true, shape_type: ShapeType::Ball, role: Role::Red, shapes }
    }

    /// Returns the action that places this ball, before rounding.
    pub fn action(&self) -> Action {
        Action {
            x: self.x / (SIZE - 1.0),
            y: self.y / (SIZE - 1.0),
            r: (self.r - RADIUS.start()) / (RADIUS.end() - RADIUS.start()),
        }
    }

    fn check_inside_scene(&self) -> Result<(), Invalid> {
        let span = self.r..=SIZE - self.r;
        if span.contains(&self.x) && span.contains(&self.y) { Ok(()) } else { Err(Invalid::Outside) }
    }
}

/// The shapes of a scene that a ball may not overlap, prepared once so that many balls can be checked quickly.
pub struct Obstacles(Vec<Obstacle>);

/// A shape in scene coordinates (px).
struct Obstacle {
    /// The index of its body in the scene.
    body: usize,
    origin: [f64; 2],
    shape: Shape,
}

impl Obstacles {
    /// Returns the obstacles of a scene. The walls are not among them: a ball inside the scene cannot overlap them.
    pub fn new(scene: &Scene) -> Obstacles {
        let shapes = scene.bodies.iter().enumerate().flat_map(|(index, body)| {
            body.shapes.iter().map(move |shape| {
                let shape = match shape {
                    Shape::Circle(radius) => Shape::Circle(*radius),
                    Shape::Polygon(corners) => {
                        Shape::Polygon(corners.iter().map(|&corner| body.to_scene(corner)).collect())
                    }
                };
                Obstacle { body: index, origin: [body.x, body.y], shape }
            })
        });
        Obstacles(shapes.collect())
    }

    /// Returns the ball that an action places among these obstacles.
    ///
    /// # Errors
    /// The reason why the action is invalid there.
    pub fn place(&self, action: Action) -> Result<Ball, Invalid> {
        if ![action.x, action.y, action.r].iter().all(|value| (0.0..=1.0).contains(value)) {
            return Err(Invalid::OutOfRange);
        }
        // PHYRE checks that the ball is inside the scene before it rounds, and what it overlaps after.
        let ball = action.unrounded();
        ball.check_inside_scene()?;
        let ball = ball.rounded();
        self.check(&ball)?;
        Ok(ball)
    }

    /// Checks that a ball is inside the scene and overlaps none of these obstacles.
    ///
    /// # Errors
    /// The reason why it is invalid.
    pub fn check(&self, ball: &Ball) -> Result<(), Invalid> {
        if !RADIUS.contains(&ball.r) {
            return Err(Invalid::Radius);
        }
        ball.check_inside_scene()?;
        match self.0.iter().find(|obstacle| obstacle.overlaps(ball)) {
            Some(obstacle) => Err(Invalid::Overlaps(obstacle.body)),
            None => Ok(()),
        }
    }
}

impl Obstacle {
    /// Touching is not overlapping.
    fn overlaps(&self, ball: &Ball) -> bool {
        match &self.shape {
            Shape::Circle(radius) => {
                libm::hypot(ball.x - self.origin[0], ball.y - self.origin[1]) + TOLERANCE < ball.r + radius
            }
            Shape::Polygon(corners) => distance_to_polygon([ball.x, ball.y], corners) + TOLERANCE < ball.r,
        }
    }
}

/// Returns the distance from a point to a convex, counter-clockwise polygon; 0 inside. Any unit of length.
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

//! Actions: three numbers in 0..=1 that place the red ball, and the one rule that decides whether the ball is valid.
//!
//! The page, the wasm exports and the commands all use this rule, so that a ball is valid in all of them or in none.
//! Only valid balls count as attempts. The mapping and the rule are PHYRE's (v0.2.2, ball tier). Code that checks many
//! balls in one scene prepares its `Obstacles` once.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::puzzle::scene::{Body, Role, SIZE, Scene, Shape, ShapeType};
use crate::puzzle::scene_form::FormFault;

/// Smallest and largest radius of the action ball, px.
pub const RADIUS: std::ops::RangeInclusive<f64> = 2.0..=32.0;

/// Two bodies overlap if they are closer than touching by more than this, px (PHYRE).
const TOLERANCE: f64 = 1e-5;

/// Margin around a bounding box, px: more than the rounding errors of distances in a scene.
const MARGIN: f64 = 1e-9;

/// A point of the action space: x, y and radius, each in 0..=1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(into = "[f64; 3]", from = "[f64; 3]")]
pub struct Action {
    /// From the left edge of the scene to the right.
    pub x: f64,
    /// From the bottom edge to the top.
    pub y: f64,
    /// From the smallest radius to the largest.
    pub r: f64,
}

/// The red ball in the scene, px: its centre and its radius. Whole numbers if an action placed it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(into = "[f64; 3]", from = "[f64; 3]")]
pub struct Ball {
    /// x of the centre, px from the left.
    pub x: f64,
    /// y of the centre, px from the bottom.
    pub y: f64,
    /// The radius, px.
    pub r: f64,
}

/// Why an action or a ball is invalid, or why a scene cannot be simulated at all.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs, reason = "the messages say it")]
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
    #[error(transparent)]
    Scene(#[from] FormFault),
}

impl Action {
    /// Returns the ball that this action places in a scene.
    ///
    /// # Errors
    /// The reason why the action is invalid in this scene.
    pub fn place(self, scene: &Scene) -> Result<Ball, Invalid> {
        Obstacles::new(scene).place(self)
    }

    /// Checks that the numbers are in 0..=1 and that the ball, before rounding, is inside the scene.
    ///
    /// # Errors
    ///
    /// The reason why the action is invalid in every scene.
    pub fn check_bounds(self) -> Result<(), Invalid> {
        if ![self.x, self.y, self.r].iter().all(|value| (0.0..=1.0).contains(value)) {
            return Err(Invalid::OutOfRange);
        }
        self.unrounded().check_inside_scene()
    }

    /// Returns the ball of this action before rounding, px.
    fn unrounded(self) -> Ball {
        let [x, y] = [self.x, self.y].map(|value| value * (SIZE - 1.0));
        Ball { x, y, r: RADIUS.start() + (RADIUS.end() - RADIUS.start()) * self.r }
    }
}

impl Ball {
    /// Checks that this ball is valid in a scene: it is inside and overlaps no body.
    ///
    /// # Errors
    ///
    /// The reason why it is invalid.
    pub fn check(&self, scene: &Scene) -> Result<(), Invalid> {
        Obstacles::new(scene).check(self)
    }

    /// Checks that this ball has a valid radius and is inside the scene; it may overlap bodies.
    ///
    /// # Errors
    ///
    /// The reason why it is invalid.
    pub fn check_bounds(&self) -> Result<(), Invalid> {
        if !RADIUS.contains(&self.r) {
            return Err(Invalid::Radius);
        }
        self.check_inside_scene()
    }

    /// Returns this ball with PHYRE's rounding: the centre truncated, the radius rounded half to even. Does not check
    /// whether it is valid.
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

/// The shapes of a scene that a ball must not overlap, prepared once so that many balls can be checked quickly. Empty
/// by default.
#[derive(Default)]
pub struct Obstacles(Vec<Obstacle>);

/// A shape in scene coordinates (px) with its bounding box and a margin.
struct Obstacle {
    /// The index of its body in the scene.
    body: usize,
    lowest: [f64; 2],
    highest: [f64; 2],
    outline: Outline,
}

enum Outline {
    Circle {
        centre: [f64; 2],
        radius: f64,
    },
    /// The edges of a convex polygon, counter-clockwise.
    Polygon(Vec<Edge>),
}

struct Edge {
    start: [f64; 2],
    /// From the start of the edge to its end.
    vector: [f64; 2],
    squared_length: f64,
}

impl Obstacles {
    /// Returns the obstacles of a scene. They do not include the walls, which a ball inside the scene cannot overlap.
    pub fn new(scene: &Scene) -> Obstacles {
        let bodies = scene.bodies.iter().enumerate();
        Obstacles(
            bodies
                .flat_map(|(index, body)| body.shapes.iter().map(move |shape| Obstacle::new(index, body, shape)))
                .collect(),
        )
    }

    /// Returns the ball that an action places among these obstacles.
    ///
    /// # Errors
    /// The reason why the action is invalid there.
    pub fn place(&self, action: Action) -> Result<Ball, Invalid> {
        // PHYRE rounds between the two checks.
        action.check_bounds()?;
        let ball = action.unrounded().rounded();
        self.check(&ball)?;
        Ok(ball)
    }

    /// Checks that a ball is inside the scene and overlaps none of these obstacles.
    ///
    /// # Errors
    /// The reason why it is invalid.
    pub fn check(&self, ball: &Ball) -> Result<(), Invalid> {
        ball.check_bounds()?;
        match self.0.iter().find(|obstacle| overlaps(obstacle.clearance([ball.x, ball.y], ball.r), ball.r)) {
            Some(obstacle) => Err(Invalid::Overlaps(obstacle.body)),
            None => Ok(()),
        }
    }

    /// Returns the clearance of a point: its distance to the nearest obstacle, or `limit` if that is smaller, px. It is
    /// not positive inside an obstacle. One clearance decides the validity of balls of all radii up to `limit`: see
    /// `overlaps`.
    pub fn clearance(&self, point: [f64; 2], limit: f64) -> f64 {
        self.0.iter().fold(limit, |nearest, obstacle| obstacle.clearance(point, nearest))
    }
}

/// Returns whether a ball of this radius overlaps an obstacle, given the clearance of its centre. Touching is not
/// overlapping.
pub fn overlaps(clearance: f64, radius: f64) -> bool {
    clearance + TOLERANCE < radius
}

impl Obstacle {
    fn new(body_index: usize, body: &Body, shape: &Shape) -> Obstacle {
        let centre = [body.x, body.y];
        let (corners, radius, outline) = match shape {
            Shape::Circle(radius) => (vec![centre], *radius, Outline::Circle { centre, radius: *radius }),
            Shape::Polygon(corners) => {
                let corners: Vec<[f64; 2]> = corners.iter().map(|&corner| body.to_scene(corner)).collect();
                let ends = corners.iter().cycle().skip(1);
                let edges = corners.iter().zip(ends).map(|(&start, end)| {
                    let vector = [end[0] - start[0], end[1] - start[1]];
                    Edge { start, vector, squared_length: squared_norm(vector) }
                });
                let outline = Outline::Polygon(edges.collect());
                (corners, 0.0, outline)
            }
        };
        let extreme = |start: f64, pick: fn(f64, f64) -> f64| {
            [0, 1].map(|axis| corners.iter().map(|corner| corner[axis]).fold(start, pick))
        };
        let lowest = extreme(f64::INFINITY, f64::min).map(|low| low - radius - MARGIN);
        let highest = extreme(f64::NEG_INFINITY, f64::max).map(|high| high + radius + MARGIN);
        Obstacle { body: body_index, lowest, highest, outline }
    }

    /// Returns the distance from a point, or `limit` if that is smaller, px; not positive inside.
    fn clearance(&self, point @ [x, y]: [f64; 2], limit: f64) -> f64 {
        // The bounding box is never farther away than its shape, even by rounding.
        let beyond =
            |axis: usize| self.lowest[axis] - point[axis] >= limit || point[axis] - self.highest[axis] >= limit;
        if beyond(0) || beyond(1) {
            return limit;
        }
        let distance = match &self.outline {
            Outline::Circle { centre, radius } => squared_norm([x - centre[0], y - centre[1]]).sqrt() - radius,
            Outline::Polygon(edges) => distance_to_polygon(point, edges),
        };
        distance.min(limit)
    }
}

/// Returns the distance from a point to a convex polygon, px; 0 inside.
fn distance_to_polygon([x, y]: [f64; 2], edges: &[Edge]) -> f64 {
    let (mut inside, mut nearest) = (true, f64::INFINITY);
    for Edge { start, vector: [dx, dy], squared_length } in edges {
        let (px, py) = (x - start[0], y - start[1]);
        inside &= dx * py - dy * px >= 0.0;
        let along = ((px * dx + py * dy) / squared_length).clamp(0.0, 1.0);
        nearest = nearest.min(squared_norm([px - along * dx, py - along * dy]));
    }
    if inside { 0.0 } else { nearest.sqrt() }
}

fn squared_norm([x, y]: [f64; 2]) -> f64 {
    x * x + y * y
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

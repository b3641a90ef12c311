//! A scene as plain data: bodies with their roles, and which two of them must touch.
//!
//! The scene is 256 x 256 px, origin at the bottom left, y up; angles are radians, counter-clockwise.
//! Everyone reads scenes; only `layout` makes them. Knows nothing of engines, pixels or nets.

use serde::{Deserialize, Serialize};

/// Width and height of every scene, px.
pub const SIZE: f64 = 256.0;

/// Thickness of the four walls that stand just outside the scene, px.
const WALL: f64 = 5.0;

/// What a body is made as.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Shape {
    Ball,
    Bar,
    Jar,
    StandingSticks,
}

/// What a body is for, named by PHYRE's colour for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Role {
    /// The dynamic body that has to reach the goal: body1 of every task.
    Green,
    /// A goal that moves.
    Blue,
    /// A goal that stands still.
    Purple,
    /// Dynamic, no part of the goal.
    Gray,
    /// Static, no part of the goal; the walls too.
    Black,
    /// The action ball. It is no part of a scene.
    Red,
}

/// One convex part of a body, in body coordinates (px).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Part {
    /// A circle of this radius round the body's origin.
    Circle(f64),
    /// A convex polygon, counter-clockwise.
    Polygon(Vec<[f64; 2]>),
}

/// One rigid body: a position, an angle, and one or more convex parts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// Position of the origin, px.
    pub x: f64,
    /// Position of the origin, px, up.
    pub y: f64,
    /// Radians, counter-clockwise, not wrapped.
    pub angle: f64,
    pub dynamic: bool,
    pub shape: Shape,
    pub role: Role,
    pub parts: Vec<Part>,
}

impl Body {
    /// Where a point in body coordinates lies in the scene, px.
    pub fn to_scene(&self, [a, b]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = (libm::sin(self.angle), libm::cos(self.angle));
        [self.x + a * cos - b * sin, self.y + a * sin + b * cos]
    }

    /// Colour and shape in words: "green ball".
    pub fn name(&self) -> String {
        let colour = match self.role {
            Role::Green => "green",
            Role::Blue => "blue",
            Role::Purple => "purple",
            Role::Gray => "gray",
            Role::Black => "black",
            Role::Red => "red",
        };
        let shape = match self.shape {
            Shape::Ball => "ball",
            Shape::Bar => "bar",
            Shape::Jar => "jar",
            Shape::StandingSticks => "standing sticks",
        };
        format!("{colour} {shape}")
    }

    /// The radius, if the body is a single ball.
    pub fn ball_radius(&self) -> Option<f64> {
        match self.parts.as_slice() {
            [Part::Circle(radius)] => Some(*radius),
            _ => None,
        }
    }
}

/// The bodies of a task, without the walls, and the goal: `body1` touches `body2` for three seconds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Scene {
    /// Index into `bodies` of the green object.
    pub body1: usize,
    /// Index into `bodies` of the blue or purple goal.
    pub body2: usize,
    pub bodies: Vec<Body>,
}

/// The four static walls just outside every scene: bottom, left, top, right.
pub fn walls() -> [Body; 4] {
    let wall = |x, y, width: f64, height: f64| Body {
        x,
        y,
        angle: 0.0,
        dynamic: false,
        shape: Shape::Bar,
        role: Role::Black,
        parts: vec![rectangle(width, height)],
    };
    let (middle, outside) = (SIZE / 2.0, SIZE + WALL / 2.0);
    [
        wall(middle, -WALL / 2.0, SIZE, WALL),
        wall(-WALL / 2.0, middle, WALL, SIZE),
        wall(middle, outside, SIZE, WALL),
        wall(outside, middle, WALL, SIZE),
    ]
}

/// A rectangle round the origin, `width` x `height` px.
pub fn rectangle(width: f64, height: f64) -> Part {
    let (w, h) = (width / 2.0, height / 2.0);
    Part::Polygon(vec![[w, h], [-w, h], [-w, -h], [w, -h]])
}

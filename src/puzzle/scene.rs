//! A scene as plain data: bodies with their roles, and the two that must touch.
//!
//! The scene is 256 x 256 px, origin at the bottom left, y up; angles are radians, counter-clockwise. Produced by
//! `layout` and `custom_scene`, read by everything else. Depends on nothing. `ShapeType` and `Shape` are PHYRE's names;
//! the JSON keys are those of `pathlight tasks --json`.

use serde::{Deserialize, Serialize};

/// Width and height of every scene, px.
pub const SIZE: f64 = 256.0;

/// Thickness of the four walls just outside the scene, px.
const WALL: f64 = 5.0;

/// The kind of a body, by its shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum ShapeType {
    /// One circle.
    Ball,
    /// One rectangle.
    Bar,
    /// A base and two walls.
    Jar,
    /// Two crossed bars.
    StandingSticks,
}

/// The role of a body, named by PHYRE's colour for it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Role {
    /// The dynamic body that must touch the goal: body1 of every task.
    Green,
    /// A dynamic goal.
    Blue,
    /// A static goal.
    Purple,
    /// Dynamic, not part of the goal.
    Gray,
    /// Static, not part of the goal; also the walls.
    Black,
    /// The action ball, which is not part of a scene.
    Red,
}

/// One convex shape of a body, in body coordinates (px).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Shape {
    /// A circle of this radius around the body's origin.
    Circle(f64),
    /// A convex polygon, counter-clockwise.
    Polygon(Vec<[f64; 2]>),
}

/// One rigid body: position, angle, and one or more convex shapes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Body {
    /// x of the origin, px.
    pub x: f64,
    /// y of the origin, px, upwards.
    pub y: f64,
    /// Radians, counter-clockwise, not wrapped.
    pub angle: f64,
    /// Whether it moves.
    pub dynamic: bool,
    /// The kind of the body.
    #[serde(rename = "shape")]
    pub shape_type: ShapeType,
    /// The role of the body in the task.
    pub role: Role,
    /// The convex shapes, in the frame of the origin.
    #[serde(rename = "parts")]
    pub shapes: Vec<Shape>,
}

impl Body {
    /// Transforms a point from body to scene coordinates, px.
    pub fn to_scene(&self, [a, b]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = (libm::sin(self.angle), libm::cos(self.angle));
        [self.x + a * cos - b * sin, self.y + a * sin + b * cos]
    }

    /// Returns the bounding box in the scene: left, bottom, right, top, px.
    pub fn bounds(&self) -> [f64; 4] {
        let extremes = self.shapes.iter().flat_map(|shape| match shape {
            Shape::Circle(r) => vec![[self.x - r, self.y - r], [self.x + r, self.y + r]],
            Shape::Polygon(corners) => corners.iter().map(|&corner| self.to_scene(corner)).collect(),
        });
        extremes.fold([f64::INFINITY, f64::INFINITY, f64::NEG_INFINITY, f64::NEG_INFINITY], |[l, b, r, t], [x, y]| {
            [l.min(x), b.min(y), r.max(x), t.max(y)]
        })
    }

    /// Returns how far the body reaches in a direction, a unit vector, from the origin of the scene, px.
    pub fn reach(&self, [x, y]: [f64; 2]) -> f64 {
        let along = |[a, b]: [f64; 2]| a * x + b * y;
        let reaches = self.shapes.iter().flat_map(|shape| match shape {
            Shape::Circle(r) => vec![along([self.x, self.y]) + r],
            Shape::Polygon(corners) => corners.iter().map(|&corner| along(self.to_scene(corner))).collect(),
        });
        reaches.fold(f64::NEG_INFINITY, f64::max)
    }

    /// Returns the colour and shape in words: "green ball".
    pub fn name(&self) -> String {
        let colour = match self.role {
            Role::Green => "green",
            Role::Blue => "blue",
            Role::Purple => "purple",
            Role::Gray => "gray",
            Role::Black => "black",
            Role::Red => "red",
        };
        let shape = match self.shape_type {
            ShapeType::Ball => "ball",
            ShapeType::Bar => "bar",
            ShapeType::Jar => "jar",
            ShapeType::StandingSticks => "standing sticks",
        };
        format!("{colour} {shape}")
    }

    /// Returns the radius if the body is a single circle, px.
    pub fn ball_radius(&self) -> Option<f64> {
        match self.shapes.as_slice() {
            [Shape::Circle(radius)] => Some(*radius),
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
    /// All bodies, in PHYRE's order.
    pub bodies: Vec<Body>,
}

/// Returns the four static walls just outside every scene: bottom, left, top, right.
pub fn walls() -> [Body; 4] {
    let wall = |x, y, width: f64, height: f64| Body {
        x,
        y,
        angle: 0.0,
        dynamic: false,
        shape_type: ShapeType::Bar,
        role: Role::Black,
        shapes: vec![rectangle(width, height)],
    };
    let (middle, outside) = (SIZE / 2.0, SIZE + WALL / 2.0);
    [
        wall(middle, -WALL / 2.0, SIZE, WALL),
        wall(-WALL / 2.0, middle, WALL, SIZE),
        wall(middle, outside, SIZE, WALL),
        wall(outside, middle, WALL, SIZE),
    ]
}

/// Returns a rectangle centred on the origin, `width` x `height` px.
pub fn rectangle(width: f64, height: f64) -> Shape {
    let (w, h) = (width / 2.0, height / 2.0);
    Shape::Polygon(vec![[w, h], [-w, h], [-w, -h], [w, -h]])
}

//! The language in which templates are written: a builder for bodies and scenes.
//!
//! A template makes bodies (`static_body` or `dynamic_body`; ball, bar, jar, standing sticks), rotates them, and aligns
//! an edge of each, often with an edge of another body. Each method acts immediately, on the body's current bounding
//! box. The template then marks the object and the goal and builds the scene with `scene`. Used only by `templates`;
//! must not depend on parameters or tasks. The formulas are PHYRE's (v0.2.2, `creator`).

use crate::puzzle::dimensions::{Dimensions, THICKNESS, radians};
use crate::puzzle::scene::{Body, Role, SIZE, Scene};

pub use ScaledShape::{Ball, Bar, Jar, StandingSticks};

/// A type of shape with its scale s; 1.0 spans the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ScaledShape {
    /// One circle of radius trunc(128 s) + 0.5 px.
    Ball(f64),
    /// A thin rectangle, 256 s px long.
    Bar(f64),
    /// A base and two walls that lean outwards, 256 s px high. The origin is the middle of the base.
    Jar(f64),
    /// Two crossed sticks, each two thirds of a bar of this scale, leaning 12.5 degrees from upright.
    StandingSticks(f64),
}

impl ScaledShape {
    fn dimensions(self) -> Dimensions {
        match self {
            ScaledShape::Ball(scale) => Dimensions::Ball { radius: (SIZE / 2.0 * scale).trunc() + 0.5 },
            ScaledShape::Bar(scale) => Dimensions::Bar { length: SIZE * scale, thickness: THICKNESS },
            ScaledShape::Jar(scale) => Dimensions::Jar { height: SIZE * scale },
            ScaledShape::StandingSticks(scale) => Dimensions::StandingSticks { length: SIZE * scale / 3.0 * 2.0 },
        }
    }
}

/// A body under construction. Every method acts immediately on its current state.
#[derive(Clone, Debug)]
pub struct BodyBuilder(Body);

/// Returns a static body at the origin.
pub fn static_body(shape: ScaledShape) -> BodyBuilder {
    body(shape, false, Role::Black)
}

/// Returns a dynamic body at the origin.
pub fn dynamic_body(shape: ScaledShape) -> BodyBuilder {
    body(shape, true, Role::Gray)
}

fn body(shape: ScaledShape, dynamic: bool, role: Role) -> BodyBuilder {
    let dimensions = shape.dimensions();
    let (shape_type, shapes) = (dimensions.shape_type(), dimensions.shapes());
    BodyBuilder(Body { x: 0.0, y: 0.0, angle: 0.0, dynamic, shape_type, role, shapes })
}

impl BodyBuilder {
    /// Marks the body that must touch the goal: body1.
    pub fn object(mut self) -> Self {
        self.0.role = Role::Green;
        self
    }

    /// Marks the body that the object must touch: body2.
    pub fn goal(mut self) -> Self {
        self.0.role = if self.0.dynamic { Role::Blue } else { Role::Purple };
        self
    }

    /// Rotates the body about its origin to this angle, degrees.
    pub fn rotated(mut self, degrees: f64) -> Self {
        self.0.angle = radians(degrees);
        self
    }

    /// Moves the origin to this position, px.
    pub fn at(mut self, x: f64, y: f64) -> Self {
        (self.0.x, self.0.y) = (x, y);
        self
    }

    /// Moves the body sideways by this distance, px.
    pub fn shifted(mut self, by: f64) -> Self {
        self.0.x += by;
        self
    }

    /// Moves the left edge to this x, px.
    pub fn at_left(mut self, edge: f64) -> Self {
        self.0.x += edge - self.left();
        self
    }

    /// Moves the right edge to this x, px.
    pub fn at_right(mut self, edge: f64) -> Self {
        self.0.x += edge - self.right();
        self
    }

    /// Moves the upper edge to this y, px.
    pub fn at_top(mut self, edge: f64) -> Self {
        self.0.y += edge - self.top();
        self
    }

    /// Moves the lower edge to this y, px.
    pub fn at_bottom(mut self, edge: f64) -> Self {
        self.0.y += edge - self.bottom();
        self
    }

    /// Moves the centre of the bounding box (not the origin) to this x, px.
    pub fn at_cx(self, x: f64) -> Self {
        let left = x - self.width() / 2.0;
        self.at_left(left)
    }

    /// Moves the centre of the bounding box (not the origin) to this y, px.
    pub fn at_cy(self, y: f64) -> Self {
        let bottom = y - self.height() / 2.0;
        self.at_bottom(bottom)
    }

    /// Returns the left edge of the bounding box, px.
    pub fn left(&self) -> f64 {
        self.0.bounds()[0]
    }

    /// Returns the right edge of the bounding box, px.
    pub fn right(&self) -> f64 {
        self.0.bounds()[2]
    }

    /// Returns the lower edge of the bounding box, px.
    pub fn bottom(&self) -> f64 {
        self.0.bounds()[1]
    }

    /// Returns the upper edge of the bounding box, px.
    pub fn top(&self) -> f64 {
        self.0.bounds()[3]
    }

    /// Returns the width of the bounding box, px.
    pub fn width(&self) -> f64 {
        self.right() - self.left()
    }

    /// Returns the height of the bounding box, px.
    pub fn height(&self) -> f64 {
        self.top() - self.bottom()
    }

    /// Returns x of the centre of the bounding box, px.
    pub fn cx(&self) -> f64 {
        (self.left() + self.right()) / 2.0
    }

    /// Returns y of the centre of the bounding box, px.
    pub fn cy(&self) -> f64 {
        (self.bottom() + self.top()) / 2.0
    }
}

/// Returns the scene of these bodies, in this order, with the marked ones as its goal.
///
/// # Panics
/// Unless exactly one body is marked as the object and one as the goal: the template's script is wrong.
pub fn scene(bodies: impl IntoIterator<Item = BodyBuilder>) -> Scene {
    let bodies: Vec<Body> = bodies.into_iter().map(|BodyBuilder(body)| body).collect();
    let only = |roles: &[Role]| {
        let mut marked = (0..bodies.len()).filter(|&index| roles.contains(&bodies[index].role));
        let first = marked.next().expect("a script marks its object and its goal");
        assert!(marked.next().is_none(), "a script marks one object and one goal");
        first
    };
    Scene { body1: only(&[Role::Green]), body2: only(&[Role::Blue, Role::Purple]), bodies }
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::puzzle::scene::Shape;

    fn scaled_shapes() -> impl Strategy<Value = ScaledShape> {
        let kinds: [fn(f64) -> ScaledShape; 4] = [Ball, Bar, Jar, StandingSticks];
        (prop::sample::select(kinds.to_vec()), 0.02..1.2).prop_map(|(kind, scale)| kind(scale))
    }

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-9
    }

    proptest! {
        #[test]
        fn an_edge_moves_to_where_it_is_aligned(shape in scaled_shapes(), degrees in -400.0..400.0, to in -300.0..300.0) {
            let body = static_body(shape).rotated(degrees);
            prop_assert!(close(body.clone().at_left(to).left(), to));
            prop_assert!(close(body.clone().at_right(to).right(), to));
            prop_assert!(close(body.clone().at_top(to).top(), to));
            prop_assert!(close(body.clone().at_bottom(to).bottom(), to));
            prop_assert!(close(body.clone().at_cx(to).cx(), to));
            prop_assert!(close(body.clone().at_cy(to).cy(), to));
        }

        #[test]
        fn alignment_keeps_the_size_and_the_other_axis(shape in scaled_shapes(), degrees in -400.0..400.0, to in -300.0..300.0) {
            let body = dynamic_body(shape).rotated(degrees).at(10.0, 20.0);
            let moved = body.clone().at_right(to);
            prop_assert!(close(moved.width(), body.width()) && close(moved.height(), body.height()));
            prop_assert_eq!(moved.bottom(), body.bottom());
        }

        #[test]
        fn polygons_are_convex_and_counter_clockwise(shape in scaled_shapes()) {
            for convex in shape.dimensions().shapes() {
                let Shape::Polygon(corners) = convex else { continue };
                for i in 0..corners.len() {
                    let [a, b, c] = [0, 1, 2].map(|k| corners[(i + k) % corners.len()]);
                    prop_assert!((b[0] - a[0]) * (c[1] - b[1]) > (b[1] - a[1]) * (c[0] - b[0]), "{:?}", corners);
                }
            }
        }
    }

    #[test]
    fn the_radius_of_a_ball_is_a_whole_number_and_a_half() {
        let radius = |scale| Ball(scale).dimensions().shapes();
        assert_eq!(radius(0.05), [Shape::Circle(6.5)]);
        assert_eq!(radius(0.1), [Shape::Circle(12.5)]);
        assert_eq!(radius(0.25), [Shape::Circle(32.5)]);
    }

    #[test]
    fn a_jar_stands_on_its_base_and_is_wider_at_the_rim() {
        let jar = static_body(Jar(0.1));
        assert!(close(jar.width(), 25.6 / 1.2));
        assert!(close(jar.height(), 25.6));
        let Shape::Polygon(wall) = &Jar(0.1).dimensions().shapes()[1] else { panic!("a wall is a polygon") };
        assert!((wall[2][0] + 4.722242).abs() < 1e-6 && (wall[2][1] + 1.594560).abs() < 1e-6, "{wall:?}");
    }

    #[test]
    fn a_ball_has_the_same_bounding_box_at_any_angle() {
        assert_eq!(static_body(Ball(0.1)).rotated(33.0).width(), 25.0);
    }

    #[test]
    #[should_panic(expected = "marks its object and its goal")]
    fn a_scene_without_a_goal_panics() {
        scene([dynamic_body(Ball(0.1)).object()]);
    }
}

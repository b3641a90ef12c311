//! The small language that templates are written in.
//!
//! A template makes pieces (`fixed` or `dynamic`; ball, bar, jar, standing sticks), turns them, and puts
//! an edge of each somewhere, often at an edge of another piece. Each word acts at once, on the outline of
//! the turned piece. Then it marks the object and the goal and closes the scene with `scene`.
//! Used by `templates` alone; it knows no parameters and no tasks. The formulas are PHYRE's (v0.2.2, `creator`).

use std::f64::consts::PI;

use crate::puzzle::scene::{Body, Part, Role, SIZE, Scene, Shape, rectangle};

pub use Form::{Ball, Bar, Jar, StandingSticks};

/// Thickness of a bar, px; also scales the walls of a jar and the sticks.
const THICKNESS: f64 = 5.12;

/// A shape by its one scale number s; 1.0 spans the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Form {
    /// One circle of radius trunc(128 s) + 0.5 px.
    Ball(f64),
    /// A thin rectangle, 256 s px long.
    Bar(f64),
    /// A base and two walls that lean outwards, 256 s px high. The origin is the middle of the base.
    Jar(f64),
    /// Two crossed sticks, each two thirds of a bar of this scale, leaning 12.5 degrees from upright.
    StandingSticks(f64),
}

impl Form {
    fn shape(self) -> Shape {
        match self {
            Form::Ball(_) => Shape::Ball,
            Form::Bar(_) => Shape::Bar,
            Form::Jar(_) => Shape::Jar,
            Form::StandingSticks(_) => Shape::StandingSticks,
        }
    }

    fn parts(self) -> Vec<Part> {
        match self {
            Form::Ball(scale) => vec![Part::Circle((SIZE / 2.0 * scale).trunc() + 0.5)],
            Form::Bar(scale) => vec![rectangle(SIZE * scale, THICKNESS)],
            Form::Jar(scale) => jar(SIZE * scale),
            Form::StandingSticks(scale) => vec![stick(scale, -77.5), stick(scale, 77.5)],
        }
    }
}

/// The base and the two walls of a jar of this height, px. They overlap in the lower corners.
fn jar(height: f64) -> Vec<Part> {
    let width = height / 1.2;
    let base = 0.8 * width;
    let t = THICKNESS * libm::log(height) / libm::log(0.3 * SIZE);
    let lean = (width - base) / 2.0;
    let slant = libm::sqrt(height * height + lean * lean);
    // The leaning wall's thickness: p along the base and v above it at the foot, q along the rim.
    let (p, q, v) = (t * height / slant, t * slant / height, t * lean / slant);
    let (w, b) = (width / 2.0, base / 2.0);
    let (rim, foot) = (height - t / 2.0, -t / 2.0);
    vec![
        rectangle(base, t),
        Part::Polygon(vec![[-w, rim], [-b, foot], [-b + p, v + foot], [-w + q, rim]]),
        Part::Polygon(vec![[w, rim], [w - q, rim], [b - p, v + foot], [b, foot]]),
    ]
}

fn stick(scale: f64, degrees: f64) -> Part {
    let (a, b) = (SIZE * scale / 3.0, THICKNESS / 3.0);
    let (sin, cos) = (libm::sin(radians(degrees)), libm::cos(radians(degrees)));
    let turned = |a: f64, b: f64| [a * cos - b * sin, a * sin + b * cos];
    Part::Polygon(vec![turned(a, b), turned(-a, b), turned(-a, -b), turned(a, -b)])
}

/// Degrees in radians, rounded as PHYRE rounds.
pub fn radians(degrees: f64) -> f64 {
    degrees / 180.0 * PI
}

/// A body under construction. Every word acts at once, on the piece as it is then.
#[derive(Clone, Debug)]
pub struct Piece(Body);

/// A static piece at the origin.
pub fn fixed(form: Form) -> Piece {
    piece(form, false, Role::Black)
}

/// A dynamic piece at the origin.
pub fn dynamic(form: Form) -> Piece {
    piece(form, true, Role::Gray)
}

fn piece(form: Form, dynamic: bool, role: Role) -> Piece {
    Piece(Body { x: 0.0, y: 0.0, angle: 0.0, dynamic, shape: form.shape(), role, parts: form.parts() })
}

impl Piece {
    /// Marks the piece that has to reach the goal: body1.
    pub fn object(mut self) -> Self {
        self.0.role = Role::Green;
        self
    }

    /// Marks the piece that the object has to touch: body2.
    pub fn goal(mut self) -> Self {
        self.0.role = if self.0.dynamic { Role::Blue } else { Role::Purple };
        self
    }

    /// Turns the piece about its origin, to this angle.
    pub fn turned(mut self, degrees: f64) -> Self {
        self.0.angle = radians(degrees);
        self
    }

    /// Puts the origin here, px.
    pub fn at(mut self, x: f64, y: f64) -> Self {
        (self.0.x, self.0.y) = (x, y);
        self
    }

    /// Moves the piece sideways, px.
    pub fn shifted(mut self, by: f64) -> Self {
        self.0.x += by;
        self
    }

    /// Moves the left edge here, px.
    pub fn at_left(mut self, edge: f64) -> Self {
        self.0.x += edge - self.left();
        self
    }

    /// Moves the right edge here, px.
    pub fn at_right(mut self, edge: f64) -> Self {
        self.0.x += edge - self.right();
        self
    }

    /// Moves the upper edge here, px.
    pub fn at_top(mut self, edge: f64) -> Self {
        self.0.y += edge - self.top();
        self
    }

    /// Moves the lower edge here, px.
    pub fn at_bottom(mut self, edge: f64) -> Self {
        self.0.y += edge - self.bottom();
        self
    }

    /// Centres the outline (not the origin) here, px across.
    pub fn at_cx(self, x: f64) -> Self {
        let left = x - self.width() / 2.0;
        self.at_left(left)
    }

    /// Centres the outline (not the origin) here, px up.
    pub fn at_cy(self, y: f64) -> Self {
        let bottom = y - self.height() / 2.0;
        self.at_bottom(bottom)
    }

    pub fn left(&self) -> f64 {
        self.edge(0, f64::INFINITY, f64::min)
    }

    pub fn right(&self) -> f64 {
        self.edge(0, f64::NEG_INFINITY, f64::max)
    }

    pub fn bottom(&self) -> f64 {
        self.edge(1, f64::INFINITY, f64::min)
    }

    pub fn top(&self) -> f64 {
        self.edge(1, f64::NEG_INFINITY, f64::max)
    }

    pub fn width(&self) -> f64 {
        self.right() - self.left()
    }

    pub fn height(&self) -> f64 {
        self.top() - self.bottom()
    }

    pub fn cx(&self) -> f64 {
        (self.left() + self.right()) / 2.0
    }

    pub fn cy(&self) -> f64 {
        (self.bottom() + self.top()) / 2.0
    }

    /// The extreme coordinate of the turned outline along an axis, px.
    fn edge(&self, axis: usize, start: f64, pick: fn(f64, f64) -> f64) -> f64 {
        let body = &self.0;
        let corners = body.parts.iter().flat_map(|part| match part {
            Part::Circle(r) => vec![[body.x + r, body.y + r], [body.x - r, body.y - r]],
            Part::Polygon(corners) => corners.iter().map(|&corner| body.to_scene(corner)).collect(),
        });
        corners.map(|corner| corner[axis]).fold(start, pick)
    }
}

/// Closes a scene: bodies in this order, the marked ones its goal.
///
/// Panics unless one piece is marked as the object and one as the goal: that is a slip in a script.
pub fn scene(pieces: impl IntoIterator<Item = Piece>) -> Scene {
    let bodies: Vec<Body> = pieces.into_iter().map(|Piece(body)| body).collect();
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

    fn forms() -> impl Strategy<Value = Form> {
        let kinds: [fn(f64) -> Form; 4] = [Ball, Bar, Jar, StandingSticks];
        (prop::sample::select(kinds.to_vec()), 0.02..1.2).prop_map(|(kind, scale)| kind(scale))
    }

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-9
    }

    proptest! {
        #[test]
        fn an_edge_goes_where_it_is_put(form in forms(), degrees in -400.0..400.0, to in -300.0..300.0) {
            let piece = fixed(form).turned(degrees);
            prop_assert!(close(piece.clone().at_left(to).left(), to));
            prop_assert!(close(piece.clone().at_right(to).right(), to));
            prop_assert!(close(piece.clone().at_top(to).top(), to));
            prop_assert!(close(piece.clone().at_bottom(to).bottom(), to));
            prop_assert!(close(piece.clone().at_cx(to).cx(), to));
            prop_assert!(close(piece.clone().at_cy(to).cy(), to));
        }

        #[test]
        fn moving_keeps_size_and_the_other_axis(form in forms(), degrees in -400.0..400.0, to in -300.0..300.0) {
            let piece = dynamic(form).turned(degrees).at(10.0, 20.0);
            let moved = piece.clone().at_right(to);
            prop_assert!(close(moved.width(), piece.width()) && close(moved.height(), piece.height()));
            prop_assert_eq!(moved.bottom(), piece.bottom());
        }

        #[test]
        fn polygons_are_convex_and_counter_clockwise(form in forms()) {
            for part in form.parts() {
                let Part::Polygon(corners) = part else { continue };
                for i in 0..corners.len() {
                    let [a, b, c] = [0, 1, 2].map(|k| corners[(i + k) % corners.len()]);
                    prop_assert!((b[0] - a[0]) * (c[1] - b[1]) > (b[1] - a[1]) * (c[0] - b[0]), "{:?}", corners);
                }
            }
        }
    }

    #[test]
    fn the_radius_of_a_ball_is_a_whole_number_and_a_half() {
        let radius = |scale| Ball(scale).parts();
        assert_eq!(radius(0.05), [Part::Circle(6.5)]);
        assert_eq!(radius(0.1), [Part::Circle(12.5)]);
        assert_eq!(radius(0.25), [Part::Circle(32.5)]);
    }

    #[test]
    fn a_jar_stands_on_its_base_and_is_wider_at_the_rim() {
        let jar = fixed(Jar(0.1));
        assert!(close(jar.width(), 25.6 / 1.2));
        assert!(close(jar.height(), 25.6));
        let Part::Polygon(wall) = &Jar(0.1).parts()[1] else { panic!("a wall is a polygon") };
        assert!((wall[2][0] + 4.722242).abs() < 1e-6 && (wall[2][1] + 1.594560).abs() < 1e-6, "{wall:?}");
    }

    #[test]
    fn the_outline_of_a_ball_does_not_turn() {
        assert_eq!(fixed(Ball(0.1)).turned(33.0).width(), 25.0);
    }

    #[test]
    #[should_panic(expected = "marks its object and its goal")]
    fn a_scene_without_a_goal_is_a_slip() {
        scene([dynamic(Ball(0.1)).object()]);
    }
}

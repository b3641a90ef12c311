//! The small language that templates are written in.
//!
//! A template adds pieces (`fixed` or `dynamic`; ball, bar, jar, standing sticks), turns them, and puts
//! an edge of each somewhere, often at an edge of a piece that is there already. Each word acts at once,
//! on the outline of the turned piece. `Layout::scene` then gives every body its role and closes the scene.
//! Formulas and their order are PHYRE's (v0.2.2, `creator`); 5.12 px is the thickness of a bar.

use crate::scene::{Body, Part, Role, SIZE, Scene, Shape, rectangle};

/// Thickness of a bar, px; also scales the walls of a jar and the sticks.
const THICKNESS: f64 = 5.12;

/// A shape from its one scale number: 1.0 spans the scene.
pub struct Form(Shape, Vec<Part>);

/// One circle of radius trunc(128 s) + 0.5 px.
pub fn ball(scale: f64) -> Form {
    Form(Shape::Ball, vec![Part::Circle((SIZE / 2.0 * scale).trunc() + 0.5)])
}

/// A thin rectangle, 256 s px long.
pub fn bar(scale: f64) -> Form {
    Form(Shape::Bar, vec![rectangle(SIZE * scale, THICKNESS)])
}

/// A base and two walls that lean outwards; 256 s px high. The origin is the middle of the base.
pub fn jar(scale: f64) -> Form {
    let height = SIZE * scale;
    let width = height / 1.2;
    let base = 0.8 * width;
    let t = THICKNESS * libm::log(height) / libm::log(0.3 * SIZE);
    let lean = (width - base) / 2.0;
    let slant = libm::sqrt(height * height + lean * lean);
    // The leaning wall's thickness: p along the base and v above it at the foot, q along the rim.
    let (p, q, v) = (t * height / slant, t * slant / height, t * lean / slant);
    let (w, b) = (width / 2.0, base / 2.0);
    let (rim, foot) = (height - t / 2.0, -t / 2.0);
    Form(
        Shape::Jar,
        vec![
            rectangle(base, t),
            Part::Polygon(vec![[-w, rim], [-b, foot], [-b + p, v + foot], [-w + q, rim]]),
            Part::Polygon(vec![[w, rim], [w - q, rim], [b - p, v + foot], [b, foot]]),
        ],
    )
}

/// Two crossed sticks, each two thirds of a bar of this scale, leaning 12.5 degrees from upright.
pub fn standing_sticks(scale: f64) -> Form {
    let (width, height) = (SIZE * scale * 2.0 / 3.0, THICKNESS * 2.0 / 3.0);
    let stick = |degrees: f64| {
        let Part::Polygon(corners) = rectangle(width, height) else { unreachable!("a rectangle is a polygon") };
        let (sin, cos) = (libm::sin(degrees.to_radians()), libm::cos(degrees.to_radians()));
        Part::Polygon(corners.iter().map(|&[a, b]| [a * cos - b * sin, a * sin + b * cos]).collect())
    };
    Form(Shape::StandingSticks, vec![stick(-77.5), stick(77.5)])
}

/// A body under construction. Every word acts at once, on the piece as it is then.
#[derive(Clone, Debug)]
pub struct Piece(Body);

/// A static piece at the origin.
pub fn fixed(form: Form) -> Piece {
    piece(form, false)
}

/// A dynamic piece at the origin.
pub fn dynamic(form: Form) -> Piece {
    piece(form, true)
}

fn piece(Form(shape, parts): Form, dynamic: bool) -> Piece {
    let role = if dynamic { Role::Gray } else { Role::Black };
    Piece(Body { x: 0.0, y: 0.0, angle: 0.0, dynamic, shape, role, parts })
}

impl Piece {
    /// Turns the piece about its origin, to this angle.
    pub fn turned(mut self, degrees: f64) -> Self {
        self.0.angle = degrees / 180.0 * std::f64::consts::PI;
        self
    }

    /// Puts the origin here, px.
    pub fn at(mut self, x: f64, y: f64) -> Self {
        (self.0.x, self.0.y) = (x, y);
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

/// The pieces of one task, in the order they were added.
#[derive(Default)]
pub struct Layout(Vec<Piece>);

/// The number of a piece in its layout: the index of the body in the scene.
pub type Id = usize;

impl Layout {
    /// Adds a piece.
    pub fn add(&mut self, piece: Piece) -> Id {
        self.0.push(piece);
        self.0.len() - 1
    }

    /// Moves a piece already added; it keeps its number.
    pub fn adjust(&mut self, id: Id, words: impl FnOnce(Piece) -> Piece) {
        self.0[id] = words(self.0[id].clone());
    }

    /// Closes the scene: the object and its goal get their roles.
    pub fn scene(self, goal: Goal) -> Scene {
        let mut bodies: Vec<Body> = self.0.into_iter().map(|Piece(body)| body).collect();
        let target = &mut bodies[goal.target];
        target.role = if target.dynamic { Role::Blue } else { Role::Purple };
        bodies[goal.object].role = Role::Green;
        Scene { body1: goal.object, body2: goal.target, bodies }
    }
}

impl std::ops::Index<Id> for Layout {
    type Output = Piece;

    fn index(&self, id: Id) -> &Piece {
        &self.0[id]
    }
}

/// Which piece has to touch which.
#[derive(Clone, Copy, Debug)]
pub struct Goal {
    /// The green object: body1, always dynamic.
    pub object: Id,
    /// What it has to touch: body2.
    pub target: Id,
}

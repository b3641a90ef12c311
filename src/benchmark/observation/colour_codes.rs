//! PHYRE's image of a scene: 256 x 256 colour codes, one per px, row 0 at the bottom.
//!
//! Bodies are drawn in order, later ones over earlier ones. Every rounding is PHYRE's, because edge pixels depend on
//! it: f32 for angles, circles and the ends of a line, f64 for corners, and halves to even.

use crate::puzzle::scene::{Body, Role, SIZE, Shape};

/// Width and height of an image, pixels.
pub const SIDE: usize = SIZE as usize;

/// Edges that rise by less than this count as horizontal, px.
const LEAST_RISE: f64 = 1e-3;

/// Returns PHYRE's code of a role, 1..=6. 0 is the background.
pub fn colour_code(role: Role) -> u8 {
    match role {
        Role::Red => 1,
        Role::Green => 2,
        Role::Blue => 3,
        Role::Purple => 4,
        Role::Gray => 5,
        Role::Black => 6,
    }
}

/// Draws bodies at their current poses into an image of `SIDE * SIDE` codes, row by row, and clears everything else.
///
/// # Panics
///
/// If the image has another size.
pub fn draw_scene(bodies: &[Body], image: &mut [u8]) {
    image.fill(0);
    bodies.iter().for_each(|body| draw_body(body, colour_code(body.role), image));
}

/// Draws one body at its current pose with this code.
///
/// # Panics
///
/// If the image does not have `SIDE * SIDE` codes.
pub fn draw_body(body: &Body, code: u8, image: &mut [u8]) {
    assert_eq!(image.len(), SIDE * SIDE, "an image has one code per px");
    for shape in &body.shapes {
        match shape {
            Shape::Circle(radius) => draw_circle([body.x as f32, body.y as f32], *radius as f32, code, image),
            Shape::Polygon(corners) => {
                let angle = f64::from(body.angle as f32);
                let [sin, cos] = [libm::sin(angle), libm::cos(angle)].map(|value| f64::from(value as f32));
                let in_scene = |&[a, b]: &[f64; 2]| [a * cos - b * sin + body.x, a * sin + b * cos + body.y];
                draw_polygon(&corners.iter().map(in_scene).collect::<Vec<_>>(), code, image);
            }
        }
    }
}

/// An edge of a polygon, directed upwards.
struct Edge {
    lower: [f64; 2],
    upper: [f64; 2],
}

impl Edge {
    /// Returns x of the edge at a height, px.
    fn x_at(&self, height: f32) -> f32 {
        let [[x, y], [u, v]] = [self.lower, self.upper];
        let along = ((f64::from(height) - y) / (v - y)) as f32;
        (f64::from(along) * (u - x) + x) as f32
    }
}

/// Draws a convex polygon whose corners are in counter-clockwise order.
fn draw_polygon(corners: &[[f64; 2]], code: u8, image: &mut [u8]) {
    let (mut left, mut right) = (Vec::new(), Vec::new());
    for (index, &corner) in corners.iter().enumerate() {
        let before = corners[(index + corners.len() - 1) % corners.len()];
        if (corner[1] - before[1]).abs() < LEAST_RISE {
            continue;
        }
        if before[1] < corner[1] {
            right.push(Edge { lower: before, upper: corner });
        } else {
            left.push(Edge { lower: corner, upper: before });
        }
    }
    if left.is_empty() || right.is_empty() {
        return;
    }
    for edges in [&mut left, &mut right] {
        edges.sort_by(|a, b| a.lower[1].total_cmp(&b.lower[1]));
    }
    let lowest = corners.iter().fold(f64::INFINITY, |lowest, corner| lowest.min(corner[1])) as f32;
    let highest = corners.iter().fold(f64::NEG_INFINITY, |highest, corner| highest.max(corner[1])) as f32;
    let (mut left, mut right) = (ActiveEdge::new(&left), ActiveEdge::new(&right));
    for row in pixel(lowest)..pixel(highest) {
        let height = row as f64 + 0.5;
        let (start, end) = (pixel(left.x_at(height)), pixel(right.x_at(height)));
        if start < end {
            image[row * SIDE..][start..end].fill(code);
        }
    }
}

/// The edge on one side of a polygon at the current height, as the height rises.
struct ActiveEdge<'a> {
    edges: &'a [Edge],
    index: usize,
}

impl<'a> ActiveEdge<'a> {
    fn new(edges: &'a [Edge]) -> Self {
        ActiveEdge { edges, index: 0 }
    }

    fn x_at(&mut self, height: f64) -> f32 {
        while self.index + 1 < self.edges.len() && self.edges[self.index].upper[1] < height {
            self.index += 1;
        }
        self.edges[self.index].x_at(height as f32)
    }
}

/// Returns the pixel to which a coordinate rounds, in the image or just after it.
fn pixel(coordinate: f32) -> usize {
    coordinate.round_ties_even().clamp(0.0, SIDE as f32) as usize
}

/// Draws a circle from the middle row outwards; each row starts from the ends of the previous one.
fn draw_circle(centre: [f32; 2], radius: f32, code: u8, image: &mut [u8]) {
    let [x, y] = centre.map(|coordinate| (f64::from(coordinate) - 0.5) as f32);
    let near = -radius - 1.0..SIDE as f32 + radius + 1.0;
    if !near.contains(&x) || !near.contains(&y) {
        return;
    }
    let squared_radius = radius * radius;
    let square = |value: f32| value * value;
    let mut draw_line = |row: i32, [left, right]: &mut [i32; 2]| {
        let residual = squared_radius - square(row as f32 - y);
        while square(*left as f32 - x) <= residual {
            *left -= 1;
        }
        while square(*right as f32 - x) <= residual {
            *right += 1;
        }
        let (start, end) = ((*left + 1).max(0), (*right).min(SIDE as i32));
        if start < end && (0..SIDE as i32).contains(&row) {
            image[row as usize * SIDE..][start as usize..end as usize].fill(code);
        }
    };
    let mut ends = [x as i32; 2];
    let mut row = (y + radius + 1.0) as i32;
    while row as f32 >= y {
        draw_line(row, &mut ends);
        row -= 1;
    }
    ends = [x as i32; 2];
    row = (y - radius) as i32;
    while (row as f32) < y {
        draw_line(row, &mut ends);
        row += 1;
    }
}

#[cfg(test)]
mod tests {
    use sha2::{Digest, Sha256};

    use super::*;
    use crate::puzzle::hex::hex;
    use crate::puzzle::task::Task;
    use crate::puzzle::templates::TEMPLATES;

    /// The digest is that of the images drawn from the same bodies by PHYRE's own functions, `fillConvexPoly` and
    /// `draw_circle` of image_to_box2d.cpp, compiled by g++ 12 for x86-64.
    #[test]
    fn the_scenes_of_all_tasks_look_as_phyre_draws_them() {
        let mut hash = Sha256::new();
        let mut image = vec![0; SIDE * SIDE];
        for task in TEMPLATES.iter().flat_map(|template| Task::of(template)) {
            draw_scene(&task.scene.bodies, &mut image);
            hash.update(&image);
        }
        assert_eq!(hex(hash.finalize()), "522e555503ae0af595e71a6acd5ddf7110bab6136f863dd99093fee8fdf017dc");
    }

    #[test]
    fn what_is_far_away_is_not_drawn() {
        for x in [-1e30, -300.0, 300.0, 1e9, 1e30] {
            let mut image = vec![0; SIDE * SIDE];
            let ball = crate::puzzle::action::Ball { x, y: 128.0, r: 30.0 };
            draw_scene(&[ball.body()], &mut image);
            assert!(image.iter().all(|&code| code == 0), "{x}");
        }
    }
}

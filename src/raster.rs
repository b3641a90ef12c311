//! 64 x 64 images for the nets: the five channels of a scene, and the path of a body through a rollout.
//!
//! Everything is drawn at 256 x 256 pixels, one per px, and max-pooled to 64 x 64 cells, as in the data of Harter et
//! al. (2020). Row 0 is the bottom of the scene. Also defines how cells map to scene coordinates. Used by
//! `dataset`, `nets`, `agents`, `play` and the page. Must not depend on the simulator or on nets.

use crate::puzzle::action::Ball;
use crate::puzzle::rollout::{Pose, Rollout};
use crate::puzzle::scene::{Body, Role, SIZE, Scene, Shape};

/// Width and height of an image, cells.
pub const SIDE: usize = 64;

/// Cells of an image.
pub const CELLS: usize = SIDE * SIDE;

/// Width and height of a cell, px. One px is one pixel of the image before pooling.
pub const PX_PER_CELL: usize = SIZE as usize / SIDE;

/// Channels of a scene: green object, blue goal, purple goal, gray, black (PHYRE's roles without the action ball).
pub const CHANNELS: usize = 5;

/// A path image shows every tenth step of a rollout, as in the data of Harter et al. (2020).
const PATH_STRIDE: usize = 10;

/// Distance between two drawings of a body along a trail, px: half a cell, so that no cell is left out.
const TRAIL_STRIDE: f64 = PX_PER_CELL as f64 / 2.0;

/// Returns the centre of a cell, px. Cells are numbered row by row from the bottom left, `0..CELLS`.
pub fn cell_centre(cell: usize) -> [f64; 2] {
    [cell % SIDE, cell / SIDE].map(|index| (index as f64 + 0.5) * PX_PER_CELL as f64)
}

/// A binary 64 x 64 image (a mask): one word per row, the lowest bit on the left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bitmap(pub [u64; SIDE]);

impl Bitmap {
    pub const EMPTY: Bitmap = Bitmap([0; SIDE]);

    /// Whether the cell in this column and row is set.
    pub fn get(&self, column: usize, row: usize) -> bool {
        self.0[row] >> column & 1 == 1
    }

    /// The number of set cells.
    pub fn count(&self) -> u32 {
        self.0.iter().map(|row| row.count_ones()).sum()
    }

    /// Returns the numbers of the set cells, ascending.
    pub fn cells(&self) -> impl Iterator<Item = usize> + use<> {
        (0..).zip(self.0).flat_map(|(row, mut word): (usize, u64)| {
            std::iter::from_fn(move || {
                let column = (word != 0).then(|| word.trailing_zeros() as usize)?;
                word &= word - 1;
                Some(row * SIDE + column)
            })
        })
    }

    /// Returns 4,096 values, row by row: 1.0 for a set cell, 0.0 for any other.
    pub fn to_f32(&self) -> impl Iterator<Item = f32> + use<> {
        self.0.into_iter().flat_map(|row| (0..SIDE).map(move |column| (row >> column & 1) as f32))
    }

    /// Returns the image flipped left to right.
    pub fn mirrored(self) -> Bitmap {
        Bitmap(self.0.map(u64::reverse_bits))
    }

    /// Draws a body at a pose.
    fn draw(&mut self, body: &Body, [x, y, angle]: Pose) {
        let placed = Body { x: x.into(), y: y.into(), angle: angle.into(), ..body.clone() };
        for shape in &placed.shapes {
            match shape {
                Shape::Circle(radius) => self.disc(placed.x, placed.y, *radius),
                Shape::Polygon(corners) => {
                    let corners: Vec<_> = corners.iter().map(|&corner| placed.to_scene(corner)).collect();
                    self.polygon(&corners);
                }
            }
        }
    }

    /// Draws a disc; centre and radius in px.
    fn disc(&mut self, x: f64, y: f64, radius: f64) {
        self.fill(y - radius, y + radius, |height| {
            let half = (radius * radius - (height - y) * (height - y)).max(0.0).sqrt();
            Some((x - half, x + half))
        });
    }

    /// Draws a convex polygon; corners in px.
    fn polygon(&mut self, corners: &[[f64; 2]]) {
        let bottom = corners.iter().map(|corner| corner[1]).fold(f64::INFINITY, f64::min);
        let top = corners.iter().map(|corner| corner[1]).fold(f64::NEG_INFINITY, f64::max);
        self.fill(bottom, top, |height| {
            let mut span = None::<(f64, f64)>;
            for (a, b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
                if (a[1] <= height) != (b[1] <= height) {
                    let x = a[0] + (height - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
                    span = Some(span.map_or((x, x), |(left, right)| (left.min(x), right.max(x))));
                }
            }
            span
        });
    }

    /// Scan conversion: sets every cell that has a pixel whose centre lies in the span of its scan line. `span` returns
    /// the left and right end of a line at a height, all px.
    fn fill(&mut self, bottom: f64, top: f64, span: impl Fn(f64) -> Option<(f64, f64)>) {
        for line in first_pixel(bottom)..end_pixel(top) {
            let Some((left, right)) = span(line as f64 + 0.5) else { continue };
            let (start, end) = (first_pixel(left), end_pixel(right));
            if start < end {
                let (low, high) = (start / PX_PER_CELL, (end - 1) / PX_PER_CELL);
                self.0[line / PX_PER_CELL] |= u64::MAX >> (SIDE - 1 - (high - low)) << low;
            }
        }
    }
}

impl std::ops::BitOrAssign for Bitmap {
    fn bitor_assign(&mut self, other: Bitmap) {
        for (row, more) in self.0.iter_mut().zip(other.0) {
            *row |= more;
        }
    }
}

/// Returns the first pixel whose centre is not before a coordinate (px), within the scene.
fn first_pixel(coordinate: f64) -> usize {
    (coordinate - 0.5).ceil().clamp(0.0, SIZE) as usize
}

/// Returns one more than the last pixel whose centre is not after a coordinate (px), within the scene.
fn end_pixel(coordinate: f64) -> usize {
    ((coordinate - 0.5).floor() + 1.0).clamp(0.0, SIZE) as usize
}

/// Returns the five channels of a scene at its start.
pub fn scene_channels(scene: &Scene) -> [Bitmap; CHANNELS] {
    [Role::Green, Role::Blue, Role::Purple, Role::Gray, Role::Black].map(|role| {
        let mut channel = Bitmap::EMPTY;
        for body in scene.bodies.iter().filter(|body| body.role == role) {
            channel.draw(body, [body.x as f32, body.y as f32, body.angle as f32]);
        }
        channel
    })
}

/// Returns the image of a ball: the placement channel.
pub fn ball_image(ball: Ball) -> Bitmap {
    let mut image = Bitmap::EMPTY;
    image.disc(ball.x, ball.y, ball.r);
    image
}

/// Returns the path of a body: the union of its images at every tenth step. `index` is the body's index in the scene
/// (the action ball has the one after the last); a static body is drawn where it is.
pub fn path_image(body: &Body, rollout: &Rollout, index: usize) -> Bitmap {
    let mut image = Bitmap::EMPTY;
    for step in (0..=rollout.steps).step_by(PATH_STRIDE) {
        let start = [body.x as f32, body.y as f32, body.angle as f32];
        image.draw(body, rollout.pose(step, index).unwrap_or(start));
    }
    image
}

/// Returns the path of a body that slides along a line through these points (px) without rotating: what a person
/// draws, as a path image. The start of the body is part of it, and points outside the scene are clamped to its edge.
pub fn trail_image(body: &Body, points: &[[f64; 2]]) -> Bitmap {
    let mut image = Bitmap::EMPTY;
    let mut draw = |[x, y]: [f64; 2]| image.draw(body, [x as f32, y as f32, body.angle as f32]);
    draw([body.x, body.y]);
    let clamped: Vec<[f64; 2]> = points.iter().map(|point| point.map(|value| value.clamp(0.0, SIZE))).collect();
    for (from, to) in clamped.iter().zip(clamped.iter().skip(1).chain(clamped.last())) {
        let steps = (libm::hypot(to[0] - from[0], to[1] - from[1]) / TRAIL_STRIDE).ceil().max(1.0);
        for step in 0..steps as usize {
            let t = step as f64 / steps;
            draw([from[0] + t * (to[0] - from[0]), from[1] + t * (to[1] - from[1])]);
        }
    }
    image
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::scene::ShapeType;

    fn area_px(ball: Ball) -> f64 {
        f64::from(ball_image(ball).count()) * (PX_PER_CELL * PX_PER_CELL) as f64
    }

    #[test]
    fn a_ball_at_the_centre_of_a_cell_sets_this_cell() {
        assert_eq!(cell_centre(SIDE + 2), [10.0, 6.0]);
        for cell in [0, 1, SIDE, SIDE + 2, CELLS - 1] {
            let [x, y] = cell_centre(cell);
            let image = ball_image(Ball { x, y, r: 1.0 });
            assert!(image.get(cell % SIDE, cell / SIDE) && image.count() == 1, "cell {cell}");
            assert!(image.cells().eq([cell]), "cell {cell}");
        }
    }

    #[test]
    fn a_mirrored_image_is_flipped_left_to_right() {
        let ball = |x| ball_image(Ball { x, y: 60.0, r: 20.0 });
        assert_eq!(ball(100.0).mirrored(), ball(SIZE - 100.0));
    }

    #[test]
    fn a_disc_covers_about_its_area_and_a_rim_of_half_a_cell() {
        let ball = Ball { x: 100.0, y: 60.0, r: 20.0 };
        let (inner, outer) = (std::f64::consts::PI * 20.0 * 20.0, std::f64::consts::PI * 24.0 * 24.0);
        assert!((inner..outer).contains(&area_px(ball)), "{}", area_px(ball));
    }

    #[test]
    fn a_ball_of_one_pixel_sets_one_cell_at_its_place() {
        let image = ball_image(Ball { x: 4.5, y: 252.5, r: 0.5 });
        assert_eq!(image.cells().collect::<Vec<_>>(), [63 * SIDE + 1]);
    }

    #[test]
    fn shapes_are_clipped_to_the_scene() {
        assert!(ball_image(Ball { x: -10.0, y: 300.0, r: 20.0 }).count() == 0);
        assert!(ball_image(Ball { x: 0.0, y: 0.0, r: 8.0 }).get(0, 0));
    }

    #[test]
    fn a_trail_covers_the_start_and_the_line() {
        let shapes = vec![Shape::Circle(6.0)];
        let body = Body {
            x: 20.0,
            y: 20.0,
            angle: 0.0,
            dynamic: true,
            shape_type: ShapeType::Ball,
            role: Role::Green,
            shapes,
        };
        let ball = |x, y| ball_image(Ball { x, y, r: 6.0 });
        assert_eq!(trail_image(&body, &[]), ball(20.0, 20.0));
        let mut expected = ball(20.0, 20.0);
        for x in 100..=200 {
            expected |= ball(f64::from(x), 100.0);
        }
        let drawn = trail_image(&body, &[[100.0, 100.0], [200.0, 100.0]]);
        let missing = (0..SIDE).map(|row| (expected.0[row] & !drawn.0[row]).count_ones()).sum::<u32>();
        assert!(missing <= 2, "{missing} cells of the line are not drawn");
        assert!(drawn.count() <= expected.count());
        assert!(
            trail_image(&body, &[[f64::NAN, f64::INFINITY], [-1e300, 1e300]]).count() > 0,
            "NaN and infinity are accepted"
        );
    }

    #[test]
    fn a_rectangle_sets_the_cells_it_overlaps() {
        let mut image = Bitmap::EMPTY;
        image.polygon(&[[8.0, 8.0], [0.0, 8.0], [0.0, 0.0], [8.0, 0.0]]);
        assert_eq!(image.0[..3], [0b11, 0b11, 0]);
    }
}

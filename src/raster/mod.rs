//! 64 x 64 images for the nets: the five channels of a scene, and the path of a body through a rollout.
//!
//! Everything is drawn at 256 x 256 pixels, one per px. For the paper's nets, the image is max-pooled to 64 x 64 cells;
//! for the success net, the dynamics net and DQN, it is average-pooled. Row 0 is the bottom of the scene. Also defines
//! how cells map to scene coordinates. Used by `nets`, `agents`, `search`, the lab and the page. Must not depend on the
//! simulator or on nets.

use scan_conversion::{Span, body_spans, disc_spans};

use crate::puzzle::action::Ball;
use crate::puzzle::rollout::{Pose, Rollout};
use crate::puzzle::scene::{Body, Role, SIZE, Scene};

mod scan_conversion;
pub mod soft_iou;

/// Width and height of an image, cells.
pub const SIDE: usize = 64;

/// Number of cells in an image.
pub const CELLS: usize = SIDE * SIDE;

/// Width and height of a cell, px. One px is one pixel of the image before pooling.
pub const PX_PER_CELL: usize = SIZE as usize / SIDE;

/// Channels of a scene: green object, blue goal, purple goal, gray, black (PHYRE's roles without the action ball).
pub const CHANNELS: usize = 5;

/// A path image shows every tenth step of a rollout. The code of Harter et al. (2020) draws every fifth.
const PATH_STRIDE: usize = 10;

/// Distance between two drawings of a body along a trail, px: half a cell, so that no cell is skipped.
const TRAIL_STRIDE: f64 = PX_PER_CELL as f64 / 2.0;

/// Returns the centre of a cell, px. Cells are numbered row by row from the bottom left, `0..CELLS`.
pub fn cell_centre(cell: usize) -> [f64; 2] {
    [cell % SIDE, cell / SIDE].map(|index| (index as f64 + 0.5) * PX_PER_CELL as f64)
}

/// A binary 64 x 64 image (a mask): one word per row, the lowest bit on the left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Bitmap(pub [u64; SIDE]);

impl Bitmap {
    /// The image without set cells.
    pub const EMPTY: Bitmap = Bitmap([0; SIDE]);

    /// Returns whether the cell in this column and row is set.
    pub fn get(&self, column: usize, row: usize) -> bool {
        self.0[row] >> column & 1 == 1
    }

    /// Returns the number of set cells.
    pub fn count(&self) -> u32 {
        self.0.iter().map(|row| row.count_ones()).sum()
    }

    /// Returns the indices of the set cells, ascending.
    pub fn cells(&self) -> impl Iterator<Item = usize> + use<> {
        (0..).zip(self.0).flat_map(|(row, mut word): (usize, u64)| {
            std::iter::from_fn(move || {
                let column = (word != 0).then(|| word.trailing_zeros() as usize)?;
                word &= word - 1;
                Some(row * SIDE + column)
            })
        })
    }

    /// Returns 4,096 values, row by row: 1.0 for a set cell, else 0.0.
    pub fn to_f32(&self) -> impl Iterator<Item = f32> + use<> {
        self.rows().flatten()
    }

    /// Returns the values of 64 rows: 1.0 for a set cell, else 0.0.
    pub fn rows(&self) -> impl Iterator<Item = [f32; SIDE]> + use<> {
        self.0.into_iter().map(|row| std::array::from_fn(|column| (row >> column & 1) as f32))
    }

    /// Returns the image flipped left to right.
    pub fn mirrored(self) -> Bitmap {
        Bitmap(self.0.map(u64::reverse_bits))
    }

    /// Draws a body at a pose.
    fn draw(&mut self, body: &Body, pose: Pose) {
        body_spans(body, pose, |span| self.mark(span));
    }

    /// Sets the cells of a span.
    fn mark(&mut self, Span { line, start, end }: Span) {
        let (low, high) = (start / PX_PER_CELL, (end - 1) / PX_PER_CELL);
        self.0[line / PX_PER_CELL] |= u64::MAX >> (SIDE - 1 - (high - low)) << low;
    }
}

impl std::ops::BitOrAssign for Bitmap {
    fn bitor_assign(&mut self, image: Bitmap) {
        for (row, more) in self.0.iter_mut().zip(image.0) {
            *row |= more;
        }
    }
}

/// The coverage of each cell, row by row: its number of covered pixels, `0..=PX_PER_CELL * PX_PER_CELL`. Unlike a
/// `Bitmap`, it shows where within a cell an edge lies.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coverage(Vec<u8>);

impl Coverage {
    /// Returns 4,096 values in 0..=1: the covered share of each cell.
    pub fn to_f32(&self) -> impl Iterator<Item = f32> + use<'_> {
        self.0.iter().map(|&pixels| f32::from(pixels) / (PX_PER_CELL * PX_PER_CELL) as f32)
    }

    /// Returns the image flipped left to right.
    pub fn mirrored(&self) -> Coverage {
        Coverage(self.0.chunks_exact(SIDE).flat_map(|row| row.iter().rev()).copied().collect())
    }
}

/// The roles of the channels.
const ROLES: [Role; CHANNELS] = [Role::Green, Role::Blue, Role::Purple, Role::Gray, Role::Black];

/// Returns the five channels of a scene at its start.
pub fn scene_channels(scene: &Scene) -> [Bitmap; CHANNELS] {
    ROLES.map(|role| {
        let mut channel = Bitmap::EMPTY;
        of_role(scene, role, |span| channel.mark(span));
        channel
    })
}

/// Returns the coverage of each cell by the bodies of each channel at the start of a scene.
pub fn scene_coverage(scene: &Scene) -> [Coverage; CHANNELS] {
    ROLES.map(|role| {
        let width = SIDE * PX_PER_CELL;
        let mut seen = vec![false; width * width];
        let mut covered = vec![0; CELLS];
        of_role(scene, role, |Span { line, start, end }| {
            for column in start..end {
                let new = !std::mem::replace(&mut seen[line * width + column], true);
                covered[line / PX_PER_CELL * SIDE + column / PX_PER_CELL] += u8::from(new);
            }
        });
        Coverage(covered)
    })
}

/// Marks the pixels of the bodies of a role at the start of a scene.
fn of_role(scene: &Scene, role: Role, mut mark: impl FnMut(Span)) {
    for body in scene.bodies.iter().filter(|body| body.role == role) {
        body_spans(body, [body.x as f32, body.y as f32, body.angle as f32], &mut mark);
    }
}

/// Returns the image of a ball: the placement channel.
pub fn ball_image(ball: Ball) -> Bitmap {
    let mut image = Bitmap::EMPTY;
    disc_spans(ball.x, ball.y, ball.r, |span| image.mark(span));
    image
}

/// Returns the path of a body: the union of its images at every tenth step. `index` is the body's index in the scene
/// (the action ball has the index after the last). A static body is drawn once.
pub fn path_image(body: &Body, rollout: &Rollout, index: usize) -> Bitmap {
    let mut image = Bitmap::EMPTY;
    for step in (0..=rollout.steps).step_by(PATH_STRIDE) {
        let start = [body.x as f32, body.y as f32, body.angle as f32];
        image.draw(body, rollout.pose(step, index).unwrap_or(start));
    }
    image
}

/// Returns the path of a body that slides along a line through these points (px) without rotating: a path that a person
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
    use super::scan_conversion::polygon_spans;
    use super::*;
    use crate::puzzle::scene::{Shape, ShapeType};

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
        let inner = std::f64::consts::PI * 20.0 * 20.0;
        let outer = std::f64::consts::PI * 24.0 * 24.0;
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
        polygon_spans(&[[8.0, 8.0], [0.0, 8.0], [0.0, 0.0], [8.0, 0.0]], |span| image.mark(span));
        assert_eq!(image.0[..3], [0b11, 0b11, 0]);
    }

    #[test]
    fn coverage_counts_the_pixels_of_a_channel_once() {
        let mut scene = crate::puzzle::task::Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
        let twice = scene.bodies[scene.body1].clone();
        let before = scene_coverage(&scene);
        let set = |coverage: &Coverage| coverage.to_f32().map(f32::ceil).collect::<Vec<_>>();
        scene.bodies.push(twice);
        assert_eq!(scene_coverage(&scene), before, "a body over another covers no more");
        for (coverage, channel) in before.iter().zip(scene_channels(&scene)) {
            assert_eq!(set(coverage), channel.to_f32().collect::<Vec<_>>(), "a covered cell is a set cell");
            assert_eq!(set(&coverage.mirrored()), channel.mirrored().to_f32().collect::<Vec<_>>());
        }
        let Body { x, y, .. } = scene.bodies[scene.body1];
        let radius = scene.bodies[scene.body1].ball_radius().expect("a ball");
        let area = f64::from(before[0].to_f32().sum::<f32>()) * (PX_PER_CELL * PX_PER_CELL) as f64;
        let disc = std::f64::consts::PI * radius * radius;
        assert!((area - disc).abs() < 2.0 * radius, "{area} of {disc} at {x}, {y}");
    }
}

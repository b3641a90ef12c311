//! A coarse sketch for comparing scenes: roughly where the bodies of each role are. It holds whole numbers, so that
//! distances are the same natively and in wasm.

use crate::puzzle::scene::{SIZE, Scene};
use crate::raster::{Coverage, SIDE as CELLS_PER_ROW, scene_coverage};

/// Width and height of a sketch, cells.
const SIDE: usize = 16;

/// Width and height of a cell of a sketch, cells of an image.
const POOLED: usize = CELLS_PER_ROW / SIDE;

/// The value of a covered cell whose neighbours are all covered.
pub(crate) const COVERED: u8 = 255;

/// A scene, pooled and blurred.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct SceneSketch(Vec<u8>);

impl SceneSketch {
    pub(crate) fn of(scene: &Scene) -> SceneSketch {
        SceneSketch(scene_coverage(scene).iter().flat_map(|channel| blurred(&pooled(channel))).collect())
    }

    /// Returns the sketch flipped left to right.
    pub(crate) fn mirrored(&self) -> SceneSketch {
        SceneSketch(self.0.chunks_exact(SIDE).flat_map(|row| row.iter().rev()).copied().collect())
    }

    /// Returns the sum of the squared differences of all cells, where a fully covered cell and an empty one differ by
    /// 1.
    pub(crate) fn squared_distance(&self, other: &SceneSketch) -> f64 {
        let squares = self.0.iter().zip(&other.0).map(|(&a, &b)| u32::from(a.abs_diff(b)).pow(2));
        f64::from(squares.sum::<u32>()) / f64::from(u32::from(COVERED).pow(2))
    }
}

/// Returns the number of covered pixels in each cell of a sketch.
fn pooled(channel: &Coverage) -> Vec<u32> {
    let mut pixels = vec![0; SIDE * SIDE];
    let per_cell = (SIZE as usize / CELLS_PER_ROW).pow(2) as f32;
    for (cell, share) in channel.to_f32().enumerate() {
        pixels[cell / CELLS_PER_ROW / POOLED * SIDE + cell % CELLS_PER_ROW / POOLED] += (share * per_cell) as u32;
    }
    pixels
}

/// Blurs with the binomial filter 1, 2, 1 in both directions. Beyond the edge nothing is covered.
fn blurred(pixels: &[u32]) -> Vec<u8> {
    let filtered = |values: &[u32], step: usize, place: fn(usize) -> usize| -> Vec<u32> {
        let at = |cell: usize| {
            let before = if place(cell) > 0 { values[cell - step] } else { 0 };
            let after = if place(cell) < SIDE - 1 { values[cell + step] } else { 0 };
            before + 2 * values[cell] + after
        };
        (0..values.len()).map(at).collect()
    };
    let rows = filtered(pixels, 1, |cell| cell % SIDE);
    let both = filtered(&rows, SIDE, |cell| cell / SIDE);
    let most = 16 * (SIZE as u32 / SIDE as u32).pow(2);
    both.into_iter().map(|value| (value * u32::from(COVERED) / most) as u8).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::Task;
    use crate::raster::CHANNELS;

    fn scene(id: &str) -> Scene {
        Task::load(id.parse().expect("an id")).expect("a task").scene
    }

    #[test]
    fn scenes_of_a_template_are_nearer_than_those_of_another() {
        let sketch = SceneSketch::of(&scene("00002:007"));
        assert_eq!(sketch.0.len(), CHANNELS * SIDE * SIDE);
        assert_eq!(sketch.squared_distance(&sketch), 0.0);
        let [near, far] = ["00002:017", "00007:008"].map(|id| sketch.squared_distance(&SceneSketch::of(&scene(id))));
        assert!(0.0 < near && near < far, "{near} {far}");
    }

    #[test]
    fn a_sketch_mirrored_twice_is_itself() {
        let sketch = SceneSketch::of(&scene("00007:008"));
        assert_ne!(sketch.mirrored(), sketch);
        assert_eq!(sketch.mirrored().mirrored(), sketch);
    }

    #[test]
    fn a_blur_spreads_what_is_covered_over_the_cells_beside_it() {
        let mut pixels = vec![0; SIDE * SIDE];
        pixels[5 * SIDE + 5] = 256;
        let cells = blurred(&pixels);
        let at = |column: usize, row: usize| u32::from(cells[row * SIDE + column]);
        assert_eq!([at(5, 5), at(4, 5), at(5, 6), at(6, 6), at(7, 5)], [63, 31, 31, 15, 0]);
        assert_eq!(blurred(&[256; SIDE * SIDE])[SIDE + 1], COVERED);
    }
}

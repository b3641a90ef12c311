//! A smooth line around what is strong in an image: marching squares on blurred values.
//!
//! Used by the page, which outlines maps and paths with it.

use super::SIDE;

/// Where the line runs, as a share of the largest value. A path one cell wide keeps its width after the blur.
const LEVEL: f32 = 0.4;

/// A piece of a line, in cells from the bottom left corner of the image.
pub type Segment = [[f64; 2]; 2];

/// Returns the line around the strong values of 64 x 64 cells, row 0 at the bottom: pieces no longer than a cell's
/// diagonal, and the square of cell centres that each lies in.
///
/// # Panics
/// If there are fewer than `CELLS` values.
pub fn contour(values: &[f32]) -> Vec<(usize, usize, Segment)> {
    let smooth = blurred(values);
    let value = |column: usize, row: usize| {
        // The outermost centres lie beyond the image, where nothing is.
        let inside = (1..=SIDE).contains(&column) && (1..=SIDE).contains(&row);
        if inside { smooth[(row - 1) * SIDE + column - 1] } else { 0.0 }
    };
    let mut segments = Vec::new();
    for row in 0..=SIDE {
        for column in 0..=SIDE {
            let corners = [[0, 0], [1, 0], [1, 1], [0, 1]];
            let crossings: Vec<[f64; 2]> = (0..4)
                .filter_map(|edge| {
                    let (from, to) = (corners[edge], corners[(edge + 1) % 4]);
                    let [one, other] = [from, to].map(|[right, up]| value(column + right, row + up));
                    let share = f64::from((LEVEL - one) / (other - one));
                    let between = |axis: usize| from[axis] as f64 + share * (to[axis] as f64 - from[axis] as f64);
                    let [x, y] = [column as f64 - 0.5 + between(0), row as f64 - 0.5 + between(1)];
                    ((one > LEVEL) != (other > LEVEL)).then_some([x, y])
                })
                .collect();
            segments.extend(crossings.chunks_exact(2).map(|pair| (column, row, [pair[0], pair[1]])));
        }
    }
    segments
}

/// Returns the values averaged with their neighbours, with weights 1, 2, 1 in both directions.
fn blurred(values: &[f32]) -> Vec<f32> {
    let along = |values: &[f32], stride: usize, place: fn(usize) -> usize| -> Vec<f32> {
        let blur = |index: usize| {
            let before = if place(index) > 0 { values[index - stride] } else { 0.0 };
            let after = if place(index) + 1 < SIDE { values[index + stride] } else { 0.0 };
            0.25 * before + 0.5 * values[index] + 0.25 * after
        };
        (0..values.len()).map(blur).collect()
    };
    along(&along(values, 1, |index| index % SIDE), SIDE, |index| index / SIDE)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::CELLS;

    /// An image that is 1 where a condition on column and row holds, else 0.
    fn image(holds: impl Fn(usize, usize) -> bool) -> Vec<f32> {
        (0..CELLS).map(|cell| f32::from(u8::from(holds(cell % SIDE, cell / SIDE)))).collect()
    }

    #[test]
    fn nothing_has_no_line() {
        assert!(contour(&[0.0; CELLS]).is_empty());
    }

    #[test]
    fn a_disc_is_outlined_by_a_closed_smooth_line() {
        let disc = image(|column, row| libm::hypot(column as f64 - 31.5, row as f64 - 31.5) < 10.0);
        let line = contour(&disc);
        for (_, _, segment) in &line {
            for [x, y] in segment {
                let radius = libm::hypot(x - 32.0, y - 32.0);
                assert!((radius - 10.0).abs() < 0.7, "{radius} cells: no steps");
            }
        }
        let mut ends: Vec<[i64; 2]> = line
            .iter()
            .flat_map(|(_, _, segment)| segment.map(|end| end.map(|coordinate| (coordinate * 1e6).round() as i64)))
            .collect();
        ends.sort_unstable();
        assert!(ends.chunks(2).all(|pair| pair[0] == pair[1]), "each end is the end of two pieces");
    }

    #[test]
    fn a_path_one_cell_wide_keeps_its_line() {
        let line = contour(&image(|column, _| column == 20));
        let middle: Vec<f64> = line.iter().filter(|(_, row, _)| *row == 30).map(|(_, _, [[x, _], _])| *x).collect();
        assert_eq!(middle.len(), 2);
        assert!(middle.iter().all(|x| (x - 20.5).abs() < 0.7), "{middle:?}");
    }

    #[test]
    fn the_line_closes_at_the_edge() {
        let line = contour(&image(|column, _| column < 3));
        assert!(line.iter().any(|(_, _, [[x, _], _])| *x < 0.5), "also along the left edge");
    }
}

//! The colours and patterns of the map of all solutions.

/// Returns the colour, RGBA, of a pixel of an outcome (`search::solve_map`). `x` and `y` in 0..8 are the pixel's
/// position in a pattern of two by two cells. Solved is filled and dotted, invalid has diagonal lines, not solved has a
/// few dots, and untried is transparent.
pub fn outcome_colour(outcome: u8, x: usize, y: usize, dark: bool) -> [u8; 4] {
    const SOLVED: [u8; 4] = [240, 188, 66, 255];
    let gray = if dark { 225 } else { 70 };
    match outcome {
        1 if (x + y).is_multiple_of(8) => [gray, gray, gray, 120],
        1 => [gray, gray, gray, 36],
        2 if x == 3 && y == 3 => [gray, gray, gray, 150],
        3 if x % 4 == 1 && y % 4 == 1 => [40, 30, 0, 255],
        3 => SOLVED,
        _ => [0; 4],
    }
}

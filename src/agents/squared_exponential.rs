//! The squared exponential covariance of two points, or of many points with one. Used by `online`.

/// A correlation of exp(-80), 2e-35, or less counts as 0: it would not change the last bit of a logit.
const NEGLIGIBLE: f64 = 80.0;

/// A squared exponential covariance.
#[derive(Clone, Copy, Debug)]
pub struct SquaredExponential {
    /// Variance of a logit before any observation.
    pub variance: f64,
    /// The root mean square difference of the coordinates of two points at which their correlation has fallen to 0.61.
    pub length_scale: f64,
}

/// Points of equal dimension, stored coordinate by coordinate, so that several are compared in parallel.
pub struct Points {
    count: usize,
    /// For each coordinate, its value for every point.
    coordinates: Vec<Vec<f32>>,
}

impl Points {
    /// Arranges points.
    pub fn new<const DIMENSIONS: usize>(points: &[[f32; DIMENSIONS]]) -> Points {
        let of_all = |dimension: usize| points.iter().map(|point| point[dimension]).collect();
        Points { count: points.len(), coordinates: (0..DIMENSIONS).map(of_all).collect() }
    }
}

impl SquaredExponential {
    /// Returns the covariance of two points of equal dimension.
    pub fn of(&self, a: &[f32], b: &[f32]) -> f64 {
        let squares = a.iter().zip(b).map(|(a, b)| f64::from(a - b) * f64::from(a - b));
        self.of_squares(squares.sum::<f64>(), a.len())
    }

    /// Returns the covariance of each of the points with another.
    pub fn of_all(&self, points: &Points, point: &[f32]) -> Vec<f64> {
        let mut sums = vec![0.0; points.count];
        for (coordinates, at) in points.coordinates.iter().zip(point) {
            for (sum, coordinate) in sums.iter_mut().zip(coordinates) {
                let difference = f64::from(coordinate - at);
                *sum += difference * difference;
            }
        }
        for sum in &mut sums {
            *sum = self.of_squares(*sum, point.len());
        }
        sums
    }

    /// Returns the covariance of two points from the sum of the squared differences of their coordinates.
    #[inline(always)]
    fn of_squares(&self, sum: f64, dimensions: usize) -> f64 {
        let mean_square = sum / dimensions as f64;
        self.variance * exp_of_negative(-mean_square / (2.0 * self.length_scale * self.length_scale))
    }
}

/// Returns e to a power of at most 0, with a relative error of 1e-15; 0 where the result is negligible. Unlike libm's,
/// the compiler can vectorize it. The same to the bit natively and in wasm.
#[inline(always)]
fn exp_of_negative(x: f64) -> f64 {
    /// ln 2 in two parts, the first with few enough bits that its multiples are exact (Cody and Waite 1980).
    const LN_2: [f64; 2] = [0.693_147_180_369_123_8, 1.908_214_929_270_587_7e-10];
    /// Adding this to a small number rounds it to a whole one, and leaves that plus the exponent bias in the lowest
    /// bits.
    const ROUND: f64 = 6_755_399_441_055_744.0 + 1023.0;
    /// 1 / n! from n = 12 down to 0.
    const SERIES: [f64; 13] = [
        1.0 / 479_001_600.0,
        1.0 / 39_916_800.0,
        1.0 / 3_628_800.0,
        1.0 / 362_880.0,
        1.0 / 40_320.0,
        1.0 / 5040.0,
        1.0 / 720.0,
        1.0 / 120.0,
        1.0 / 24.0,
        1.0 / 6.0,
        0.5,
        1.0,
        1.0,
    ];
    let within = if x < -NEGLIGIBLE { -NEGLIGIBLE } else { x };
    let rounded = within * std::f64::consts::LOG2_E + ROUND;
    let whole = rounded - ROUND;
    let rest = within - whole * LN_2[0] - whole * LN_2[1];
    let series = SERIES.iter().fold(0.0, |sum, factor| sum * rest + factor);
    let power_of_two = f64::from_bits(rounded.to_bits() << 52);
    if x < -NEGLIGIBLE { 0.0 } else { series * power_of_two }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_exponential_function_is_that_of_the_library() {
        for step in 0..=80_000 {
            let x = -0.001 * f64::from(step);
            let (found, expected) = (exp_of_negative(x), libm::exp(x));
            assert!((found - expected).abs() <= 1e-15 * expected, "e^{x}: {found}, not {expected}");
        }
        assert_eq!(exp_of_negative(-80.01), 0.0);
    }

    #[test]
    fn many_points_have_the_covariances_of_each() {
        let kernel = SquaredExponential { variance: 3.0, length_scale: 7.0 };
        let points: Vec<[f32; 2]> = (0..9).map(|index| [index as f32 * 13.0, 40.0 - index as f32]).collect();
        let of_each: Vec<f64> = points.iter().map(|point| kernel.of(point, &points[3])).collect();
        assert_eq!(kernel.of_all(&Points::new(&points), &points[3]), of_each);
        assert_eq!(of_each[3], 3.0);
    }
}

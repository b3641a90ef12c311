//! Operations on numbers that are single instructions in wasm too: the same results as those that they replace for all
//! numbers but NaN, which does not occur here.

use rapier2d::math::Vector;

/// The length of a vector. `Vector::length` takes the square root from libm, which is a loop in wasm. The result is the
/// same, because IEEE 754 prescribes the rounding.
pub(crate) fn length(vector: Vector) -> f32 {
    vector.length_squared().sqrt()
}

/// The larger of two numbers. `f32::max` treats NaN, which is a call in wasm.
pub(crate) fn max(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// The smaller of two numbers, like `max`.
pub(crate) fn min(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

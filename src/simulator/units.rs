//! Units of length: px outside this folder, metres inside.
//!
//! PHYRE rounds a length in px to single precision before dividing it. Dividing first would change the last bit of two
//! coordinates in five, and with it nearly every rollout.

use rapier2d::math::Vector;

/// px per metre (PHYRE).
pub const PX_PER_METRE: f32 = 6.0;

/// Converts a length from px.
pub fn metres(px: f64) -> f32 {
    px as f32 / PX_PER_METRE
}

/// Converts a point from px.
pub fn point_in_metres([x, y]: [f64; 2]) -> Vector {
    Vector::new(metres(x), metres(y))
}

/// Converts a point to px.
pub fn point_in_px(point: Vector) -> [f32; 2] {
    (point * PX_PER_METRE).to_array()
}

//! Rotations, transforms and scalars: b2Rot, b2Transform and the functions of b2Math.h.
//!
//! Vectors are rapier's; `Vector::dot`, `perp_dot` and `perp` are b2Dot, b2Cross of two vectors, and b2Cross of 1 and a
//! vector. Sums and products are in Box2D's order, because another order rounds differently.

use rapier2d::math::Vector;

/// Sine and cosine of an angle (b2Rot).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rotation {
    pub(super) sin: f32,
    pub(super) cos: f32,
}

impl Rotation {
    pub(super) const IDENTITY: Rotation = Rotation { sin: 0.0, cos: 1.0 };

    /// Sine and cosine are correctly rounded: computed in double precision, then rounded once. PHYRE's came from the C
    /// library of its time, which nearly always rounds correctly; later libraries round differently.
    pub(super) fn new(angle: f32) -> Rotation {
        let (sin, cos) = libm::sincos(f64::from(angle));
        Rotation { sin: sin as f32, cos: cos as f32 }
    }

    /// Rotates a vector (b2Mul).
    #[inline(always)]
    pub(super) fn rotate(self, v: Vector) -> Vector {
        Vector::new(self.cos * v.x - self.sin * v.y, self.sin * v.x + self.cos * v.y)
    }

    /// Rotates a vector back (b2MulT).
    #[inline(always)]
    pub(super) fn rotate_back(self, v: Vector) -> Vector {
        Vector::new(self.cos * v.x + self.sin * v.y, -self.sin * v.x + self.cos * v.y)
    }
}

/// The frame of a body: the position of its origin, m, and its rotation (b2Transform).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Transform {
    pub(super) position: Vector,
    pub(super) rotation: Rotation,
}

impl Transform {
    /// Returns the frame of a body whose centre of mass is at `centre`, m; `local_centre` is this point in the body's
    /// frame.
    #[inline(always)]
    pub(super) fn about(centre: Vector, local_centre: Vector, rotation: Rotation) -> Transform {
        Transform { position: centre - rotation.rotate(local_centre), rotation }
    }

    /// Transforms a point from this frame to the world (b2Mul).
    #[inline(always)]
    pub(super) fn to_world(self, p: Vector) -> Vector {
        let Rotation { sin, cos } = self.rotation;
        Vector::new((cos * p.x - sin * p.y) + self.position.x, (sin * p.x + cos * p.y) + self.position.y)
    }

    /// Transforms a point from the world to this frame (b2MulT).
    #[inline(always)]
    pub(super) fn to_local(self, p: Vector) -> Vector {
        self.rotation.rotate_back(p - self.position)
    }

    /// Returns another frame relative to this one (b2MulT).
    #[inline(always)]
    pub(super) fn relative(&self, other: &Transform) -> Transform {
        let (q, r) = (self.rotation, other.rotation);
        let rotation = Rotation { sin: q.cos * r.sin - q.sin * r.cos, cos: q.cos * r.cos + q.sin * r.sin };
        Transform { position: q.rotate_back(other.position - self.position), rotation }
    }
}

/// Turns a vector clockwise by a right angle (b2Cross of a vector and 1).
#[inline(always)]
pub(super) fn clockwise(v: Vector) -> Vector {
    Vector::new(v.y, -v.x)
}

/// Returns the length of a vector. `Vector::length` takes the square root from libm, which is a loop in wasm; the
/// result is the same, because IEEE 754 prescribes the rounding.
#[inline(always)]
pub(super) fn length(v: Vector) -> f32 {
    v.length_squared().sqrt()
}

/// Returns the unit vector in the direction of a vector. A vector of negligible length is returned unchanged
/// (b2Vec2::Normalize).
#[inline(always)]
pub(super) fn normalized(v: Vector) -> Vector {
    let length = length(v);
    if length < f32::EPSILON {
        return v;
    }
    let inv_length = 1.0 / length;
    Vector::new(v.x * inv_length, v.y * inv_length)
}

/// Returns the smaller of two numbers (b2Min). `f32::min` handles NaN, which is a call in wasm.
#[inline(always)]
pub(super) fn min(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// Returns the larger of two numbers (b2Max).
#[inline(always)]
pub(super) fn max(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// Returns the number in `low..=high` that is nearest to `a` (b2Clamp).
#[inline(always)]
pub(super) fn clamp(a: f32, low: f32, high: f32) -> f32 {
    max(low, min(a, high))
}

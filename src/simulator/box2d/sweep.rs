//! The motion of a body over a step: b2Sweep.

use std::f32::consts::TAU;

use rapier2d::math::Vector;

use super::math::{Rotation, Transform};

/// The motion of a body's centre of mass, m, and its angle, radians, not wrapped. `centre0` and `angle0` belong to the
/// start of the step or the last time of impact, the rest to the end of the step.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sweep {
    /// The centre of mass in the frame of the body, m.
    pub(super) local_centre: Vector,
    pub(super) centre0: Vector,
    pub(super) centre: Vector,
    pub(super) angle0: f32,
    pub(super) angle: f32,
    /// The fraction of the step to which `centre0` and `angle0` belong.
    pub(super) alpha0: f32,
    /// Whether all shapes are circles about the origin. Rotation then changes nothing and is not computed.
    pub(super) is_round: bool,
}

impl Sweep {
    /// Returns the rotation of the body at an angle.
    #[inline(always)]
    pub(super) fn rotation(&self, angle: f32) -> Rotation {
        if self.is_round { Rotation::IDENTITY } else { Rotation::new(angle) }
    }

    /// Returns the frame of the body at a fraction of the rest of the step (GetTransform).
    #[inline(always)]
    pub(super) fn transform(&self, beta: f32) -> Transform {
        let centre = (1.0 - beta) * self.centre0 + beta * self.centre;
        let rotation = self.rotation((1.0 - beta) * self.angle0 + beta * self.angle);
        Transform::about(centre, self.local_centre, rotation)
    }

    /// Moves the start forward to a fraction of the step (Advance). It interpolates differently from `transform`, so a
    /// body that does not move stays in place to the last bit.
    #[inline]
    pub(super) fn advance(&mut self, alpha: f32) {
        let beta = (alpha - self.alpha0) / (1.0 - self.alpha0);
        self.centre0 += beta * (self.centre - self.centre0);
        self.angle0 += beta * (self.angle - self.angle0);
        self.alpha0 = alpha;
    }

    /// Returns the sweep with `angle0` in 0..2π (Normalize).
    pub(super) fn normalized(&self) -> Sweep {
        let turns = TAU * floor(self.angle0 / TAU);
        Sweep { angle0: self.angle0 - turns, angle: self.angle - turns, ..*self }
    }
}

/// Like `f32::floor`, which is a call if the processor's instruction set has no such instruction.
fn floor(number: f32) -> f32 {
    // From here on all numbers are whole.
    const LARGEST: f32 = 8_388_608.0;
    if number.abs() < LARGEST {
        let truncated = number as i32 as f32;
        if truncated > number { truncated - 1.0 } else { truncated }
    } else {
        number
    }
}

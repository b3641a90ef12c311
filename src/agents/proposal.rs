//! A proposed ball and its origin.

use serde::Serialize;

use crate::puzzle::action::Ball;

/// A valid ball that an agent proposes, and how it was found.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Proposal {
    pub ball: Ball,
    pub origin: Origin,
    /// Draws before it that were rejected: invalid, or proposed already.
    pub rejected: usize,
}

/// Where a proposal comes from.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Origin {
    /// A cell of the placement map, by its centre in px, from which the ball was improved.
    Map { x: f64, y: f64 },
    /// An earlier proposal, by its number from 1, with Gaussian noise.
    Perturbed { number: usize },
    /// Uniform over the action space: the placement map has no place where a ball may be.
    Uniform,
    /// The judge's maps: the probability, 0..=1, that the ball solves, lowered by the proposals before it.
    Judge { probability: f64 },
}

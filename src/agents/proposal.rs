//! A proposed ball and where it comes from.

use serde::Serialize;

use crate::puzzle::action::Ball;

/// A ball that is proposed, and how it was come by.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Proposal {
    pub ball: Ball,
    pub origin: Origin,
    /// Draws before it that were passed over: invalid, or proposed already.
    pub passed: usize,
}

/// Where a proposal comes from.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Origin {
    /// A cell of the map, by its middle in px, from which the ball was improved.
    Map { x: f64, y: f64 },
    /// An earlier proposal, by its number from 1, with noise.
    Near { number: usize },
    /// The judge's maps: how likely they say that it solves, 0..=1, after what was proposed before.
    Judge { chance: f64 },
    /// Chance: the map has no place where a ball may be.
    Chance,
}

//! The constants of a memory: how similarity is measured, and how much each attempt weighs.

use super::Attempt;

/// Parameters of similarity and learning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Distance of two sketches at which the similarity of their scenes has fallen to 0.61; infinite to treat all
    /// scenes as alike.
    pub scene_length: f64,
    /// Distance of two balls in x, y and radius, px, at which their similarity has fallen to 0.61.
    pub ball_length: f64,
    /// Weights of three similarities of balls: by position in the scene, relative to the green object, and relative to
    /// the goal.
    pub shares: [f64; 3],
    /// By how much a wholly unexpected success raises the logit of an identical ball.
    pub success: f64,
    /// By how much a wholly unexpected failure lowers the logit of an identical ball.
    pub failure: f64,
    /// Lower limit on the chance that a failure is taken to have had.
    pub least_expected: f64,
    /// Maximum number of balls from similar scenes that become candidates.
    pub suggestions: usize,
}

impl Settings {
    /// The settings chosen on dev tasks.
    pub const DEFAULT: Settings = Settings {
        scene_length: 0.8,
        ball_length: 8.0,
        shares: [1.0 / 3.0; 3],
        success: 6.0,
        failure: 2.0,
        least_expected: 0.05,
        suggestions: 20,
    };

    /// Returns by how much an attempt changes the logit of its own ball, given the chance that the ball had.
    pub(super) fn weight(&self, &Attempt { chance, solved, .. }: &Attempt) -> f64 {
        let Settings { success, failure, least_expected, .. } = *self;
        if solved { success * (1.0 - chance) } else { -failure * chance.max(least_expected) }
    }
}

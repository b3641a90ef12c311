//! The constants of a memory: which attempts are alike, and how much each weighs.

use super::Attempt;

/// What makes attempts alike, and how much they teach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Distance of two sketches at which the similarity of their scenes has fallen to 0.61; infinite if all scenes are
    /// alike.
    pub scene_length: f64,
    /// Distance of two balls in x, y and radius, px, at which their similarity has fallen to 0.61.
    pub ball_length: f64,
    /// Shares of three similarities of balls, by position in the scene, relative to the green object, and relative to
    /// its goal.
    pub shares: [f64; 3],
    /// By how much a wholly unexpected success raises the logit of the same ball.
    pub success: f64,
    /// By how much a wholly unexpected failure lowers it.
    pub failure: f64,
    /// A failure counts as if at least this chance had been expected.
    pub least_expected: f64,
    /// At most this number of balls that solved similar scenes become candidates.
    pub suggestions: usize,
}

impl Settings {
    /// Chosen on dev tasks.
    pub const DEFAULT: Settings = Settings {
        scene_length: 0.8,
        ball_length: 8.0,
        shares: [1.0 / 3.0; 3],
        success: 6.0,
        failure: 2.0,
        least_expected: 0.05,
        suggestions: 20,
    };

    /// By how much an attempt moves the logit of its own ball, given the chance that it had.
    pub(super) fn weight(&self, &Attempt { chance, solved, .. }: &Attempt) -> f64 {
        let Settings { success, failure, least_expected, .. } = *self;
        if solved { success * (1.0 - chance) } else { -failure * chance.max(least_expected) }
    }
}

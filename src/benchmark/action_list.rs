//! PHYRE's list of 100,000 actions, one for all tasks.
//!
//! PHYRE's baselines choose from this list, and its simulation cache holds the status of each of these actions in each
//! task (`get_default_100k_cache("ball")`). Used by the agent `listed` and by the Python package.

use crate::puzzle::action::Action;
use crate::puzzle::numpy::RandomState;

/// Number of actions in the list (PHYRE's `DEFAULT_NUM_ACTIONS`).
pub const ACTIONS: usize = 100_000;

/// Seed of the list (PHYRE's `ACTION_SEED`).
const SEED: usize = 42;

/// Returns the list: uniform draws whose ball lies inside the scene but may overlap bodies of a task. Each number is
/// rounded to f32, as in PHYRE's file.
///
/// ```
/// use pathlight::benchmark::action_list::action_list;
///
/// let first = action_list().next().expect("there are 100,000");
/// assert_eq!([first.x, first.y, first.r].map(|value| value as f32), [0.5986585, 0.15601864, 0.15599452]);
/// ```
pub fn action_list() -> impl Iterator<Item = Action> {
    let mut random = RandomState::new(SEED);
    let draws = std::iter::repeat_with(move || [(); 3].map(|()| random.unit()));
    let inside = draws.filter(|&draw| Action::from(draw).check_bounds().is_ok());
    inside.map(|draw| Action::from(draw.map(|value| f64::from(value as f32)))).take(ACTIONS)
}

#[cfg(test)]
mod tests {
    use sha2::{Digest, Sha256};

    use super::*;
    use crate::puzzle::hex::hex;

    /// The digest printed by NumPy 2.4.6:
    ///
    /// ```python
    /// rng, actions = np.random.RandomState(42), []
    /// while len(actions) < 100_000:
    ///     x, y, r = action = rng.random_sample(3)
    ///     x, y, r = x * 255, y * 255, r * 30 + 2
    ///     if r <= x <= 256 - r and r <= y <= 256 - r:
    ///         actions.append(action)
    /// hashlib.sha256(np.array(actions, "<f4").tobytes()).hexdigest()
    /// ```
    #[test]
    fn the_list_is_the_one_that_numpy_draws() {
        let mut hash = Sha256::new();
        for number in action_list().flat_map(<[f64; 3]>::from) {
            hash.update((number as f32).to_le_bytes());
        }
        let digest = "ffa28743769adf9d0220f18ffba4db9516358b9b91f37c6fc1ee88a332c314bd";
        assert_eq!(hex(hash.finalize()), digest);
    }
}

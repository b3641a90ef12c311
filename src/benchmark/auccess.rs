//! AUCCESS, PHYRE's metric: the area under the success curve. It is a weighted mean, over numbers of attempts, of the
//! fraction of tasks that an agent solves within them.
//!
//! auccess = sum_k w_k s_k / sum_k w_k, w_k = ln(k + 1) - ln(k), k = 1..=K, where s_k is the fraction of tasks
//! solved within k attempts (Bakhtin et al. 2019). Printed in percent.

/// K of AUCCESS: attempts after this one do not count (PHYRE's `MAX_TEST_ATTEMPTS`).
pub const MAX_ATTEMPTS: usize = 100;

/// Returns the AUCCESS in percent, 0..=100. The argument holds, for each task, the number (from 1) of the first attempt
/// that solved it, if any did. Returns 0 for no tasks.
///
/// ```
/// use pathlight::benchmark::auccess::auccess;
///
/// assert_eq!(auccess(&[Some(1), None]), 50.0);
/// assert!(auccess(&[Some(2)]) < auccess(&[Some(1)]));
/// ```
pub fn auccess(first_solved: &[Option<usize>]) -> f64 {
    let weight = |attempt: usize| libm::log((attempt + 1) as f64 / attempt as f64);
    let weighted: f64 = (1..=MAX_ATTEMPTS).map(|k| weight(k) * solved_within(first_solved, k)).sum();
    100.0 * weighted / (1..=MAX_ATTEMPTS).map(weight).sum::<f64>()
}

/// Returns the fraction of tasks solved within `attempts` attempts, 0..=1; 0 for no tasks.
pub fn solved_within(first_solved: &[Option<usize>], attempts: usize) -> f64 {
    let solved = first_solved.iter().filter(|first| first.is_some_and(|first| first <= attempts)).count();
    if first_solved.is_empty() { 0.0 } else { solved as f64 / first_solved.len() as f64 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Figures of PHYRE's definition for a single task.
    #[test]
    fn one_task_solved_at_a_given_attempt() {
        for (attempt, percent) in [(1, 100.0), (2, 85.0), (10, 50.1), (50, 15.2)] {
            assert!((auccess(&[Some(attempt)]) - percent).abs() < 0.06, "attempt {attempt}");
        }
        assert_eq!(auccess(&[None]), 0.0);
        assert_eq!(auccess(&[]), 0.0);
    }

    #[test]
    fn attempts_after_the_last_that_counts_score_nothing() {
        assert!(auccess(&[Some(MAX_ATTEMPTS)]) > 0.0);
        assert_eq!(auccess(&[Some(MAX_ATTEMPTS + 1)]), 0.0);
    }
}

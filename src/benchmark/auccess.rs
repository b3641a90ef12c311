//! PHYRE's metric: how soon, over many tasks, an agent solves them.
//!
//! auccess = sum_k w_k s_k / sum_k w_k, w_k = ln(k + 1) - ln(k), k = 1..=100, where s_k is the share of tasks
//! solved within k attempts (Bakhtin et al. 2019). Printed in percent.

/// The most attempts that an agent has at one task.
pub const ATTEMPTS: usize = 100;

/// Auccess, 0..=100. For each task, the attempt (from 1) that first solved it, if one did; 0 for no tasks.
pub fn auccess(first_solved: &[Option<usize>]) -> f64 {
    let weight = |attempt: usize| libm::log((attempt + 1) as f64 / attempt as f64);
    let weighted: f64 = (1..=ATTEMPTS).map(|k| weight(k) * share_within(first_solved, k)).sum();
    100.0 * weighted / (1..=ATTEMPTS).map(weight).sum::<f64>()
}

/// Share of tasks solved within so many attempts, 0..=1; 0 for no tasks.
pub fn share_within(first_solved: &[Option<usize>], attempts: usize) -> f64 {
    let solved = first_solved.iter().filter(|first| first.is_some_and(|first| first <= attempts)).count();
    if first_solved.is_empty() { 0.0 } else { solved as f64 / first_solved.len() as f64 }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The figures that PHYRE's definition gives for one task.
    #[test]
    fn one_task_solved_at_a_given_attempt() {
        for (attempt, percent) in [(1, 100.0), (2, 85.0), (10, 50.1), (50, 15.2)] {
            assert!((auccess(&[Some(attempt)]) - percent).abs() < 0.06, "attempt {attempt}");
        }
        assert_eq!(auccess(&[None]), 0.0);
        assert_eq!(auccess(&[]), 0.0);
    }

    #[test]
    fn attempts_past_the_hundredth_do_not_count() {
        assert_eq!(auccess(&[Some(101)]), 0.0);
    }
}

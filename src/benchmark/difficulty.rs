//! The difficulty of the benchmark's tasks: how many uniform valid balls solve each.
//!
//! `pathlight-lab data difficulty` measures the counts, which ship in difficulty.json. Used by the page, which shows
//! players how hard a puzzle is, and wherever a scene is ranked among the benchmark's tasks.

use serde::{Deserialize, Serialize};

use crate::puzzle::task::TaskId;
use crate::puzzle::templates::TEMPLATES;

/// How many of `balls` uniform valid balls solved each task.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Difficulty {
    /// Version of the simulator used.
    pub simulator: u32,
    /// Seed of the balls.
    pub seed: u64,
    /// Valid balls tried per task.
    pub balls: u32,
    /// The number of balls that solved each task: for each template, in the order of `TEMPLATES`, its tasks in
    /// ascending order.
    pub solved: Vec<Vec<u32>>,
}

impl Difficulty {
    /// Returns the counts of difficulty.json.
    pub fn shipped() -> Difficulty {
        let text = include_str!("difficulty.json");
        serde_json::from_str(text).expect("tests/difficulty.rs reads the shipped file")
    }

    /// Returns the share of valid balls that solve a task, 0..=1; `None` if the task is not in the benchmark.
    pub fn solve_rate(&self, task: TaskId) -> Option<f64> {
        let column = TEMPLATES.get(task.template)?.task_numbers.binary_search(&task.number).ok()?;
        let solved = self.solved.get(task.template)?.get(column)?;
        Some(f64::from(*solved) / f64::from(self.balls))
    }

    /// Returns the shares of valid balls that solve the tasks, 0..=1: the tasks of the first template, ascending, then
    /// those of the next.
    pub fn solve_rates(&self) -> impl Iterator<Item = f64> + '_ {
        self.solved.iter().flatten().map(|&solved| f64::from(solved) / f64::from(self.balls))
    }

    /// Returns the share of the benchmark's tasks that are harder than a solve rate of 0..=1, with tasks of the same
    /// rate counted half: 0 (the hardest) to 1 (the easiest).
    pub fn rank(&self, solve_rate: f64) -> f64 {
        let rates = || self.solve_rates();
        let (lower, higher) = (rates().filter(|&rate| rate < solve_rate), rates().filter(|&rate| rate > solve_rate));
        let (all, lower, higher) = (rates().count() as f64, lower.count() as f64, higher.count() as f64);
        (all + lower - higher) / (2.0 * all)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn difficulty() -> Difficulty {
        Difficulty { simulator: 3, seed: 0, balls: 10, solved: vec![vec![0, 1], vec![4, 1]] }
    }

    #[test]
    fn a_rate_is_a_count_of_the_balls() {
        let id = |text: &str| text.parse::<TaskId>().expect("an id");
        let [first, second] = [0, 1].map(|column| TaskId { template: 1, number: TEMPLATES[1].task_numbers[column] });
        assert_eq!([first, second].map(|task| difficulty().solve_rate(task)), [Some(0.4), Some(0.1)]);
        assert_eq!(difficulty().solve_rate(id("00000:999")), None, "not in the benchmark");
        assert_eq!(difficulty().solve_rate(id("00024:000")), None, "no counts");
    }

    #[test]
    fn the_rank_counts_the_harder_tasks_and_half_of_the_equal_ones() {
        assert_eq!([0.0, 0.05, 0.1, 0.4, 1.0].map(|rate| difficulty().rank(rate)), [0.125, 0.25, 0.5, 0.875, 1.0]);
    }
}

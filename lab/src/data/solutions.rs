//! Solutions of tasks, found among uniform draws like PHYRE's own collection of solutions. Used by `collect` and by
//! everything that trains on solutions.
//!
//! The search for a task depends only on its id and the seed, so tasks can be searched in any order and on any machine,
//! and no solution of one task influences the search for another.

use pathlight::puzzle::action::{Ball, Obstacles};
use pathlight::puzzle::sampling::uniform_ball;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::simulator::outcome;
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use serde::{Deserialize, Serialize};

/// A ball that solves a task.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution {
    pub task: TaskId,
    /// px
    pub ball: Ball,
}

/// The first solutions among uniform valid balls of a task.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct TaskSolutions {
    pub task: TaskId,
    /// Number of balls simulated.
    pub rollouts: usize,
    /// Balls that solve the task, in the order drawn, px. A ball may be drawn twice.
    pub balls: Vec<Ball>,
}

impl TaskSolutions {
    /// Draws valid balls uniformly until `wanted` of them solve the task, `max_rollouts` are simulated, or the scene
    /// has no room for a ball.
    pub fn search(task: &Task, wanted: usize, max_rollouts: usize, seed: u64) -> TaskSolutions {
        let mut rng = Pcg64Mcg::seed_from_u64(task.id.seed(seed));
        let obstacles = Obstacles::new(&task.scene);
        let mut found = TaskSolutions { task: task.id, rollouts: 0, balls: Vec::new() };
        while found.balls.len() < wanted && found.rollouts < max_rollouts {
            let Some(ball) = uniform_ball(&obstacles, &mut rng) else { break };
            found.rollouts += 1;
            if outcome(&task.scene, Some(ball)).is_ok_and(|outcome| outcome.solved) {
                found.balls.push(ball);
            }
        }
        found
    }

    /// Iterates over the solutions.
    pub fn solutions(&self) -> impl Iterator<Item = Solution> {
        self.balls.iter().map(|&ball| Solution { task: self.task, ball })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn task(id: &str) -> Task {
        Task::load(id.parse().expect("an id")).expect("a task")
    }

    #[test]
    fn a_search_ends_with_the_last_solution_that_was_asked_for() {
        let task = task("00002:007");
        let [three, two] = [3, 2].map(|wanted| TaskSolutions::search(&task, wanted, 10_000, 0));
        assert_eq!(three.balls.len(), 3);
        assert_eq!(three.balls[..2], two.balls, "a longer search starts with the same solutions");
        assert!(two.rollouts < three.rollouts);
        let all_solve = three.balls.iter().all(|&ball| outcome(&task.scene, Some(ball)).expect("valid").solved);
        assert!(all_solve);
    }

    #[test]
    fn a_search_ends_with_the_last_rollout_that_is_allowed() {
        let found = TaskSolutions::search(&task("00024:006"), 10, 50, 0);
        assert_eq!(found.rollouts, 50);
        assert!(found.balls.len() < 10);
    }

    #[test]
    fn tasks_and_seeds_draw_different_balls() {
        let find = |id: &str, seed| TaskSolutions::search(&task(id), 2, 10_000, seed).balls;
        assert_ne!(find("00002:007", 0), find("00002:007", 1));
        assert_ne!(find("00002:007", 0), find("00002:011", 0));
    }
}

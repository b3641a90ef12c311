//! Counts how many uniformly drawn valid balls solve each task, for difficulty.json of `pathlight::benchmark`.

use pathlight::benchmark::difficulty::Difficulty;
use pathlight::puzzle::action::Obstacles;
use pathlight::puzzle::sampling::uniform_ball;
use pathlight::puzzle::task::Task;
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator::{self, outcome};
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use crate::progress::Progress;

/// What to count.
pub struct Settings {
    /// Valid balls per task.
    pub balls: u32,
    /// Maximum number of tasks per template; the first are used.
    pub limit: usize,
    /// Seed of the balls.
    pub seed: u64,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings { balls: 500, limit: 100, seed: 0 }
    }
}

impl Settings {
    /// Counts how many balls solve each task.
    pub fn measure(&self, progress: &mut dyn Progress) -> Difficulty {
        progress.begin(TEMPLATES.len() as u64);
        let mut solved = Vec::new();
        for template in TEMPLATES {
            let tasks: Vec<Task> = Task::of(template).take(self.limit).collect();
            solved.push(tasks.par_iter().map(|task| self.solving_balls(task)).collect());
            progress.advance(1, format!("template {:05}", template.number));
        }
        progress.finish(&format!("{} balls per task", self.balls));
        Difficulty { simulator: simulator::VERSION, seed: self.seed, balls: self.balls, solved }
    }

    fn solving_balls(&self, task: &Task) -> u32 {
        let mut rng = Pcg64Mcg::seed_from_u64(task.id.seed(self.seed));
        let obstacles = Obstacles::new(&task.scene);
        let balls = (0..self.balls).map_while(|_| uniform_ball(&obstacles, &mut rng));
        let outcomes = balls.filter_map(|ball| outcome(&task.scene, Some(ball)).ok());
        outcomes.filter(|outcome| outcome.solved).count() as u32
    }
}

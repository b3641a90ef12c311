//! `pathlight difficulty`: how many of uniform valid balls solve each task, as the JSON of assets/difficulty.json.

use std::io::{self, Write};

use pathlight::benchmark::difficulty::Difficulty;
use pathlight::dataset::sampling::random_ball;
use pathlight::puzzle::task::Task;
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator::{self, outcome};
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use super::progress::Progress;

/// Measure how hard the tasks are: how many of uniform valid balls solve each, as JSON
#[derive(clap::Args)]
pub struct Args {
    /// Valid balls per task
    #[arg(long, value_name = "N", default_value_t = 500, value_parser = clap::value_parser!(u32).range(1..))]
    balls: u32,

    /// Use only the first N tasks of each template, for a quick look
    #[arg(long, value_name = "N", default_value_t = 100)]
    limit: usize,

    /// Seed of the balls
    #[arg(long, default_value_t = 0)]
    seed: u64,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let mut progress = Progress::new(Some(TEMPLATES.len() as u64));
        let mut solved = Vec::new();
        for template in TEMPLATES {
            let tasks: Vec<Task> = Task::of(template).take(self.limit).collect();
            solved.push(tasks.par_iter().map(|task| self.solving_balls(task)).collect());
            progress.advance(1, format!("template {:05}", template.number));
        }
        let difficulty = Difficulty { simulator: simulator::VERSION, seed: self.seed, balls: self.balls, solved };
        writeln!(io::stdout(), "{}", serde_json::to_string(&difficulty)?)?;
        progress.finish(&format!("{} balls per task", self.balls));
        Ok(())
    }

    fn solving_balls(&self, task: &Task) -> u32 {
        let mut rng = Pcg64Mcg::seed_from_u64(task.id.seed(self.seed));
        let balls = (0..self.balls).map_while(|_| random_ball(&task.scene, &mut rng));
        let outcomes = balls.filter_map(|ball| outcome(&task.scene, Some(ball)).ok());
        outcomes.filter(|outcome| outcome.solved).count() as u32
    }
}

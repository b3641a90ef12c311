//! Calibration: whether the chances that the model predicts come true, on the test tasks of a fold.
//!
//! Two kinds of balls are tried: uniformly random ones, as a person may place them, few of which the model finds
//! likely; and a sample of the model's own candidates over their whole ranking.

use std::fmt::{self, Write as _};
use std::path::PathBuf;

use pathlight::agents::agent_name::AgentName;
use pathlight::agents::imagined_candidates::imagined_candidates;
use pathlight::agents::{self, sigmoid};
use pathlight::benchmark::folds::{FoldId, Setup};
use pathlight::command_line::weights_file::ModelFile;
use pathlight::nets::{Card, PathNet};
use pathlight::puzzle::action::{Ball, Obstacles};
use pathlight::puzzle::sampling::uniform_ball;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::simulator::{self, simulate};
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::task_set::TaskSet;

/// Bins of equal width in which chances are counted.
const BINS: usize = 10;

/// What to measure.
pub struct Settings {
    pub fold: FoldId,
    /// Random balls per task, and the same number of the model's candidates.
    pub balls: u16,
    /// Use only the first N test tasks per template.
    pub limit: Option<u16>,
    /// Seed of the random balls.
    pub seed: u64,
    /// Weights of the model; `None` means the shipped ones.
    pub weights: Option<PathBuf>,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings { fold: FoldId::default(), balls: 20, limit: None, seed: 0, weights: None }
    }
}

/// The measurement and its settings: the content of the `--json` file.
#[derive(Serialize, Deserialize)]
pub struct Calibration {
    pub setup: Setup,
    pub fold: u8,
    pub seed: u64,
    /// `simulator::VERSION`
    pub simulator: u32,
    /// `agents::VERSION`, on which the candidates depend.
    pub agents_version: u32,
    /// How the model was trained.
    pub card: Card,
    /// Number of test tasks.
    pub tasks: usize,
    /// Chances from 0 to 1, in bins of equal width.
    pub random: Vec<Bin>,
    pub candidates: Vec<Bin>,
}

/// The balls whose predicted chance is in one bin.
#[derive(Clone, Copy, Default, Serialize, Deserialize)]
pub struct Bin {
    pub balls: u32,
    /// Mean predicted chance, 0..=1; 0 without balls.
    pub chance: f64,
    /// Number of balls that solve.
    pub solved: u32,
}

/// The predicted chance of a ball, 0..=1, and whether the ball solves.
type Trial = (f64, bool);

const CHECKED: &str = "measure has checked that there is a dynamics net";

impl Settings {
    /// Measures the calibration.
    ///
    /// # Errors
    /// If the weights cannot be used.
    pub fn measure(&self) -> anyhow::Result<Calibration> {
        let model = ModelFile::read(self.weights.as_deref(), self.fold)?;
        model.check(AgentName::Dynamics, self.fold)?;
        let tasks = TaskSet::Test.tasks(self.fold, self.limit);
        let trials: Vec<[Vec<Trial>; 2]> =
            tasks.par_iter().map(|&id| self.trials(&model.nets, id)).collect::<anyhow::Result<_>>()?;
        let [random, candidates] = [0, 1].map(|kind| bins(trials.iter().flat_map(|of_task| &of_task[kind])));
        Ok(Calibration {
            setup: self.fold.setup,
            fold: self.fold.fold,
            seed: self.seed,
            simulator: simulator::VERSION,
            agents_version: agents::VERSION,
            card: model.card,
            tasks: tasks.len(),
            random,
            candidates,
        })
    }

    /// Tries random balls in a task, and some of the model's candidates.
    fn trials(&self, nets: &PathNet, id: TaskId) -> anyhow::Result<[Vec<Trial>; 2]> {
        let scene = Task::load(id)?.scene;
        let count = usize::from(self.balls);
        let mut rng = Pcg64Mcg::seed_from_u64(id.seed(self.seed));
        let obstacles = Obstacles::new(&scene);
        let random: Vec<Ball> =
            std::iter::repeat_with(|| uniform_ball(&obstacles, &mut rng)).map_while(|ball| ball).take(count).collect();
        let read = nets.read(&scene).expect(CHECKED);
        let imagined = read.imagine(&random);
        let chances = random.iter().zip(imagined).map(|(&ball, imagined)| (ball, f64::from(imagined.logit)));
        let mut candidates = imagined_candidates(nets, &scene, count).expect(CHECKED);
        candidates.sort_by(|a, b| b.logit.total_cmp(&a.logit));
        let every = candidates.iter().step_by((candidates.len() / count).max(1)).take(count);
        let considered: Vec<(Ball, f64)> = every.map(|candidate| (candidate.ball, candidate.logit)).collect();
        let tried = |(ball, logit): (Ball, f64)| {
            let rollout = simulate(&scene, Some(ball)).map_err(|why| anyhow::anyhow!("{id}, {ball}: {why}"))?;
            Ok((sigmoid(logit), rollout.solved))
        };
        let random = chances.map(tried).collect::<anyhow::Result<_>>()?;
        Ok([random, considered.into_iter().map(tried).collect::<anyhow::Result<_>>()?])
    }
}

fn bins<'a>(trials: impl Iterator<Item = &'a Trial>) -> Vec<Bin> {
    let mut bins = vec![Bin::default(); BINS];
    for &(chance, solved) in trials {
        let bin = &mut bins[((chance * BINS as f64) as usize).min(BINS - 1)];
        bin.chance += (chance - bin.chance) / f64::from(bin.balls + 1);
        bin.balls += 1;
        bin.solved += u32::from(solved);
    }
    for bin in &mut bins {
        bin.chance = (1e4 * bin.chance).round() / 1e4;
    }
    bins
}

impl Calibration {
    /// Formats the bins as a table.
    pub fn table(&self) -> Result<String, fmt::Error> {
        let Calibration { setup, fold, tasks, seed, random, candidates, .. } = self;
        let mut text = format!("{setup}-{fold}, {tasks} test tasks, seed {seed}\n");
        writeln!(text, "{:>14}  {:^25}  {:^25}", "chance", "random balls", "the model's candidates")?;
        for (index, (random, candidates)) in random.iter().zip(candidates).enumerate() {
            let bin = format!("{} to {} %", 100 * index / BINS, 100 * (index + 1) / BINS);
            writeln!(text, "{bin:>14}  {}  {}", random.words(), candidates.words())?;
        }
        Ok(text)
    }
}

impl Bin {
    /// Formats the bin as a cell of the table.
    fn words(self) -> String {
        let share = match self.balls {
            0 => "-".to_string(),
            balls => format!("{:.1} % solve", 100.0 * f64::from(self.solved) / f64::from(balls)),
        };
        format!("{:>6} balls {share:>13}", self.balls)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bin_holds_its_balls_their_mean_chance_and_how_many_solve() {
        let bins = bins([(0.1, false), (0.19, true), (1.0, true), (0.0, false)].iter());
        let of = |bin: usize| (bins[bin].balls, bins[bin].chance, bins[bin].solved);
        assert_eq!((of(0), of(1), of(9)), ((1, 0.0, 0), (2, 0.145, 1), (1, 1.0, 1)));
        assert_eq!(bins.iter().map(|bin| bin.balls).sum::<u32>(), 4);
    }
}

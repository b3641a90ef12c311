//! What the results cost, and what more would: `costs.md` beside the report. Apart from it, because times differ from
//! run to run, and the report does not.

use std::fmt::Write as _;
use std::path::Path;
use std::time::Instant;

use pathlight::benchmark::folds::{FOLDS, Setup};
use pathlight::puzzle::task::Task;
use pathlight::puzzle::templates::TEMPLATES;
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::fold_result::{FoldResult, Hyperparameters};
use super::report::of;
use crate::data::collect::read_solutions;
use crate::data::label::BALLS;
use crate::data::labels::{Sampled, sample, try_balls};
use crate::data::scene_id::SceneId;
use crate::data::solutions::Solution;
use crate::files::replace_file::replace_file;

/// The factor by which the estimate increases the number of labels.
const MORE_LABELS: f64 = 10.0;

/// Cores that the estimate is for.
const CORES: [usize; 3] = [1, 20, 200];

/// A fold's costs, core-minutes.
struct FoldCost {
    nets: f64,
    success: f64,
    dynamics: f64,
    dqn: f64,
    evaluation: f64,
}

impl FoldCost {
    /// Returns the cost of the whole fold, core-minutes. The nets that learn from labels train `times` as long.
    fn all(&self, times: f64) -> f64 {
        self.nets + times * (self.success + self.dynamics + self.dqn) + self.evaluation
    }
}

/// Writes the costs to a folder.
///
/// # Errors
/// If the solutions cannot be read, or the folder cannot be written.
pub fn write(results: &[FoldResult], solutions: &Path, folder: &Path) -> anyhow::Result<()> {
    let per_ball = seconds_per_ball(&read_solutions(solutions)?.solutions)?;
    let mut text = String::from(
        "# Costs\n\n`pathlight-lab reproduce` wrote this beside the report. Times are wall-clock times multiplied by \
         the number of threads.\n\n",
    );
    folds(&mut text, results)?;
    estimate(&mut text, results, per_ball)?;
    let path = folder.join("costs.md");
    replace_file(&path, text.as_bytes())
}

fn cost(result: &FoldResult) -> FoldCost {
    let minutes = |seconds: f64| seconds * result.threads as f64 / 60.0;
    FoldCost {
        nets: minutes(result.nets.seconds),
        success: minutes(result.success.seconds),
        dynamics: minutes(result.dynamics.seconds),
        dqn: minutes(result.dqn.seconds),
        evaluation: minutes(result.evaluation_seconds),
    }
}

fn folds(text: &mut String, results: &[FoldResult]) -> anyhow::Result<()> {
    writeln!(text, "## Each fold, core-minutes\n")?;
    writeln!(
        text,
        "| setup | fold | threads | four nets | success net | dynamics net | DQN | evaluation | all |\n|{}",
        " ---: |".repeat(9)
    )?;
    for result in results {
        let cost @ FoldCost { nets, success, dynamics, dqn, evaluation } = cost(result);
        let (setup, fold, threads, all) = (result.report.setup, result.report.fold, result.threads, cost.all(1.0));
        writeln!(
            text,
            "| {setup} | {fold} | {threads} | {nets:.1} | {success:.1} | {dynamics:.1} | {dqn:.1} | {evaluation:.1} | \
             {all:.1} |"
        )?;
    }
    Ok(())
}

/// Estimates all folds with that many labels. Each ball is seen as often as before, so the nets that learn from labels
/// train longer by the same factor.
fn estimate(text: &mut String, results: &[FoldResult], seconds_per_ball: f64) -> anyhow::Result<()> {
    let Some(first) = results.first() else { return Ok(()) };
    let tasks: usize = TEMPLATES.iter().map(|&template| Task::of(template).count()).sum();
    let Hyperparameters { label_rounds, variant_rounds, .. } = first.hyperparameters;
    let balls = MORE_LABELS * (tasks * BALLS) as f64 * f64::from(label_rounds + variant_rounds);
    let label_hours = balls * seconds_per_ball / 3600.0;
    let of_setup =
        |setup: Setup| -> Vec<f64> { of(results, setup).map(|result| cost(result).all(MORE_LABELS) / 60.0).collect() };
    let setups: Vec<Vec<f64>> =
        [Setup::Within, Setup::Cross].map(of_setup).into_iter().filter(|of| !of.is_empty()).collect();
    let count = setups.len() * usize::from(FOLDS);
    let longest = setups.iter().flatten().copied().fold(0.0, f64::max);
    // The mean of a setup stands for its folds that were not made.
    let means = setups.iter().map(|of| of.iter().sum::<f64>() / of.len() as f64);
    let all = means.sum::<f64>() * f64::from(FOLDS);
    writeln!(
        text,
        "\n## {count} folds at {MORE_LABELS} times the labels, estimated\n\n\
         {balls:.2e} balls to label, at {:.2} ms each on one core (measured on {} balls when this was written). The \
         success net, dynamics net and DQN are trained {MORE_LABELS} times as long; four nets and evaluation stay. A fold is one job \
         on one core; the labels are made by at most {} jobs, one for each template.\n",
        1e3 * seconds_per_ball,
        TEMPLATES.len() * BALLS,
        TEMPLATES.len(),
    )?;
    writeln!(text, "| cores | labels, h | folds, h | all, h | most of it |\n| ---: | ---: | ---: | ---: | --- |")?;
    for cores in CORES {
        let labels = label_hours / cores.min(TEMPLATES.len()) as f64;
        // No schedule is shorter than the mean load of a core, or than the longest job.
        let folds = longest.max(all / cores as f64);
        let most = match (labels > folds, folds > longest) {
            (true, _) => "labels",
            (false, true) => "training",
            (false, false) => "the training of one fold, which further cores do not shorten",
        };
        writeln!(text, "| {cores} | {labels:.2} | {folds:.2} | {:.2} | {most} |", labels + folds)?;
    }
    Ok(())
}

/// How long a ball takes to label, on one core: a round of the first task of each template.
fn seconds_per_ball(solutions: &[Solution]) -> anyhow::Result<f64> {
    let started = Instant::now();
    for template in TEMPLATES {
        let Some(task) = Task::of(template).next() else { continue };
        let own: Vec<Solution> = solutions.iter().filter(|solution| solution.task == task.id).copied().collect();
        let balls: Vec<Sampled> = own.iter().map(|solution| (solution.ball, None)).collect();
        let mut rng = Pcg64Mcg::seed_from_u64(task.id.seed(0));
        try_balls(&task.scene, sample((SceneId::Task(task.id), &task.scene), &balls, &own, BALLS, &mut rng));
    }
    Ok(started.elapsed().as_secs_f64() / (TEMPLATES.len() * BALLS) as f64)
}

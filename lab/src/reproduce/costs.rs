//! What the results cost, and what more would: `costs.md` beside the report. Apart from it, because times differ from
//! run to run, and the report does not.

use std::fmt::{self, Write as _};
use std::path::Path;
use std::time::Instant;

use pathlight::benchmark::folds::{FOLDS, Setup};
use pathlight::puzzle::task::Task;
use pathlight::puzzle::templates::TEMPLATES;
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::fold_result::FoldResult;
use super::report::of;
use crate::data::label::BALLS;
use crate::data::labels::{sample, try_balls};
use crate::data::scene_id::SceneId;
use crate::files::replace_file::replace_file;

/// The factor by which the estimate increases the number of labels.
const MORE_LABELS: f64 = 10.0;

/// Cores that the estimate is for.
const CORES: [usize; 3] = [1, 20, 200];

/// What a fold of a setup costs, core-minutes: medians over its folds.
struct FoldCost {
    setup: Setup,
    /// Folds that were made.
    folds: usize,
    success: f64,
    dynamics: f64,
    dqn: f64,
    evaluation: f64,
}

impl FoldCost {
    /// Returns the costs of the setups that have results.
    fn of(results: &[FoldResult]) -> Vec<FoldCost> {
        let of_setup = |setup| {
            let median = |seconds: &dyn Fn(&FoldResult) -> Option<f64>| {
                let minutes = |result| Some(seconds(result)? * result.threads as f64 / 60.0);
                median(of(results, setup).filter_map(minutes).collect())
            };
            FoldCost {
                setup,
                folds: of(results, setup).count(),
                success: median(&|result| Some(result.success.seconds)),
                dynamics: median(&|result| Some(result.dynamics.seconds)),
                dqn: median(&|result| Some(result.dqn.seconds)),
                evaluation: median(&|result| result.evaluation_seconds),
            }
        };
        [Setup::Within, Setup::Cross].map(of_setup).into_iter().filter(|cost| cost.folds > 0).collect()
    }

    /// Returns the cost of the whole fold, core-minutes. The nets that learn from labels train `times` as long.
    fn all(&self, times: f64) -> f64 {
        times * (self.success + self.dynamics + self.dqn) + self.evaluation
    }
}

/// Writes the costs to a folder.
///
/// # Errors
/// If the folder cannot be written.
pub fn write(results: &[FoldResult], folder: &Path) -> anyhow::Result<()> {
    let Some(FoldResult { hyperparameters, .. }) = results.first() else { return Ok(()) };
    let costs = FoldCost::of(results);
    let mut text = String::from(
        "# Costs\n\n`pathlight-lab reproduce` wrote this beside the report. Times are wall-clock times multiplied by \
         the number of threads. An epoch of the four nets, which every weights file holds and no agent here uses, is \
         not counted.\n\n",
    );
    table(&mut text, &costs)?;
    estimate(&mut text, &costs, hyperparameters.label_rounds, seconds_per_ball())?;
    replace_file(&folder.join("costs.md"), text.as_bytes())
}

fn table(text: &mut String, costs: &[FoldCost]) -> fmt::Result {
    writeln!(
        text,
        "## A fold, core-minutes\n\nMedians over the folds, as the clock also runs while a run is paused. Folds \
         without a time of evaluation are left out of that column.\n\n\
         | setup | folds | success net | dynamics net | DQN | evaluation | all |\n| --- |{}",
        " ---: |".repeat(6)
    )?;
    for cost @ FoldCost { setup, folds, success, dynamics, dqn, evaluation } in costs {
        writeln!(
            text,
            "| {setup} | {folds} | {success:.1} | {dynamics:.1} | {dqn:.1} | {evaluation:.1} | {:.1} |",
            cost.all(1.0)
        )?;
    }
    Ok(())
}

/// Estimates all folds with that many labels. Each ball is seen as often as before, so the nets that learn from labels
/// train longer by the same factor.
fn estimate(text: &mut String, costs: &[FoldCost], label_rounds: u16, seconds_per_ball: f64) -> fmt::Result {
    let tasks: usize = TEMPLATES.iter().map(|&template| Task::of(template).count()).sum();
    let balls = MORE_LABELS * (tasks * BALLS) as f64 * f64::from(label_rounds);
    let label_hours = balls * seconds_per_ball / 3600.0;
    let hours = costs.iter().map(|cost| cost.all(MORE_LABELS) / 60.0);
    let count = costs.len() * usize::from(FOLDS);
    let longest = hours.clone().fold(0.0, f64::max);
    let all = hours.sum::<f64>() * f64::from(FOLDS);
    writeln!(
        text,
        "\n## {count} folds at {MORE_LABELS} times the labels, estimated\n\n\
         {balls:.2e} balls to label, at {:.2} ms each on one core (measured on {} uniform balls when this was \
         written). The success net, dynamics net and DQN are trained {MORE_LABELS} times as long; evaluation \
         stays. A fold is one job on one core; the labels are made by at most {} jobs, one for each \
         template.\n",
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

/// Returns the median; NaN if there are no numbers.
fn median(mut numbers: Vec<f64>) -> f64 {
    numbers.sort_by(f64::total_cmp);
    let middle = numbers.len() / 2;
    match numbers.len() {
        0 => f64::NAN,
        len if len % 2 == 0 => (numbers[middle - 1] + numbers[middle]) / 2.0,
        _ => numbers[middle],
    }
}

/// How long a ball takes to label, on one core, s: a round of uniform balls in the first task of each template.
fn seconds_per_ball() -> f64 {
    let started = Instant::now();
    for task in TEMPLATES.into_iter().filter_map(|template| Task::of(template).next()) {
        let mut rng = Pcg64Mcg::seed_from_u64(task.id.seed(0));
        try_balls(&task.scene, sample((SceneId::Task(task.id), &task.scene), &[], &[], BALLS, &mut rng));
    }
    started.elapsed().as_secs_f64() / (TEMPLATES.len() * BALLS) as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_in_the_middle() {
        assert!(median(vec![]).is_nan());
        assert_eq!(median(vec![9.0, 1.0, 2.0]), 2.0);
        assert_eq!(median(vec![9.0, 1.0, 2.0, 4.0]), 3.0);
    }
}

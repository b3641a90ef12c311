//! The report on the existing results: `README.md` beside them.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;
use std::{fs, io};

use anyhow::Context;
use pathlight::benchmark::auccess::MAX_ATTEMPTS;
use pathlight::benchmark::folds::{FOLDS, Setup};
use pathlight::dataset::solutions::MIN_DISTANCE;
use pathlight::puzzle::task::{TaskId, ids};
use pathlight::puzzle::templates::TEMPLATES;

use super::fold_result::FoldResult;
use super::{dqn_report as dqn, plot};
use crate::commands::agent_name::AgentName;
use crate::commands::collect::{Collected, read_solutions};
use crate::commands::label::BALLS;
use crate::commands::training_run::Checkpoint;

/// Our agents, the best first, and their names in the report.
pub const AGENTS: [(AgentName, &str); 4] = [
    (AgentName::Judge, "with the judge"),
    (AgentName::Dqn, "DQN, smaller"),
    (AgentName::Paper, "the paper's four nets"),
    (AgentName::Random, "random"),
];

/// Published auccess, mean over the ten folds, within and cross, on PHYRE's own engine: Harter et al. (2020), Table 1,
/// for their nets and for DQN; the benchmark (PHYRE 0.2.2) for the random agent.
pub const REPORTED: [(&str, [&str; 2]); 3] =
    [("DQN", ["77", "37"]), ("the paper's nets", ["62", "31"]), ("random", ["13.7", "13.0"])];

/// Writes the report and its plot to a folder, and prints the report.
///
/// # Errors
/// If the solutions cannot be read, or the folder cannot be written.
pub fn write(results: &[FoldResult], solutions: &Path, folder: &Path) -> anyhow::Result<()> {
    let name = "templates.svg";
    plot::draw(results, &folder.join(name))?;
    let mut text = String::new();
    head(&mut text, results)?;
    table(&mut text, results)?;
    writeln!(text, "\n![Auccess of each template, mean over the folds that test it]({name})\n")?;
    folds(&mut text, results)?;
    training(&mut text, results)?;
    dqn::training(&mut text, results)?;
    data(&mut text, results, solutions)?;
    text.push_str(REPRODUCING);
    let path = folder.join("README.md");
    fs::write(&path, &text).with_context(|| format!("cannot write {}", path.display()))?;
    io::stdout().write_all(text.as_bytes())?;
    Ok(())
}

fn head(text: &mut String, results: &[FoldResult]) -> anyhow::Result<()> {
    let Some(FoldResult { hyperparameters, report, .. }) = results.first() else { return Ok(()) };
    writeln!(
        text,
        "# Results\n\n\
         `pathlight reproduce` printed this from the files beside it, one per setup and fold; {} of {} exist. Seed {}, \
         simulator {}, agents {}, at most {} test tasks per template.\n\n\
         Auccess is measured with at most {MAX_ATTEMPTS} attempts per task, and only these attempts are simulated. Nets \
         learn only from rollouts on training tasks; but in the setup within, the search for solutions and the balls for \
         the judge also start from known solutions of test tasks of the same template. The four nets are those of Harter \
         et al. (2020), trained jointly, with balls from their placement map. The judge is a fifth net, not the \
         paper's, which orders the balls. DQN is the benchmark's baseline (Bakhtin et al. 2019), made smaller.\n",
        results.len(),
        2 * FOLDS,
        hyperparameters.seed,
        report.simulator,
        report.agents_version,
        hyperparameters.limit,
    )?;
    Ok(())
}

/// The paper's table, with our results beside it.
fn table(text: &mut String, results: &[FoldResult]) -> anyhow::Result<()> {
    writeln!(text, "## Auccess, mean over folds ± standard deviation\n")?;
    writeln!(text, "| agent | engine | within | cross |\n| --- | --- | ---: | ---: |")?;
    for (agent, name) in AGENTS {
        let cells = [Setup::Within, Setup::Cross].map(|setup| {
            let scores = of(results, setup).filter_map(|result| result.score(agent)).map(|[auccess, ..]| auccess);
            mean_and_deviation(&scores.collect::<Vec<_>>())
        });
        writeln!(text, "| **{name}** | ours | {} | {} |", cells[0], cells[1])?;
    }
    for (name, [within, cross]) in REPORTED {
        writeln!(text, "| {name} | PHYRE's | {within} | {cross} |")?;
    }
    let folds = [Setup::Within, Setup::Cross].map(|setup| numbers(setup, &mut of(results, setup)));
    let of_dqn = [Setup::Within, Setup::Cross]
        .map(|setup| numbers(setup, &mut of(results, setup).filter(|result| result.dqn.is_some())));
    writeln!(
        text,
        "\nOur folds: {}; of DQN: {}. The published means are over all ten: the paper's nets and DQN by Harter et al. (2020), \
         random by the benchmark.",
        folds.join("; "),
        of_dqn.join("; ")
    )?;
    Ok(())
}

/// Names the folds of some results of a setup.
fn numbers(setup: Setup, results: &mut dyn Iterator<Item = &FoldResult>) -> String {
    let numbers: Vec<String> = results.map(|result| result.report.fold.to_string()).collect();
    format!("{setup} {}", if numbers.is_empty() { "none".to_string() } else { numbers.join(", ") })
}

fn folds(text: &mut String, results: &[FoldResult]) -> anyhow::Result<()> {
    writeln!(
        text,
        "## Each fold\n\nAuccess, and the percentage solved at the first attempt / within 10 / within 100.\n"
    )?;
    let names = AGENTS.map(|(_, name)| name).join(" | ");
    writeln!(text, "| setup | fold | test tasks | {names} |\n| --- |{}", " ---: |".repeat(2 + AGENTS.len()))?;
    for result in results {
        let cells = AGENTS.map(|(agent, _)| {
            result.score(agent).map_or("–".to_string(), |[auccess, one, ten, hundred]| {
                format!("**{auccess:.1}** {one:.0} / {ten:.0} / {hundred:.0} %")
            })
        });
        let tasks = result.first_solved(AgentName::Random, None).len();
        writeln!(text, "| {} | {} | {tasks} | {} |", result.report.setup, result.report.fold, cells.join(" | "))?;
    }
    Ok(())
}

fn training(text: &mut String, results: &[FoldResult]) -> anyhow::Result<()> {
    writeln!(
        text,
        "\n## Training\n\nLearning rates are peak values. The nets' rate is constant, then decays linearly to zero over \
         the decay epochs; the judge's warms up, then decays linearly to zero. A loss is the mean over the last \
         batches. `costs.md` has the times.\n"
    )?;
    writeln!(
        text,
        "| setup | fold | solutions (tasks) | epochs x batch | learning rate | decay epochs | placement loss | balls | \
         judge: epochs x batch x balls | learning rate | loss | weights, MB |\n|{}",
        " ---: |".repeat(12)
    )?;
    for FoldResult { report, nets, judge, weights, .. } in results {
        let Some(judge_card) = &judge.card.judge else { continue };
        let card = &nets.card;
        let last =
            |run: &Checkpoint| run.log.last().and_then(|(_, _, losses)| losses.last().copied()).unwrap_or(f32::NAN);
        writeln!(
            text,
            "| {} | {} | {} ({}) | {} x {} | {} | {} | {:.4} | {} | {} x {} x {} | {} | {:.4} | {:.2} |",
            report.setup,
            report.fold,
            card.samples,
            card.tasks,
            card.epochs,
            card.batch,
            card.learning_rate,
            card.decay_epochs,
            last(nets),
            judge_card.balls,
            judge_card.epochs,
            judge_card.batch,
            judge_card.balls_per_scene,
            judge_card.learning_rate,
            last(judge),
            *weights as f64 / 1e6,
        )?;
    }
    Ok(())
}

/// How many solutions of the tasks are known, and the files that the results were made from.
fn data(text: &mut String, results: &[FoldResult], path: &Path) -> anyhow::Result<()> {
    let mut known: BTreeMap<TaskId, usize> = TEMPLATES.iter().flat_map(|&one| ids(one)).map(|id| (id, 0)).collect();
    let Collected { solutions, rollouts, .. } = read_solutions(path)?;
    for solution in &solutions {
        *known.entry(solution.task).or_default() += 1;
    }
    let most = known.values().max().copied().unwrap_or_default();
    let count = |of: &dyn Fn(usize) -> bool| known.values().filter(|&&count| of(count)).count();
    writeln!(
        text,
        "\n## Data\n\n{} solutions of {} tasks, found in {rollouts} rollouts. {} tasks have {most}, {} have fewer, {} \
         have none. Solutions of a task differ by at least {MIN_DISTANCE} px in x, y or radius; fewer are known \
         where few balls solve the task. Tasks without a known solution still count in auccess.\n",
        solutions.len(),
        known.len(),
        count(&|count| count == most),
        count(&|count| count < most),
        count(&|count| count == 0),
    )?;
    writeln!(text, "| template | tasks with fewer | solutions | without any |\n| --- | ---: | ---: | --- |")?;
    for template in TEMPLATES {
        let of_template: Vec<(TaskId, usize)> = ids(template).map(|id| (id, known[&id])).collect();
        let fewer = of_template.iter().filter(|(_, count)| *count < most).count();
        let total: usize = of_template.iter().map(|(_, count)| count).sum();
        let none: Vec<String> =
            of_template.iter().filter(|(_, count)| *count == 0).map(|(id, _)| id.to_string()).collect();
        if fewer > 0 {
            writeln!(text, "| {:05} {} | {fewer} | {total} | {} |", template.number, template.name, none.join(", "))?;
        }
    }
    let Some(FoldResult { hyperparameters, nets, judge, .. }) = results.first() else { return Ok(()) };
    writeln!(
        text,
        "\nBalls were labelled in {} rounds, {BALLS} per task and round. SHA-256 of the file of solutions: `{}`, of \
         the file of balls: `{}`.",
        hyperparameters.label_rounds, nets.data, judge.data
    )?;
    Ok(())
}

const REPRODUCING: &str = "
## Reproducing

Run `make build` first. Each command continues where it was interrupted; settings other than the defaults (`--help`)
need other folders.

```
pathlight reproduce                             # data, all twenty folds, DQN, report
pathlight reproduce --setup within --fold 3     # data if missing, one fold, its DQN, report
pathlight reproduce --only report               # this file and the plot
```

Folds only read the two shared data files, so up to twenty processes can run in parallel, on all machines that share
the folder. `scripts/cluster/submit FOLDER` submits the whole chain to Slurm, from the search for solutions to the report, as
arrays of jobs that each wait for the one before. `costs.md` says what that takes.
";

/// The results of a setup.
pub fn of(results: &[FoldResult], setup: Setup) -> impl Iterator<Item = &FoldResult> {
    results.iter().filter(move |result| result.report.setup == setup)
}

/// Formats the mean, and the sample standard deviation if there are several numbers.
fn mean_and_deviation(numbers: &[f64]) -> String {
    let count = numbers.len() as f64;
    let mean = numbers.iter().sum::<f64>() / count;
    match numbers.len() {
        0 => "–".to_string(),
        1 => format!("{mean:.1}"),
        _ => {
            let variance = numbers.iter().map(|number| (number - mean).powi(2)).sum::<f64>() / (count - 1.0);
            format!("{mean:.1} ± {:.1}", variance.sqrt())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn means_are_printed_with_their_deviation() {
        assert_eq!(mean_and_deviation(&[]), "–");
        assert_eq!(mean_and_deviation(&[50.0]), "50.0");
        assert_eq!(mean_and_deviation(&[1.0, 3.0]), "2.0 ± 1.4");
    }
}

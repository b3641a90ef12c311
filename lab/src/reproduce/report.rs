//! The report on the existing results: `README.md` beside them.

use std::fmt::Write as _;
use std::path::Path;

use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::auccess::MAX_ATTEMPTS;
use pathlight::benchmark::folds::{FOLDS, Setup};

use super::compared::{
    AgentMean, Published, REPORTED, listed, mean_and_deviation, on_folds, online_with_other_data, our_means,
};
use super::fold_result::{FoldResult, Hyperparameters};
use super::training_report;
use crate::data::label::BALLS;
use crate::files::replace_file::replace_file;
use crate::measure::agents::row;
use crate::measure::report::score_cell;

/// An agent, one that lacks a part of it, and the part.
const ABLATIONS: [(AgentName, AgentName, &str); 3] = [
    (AgentName::Dynamics, AgentName::Success, "it imagines what a ball leads to"),
    (AgentName::Online, AgentName::Dynamics, "it is told how each attempt ended"),
    (AgentName::Online, AgentName::OnlineByBalls, "balls are compared by imagined paths too"),
];

/// What the online agent is called if its net learned from other data than those of the main results.
const OTHER_DATA: &str = "online, with proposed balls or random scenes";

/// Writes the report to a folder, and returns it.
///
/// # Errors
/// If the results with other data are damaged, or the folder cannot be written.
pub fn write(results: &[FoldResult], folder: &Path) -> anyhow::Result<String> {
    let mut text = String::new();
    let other_data = online_with_other_data(folder)?;
    head(&mut text, results, &other_data, folder)?;
    table(&mut text, results, &other_data, folder)?;
    ablations(&mut text, results)?;
    folds(&mut text, results)?;
    training_report::write(&mut text, results)?;
    data(&mut text, results)?;
    reproducing(&mut text, results)?;
    let path = folder.join("README.md");
    replace_file(&path, text.as_bytes())?;
    Ok(text)
}

fn head(
    text: &mut String,
    results: &[FoldResult],
    other_data: &[Option<String>; 2],
    folder: &Path,
) -> anyhow::Result<()> {
    let Some(FoldResult { hyperparameters, report, .. }) = results.first() else { return Ok(()) };
    writeln!(
        text,
        "# Results\n\n\
         `pathlight-lab reproduce` printed this from the files beside it, one per setup and fold, and from those in \
         `paper/`, `proposed-balls/` and `random-scenes/`, if they exist. Of the first, {} of {} exist. Seed \
         {}, simulator {}, agents {}, at most {} test tasks per template.\n\n\
         Auccess is measured with at most {MAX_ATTEMPTS} attempts per task, and only these attempts are simulated. \
         The nets here learn only from rollouts in training tasks, and from none whose ball was sampled around a \
         solution of a test task.\n\n\
         - **online**: the dynamics net imagines candidates, and a Gaussian process learns from each attempt, by the \
         similarity of imagined paths and of balls; **by balls**: by that of balls alone.\n\
         - **dynamics**: the same candidates in the order that the net gives them, as if each attempt ended as \
         imagined.\n\
         - **success net**: a net that sees only the scene ranks the balls. It is trained like the dynamics net.\n\
         - **DQN, smaller**: the benchmark's baseline (Bakhtin et al. 2019), made smaller.\n\
         - **the paper's four nets**: those of Harter et al. (2020), trained jointly, with balls from their placement \
         map{}.\n",
        results.len(),
        2 * FOLDS,
        hyperparameters.seed,
        report.simulator,
        report.agents_version,
        hyperparameters.limit,
        if folder.join("paper").exists() {
            ". [Their own table](paper/README.md) says how they were trained"
        } else {
            ""
        },
    )?;
    if other_data.iter().any(Option::is_some) {
        writeln!(
            text,
            "**{OTHER_DATA}**: within, its net also learned from [balls that a net \
             proposed](proposed-balls/README.md); in cross, it learned from [random scenes](random-scenes/README.md) \
             alone. It was trained longer than the nets below it.\n"
        )?;
    }
    Ok(())
}

/// The mean of each agent over the folds, and what was published.
fn table(
    text: &mut String,
    results: &[FoldResult],
    other_data: &[Option<String>; 2],
    folder: &Path,
) -> anyhow::Result<()> {
    writeln!(text, "## Auccess, mean over folds ± standard deviation\n")?;
    writeln!(text, "| agent | simulator | within | cross |\n| --- | --- | ---: | ---: |")?;
    if other_data.iter().any(Option::is_some) {
        let [within, cross] = other_data.each_ref().map(|auccess| auccess.as_deref().unwrap_or("–"));
        writeln!(text, "| **{OTHER_DATA}** | ours | {within} | {cross} |")?;
    }
    let listed = listed(folder)?;
    let plays_the_same_list = listed.is_some();
    for AgentMean { agent, auccess: [within, cross] } in our_means(results).into_iter().chain(listed) {
        writeln!(text, "| **{}** | ours | {within} | {cross} |", row(agent).label)?;
    }
    for (label, Published { auccess: [within, cross], .. }) in REPORTED {
        writeln!(text, "| {label} | PHYRE's | {within} | {cross} |")?;
    }
    let folds = [Setup::Within, Setup::Cross].map(|setup| numbers(setup, &mut of(results, setup)));
    writeln!(
        text,
        "\nOur folds: {}. The published means are over all ten: the paper's nets and DQN by Harter et al. (2020), \
         RAND, which plays one list of actions on all tasks, by the benchmark.{}",
        folds.join("; "),
        if plays_the_same_list {
            " Ours plays the same list: that it scores the same shows that scenes, valid balls, physics, folds and \
             metric are PHYRE's."
        } else {
            ""
        }
    )?;
    Ok(())
}

/// What each part of the agent brings, by paired differences: two agents meet the same tasks in a fold, so that their
/// difference varies less over the folds than their scores.
fn ablations(text: &mut String, results: &[FoldResult]) -> anyhow::Result<()> {
    writeln!(
        text,
        "\n## Ablations\n\nThe paired difference of two agents' auccess, which is that on the same fold: mean ± \
         standard deviation, and the folds on which it is positive.\n"
    )?;
    writeln!(
        text,
        "| paired difference | what the first has and the second lacks | within | cross |\n| --- | --- | ---: | ---: |"
    )?;
    for (agent, without, part) in ABLATIONS {
        let cells = [Setup::Within, Setup::Cross].map(|setup| {
            let score = |result: &FoldResult, agent| result.report.score(agent).map(|[auccess, ..]| auccess);
            let of_fold = |result| Some(score(result, agent)? - score(result, without)?);
            let differences: Vec<f64> = of(results, setup).filter_map(of_fold).collect();
            let positive = differences.iter().filter(|&&difference| difference > 0.0).count();
            format!("{}, {positive} of {}", mean_and_deviation(&differences), differences.len())
        });
        writeln!(text, "| {} – {} | {part} | {} | {} |", row(agent).label, row(without).label, cells[0], cells[1])?;
    }
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
        "\n## Each fold\n\nAuccess, and the percentage solved at the first attempt / within 10 / within 100.\n"
    )?;
    let names: Vec<&str> = on_folds().map(|agent| agent.label).collect();
    let columns = " ---: |".repeat(2 + names.len());
    writeln!(text, "| setup | fold | test tasks | {} |\n| --- |{columns}", names.join(" | "))?;
    for result in results {
        let cells = on_folds().map(|agent| result.report.score(agent.agent).map_or("–".to_string(), score_cell));
        let cells: Vec<String> = cells.collect();
        let tasks = result.report.first_solved(AgentName::Random, None).len();
        writeln!(text, "| {} | {} | {tasks} | {} |", result.report.setup, result.report.fold, cells.join(" | "))?;
    }
    Ok(())
}

/// How many solutions of the tasks are known, and the files that the results were made from.
fn data(text: &mut String, results: &[FoldResult]) -> anyhow::Result<()> {
    let Some(FoldResult { hyperparameters, solutions, dynamics, .. }) = results.first() else { return Ok(()) };
    writeln!(
        text,
        "\n## Data\n\nBalls were labelled in {} rounds, {BALLS} per task and round, half of them around known \
         solutions. SHA-256 of the file of solutions: `{}`, of the file of balls: `{}`.",
        hyperparameters.label_rounds, solutions, dynamics.data,
    )?;
    Ok(())
}

fn reproducing(text: &mut String, results: &[FoldResult]) -> anyhow::Result<()> {
    let mut command = "pathlight-lab reproduce".to_string();
    if let Some(FoldResult { hyperparameters, .. }) = results.first() {
        let [used, default] = [hyperparameters, &Hyperparameters::default()].map(serde_json::to_value);
        let default = default?;
        for (key, value) in used?.as_object().into_iter().flatten().filter(|(key, value)| default[*key] != **value) {
            write!(command, " --{} {value}", key.replace('_', "-"))?;
        }
    }
    write!(
        text,
        "
## Reproducing

Run `make build` first. Each command continues where it was interrupted; settings other than the defaults (`--help`)
need other folders (`--results`, `--train-dir`).

```
{command}                             # data, all twenty folds, report
{command} --setup within --fold 3     # data if missing, one fold, report
{command} --only report               # this file and costs.md
```

Folds only read the shared data files, so up to twenty processes can run in parallel, on all machines that share
the folder. `scripts/cluster/submit FOLDER` submits the whole chain to Slurm, from the search for solutions to the
report, as arrays of jobs that each wait for the one before. `costs.md` says what that takes.
"
    )?;
    Ok(())
}

/// The results of a setup.
pub fn of(results: &[FoldResult], setup: Setup) -> impl Iterator<Item = &FoldResult> {
    results.iter().filter(move |result| result.report.setup == setup)
}

//! The report on the rows that there are: `README.md` beside them.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::Write as _;
use std::path::Path;
use std::{fs, io};

use anyhow::Context;
use pathlight::benchmark::folds::{FOLDS, Setup};
use pathlight::dataset::solutions::MIN_DISTANCE;
use pathlight::puzzle::task::{TaskId, ids};
use pathlight::puzzle::templates::TEMPLATES;

use super::picture;
use super::row::Row;
use crate::commands::collect::{Collected, read_solutions};
use crate::commands::evaluate::Agent;
use crate::commands::label::BALLS;
use crate::commands::training_run::State;

/// Our agents, the best first, and what the report calls them.
pub const AGENTS: [(Agent, &str); 3] =
    [(Agent::Judge, "with the judge"), (Agent::Paper, "the paper's four nets"), (Agent::Random, "random")];

/// Auccess that others report over the ten folds, within and across templates, on PHYRE's own engine: Harter et al.
/// (2020), Table 1, for their nets and for DQN; the benchmark (PHYRE 0.2.2) for the random agent.
const REPORTED: [(&str, [&str; 2]); 3] =
    [("DQN", ["77", "37"]), ("the paper's nets", ["62", "31"]), ("random", ["13.7", "13.0"])];

/// Writes the report and its picture into a folder, and prints the report.
///
/// # Errors
/// If the solutions cannot be read, or the folder not written.
pub fn write(rows: &[Row], solutions: &Path, folder: &Path) -> anyhow::Result<()> {
    let name = "templates.svg";
    picture::draw(rows, &folder.join(name))?;
    let mut text = String::new();
    head(&mut text, rows)?;
    table(&mut text, rows)?;
    writeln!(text, "\n![Auccess of each template, mean over the folds that test it]({name})\n")?;
    folds(&mut text, rows)?;
    training(&mut text, rows)?;
    data(&mut text, rows, solutions)?;
    text.push_str(AGAIN);
    let path = folder.join("README.md");
    fs::write(&path, &text).with_context(|| format!("cannot write {}", path.display()))?;
    io::stdout().write_all(text.as_bytes())?;
    Ok(())
}

fn head(text: &mut String, rows: &[Row]) -> anyhow::Result<()> {
    let Some(Row { recipe, report, .. }) = rows.first() else { return Ok(()) };
    writeln!(
        text,
        "# Results\n\n\
         `pathlight table` has printed this from the files beside it, one for each setup and fold; {} of {} are there. \
         Seed {}, simulator {}, at most {} test tasks of a template.\n\n\
         Auccess is measured with at most 100 attempts at a task, and with no call of the simulator but for these; \
         trained is on training tasks alone. The four nets are those of Harter et al. (2020), trained jointly, balls \
         from their placement map. The judge is a fifth net, not the paper's, which orders the balls.\n",
        rows.len(),
        2 * FOLDS,
        recipe.seed,
        report.simulator,
        recipe.limit,
    )?;
    Ok(())
}

/// The paper's table, with ours beside it.
fn table(text: &mut String, rows: &[Row]) -> anyhow::Result<()> {
    writeln!(text, "## Auccess, mean over folds ± standard deviation\n")?;
    writeln!(text, "| agent | engine | within | cross |\n| --- | --- | ---: | ---: |")?;
    for (agent, name) in AGENTS {
        let cells = [Setup::Within, Setup::Cross].map(|setup| {
            let scores: Vec<f64> = of(rows, setup).map(|row| row.score(agent)[0]).collect();
            mean_and_deviation(&scores)
        });
        writeln!(text, "| **{name}** | ours | {} | {} |", cells[0], cells[1])?;
    }
    for (name, [within, cross]) in REPORTED {
        writeln!(text, "| {name} | PHYRE's | {within} | {cross} |")?;
    }
    let folds = [Setup::Within, Setup::Cross].map(|setup| {
        let numbers: Vec<String> = of(rows, setup).map(|row| row.report.fold.to_string()).collect();
        format!("{setup} {}", if numbers.is_empty() { "none".to_string() } else { numbers.join(", ") })
    });
    writeln!(
        text,
        "\nOur folds: {}. The others are reported over all ten: the paper's nets and DQN by Harter et al. (2020), \
         random by the benchmark.",
        folds.join("; ")
    )?;
    Ok(())
}

fn folds(text: &mut String, rows: &[Row]) -> anyhow::Result<()> {
    writeln!(text, "## Each fold\n\nAuccess, and the shares solved at the first attempt / within 10 / within 100.\n")?;
    let names = AGENTS.map(|(_, name)| name).join(" | ");
    writeln!(text, "| setup | fold | test tasks | {names} |\n| --- | ---: | ---: | ---: | ---: | ---: |")?;
    for row in rows {
        let cells = AGENTS.map(|(agent, _)| {
            let [auccess, one, ten, hundred] = row.score(agent);
            format!("**{auccess:.1}** {one:.0} / {ten:.0} / {hundred:.0} %")
        });
        let tasks = row.first_solved(Agent::Random, None).len();
        writeln!(text, "| {} | {} | {tasks} | {} |", row.report.setup, row.report.fold, cells.join(" | "))?;
    }
    Ok(())
}

fn training(text: &mut String, rows: &[Row]) -> anyhow::Result<()> {
    let course = match rows.first().map_or(0, |row| row.nets.card.decay_epochs) {
        0 => "is the same all the time".to_string(),
        1 => "falls to nothing in the last epoch".to_string(),
        epochs => format!("falls to nothing in the last {epochs} epochs"),
    };
    writeln!(
        text,
        "\n## Training\n\nRates are the highest: that of the four nets {course}, that of the judge from early on to the \
         end. A loss is the mean of the last batches; times are wall-clock.\n"
    )?;
    writeln!(
        text,
        "| setup | fold | solutions (tasks) | epochs x batch | rate | placement loss | min | balls | judge: epochs x \
         batch x balls | rate | loss | min | weights, MB | evaluation, s |\n|{}",
        " ---: |".repeat(14)
    )?;
    for Row { report, nets, judge, weights, evaluation_seconds, .. } in rows {
        let Some(judged) = &judge.card.judge else { continue };
        let card = &nets.card;
        let last = |run: &State| run.log.last().and_then(|(_, _, losses)| losses.last().copied()).unwrap_or(f32::NAN);
        writeln!(
            text,
            "| {} | {} | {} ({}) | {} x {} | {} | {:.4} | {:.0} | {} | {} x {} x {} | {} | {:.4} | {:.0} | {:.2} | {:.0} |",
            report.setup,
            report.fold,
            card.samples,
            card.tasks,
            card.epochs,
            card.batch,
            card.learning_rate,
            last(nets),
            nets.seconds / 60.0,
            judged.balls,
            judged.epochs,
            judged.batch,
            judged.balls_per_scene,
            judged.learning_rate,
            last(judge),
            judge.seconds / 60.0,
            *weights as f64 / 1e6,
            evaluation_seconds,
        )?;
    }
    Ok(())
}

/// How many solutions are known of the tasks, and which files the rows were made from.
fn data(text: &mut String, rows: &[Row], path: &Path) -> anyhow::Result<()> {
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
         have none. Those of a task are at least {MIN_DISTANCE} px apart in x, y or radius; fewer are known where few balls \
         solve it. A task without a known solution stays in the count.\n",
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
    let Some(Row { recipe, nets, judge, .. }) = rows.first() else { return Ok(()) };
    writeln!(
        text,
        "\nBalls were labelled in {} rounds, {BALLS} of each task in a round. SHA-256 of the file of solutions: `{}`, of the \
         file of balls: `{}`.",
        recipe.label_rounds, nets.data, judge.data
    )?;
    Ok(())
}

const AGAIN: &str = "
## Again

`make build` first. Each command goes on where it was cut off; settings other than the defaults (`--help`) need
folders of their own.

```
pathlight table                             # data, all twenty rows, report
pathlight table --setup within --fold 3     # data if it is not there yet, one row, report
pathlight table --only report               # this file and the picture
```

Rows share nothing but the two files of data, which they read. So twenty processes can make them, on as many machines
as see the folder. `results/array.sh` is such a job, for Slurm's arrays or whatever sets `SLURM_ARRAY_TASK_ID`:

```
pathlight table --only data
sbatch --array=0-19 --cpus-per-task=2 results/array.sh
seq 0 19 | RAYON_NUM_THREADS=2 xargs -P 4 -I{} env SLURM_ARRAY_TASK_ID={} results/array.sh  # without a scheduler
pathlight table --only report
```
";

/// The rows of a setup.
pub fn of(rows: &[Row], setup: Setup) -> impl Iterator<Item = &Row> {
    rows.iter().filter(move |row| row.report.setup == setup)
}

/// The mean, and the sample standard deviation where there are several.
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
    fn means_stand_with_their_deviation() {
        assert_eq!(mean_and_deviation(&[]), "–");
        assert_eq!(mean_and_deviation(&[50.0]), "50.0");
        assert_eq!(mean_and_deviation(&[1.0, 3.0]), "2.0 ± 1.4");
    }
}

//! The report on the rows that there are: `README.md` beside them.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::Path;

use anyhow::Context;
use pathlight::folds::{FOLDS, Setup};
use pathlight::task::{TaskId, ids};
use pathlight::templates::TEMPLATES;

use super::picture;
use super::row::{Row, Training};
use crate::commands::collect::read_solutions;
use crate::commands::evaluate::Agent;

/// Our agents, the best first, and what the report calls them.
pub const AGENTS: [(Agent, &str); 3] =
    [(Agent::Judge, "with the judge"), (Agent::Paper, "the paper's recipe"), (Agent::Random, "random")];

/// Auccess that others report over the ten folds, within and across templates, on PHYRE's own engine: the random
/// agent and DQN of Bakhtin et al. (2019), the nets of Harter et al. (2020), Table 1.
const REPORTED: [(&str, [&str; 2]); 3] = [
    ("DQN (Bakhtin et al. 2019)", ["77", "37"]),
    ("the paper's nets (Harter et al. 2020)", ["62", "31"]),
    ("random (Bakhtin et al. 2019)", ["13.7", "13.0"]),
];

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
    print!("{text}");
    let path = folder.join("README.md");
    fs::write(&path, text).with_context(|| format!("cannot write {}", path.display()))
}

fn head(text: &mut String, rows: &[Row]) -> anyhow::Result<()> {
    let Some(Row { recipe, report, .. }) = rows.first() else { return Ok(()) };
    writeln!(
        text,
        "# Results\n\n\
         `pathlight table` has printed this from the files beside it, one for each setup and fold ({} of {} are there). \
         Seed {}, simulator {}. Auccess on the test tasks of the folds, at most 100 attempts a task; the simulator is \
         called for the counted attempts alone, and only training tasks are trained on. The paper's recipe is the \
         four nets, balls from the placement map; the judge is a net of ours that orders the balls.\n",
        rows.len(),
        2 * FOLDS,
        recipe.seed,
        report.simulator,
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
        format!("{setup} {}", numbers.join(", "))
    });
    writeln!(text, "\nOur folds: {}. The others report all ten.", folds.join("; "))?;
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
    writeln!(text, "\n## Training\n")?;
    writeln!(
        text,
        "The four nets: the paper's joint training, batches of 32. Times are wall-clock, on machines that did other \
         things too; losses are means of the last epoch.\n"
    )?;
    writeln!(
        text,
        "| setup | fold | solutions of tasks | epochs | rate | placement loss | min | balls | judge: epochs | rate \
         | loss | min | evaluation: s |\n| --- | {}",
        "---: | ".repeat(12).trim_end()
    )?;
    for Row { report, nets, judge, evaluation_seconds, .. } in rows {
        let Some(card) = &report.card else { continue };
        let Some(judged) = &card.judge else { continue };
        let last = |training: &Training| training.by_epoch.last().and_then(|losses| losses.last()).copied();
        writeln!(
            text,
            "| {} | {} | {} of {} | {} | {} | {:.4} | {:.0} | {} | {} | {} | {:.4} | {:.0} | {:.0} |",
            report.setup,
            report.fold,
            card.samples,
            card.tasks,
            card.epochs,
            card.rate,
            last(nets).unwrap_or(f64::NAN),
            nets.seconds / 60.0,
            judged.balls,
            judged.epochs,
            judged.rate,
            last(judge).unwrap_or(f64::NAN),
            judge.seconds / 60.0,
            evaluation_seconds,
        )?;
    }
    Ok(())
}

/// How many solutions are known of the tasks.
fn data(text: &mut String, rows: &[Row], solutions: &Path) -> anyhow::Result<()> {
    let mut known: BTreeMap<TaskId, usize> = TEMPLATES.iter().flat_map(|&one| ids(one)).map(|id| (id, 0)).collect();
    let (solutions, _) = read_solutions(solutions)?;
    for solution in &solutions {
        *known.entry(solution.task).or_default() += 1;
    }
    let most = known.values().max().copied().unwrap_or_default();
    let fewer = known.values().filter(|&&count| count < most).count();
    let none: Vec<String> = known.iter().filter(|(_, count)| **count == 0).map(|(id, _)| id.to_string()).collect();
    writeln!(
        text,
        "\n## Data\n\n{} solutions of {} tasks; {fewer} have fewer than {most}, {} have none{}{}. A task without a \
         known solution would stay in the count. \n",
        solutions.len(),
        known.len(),
        none.len(),
        if none.is_empty() { "" } else { ": " },
        none.join(", "),
    )?;
    writeln!(text, "| template | tasks with fewer | solutions |\n| --- | ---: | ---: |")?;
    for template in TEMPLATES {
        let counts: Vec<usize> = ids(template).filter_map(|id| known.get(&id).copied()).collect();
        let fewer = counts.iter().filter(|&&count| count < most).count();
        if fewer > 0 {
            let total: usize = counts.iter().sum();
            writeln!(text, "| {:05} {} | {fewer} | {total} |", template.number, template.name)?;
        }
    }
    let mut digests: Vec<&[String; 2]> = rows.iter().map(|row| &row.data).collect();
    digests.dedup();
    writeln!(text, "\nSHA-256 of the solutions and of the labelled balls that the rows were made with:\n")?;
    for [solutions, balls] in digests {
        writeln!(text, "- {solutions}, {balls}")?;
    }
    Ok(())
}

const AGAIN: &str = "
## Again

```
pathlight table                             # data, all twenty rows, report; goes on where it was cut off
pathlight table --setup within --fold 3     # data if they are not there yet, one row, report
pathlight table --only report               # this file and the picture
```

Rows share nothing but the two files of data, which they read. So twenty processes can make them, on as many machines
as see the folder; `results/array.sh` is such a job, for Slurm's arrays or anything that sets `SLURM_ARRAY_TASK_ID`:

```
pathlight table --only data
sbatch --array=0-19 --cpus-per-task=2 results/array.sh
seq 0 19 | xargs -P 4 -I{} env SLURM_ARRAY_TASK_ID={} results/array.sh     # without a scheduler, four at a time
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

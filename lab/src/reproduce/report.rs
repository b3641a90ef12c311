//! The table of all results, and below it each fold and template, and how each row was made: `README.md` beside them.

use std::fmt::{self, Write as _};
use std::path::Path;

use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::auccess::{MAX_ATTEMPTS, auccess};
use pathlight::benchmark::folds::FOLDS;
use pathlight::puzzle::templates::TEMPLATES;

use super::means::{auccess_by_template, mean, mean_and_deviation};
use super::published::{BY_TEMPLATE, PUBLISHED, Published};
use super::recipes::Recipes;
use super::{COMMAND, Results};
use crate::measure::report::score_cell;

/// Two players of a recipe, and what the first has and the second lacks.
const PAIRS: [(AgentName, AgentName, &str); 2] = [
    (AgentName::Online, AgentName::Dynamics, "it is told how each attempt ended"),
    (AgentName::Online, AgentName::OnlineByBalls, "balls are compared by imagined paths too"),
];

/// The report on the results in a folder.
///
/// # Errors
/// If results are damaged or do not belong together.
pub fn text(folder: &Path, recipes: &Recipes) -> anyhow::Result<String> {
    let results = Results::read(folder, recipes)?;
    let setups: Vec<&[Results]> = results.chunks_exact(2).collect();
    let mut text = String::new();
    head(&mut text)?;
    table(&mut text, &setups)?;
    pairs(&mut text, &setups)?;
    by_template(&mut text, &setups)?;
    folds(&mut text, &setups)?;
    made(&mut text, &setups)?;
    Ok(text)
}

fn head(text: &mut String) -> fmt::Result {
    writeln!(
        text,
        "# Results\n\n\
         `{COMMAND}` wrote this from the files in the folders beside it, a folder for each recipe of \
         [lab/recipes.toml](../lab/recipes.toml). [Results](../docs/results.md) says what follows from it.\n\n\
         Auccess is measured with at most {MAX_ATTEMPTS} attempts per task, and only these attempts are simulated. \
         Cells are means over folds ± standard deviation. Nets learn from training tasks of their fold, \
         unless more is stated, and from no ball that was sampled around a solution of a test task."
    )
}

fn table(text: &mut String, setups: &[&[Results]]) -> fmt::Result {
    writeln!(
        text,
        "\n## Auccess\n\n| agent | learns from | within | cross | simulator |\n| --- | --- | ---: | ---: | ---: |"
    )?;
    for results in setups {
        let recipe = results[0].recipe;
        for (index, row) in recipe.rows.iter().enumerate() {
            let cells = results.iter().map(|results| {
                let count = results.firsts(row.player()).count();
                let part = if (1..usize::from(FOLDS)).contains(&count) {
                    format!(" ({count} of {FOLDS} folds)")
                } else {
                    String::new()
                };
                mean(results, row.player()) + &part
            });
            let cells: Vec<String> = cells.collect();
            let (title, learns_from) = match index {
                0 => (format!("**{}**", row.title), recipe.learns_from.as_str()),
                _ => (row.title.clone(), ""),
            };
            writeln!(text, "| {title} | {learns_from} | {} | {} |", cells.join(" | "), versions(results))?;
        }
    }
    for published in &PUBLISHED {
        let Published { auccess: [within, cross], .. } = published;
        writeln!(text, "| {} | | {within} | {cross} | PHYRE's |", published.label())?;
    }
    writeln!(
        text,
        "\nSimulator 4 is PHYRE's physics to the bit, simulator 3 agreed with 98.8 % of its stable solutions. RAND plays \
         one list of balls on all tasks: that ours scores the same shows that scenes, valid balls, physics, folds and \
         metric are PHYRE's. The paper's means are over templates; averaged that way, ours are {} within and {} cross. An agent \
         with a memory keeps what it learned at one test task for the next, as PHYRE's DQN-O does (56.2 cross): do not \
         compare it with agents that start each task afresh.",
        paper(setups, 0),
        paper(setups, 1)
    )
}

/// The versions of the simulator that results were made in.
fn versions(results: &[Results]) -> String {
    let mut versions: Vec<String> =
        results.iter().filter_map(|results| Some(results.reports.first()?.simulator.to_string())).collect();
    versions.dedup();
    versions.join(", ")
}

/// The mean over templates of the paper's nets.
fn paper(setups: &[&[Results]], setup: usize) -> String {
    let Some(results) = setups.iter().find(|results| results[0].recipe.name == "paper") else {
        return "–".to_string();
    };
    let player = results[setup].recipe.rows[0].player();
    let firsts = TEMPLATES.iter().map(|template| results[setup].of_template(player, template.number));
    let scores: Vec<f64> = firsts.filter(|firsts| !firsts.is_empty()).map(|firsts| auccess(&firsts)).collect();
    match scores.len() {
        0 => "–".to_string(),
        count => format!("{:.1}", scores.iter().sum::<f64>() / count as f64),
    }
}

/// What a part of the agent brings, by paired differences: two agents meet the same tasks in a fold, so that their
/// difference varies less over the folds than their scores.
fn pairs(text: &mut String, setups: &[&[Results]]) -> fmt::Result {
    writeln!(
        text,
        "\n## What the parts bring\n\nThe difference of two agents' auccess on the same fold: mean ± standard deviation, \
         and the folds on which it is positive.\n\n| recipe | difference | what the first has and the second lacks | \
         within | cross |\n| --- | --- | --- | ---: | ---: |"
    )?;
    for results in setups {
        for (one, other, part) in PAIRS {
            let cells = results.iter().map(|results| {
                let both = results.firsts(one.into()).zip(results.firsts(other.into()));
                let differences: Vec<f64> = both.map(|(one, other)| auccess(one) - auccess(other)).collect();
                let positive = differences.iter().filter(|&&difference| difference > 0.0).count();
                match differences.len() {
                    0 => "–".to_string(),
                    count => format!("{}, {positive} of {count}", mean_and_deviation(&differences)),
                }
            });
            let cells: Vec<String> = cells.collect();
            if cells.iter().any(|cell| cell != "–") {
                let name = &results[0].recipe.name;
                writeln!(text, "| {name} | {one} – {other} | {part} | {} |", cells.join(" | "))?;
            }
        }
    }
    Ok(())
}

fn by_template(text: &mut String, setups: &[&[Results]]) -> fmt::Result {
    for (setup, published) in BY_TEMPLATE.iter().enumerate() {
        let names: Vec<&str> = setups.iter().map(|results| results[0].recipe.name.as_str()).collect();
        writeln!(
            text,
            "\n## By template, {}\n\nAuccess over the tasks of all folds that test a template, of the first agent of \
             each recipe; of the paper's nets as published, too.\n\n| template | {} | published |\n| --- |{}",
            setups[0][setup].setup,
            names.join(" | "),
            " ---: |".repeat(names.len() + 1)
        )?;
        let columns: Vec<Vec<String>> = setups
            .iter()
            .map(|results| auccess_by_template(&results[setup], results[setup].recipe.rows[0].player()))
            .collect();
        for ((index, template), published) in TEMPLATES.iter().enumerate().zip(published.split_whitespace()) {
            let cells: Vec<&str> = columns.iter().map(|column| column[index].as_str()).collect();
            writeln!(text, "| {:05} {} | {} | {published} |", template.number, template.name, cells.join(" | "))?;
        }
    }
    Ok(())
}

fn folds(text: &mut String, setups: &[&[Results]]) -> fmt::Result {
    writeln!(
        text,
        "\n## Each fold\n\nAuccess, and the percentage of the test tasks solved at the first attempt / within 10 / \
         within 100.\n"
    )?;
    for results in setups {
        for row in &results[0].recipe.rows {
            let named = format!("{}: {}", results[0].recipe.name, row.player());
            writeln!(text, "| {named} | within | cross |\n| ---: | ---: | ---: |")?;
            for fold in 0..FOLDS {
                let cell = |results: &Results| {
                    let report = results.reports.iter().find(|report| report.fold == fold);
                    report.and_then(|report| report.first_solved(row.player())).map_or("–".to_string(), score_cell)
                };
                writeln!(text, "| {fold} | {} | {} |", cell(&results[0]), cell(&results[1]))?;
            }
            writeln!(text)?;
        }
    }
    Ok(())
}

/// How each row was made, and what that costs.
fn made(text: &mut String, setups: &[&[Results]]) -> fmt::Result {
    writeln!(
        text,
        "## How they were made\n\nBy these commands of `pathlight-lab`, or by earlier ones that are named instead; {{of}} \
         stands for `--setup SETUP --fold FOLD`, {{fold}} for SETUP-FOLD. Core-minutes are the median over folds and \
         leave out work that other results share; what has none was made before they were counted."
    )?;
    for results in setups.iter().flat_map(|results| results.iter()) {
        let Some(report) = results.reports.first() else { continue };
        let mut minutes: Vec<f64> = results.reports.iter().filter_map(|report| report.core_minutes).collect();
        minutes.sort_by(f64::total_cmp);
        let cost = minutes.get(minutes.len() / 2).map_or(String::new(), |cost| format!(", {cost:.0} core-minutes"));
        writeln!(
            text,
            "\n**{}, {}**: seed {}, simulator {}, agents {}{cost}. Fold {}: {}.{}\n\n```\n{}\n```",
            results.recipe.name,
            results.setup,
            report.seed,
            report.simulator,
            report.agents_version,
            report.fold,
            if report.trainings().is_empty() {
                "nothing is learned".to_string()
            } else {
                report.trainings().join("; ")
            },
            if results.is_of_today { "" } else { " The current recipe has not been run." },
            report.made_by.join("\n")
        )?;
    }
    Ok(())
}

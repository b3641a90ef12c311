//! The table of Harter et al. (2020) with the results of our training of their nets beside the published ones, as
//! Markdown.

use std::fmt::{self, Write as _};
use std::path::Path;

use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::auccess::{auccess, solved_within};
use pathlight::benchmark::folds::{FOLDS, Setup};
use pathlight::nets::Card;
use pathlight::puzzle::templates::TEMPLATES;
use serde::Serialize;

use super::fold_reports;
use super::report::{Report, score_cell};
use crate::training::settings::{PathsRecipe, recipe_of};

/// What the paper reports of a setup, over its ten folds.
struct Published {
    setup: Setup,
    /// Auccess, by template and as the mean over the templates.
    auccess: [&'static str; 2],
    /// The percentage of tasks solved within ten attempts.
    solved: [&'static str; 2],
}

const WITHIN: Published = Published {
    setup: Setup::Within,
    auccess: ["80 89 87 95 79 82 86 62 69 77 31 53 52 65 84 78 39 41 69 45 46 29 30 45 42", "62"],
    solved: ["86 98 90 100 86 90 94 62 72 81 27 57 55 70 93 83 37 44 82 51 48 23 27 46 44", "66"],
};

/// No fold tests template 00006.
const CROSS: Published = Published {
    setup: Setup::Cross,
    auccess: ["51 54 67 67 57 63 – 30 24 14 14 38 48 51 15 25 14 5 37 17 24 3 9 6 6", "31"],
    solved: ["50 51 72 70 58 67 – 31 22 13 11 34 50 53 11 21 12 6 35 13 22 0 7 4 6", "31"],
};

/// The auccess of each template in a setup: as published, and ours; “–” where no fold tests it.
#[derive(Serialize)]
pub struct ByTemplate {
    published: Vec<&'static str>,
    ours: Vec<String>,
}

/// The results of a setup, a report for each fold.
struct Measured<'a>(Vec<&'a Report>);

/// Reads the results in a folder, `SETUP-FOLD.json` of `measure evaluate --agent paper`, and returns the page.
///
/// # Errors
/// If there are none, or one is damaged, or they were made with different settings.
pub fn page(folder: &Path) -> anyhow::Result<String> {
    let reports = read(folder)?;
    let mut text = HEAD.to_string();
    training(&mut text, &reports[0], reports.len())?;
    let [within, cross] = [&WITHIN, &CROSS].map(|published| Measured::of(&reports, published.setup));
    means(&mut text, [(&within, &WITHIN), (&cross, &CROSS)])?;
    for (measured, published) in [(&within, &WITHIN), (&cross, &CROSS)] {
        if !measured.0.is_empty() {
            measured.templates(&mut text, published)?;
        }
    }
    folds(&mut text, &reports)?;
    Ok(text)
}

/// Returns the auccess by template, within and cross, of the results in a folder.
///
/// # Errors
/// As `page`.
pub fn by_template(folder: &Path) -> anyhow::Result<[ByTemplate; 2]> {
    let reports = read(folder)?;
    Ok([&WITHIN, &CROSS].map(|published| {
        let measured = Measured::of(&reports, published.setup);
        let ours = TEMPLATES.iter().map(|template| {
            let firsts = measured.firsts(AgentName::Paper, Some(template.number));
            if firsts.is_empty() { "–".to_string() } else { format!("{:.0}", auccess(&firsts)) }
        });
        ByTemplate { published: published.by_template().collect(), ours: ours.collect() }
    }))
}

/// Reads the results in a folder, within before cross, folds ascending.
///
/// # Errors
/// As `page`.
pub fn read(folder: &Path) -> anyhow::Result<Vec<Report>> {
    fold_reports::read(folder, &[AgentName::Paper, AgentName::Random], "scripts/paper-table", settings)
}

impl Published {
    /// The published auccess of each template.
    fn by_template(&self) -> impl Iterator<Item = &'static str> + use<> {
        self.auccess[0].split_whitespace()
    }
}

const HEAD: &str = "# The table of Harter et al. (2020)

`pathlight-lab measure paper results/paper` printed this from the files beside it, which `scripts/paper-table` made. \
The published numbers are means over all ten folds, in PHYRE's simulator. Auccess counts up to 100 attempts per task; \
“solved” is the percentage of test tasks solved within ten. Only counted attempts are simulated.
";

/// What has to agree between the results of a table: the seed, and how the nets were trained.
fn settings(report: &Report) -> impl PartialEq + use<> {
    let recipe =
        report.card.as_ref().map(|card| (card.seed, card.epochs, card.samples, recipe_of::<PathsRecipe>(card)));
    (report.seed, recipe)
}

fn training(text: &mut String, report: &Report, count: usize) -> fmt::Result {
    let Report { seed, simulator, agents_version, card: Some(card), .. } = report else { return Ok(()) };
    let Card { epochs, batch, learning_rate, decay_epochs, mirror, samples, tasks, .. } = card;
    writeln!(
        text,
        "\nThe four nets were trained on {samples} solutions of {tasks} tasks, {epochs} epochs in batches of {batch}, \
         Adam at {learning_rate}, which decays linearly to zero in the end (epochs of decay: {decay_epochs}){}. Seed \
         {seed}, simulator {simulator}, agents {agents_version}.",
        if *mirror { ", half of the samples mirrored" } else { "" },
    )?;
    let all = 2 * usize::from(FOLDS);
    if count < all {
        writeln!(
            text,
            "\n**{count} of {all} folds are measured.** Folds differ, across templates by ten points and more, so these \
             means cannot be compared with the published ones yet."
        )?;
    }
    Ok(())
}

fn means(text: &mut String, setups: [(&Measured, &Published); 2]) -> fmt::Result {
    writeln!(
        text,
        "\n## Mean\n\n| setup | results | auccess, mean over templates | over tasks | solved, mean over templates \
         |\n| --- | --- | ---: | ---: | ---: |"
    )?;
    for (measured, published) in setups {
        for (agent, label) in [(AgentName::Paper, "ours"), (AgentName::Random, "random balls, ours")] {
            if measured.0.is_empty() {
                continue;
            }
            let all: Vec<_> = measured.firsts(agent, None);
            writeln!(
                text,
                "| {} | {label} | {:.1} | {:.1} | {:.0} % |",
                published.setup,
                measured.mean_over_templates(agent, auccess),
                auccess(&all),
                measured.mean_over_templates(agent, solved),
            )?;
        }
        let Published { setup, auccess: [_, auccess], solved: [_, solved] } = published;
        writeln!(text, "| {setup} | published | {auccess} | | {solved} % |")?;
    }
    Ok(())
}

/// The percentage of tasks solved within ten attempts.
fn solved(firsts: &[Option<usize>]) -> f64 {
    100.0 * solved_within(firsts, 10)
}

impl<'a> Measured<'a> {
    /// The reports of a setup.
    fn of(reports: &'a [Report], setup: Setup) -> Measured<'a> {
        Measured(reports.iter().filter(|report| report.setup == setup).collect())
    }

    /// The first solving attempts of an agent at the tasks of a template, or of all, in all folds.
    fn firsts(&self, agent: AgentName, template: Option<usize>) -> Vec<Option<usize>> {
        self.0.iter().flat_map(|report| report.first_solved(agent, template)).collect()
    }

    fn mean_over_templates(&self, agent: AgentName, of: impl Fn(&[Option<usize>]) -> f64) -> f64 {
        let firsts = TEMPLATES.iter().map(|template| self.firsts(agent, Some(template.number)));
        let measured: Vec<f64> = firsts.filter(|firsts| !firsts.is_empty()).map(|firsts| of(&firsts)).collect();
        measured.iter().sum::<f64>() / measured.len() as f64
    }

    fn templates(&self, text: &mut String, published: &Published) -> fmt::Result {
        writeln!(
            text,
            "\n## By template, {}\n\n| template | auccess, published | ours | random balls | solved, published | ours \
             |\n| --- | ---: | ---: | ---: | ---: | ---: |",
            published.setup
        )?;
        let numbers = published.by_template().zip(published.solved[0].split_whitespace());
        for (template, (published_auccess, published_solved)) in TEMPLATES.iter().zip(numbers) {
            let [ours, random] =
                [AgentName::Paper, AgentName::Random].map(|agent| self.firsts(agent, Some(template.number)));
            if ours.is_empty() {
                continue;
            }
            writeln!(
                text,
                "| {:05} {} | {} | {:.0} | {:.0} | {} | {:.0} |",
                template.number,
                template.name,
                published_auccess,
                auccess(&ours),
                auccess(&random),
                published_solved,
                solved(&ours),
            )?;
        }
        Ok(())
    }
}

fn folds(text: &mut String, reports: &[Report]) -> fmt::Result {
    writeln!(
        text,
        "\n## Each fold\n\nAuccess over the test tasks, and the percentage solved at the first attempt / within 10 / \
         within 100.\n\n| setup | fold | test tasks | ours | random balls |\n| --- | ---: | ---: | ---: | ---: |"
    )?;
    for report in reports {
        let cells =
            [AgentName::Paper, AgentName::Random].map(|agent| report.score(agent).map_or("–".to_string(), score_cell));
        let tasks = report.agents.first().map_or(0, |score| score.first_solved.len());
        writeln!(text, "| {} | {} | {tasks} | {} | {} |", report.setup, report.fold, cells[0], cells[1])?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_template_has_a_published_number() {
        for Published { auccess: [auccess, _], solved: [solved, _], .. } in [WITHIN, CROSS] {
            for numbers in [auccess, solved] {
                assert_eq!(numbers.split_whitespace().count(), TEMPLATES.len(), "{numbers}");
            }
        }
    }
}

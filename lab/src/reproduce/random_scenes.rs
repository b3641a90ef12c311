//! The results of dynamics nets that learned from random scenes too, beside the rows without them, as Markdown.

use std::fmt::{self, Write as _};
use std::path::Path;

use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::auccess::auccess;
use pathlight::benchmark::folds::{FOLDS, Setup};
use pathlight::nets::{Card, DynamicsCard};
use pathlight::puzzle::templates::TEMPLATES;

use super::compared::mean_and_deviation;
use super::fold_result::{self, FoldResult};
use crate::files::json_file;
use crate::measure::agents::row;
use crate::measure::evaluate::{Report, score_cell};
use crate::measure::fold_reports;
use crate::measure::task_set::TaskSet;

/// What makes the results.
const SCRIPT: &str = "scripts/random-scenes-table";

/// The agents that are measured, but for the random one.
const AGENTS: [AgentName; 3] = [AgentName::Online, AgentName::OnlineByBalls, AgentName::Dynamics];

/// Reads the results in a folder, `SETUP-FOLD.json` of `measure evaluate`, and the rows in another, and returns the
/// page.
///
/// # Errors
/// If there are no results, one is damaged, or they were made with different settings.
pub fn page(folder: &Path, rows: &Path) -> anyhow::Result<String> {
    let rows = fold_result::read(rows)?;
    let reports = fold_reports::read(folder, &AGENTS, SCRIPT, settings)?;
    let mut text = String::new();
    head(&mut text, &reports[0], reports.len())?;
    means(&mut text, &reports, &rows)?;
    templates(&mut text, &reports, &rows)?;
    folds(&mut text, &reports)?;
    let path = folder.join("alone.json");
    if path.exists() {
        alone(&mut text, &json_file::read(&path, SCRIPT)?)?;
    }
    Ok(text)
}

/// Returns the auccess of the online agent over the folds in a folder, within and cross: the mean and the deviation.
///
/// # Errors
/// As `page`.
pub fn online(folder: &Path) -> anyhow::Result<[String; 2]> {
    let reports = fold_reports::read(folder, &AGENTS, SCRIPT, settings)?;
    Ok([Setup::Within, Setup::Cross].map(|setup| {
        let of_setup = reports.iter().filter(|report| report.setup == setup);
        let scores: Vec<f64> =
            of_setup.filter_map(|report| report.score(AgentName::Online)).map(|[auccess, ..]| auccess).collect();
        mean_and_deviation(&scores)
    }))
}

/// The net that has seen random scenes alone, on all tasks.
fn alone(text: &mut String, report: &Report) -> anyhow::Result<()> {
    let Report { tasks_of: TaskSet::All, seed, card: Some(Card { dynamics: Some(card), .. }), .. } = report else {
        anyhow::bail!("alone.json is not of all tasks: remove it, and run `{SCRIPT}` again");
    };
    let DynamicsCard { epochs, batch, balls_per_scene, learning_rate, balls, random_scenes, .. } = card;
    let agents = || AGENTS.into_iter().chain([AgentName::Random]);
    let tasks = report.first_solved(AgentName::Random, None).len();
    writeln!(
        text,
        "\n## Random scenes alone\n\nThe net that those of the folds start from has seen no task and no template. \
         {balls} balls, {random_scenes} random scenes; {epochs} epochs in batches of {batch} scenes with \
         {balls_per_scene} balls each, Adam at {learning_rate}. Seed {seed}, {tasks} tasks.\n"
    )?;
    let names: Vec<&str> = agents().map(|agent| row(agent).label).collect();
    writeln!(text, "| template | {} |\n| --- |{}", names.join(" | "), " ---: |".repeat(names.len()))?;
    for template in TEMPLATES {
        let auccess = |agent| format!("{:.0}", auccess(&report.first_solved(agent, Some(template.number))));
        let cells: Vec<String> = agents().map(auccess).collect();
        writeln!(text, "| {:05} {} | {} |", template.number, template.name, cells.join(" | "))?;
    }
    let all: Vec<String> = agents().map(|agent| report.score(agent).map_or("–".to_string(), score_cell)).collect();
    writeln!(text, "| all | {} |", all.join(" | "))?;
    Ok(())
}

/// What has to agree between the results of a table: the seed, and how the dynamics nets were trained.
fn settings(report: &Report) -> impl PartialEq + use<> {
    let card = report.card.as_ref().and_then(|card| card.dynamics.as_ref());
    let recipe = card.map(|card| {
        let DynamicsCard { seed, epochs, batch, balls_per_scene, imagined_per_scene, learning_rate, .. } = *card;
        (seed, epochs, batch, balls_per_scene, imagined_per_scene, learning_rate, card.random_scenes)
    });
    (report.seed, recipe)
}

fn head(text: &mut String, report: &Report, count: usize) -> anyhow::Result<()> {
    let Report { seed, simulator, agents_version, card: Some(Card { dynamics: Some(card), .. }), .. } = report else {
        anyhow::bail!("the results are of weights without a dynamics net: make them with `{SCRIPT}`");
    };
    let DynamicsCard { epochs, batch, balls_per_scene, learning_rate, balls, variants, random_scenes, .. } = card;
    write!(
        text,
        "# With random scenes\n\n`pathlight-lab measure random-scenes` printed this from the files beside it, which \
         `{SCRIPT}` made. The dynamics nets learned from random scenes, which have no template, at first from these \
         alone, and then from the training tasks and variants of them too. The nets of the [rows](../README.md) have \
         seen no random scenes, and were trained with other settings. Only counted attempts are simulated.\n\n\
         {} {}: {balls} balls, {variants} variants, {random_scenes} random scenes; {epochs} epochs in batches of \
         {batch} scenes with {balls_per_scene} balls each, Adam at {learning_rate}. Seed {seed}, simulator \
         {simulator}, agents {agents_version}. {count} of {FOLDS} folds are measured.\n",
        report.setup, report.fold,
    )?;
    Ok(())
}

/// The means over the folds that are measured, beside those of the rows of the same folds.
fn means(text: &mut String, reports: &[Report], rows: &[FoldResult]) -> fmt::Result {
    writeln!(
        text,
        "\n## Auccess, mean over folds ± standard deviation\n\n| setup | folds | agent | with random scenes | the rows \
         of the same folds | paired difference, folds on which it is positive |\n| --- | ---: | --- | ---: | ---: | \
         ---: |"
    )?;
    for setup in [Setup::Within, Setup::Cross] {
        let of_setup: Vec<&Report> = reports.iter().filter(|report| report.setup == setup).collect();
        for agent in AGENTS.into_iter().filter(|_| !of_setup.is_empty()) {
            let auccess = |report: &Report| report.score(agent).map(|[auccess, ..]| auccess);
            let of_rows =
                |fold: u8| rows.iter().map(|row| &row.report).find(|row| (row.setup, row.fold) == (setup, fold));
            let (with, without): (Vec<f64>, Vec<f64>) =
                of_setup.iter().filter_map(|report| Some((auccess(report)?, auccess(of_rows(report.fold)?)?))).unzip();
            let differences: Vec<f64> = with.iter().zip(&without).map(|(with, without)| with - without).collect();
            writeln!(
                text,
                "| {setup} | {} | **{}** | {} | {} | {}, {} of {} |",
                with.len(),
                row(agent).label,
                mean_and_deviation(&with),
                mean_and_deviation(&without),
                mean_and_deviation(&differences),
                differences.iter().filter(|&&difference| difference > 0.0).count(),
                differences.len(),
            )?;
        }
    }
    Ok(())
}

/// The online agent on each template, with random scenes and in the rows of the same folds.
fn templates(text: &mut String, reports: &[Report], rows: &[FoldResult]) -> fmt::Result {
    writeln!(
        text,
        "\n## By template\n\nAuccess of the online agent over the tasks of all folds of the table that test a \
         template.\n\n| template | with random scenes | the rows of the same folds | random |\n| --- | ---: | ---: | ---: |"
    )?;
    let of_rows =
        |of: &Report| rows.iter().map(|row| &row.report).find(|row| (row.setup, row.fold) == (of.setup, of.fold));
    let rows: Vec<&Report> = reports.iter().filter_map(of_rows).collect();
    let reports: Vec<&Report> = reports.iter().collect();
    for template in TEMPLATES {
        let auccess = |reports: &[&Report], agent| {
            let firsts = reports.iter().flat_map(|report| report.first_solved(agent, Some(template.number)));
            let firsts: Vec<Option<usize>> = firsts.collect();
            (!firsts.is_empty()).then(|| format!("{:.0}", auccess(&firsts)))
        };
        let cells = [(&reports, AgentName::Online), (&rows, AgentName::Online), (&reports, AgentName::Random)];
        let cells: Option<Vec<String>> = cells.into_iter().map(|(reports, agent)| auccess(reports, agent)).collect();
        if let Some(cells) = cells {
            writeln!(text, "| {:05} {} | {} |", template.number, template.name, cells.join(" | "))?;
        }
    }
    Ok(())
}

fn folds(text: &mut String, reports: &[Report]) -> fmt::Result {
    let names = AGENTS.map(|agent| row(agent).label).join(" | ");
    writeln!(
        text,
        "\n## Each fold\n\nAuccess, and the percentage solved at the first attempt / within 10 / within 100.\n\n| setup \
         | fold | {names} |\n| --- | ---: | ---: | ---: | ---: |"
    )?;
    for report in reports {
        let cells = AGENTS.map(|agent| report.score(agent).map_or("–".to_string(), score_cell));
        writeln!(text, "| {} | {} | {} |", report.setup, report.fold, cells.join(" | "))?;
    }
    Ok(())
}

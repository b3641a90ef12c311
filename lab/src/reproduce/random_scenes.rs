//! The results of dynamics nets that learned from random scenes too, beside the rows without them, as Markdown.

use std::fmt::{self, Write as _};
use std::path::Path;

use anyhow::{Context, ensure};
use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::auccess::auccess;
use pathlight::benchmark::folds::{FOLDS, Setup};
use pathlight::nets::{Card, DynamicsCard};
use pathlight::puzzle::templates::TEMPLATES;

use super::compared::{mean_and_deviation, scores};
use super::fold_result;
use crate::files::json_file;
use crate::measure::agents::row;
use crate::measure::evaluate::{Report, score_cell};
use crate::measure::fold_reports;
use crate::measure::task_set::TaskSet;

/// What makes the results.
const SCRIPT: &str = "scripts/random-scenes-table";

/// The agents that are measured, but for the random one.
const AGENTS: [AgentName; 3] = [AgentName::Online, AgentName::OnlineByBalls, AgentName::Dynamics];

/// Reads the results in a folder, `cross-FOLD.json` of `measure evaluate` and `alone.json`, and the rows in another;
/// returns the page.
///
/// # Errors
/// If there are no results, one is damaged or has no row, or they were made with different settings.
pub fn page(folder: &Path, rows: &Path) -> anyhow::Result<String> {
    let reports = read(folder)?;
    let rows = fold_result::read(rows)?;
    let row_of = |report: &Report| {
        let mut rows = rows.iter().map(|row| &row.report);
        let row = rows.find(|row| (row.setup, row.fold) == (report.setup, report.fold));
        row.with_context(|| format!("there is no row of {} {}: name the folder of all rows", report.setup, report.fold))
    };
    let rows = reports.iter().map(row_of).collect::<anyhow::Result<Vec<_>>>()?;
    let path = folder.join("alone.json");
    let alone: Option<Report> = if path.exists() { Some(json_file::read(&path, SCRIPT)?) } else { None };
    let mut text = String::new();
    head(&mut text, &reports[0], reports.len())?;
    means(&mut text, &reports, &rows, alone.as_ref())?;
    templates(&mut text, &reports, &rows, alone.as_ref())?;
    folds(&mut text, &reports)?;
    if let Some(alone) = &alone {
        random_scenes_alone(&mut text, alone)?;
    }
    Ok(text)
}

/// Returns the auccess of the online agent over the folds in a folder: the mean and the deviation.
///
/// # Errors
/// As `page`.
pub fn online(folder: &Path) -> anyhow::Result<String> {
    Ok(mean_and_deviation(&scores(read(folder)?.iter(), AgentName::Online)))
}

fn read(folder: &Path) -> anyhow::Result<Vec<Report>> {
    let reports = fold_reports::read(folder, &AGENTS, SCRIPT, settings)?;
    ensure!(
        reports.iter().all(|report| report.setup == Setup::Cross),
        "{} holds results of the setup within, but `{SCRIPT}` makes those of cross: remove the others",
        folder.display()
    );
    Ok(reports)
}

/// The net that has seen random scenes alone, on all tasks.
fn random_scenes_alone(text: &mut String, report: &Report) -> anyhow::Result<()> {
    let Report { tasks_of: TaskSet::All, seed, card: Some(Card { dynamics: Some(card), .. }), .. } = report else {
        anyhow::bail!("alone.json is not of all tasks: remove it, and run `{SCRIPT}` again");
    };
    let DynamicsCard { epochs, batch, balls_per_scene, optimiser, learning_rate, balls, random_scenes, .. } = card;
    let agents = || AGENTS.into_iter().chain([AgentName::Random]);
    let tasks = report.first_solved(AgentName::Random, None).len();
    writeln!(
        text,
        "\n## Random scenes alone\n\nThe net that those of the folds start from has seen no task and no template. \
         {balls} balls, {random_scenes} random scenes; {epochs} epochs in batches of {batch} scenes with \
         {balls_per_scene} balls each, {optimiser} at {learning_rate}. Seed {seed}, {tasks} tasks.\n"
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
        let DynamicsCard { seed, epochs, batch, balls_per_scene, imagined_per_scene, .. } = *card;
        let rate = (card.optimiser, card.learning_rate);
        (seed, epochs, batch, balls_per_scene, imagined_per_scene, rate, card.random_scenes)
    });
    (report.seed, recipe)
}

fn head(text: &mut String, report: &Report, count: usize) -> anyhow::Result<()> {
    let Report { seed, simulator, agents_version, card: Some(Card { dynamics: Some(card), .. }), .. } = report else {
        anyhow::bail!("the results are of weights without a dynamics net: make them with `{SCRIPT}`");
    };
    let DynamicsCard {
        epochs, batch, balls_per_scene, optimiser, learning_rate, balls, variants, random_scenes, ..
    } = card;
    write!(
        text,
        "# With random scenes\n\n`pathlight-lab measure random-scenes` printed this from the files beside it, which \
         `{SCRIPT}` made. The dynamics nets learned from random scenes, which have no template, at first from these \
         alone, and then from the training tasks and variants of them too. The nets of the [rows](../README.md) have \
         seen no random scenes, and were trained with other settings. Only counted attempts are simulated.\n\n\
         {} {}: {balls} balls, {variants} variants, {random_scenes} random scenes; {epochs} epochs in batches of \
         {batch} scenes with {balls_per_scene} balls each, {optimiser} at {learning_rate}. Seed {seed}, simulator \
         {simulator}, agents {agents_version}. {count} of {FOLDS} folds are measured.\n",
        report.setup, report.fold,
    )?;
    Ok(())
}

/// The means over the folds that are measured, beside those of the net that has seen random scenes alone and of the
/// rows, on the same test tasks.
fn means(text: &mut String, reports: &[Report], rows: &[&Report], alone: Option<&Report>) -> fmt::Result {
    writeln!(
        text,
        "\n## Auccess, mean over folds ± standard deviation\n\nOn the same test tasks.\n\n| setup | folds | agent | \
         random scenes, then tasks | random scenes alone | the rows | first minus rows, folds on which it is positive \
         |\n| --- | ---: | --- | ---: | ---: | ---: | ---: |"
    )?;
    for agent in AGENTS {
        let [with, without] = [scores(reports.iter(), agent), scores(rows.iter().copied(), agent)];
        let differences: Vec<f64> = with.iter().zip(&without).map(|(with, without)| with - without).collect();
        let alone: Vec<f64> =
            alone.iter().flat_map(|alone| reports.iter().map(|of| auccess(&on_tasks_of(of, alone, agent)))).collect();
        writeln!(
            text,
            "| cross | {} | **{}** | {} | {} | {} | {}, {} of {} |",
            reports.len(),
            row(agent).label,
            mean_and_deviation(&with),
            mean_and_deviation(&alone),
            mean_and_deviation(&without),
            mean_and_deviation(&differences),
            differences.iter().filter(|&&difference| difference > 0.0).count(),
            differences.len(),
        )?;
    }
    Ok(())
}

/// The first solving attempts of an agent in a report on all tasks, at those that a fold of cross tests: all of some
/// templates.
fn on_tasks_of(fold: &Report, all: &Report, agent: AgentName) -> Vec<Option<usize>> {
    let tested = |template: &usize| !fold.first_solved(agent, Some(*template)).is_empty();
    (0..TEMPLATES.len()).filter(tested).flat_map(|template| all.first_solved(agent, Some(template))).collect()
}

/// The same of the online agent, by template.
fn templates(text: &mut String, reports: &[Report], rows: &[&Report], alone: Option<&Report>) -> fmt::Result {
    writeln!(
        text,
        "\n## By template\n\nAuccess of the online agent over the tasks of all folds that test a template.\n\n| template \
         | random scenes, then tasks | random scenes alone | the rows | random |\n| --- | ---: | ---: | ---: | ---: |"
    )?;
    let reports: Vec<&Report> = reports.iter().collect();
    for template in TEMPLATES {
        let cell = |reports: &[&Report], agent| {
            let firsts = reports.iter().flat_map(|report| report.first_solved(agent, Some(template.number)));
            let firsts: Vec<Option<usize>> = firsts.collect();
            if firsts.is_empty() { "–".to_string() } else { format!("{:.0}", auccess(&firsts)) }
        };
        let cells = [(&reports[..], AgentName::Online), (alone.as_slice(), AgentName::Online)];
        let cells = cells.into_iter().chain([(rows, AgentName::Online), (&reports, AgentName::Random)]);
        let cells: Vec<String> = cells.map(|(reports, agent)| cell(reports, agent)).collect();
        if cells[0] != "–" {
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

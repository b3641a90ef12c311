//! The results of dynamics nets that learned from other data than those of the main results, beside these, as Markdown.

use std::fmt::{self, Write as _};
use std::path::Path;

use anyhow::ensure;
use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::auccess::auccess;
use pathlight::benchmark::folds::{FOLDS, FoldId, Setup};
use pathlight::nets::{Card, DynamicsCard};
use pathlight::puzzle::templates::TEMPLATES;

use super::compared::{mean_and_deviation, scores};
use super::fold_result;
use crate::measure::agents::row;
use crate::measure::fold_reports::{self, ALL_TASKS};
use crate::measure::report::{Report, scene_counts, score_cell};
pub use table::Table;

mod table;

/// The agents that are measured, but for the random one.
const AGENTS: [AgentName; 3] = [AgentName::Online, AgentName::OnlineByBalls, AgentName::Dynamics];

/// What a page is written from.
struct Results {
    table: Table,
    /// On several folds of one setup.
    reports: Vec<Report>,
    /// The main results on the same folds.
    main: Vec<Report>,
    /// On all tasks, if the nets have seen none; `reports` are parts of it.
    on_all_tasks: Option<Report>,
}

/// Reads the results of `measure evaluate` in a folder, and the main results in another; returns the page.
///
/// # Errors
/// If there are no results, one is damaged, the main results lack its fold, or they were made with different settings.
pub fn page(table: Table, folder: &Path, main: &Path) -> anyhow::Result<String> {
    let (reports, on_all_tasks) = read(table, folder)?;
    let mut on_folds: Vec<Report> = fold_result::read(main)?.into_iter().map(|result| result.report).collect();
    on_folds.retain(|one| reports.iter().any(|report| (one.setup, one.fold) == (report.setup, report.fold)));
    ensure!(
        on_folds.len() == reports.len(),
        "{} lacks some folds that {} holds: name the folder of the main results with --main",
        main.display(),
        folder.display()
    );
    if let Some(cut) = on_folds.iter().find(|report| !report.is_of(&report.fold_id().tasks().test)) {
        anyhow::bail!(
            "{}/{}.json is not of all test tasks of its fold: name the folder of the main results with --main",
            main.display(),
            cut.fold_id()
        );
    }
    let results = Results { table, reports, main: on_folds, on_all_tasks };
    let mut text = String::new();
    results.head(&mut text)?;
    results.means(&mut text)?;
    results.templates(&mut text)?;
    results.folds(&mut text)?;
    if let Some(report) = &results.on_all_tasks {
        all_tasks(&mut text, report)?;
    }
    Ok(text)
}

/// Returns the auccess of the online agent over the ten folds, the mean and the deviation; `None` if the folder does
/// not hold them all.
///
/// # Errors
/// If a result is damaged, or they were made with different settings.
pub fn online(table: Table, folder: &Path) -> anyhow::Result<Option<String>> {
    let exists = |name: String| folder.join(name).exists();
    let is_whole = match table {
        Table::ProposedBalls => folds_of(table.setup()).all(|fold| exists(format!("{fold}.json"))),
        Table::RandomScenes => exists(ALL_TASKS.to_string()),
    };
    if !is_whole {
        return Ok(None);
    }
    Ok(Some(mean_and_deviation(&scores(read(table, folder)?.0.iter(), AgentName::Online))))
}

/// Returns the results on the folds; and those on all tasks, if the nets have seen none.
fn read(table: Table, folder: &Path) -> anyhow::Result<(Vec<Report>, Option<Report>)> {
    let (setup, script) = (table.setup(), table.script());
    match table {
        Table::ProposedBalls => {
            let reports = fold_reports::read(folder, &AGENTS, script, settings)?;
            ensure!(
                reports.iter().all(|report| report.setup == setup),
                "{} holds results of a setup other than {setup}, the one that `{script}` measures: remove them",
                folder.display(),
            );
            Ok((reports, None))
        }
        Table::RandomScenes => {
            let report = fold_reports::read_all_tasks(folder, &AGENTS, script)?;
            Ok((folds_of(setup).map(|fold| report.on_fold(fold)).collect(), Some(report)))
        }
    }
}

/// The folds of a setup.
fn folds_of(setup: Setup) -> impl Iterator<Item = FoldId> {
    FoldId::all().filter(move |fold| fold.setup == setup)
}

/// What has to agree between the results of a table: the seed, and how the dynamics nets were trained.
fn settings(report: &Report) -> impl PartialEq + use<> {
    let card = report.card.as_ref().and_then(|card| card.dynamics.as_ref());
    let recipe = card.map(|card| {
        let DynamicsCard { seed, epochs, batch, balls_per_scene, imagined_per_scene, .. } = *card;
        let rate = (card.optimiser, card.learning_rate, card.path_weights);
        (seed, epochs, batch, balls_per_scene, imagined_per_scene, rate)
    });
    (report.seed, recipe)
}

impl Results {
    fn head(&self, text: &mut String) -> anyhow::Result<()> {
        let first = &self.reports[0];
        let Report { setup, fold, seed, simulator, agents_version, .. } = first;
        let Report { card: Some(Card { dynamics: Some(card), .. }), .. } = first else {
            anyhow::bail!(
                "the results are of weights without a dynamics net: make them with `{}`",
                self.table.script()
            );
        };
        let DynamicsCard { epochs, batch, balls_per_scene, optimiser, learning_rate, path_weights, .. } = card;
        let (title, command) = (self.table.title(), self.table.name());
        let training = match self.on_all_tasks {
            None => format!("The last training of {setup} {fold}"),
            Some(_) => "The training".to_string(),
        };
        let data: Vec<String> = [format!("{} balls", card.balls)].into_iter().chain(scene_counts(card)).collect();
        let data = data.join(", ");
        write!(
            text,
            "# {title}\n\n`pathlight-lab measure {command}` printed this from the files beside it, which `{}` made. \
             {} Only counted attempts are simulated.\n\n\
             {training}: {data}; {epochs} epochs in batches of {batch} scenes with {balls_per_scene} balls each, \
             {optimiser} at {learning_rate}, weights of the paths {} and {}. Seed {seed}, simulator {simulator}, \
             agents {agents_version}. Folds measured: {} of {FOLDS}.\n",
            self.table.script(),
            self.table.introduction(),
            path_weights.all,
            path_weights.solving,
            self.reports.len(),
        )?;
        Ok(())
    }

    /// The means over the folds that are measured, beside those of the main results, on the same test tasks.
    fn means(&self, text: &mut String) -> fmt::Result {
        writeln!(
            text,
            "\n## Auccess, mean over folds ± standard deviation\n\nOn the same test tasks.\n\n| setup | folds | agent \
             | {} | main results | difference, folds on which it is positive |\n\
             | --- | ---: | --- | ---: | ---: | ---: |",
            self.table.column(),
        )?;
        for agent in AGENTS {
            let [with, without] = [&self.reports, &self.main].map(|reports| scores(reports.iter(), agent));
            let differences: Vec<f64> = with.iter().zip(&without).map(|(with, without)| with - without).collect();
            writeln!(
                text,
                "| {} | {} | **{}** | {} | {} | {}, {} of {} |",
                self.table.setup(),
                self.reports.len(),
                row(agent).label,
                mean_and_deviation(&with),
                mean_and_deviation(&without),
                mean_and_deviation(&differences),
                differences.iter().filter(|&&difference| difference > 0.0).count(),
                differences.len(),
            )?;
        }
        Ok(())
    }

    /// The same of the online agent, by template.
    fn templates(&self, text: &mut String) -> fmt::Result {
        writeln!(
            text,
            "\n## By template\n\nAuccess of the online agent over the tasks of all folds that test a template.\n\n\
             | template | {} | main results | random |\n| --- | ---: | ---: | ---: |",
            self.table.column(),
        )?;
        for template in TEMPLATES {
            let cell = |reports: &[Report], agent| {
                let firsts = reports.iter().flat_map(|report| report.first_solved(agent, Some(template.number)));
                let firsts: Vec<Option<usize>> = firsts.collect();
                if firsts.is_empty() { "–".to_string() } else { format!("{:.0}", auccess(&firsts)) }
            };
            let cells = [&self.reports, &self.main].map(|reports| cell(reports, AgentName::Online));
            if cells[0] != "–" {
                let random = cell(&self.reports, AgentName::Random);
                writeln!(text, "| {:05} {} | {} | {random} |", template.number, template.name, cells.join(" | "))?;
            }
        }
        Ok(())
    }

    fn folds(&self, text: &mut String) -> fmt::Result {
        let names = AGENTS.map(|agent| row(agent).label).join(" | ");
        writeln!(
            text,
            "\n## Each fold\n\nAuccess, and the percentage solved at the first attempt / within 10 / within 100.\n\n| setup \
             | fold | {names} |\n| --- | ---: | ---: | ---: | ---: |"
        )?;
        for report in &self.reports {
            let cells = AGENTS.map(|agent| report.score(agent).map_or("–".to_string(), score_cell));
            writeln!(text, "| {} | {} | {} |", report.setup, report.fold, cells.join(" | "))?;
        }
        Ok(())
    }
}

/// The means over all tasks.
fn all_tasks(text: &mut String, report: &Report) -> fmt::Result {
    let agents = || AGENTS.into_iter().chain([AgentName::Random]);
    let tasks = report.first_solved(AgentName::Random, None).len();
    let names: Vec<&str> = agents().map(|agent| row(agent).label).collect();
    let cells: Vec<String> = agents().map(|agent| report.score(agent).map_or("–".to_string(), score_cell)).collect();
    writeln!(
        text,
        "\n## All {tasks} tasks\n\n| {} |\n|{}\n| {} |",
        names.join(" | "),
        " ---: |".repeat(names.len()),
        cells.join(" | ")
    )
}

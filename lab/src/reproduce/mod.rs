//! The results: recipes that define how each row of the table is made, the result of each fold as a file of `measure
//! evaluate`, and the table.
//!
//! Results are independent, so they can be made in parallel on several machines.

use std::path::Path;

use anyhow::ensure;
use pathlight::benchmark::folds::{FoldId, Setup};

use crate::measure::report::{Player, Report};
use recipes::{Recipe, Recipes};

pub mod means;
pub mod published;
pub mod recipes;
pub mod report;

/// The folder of the results in the repository.
pub const RESULTS: &str = "results";

/// The command that makes the results.
pub const COMMAND: &str = "pathlight-lab reproduce";

/// The results of a recipe in a setup, one per fold; fewer than ten if some are missing.
pub struct Results<'a> {
    pub recipe: &'a Recipe,
    pub setup: Setup,
    /// In ascending order of folds.
    pub reports: Vec<Report>,
    /// Whether they were made by the current steps of the recipe.
    pub is_current: bool,
}

impl<'a> Results<'a> {
    /// Reads the results in a folder.
    ///
    /// # Errors
    /// If a result is damaged, is of another fold than its name says, or was made differently from the others.
    pub fn read(folder: &Path, recipes: &'a Recipes) -> anyhow::Result<Vec<Results<'a>>> {
        let mut all = Vec::new();
        for recipe in recipes.iter() {
            for setup in [Setup::Within, Setup::Cross] {
                let reports = reports(&folder.join(&recipe.name), recipe, setup)?;
                let steps = recipes.steps(recipe, setup);
                let is_current = reports.first().is_none_or(|report| report.made_by == steps);
                all.push(Results { recipe, setup, reports, is_current });
            }
        }
        Ok(all)
    }

    /// The first solving attempts of a player on each fold.
    pub fn firsts(&self, player: Player) -> impl Iterator<Item = &[Option<usize>]> {
        self.reports.iter().filter_map(move |report| report.first_solved(player))
    }

    /// The first solving attempts of a player at the tasks of a template, on all folds that test it.
    pub fn of_template(&self, player: Player, template: usize) -> Vec<Option<usize>> {
        self.reports.iter().flat_map(|report| report.of_template(player, template)).collect()
    }
}

fn reports(folder: &Path, recipe: &Recipe, setup: Setup) -> anyhow::Result<Vec<Report>> {
    let mut reports: Vec<Report> = Vec::new();
    for fold in FoldId::all().filter(|fold| fold.setup == setup) {
        let path = folder.join(format!("{fold}.json"));
        if !path.exists() {
            continue;
        }
        let name = path.display();
        let report = Report::read(&path, COMMAND)?;
        ensure!(
            report.fold_id() == fold && recipe.rows.iter().all(|row| report.first_solved(row.player()).is_some()),
            "{name} does not hold the agents of the recipe {} on {fold}: remove it, and run `{COMMAND}`",
            recipe.name
        );
        let of = |report: &Report| {
            let Report { limit, seed, simulator, agents_version, made_by, .. } = report;
            (*limit, *seed, *simulator, *agents_version, made_by.clone())
        };
        if let Some(first) = reports.first() {
            ensure!(
                of(&report) == of(first),
                "{name} was made differently from {}.json (steps, seed, versions or number of tasks): remove one of \
                 them, and run `{COMMAND}`",
                first.fold_id()
            );
        }
        reports.push(report);
    }
    Ok(reports)
}

//! `pathlight-lab reproduce`

use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::Instant;

use anyhow::Context;
use clap::{Parser, ValueEnum};
use pathlight::benchmark::folds::{FOLDS, FoldId, Setup};
use pathlight::command_line::exit::unless_broken_pipe;
use pathlight::command_line::fold_args::{fold, setup};
use pathlight::command_line::replace_file::replace_file;
use pathlight_lab::files::json_file;
use pathlight_lab::measure::report::Report;
use pathlight_lab::progress::Progress;
use pathlight_lab::reproduce::recipes::{RECIPES, Recipe, Recipes, words};
use pathlight_lab::reproduce::{COMMAND, RESULTS, report};

use super::CommandLine;

/// Make all results by their recipes, then the table of results, continuing where an earlier run stopped
#[derive(clap::Args)]
pub struct Args {
    /// Do only this part
    #[arg(long, value_enum)]
    only: Option<Part>,

    /// Make only the results of this recipe, for example tasks; can be repeated
    #[arg(long = "recipe", value_name = "NAME")]
    names: Vec<String>,

    /// Use only folds of this setup
    #[arg(long, value_parser = setup())]
    setup: Option<Setup>,

    /// Use only this fold; can be repeated [default: all ten]
    #[arg(long = "fold", value_name = "FOLD", value_parser = fold)]
    folds: Vec<u8>,

    /// Folder of the results and the table
    #[arg(long, value_name = "DIR", default_value = RESULTS)]
    results: PathBuf,

    /// Folder of data and training runs, which recipes share
    #[arg(long, value_name = "DIR", default_value = "target/reproduce")]
    runs: PathBuf,

    /// Use the recipes in this file instead of lab/recipes.toml, in the same format
    #[arg(long, value_name = "FILE")]
    recipes: Option<PathBuf>,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Part {
    /// Training and evaluation: a JSON file per recipe, setup and fold
    Results,
    /// README.md with the table of the existing results
    Report,
}

impl Args {
    pub fn run(self, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let recipes = match &self.recipes {
            None => Recipes::parse(RECIPES)?,
            Some(path) => {
                let name = path.display();
                let text = fs::read_to_string(path).with_context(|| format!("cannot read {name}"))?;
                Recipes::parse(&text).with_context(|| format!("cannot use the recipes in {name}"))?
            }
        };
        let named = self.names.iter().map(|name| recipes.named(name)).collect::<anyhow::Result<Vec<&Recipe>>>()?;
        let asked: Vec<&Recipe> = if named.is_empty() { recipes.iter().collect() } else { named };
        if self.only != Some(Part::Report) {
            for fold in self.chosen_folds() {
                for recipe in &asked {
                    self.make(&recipes, recipe, fold, progress)?;
                }
            }
        }
        if self.only != Some(Part::Results) {
            // Write the file before printing, so that a closed pipe does not lose it.
            let text = report::text(&self.results, &recipes)?;
            replace_file(&self.results.join("README.md"), text.as_bytes())?;
            io::stdout().write_all(text.as_bytes())?;
        }
        Ok(())
    }

    /// Folds to make results for. Both setups of a fold are adjacent.
    fn chosen_folds(&self) -> Vec<FoldId> {
        let folds = if self.folds.is_empty() { (0..FOLDS).collect() } else { self.folds.clone() };
        let setups = self.setup.map_or(vec![Setup::Within, Setup::Cross], |setup| vec![setup]);
        folds.into_iter().flat_map(|fold| setups.iter().map(move |&setup| FoldId { setup, fold })).collect()
    }

    /// Makes the result of a recipe on a fold, unless its file exists.
    fn make(
        &self,
        recipes: &Recipes,
        recipe: &Recipe,
        fold: FoldId,
        progress: &mut dyn Progress,
    ) -> anyhow::Result<()> {
        let result = self.results.join(&recipe.name).join(format!("{fold}.json"));
        let steps = recipes.steps(recipe, fold.setup);
        if result.exists() {
            let is_current = Report::read(&result, COMMAND)?.made_by == steps;
            let note = if is_current { "" } else { ", made by an earlier recipe: remove it to make it again" };
            progress.say(&format!("{} exists{note}", result.display()));
            return Ok(());
        }
        let file = |ending| self.runs.join(format!("{}-{fold}.{ending}", recipe.name));
        let (measured, spent) = (file("json"), file("minutes"));
        let mut minutes = read_minutes(&spent)?;
        // Parse all steps before spending hours on the first.
        let commands = steps.iter().map(|step| {
            let words = words(step, fold, &self.runs, &measured);
            let line = format!("pathlight-lab {}", words.join(" "));
            let parsed = CommandLine::try_parse_from(std::iter::once("pathlight-lab".to_string()).chain(words));
            let parsed = parsed.with_context(|| format!("the recipe {} cannot be followed", recipe.name))?;
            Ok((line, parsed.command))
        });
        for (line, command) in commands.collect::<anyhow::Result<Vec<_>>>()? {
            progress.say(&format!("$ {line}"));
            let started = Instant::now();
            // The step has written its file before its table.
            unless_broken_pipe(command.run(progress))?;
            minutes += started.elapsed().as_secs_f64() * rayon::current_num_threads() as f64 / 60.0;
            json_file::write(Some(&spent), &minutes)?;
        }
        let mut report = Report::read(&measured, COMMAND)?;
        (report.made_by, report.core_minutes) = (steps, Some((10.0 * minutes).round() / 10.0));
        json_file::write(Some(&result), &report)?;
        progress.say(&format!("wrote {}", result.display()));
        Ok(())
    }
}

/// Reads the core-minutes that an interrupted run has spent on a result.
fn read_minutes(path: &Path) -> anyhow::Result<f64> {
    if path.exists() { json_file::read(path, COMMAND) } else { Ok(0.0) }
}

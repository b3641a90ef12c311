//! The recipes of `lab/recipes.toml`: how commands of this program make each row of the results.

use std::path::Path;

use anyhow::{Context, ensure};
use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::folds::{FoldId, Setup};
use serde::Deserialize;

use crate::measure::report::{Order, Player};

/// The recipes of the results in the repository.
pub const RECIPES: &str = include_str!("../../recipes.toml");

/// The recipes, in the order of the table.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Recipes {
    recipe: Vec<Recipe>,
}

/// How a folder of results is made.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Recipe {
    /// Name of the recipe and of the folder of its results.
    pub name: String,
    pub learns_from: String,
    /// The recipe whose steps, except its measurement, run first.
    pub after: Option<String>,
    #[serde(default)]
    steps: Vec<String>,
    #[serde(default)]
    within: Vec<String>,
    #[serde(default)]
    cross: Vec<String>,
    pub rows: Vec<Row>,
}

/// A row of the table.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Row {
    agent: AgentName,
    memory: Option<Order>,
    pub title: String,
}

impl Row {
    pub fn player(&self) -> Player {
        Player { agent: self.agent, memory: self.memory }
    }
}

impl Recipes {
    /// Parses recipes in the format of `RECIPES`.
    ///
    /// # Errors
    /// If the text has another format.
    pub fn parse(text: &str) -> anyhow::Result<Recipes> {
        let recipes: Recipes = toml::from_str(text)?;
        for (index, Recipe { name, after, rows, .. }) in recipes.recipe.iter().enumerate() {
            let is_above = |after: &String| recipes.recipe[..index].iter().any(|other| other.name == *after);
            ensure!(after.as_ref().is_none_or(is_above), "the recipe {name} must come below the one in its `after`");
            ensure!(!rows.is_empty(), "the recipe {name} has no rows: name the agents that it measures");
        }
        Ok(recipes)
    }

    pub fn iter(&self) -> impl Iterator<Item = &Recipe> {
        self.recipe.iter()
    }

    /// Finds a recipe by its name.
    ///
    /// # Errors
    /// If no recipe has this name.
    pub fn named(&self, name: &str) -> anyhow::Result<&Recipe> {
        let names = || self.iter().map(|recipe| recipe.name.as_str()).collect::<Vec<_>>().join(", ");
        let found = self.iter().find(|recipe| recipe.name == name);
        found.with_context(|| format!("there is no recipe {name}: name one of {}", names()))
    }

    /// The commands that make the results of a recipe in a setup, with placeholders for fold and files.
    pub fn steps(&self, recipe: &Recipe, setup: Setup) -> Vec<String> {
        let of_setup = if setup == Setup::Within { &recipe.within } else { &recipe.cross };
        let own = recipe.steps.iter().chain(of_setup).cloned();
        let before = recipe.after.as_ref().and_then(|after| self.named(after).ok());
        let before = before.map_or(Vec::new(), |before| self.steps(before, setup));
        without_measurements(&before).cloned().chain(own).collect()
    }
}

/// Leaves out the steps that measure.
pub fn without_measurements(steps: &[String]) -> impl Iterator<Item = &String> {
    steps.iter().filter(|step| !step.starts_with("measure "))
}

/// Splits a step into words and replaces its placeholders.
pub fn words(step: &str, fold: FoldId, runs: &Path, result: &Path) -> Vec<String> {
    let of = format!("--setup {} --fold {}", fold.setup, fold.fold);
    let with_files = |word: &str| {
        let word = word.replace("{fold}", &fold.to_string());
        word.replace("{runs}", &runs.display().to_string()).replace("{result}", &result.display().to_string())
    };
    step.replace("{of}", &of).split_whitespace().map(with_files).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_of_the_recipe_before_come_first_without_its_measurement() {
        let recipes = Recipes::parse(RECIPES).expect("our own");
        let steps = |name: &str| recipes.steps(recipes.named(name).expect("ours"), Setup::Cross);
        let (before, with_memory) = (steps("scenes"), steps("memory"));
        assert_eq!(with_memory[..before.len() - 1], before[..before.len() - 1]);
        assert!(with_memory.last().is_some_and(|step| step.contains("--memory")) && with_memory.len() == before.len());
    }

    #[test]
    fn words_name_fold_and_files() {
        let fold = FoldId { setup: Setup::Cross, fold: 3 };
        let step = "measure evaluate {of} --weights {runs}/{fold}/w --json {result}";
        let found = words(step, fold, Path::new("a folder"), Path::new("r.json")).join("|");
        assert_eq!(found, "measure|evaluate|--setup|cross|--fold|3|--weights|a folder/cross-3/w|--json|r.json");
    }
}

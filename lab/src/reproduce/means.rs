//! Means over folds, for the table and for the page.

use std::path::Path;

use pathlight::benchmark::auccess::auccess;
use pathlight::benchmark::folds::FOLDS;
use pathlight::puzzle::templates::TEMPLATES;
use serde::Serialize;

use super::Results;
use super::published::{BY_TEMPLATE, PUBLISHED, Published};
use super::recipes::{RECIPES, Recipes};
use crate::measure::report::Player;

/// The means of our agents and the published ones, as the page shows them.
#[derive(Serialize)]
pub struct Comparison {
    /// For each recipe, the auccess of its first row, within and cross; “–” unless all ten folds are measured.
    ours: Vec<(String, [String; 2])>,
    published: [Published; 5],
    /// Auccess of the paper's nets by template, within and cross: published, and ours; “–” where no fold tests it.
    paper: [[Vec<String>; 2]; 2],
}

/// Compares the results in a folder with the published ones.
///
/// # Errors
/// If results are damaged or do not belong together.
pub fn comparison(folder: &Path) -> anyhow::Result<Comparison> {
    let recipes = Recipes::parse(RECIPES)?;
    let results = Results::read(folder, &recipes)?;
    let ours = results.chunks_exact(2).map(|setups| {
        let recipe = setups[0].recipe;
        let of_setup = |results: &Results| {
            let whole = results.reports.len() == usize::from(FOLDS);
            if whole { mean(results, recipe.rows[0].player()) } else { "–".to_string() }
        };
        (recipe.name.clone(), [0, 1].map(|setup| of_setup(&setups[setup])))
    });
    let paper = results.chunks_exact(2).find(|setups| setups[0].recipe.name == "paper");
    let by_template = |setup: usize| {
        let ours = paper.map(|setups| auccess_by_template(&setups[setup], setups[setup].recipe.rows[0].player()));
        [BY_TEMPLATE[setup].split_whitespace().map(String::from).collect(), ours.unwrap_or_default()]
    };
    Ok(Comparison { ours: ours.collect(), published: PUBLISHED, paper: [0, 1].map(by_template) })
}

/// The mean and standard deviation of a player's auccess over the folds.
pub fn mean(results: &Results, player: Player) -> String {
    mean_and_deviation(&results.firsts(player).map(auccess).collect::<Vec<_>>())
}

/// The auccess on each template over the tasks of all folds that test it; “–” if none does.
pub fn auccess_by_template(results: &Results, player: Player) -> Vec<String> {
    let of_template = |number| {
        let firsts = results.of_template(player, number);
        if firsts.is_empty() { "–".to_string() } else { format!("{:.0}", auccess(&firsts)) }
    };
    TEMPLATES.iter().map(|template| of_template(template.number)).collect()
}

/// Formats the mean, and the sample standard deviation if there are several numbers.
pub fn mean_and_deviation(numbers: &[f64]) -> String {
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
    fn means_are_printed_with_their_deviation() {
        assert_eq!(mean_and_deviation(&[]), "–");
        assert_eq!(mean_and_deviation(&[50.0]), "50.0");
        assert_eq!(mean_and_deviation(&[1.0, 3.0]), "2.0 ± 1.4");
    }
}

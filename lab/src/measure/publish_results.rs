//! Collects the measurements of the shipped models in a small file that the page shows.
//!
//! For each model, the file holds the first solving attempt of every agent at every test task of its fold and the
//! calibration of its chances. It also holds the comparison with published figures.

use std::collections::BTreeMap;
use std::path::PathBuf;

use pathlight::benchmark::folds::Setup;
use pathlight::command_line::replace_file::replace_file;
use pathlight::puzzle::task::TaskId;
use serde::Serialize;

use super::calibration::{Bin, Calibration};
use super::report::Report;
use super::shipped::Shipped;
use crate::files::json_file;
use crate::training::publish::{ModelEntry, ModelList};

/// `results.json`.
#[derive(Serialize)]
struct Results<'a, T> {
    models: Vec<ModelResults>,
    /// The agents over all folds, compared with published figures.
    compared: &'a T,
}

#[derive(Serialize)]
struct ModelResults {
    name: String,
    setup: Setup,
    simulator: u32,
    agents_version: u32,
    /// All test tasks of the model's fold, ascending.
    tasks: Vec<TaskId>,
    /// The auccess of each agent, 0..=100.
    auccess: BTreeMap<String, f64>,
    /// For each agent, the first attempt that solved each task, from 1; null if none of a hundred did.
    first_solved: BTreeMap<String, Vec<Option<usize>>>,
    /// How often balls solve, in ten bins of their predicted chance: uniformly random balls, and the model's own
    /// candidates.
    calibration: BTreeMap<&'static str, Vec<Bin>>,
}

/// Writes `results.json` next to the weights of the models; returns its path.
///
/// # Errors
/// If a measurement is missing or does not belong to the weights, or the file cannot be written.
pub fn publish(shipped: &Shipped, compared: &impl Serialize) -> anyhow::Result<PathBuf> {
    let list = shipped.assets.join("model.json");
    let list: ModelList = json_file::read(&list, "pathlight-lab publish weights")?;
    let models = list.models.into_iter().map(|entry| results_of(shipped, entry)).collect::<anyhow::Result<_>>()?;
    let path = shipped.assets.join("results.json");
    let mut json = serde_json::to_vec(&Results { models, compared })?;
    json.push(b'\n');
    replace_file(&path, &json)?;
    Ok(path)
}

fn results_of(shipped: &Shipped, ModelEntry { name, .. }: ModelEntry) -> anyhow::Result<ModelResults> {
    let (report, fold) = shipped.read::<Report>(&name)?;
    let (calibration, _) = shipped.read::<Calibration>(&name)?;
    let first_solved = report.agents.iter().map(|score| (score.player.to_string(), score.first_solved.clone()));
    Ok(ModelResults {
        setup: report.setup,
        simulator: report.simulator,
        agents_version: report.agents_version,
        tasks: fold.tasks().test,
        auccess: report.agents.iter().map(|score| (score.player.to_string(), score.auccess)).collect(),
        first_solved: first_solved.collect(),
        calibration: [("random", calibration.random), ("candidates", calibration.candidates)].into(),
        name,
    })
}

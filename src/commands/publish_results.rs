//! `pathlight publish-results`: collects the measurements of the shipped models into the small file from which the page
//! shows them.
//!
//! For each model the first solving attempt of every agent on every test task of its fold, and the calibration of its
//! chances.

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::PathBuf;

use pathlight::benchmark::folds::Setup;
use pathlight::puzzle::task::TaskId;
use serde::Serialize;

use super::agent_name::AgentName;
use super::calibration::{Bin, Calibration};
use super::evaluate::Report;
use super::json_file;
use super::publish::{ModelEntry, ModelList};
use super::replace_file::replace_file;
use super::shipped::Shipped;

/// Collect the measurements of the shipped models into the file from which the page shows them
#[derive(clap::Args)]
pub struct Args {
    /// The folder of NAME.json, from `pathlight evaluate --json`, and NAME-calibration.json, from `pathlight
    /// calibration --json`
    #[arg(long, default_value = "results/shipped")]
    results: PathBuf,

    /// The folder that the page loads from, whose model.json names the models
    #[arg(long, default_value = "assets")]
    assets: PathBuf,
}

/// `results.json`.
#[derive(Serialize)]
struct Results {
    models: Vec<ModelResults>,
}

#[derive(Serialize)]
struct ModelResults {
    name: String,
    setup: Setup,
    simulator: u32,
    agents_version: u32,
    /// All test tasks of the model's fold, ascending.
    tasks: Vec<TaskId>,
    /// For each agent its auccess, 0..=100.
    auccess: BTreeMap<String, f64>,
    /// For each agent the first attempt that solved each task, from 1; null if none of a hundred did.
    first_solved: BTreeMap<String, Vec<Option<usize>>>,
    /// How often balls solve to which the model gives a chance, in ten bins of chances: uniformly random balls, and the
    /// model's own candidates.
    calibration: BTreeMap<&'static str, Vec<Bin>>,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let list: ModelList = json_file::read(&self.assets.join("model.json"), "pathlight publish")?;
        let models = list
            .models
            .into_iter()
            .map(|ModelEntry { name, .. }| self.results_of(name))
            .collect::<anyhow::Result<_>>()?;
        let path = self.assets.join("results.json");
        let mut json = serde_json::to_vec(&Results { models })?;
        json.push(b'\n');
        replace_file(&path, &json)?;
        writeln!(io::stdout(), "{}", path.display())?;
        Ok(())
    }

    fn results_of(&self, name: String) -> anyhow::Result<ModelResults> {
        let shipped = Shipped { measurements: &self.results, assets: &self.assets };
        let (report, fold) = shipped.read::<Report>(&name)?;
        let (calibration, _) = shipped.read::<Calibration>(&name)?;
        let label = |agent: AgentName| agent.to_string();
        Ok(ModelResults {
            setup: report.setup,
            simulator: report.simulator,
            agents_version: report.agents_version,
            tasks: fold.tasks().test,
            auccess: report.agents.iter().map(|score| (label(score.agent), score.auccess)).collect(),
            first_solved: report
                .agents
                .iter()
                .map(|score| (label(score.agent), score.first_solved.iter().map(|&(_, first)| first).collect()))
                .collect(),
            calibration: [("random", calibration.random), ("candidates", calibration.candidates)].into(),
            name,
        })
    }
}

//! `pathlight publish-results`: collects the measurements of the shipped models into the small file from which the page shows them.
//!
//! For each model the first solving attempt of every agent on every test task of its fold, and the calibration of its chances.

use std::collections::BTreeMap;
use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;

use anyhow::{Context, ensure};
use pathlight::agents;
use pathlight::benchmark::folds::Fold;
use pathlight::puzzle::task::TaskId;
use pathlight::simulator;
use serde::Serialize;

use super::agent_name::AgentName;
use super::calibration::{Bin, Calibration};
use super::evaluate::{Report, Score};
use super::json_file;
use super::publish::{ModelEntry, ModelList};

/// Collect the measurements of the shipped models into the file from which the page shows them
#[derive(clap::Args)]
pub struct Args {
    /// The folder of NAME.json, from `pathlight evaluate --json`, and NAME-calibration.json, from `pathlight calibration --json`
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
        fs::write(&path, json).with_context(|| format!("cannot write {}", path.display()))?;
        writeln!(io::stdout(), "{}", path.display())?;
        Ok(())
    }

    fn results_of(&self, name: String) -> anyhow::Result<ModelResults> {
        let report: Report = json_file::read(&self.results.join(format!("{name}.json")), "pathlight evaluate --json")?;
        let path = self.results.join(format!("{name}-calibration.json"));
        let calibration: Calibration = json_file::read(&path, "pathlight calibration --json")?;
        ensure!(
            (calibration.simulator, calibration.agents_version) == (report.simulator, report.agents_version)
                && (calibration.setup, calibration.fold) == (report.setup, report.fold),
            "{} does not belong to the evaluation beside it: measure it again with `pathlight calibration --json`",
            path.display()
        );
        let tasks = Fold::new(report.setup, report.fold).test;
        let all = |score: &Score| score.first_solved.iter().map(|(task, _)| task).eq(&tasks);
        ensure!(
            format!("{}-{}", report.setup, report.fold) == name
                && report.engine.is_first()
                && (report.simulator, report.agents_version) == (simulator::VERSION, agents::VERSION)
                && !report.agents.is_empty()
                && report.agents.iter().all(all),
            "the evaluation of {name} is not of all test tasks of its fold, or of another version: measure it again with `pathlight evaluate --json`"
        );
        ensure!(
            calibration.tasks == tasks.len(),
            "{} is not of all test tasks: measure it again with `pathlight calibration --json`",
            path.display()
        );
        let label = |agent: AgentName| agent.to_string();
        Ok(ModelResults {
            simulator: report.simulator,
            agents_version: report.agents_version,
            tasks,
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

//! The measurements of the models on the page. A measurement is matched to weights by their card, so new weights need
//! new measurements.

use std::fs;
use std::path::Path;

use anyhow::{Context, ensure};
use pathlight::agents;
use pathlight::benchmark::folds::FoldId;
use pathlight::nets::{Card, read_card};
use pathlight::puzzle::task::TaskId;
use pathlight::simulator;
use serde::de::DeserializeOwned;

use super::calibration::Calibration;
use super::report::Report;
use crate::files::json_file;

/// A measurement of a model, as stored in its `--json` file.
pub trait Measurement: DeserializeOwned {
    /// The subcommand of `measure` that makes it.
    const COMMAND: &'static str;
    /// Suffix of the file name, after the name of the model.
    const SUFFIX: &'static str;

    /// Card of the model, if one was measured.
    fn card(&self) -> Option<&Card>;

    /// Whether the measurement covers all these test tasks, with the current agents and simulator.
    fn is_complete(&self, test: &[TaskId]) -> bool;
}

impl Measurement for Report {
    const COMMAND: &'static str = "evaluate";
    const SUFFIX: &'static str = "";

    fn card(&self) -> Option<&Card> {
        self.card.as_ref()
    }

    fn is_complete(&self, test: &[TaskId]) -> bool {
        self.engine.is_first()
            && (self.simulator, self.agents_version) == (simulator::VERSION, agents::VERSION)
            && Report::is_complete(self)
            && self.agents.iter().all(|score| score.first_solved.len() == test.len())
    }
}

impl Measurement for Calibration {
    const COMMAND: &'static str = "calibration";
    const SUFFIX: &'static str = "-calibration";

    fn card(&self) -> Option<&Card> {
        Some(&self.card)
    }

    fn is_complete(&self, test: &[TaskId]) -> bool {
        (self.simulator, self.agents_version, self.tasks) == (simulator::VERSION, agents::VERSION, test.len())
    }
}

/// Folders of the measurements and of the weights that were measured.
pub struct Shipped<'a> {
    pub measurements: &'a Path,
    pub assets: &'a Path,
}

impl Shipped<'_> {
    /// Reads a measurement of a model, and the fold of the model.
    ///
    /// # Errors
    /// If the measurement or the weights are missing or damaged, or if they do not match: other weights, not all test
    /// tasks of the fold, or other versions of the agents or the simulator.
    pub fn read<M: Measurement>(&self, name: &str) -> anyhow::Result<(M, FoldId)> {
        let weights = self.assets.join(format!("{name}.safetensors"));
        let weights_name = weights.display();
        let bytes = fs::read(&weights).with_context(|| {
            format!("cannot read the weights in {weights_name}: write them with `pathlight-lab publish weights`")
        })?;
        let card = read_card(&bytes).with_context(|| format!("cannot use {weights_name}"))?;
        let fold = card.fold_id();
        let path = self.measurements.join(format!("{name}{}.json", M::SUFFIX));
        let file = path.display();
        let command = format!(
            "pathlight-lab measure {} --setup {} --fold {} --weights {} --json {}",
            M::COMMAND,
            fold.setup,
            fold.fold,
            weights.display(),
            path.display()
        );
        let measured: M = json_file::read(&path, &command)?;
        ensure!(
            measured.card() == Some(&card),
            "{file} does not belong to the weights in {weights_name}: measure them again with `{command}`"
        );
        ensure!(
            measured.is_complete(&fold.tasks().test),
            "{file} does not cover all test tasks of its fold, or is of another version: measure the model again \
             with `{command}`"
        );
        Ok((measured, fold))
    }
}

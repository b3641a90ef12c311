//! The measurements of the models on the page, which belong to the weights that the page has.

use std::fs;
use std::path::Path;

use anyhow::{Context, ensure};
use pathlight::agents;
use pathlight::nets::{Card, read_card};
use pathlight::simulator;
use serde::Deserialize;

use super::calibration::Calibration;
use super::evaluate::Report;
use super::fold_args::FoldArgs;
use super::forecasts::Forecasts;
use super::json_file;

/// The folders of the measurements, and of the weights that they are of.
pub struct Shipped<'a> {
    pub measurements: &'a Path,
    pub assets: &'a Path,
}

impl Shipped<'_> {
    /// Reads NAME.json, from `pathlight evaluate --json`.
    ///
    /// # Errors
    /// If it is missing or damaged, or is not that of these weights on all test tasks of their fold, with these agents and
    /// this simulator.
    pub fn evaluation(&self, name: &str) -> anyhow::Result<Report> {
        let report: Report =
            self.read(&format!("{name}.json"), name, "evaluate", |report: &Report| report.card.as_ref())?;
        let test = FoldArgs { setup: report.setup, fold: report.fold }.tasks().test;
        ensure!(
            report.engine.is_first()
                && (report.simulator, report.agents_version) == (simulator::VERSION, agents::VERSION)
                && report.agents.iter().all(|score| score.first_solved.iter().map(|(task, _)| task).eq(&test)),
            "the evaluation of {name} is not of all test tasks of its fold, or of another version: measure it again with \
             `pathlight evaluate --json`"
        );
        Ok(report)
    }

    /// Reads NAME-calibration.json, from `pathlight calibration --json`.
    ///
    /// # Errors
    /// As of `evaluation`.
    pub fn calibration(&self, name: &str) -> anyhow::Result<Calibration> {
        let file = format!("{name}-calibration.json");
        let calibration: Calibration = self.read(&file, name, "calibration", |one: &Calibration| Some(&one.card))?;
        ensure!(
            (calibration.simulator, calibration.agents_version) == (simulator::VERSION, agents::VERSION)
                && calibration.tasks == test_tasks(&calibration.card),
            "the calibration of {name} is not of all test tasks of its fold, or of another version: measure it again with \
             `pathlight calibration --json`"
        );
        Ok(calibration)
    }

    /// Reads NAME-forecasts.json, from `pathlight forecasts --json`.
    ///
    /// # Errors
    /// As of `evaluation`.
    pub fn forecasts(&self, name: &str) -> anyhow::Result<Forecasts> {
        let file = format!("{name}-forecasts.json");
        let forecasts: Forecasts = self.read(&file, name, "forecasts", |one: &Forecasts| Some(&one.card))?;
        ensure!(
            forecasts.simulator == simulator::VERSION && forecasts.tasks == test_tasks(&forecasts.card),
            "the forecasts of {name} are not of all test tasks of its fold, or of another version: measure them again with \
             `pathlight forecasts --json`"
        );
        Ok(forecasts)
    }

    /// Reads a measurement and checks which weights it is of.
    fn read<T: for<'a> Deserialize<'a>>(
        &self,
        file: &str,
        name: &str,
        command: &str,
        card: fn(&T) -> Option<&Card>,
    ) -> anyhow::Result<T> {
        let path = self.measurements.join(file);
        let weights = self.assets.join(format!("{name}.safetensors"));
        let (file, weights_name) = (path.display(), weights.display());
        let (setup, fold) =
            name.rsplit_once('-').with_context(|| format!("{name} is no model: the name is SETUP-FOLD"))?;
        let command = format!("pathlight {command} --setup {setup} --fold {fold} --json");
        let measured: T = json_file::read(&path, &command)?;
        let bytes = fs::read(&weights).with_context(|| {
            format!("cannot read the weights in {weights_name}: write them with `pathlight publish`")
        })?;
        let trained = read_card(&bytes).with_context(|| format!("cannot use {weights_name}"))?;
        ensure!(
            card(&measured) == Some(&trained),
            "{file} does not belong to the weights in {weights_name}: measure them again with `{command}`"
        );
        Ok(measured)
    }
}

/// The number of test tasks of the fold that weights belong to.
fn test_tasks(card: &Card) -> usize {
    FoldArgs { setup: card.setup, fold: card.fold }.tasks().test.len()
}

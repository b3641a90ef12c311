//! `pathlight-lab publish …`

use std::path::PathBuf;

use pathlight_lab::measure::publish_results;
use pathlight_lab::measure::shipped::Shipped;
use pathlight_lab::reproduce::{RESULTS, means};
use pathlight_lab::training::publish;

use super::print_paths;

#[derive(clap::Subcommand)]
pub enum Command {
    /// Copy trained weights, rounded, to the assets, where the page loads them from
    Weights {
        /// Weights files of `train paths`, `train success` or `train dynamics`; without any, only the list is rewritten
        weights: Vec<PathBuf>,

        /// The folder that the page loads weights from
        #[arg(long, default_value = "assets")]
        assets: PathBuf,
    },
    /// Collect the measurements of the shipped models into the file from which the page shows them
    Results {
        /// The folder of NAME.json, from `measure evaluate --json`, and NAME-calibration.json, from `measure
        /// calibration --json`
        #[arg(long, default_value = "results/shipped")]
        results: PathBuf,

        /// The folder of the results of `reproduce`, whose means stand beside published figures
        #[arg(long, value_name = "DIR", default_value = RESULTS)]
        main: PathBuf,

        /// The folder that the page loads from, whose model.json names the models
        #[arg(long, default_value = "assets")]
        assets: PathBuf,
    },
}

impl Command {
    pub fn run(self) -> anyhow::Result<()> {
        match self {
            Command::Weights { weights, assets } => print_paths(&publish::publish(&weights, &assets)?),
            Command::Results { results, main, assets } => {
                let shipped = Shipped { measurements: &results, assets: &assets };
                let compared = means::comparison(&main)?;
                print_paths(&[publish_results::publish(&shipped, &compared)?])
            }
        }
    }
}

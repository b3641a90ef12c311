//! `pathlight-lab publish …`

use std::path::PathBuf;

use pathlight_lab::measure::publish_results;
use pathlight_lab::measure::shipped::Shipped;
use pathlight_lab::reproduce::{RESULTS, means};
use pathlight_lab::training::publish;

use super::print_paths;

#[derive(clap::Subcommand)]
pub enum Command {
    /// Round trained weights and copy them to the assets, from which the page loads them
    Weights {
        /// Weights files from `train paths`, `train success` or `train dynamics`; if none, only the list is rewritten
        weights: Vec<PathBuf>,

        /// Folder that the page loads weights from
        #[arg(long, default_value = "assets")]
        assets: PathBuf,
    },
    /// Collect the measurements of the shipped models in the file that the page shows
    Results {
        /// Folder with NAME.json, from `measure evaluate --json`, and NAME-calibration.json, from `measure calibration
        /// --json`
        #[arg(long, default_value = "results/shipped")]
        results: PathBuf,

        /// Folder of the results of `reproduce`, whose means are compared with published figures
        #[arg(long, value_name = "DIR", default_value = RESULTS)]
        main: PathBuf,

        /// Folder that the page loads from; its model.json lists the models
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

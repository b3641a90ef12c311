//! `pathlight-lab figures`

use std::path::PathBuf;

use pathlight_lab::data::collect::SOLUTIONS;
use pathlight_lab::figures::Settings;
use pathlight_lab::reproduce::RESULTS;

use super::print_paths;

/// Draw the figures of the results: templates, what is imagined for some tasks, curves, bars and soft IoU by template
#[derive(clap::Args)]
pub struct Args {
    /// Folder of the results, with the folders shipped/ (models on the page) and paper/ (the paper's nets)
    #[arg(long, value_name = "DIR", default_value = RESULTS)]
    results: PathBuf,

    /// Solutions of all tasks, from `data collect`
    #[arg(long, default_value = SOLUTIONS)]
    solutions: PathBuf,

    /// The folder of the weights of the models on the page
    #[arg(long, value_name = "DIR", default_value = "assets")]
    assets: PathBuf,

    /// The folder of the figures [default: figures/ in that of the results]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let Args { results, solutions, assets, out } = self;
        let out = out.unwrap_or_else(|| results.join("figures"));
        print_paths(&Settings { results, solutions, assets, out }.draw()?)
    }
}

//! `pathlight-lab figures`

use std::path::PathBuf;

use pathlight_lab::figures::Settings;
use pathlight_lab::reproduce::RESULTS;

use super::print_paths;

/// Draw the figures of the models on the page: what they imagine for some tasks, and the tasks solved within k attempts
#[derive(clap::Args)]
pub struct Args {
    /// Folder of the results, with the folder shipped/
    #[arg(long, value_name = "DIR", default_value = RESULTS)]
    results: PathBuf,

    /// The folder of the weights of the models on the page
    #[arg(long, value_name = "DIR", default_value = "assets")]
    assets: PathBuf,

    /// The folder of the figures [default: figures/ in that of the results]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let Args { results, assets, out } = self;
        let out = out.unwrap_or_else(|| results.join("figures"));
        print_paths(&Settings { results, assets, out }.draw()?)
    }
}

//! `pathlight-lab figures`

use std::path::PathBuf;

use pathlight_lab::figures::Settings;
use pathlight_lab::reproduce::RESULTS;

use super::print_paths;

/// Draw figures of the models on the page: imagined maps and paths for some tasks, and tasks solved within k attempts
#[derive(clap::Args)]
pub struct Args {
    /// Folder of the results, which contains shipped/
    #[arg(long, value_name = "DIR", default_value = RESULTS)]
    results: PathBuf,

    /// Folder with the weights of the models on the page
    #[arg(long, value_name = "DIR", default_value = "assets")]
    assets: PathBuf,

    /// Folder to write the figures to [default: figures/ in the folder of the results]
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

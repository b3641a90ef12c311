//! The argument that names DQN's weights, and the check that a fold may use them.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, ensure};
use pathlight::nets::{Dqn, DqnCard};

use super::fold_args::FoldArgs;

/// A file of DQN's weights; part of the arguments of other commands.
#[derive(clap::Args)]
pub struct DqnArgs {
    /// Weights of DQN, the benchmark's baseline [default for --agent dqn:
    /// target/train/SETUP-FOLD/dqn/weights.safetensors]
    #[arg(long, value_name = "FILE")]
    pub dqn: Option<PathBuf>,
}

impl DqnArgs {
    /// The net of a fold, and how it was trained.
    ///
    /// # Errors
    /// If the file cannot be read, or its net was trained on another fold and so may know the test tasks of this.
    pub fn load(&self, fold: &FoldArgs) -> anyhow::Result<(Dqn, DqnCard)> {
        let path = self.dqn.clone().unwrap_or_else(|| fold.folder().join("dqn/weights.safetensors"));
        let name = path.display();
        let bytes = fs::read(&path).with_context(|| {
            format!("cannot read DQN's weights in {name}: run `pathlight train-dqn`, or name a file with --dqn")
        })?;
        let (net, card) = Dqn::load(&bytes)
            .with_context(|| format!("cannot use {name} as DQN's weights, which `pathlight train-dqn` writes"))?;
        ensure!(
            card.setup == fold.setup && card.fold == fold.fold,
            "{name} was trained on {} {}, so it may have seen the test tasks of {} {}: use other weights",
            card.setup,
            card.fold,
            fold.setup,
            fold.fold
        );
        Ok((net, card))
    }
}

//! The arguments that name a model's weights, and the check that a fold may use them.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, ensure};
use pathlight::nets::{Card, PathNet};

use super::fold_args::FoldArgs;

/// A file of weights; part of the arguments of other commands.
#[derive(clap::Args)]
pub struct ModelArgs {
    /// Weights of the model [default: assets/SETUP-FOLD.safetensors]
    #[arg(long)]
    pub weights: Option<PathBuf>,
}

impl ModelArgs {
    /// The nets of a fold, and how they were trained.
    ///
    /// # Errors
    /// If the file cannot be read, or its nets were trained on another fold and so may know the test tasks of this.
    pub fn load(&self, &FoldArgs { setup, fold }: &FoldArgs) -> anyhow::Result<(PathNet, Card)> {
        let path = self.weights.clone().unwrap_or_else(|| format!("assets/{setup}-{fold}.safetensors").into());
        let name = path.display();
        let bytes = fs::read(&path).with_context(|| {
            format!("cannot read the weights in {name}: run `pathlight train`, or name a file with --weights")
        })?;
        let (nets, card) = PathNet::load(&bytes).with_context(|| format!("cannot use {name}"))?;
        ensure!(
            card.setup == setup && card.fold == fold,
            "{name} was trained on {} {}, so it may have seen the test tasks of {setup} {fold}: use other weights",
            card.setup,
            card.fold
        );
        Ok((nets, card))
    }
}

//! Weights files on disk: which one belongs to a fold, and whether it may be used there.

use std::fs;
use std::path::PathBuf;

use anyhow::{Context, ensure};
use pathlight::nets::{Card, PathNet, flex};

use super::fold_args::FoldArgs;

/// Where a fold's weights come from; part of the arguments of other commands.
#[derive(clap::Args)]
pub struct ModelArgs {
    /// Weights of the model [default: assets/SETUP-FOLD.safetensors]
    #[arg(long)]
    weights: Option<PathBuf>,
}

impl ModelArgs {
    /// The nets of a fold. Weights of another fold have seen its test tasks, so they are refused.
    pub fn load(&self, &FoldArgs { setup, fold }: &FoldArgs) -> anyhow::Result<(PathNet, Card)> {
        let path = self.weights.clone().unwrap_or_else(|| format!("assets/{setup}-{fold}.safetensors").into());
        let name = path.display();
        let bytes = fs::read(&path)
            .with_context(|| format!("no weights in {name}: run `pathlight train`, or name a file with --weights"))?;
        let (nets, card) = PathNet::load(&bytes, &flex()).with_context(|| format!("{name} does not fit"))?;
        ensure!(
            card.setup == setup && card.fold == fold,
            "{name} was trained on {} {}, so it may have seen the test tasks of {setup} {fold}: name other weights",
            card.setup,
            card.fold
        );
        Ok((nets, card))
    }
}

//! The arguments that name the weights of a model and of DQN.

use std::path::PathBuf;
use std::{fs, path};

use anyhow::Context;
use pathlight::benchmark::folds::FoldId;
use pathlight::nets::{Dqn, PathNet};
use pathlight::puzzle::hex::hex;
use sha2::{Digest, Sha256};

/// A model's weights file, to include in a command's arguments.
#[derive(clap::Args)]
pub struct ModelArgs {
    /// Weights of the model [default: assets/SETUP-FOLD.safetensors]
    #[arg(long)]
    weights: Option<PathBuf>,
}

impl ModelArgs {
    /// Loads the nets of a fold.
    ///
    /// # Errors
    ///
    /// If the file cannot be read, or its nets were trained on another fold and may therefore have seen this fold's
    /// test tasks.
    pub fn load(&self, fold: FoldId) -> anyhow::Result<PathNet> {
        Ok(self.load_with_digest(fold)?.0)
    }

    /// Loads the nets of a fold. Also returns the SHA-256 of their file in hexadecimal.
    ///
    /// # Errors
    ///
    /// The same as those of `load`.
    pub fn load_with_digest(&self, fold: FoldId) -> anyhow::Result<(PathNet, String)> {
        let default = || path::absolute(format!("assets/{fold}.safetensors"));
        let path = self.weights.clone().map_or_else(default, Ok)?;
        let name = path.display();
        let bytes = fs::read(&path).with_context(|| {
            format!(
                "cannot read the weights in {name}: run this in Pathlight's folder, which has those of fold 0, or \
                 name a file that `pathlight-lab train paths` has written with --weights"
            )
        })?;
        let (nets, card) = PathNet::load(&bytes).with_context(|| format!("cannot use {name}"))?;
        card.fold_id().check(fold).with_context(|| format!("cannot use {name}"))?;
        Ok((nets, hex(Sha256::digest(&bytes))))
    }
}

/// DQN's weights file, to include in a command's arguments.
#[derive(clap::Args)]
pub struct DqnArgs {
    /// Weights of DQN, the benchmark's baseline [default for --agent dqn:
    /// target/train/SETUP-FOLD/dqn/weights.safetensors]
    #[arg(long, value_name = "FILE")]
    dqn: Option<PathBuf>,
}

impl DqnArgs {
    /// Loads the net of a fold.
    ///
    /// # Errors
    ///
    /// The same as those of `ModelArgs::load`.
    pub fn load(&self, fold: FoldId) -> anyhow::Result<Dqn> {
        let path = self.dqn.clone().unwrap_or_else(|| format!("target/train/{fold}/dqn/weights.safetensors").into());
        let name = path.display();
        let bytes = fs::read(&path).with_context(|| {
            format!("cannot read DQN's weights in {name}: run `pathlight-lab train dqn`, or name a file with --dqn")
        })?;
        let (net, card) = Dqn::load(&bytes)
            .with_context(|| format!("cannot use {name} as DQN's weights, which `pathlight-lab train dqn` writes"))?;
        card.fold_id().check(fold).with_context(|| format!("cannot use {name}"))?;
        Ok(net)
    }
}

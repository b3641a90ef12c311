//! The weights files that commands read: those of a model, and DQN's.

use std::path::{Path, PathBuf};
use std::{fs, path};

use anyhow::Context;
use sha2::{Digest, Sha256};

use crate::agents::agent_name::{AgentName, Needs};
use crate::benchmark::folds::FoldId;
use crate::nets::{Card, Dqn, DqnCard, PathNet};
use crate::puzzle::hex::hex;

/// The nets of a weights file.
pub struct ModelFile {
    /// The nets.
    pub nets: PathNet,
    /// How they were trained.
    pub card: Card,
    /// SHA-256 of the file, in hexadecimal.
    pub digest: String,
    path: PathBuf,
}

impl ModelFile {
    /// Reads a file; without a path, the weights of a fold in `assets/`. The nets may be those of another fold, and may
    /// lack what an agent needs: `check` finds out.
    ///
    /// # Errors
    ///
    /// If the file cannot be read, or is not a weights file.
    pub fn read(path: Option<&Path>, fold: FoldId) -> anyhow::Result<ModelFile> {
        // An absolute path shows where the default was looked for.
        let default = || path::absolute(format!("assets/{fold}.safetensors"));
        let path = path.map_or_else(default, |path| Ok(path.to_path_buf()))?;
        let name = path.display();
        let bytes = fs::read(&path).with_context(|| {
            format!(
                "cannot read the weights in {name}: run this in Pathlight's folder, which has those of fold 0, or \
                 name a file from `pathlight-lab train` with --weights"
            )
        })?;
        let (nets, card) = PathNet::load(&bytes).with_context(|| format!("cannot use {name}"))?;
        Ok(ModelFile { nets, card, digest: hex(Sha256::digest(&bytes)), path })
    }

    /// Checks that the file has the net that an agent needs, and that this net has seen no test task of a fold.
    ///
    /// # Errors
    ///
    /// If the net is missing, or may have seen one.
    pub fn check(&self, agent: AgentName, fold: FoldId) -> anyhow::Result<()> {
        let cannot_use = || format!("cannot use {}", self.path.display());
        let dynamics = self.card.dynamics.as_ref().filter(|_| agent.needs() == Needs::Dynamics);
        if !dynamics.is_some_and(|card| card.learned_from.serves_all_folds(fold.setup)) {
            self.card.fold_id().check(fold).with_context(cannot_use)?;
        }
        agent.check(&self.nets).with_context(cannot_use)
    }
}

/// Returns the default folder of the training runs of a fold.
pub fn training_folder(fold: FoldId) -> PathBuf {
    format!("target/train/{fold}").into()
}

/// Reads the DQN of a fold and its card; without a path, from the default folder.
///
/// # Errors
///
/// If the file cannot be read, or its net was trained on another fold and may have seen this fold's test tasks.
pub fn read_dqn(path: Option<&Path>, fold: FoldId) -> anyhow::Result<(Dqn, DqnCard)> {
    let path = path.map_or_else(|| training_folder(fold).join("dqn/weights.safetensors"), Path::to_path_buf);
    let name = path.display();
    let bytes = fs::read(&path).with_context(|| {
        format!("cannot read DQN's weights in {name}: run `pathlight-lab train dqn`, or name a file with --dqn")
    })?;
    let (net, card) = Dqn::load(&bytes)
        .with_context(|| format!("cannot use {name} as DQN's weights: name a file from `pathlight-lab train dqn`"))?;
    card.fold_id().check(fold).with_context(|| format!("cannot use {name}"))?;
    Ok((net, card))
}

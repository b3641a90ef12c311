//! Weights files. They are loaded only for the fold that they were trained on.

use std::fs;
use std::path::{Path, PathBuf};

use anyhow::Context;
use pathlight::benchmark::folds::FoldId;
use pathlight::nets::{Card, Dqn, DqnCard, PathNet};

/// Returns the default folder of the training runs of a fold.
pub fn training_folder(fold: FoldId) -> PathBuf {
    format!("target/train/{fold}").into()
}

/// Returns the file that `load_nets` reads: the shipped weights if none is named.
pub fn weights_path(path: Option<&Path>, fold: FoldId) -> PathBuf {
    path.map_or_else(|| format!("assets/{fold}.safetensors").into(), Path::to_path_buf)
}

/// Reads the nets of a fold and their card; without a path, the shipped ones.
///
/// # Errors
/// If the file cannot be read, or its nets were trained on another fold and so may have seen this fold's test tasks.
pub fn load_nets(path: Option<&Path>, fold: FoldId) -> anyhow::Result<(PathNet, Card)> {
    let path = weights_path(path, fold);
    let (nets, card) = load_nets_of_any_fold(&path)?;
    card.fold_id().check(fold).with_context(|| format!("cannot use {}", path.display()))?;
    Ok((nets, card))
}

/// Reads nets and their card; without a path, the shipped ones. The dynamics net belongs to this fold or serves all
/// folds of its setup; in the latter case, the other nets may belong to another fold.
///
/// # Errors
/// Same as for `load_nets`.
pub fn load_nets_for_dynamics(path: Option<&Path>, fold: FoldId) -> anyhow::Result<(PathNet, Card)> {
    let path = weights_path(path, fold);
    let (nets, card) = load_nets_of_any_fold(&path)?;
    if !card.dynamics.as_ref().is_some_and(|dynamics| dynamics.learned_from.serves_all_folds(fold.setup)) {
        card.fold_id().check(fold).with_context(|| format!("cannot use {}", path.display()))?;
    }
    Ok((nets, card))
}

/// Reads nets and their card. The caller checks which tasks they may have seen.
///
/// # Errors
/// If the file cannot be read.
pub fn load_nets_of_any_fold(path: &Path) -> anyhow::Result<(PathNet, Card)> {
    let name = path.display();
    let bytes = fs::read(path).with_context(|| {
        format!("cannot read the weights in {name}: train nets with `pathlight-lab train`, or name another file")
    })?;
    PathNet::load(&bytes).with_context(|| format!("cannot use {name}"))
}

/// Reads the DQN of a fold and its card; without a path, from the default folder.
///
/// # Errors
/// Same as for `load_nets`.
pub fn load_dqn(path: Option<&Path>, fold: FoldId) -> anyhow::Result<(Dqn, DqnCard)> {
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

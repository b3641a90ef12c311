//! The common part of all training: nets, their optimiser, and a step on losses. A trainer can be saved between two
//! batches and resumed with the same result. The caller chooses the learning rate of each step. The batches and losses
//! of the nets are in `paths`, `success`, `dynamics` and `dqn`.

use std::path::Path;

use burn::module::Module;
use burn::optim::{GradientsParams, ModuleOptimizer};
use burn::store::RecordError;
use burn::tensor::{Device, Tensor};

use super::adam::FusedAdam;
use super::muon::muon_and_adam;
use crate::nets::{Optimiser, flex};

/// A module that can be trained: `PathNet`, `SuccessNet`, `DynamicsNet` or `Dqn`.
pub trait Trainable: Module {}

impl<M: Module> Trainable for M {}

/// Why a checkpoint cannot be written or read.
#[derive(Debug, thiserror::Error)]
#[error(transparent)]
pub struct CheckpointError(#[from] RecordError);

/// Nets in training, and their optimiser.
pub struct Trainer<M> {
    pub(super) nets: M,
    optimiser: ModuleOptimizer,
    pub(super) device: Device,
}

impl<M: Trainable> Trainer<M> {
    /// Returns the same trainer with another optimiser. It must not have taken a step yet.
    pub fn with_optimiser(self, optimiser: Optimiser) -> Trainer<M> {
        let optimiser = match optimiser {
            Optimiser::Adam => FusedAdam.into(),
            Optimiser::Muon => muon_and_adam(),
        };
        Trainer { optimiser, ..self }
    }

    /// Returns a trainer that starts from these nets, with a fresh optimiser.
    pub fn from_nets(nets: M) -> Trainer<M> {
        Trainer { nets: nets.train(), optimiser: FusedAdam.into(), device: flex().autodiff() }
    }

    pub(super) fn fresh(seed: u64, new: impl FnOnce(&Device) -> M) -> Trainer<M> {
        let device = flex().autodiff();
        device.seed(seed);
        Trainer { nets: new(&device), optimiser: FusedAdam.into(), device }
    }

    /// Takes one optimiser step on the sum of the losses; returns the separate losses.
    pub(super) fn backward_step(&mut self, losses: Tensor<1>, learning_rate: f64) -> Vec<f32> {
        let gradients = GradientsParams::from_grads(losses.clone().sum().backward(), &self.nets);
        self.nets = self.optimiser.step(learning_rate, self.nets.clone(), gradients);
        losses.into_data().iter::<f32>().collect()
    }

    /// Returns the current nets, without autodiff.
    pub fn nets(&self) -> M {
        self.nets.valid()
    }

    /// Writes the nets and the optimiser to two files.
    ///
    /// # Errors
    ///
    /// If a file cannot be written.
    pub fn save(&self, nets: &Path, optimiser: &Path) -> Result<(), CheckpointError> {
        self.nets.clone().save_file(nets)?;
        Ok(self.optimiser.save(optimiser)?)
    }

    /// Replaces the nets and the optimiser by those that `save` wrote.
    ///
    /// # Errors
    ///
    /// If a file cannot be read or does not fit.
    pub fn restore(self, nets: &Path, optimiser: &Path) -> Result<Trainer<M>, CheckpointError> {
        let Trainer { nets: fresh, optimiser: idle, device } = self;
        Ok(Trainer { nets: fresh.try_load_file(nets)?, optimiser: idle.load(optimiser)?, device })
    }
}

//! Training the four nets jointly: one optimiser, one loss, a batch at a time.
//!
//! The loss is the sum of the four maps' per-pixel cross-entropies, with gradients through the whole chain (Harter
//! et al. 2020). A trainer can be saved between two batches and goes on with the same result. Used by `train`
//! and the benchmark; native only.

use std::path::Path;

use burn::module::Module;
use burn::optim::{GradientsParams, ModuleOptimizer};
use burn::store::RecordError;
use burn::tensor::activation::relu;
use burn::tensor::{Device, Tensor, TensorData};

use super::PathNet;
use super::adam::FusedAdam;
use crate::raster::{Bitmap, CHANNELS, SIDE};
use crate::samples::Sample;

/// Nets and their optimiser.
pub struct Trainer {
    nets: PathNet,
    optimiser: ModuleOptimizer,
    device: Device,
}

/// Some samples as tensors' numbers: `[samples, 5, 64, 64]` of scenes and `[samples, 4, 64, 64]` of pictures to
/// imagine.
pub struct Batch {
    samples: usize,
    scene: Vec<f32>,
    imagined: Vec<f32>,
}

impl Batch {
    /// The samples, each as it is or mirrored left to right.
    pub fn new<'a>(samples: impl Iterator<Item = (&'a Sample, bool)>) -> Batch {
        let mut batch = Batch { samples: 0, scene: Vec::new(), imagined: Vec::new() };
        let numbers = |pictures: &[Bitmap], mirrored: bool, out: &mut Vec<f32>| {
            out.extend(pictures.iter().flat_map(|picture| picture.turned(mirrored).numbers()));
        };
        for (sample, mirrored) in samples {
            numbers(&sample.scene, mirrored, &mut batch.scene);
            numbers(&sample.imagined, mirrored, &mut batch.imagined);
            batch.samples += 1;
        }
        batch
    }
}

impl Trainer {
    /// Fresh nets on a device, their weights drawn from the seed.
    pub fn new(device: Device, seed: u64) -> Trainer {
        let device = device.autodiff();
        device.seed(seed);
        Trainer { nets: PathNet::new(&device), optimiser: FusedAdam.into(), device }
    }

    /// One step on a batch at a learning rate; gives the losses of the four maps.
    pub fn step(&mut self, batch: Batch, rate: f64) -> [f32; 4] {
        let tensor = |numbers: Vec<f32>, channels: usize| {
            Tensor::<4>::from_data(TensorData::new(numbers, [batch.samples, channels, SIDE, SIDE]), &self.device)
        };
        let maps = self.nets.forward(tensor(batch.scene, CHANNELS));
        let wanted = tensor(batch.imagined, 4).chunk(4, 1);
        let losses: Vec<Tensor<1>> =
            maps.into_iter().zip(wanted).map(|(map, wanted)| cross_entropy(map, wanted)).collect();
        let losses = Tensor::cat(losses, 0);
        let gradients = GradientsParams::from_grads(losses.clone().sum().backward(), &self.nets);
        self.nets = self.optimiser.step(rate, self.nets.clone(), gradients);
        let numbers: Vec<f32> = losses.into_data().iter::<f32>().collect();
        numbers.try_into().expect("four maps")
    }

    /// The nets as they are now, ready to imagine.
    pub fn nets(&self) -> PathNet {
        self.nets.valid()
    }

    /// Writes nets and optimiser to two files.
    ///
    /// # Errors
    /// Says which file cannot be written.
    pub fn save(&self, nets: &Path, optimiser: &Path) -> Result<(), RecordError> {
        self.nets.clone().save_file(nets)?;
        self.optimiser.save(optimiser)
    }

    /// Goes on from what `save` wrote.
    ///
    /// # Errors
    /// Says what is wrong with the files.
    pub fn restore(self, nets: &Path, optimiser: &Path) -> Result<Trainer, RecordError> {
        let Trainer { nets: fresh, optimiser: idle, device } = self;
        Ok(Trainer { nets: fresh.try_load_file(nets)?, optimiser: idle.load(optimiser)?, device })
    }
}

/// Mean over the pixels of the cross-entropy between logits and pictures of 0 and 1. `[batch, 1, 64, 64]` in,
/// `[1]` out.
fn cross_entropy(logits: Tensor<4>, wanted: Tensor<4>) -> Tensor<1> {
    // ln(1 + e^x) written so that no x overflows.
    let softplus = relu(logits.clone()) + logits.clone().abs().neg().exp().log1p();
    (softplus - logits * wanted).mean()
}

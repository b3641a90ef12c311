//! Training the four nets jointly: one optimiser, one loss, a batch at a time.
//!
//! The loss is the sum of the four maps' per-pixel cross-entropies, with gradients through the whole chain (Harter
//! et al. 2020). A trainer can be saved between two batches and goes on with the same result. Used by `train`
//! and the benchmark; native only.

use std::path::Path;

/// What a trainer trains: `PathNet`, `Judge`.
pub use burn::module::Module;
use burn::optim::{GradientsParams, ModuleOptimizer};
use burn::store::RecordError;
use burn::tensor::activation::relu;
use burn::tensor::{Device, Int, Tensor, TensorData};

use super::adam::FusedAdam;
use crate::dataset::samples::Sample;
use crate::nets::judge::{self, RADII};
use crate::nets::{Judge, PathNet};
use crate::puzzle::action::Ball;
use crate::puzzle::scene::SIZE;
use crate::raster::{Bitmap, CELLS, CHANNELS, SIDE};

/// Nets, all four or the judge, and their optimiser.
pub struct Trainer<M> {
    nets: M,
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
            out.extend(pictures.iter().flat_map(|picture| flipped(picture, mirrored).to_f32()));
        };
        for (sample, mirrored) in samples {
            numbers(&sample.scene, mirrored, &mut batch.scene);
            numbers(&sample.imagined, mirrored, &mut batch.imagined);
            batch.samples += 1;
        }
        batch
    }
}

/// Some scenes with balls that were tried: `[scenes, 5, 64, 64]`, and for each ball its index among the logits
/// `[scenes, RADII, 64, 64]` and 1 if it solved, else 0.
#[derive(Default)]
pub struct Trials {
    scenes: usize,
    scene: Vec<f32>,
    indices: Vec<i64>,
    solved: Vec<f32>,
}

impl Trials {
    /// Adds a scene and balls that were tried in it, as they are or mirrored left to right.
    pub fn add(&mut self, scene: &[Bitmap; CHANNELS], balls: &[(Ball, bool)], mirrored: bool) {
        self.scene.extend(scene.iter().flat_map(|picture| flipped(picture, mirrored).to_f32()));
        for &(ball, solved) in balls {
            let mirror = Ball { x: SIZE - ball.x, ..ball };
            let index = judge::index(if mirrored { mirror } else { ball });
            self.indices.push((self.scenes * RADII * CELLS + index) as i64);
            self.solved.push(if solved { 1.0 } else { 0.0 });
        }
        self.scenes += 1;
    }
}

fn flipped(image: &Bitmap, mirrored: bool) -> Bitmap {
    if mirrored { image.mirrored() } else { *image }
}

impl Trainer<PathNet> {
    /// Fresh nets on a device, their weights drawn from the seed.
    pub fn new(device: Device, seed: u64) -> Trainer<PathNet> {
        Trainer::begin(device, seed, PathNet::new)
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
        self.descend(Tensor::cat(losses, 0), rate).try_into().expect("four maps")
    }
}

impl Trainer<Judge> {
    /// A fresh judge on a device, its weights drawn from the seed.
    pub fn new(device: Device, seed: u64) -> Trainer<Judge> {
        Trainer::begin(device, seed, Judge::new)
    }

    /// One step on some scenes and their balls at a learning rate; gives the mean cross-entropy of a ball.
    pub fn step(&mut self, trials: Trials, rate: f64) -> f32 {
        let shape = [trials.scenes, CHANNELS, SIDE, SIDE];
        let logits = self.nets.forward(Tensor::from_data(TensorData::new(trials.scene, shape), &self.device));
        let balls = trials.indices.len();
        let indices = Tensor::<1, Int>::from_data(TensorData::new(trials.indices, [balls]), &self.device);
        let logits = logits.reshape([-1]).select(0, indices);
        let solved = Tensor::<1>::from_data(TensorData::new(trials.solved, [balls]), &self.device);
        self.descend(cross_entropy(logits, solved), rate)[0]
    }
}

impl<M: Module> Trainer<M> {
    fn begin(device: Device, seed: u64, fresh: impl FnOnce(&Device) -> M) -> Trainer<M> {
        let device = device.autodiff();
        device.seed(seed);
        Trainer { nets: fresh(&device), optimiser: FusedAdam.into(), device }
    }

    /// Goes on with these nets instead.
    pub fn with(self, nets: M) -> Trainer<M> {
        Trainer { nets: nets.train(), ..self }
    }

    /// A step down the sum of the losses, which it gives.
    fn descend(&mut self, losses: Tensor<1>, rate: f64) -> Vec<f32> {
        let gradients = GradientsParams::from_grads(losses.clone().sum().backward(), &self.nets);
        self.nets = self.optimiser.step(rate, self.nets.clone(), gradients);
        losses.into_data().iter::<f32>().collect()
    }

    /// The nets as they are now, ready to imagine.
    pub fn nets(&self) -> M {
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
    pub fn restore(self, nets: &Path, optimiser: &Path) -> Result<Trainer<M>, RecordError> {
        let Trainer { nets: fresh, optimiser: idle, device } = self;
        Ok(Trainer { nets: fresh.try_load_file(nets)?, optimiser: idle.load(optimiser)?, device })
    }
}

/// Mean cross-entropy between logits and numbers of 0 and 1 of the same shape. `[1]` out.
fn cross_entropy<const D: usize>(logits: Tensor<D>, wanted: Tensor<D>) -> Tensor<1> {
    // ln(1 + e^x) written so that no x overflows.
    let softplus = relu(logits.clone()) + logits.clone().abs().neg().exp().log1p();
    (softplus - logits * wanted).mean()
}

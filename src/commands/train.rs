//! `pathlight train`: the four nets trained jointly on the solutions of a fold's training tasks.
//!
//! One optimiser, one loss: the sum of the four maps' per-pixel cross-entropies, with gradients through the
//! whole chain (Harter et al. 2020). The run lives in a folder (checkpoint, losses, weights) from which it goes
//! on if it was cut off, with the same result. Beside `pathnet` the only user of burn.

use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use burn::module::Module;
use burn::optim::{AdamConfig, GradientsParams, ModuleOptimizer};
use burn::tensor::activation::relu;
use burn::tensor::{Device, Tensor, TensorData};
use pathlight::pathnet::{Card, PathNet, device};
use pathlight::raster::{Bitmap, CELLS, CHANNELS, SIDE};
use pathlight::samples::Sample;
use pathlight::simulator;
use pathlight::solutions::Solution;
use rand::seq::SliceRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use super::collect::read_solutions;
use super::progress::Progress;
use super::scenes::Scenes;
use super::which::Which;

/// Train the four nets on the training tasks of a fold
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    which: Which,

    /// Solutions to train on, from `pathlight collect`
    #[arg(long, default_value = "target/solutions.jsonl")]
    solutions: PathBuf,

    /// Folder of the run: checkpoint, losses.csv, weights.safetensors [default: target/train/SETUP-FOLD]
    #[arg(long)]
    out: Option<PathBuf>,

    /// Passes over the samples
    #[arg(long, default_value_t = 10)]
    epochs: usize,

    /// Samples in a batch
    #[arg(long, default_value_t = 32, value_parser = clap::value_parser!(u16).range(1..))]
    batch: u16,

    /// Learning rate of Adam
    #[arg(long, default_value_t = 3e-3)]
    rate: f64,

    /// Show half of the samples mirrored left to right: PHYRE's world is symmetric
    #[arg(long)]
    mirror: bool,

    /// Batches between two checkpoints, and between two lines of losses
    #[arg(long, value_name = "BATCHES", default_value_t = 100, value_parser = clap::value_parser!(u16).range(1..))]
    checkpoint: u16,

    /// End this run after so many batches, at a checkpoint; the same command goes on from there
    #[arg(long, value_name = "BATCHES")]
    stop_after: Option<usize>,

    /// Seed of the initial weights and of the order of the samples
    #[arg(long, default_value_t = 0)]
    seed: u64,

    /// What the nets run on: flex or ndarray
    #[arg(long, default_value = "flex")]
    device: String,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let name = format!("target/train/{}-{}", self.which.setup, self.which.fold);
        let folder = self.out.clone().unwrap_or_else(|| PathBuf::from(name));
        fs::create_dir_all(&folder).with_context(|| format!("cannot make {}", folder.display()))?;
        let (samples, card) = self.samples()?;
        let device = device(&self.device).map_err(anyhow::Error::msg)?.autodiff();
        device.seed(self.seed);
        let mut run = Run::open(&folder, &card, &device)?;
        let batches = samples.len().div_ceil(self.batch.into());
        let total = batches * self.epochs;
        let mut progress = Progress::new(Some(total as u64));
        progress.advance(run.done as u64, format!("batch {}", run.done));
        let interval = usize::from(self.checkpoint);
        let stop = self.stop_after.map_or(usize::MAX, |batches| run.done + batches);
        let mut sums = [0.0; 4];
        while run.done < total {
            let epoch = run.done / batches;
            let order = self.order(samples.len(), epoch);
            for chosen in order.chunks(self.batch.into()).skip(run.done % batches) {
                let losses = run.step(&samples, chosen, self.rate, &device);
                for (sum, loss) in sums.iter_mut().zip(losses) {
                    *sum += loss / f32::from(self.checkpoint);
                }
                if run.done.is_multiple_of(interval) {
                    run.save(&folder, &card, epoch, sums)?;
                    let so_far = format!("batch {} of {total}, placement loss {:.4}", run.done, sums[3]);
                    progress.advance(interval as u64, so_far);
                    sums = [0.0; 4];
                    if run.done >= stop {
                        progress.finish(&format!("batch {} of {total}: stopped as told", run.done));
                        return Ok(());
                    }
                }
            }
        }
        let weights = folder.join("weights.safetensors");
        fs::write(&weights, run.nets.valid().save(&card))
            .with_context(|| format!("cannot write {}", weights.display()))?;
        progress.finish(&format!("{total} batches; weights are in {},", weights.display()));
        Ok(())
    }

    /// The samples of the fold's training tasks, and what they were made with.
    fn samples(&self) -> anyhow::Result<(Vec<Sample>, Card)> {
        let tasks = self.which.tasks().all_train();
        let (solutions, version) = read_solutions(&self.solutions)?;
        ensure!(
            version == simulator::VERSION,
            "the solutions are of simulator {version}, this is simulator {}: collect them again",
            simulator::VERSION
        );
        let mut chosen: Vec<Solution> =
            solutions.into_iter().filter(|solution| tasks.binary_search(&solution.task).is_ok()).collect();
        ensure!(!chosen.is_empty(), "{} holds no solutions of this fold", self.solutions.display());
        chosen.sort_by_key(|solution| solution.task);
        let scenes = Scenes::new();
        eprintln!("drawing {} solutions", chosen.len());
        let samples = chosen
            .par_iter()
            .map(|solution| Ok(Sample::new(scenes.get(solution.task)?, solution.ball)?))
            .collect::<anyhow::Result<Vec<Sample>>>()?;
        let card = Card {
            setup: self.which.setup,
            fold: self.which.fold,
            seed: self.seed,
            epochs: self.epochs,
            batch: self.batch,
            rate: self.rate,
            mirror: self.mirror,
            samples: samples.len(),
            tasks: chosen.chunk_by(|a, b| a.task == b.task).count(),
            simulator: version,
        };
        Ok((samples, card))
    }

    /// The order of the samples in an epoch, and whether each is mirrored.
    fn order(&self, samples: usize, epoch: usize) -> Vec<(usize, bool)> {
        let mut rng = Pcg64Mcg::seed_from_u64(self.seed.wrapping_mul(1000).wrapping_add(epoch as u64));
        let mut order: Vec<_> = (0..samples).map(|sample| (sample, self.mirror && rng.random())).collect();
        order.shuffle(&mut rng);
        order
    }
}

/// A training run: nets, optimiser, and how many batches they have seen.
struct Run {
    nets: PathNet,
    optimiser: ModuleOptimizer,
    done: usize,
    /// The batch of the checkpoint that is on disk.
    kept: Option<usize>,
}

const NETS: &str = "checkpoint-nets.bpk";
const OPTIMISER: &str = "checkpoint-adam.bpk";
const STATE: &str = "checkpoint.json";

impl Run {
    /// The run of a folder: its checkpoint, or a fresh start.
    fn open(folder: &Path, card: &Card, device: &Device) -> anyhow::Result<Run> {
        let (nets, optimiser) = (PathNet::new(device), AdamConfig::new().with_epsilon(1e-8).init());
        let Ok(state) = fs::read(folder.join(STATE)) else {
            fs::write(folder.join("losses.csv"), "epoch,batch,base,target,action,placement,sum\n")?;
            return Ok(Run { nets, optimiser, done: 0, kept: None });
        };
        let (found, done): (Card, usize) =
            serde_json::from_slice(&state).with_context(|| format!("{} is damaged: remove it", folder.display()))?;
        ensure!(
            found == *card,
            "{} holds a run with {found:?}, now it is {card:?}: name another folder with --out",
            folder.display()
        );
        let nets = nets.try_load_file(folder.join(format!("{done}-{NETS}")))?;
        let optimiser = optimiser.load(folder.join(format!("{done}-{OPTIMISER}")))?;
        Ok(Run { nets, optimiser, done, kept: Some(done) })
    }

    /// One batch; gives the losses of the four maps.
    fn step(&mut self, samples: &[Sample], chosen: &[(usize, bool)], rate: f64, device: &Device) -> [f32; 4] {
        let pictures = |of: fn(&Sample) -> &[Bitmap], channels: usize| {
            let mut numbers = Vec::with_capacity(chosen.len() * channels * CELLS);
            for &(sample, mirrored) in chosen {
                let pictures = of(&samples[sample]).iter();
                numbers.extend(pictures.flat_map(|picture| picture.turned(mirrored).numbers()));
            }
            Tensor::<4>::from_data(TensorData::new(numbers, [chosen.len(), channels, SIDE, SIDE]), device)
        };
        let scene = pictures(|sample| &sample.scene, CHANNELS);
        let wanted = pictures(|sample| &sample.imagined, 4).chunk(4, 1);
        let maps = self.nets.forward(scene);
        let losses: Vec<Tensor<1>> =
            maps.into_iter().zip(wanted).map(|(map, wanted)| cross_entropy(map, wanted)).collect();
        let losses = Tensor::cat(losses, 0);
        let gradients = GradientsParams::from_grads(losses.clone().sum().backward(), &self.nets);
        self.nets = self.optimiser.step(rate, self.nets.clone(), gradients);
        self.done += 1;
        let numbers: Vec<f32> = losses.into_data().iter::<f32>().collect();
        numbers.try_into().expect("four maps")
    }

    /// Writes the checkpoint and a line of losses. The state is written last and names the files, so that a run
    /// cut off in between goes on from the checkpoint before.
    fn save(&mut self, folder: &Path, card: &Card, epoch: usize, losses: [f32; 4]) -> anyhow::Result<()> {
        let done = self.done;
        self.nets.clone().save_file(folder.join(format!("{done}-{NETS}")))?;
        self.optimiser.save(folder.join(format!("{done}-{OPTIMISER}")))?;
        let state = folder.join(STATE);
        fs::write(folder.join("next.json"), serde_json::to_vec(&(card, done))?)?;
        fs::rename(folder.join("next.json"), state)?;
        if let Some(before) = self.kept.replace(done) {
            for name in [NETS, OPTIMISER] {
                fs::remove_file(folder.join(format!("{before}-{name}")))?;
            }
        }
        let [base, target, action, placement] = losses;
        let sum: f32 = losses.iter().sum();
        let line = format!("{epoch},{done},{base:.5},{target:.5},{action:.5},{placement:.5},{sum:.5}\n");
        OpenOptions::new().append(true).open(folder.join("losses.csv"))?.write_all(line.as_bytes())?;
        Ok(())
    }
}

/// Mean over the pixels of the cross-entropy between logits and pictures of 0 and 1. `[batch, 1, 64, 64]` in,
/// `[1]` out.
fn cross_entropy(logits: Tensor<4>, wanted: Tensor<4>) -> Tensor<1> {
    // ln(1 + e^x) written so that no x overflows.
    let softplus = relu(logits.clone()) + logits.clone().abs().neg().exp().log1p();
    (softplus - logits * wanted).mean()
}

//! One optimiser step of the four nets: the sum of the per-pixel binary cross-entropies of their maps, with gradients
//! through the whole chain (Harter et al. 2020).

use burn::tensor::{Tensor, TensorData};

use super::cross_entropy::binary_cross_entropy_with_logits;
use super::trainer::Trainer;
use crate::nets::PathNet;
use crate::raster::{Bitmap, CHANNELS, SIDE};

/// The images of a scene and a ball that solves it: nine images of 512 bytes.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// Input of the nets: green object, blue goal, purple goal, gray, black.
    pub scene: [Bitmap; CHANNELS],
    /// Target maps: base path, target path, action path, placement.
    pub targets: [Bitmap; 4],
}

/// Samples as tensor data: scenes `[samples, 5, 64, 64]` and target maps `[samples, 4, 64, 64]`.
pub struct PathsBatch {
    samples: usize,
    scenes: Vec<f32>,
    targets: Vec<f32>,
}

impl PathsBatch {
    /// Collects the samples, each unchanged or mirrored left to right.
    pub fn new<'a>(samples: impl Iterator<Item = (&'a Sample, bool)>) -> PathsBatch {
        let mut batch = PathsBatch { samples: 0, scenes: Vec::new(), targets: Vec::new() };
        for (sample, mirrored) in samples {
            extend(&mut batch.scenes, &sample.scene, mirrored);
            extend(&mut batch.targets, &sample.targets, mirrored);
            batch.samples += 1;
        }
        batch
    }
}

/// Appends images as values of 0 and 1.
fn extend(values: &mut Vec<f32>, images: &[Bitmap], mirrored: bool) {
    for image in images {
        let image = if mirrored { image.mirrored() } else { *image };
        for row in image.rows() {
            values.extend_from_slice(&row);
        }
    }
}

impl Trainer<PathNet> {
    /// Returns a trainer of fresh nets, whose weights depend only on the seed.
    pub fn new(seed: u64) -> Trainer<PathNet> {
        Trainer::fresh(seed, PathNet::new)
    }

    /// Takes one optimiser step on a batch; returns the losses of the four maps.
    pub fn step(&mut self, batch: PathsBatch, learning_rate: f64) -> [f32; 4] {
        let tensor = |values: Vec<f32>, channels: usize| {
            Tensor::<4>::from_data(TensorData::new(values, [batch.samples, channels, SIDE, SIDE]), &self.device)
        };
        let logits = self.nets.forward(tensor(batch.scenes, CHANNELS));
        let targets = tensor(batch.targets, 4).chunk(4, 1);
        let losses: Vec<Tensor<1>> = logits
            .into_iter()
            .zip(targets)
            .map(|(map, target)| binary_cross_entropy_with_logits(map, target))
            .collect();
        self.backward_step(Tensor::cat(losses, 0), learning_rate).try_into().expect("four maps")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::action::Ball;
    use crate::raster::ball_image;

    /// A scene that is not its own mirror image, with the same image in all channels.
    fn scene() -> [Bitmap; CHANNELS] {
        [ball_image(Ball { x: 60.0, y: 100.0, r: 20.0 }); CHANNELS]
    }

    fn mirror(images: &[f32]) -> Vec<f32> {
        images.chunks(SIDE).flat_map(|row| row.iter().rev()).copied().collect()
    }

    #[test]
    fn scenes_and_targets_are_mirrored_together() {
        let target = ball_image(Ball { x: 200.0, y: 30.0, r: 9.0 });
        let sample = Sample { scene: scene(), targets: [target; 4] };
        let (plain, flipped) =
            (PathsBatch::new([(&sample, false)].into_iter()), PathsBatch::new([(&sample, true)].into_iter()));
        assert_eq!(flipped.scenes, mirror(&plain.scenes));
        assert_eq!(flipped.targets, mirror(&plain.targets));
        assert_ne!(flipped.targets, plain.targets);
    }
}

//! Gaussian process classification, one outcome at a time (Csató and Opper 2002, "Sparse On-Line Gaussian Processes";
//! Rasmussen and Williams 2006, chapter 3).
//!
//! The logit of the chance that a ball solves is a latent function of an input, here the ball and its imagined path.
//! The function is a Gaussian process, with the net's logit as its prior mean and a covariance that falls with the
//! distance between two inputs. An outcome therefore changes the logits of all balls whose inputs resemble the observed
//! one. Each outcome is one Laplace step: the mode and the curvature of the posterior along the observed logit give a
//! rank-one update. Deterministic: sums have a fixed order, and no function depends on the platform. Used by `online`.

use super::sigmoid;

/// How often to halve the interval that holds the mode. It begins as wide as the variance and ends narrower than f64
/// can resolve.
const HALVINGS: usize = 60;

/// The prior covariance of the logits of two inputs.
pub trait Kernel {
    /// The input to compare.
    type Input: Copy;

    /// Many inputs, arranged for fast comparison with one more.
    type Inputs;

    /// Arranges inputs.
    fn arrange(&self, inputs: &[Self::Input]) -> Self::Inputs;

    /// Returns the prior covariances of the logits of all `inputs` with the logit of `with`.
    fn covariances(&self, inputs: &Self::Inputs, with: &Self::Input) -> Vec<f64>;

    /// Returns the prior covariance of the logits of two inputs.
    fn covariance(&self, a: &Self::Input, b: &Self::Input) -> f64;
}

/// The logits of a set of candidates, given the outcomes observed so far.
pub struct GaussianProcessClassifier<K: Kernel> {
    kernel: K,
    inputs: K::Inputs,
    prior: Vec<f64>,
    means: Vec<f64>,
    observations: Vec<RankOne<K::Input>>,
}

/// One observation: means = prior + Σ gain · covariances, covariance = kernel − Σ weight · covariances · covariancesᵀ.
struct RankOne<I> {
    input: I,
    gain: f64,
    weight: f64,
    /// Its covariance with each candidate, given the observations before it.
    covariances: Vec<f64>,
    /// Its covariance with each observation before it, given the observations before that one.
    with_earlier: Vec<f64>,
}

impl<K: Kernel> GaussianProcessClassifier<K> {
    /// Creates the prior from the mean logit and the input of each candidate.
    pub fn new(kernel: K, prior: Vec<f64>, inputs: &[K::Input]) -> GaussianProcessClassifier<K> {
        assert_eq!(prior.len(), inputs.len(), "an input for each candidate");
        let inputs = kernel.arrange(inputs);
        GaussianProcessClassifier { kernel, means: prior.clone(), prior, inputs, observations: Vec::new() }
    }

    /// Returns the posterior mean of each candidate's logit.
    pub fn means(&self) -> &[f64] {
        &self.means
    }

    /// Updates the logits with the outcome of a candidate, whose actual input turned out to be `input`. Returns the
    /// change of each candidate's mean logit.
    pub fn observe(&mut self, candidate: usize, input: K::Input, solved: bool) -> Vec<f64> {
        let mut mean = self.prior[candidate];
        let mut variance = self.kernel.covariance(&input, &input);
        let mut with_earlier: Vec<f64> = Vec::with_capacity(self.observations.len());
        for earlier in &self.observations {
            let prior = self.kernel.covariance(&earlier.input, &input);
            let shared = prior - self.explained(&with_earlier, &earlier.with_earlier);
            mean += earlier.gain * shared;
            variance -= earlier.weight * shared * shared;
            with_earlier.push(shared);
        }
        let (gain, weight) = laplace_step(mean, variance.max(0.0), solved);
        let mut covariances = self.kernel.covariances(&self.inputs, &input);
        for (earlier, shared) in self.observations.iter().zip(&with_earlier) {
            let explained = earlier.weight * shared;
            for (covariance, with_candidate) in covariances.iter_mut().zip(&earlier.covariances) {
                *covariance -= explained * with_candidate;
            }
        }
        let rises: Vec<f64> = covariances.iter().map(|covariance| gain * covariance).collect();
        self.means.iter_mut().zip(&rises).for_each(|(mean, rise)| *mean += rise);
        self.observations.push(RankOne { input, gain, weight, covariances, with_earlier });
        rises
    }

    /// Returns how much of the covariance of two inputs the first observations explain. `a` and `b` hold the
    /// covariances of each input with these observations.
    fn explained(&self, a: &[f64], b: &[f64]) -> f64 {
        self.observations.iter().zip(a.iter().zip(b)).map(|(earlier, (a, b))| earlier.weight * a * b).sum()
    }
}

/// Returns the derivative of the log likelihood at the mode of the posterior of one logit, and the weight of the
/// rank-one update of the covariance: w / (1 + w variance), where w is the curvature there.
fn laplace_step(mean: f64, variance: f64, solved: bool) -> (f64, f64) {
    let target = if solved { 1.0 } else { 0.0 };
    // The mode is where logit = mean + variance (target − sigmoid(logit)), whose right side falls. Newton's method
    // would need safeguards: from a large logit it oscillates.
    let mut low = mean - variance * (1.0 - target);
    let mut high = mean + variance * target;
    for _ in 0..HALVINGS {
        let middle = (low + high) / 2.0;
        if middle < mean + variance * (target - sigmoid(middle)) { low = middle } else { high = middle }
    }
    let chance = sigmoid(low);
    let curvature = chance * (1.0 - chance);
    (target - chance, curvature / (1.0 + curvature * variance))
}

#[cfg(test)]
mod tests {
    use super::super::squared_exponential::{Points, SquaredExponential};
    use super::*;

    const KERNEL: SquaredExponential = SquaredExponential { variance: 9.0, length_scale: 2.0 };

    impl Kernel for SquaredExponential {
        type Input = f32;
        type Inputs = Points;

        fn arrange(&self, inputs: &[f32]) -> Points {
            Points::new(&inputs.iter().map(|x| [*x]).collect::<Vec<_>>())
        }

        fn covariances(&self, inputs: &Points, with: &f32) -> Vec<f64> {
            self.of_all(inputs, &[*with])
        }

        fn covariance(&self, a: &f32, b: &f32) -> f64 {
            self.of(&[*a], &[*b])
        }
    }

    /// The mode maximizes prior times likelihood on a fine grid.
    #[test]
    fn one_failure_moves_its_own_logit_to_the_mode_of_its_posterior() {
        for prior in [-6.0, 0.0, 1.5, 7.0] {
            let mut process = GaussianProcessClassifier::new(KERNEL, vec![prior], &[0.0]);
            process.observe(0, 0.0, false);
            let log_posterior = |logit: f64| {
                -(logit - prior) * (logit - prior) / (2.0 * KERNEL.variance) - libm::log1p(libm::exp(logit))
            };
            let grid = (-30_000..30_000).map(|step| f64::from(step) / 1000.0);
            let mode = grid.max_by(|a, b| log_posterior(*a).total_cmp(&log_posterior(*b))).expect("a grid");
            assert!((process.means()[0] - mode).abs() < 2e-3, "{prior}: {} {mode}", process.means()[0]);
        }
    }

    #[test]
    fn the_nearer_an_input_is_to_a_failure_the_more_it_falls() {
        let inputs: Vec<f32> = (0..6).map(|x| 1.5 * x as f32).collect();
        let mut process = GaussianProcessClassifier::new(KERNEL, vec![2.0; 6], &inputs);
        let rises = process.observe(0, 0.0, false);
        assert!(rises.windows(2).all(|pair| pair[0] < pair[1]), "{rises:?}");
        assert!(rises[0] < -1.0 && rises[5] > -0.05, "{rises:?}");
        assert!(process.means().iter().zip(&rises).all(|(mean, rise)| (mean - 2.0 - rise).abs() < 1e-12));
        let solved = process.observe(5, 7.5, true);
        assert!(solved[5] > solved[3] && solved[5] > 0.0);
    }

    /// The rank-one updates agree with those of the dense covariance matrix.
    #[test]
    fn many_outcomes_leave_what_a_dense_covariance_leaves() {
        let inputs: Vec<f32> = (0..9).map(|x| x as f32 * 0.7).collect();
        let prior: Vec<f64> = (0..9).map(|x| 1.0 - 0.3 * f64::from(x)).collect();
        let mut process = GaussianProcessClassifier::new(KERNEL, prior.clone(), &inputs);
        let mut dense: Vec<Vec<f64>> =
            inputs.iter().map(|a| inputs.iter().map(|b| KERNEL.covariance(a, b)).collect()).collect();
        let mut means = prior;
        for (candidate, solved) in [(0, false), (4, false), (1, true), (8, false), (4, false), (2, false)] {
            process.observe(candidate, inputs[candidate], solved);
            let column: Vec<f64> = dense.iter().map(|row| row[candidate]).collect();
            let (gain, weight) = laplace_step(means[candidate], column[candidate], solved);
            for (index, row) in dense.iter_mut().enumerate() {
                means[index] += gain * column[index];
                row.iter_mut()
                    .zip(&column)
                    .for_each(|(value, covariance)| *value -= weight * column[index] * covariance);
            }
            for (mean, expected) in process.means().iter().zip(&means) {
                assert!((mean - expected).abs() < 1e-9, "{:?} {means:?}", process.means());
            }
        }
    }
}

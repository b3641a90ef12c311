//! The optimiser of a training, as an argument.

use clap::ValueEnum;
use pathlight::nets::Optimiser;

/// The name of an optimiser.
#[derive(Clone, Copy, Default, ValueEnum)]
pub enum OptimiserName {
    #[default]
    Adam,
    /// Muon for the weights of the layers, Adam for all else: learns more in the same number of batches
    Muon,
}

impl From<OptimiserName> for Optimiser {
    fn from(name: OptimiserName) -> Optimiser {
        match name {
            OptimiserName::Adam => Optimiser::Adam,
            OptimiserName::Muon => Optimiser::Muon,
        }
    }
}

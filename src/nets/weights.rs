//! Weights files: safetensors in half precision or in one byte per weight (`stored_parameter`), with a card of the
//! training settings in the metadata.
//!
//! The names of the tensors are the paths of the parameters in `PathNet` (`base.down.0.weight`). A file that does not
//! fit is refused, and the error names the tensor. Does no file or network I/O.
//!
//! burn-store's `SafetensorsStore` writes the same names, but converts to half precision without checking the range,
//! and accepts any type of number. Here, a file must fit exactly.

use std::collections::{BTreeMap, HashMap};

use burn::module::{Module, ModuleMapper, Param};
use burn::tensor::{Device, Tensor, TensorData};
use half::f16;
use safetensors::tensor::{Dtype, SafeTensors};
use serde::Serialize;
use serde::de::DeserializeOwned;

use super::parameters::{Parameter, parameters};
use super::stored_parameter::{read, stored};
use super::{Card, DynamicsNet, PathNet, SuccessNet};
#[cfg(not(target_arch = "wasm32"))]
use super::{Dqn, DqnCard, flex};

/// The key of the card in the file's metadata.
const CARD: &str = "pathlight";

/// Why weights cannot be loaded or saved.
#[derive(Debug, thiserror::Error)]
#[allow(missing_docs, reason = "the messages say it")]
pub enum WeightsError {
    #[error("not a safetensors file ({0}): download or train the weights again")]
    NotSafetensors(safetensors::SafeTensorError),
    #[error("the file does not record how it was trained: train weights with `pathlight-lab train`")]
    NoCard,
    #[error("the card of the weights cannot be read ({0}): they belong to other nets, or must be trained again")]
    BadCard(serde_json::Error),
    #[error("the file and its card disagree about the {0}: download or train the weights again")]
    OtherNets(&'static str),
    #[error("the weights lack `{0}`: they belong to other nets")]
    Missing(String),
    #[error(
        "`{name}` has shape {:?} and type {}, but the nets expect {:?} and {}: the weights belong to other nets",
        .found.0, .found.1, .expected.0, .expected.1
    )]
    ShapeMismatch { name: String, found: (Vec<usize>, Dtype), expected: (Vec<usize>, Dtype) },
    #[error("`{name}` has the type {dtype}, which the nets do not read: save the weights as F16")]
    OtherType { name: String, dtype: Dtype },
    #[error("`{name}` names the value {index}, which does not exist: download or train the weights again")]
    Outlier { name: String, index: u32 },
    #[error("`{0}` holds a number that is not finite: download or train the weights again")]
    NotFinite(String),
    #[error("the weights have {0} unknown tensors: they belong to other nets")]
    Extra(usize),
    #[error(
        "`{name}` holds {value}, which half precision cannot represent: the training diverged, repeat it with a lower learning rate"
    )]
    Unrepresentable { name: String, value: f32 },
}

impl PathNet {
    pub(super) fn load_on(bytes: &[u8], device: &Device) -> Result<(PathNet, Card), WeightsError> {
        let card = read_card(bytes)?;
        let file = SafeTensors::deserialize(bytes).map_err(WeightsError::NotSafetensors)?;
        let mut nets = PathNet::new(device);
        let has = |net: &str| file.names().iter().any(|name| name.starts_with(net));
        for (net, is_there, is_on_card) in [
            ("success net", has("success."), card.success.is_some()),
            ("dynamics net", has("dynamics."), card.dynamics.is_some()),
        ] {
            if is_there != is_on_card {
                return Err(WeightsError::OtherNets(net));
            }
        }
        nets.success = card.success.as_ref().map(|_| SuccessNet::new(device));
        nets.dynamics = card.dynamics.as_ref().map(|_| DynamicsNet::new(device));
        Ok((load(nets, &file, device)?, card))
    }

    /// Returns the bytes of a weights file of these nets.
    ///
    /// # Errors
    /// If a parameter is NaN, infinite or beyond the range of half precision.
    pub fn save(&self, card: &Card) -> Result<Vec<u8>, WeightsError> {
        save(self, card)
    }
}

#[cfg(not(target_arch = "wasm32"))]
impl Dqn {
    /// Returns the net of a weights file, and its card.
    ///
    /// # Errors
    /// If the bytes are not a weights file of this net.
    pub fn load(bytes: &[u8]) -> Result<(Dqn, DqnCard), WeightsError> {
        let card = card_of(bytes)?;
        let file = SafeTensors::deserialize(bytes).map_err(WeightsError::NotSafetensors)?;
        let device = flex();
        Ok((load(Dqn::new(&device), &file, &device)?, card))
    }

    /// Returns the bytes of a weights file of this net.
    ///
    /// # Errors
    /// If a parameter is NaN, infinite or beyond the range of half precision.
    pub fn save(&self, card: &DqnCard) -> Result<Vec<u8>, WeightsError> {
        save(self, card)
    }
}

/// Replaces all parameters of fresh nets by those of a file.
fn load<M: Module>(nets: M, file: &SafeTensors, device: &Device) -> Result<M, WeightsError> {
    let mut loader = Loader { file, device, path: Vec::new(), loaded: 0, error: None };
    let nets = nets.map(&mut loader);
    let extra = file.len().saturating_sub(loader.loaded);
    match loader.error {
        Some(error) => Err(error),
        None if extra > 0 => Err(WeightsError::Extra(extra)),
        None => Ok(nets),
    }
}

/// Returns the bytes of a file of these nets.
fn save(nets: &impl Module, card: &impl Serialize) -> Result<Vec<u8>, WeightsError> {
    let mut tensors = BTreeMap::new();
    for (name, Parameter { shape, values }) in parameters(nets) {
        if let Some(&value) = values.iter().find(|&&value| !f16::from_f32(value).is_finite()) {
            return Err(WeightsError::Unrepresentable { name, value });
        }
        let halves: Vec<f16> = values.into_iter().map(f16::from_f32).collect();
        tensors.extend(stored(&name, shape, &halves));
    }
    let card = serde_json::to_string(card).expect("a card is plain data");
    Ok(safetensors::serialize(tensors, Some(HashMap::from([(CARD.to_string(), card)])))
        .expect("names and sizes come from the nets"))
}

/// Returns the card of a weights file without loading its nets.
///
/// # Errors
/// If the bytes are not a weights file.
pub fn read_card(bytes: &[u8]) -> Result<Card, WeightsError> {
    card_of(bytes)
}

/// Returns the card of a file, for the nets that it should belong to.
fn card_of<C: DeserializeOwned>(bytes: &[u8]) -> Result<C, WeightsError> {
    let (_, header) = SafeTensors::read_metadata(bytes).map_err(WeightsError::NotSafetensors)?;
    let card = header.metadata().as_ref().and_then(|metadata| metadata.get(CARD)).ok_or(WeightsError::NoCard)?;
    serde_json::from_str(card).map_err(WeightsError::BadCard)
}

/// Replaces every parameter by that of the file.
struct Loader<'a> {
    file: &'a SafeTensors<'a>,
    device: &'a Device,
    path: Vec<String>,
    /// Number of tensors of the file that were loaded.
    loaded: usize,
    error: Option<WeightsError>,
}

impl Loader<'_> {
    /// Returns the values of the current parameter.
    fn read(&mut self, shape: &[usize]) -> Result<Vec<f32>, WeightsError> {
        let name = self.path.join(".");
        let (values, tensors) = read(self.file, &name, shape)?;
        self.loaded += tensors;
        Ok(values)
    }
}

impl ModuleMapper for Loader<'_> {
    fn enter_module(&mut self, name: &str, _: &str) {
        self.path.push(name.to_string());
    }

    fn exit_module(&mut self, _: &str, _: &str) {
        self.path.pop();
    }

    fn map_float<const D: usize>(&mut self, param: Param<Tensor<D>>) -> Param<Tensor<D>> {
        // Reading its value would first initialise the parameter at random.
        let shape = param.lazy_shape();
        match self.read(&shape) {
            Ok(values) => {
                let id = param.id;
                let tensor = Tensor::from_data(TensorData::new(values, shape), self.device);
                param.transform_for_load(tensor, id)
            }
            Err(error) => {
                self.error.get_or_insert(error);
                param
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::benchmark::folds::Setup;

    /// Sets the biases, the parameters of one dimension, to a value.
    struct SetBiases(f32);

    impl ModuleMapper for SetBiases {
        fn map_float<const D: usize>(&mut self, param: Param<Tensor<D>>) -> Param<Tensor<D>> {
            if D == 1 { param.map(|tensor| tensor.zeros_like() + self.0) } else { param }
        }
    }

    #[test]
    fn parameters_beyond_half_precision_are_neither_saved_nor_loaded() {
        let card = Card {
            setup: Setup::Within,
            fold: 0,
            seed: 0,
            epochs: 1,
            batch: 1,
            learning_rate: 1.0,
            decay_epochs: 0,
            mirror: false,
            without_dev: false,
            samples: 1,
            tasks: 1,
            simulator: 0,
            success: None,
            dynamics: None,
        };
        let saved = |value: f32| PathNet::fresh(0).map(&mut SetBiases(value)).save(&card);
        assert!(saved(f16::MAX.to_f32()).is_ok());
        for value in [1e5, -1e5, f32::INFINITY, f32::NAN] {
            let error = saved(value).expect_err("half precision has no such number");
            assert!(matches!(error, WeightsError::Unrepresentable { .. }), "{error}");
            assert!(error.to_string().contains("`action.down.0.bias` holds"), "{error}");
        }
        // The last two bytes of the file are a weight.
        let mut bytes = saved(0.0).expect("weights");
        assert!(PathNet::load(&bytes).is_ok());
        for value in [f16::INFINITY, f16::NAN] {
            bytes.splice(bytes.len() - 2.., value.to_le_bytes());
            let error = PathNet::load(&bytes).map(drop).expect_err("it is no weight");
            assert!(matches!(error, WeightsError::NotFinite(_)), "{error}");
        }
    }

    #[cfg(not(target_arch = "wasm32"))]
    #[test]
    fn dqn_has_files_of_its_own() {
        use crate::nets::Optimiser;

        let card = DqnCard {
            setup: Setup::Cross,
            fold: 3,
            seed: 0,
            epochs: 1,
            batch: 1,
            balls_per_scene: 2,
            optimiser: Optimiser::Muon,
            learning_rate: 1.0,
            balls: 1,
            without_dev: false,
        };
        let bytes = Dqn::fresh(2).save(&card).expect("fresh weights are finite");
        let (loaded, of_file) = Dqn::load(&bytes).expect("our own file");
        assert_eq!(of_file, card);
        assert_eq!(loaded.save(&card).expect("finite weights"), bytes);
        assert!(matches!(PathNet::load(&bytes), Err(WeightsError::BadCard(_))));
    }
}

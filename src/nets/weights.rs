//! Bytes to nets and back: half-precision safetensors whose metadata is a card of the settings that made them.
//!
//! The names of the tensors are the paths of the parameters in `PathNet` (`base.down.0.weight`). A file that
//! does not fit is refused in words. Knows neither files nor the network.

use std::collections::{BTreeMap, HashMap};

use burn::module::{Module, ModuleMapper, ModuleVisitor, Param};
use burn::tensor::{Device, Tensor, TensorData};
use half::f16;
use safetensors::tensor::{Dtype, SafeTensors, TensorView};
use serde::{Deserialize, Serialize};

use super::{Judge, PathNet};
use crate::benchmark::folds::Setup;

/// The key of the card in the file's metadata.
const CARD: &str = "pathlight";

/// How weights came to be.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Card {
    pub setup: Setup,
    /// 0..=9; the nets have seen only this fold's training tasks.
    pub fold: u8,
    /// Of the initial weights and the order of the samples.
    pub seed: u64,
    /// Passes over the samples.
    pub epochs: usize,
    /// Samples in a batch.
    pub batch: u16,
    /// Learning rate of Adam.
    pub rate: f64,
    /// Of the passes, the last ones in which the rate fell to nothing.
    pub cool: usize,
    /// Half of the samples were shown mirrored left to right.
    pub mirror: bool,
    /// Solutions trained on.
    pub samples: usize,
    /// Tasks that the solutions belong to.
    pub tasks: usize,
    /// `simulator::VERSION` of the rollouts trained on.
    pub simulator: u32,
    /// How the judge came to be, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub judge: Option<JudgeCard>,
}

/// How a judge came to be. It has seen the same tasks as the nets.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct JudgeCard {
    /// Of the initial weights and the order of the scenes.
    pub seed: u64,
    /// Passes over the scenes.
    pub epochs: usize,
    /// Scenes in a batch.
    pub batch: u16,
    /// Balls of each scene in a batch.
    pub drawn: u16,
    /// Highest learning rate of Adam.
    pub rate: f64,
    /// Balls with their outcome that these are drawn from.
    pub balls: usize,
}

/// Why bytes are no weights.
#[derive(Debug, thiserror::Error)]
pub enum WeightsError {
    #[error("not a safetensors file ({0}): download or train the weights again")]
    NotSafetensors(#[from] safetensors::SafeTensorError),
    #[error("the file says nothing of how it was trained: write weights with `pathlight train`")]
    NoCard,
    #[error("the card of the weights cannot be read ({0}): write weights with `pathlight train`")]
    BadCard(#[from] serde_json::Error),
    #[error("the weights have no `{0}`: they belong to other nets")]
    Missing(String),
    #[error(
        "`{name}` is {found:?} of type {dtype:?} where the nets have {wanted:?} in half precision: the weights belong to other nets"
    )]
    Misfit { name: String, found: Vec<usize>, wanted: Vec<usize>, dtype: Dtype },
    #[error("the weights have {0} tensors that the nets have not: they belong to other nets")]
    Extra(usize),
}

impl PathNet {
    /// The nets of a weights file, and its card.
    ///
    /// # Errors
    /// Says what does not fit.
    pub fn load(bytes: &[u8], device: &Device) -> Result<(PathNet, Card), WeightsError> {
        let card = read_card(bytes)?;
        let file = SafeTensors::deserialize(bytes)?;
        let mut filler = Filler { file: &file, device, path: Vec::new(), filled: 0, error: None };
        let mut nets = PathNet::new(device);
        if file.names().iter().any(|name| name.starts_with("judge.")) {
            nets.judge = Some(Judge::new(device));
        }
        let nets = nets.map(&mut filler);
        let extra = file.len().saturating_sub(filler.filled);
        match filler.error {
            Some(error) => Err(error),
            None if extra > 0 => Err(WeightsError::Extra(extra)),
            None => Ok((nets, card)),
        }
    }

    /// A weights file of these nets.
    pub fn save(&self, card: &Card) -> Vec<u8> {
        let mut lister = Lister::default();
        self.visit(&mut lister);
        let tensors = lister.tensors.iter().map(|(name, (shape, bytes))| {
            let view = TensorView::new(Dtype::F16, shape.clone(), bytes).expect("two bytes a number");
            (name.as_str(), view)
        });
        let card = serde_json::to_string(card).expect("a card is plain data");
        safetensors::serialize(tensors, Some(HashMap::from([(CARD.to_string(), card)])))
            .expect("names and sizes come from the nets")
    }
}

/// The card of a weights file, without its nets.
///
/// # Errors
/// Says why there is none.
pub fn read_card(bytes: &[u8]) -> Result<Card, WeightsError> {
    let (_, header) = SafeTensors::read_metadata(bytes)?;
    let card = header.metadata().as_ref().and_then(|metadata| metadata.get(CARD)).ok_or(WeightsError::NoCard)?;
    Ok(serde_json::from_str(card)?)
}

/// Collects every parameter, in half precision.
#[derive(Default)]
struct Lister {
    path: Vec<String>,
    tensors: BTreeMap<String, (Vec<usize>, Vec<u8>)>,
}

impl ModuleVisitor for Lister {
    fn enter_module(&mut self, name: &str, _: &str) {
        self.path.push(name.to_string());
    }

    fn exit_module(&mut self, _: &str, _: &str) {
        self.path.pop();
    }

    fn visit_float<const D: usize>(&mut self, param: &Param<Tensor<D>>) {
        let data = param.val().into_data();
        let numbers: Vec<f32> = data.iter::<f32>().collect();
        let bytes = numbers.iter().flat_map(|&number| f16::from_f32(number).to_le_bytes()).collect();
        self.tensors.insert(self.path.join("."), (param.val().dims().to_vec(), bytes));
    }
}

/// Replaces every parameter by the file's.
struct Filler<'a> {
    file: &'a SafeTensors<'a>,
    device: &'a Device,
    path: Vec<String>,
    filled: usize,
    error: Option<WeightsError>,
}

impl Filler<'_> {
    fn read(&self, wanted: &[usize]) -> Result<Vec<f32>, WeightsError> {
        let name = self.path.join(".");
        let view = self.file.tensor(&name).map_err(|_| WeightsError::Missing(name.clone()))?;
        if view.dtype() != Dtype::F16 || view.shape() != wanted {
            let (found, dtype) = (view.shape().to_vec(), view.dtype());
            return Err(WeightsError::Misfit { name, found, wanted: wanted.to_vec(), dtype });
        }
        let numbers = view.data().as_chunks().0.iter().map(|&pair| f16::from_le_bytes(pair).to_f32());
        Ok(numbers.collect())
    }
}

impl ModuleMapper for Filler<'_> {
    fn enter_module(&mut self, name: &str, _: &str) {
        self.path.push(name.to_string());
    }

    fn exit_module(&mut self, _: &str, _: &str) {
        self.path.pop();
    }

    fn map_float<const D: usize>(&mut self, param: Param<Tensor<D>>) -> Param<Tensor<D>> {
        let shape = param.val().dims();
        match self.read(&shape) {
            Ok(numbers) => {
                self.filled += 1;
                let data = TensorData::new(numbers, shape);
                param.map(|_| Tensor::from_data(data, self.device))
            }
            Err(error) => {
                self.error.get_or_insert(error);
                param
            }
        }
    }
}

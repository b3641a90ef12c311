//! The shipped models: what they imagine, and the agents that propose balls with them.

use std::collections::BTreeMap;
use std::sync::Mutex;

use numpy::{IntoPyArray, PyArray2, PyArrayMethods};
use pathlight::agents::{self, Observation};
use pathlight::benchmark::auccess::MAX_ATTEMPTS;
use pathlight::colour::imagined_maps::ImaginedMap;
use pathlight::nets::PathNet;
use pathlight::raster::SIDE;
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::scene::Scene;
use crate::value_error;

/// The weights that the wheel holds.
const WITHIN: &[u8] = include_bytes!("../../assets/within-0.safetensors");
const CROSS: &[u8] = include_bytes!("../../assets/cross-0.safetensors");

/// Returns the shipped weights as a file's bytes.
#[pyfunction]
pub fn weights(py: Python<'_>, cross: bool) -> Bound<'_, PyBytes> {
    PyBytes::new(py, shipped(cross))
}

fn shipped(cross: bool) -> &'static [u8] {
    if cross { CROSS } else { WITHIN }
}

/// The nets of a weights file.
#[pyclass(frozen)]
pub struct Model(PathNet);

#[pymethods]
impl Model {
    /// Loads the shipped nets, or those of a file's bytes.
    #[new]
    #[pyo3(signature = (cross, weights=None))]
    fn new(py: Python<'_>, cross: bool, weights: Option<&[u8]>) -> PyResult<Model> {
        let bytes = weights.unwrap_or(shipped(cross));
        let (nets, _) = py.detach(|| PathNet::load(bytes)).map_err(value_error)?;
        Ok(Model(nets))
    }

    /// What the nets imagine for a scene: by name of the map, float32, (64, 64), row 0 at the bottom.
    fn imagine<'py>(&self, py: Python<'py>, scene: &Scene) -> PyResult<BTreeMap<&str, Bound<'py, PyArray2<f32>>>> {
        let imagined = py.detach(|| self.0.imagine(&scene.task.scene));
        let maps = ImaginedMap::ALL.into_iter().filter_map(|map| Some((map.name(), imagined.map(map)?.to_vec())));
        maps.map(|(name, values)| Ok((name, values.into_pyarray(py).reshape([SIDE, SIDE])?))).collect()
    }

    /// Up to `count` balls, the most promising first: x, y, radius in px, and the chance to solve or NaN;
    /// float64, (balls, 4).
    fn propose<'py>(
        &self,
        py: Python<'py>,
        scene: &Scene,
        seed: u64,
        count: u16,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let seed = scene.task.id.seed(seed);
        let proposals = py.detach(|| agents::propose(&self.0, &scene.task.scene, seed, count.into()));
        let row = |proposal: &agents::Proposal| {
            [proposal.ball.x, proposal.ball.y, proposal.ball.r, proposal.chance().unwrap_or(f64::NAN)]
        };
        let numbers: Vec<f64> = proposals.iter().flat_map(row).collect();
        numbers.into_pyarray(py).reshape([proposals.len(), 4])
    }

    /// The agent of the model at work on a scene.
    fn agent(&self, py: Python<'_>, scene: &Scene, seed: u64) -> Agent {
        let seed = scene.task.id.seed(seed);
        let agent = py.detach(|| agents::start(&self.0, &scene.task.scene, seed, MAX_ATTEMPTS));
        Agent(Mutex::new(agent))
    }
}

/// An agent at work on one puzzle.
#[pyclass(frozen)]
pub struct Agent(Mutex<Box<dyn agents::Agent>>);

#[pymethods]
impl Agent {
    /// The next ball: x, y and radius, px; None if there is none.
    fn propose(&self, py: Python<'_>) -> PyResult<Option<[f64; 3]>> {
        let proposal = py.detach(|| self.0.lock().map(|mut agent| agent.propose()).map_err(|_| broken()))?;
        Ok(proposal.map(|proposal| proposal.ball.into()))
    }

    /// Tells the agent whether the ball that it proposed last solved the task.
    fn observe(&self, py: Python<'_>, solved: bool) -> PyResult<()> {
        let observation = Observation { solved, paths: None };
        py.detach(|| self.0.lock().map(|mut agent| agent.observe(&observation)).map_err(|_| broken()))
    }
}

fn broken() -> PyErr {
    PyRuntimeError::new_err("the agent failed before: start another one")
}

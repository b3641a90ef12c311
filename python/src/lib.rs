//! The module `pathlight_phyre._native`: the library's tasks, simulator, folds and nets as Python objects and arrays.
//!
//! Converts and nothing else; `pathlight_phyre/*.py` give it PHYRE's names and types. Long work runs without the GIL.

use numpy::{IntoPyArray, PyArray2, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods};
use pathlight::benchmark::action_list::action_list;
use pathlight::benchmark::folds::{Fold, Setup};
use pathlight::benchmark::observation::colour_codes::{SIDE, draw_scene};
use pathlight::benchmark::observation::features::{FEATURES, body_of};
use pathlight::puzzle::stable_shuffle::stable_shuffle as shuffled;
use pathlight::puzzle::task::{self, TaskId};
use pathlight::puzzle::templates::TEMPLATES;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

mod model;
mod parallel;
mod scene;

#[pymodule]
mod _native {
    #[pymodule_export]
    use super::model::{Agent, Model, weights};
    #[pymodule_export]
    use super::scene::{Observed, Scene};
    #[pymodule_export]
    use super::{actions, fold, raster, stable_shuffle, task_ids};

    #[pymodule_export]
    const SIMULATOR_VERSION: u32 = pathlight::simulator::VERSION;
    #[pymodule_export]
    const DEFAULT_STRIDE: usize = pathlight::benchmark::observation::DEFAULT_STRIDE;
    #[pymodule_export]
    const MAX_ATTEMPTS: usize = pathlight::benchmark::auccess::MAX_ATTEMPTS;
    #[pymodule_export]
    const MAX_STEPS: usize = pathlight::puzzle::rollout::MAX_STEPS;
    #[pymodule_export]
    const GOAL_STEPS: usize = pathlight::puzzle::rollout::GOAL_STEPS;
    #[pymodule_export]
    const FEATURES: usize = super::FEATURES;
}

/// Returns a `ValueError` of an error of the library.
fn value_error(error: impl std::fmt::Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// Returns the ids of all tasks, ascending.
#[pyfunction]
fn task_ids() -> Vec<String> {
    TEMPLATES.iter().flat_map(|template| task::ids(template)).map(String::from).collect()
}

/// Returns the ids of a fold: train, dev, test.
#[pyfunction]
fn fold(cross: bool, seed: u8) -> [Vec<String>; 3] {
    let Fold { train, dev, test } = Fold::new(if cross { Setup::Cross } else { Setup::Within }, seed);
    [train, dev, test].map(|tasks: Vec<TaskId>| tasks.into_iter().map(String::from).collect())
}

/// Sorts texts by the MD5 of each with a salt.
#[pyfunction]
fn stable_shuffle(texts: Vec<String>, salt: &str) -> Vec<String> {
    shuffled(texts, salt)
}

/// Returns PHYRE's list of actions, float32, (100000, 3).
#[pyfunction]
fn actions(py: Python<'_>) -> PyResult<Bound<'_, PyArray2<f32>>> {
    let numbers: Vec<f32> = action_list().flat_map(<[f64; 3]>::from).map(|number| number as f32).collect();
    let rows = numbers.len() / 3;
    numbers.into_pyarray(py).reshape([rows, 3])
}

/// Returns the image of objects with these features, (objects, 14): uint8 colour codes, (256, 256).
#[pyfunction]
fn raster<'py>(py: Python<'py>, features: PyReadonlyArray2<'py, f32>) -> PyResult<Bound<'py, PyArray2<u8>>> {
    let &[_, FEATURES] = features.shape() else {
        return Err(value_error(format!(
            "features must be an array (objects, {FEATURES}), not {:?}",
            features.shape()
        )));
    };
    let rows = features.to_vec()?;
    let bodies = rows.as_chunks().0.iter().map(body_of).collect::<Result<Vec<_>, _>>().map_err(value_error)?;
    // PHYRE draws the action last, wherever it is in the list.
    let (actions, scene): (Vec<_>, Vec<_>) =
        bodies.into_iter().partition(|body| body.role == pathlight::puzzle::scene::Role::Red);
    let mut image = vec![0; SIDE * SIDE];
    draw_scene(&[scene, actions].concat(), &mut image);
    image.into_pyarray(py).reshape([SIDE, SIDE])
}

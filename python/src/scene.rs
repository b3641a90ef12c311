//! A task and its simulations.

use numpy::ndarray::{Array2, Array3, Array4};
use numpy::{
    IntoPyArray, PyArray1, PyArray2, PyArray3, PyArray4, PyArrayMethods, PyReadonlyArray2, PyUntypedArrayMethods,
};
use pathlight::benchmark::observation::colour_codes::{SIDE, draw_body, draw_scene};
use pathlight::benchmark::observation::features::{FEATURES, ObjectFeatures};
use pathlight::benchmark::observation::{move_to_step, objects, observed_steps};
use pathlight::puzzle::action::{Action, Ball, Obstacles};
use pathlight::puzzle::rollout::{Rollout, STEPS_PER_SECOND};
use pathlight::puzzle::scene::{self, Body};
use pathlight::puzzle::task::Task;
use pathlight::search::stability::is_stable;
use pathlight::simulator::{ContactEvent, contacts, outcome, simulate};
use pyo3::prelude::*;

use crate::{parallel, value_error};

/// PHYRE's `SimulationStatus`.
const NOT_SOLVED: i8 = -1;
const INVALID_INPUT: i8 = 0;
const SOLVED: i8 = 1;
const UNSTABLY_SOLVED: i8 = 2;
const STABLY_SOLVED: i8 = 3;

/// A task of the benchmark.
#[pyclass(frozen)]
pub struct Scene {
    pub task: Task,
    obstacles: Obstacles,
}

/// What is wanted of a simulation beside its status.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
struct Wanted {
    images: bool,
    features: bool,
    velocities: bool,
    masks: bool,
    contacts: bool,
}

/// What came of a simulation. Arrays that were not wanted are None, as are all if the action is invalid.
#[pyclass(frozen, get_all)]
#[derive(Default)]
pub struct Observed {
    /// The number of PHYRE's `SimulationStatus`.
    status: i8,
    /// The step of each observation, from 1; int64, (times,).
    steps: Option<Py<PyArray1<i64>>>,
    /// uint8, (times, 256, 256)
    images: Option<Py<PyArray3<u8>>>,
    /// float32, (times, objects, 14)
    features: Option<Py<PyArray3<f32>>>,
    /// float32, (times, objects, 3)
    velocities: Option<Py<PyArray3<f32>>>,
    /// uint8, (times, objects, 256, 256)
    masks: Option<Py<PyArray4<u8>>>,
    /// Two bodies, the step in which they begin to touch, and that in which they no longer do; int64, (contacts, 4).
    contacts: Option<Py<PyArray2<i64>>>,
    /// Whether the object touches the goal; bool, (times,).
    touching: Option<Py<PyArray1<bool>>>,
}

#[pymethods]
impl Scene {
    #[new]
    fn new(id: &str) -> PyResult<Scene> {
        let task = id.parse().and_then(Task::load).map_err(|_| {
            value_error(format!(
                "there is no ball task {id:?}: pathlight_phyre.metrics.get_task_ids_in_tier('ball') lists all of them"
            ))
        })?;
        let obstacles = Obstacles::new(&task.scene);
        Ok(Scene { task, obstacles })
    }

    /// The task as JSON, as `pathlight tasks --json` prints it.
    fn json(&self) -> String {
        serde_json::to_string(&self.task).expect("a task is plain data")
    }

    /// The scene before an action: uint8, (256, 256).
    fn image<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray2<u8>> {
        let mut image = Array2::zeros([SIDE, SIDE]);
        draw_scene(&self.task.scene.bodies, image.as_slice_mut().expect("contiguous"));
        image.into_pyarray(py)
    }

    /// The features of its objects before an action: float32, (1, objects, 14).
    fn features<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray3<f32>> {
        let bodies = &self.task.scene.bodies;
        let numbers = bodies.iter().zip(features_of(bodies)).flat_map(|(body, features)| features.at(pose(body)));
        let array = Array3::from_shape_vec([1, bodies.len(), FEATURES], numbers.collect());
        array.expect("one row of features per object").into_pyarray(py)
    }

    /// Whether an action places its ball inside the scene, whatever it overlaps there.
    #[staticmethod]
    fn is_inside(action: [f64; 3]) -> bool {
        Action::from(action).check_bounds().is_ok()
    }

    /// The ball of an action: x, y and radius, px; None if the action is invalid.
    fn ball(&self, action: [f64; 3]) -> Option<[f64; 3]> {
        self.obstacles.place(action.into()).ok().map(Into::into)
    }

    /// Simulates the scene with the ball of an action, or without a ball.
    fn simulate(
        &self,
        py: Python<'_>,
        action: Option<[f64; 3]>,
        stride: usize,
        stable: bool,
        wanted: Wanted,
    ) -> PyResult<Observed> {
        let Ok(ball) = action.map(|action| self.obstacles.place(action.into())).transpose() else {
            return Ok(Observed::default());
        };
        let Wanted { images, features, velocities, masks, contacts } = wanted;
        if !(images || features || velocities || masks || contacts) {
            let status = py.detach(|| self.status_of(ball, stable));
            return Ok(Observed { status, ..Observed::default() });
        }
        let observations = py.detach(|| {
            let rollout = simulate(&self.task.scene, ball).expect("the ball was placed in this scene");
            let status = self.refined(rollout.solved, ball, stable);
            Observations::new(&self.task, ball, &rollout, stride, &wanted, status)
        });
        Ok(observations.into_python(py))
    }

    /// The statuses of actions, float64 (actions, 3): int8, (actions,). On all cores.
    fn statuses<'py>(
        &self,
        py: Python<'py>,
        actions: PyReadonlyArray2<'py, f64>,
        stable: bool,
    ) -> PyResult<Bound<'py, PyArray1<i8>>> {
        let &[_, 3] = actions.shape() else {
            return Err(value_error(format!("actions must be an array (actions, 3), not {:?}", actions.shape())));
        };
        let numbers = actions.to_vec()?;
        let statuses = py.detach(|| {
            let actions = numbers.as_chunks().0;
            parallel::map(actions, |&action: &[f64; 3]| match self.obstacles.place(action.into()) {
                Ok(ball) => self.status_of(Some(ball), stable),
                Err(_) => INVALID_INPUT,
            })
        });
        Ok(statuses.into_pyarray(py))
    }
}

impl Scene {
    fn status_of(&self, ball: Option<Ball>, stable: bool) -> i8 {
        let outcome = outcome(&self.task.scene, ball).expect("the ball was placed in this scene");
        self.refined(outcome.solved, ball, stable)
    }

    fn refined(&self, solved: bool, ball: Option<Ball>, stable: bool) -> i8 {
        match (solved, ball) {
            (false, _) => NOT_SOLVED,
            (true, Some(ball)) if stable => {
                let is_stable = is_stable(&self.task.scene, ball).expect("the scene was simulated before");
                if is_stable { STABLY_SOLVED } else { UNSTABLY_SOLVED }
            }
            (true, _) => SOLVED,
        }
    }
}

/// The features of bodies of the benchmark.
fn features_of(bodies: &[Body]) -> Vec<ObjectFeatures> {
    bodies.iter().map(|body| ObjectFeatures::of(body).expect("the benchmark has PHYRE's shapes")).collect()
}

fn pose(body: &Body) -> [f64; 3] {
    [body.x, body.y, body.angle]
}

/// What is seen of a rollout, before it is handed to Python.
struct Observations {
    status: i8,
    steps: Vec<i64>,
    touching: Vec<bool>,
    images: Option<Array3<u8>>,
    features: Option<Array3<f32>>,
    velocities: Option<Array3<f32>>,
    masks: Option<Array4<u8>>,
    contacts: Option<Array2<i64>>,
}

impl Observations {
    fn new(
        task: &Task,
        ball: Option<Ball>,
        rollout: &Rollout,
        stride: usize,
        wanted: &Wanted,
        status: i8,
    ) -> Observations {
        let mut bodies = objects(&task.scene, ball);
        let constant = features_of(&bodies);
        let steps = || observed_steps(rollout, stride);
        let (times, count) = (steps().len(), bodies.len());
        let mut images = wanted.images.then(|| Array3::zeros([times, SIDE, SIDE]));
        let mut features = wanted.features.then(|| Vec::with_capacity(times * count * FEATURES));
        let mut velocities = wanted.velocities.then(|| Vec::with_capacity(times * count * 3));
        let mut masks = wanted.masks.then(|| Array4::zeros([times, count, SIDE, SIDE]));
        for (time, step) in steps().enumerate() {
            if let Some(velocities) = &mut velocities {
                move_to_step(&mut bodies, rollout, step - 1);
                let before: Vec<_> = bodies.iter().map(pose).collect();
                move_to_step(&mut bodies, rollout, step);
                for ((body, features), before) in bodies.iter().zip(&constant).zip(before) {
                    velocities.extend(velocity(features, before, pose(body)));
                }
            } else {
                move_to_step(&mut bodies, rollout, step);
            }
            if let Some(features) = &mut features {
                features.extend(bodies.iter().zip(&constant).flat_map(|(body, constant)| constant.at(pose(body))));
            }
            let size = SIDE * SIDE;
            if let Some(images) = &mut images {
                draw_scene(&bodies, &mut images.as_slice_mut().expect("contiguous")[time * size..][..size]);
            }
            if let Some(masks) = &mut masks {
                let of_time = &mut masks.as_slice_mut().expect("contiguous")[time * count * size..][..count * size];
                bodies.iter().zip(of_time.chunks_mut(size)).for_each(|(body, mask)| draw_body(body, 1, mask));
            }
        }
        let shaped =
            |numbers, width| Array3::from_shape_vec([times, count, width], numbers).expect("one row per object");
        Observations {
            status,
            steps: steps().map(|step| step as i64).collect(),
            touching: steps().map(|step| rollout.touching[step]).collect(),
            images,
            features: features.map(|numbers| shaped(numbers, FEATURES)),
            velocities: velocities.map(|numbers| shaped(numbers, 3)),
            masks,
            contacts: wanted.contacts.then(|| contacts_of(&task.scene, ball)),
        }
    }

    fn into_python(self, py: Python<'_>) -> Observed {
        let Observations { status, steps, touching, images, features, velocities, masks, contacts } = self;
        Observed {
            status,
            steps: Some(steps.into_pyarray(py).unbind()),
            images: images.map(|array| array.into_pyarray(py).unbind()),
            features: features.map(|array| array.into_pyarray(py).unbind()),
            velocities: velocities.map(|array| array.into_pyarray(py).unbind()),
            masks: masks.map(|array| array.into_pyarray(py).unbind()),
            contacts: contacts.map(|array| array.into_pyarray(py).unbind()),
            touching: Some(touching.into_pyarray(py).unbind()),
        }
    }
}

/// The events as rows: see `Observed::contacts`.
fn contacts_of(scene: &scene::Scene, ball: Option<Ball>) -> Array2<i64> {
    let events = contacts(scene, ball).expect("the scene was simulated before");
    let row = |event: &ContactEvent| [event.bodies[0], event.bodies[1], event.begin, event.end].map(|n| n as i64);
    Array2::from(events.iter().map(row).collect::<Vec<_>>())
}

/// The velocity of the centre, px/s, and the angular velocity, rad/s, with which a body moved in the step between two
/// poses.
fn velocity(features: &ObjectFeatures, before: [f64; 3], after: [f64; 3]) -> [f32; 3] {
    let [[x, y], [u, v]] = [before, after].map(|pose| features.centre_at(pose));
    [u - x, v - y, after[2] - before[2]].map(|change| (change * STEPS_PER_SECOND as f64) as f32)
}

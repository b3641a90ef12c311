//! A rollout that is shown: its ball, and the interpolated pose of every body at any time. Used by `game`, `game_view`
//! and `frame`; draws nothing itself.

use std::rc::Rc;

use js_sys::{Float32Array, Object, Reflect};
use wasm_bindgen::JsValue;

use super::paint::LineStyle;
use crate::puzzle::action::Ball;
use crate::puzzle::rollout::{Pose, Rollout};
use crate::puzzle::scene::Scene;
use crate::raster::{Bitmap, path_image};

/// One rollout that is shown.
pub(crate) struct Recording {
    /// `None` if the scene runs without a ball.
    pub ball: Option<Ball>,
    pub rollout: Rc<Rollout>,
    /// Line style of its paths.
    pub line_style: LineStyle,
    /// Whether the ball is the model's.
    pub of_model: bool,
}

impl Recording {
    /// Returns the pose of a dynamic body at a step; a fraction is interpolated, and the last step holds afterwards.
    pub(crate) fn pose(&self, step: f64, body: usize) -> Option<Pose> {
        let step = step.clamp(0.0, self.rollout.steps as f64);
        let before = self.rollout.pose(step.floor() as usize, body)?;
        let after = self.rollout.pose(step.ceil() as usize, body)?;
        let fraction = step.fract() as f32;
        Some(std::array::from_fn(|axis| before[axis] + fraction * (after[axis] - before[axis])))
    }

    /// Returns the path of a body's origin from the start to a step, px.
    pub(crate) fn path(&self, step: f64, body: usize) -> impl Iterator<Item = [f64; 2]> {
        let last = (step.max(0.0) as usize).min(self.rollout.steps);
        let points = (0..=last).filter_map(move |step| self.rollout.pose(step, body));
        points.map(|[x, y, _]| [x.into(), y.into()])
    }

    /// Returns the paths of the green object and of the ball as masks: `{ object, ball }`.
    pub(crate) fn path_masks(&self, scene: &Scene) -> Result<JsValue, JsValue> {
        let to_array = |image: Bitmap| Float32Array::from(image.to_f32().collect::<Vec<_>>().as_slice());
        let paths = Object::new();
        let object = path_image(&scene.bodies[scene.body1], &self.rollout, scene.body1);
        Reflect::set(&paths, &"object".into(), &to_array(object))?;
        if let Some(ball) = self.ball {
            let path = path_image(&ball.body(), &self.rollout, scene.bodies.len());
            Reflect::set(&paths, &"ball".into(), &to_array(path))?;
        }
        Ok(paths.into())
    }

    /// Returns the intervals in which the green object touches the goal, each as its first and last step.
    pub(crate) fn touches(&self) -> Vec<[u32; 2]> {
        let mut intervals: Vec<[u32; 2]> = Vec::new();
        for (step, _) in self.rollout.touching.iter().enumerate().filter(|&(_, &touches)| touches) {
            let step = step as u32;
            match intervals.last_mut() {
                Some([_, last]) if *last + 1 == step => *last = step,
                _ => intervals.push([step, step]),
            }
        }
        intervals
    }
}

//! A rollout on its way to the screen: whose attempt it is, and where every body stands at a moment between
//! two steps. Used by `puzzle`; draws nothing itself.

use js_sys::{Float32Array, Object, Reflect};
use wasm_bindgen::JsValue;

use super::paint::Line;
use crate::play::game::Contender;
use crate::puzzle::action::Ball;
use crate::puzzle::rollout::{Pose, Rollout};
use crate::puzzle::scene::Scene;
use crate::raster::{Bitmap, path_image};

/// One rollout being shown.
pub struct Take {
    /// `None` if the scene runs without a ball.
    pub attempt: Option<(Contender, Ball)>,
    pub rollout: Rollout,
    /// How its paths are drawn.
    pub line: Line,
}

impl Take {
    /// The pose of a moving body at a step, which may lie between two; after the last it stays.
    pub fn pose(&self, step: f64, body: usize) -> Option<Pose> {
        let step = step.clamp(0.0, self.rollout.steps as f64);
        let before = self.rollout.pose(step.floor() as usize, body)?;
        let after = self.rollout.pose(step.ceil() as usize, body)?;
        let share = step.fract() as f32;
        Some(std::array::from_fn(|axis| before[axis] + share * (after[axis] - before[axis])))
    }

    /// The path of a body's origin from the start to a step, px.
    pub fn path(&self, step: f64, body: usize) -> impl Iterator<Item = [f64; 2]> {
        let last = (step.max(0.0) as usize).min(self.rollout.steps);
        let points = (0..=last).filter_map(move |step| self.rollout.pose(step, body));
        points.map(|[x, y, _]| [x.into(), y.into()])
    }

    /// The paths of the green object and of the ball as pictures: `{ object, ball }`.
    pub fn pictures(&self, scene: &Scene) -> Result<JsValue, JsValue> {
        let picture = |image: Bitmap| Float32Array::from(image.to_f32().collect::<Vec<_>>().as_slice());
        let paths = Object::new();
        let object = path_image(&scene.bodies[scene.body1], &self.rollout, scene.body1);
        Reflect::set(&paths, &"object".into(), &picture(object))?;
        if let Some((_, ball)) = self.attempt {
            let path = path_image(&ball.body(), &self.rollout, scene.bodies.len());
            Reflect::set(&paths, &"ball".into(), &picture(path))?;
        }
        Ok(paths.into())
    }

    /// The stretches of steps in which the green object touches the goal: first and last step of each.
    pub fn touches(&self) -> Vec<[u32; 2]> {
        let mut stretches: Vec<[u32; 2]> = Vec::new();
        for (step, _) in self.rollout.touching.iter().enumerate().filter(|&(_, &touches)| touches) {
            let step = step as u32;
            match stretches.last_mut() {
                Some([_, last]) if *last + 1 == step => *last = step,
                _ => stretches.push([step, step]),
            }
        }
        stretches
    }
}

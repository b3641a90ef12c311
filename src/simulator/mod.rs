//! The simulator: a scene and perhaps a ball in, the whole rollout out. The only user of rapier2d.
//!
//! rapier supplies shapes, mass properties, contact points and distances; the step around them (`world`) keeps
//! the order of Box2D 2.3, on which PHYRE runs. Bit for bit the same natively and in wasm: f32 throughout, libm
//! for the trigonometry, and no order that hangs on a hash. Page, wasm, collection and evaluation all come here.
//! Knows nothing of tasks, pixels or nets.

use crate::puzzle::action::{Ball, Invalid};
use crate::puzzle::rollout::{GOAL_STEPS, MAX_STEPS, Pose, Rollout};
use crate::puzzle::scene::{Scene, walls};
use constants::{SCALE, TOUCHING_BALLS};
use world::World;

mod body;
mod constants;
mod contact;
mod contact_solver;
mod time_of_impact;
mod world;

/// Raised whenever any rollout changes; stored in weights and collected data.
pub const VERSION: u32 = 3;

/// How a rollout ended, without its poses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outcome {
    pub solved: bool,
    /// Steps simulated: at most 1000, and fewer if solved.
    pub steps: usize,
}

/// The whole rollout of a scene, with a ball or without, with the pose of every moving body at every step.
///
/// # Errors
/// Says why the ball may not be there.
pub fn simulate(scene: &Scene, ball: Option<Ball>) -> Result<Rollout, Invalid> {
    let setup = Setup::new(scene, ball)?;
    let bodies = setup.moving.iter().map(|&(index, _)| index).collect();
    let (mut poses, mut touching) = (Vec::new(), Vec::new());
    let Outcome { solved, steps } = setup.run(|setup, touches| {
        poses.extend(setup.poses());
        touching.push(touches);
    });
    Ok(Rollout { solved, steps, bodies, poses, touching })
}

/// The same rollout without keeping the poses: for bulk work.
///
/// # Errors
/// Says why the ball may not be there.
pub fn outcome(scene: &Scene, ball: Option<Ball>) -> Result<Outcome, Invalid> {
    Ok(Setup::new(scene, ball)?.run(|_, _| ()))
}

/// A scene in the world.
struct Setup {
    world: World,
    /// The moving bodies: index in the scene, and number in the world.
    moving: Vec<(usize, usize)>,
    /// The green object and its goal, by their numbers in the world.
    pair: [usize; 2],
    /// If both are balls: they touch when their centres are nearer than this, px.
    reach: Option<f64>,
}

impl Setup {
    fn new(scene: &Scene, ball: Option<Ball>) -> Result<Setup, Invalid> {
        let mut world = World::default();
        for wall in walls() {
            world.add(&wall);
        }
        let numbers: Vec<usize> = scene.bodies.iter().map(|body| world.add(body)).collect();
        let mut moving: Vec<_> = (0..).zip(numbers.iter().copied()).filter(|&(i, _)| scene.bodies[i].dynamic).collect();
        if let Some(ball) = ball {
            ball.check(scene)?;
            moving.push((scene.bodies.len(), world.add(&ball.body())));
        }
        let [object, target] = [scene.body1, scene.body2].map(|body| scene.bodies[body].ball_radius());
        let reach = object.zip(target).map(|(r1, r2)| r1 + r2 + TOUCHING_BALLS);
        Ok(Setup { world, moving, pair: [numbers[scene.body1], numbers[scene.body2]], reach })
    }

    /// Steps until solved or out of steps; `see` gets the setup and whether it touches, start included.
    fn run(mut self, mut see: impl FnMut(&Setup, bool)) -> Outcome {
        see(&self, self.touches());
        let mut held = 0;
        for steps in 1..=MAX_STEPS {
            // Once everything sleeps, nothing moves and no contact changes any more.
            if self.world.is_awake() {
                self.world.step();
            }
            let touches = self.touches();
            see(&self, touches);
            held = if touches { held + 1 } else { 0 };
            if held == GOAL_STEPS {
                return Outcome { solved: true, steps };
            }
        }
        Outcome { solved: false, steps: MAX_STEPS }
    }

    fn touches(&self) -> bool {
        let [a, b] = self.pair;
        match self.reach {
            Some(reach) => {
                let apart = self.world.bodies[a].origin() - self.world.bodies[b].origin();
                libm::hypot(f64::from(apart.x), f64::from(apart.y)) * SCALE < reach
            }
            None => self.world.touch(a, b),
        }
    }

    /// The pose of every moving body, in px.
    fn poses(&self) -> impl Iterator<Item = Pose> {
        self.moving.iter().map(|&(_, number)| {
            let body = &self.world.bodies[number];
            let origin = body.origin() * SCALE as f32;
            [origin.x, origin.y, body.now.angle]
        })
    }
}

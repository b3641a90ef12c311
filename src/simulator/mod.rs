//! The simulator: a port of Box2D 2.3's step, the engine of PHYRE, on rapier2d's geometry.
//!
//! A scene and perhaps a ball in, the complete rollout out. The only user of rapier2d, which supplies shapes, mass
//! properties, contact manifolds and distances; each file names the class or function of Box2D that it ports. Results are
//! bit-identical natively and in wasm: f32 throughout, libm for the trigonometry, and no order that depends on a hash.
//! Used by `dataset`, `play`, `web` and `commands`. Must not depend on tasks, images or nets.
//!
//! | file | ports |
//! | --- | --- |
//! | `constants` | b2Settings.h, and PHYRE's parameters |
//! | `body` | b2Body, b2Sweep |
//! | `fixture` | b2Fixture, b2FixtureProxy |
//! | `contact` | b2Contact, b2WorldManifold |
//! | `contact_solver`, `position_solver` | b2ContactSolver |
//! | `time_of_impact` | b2TimeOfImpact |
//! | `world` | b2World::Step, b2ContactManager |
//! | `island` | b2World::Solve, b2Island::Solve |
//! | `toi_solver` | b2World::SolveTOI, b2Island::SolveTOI |

use crate::puzzle::action::{Ball, Invalid};
use crate::puzzle::rollout::{GOAL_STEPS, MAX_STEPS, Pose, Rollout};
use crate::puzzle::sampled_paths::{SAMPLED_STEPS, SAMPLES, SampledPaths};
use crate::puzzle::scene::{Scene, walls};
use constants::{BALL_TOUCH_DISTANCE, PX_PER_METRE};
use world::World;

pub use closest_approach::{ClosestApproach, closest_approach};

mod body;
mod closest_approach;
pub mod constants;
mod contact;
mod contact_solver;
pub mod distance;
mod fixture;
mod island;
pub mod overlap;
mod position_solver;
mod scalar;
mod time_of_impact;
mod toi_solver;
mod world;

/// Raised whenever any rollout changes. Stored in weights and collected data.
pub const VERSION: u32 = 3;

/// How a rollout ended, without its poses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outcome {
    pub solved: bool,
    /// Number of simulated steps: `MAX_STEPS`, or fewer if solved.
    pub steps: usize,
}

/// Simulates a scene, with or without a ball. Returns the complete rollout: the pose of every dynamic body at every step.
///
/// # Errors
/// The reason why the ball is invalid in this scene, or why the scene cannot be simulated.
pub fn simulate(scene: &Scene, ball: Option<Ball>) -> Result<Rollout, Invalid> {
    let simulation = Simulation::new(scene, ball)?;
    let bodies = simulation.dynamic_bodies.iter().map(|&(index, _)| index).collect();
    let (mut poses, mut touching) = (Vec::new(), Vec::new());
    let Outcome { solved, steps } = simulation.run_with(|simulation, touches| {
        poses.extend(simulation.poses());
        touching.push(touches);
    });
    Ok(Rollout { solved, steps, bodies, poses, touching })
}

/// Simulates like `simulate`, but keeps no poses: for bulk work.
///
/// # Errors
/// The reason why the ball is invalid in this scene.
pub fn outcome(scene: &Scene, ball: Option<Ball>) -> Result<Outcome, Invalid> {
    Ok(Simulation::new(scene, ball)?.run())
}

/// Simulates like `outcome`, and keeps the sampled paths of the green object and of the ball: for labels.
///
/// # Errors
/// The reason why the ball is invalid in this scene.
pub fn sampled_paths(scene: &Scene, ball: Ball) -> Result<(Outcome, SampledPaths), Invalid> {
    let simulation = Simulation::new(scene, Some(ball))?;
    let [object, ball] = [simulation.goal[0], simulation.world.bodies.len() - 1];
    let mut paths = SampledPaths { object: [[0.0; 2]; SAMPLES], ball: [[0.0; 2]; SAMPLES] };
    let (mut step, mut sample, mut latest) = (0, 0, [[0.0; 2]; 2]);
    let outcome = simulation.run_with(|simulation, _| {
        latest = [object, ball].map(|body| simulation.pose(body)).map(|[x, y, _]| [x, y]);
        if SAMPLED_STEPS.get(sample) == Some(&step) {
            [paths.object[sample], paths.ball[sample]] = latest;
            sample += 1;
        }
        step += 1;
    });
    paths.object[sample..].fill(latest[0]);
    paths.ball[sample..].fill(latest[1]);
    Ok((outcome, paths))
}

/// A rollout before its first step: the world of a scene, and what decides whether its goal is reached.
pub struct Simulation {
    world: World,
    /// The dynamic bodies: index in the scene and index in the world.
    dynamic_bodies: Vec<(usize, usize)>,
    /// The green object and its goal: indices in the world.
    goal: [usize; 2],
    /// If both are balls: they touch when their centres are nearer than this, px.
    touch_distance: Option<f64>,
}

impl Simulation {
    /// Builds the world of a scene, with or without a ball.
    ///
    /// # Errors
    /// The reason why the ball is invalid in this scene.
    pub fn new(scene: &Scene, ball: Option<Ball>) -> Result<Simulation, Invalid> {
        scene.check_form()?;
        let mut world = World::default();
        for wall in walls() {
            world.add(&wall);
        }
        let indices: Vec<usize> = scene.bodies.iter().map(|body| world.add(body)).collect();
        let all = indices.iter().copied().enumerate();
        let mut dynamic_bodies: Vec<_> = all.filter(|&(body, _)| scene.bodies[body].dynamic).collect();
        if let Some(ball) = ball {
            ball.check(scene)?;
            dynamic_bodies.push((scene.bodies.len(), world.add(&ball.body())));
        }
        let [object, target] = [scene.body1, scene.body2].map(|body| scene.bodies[body].ball_radius());
        let touch_distance = object.zip(target).map(|(r1, r2)| r1 + r2 + BALL_TOUCH_DISTANCE);
        let goal = [indices[scene.body1], indices[scene.body2]];
        Ok(Simulation { world, dynamic_bodies, goal, touch_distance })
    }

    /// Steps until the task is solved or `MAX_STEPS` are over.
    pub fn run(self) -> Outcome {
        self.run_with(|_, _| ())
    }

    /// Runs like `run`. Calls `on_step` for the start and after each step, with whether the object touches the
    /// goal.
    fn run_with(mut self, mut on_step: impl FnMut(&Simulation, bool)) -> Outcome {
        on_step(&self, self.touches());
        let mut touch_steps = 0;
        for steps in 1..=MAX_STEPS {
            // When all bodies sleep, nothing moves and no contact changes.
            if self.world.is_awake() {
                self.world.step();
            }
            let touches = self.touches();
            on_step(&self, touches);
            touch_steps = if touches { touch_steps + 1 } else { 0 };
            if touch_steps == GOAL_STEPS {
                return Outcome { solved: true, steps };
            }
        }
        Outcome { solved: false, steps: MAX_STEPS }
    }

    fn touches(&self) -> bool {
        let [a, b] = self.goal;
        match self.touch_distance {
            Some(touch_distance) => {
                let delta = self.world.bodies[a].origin() - self.world.bodies[b].origin();
                libm::hypot(f64::from(delta.x), f64::from(delta.y)) * PX_PER_METRE < touch_distance
            }
            None => self.world.has_touching_contact(a, b),
        }
    }

    /// Returns the pose of every dynamic body, px and radians.
    fn poses(&self) -> impl Iterator<Item = Pose> {
        self.dynamic_bodies.iter().map(|&(_, index)| self.pose(index))
    }

    /// Returns the pose of a body by its index in the world, px and radians.
    fn pose(&self, index: usize) -> Pose {
        let body = &self.world.bodies[index];
        let origin = body.origin() * PX_PER_METRE as f32;
        [origin.x, origin.y, body.sweep.position.angle]
    }
}

//! A rollout in the world of an engine: builds the world, steps it, and decides when the goal is reached.

use std::fmt;

use rapier2d::math::Vector;

use super::box2d::World;
use super::constants::BALL_TOUCH_DISTANCE;
use super::contact_events::{ContactEvent, ContactLog};
use super::units::{metres, point_in_px};
use crate::puzzle::action::{Ball, Invalid};
use crate::puzzle::rollout::{GOAL_STEPS, MAX_STEPS, Pose, Rollout};
use crate::puzzle::sampled_paths::{SAMPLED_STEPS, SAMPLES, SampledPaths};
use crate::puzzle::scene::{Body, Scene, walls};

/// The interface of an engine's world to a simulation. Bodies are identified by the order in which they were added.
pub trait EngineWorld: Default {
    /// Adds a body at rest; returns its index.
    fn add(&mut self, body: &Body) -> usize;

    /// Returns whether any body is awake. Otherwise nothing moves.
    fn is_awake(&self) -> bool;

    /// Simulates one `TIME_STEP`.
    fn step(&mut self);

    /// Returns whether two bodies had a touching contact at its last update.
    fn has_touching_contact(&self, a: usize, b: usize) -> bool;

    /// Returns the origin of a body, m.
    fn origin(&self, body: usize) -> Vector;

    /// Returns the angle of a body, radians, not wrapped.
    fn angle(&self, body: usize) -> f32;
}

/// How a rollout ended, without its poses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outcome {
    /// Whether the task was solved.
    pub solved: bool,
    /// Number of steps until it was solved, otherwise `MAX_STEPS`.
    pub steps: usize,
}

/// A digest of the poses of all bodies after each step. Equal digests mean equal rollouts, to the bit.
///
/// It is FNV-1a on whole words. The words of a step are x and y of the origin, m, and the angle, radians, of each body,
/// as the bits of f32, walls first and the ball last. The words of the rollout are the digests of its steps. PHYRE's
/// Box2D was recorded with the same digest, so a recorded rollout can be compared by its digest alone.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Digest(u64);

impl Digest {
    fn add_step(&mut self, numbers: impl Iterator<Item = f32>) {
        // FNV's offset basis without its last digit, as in many copies of it.
        const BASIS: u64 = 1_469_598_103_934_665_603;
        let hash = |digest: u64, word: u64| (digest ^ word).wrapping_mul(0x0100_0000_01b3);
        let step = numbers.map(|number| u64::from(number.to_bits())).fold(BASIS, hash);
        self.0 = hash(self.0, step);
    }
}

impl fmt::Display for Digest {
    /// Writes 16 hexadecimal digits.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

/// A rollout before its first step: the world of a scene, and the condition for reaching its goal.
pub struct Simulation<W = World> {
    world: W,
    /// Number of bodies in the world: the walls, the scene's bodies, and the ball.
    body_count: usize,
    /// The dynamic bodies: index in the scene and index in the world.
    dynamic_bodies: Vec<(usize, usize)>,
    /// The green object and its goal: indices in the world.
    goal: [usize; 2],
    /// Distance between their centres below which they touch, m, if both are balls.
    touch_distance: Option<f32>,
}

impl Simulation {
    /// Runs to the end, and returns the touches of bodies.
    pub(super) fn contacts(self) -> Vec<ContactEvent> {
        let mut log = ContactLog::default();
        let mut step = 0;
        let Outcome { steps, .. } = self.run_with(|simulation, _| {
            let (count, walls) = (simulation.body_count, walls().len());
            // The walls are first in the world, and last here.
            let place = |body| (body + count - walls) % count;
            let pairs = simulation.world.touching_pairs().map(|pair| pair.map(place));
            log.add_step(step, &pairs.map(|[a, b]| [a.min(b), a.max(b)]).collect());
            step += 1;
        });
        log.into_events(steps + 1)
    }
}

impl<W: EngineWorld> Simulation<W> {
    /// Builds the world of a scene, with or without a ball.
    ///
    /// # Errors
    /// The reason why the ball is invalid in this scene, or why the scene cannot be simulated.
    pub fn new(scene: &Scene, ball: Option<Ball>) -> Result<Simulation<W>, Invalid> {
        scene.check_form()?;
        let mut world = W::default();
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
        let touch_distance = object.zip(target).map(|(r1, r2)| metres(r1) + metres(r2) + metres(BALL_TOUCH_DISTANCE));
        let goal = [indices[scene.body1], indices[scene.body2]];
        let body_count = walls().len() + scene.bodies.len() + usize::from(ball.is_some());
        Ok(Simulation { world, body_count, dynamic_bodies, goal, touch_distance })
    }

    /// Steps until the task is solved or can no longer be: all bodies sleep, or too few steps are left.
    pub fn run(mut self) -> Outcome {
        let mut touch_steps = 0;
        for steps in 1..=MAX_STEPS {
            touch_steps = if self.step() { touch_steps + 1 } else { 0 };
            if touch_steps == GOAL_STEPS {
                return Outcome { solved: true, steps };
            }
            let asleep_apart = touch_steps == 0 && !self.world.is_awake();
            if asleep_apart || touch_steps + (MAX_STEPS - steps) < GOAL_STEPS {
                break;
            }
        }
        Outcome { solved: false, steps: MAX_STEPS }
    }

    /// Runs to the end, and keeps every pose.
    pub fn rollout(self) -> Rollout {
        let bodies = self.dynamic_bodies.iter().map(|&(index, _)| index).collect();
        let (mut poses, mut touching) = (Vec::new(), Vec::new());
        let Outcome { solved, steps } = self.run_with(|simulation, touches| {
            poses.extend(simulation.poses());
            touching.push(touches);
        });
        Rollout { solved, steps, bodies, poses, touching }
    }

    /// Runs to the end, and returns the digest of all poses.
    pub(super) fn digest(self) -> (Outcome, Digest) {
        let mut digest = Digest::default();
        let mut is_start = true;
        let outcome = self.run_with(|simulation, _| {
            if !std::mem::take(&mut is_start) {
                let poses = (0..simulation.body_count).flat_map(|body| {
                    let origin = simulation.world.origin(body);
                    [origin.x, origin.y, simulation.world.angle(body)]
                });
                digest.add_step(poses);
            }
        });
        (outcome, digest)
    }

    /// Runs to the end, and keeps the sampled paths of the green object and of the ball, which must exist.
    pub(super) fn sampled_paths(self) -> (Outcome, SampledPaths) {
        let &(_, ball) = self.dynamic_bodies.last().expect("the ball moves");
        let object = self.goal[0];
        let mut paths = SampledPaths { object: [[0.0; 2]; SAMPLES], ball: [[0.0; 2]; SAMPLES] };
        let (mut step, mut sample, mut latest) = (0, 0, [[0.0; 2]; 2]);
        let outcome = self.run_with(|simulation, _| {
            latest = [object, ball].map(|body| simulation.pose(body)).map(|[x, y, _]| [x, y]);
            if SAMPLED_STEPS.get(sample) == Some(&step) {
                [paths.object[sample], paths.ball[sample]] = latest;
                sample += 1;
            }
            step += 1;
        });
        paths.object[sample..].fill(latest[0]);
        paths.ball[sample..].fill(latest[1]);
        (outcome, paths)
    }

    /// Steps until the task is solved or `MAX_STEPS` are over. Calls `on_step` at the start and after each step, with
    /// whether the object touches the goal.
    fn run_with(mut self, mut on_step: impl FnMut(&Simulation<W>, bool)) -> Outcome {
        on_step(&self, self.touches());
        let mut touch_steps = 0;
        for steps in 1..=MAX_STEPS {
            let touches = self.step();
            on_step(&self, touches);
            touch_steps = if touches { touch_steps + 1 } else { 0 };
            if touch_steps == GOAL_STEPS {
                return Outcome { solved: true, steps };
            }
        }
        Outcome { solved: false, steps: MAX_STEPS }
    }

    /// Simulates one step. Returns whether the object touches the goal after it.
    fn step(&mut self) -> bool {
        // When all bodies sleep, nothing moves and no contact changes.
        if self.world.is_awake() {
            self.world.step();
        }
        self.touches()
    }

    fn touches(&self) -> bool {
        let [a, b] = self.goal;
        match self.touch_distance {
            Some(touch_distance) => {
                let delta = self.world.origin(a) - self.world.origin(b);
                delta.length_squared().sqrt() < touch_distance
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
        let [x, y] = point_in_px(self.world.origin(index));
        [x, y, self.world.angle(index)]
    }
}

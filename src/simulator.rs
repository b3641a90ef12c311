//! The simulator: a scene and perhaps a ball in, the whole rollout out. The only user of rapier2d.
//!
//! Bit for bit the same natively and in wasm: f32 throughout, libm for the trigonometry, and no order that
//! hangs on a hash. Page, wasm, collection and evaluation all come here. Knows nothing of tasks, pixels or nets.

use std::f32::consts::TAU;

use rapier2d::prelude::*;

use crate::action::{Ball, Invalid};
use crate::rollout::{GOAL_STEPS, MAX_STEPS, Rollout, STEPS_PER_SECOND};
use crate::scene::{Body, Part, Role, Scene, Shape, walls};

/// Raised whenever any rollout changes; stored in weights and collected data.
pub const VERSION: u32 = 1;

/// px per metre (PHYRE).
const SCALE: f64 = 6.0;
/// m/s^2 (PHYRE).
const GRAVITY: f32 = -9.8;
/// kg/m^2 of dynamic bodies (PHYRE).
const DENSITY: f32 = 0.25;
/// Friction coefficient of every body (PHYRE).
const FRICTION: f32 = 0.5;
/// Restitution of every body (PHYRE).
const RESTITUTION: f32 = 0.2;
/// 1/s (PHYRE).
const ANGULAR_DAMPING: f32 = 0.01;
/// Two bodies of which one is no ball touch when a contact's gap is below this, m (Box2D 2.3: two polygon skins).
const TOUCHING_GAP: f32 = 0.02;
/// Two balls touch when their gap is below this, px (PHYRE).
const TOUCHING_BALLS: f64 = 0.1;

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
    let world = World::new(scene, ball)?;
    let bodies = world.moving.iter().map(|&(index, _)| index).collect();
    let (mut poses, mut touching) = (Vec::new(), Vec::new());
    let Outcome { solved, steps } = world.run(|world, touches| {
        poses.extend(world.poses());
        touching.push(touches);
    });
    Ok(Rollout { solved, steps, bodies, poses, touching })
}

/// The same rollout without keeping the poses: for bulk work.
///
/// # Errors
/// Says why the ball may not be there.
pub fn outcome(scene: &Scene, ball: Option<Ball>) -> Result<Outcome, Invalid> {
    Ok(World::new(scene, ball)?.run(|_, _| ()))
}

struct World {
    engine: PhysicsWorld,
    /// The moving bodies: index in the scene, and handle in the engine.
    moving: Vec<(usize, RigidBodyHandle)>,
    /// Their angles, not wrapped, radians.
    angles: Vec<f32>,
    goal: Goal,
}

/// When the green object touches its goal.
enum Goal {
    /// Two balls: their centres are nearer than this, px.
    Balls(RigidBodyHandle, RigidBodyHandle, f64),
    /// Anything else: a pair of these colliders has a contact.
    Contact(Vec<(ColliderHandle, ColliderHandle)>),
}

impl World {
    fn new(scene: &Scene, ball: Option<Ball>) -> Result<World, Invalid> {
        let mut engine = PhysicsWorld::new();
        engine.gravity = Vector::new(0.0, GRAVITY);
        engine.integration_parameters.dt = 1.0 / STEPS_PER_SECOND as f32;
        engine.integration_parameters.contact_recycling = false;
        for wall in walls() {
            insert(&mut engine, &wall);
        }
        let handles: Vec<RigidBodyHandle> = scene.bodies.iter().map(|body| insert(&mut engine, body)).collect();
        let mut moving: Vec<_> = (0..).zip(handles.iter().copied()).filter(|&(i, _)| scene.bodies[i].dynamic).collect();
        if let Some(ball) = ball {
            ball.check(scene)?;
            moving.push((scene.bodies.len(), insert(&mut engine, &red(ball))));
        }
        let (object, target) = (handles[scene.body1], handles[scene.body2]);
        let goal = match (scene.bodies[scene.body1].ball_radius(), scene.bodies[scene.body2].ball_radius()) {
            (Some(r1), Some(r2)) => Goal::Balls(object, target, r1 + r2 + TOUCHING_BALLS),
            _ => {
                let of = |handle: RigidBodyHandle| engine.bodies[handle].colliders().to_vec();
                let pairs = of(object).into_iter().flat_map(|a| of(target).into_iter().map(move |b| (a, b)));
                Goal::Contact(pairs.collect())
            }
        };
        // A ball of an action starts at angle 0, as every body past the scene's.
        let angle = |&(i, _): &(usize, _)| scene.bodies.get(i).map_or(0.0, |body| body.angle as f32);
        let angles = moving.iter().map(angle).collect();
        Ok(World { engine, moving, angles, goal })
    }

    /// Steps until solved or out of steps; `see` gets the world and whether it touches, start included.
    fn run(mut self, mut see: impl FnMut(&World, bool)) -> Outcome {
        see(&self, self.touches());
        let mut held = 0;
        for steps in 1..=MAX_STEPS {
            // Once everything sleeps, nothing moves and no contact changes any more. (Before the first step,
            // the engine has not yet counted anyone as awake.)
            if steps == 1 || self.engine.islands.num_active_bodies() > 0 {
                self.engine.step();
                for (angle, &(_, handle)) in self.angles.iter_mut().zip(&self.moving) {
                    let turn = turned(&self.engine.bodies[handle]) - *angle;
                    *angle += turn - (turn / TAU).round() * TAU;
                }
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
        match &self.goal {
            Goal::Balls(a, b, reach) => {
                let apart = self.engine.bodies[*a].translation() - self.engine.bodies[*b].translation();
                libm::hypot(f64::from(apart.x), f64::from(apart.y)) * SCALE < *reach
            }
            Goal::Contact(pairs) => pairs.iter().any(|&(a, b)| {
                let pair = self.engine.contact_pair(a, b);
                let mut points = pair.into_iter().flat_map(|pair| pair.manifolds()).flat_map(|m| &m.points);
                points.any(|point| point.dist < TOUCHING_GAP)
            }),
        }
    }

    /// The pose of every moving body, in px.
    fn poses(&self) -> impl Iterator<Item = [f32; 3]> {
        self.moving.iter().zip(&self.angles).map(|(&(_, handle), &angle)| {
            let [x, y] = self.engine.bodies[handle].translation().into();
            [x * SCALE as f32, y * SCALE as f32, angle]
        })
    }
}

/// The angle that the engine keeps, -pi..=pi.
fn turned(body: &RigidBody) -> f32 {
    libm::atan2f(body.rotation().im, body.rotation().re)
}

/// The action ball as a body.
fn red(ball: Ball) -> Body {
    let parts = vec![Part::Circle(ball.r)];
    Body { x: ball.x, y: ball.y, angle: 0.0, dynamic: true, shape: Shape::Ball, role: Role::Red, parts }
}

fn insert(engine: &mut PhysicsWorld, body: &Body) -> RigidBodyHandle {
    let metres = |[x, y]: [f64; 2]| Vector::new((x / SCALE) as f32, (y / SCALE) as f32);
    let rigid = if body.dynamic { RigidBodyBuilder::dynamic() } else { RigidBodyBuilder::fixed() };
    let rigid =
        rigid.translation(metres([body.x, body.y])).rotation(body.angle as f32).angular_damping(ANGULAR_DAMPING);
    let handle = engine.insert_body(rigid);
    for part in &body.parts {
        let collider = match part {
            Part::Circle(r) => ColliderBuilder::ball((r / SCALE) as f32),
            Part::Polygon(corners) => ColliderBuilder::convex_polyline(corners.iter().copied().map(metres).collect())
                .expect("the parts of a body are convex polygons"),
        };
        let collider = collider.density(DENSITY).friction(FRICTION).restitution(RESTITUTION);
        engine.insert_collider(collider, Some(handle));
    }
    handle
}

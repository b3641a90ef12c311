//! rapier2d's own physics pipeline as the world of the second engine: a second opinion on the outcome of a ball.
//!
//! The solver, its parameters and its order are rapier's own (`IntegrationParameters::default`). The values that define
//! the puzzles are PHYRE's: scene, gravity, density, friction, restitution, angular damping and the duration of a step.
//! Bodies are swept (continuous collision detection), as in Box2D, and polygons have no skin. rapier computes on one
//! thread, with libm and without unordered maps (feature `enhanced-determinism`).

use rapier2d::dynamics::{RigidBodyBuilder, RigidBodyHandle};
use rapier2d::geometry::{ColliderBuilder, ColliderHandle};
use rapier2d::math::{Rotation, Vector};
use rapier2d::pipeline::PhysicsWorld;

use super::constants::{ANGULAR_DAMPING, DENSITY, FRICTION, GRAVITY, RESTITUTION, TIME_STEP};
use super::distance::{Outline, frame, pose_of};
use super::simulation::EngineWorld;
use crate::puzzle::scene::Body;

pub(crate) struct RapierWorld {
    world: PhysicsWorld,
    bodies: Vec<Tracked>,
}

/// A body, and its full angle including complete turns, which rapier's rotation lacks.
struct Tracked {
    handle: RigidBodyHandle,
    colliders: Vec<ColliderHandle>,
    rotation: Rotation,
    /// Radians, not wrapped.
    angle: f32,
}

impl Default for RapierWorld {
    fn default() -> RapierWorld {
        let mut world = PhysicsWorld { gravity: Vector::new(0.0, GRAVITY), ..PhysicsWorld::default() };
        world.integration_parameters.dt = TIME_STEP;
        RapierWorld { world, bodies: Vec::new() }
    }
}

impl EngineWorld for RapierWorld {
    fn add(&mut self, body: &Body) -> usize {
        let frame = frame(pose_of(body));
        let builder = if body.dynamic { RigidBodyBuilder::dynamic() } else { RigidBodyBuilder::fixed() };
        let rigid_body = builder.pose(frame).angular_damping(ANGULAR_DAMPING).ccd_enabled(true);
        let handle = self.world.insert_body(rigid_body);
        let collider = |(shape, local)| {
            let collider = ColliderBuilder::new(shape).position(local).density(DENSITY);
            self.world.insert_collider(collider.friction(FRICTION).restitution(RESTITUTION), Some(handle))
        };
        let colliders = Outline::of(body).0.into_iter().map(collider).collect();
        self.bodies.push(Tracked { handle, colliders, rotation: frame.rotation, angle: body.angle as f32 });
        self.bodies.len() - 1
    }

    fn is_awake(&self) -> bool {
        self.world.bodies.iter().any(|(_, body)| body.is_dynamic() && !body.is_sleeping())
    }

    fn step(&mut self) {
        self.world.step();
        for body in &mut self.bodies {
            let rotation = *self.world.bodies[body.handle].rotation();
            let turned = body.rotation.inverse() * rotation;
            body.angle += libm::atan2f(turned.im, turned.re);
            body.rotation = rotation;
        }
    }

    fn has_touching_contact(&self, a: usize, b: usize) -> bool {
        let [a, b] = [a, b].map(|body| &self.bodies[body].colliders);
        let mut pairs = a.iter().flat_map(|a| b.iter().map(move |b| (*a, *b)));
        pairs.any(|(a, b)| self.world.narrow_phase.contact_pair(a, b).is_some_and(|pair| pair.has_any_active_contact()))
    }

    fn origin(&self, body: usize) -> Vector {
        self.world.bodies[self.bodies[body].handle].translation()
    }

    fn angle(&self, body: usize) -> f32 {
        self.bodies[body].angle
    }
}

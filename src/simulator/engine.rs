//! The engines by name. Every engine turns a scene and an optional ball into a rollout.
//!
//! The first engine is the port of Box2D, on which everything else is based. rapier2d's own pipeline serves as a second
//! opinion. The wasm omits it: it would make the compressed wasm some 360 kB, or two thirds, larger.

use std::fmt;
use std::str::FromStr;

use serde::{Deserialize, Serialize};

#[cfg(not(target_arch = "wasm32"))]
use super::rapier_world::RapierWorld;
use super::simulation::Outcome;
#[cfg(not(target_arch = "wasm32"))]
use super::simulation::Simulation;
use super::{Digest, VERSION, digest, outcome, simulate};
use crate::puzzle::action::{Ball, Invalid};
use crate::puzzle::rollout::Rollout;
use crate::puzzle::scene::Scene;

/// An engine that computes rollouts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase", try_from = "String")]
pub enum Engine {
    /// The port of Box2D.
    #[default]
    Box2d,
    /// rapier2d's own pipeline, with its own parameters.
    #[cfg(not(target_arch = "wasm32"))]
    Rapier,
}

/// A name that belongs to no engine.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("unknown engine {0}: the engines are box2d and, only in the native program, rapier")]
pub struct UnknownEngine(String);

impl Engine {
    /// All available engines.
    pub const ALL: &[Engine] = &[
        Engine::Box2d,
        #[cfg(not(target_arch = "wasm32"))]
        Engine::Rapier,
    ];

    /// Returns whether this is `box2d`, which output does not name.
    pub fn is_first(&self) -> bool {
        *self == Engine::default()
    }

    /// Returns the version of the engine's rollouts, which is raised whenever any of them changes.
    pub fn version(self) -> u32 {
        match self {
            Engine::Box2d => VERSION,
            #[cfg(not(target_arch = "wasm32"))]
            Engine::Rapier => 2,
        }
    }

    /// Returns the engine's name on the command line and in attempts.
    pub fn name(self) -> &'static str {
        match self {
            Engine::Box2d => "box2d",
            #[cfg(not(target_arch = "wasm32"))]
            Engine::Rapier => "rapier",
        }
    }

    /// Simulates a scene, with or without a ball: see `simulate`.
    ///
    /// # Errors
    /// The reason why the ball is invalid in this scene.
    pub fn simulate(self, scene: &Scene, ball: Option<Ball>) -> Result<Rollout, Invalid> {
        match self {
            Engine::Box2d => simulate(scene, ball),
            #[cfg(not(target_arch = "wasm32"))]
            Engine::Rapier => Ok(Simulation::<RapierWorld>::new(scene, ball)?.rollout()),
        }
    }

    /// Simulates like `simulate`, but keeps no poses.
    ///
    /// # Errors
    /// The reason why the ball is invalid in this scene.
    pub fn outcome(self, scene: &Scene, ball: Option<Ball>) -> Result<Outcome, Invalid> {
        match self {
            Engine::Box2d => outcome(scene, ball),
            #[cfg(not(target_arch = "wasm32"))]
            Engine::Rapier => Ok(Simulation::<RapierWorld>::new(scene, ball)?.run()),
        }
    }

    /// Simulates like `outcome`, and returns the `Digest` of the rollout.
    ///
    /// # Errors
    /// The reason why the ball is invalid in this scene.
    pub fn digest(self, scene: &Scene, ball: Option<Ball>) -> Result<(Outcome, Digest), Invalid> {
        match self {
            Engine::Box2d => digest(scene, ball),
            #[cfg(not(target_arch = "wasm32"))]
            Engine::Rapier => Ok(Simulation::<RapierWorld>::new(scene, ball)?.digest()),
        }
    }
}

impl fmt::Display for Engine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl TryFrom<String> for Engine {
    type Error = UnknownEngine;

    fn try_from(name: String) -> Result<Engine, UnknownEngine> {
        name.parse()
    }
}

impl FromStr for Engine {
    type Err = UnknownEngine;

    fn from_str(name: &str) -> Result<Engine, UnknownEngine> {
        let named = Engine::ALL.iter().find(|engine| engine.name() == name);
        named.copied().ok_or_else(|| UnknownEngine(name.to_string()))
    }
}

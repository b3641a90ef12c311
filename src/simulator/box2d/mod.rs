//! Box2D as PHYRE runs it: a port of erincatto/box2d at commit 33af62e3 (May 2018, between 2.3.1 and 2.4.0), in the
//! same order of operations, so that every pose of every step is the same to the last bit.
//!
//! The port covers the features that the puzzles need: convex shapes, friction, restitution, sleep and continuous
//! collision against static bodies. It has no joints, sensors, filters or forces. Each file is named after the class or
//! function of Box2D that it ports, and the methods after Box2D's methods. Lengths are in metres. This is an altered
//! version of Box2D in another language; `NOTICE` has its licence. Used only by the rest of the simulator.
//!
//! Shortcuts that Box2D does not have are marked as such. Each gives the same bits: the tests compare the least obvious
//! one with the full computation, and recorded rollouts test all of them.

mod body;
mod collide_circle;
mod collide_polygon;
mod contact;
mod contact_manager;
mod contact_solver;
mod distance;
mod fixture;
mod island;
mod manifold;
mod math;
mod shape;
mod sweep;
mod time_of_impact;
mod world;

pub(super) use world::World;

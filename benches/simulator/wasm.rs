//! The simulator in wasm, as one implementation of `make bench`: a module that `web/ours.mjs` calls without
//! wasm-bindgen.

mod rollouts;

use std::cell::RefCell;

use pathlight::puzzle::action::Ball;
use pathlight::puzzle::scene::Scene;
use pathlight::simulator::Simulation;

thread_local! {
    static ROLLOUTS: Vec<(Scene, Ball)> = rollouts::rollouts();
    static STARTED: RefCell<Option<Simulation>> = const { RefCell::new(None) };
}

/// Returns the location of the final states' text in memory: its address and its length in bytes.
#[unsafe(no_mangle)]
pub extern "C" fn final_states() -> *const [usize; 2] {
    let text = ROLLOUTS.with(|rollouts| rollouts::final_states(rollouts)).leak();
    Box::leak(Box::new([text.as_ptr() as usize, text.len()]))
}

#[unsafe(no_mangle)]
pub extern "C" fn count() -> usize {
    ROLLOUTS.with(Vec::len)
}

/// Builds the world of a rollout.
#[unsafe(no_mangle)]
pub extern "C" fn start(index: usize) {
    let simulation = ROLLOUTS.with(|rollouts| rollouts::start(&rollouts[index]));
    STARTED.with(|started| started.replace(Some(simulation)));
}

/// Runs the rollout that was started last.
#[unsafe(no_mangle)]
pub extern "C" fn run() {
    STARTED.with(|started| started.take().expect("a rollout was started").run());
}

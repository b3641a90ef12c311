//! Runs the simulator natively, as one implementation of `make bench`; `benches/bench.mjs` decides when each
//! implementation runs.
//!
//! `export FILE` writes the rollouts for the other implementations. `rollouts` times the stepping of all rollouts;
//! `worlds` times the building of their worlds. Both first print how each rollout ends.

use std::time::Duration;
use std::{env, fs};

use export::export;
use repeat::{repeat, stopwatch};
use rollouts::{final_states, rollouts, start};

mod export;
#[path = "../repeat.rs"]
mod repeat;
mod rollouts;

fn main() {
    let arguments: Vec<String> = env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let rollouts = rollouts();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["export", file] => fs::write(file, export(&rollouts)).expect("the file can be written"),
        ["rollouts"] => repeat(&final_states(&rollouts), || {
            let step = |rollout| {
                let simulation = start(rollout);
                stopwatch(|| simulation.run())
            };
            rollouts.iter().map(step).sum::<Duration>()
        }),
        ["worlds"] => {
            repeat(&final_states(&rollouts), || stopwatch(|| rollouts.iter().for_each(|rollout| drop(start(rollout)))))
        }
        _ => println!("`make bench` runs this, with implementations to compare it with"),
    }
}

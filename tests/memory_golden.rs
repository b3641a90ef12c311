//! An agent with a memory tries the same balls in the same order, with the same probabilities bit for bit, natively and
//! in wasm. So does one that reads its memory from a file halfway.
//!
//! The balls are random balls in a few tasks, and the outcomes follow a made-up rule that can be learned. When the
//! order is meant to change, replace the digest by the one that the test prints, and raise `memory::VERSION`.

use md5::{Digest, Md5};
use pathlight::agents::memory::{Memory, PuzzleSource};
use pathlight::agents::online::{OnlineAgent, Similarity};
use pathlight::agents::{Agent, Observation};
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::{Task, ids};
use pathlight::puzzle::templates::TEMPLATES;

/// Number of puzzles of each of two templates.
const PUZZLES: usize = 6;

/// Number of attempts at a puzzle.
const ATTEMPTS: usize = 20;

const GOLDEN: &str = "d32650a8e6a376577d07bc577811b97a";

#[cfg_attr(not(target_arch = "wasm32"), test)]
#[cfg_attr(target_arch = "wasm32", wasm_bindgen_test::wasm_bindgen_test)]
fn a_carried_run_is_as_it_was() {
    let mut memory = Memory::default();
    let mut md5 = Md5::new();
    let mut firsts = Vec::new();
    for number in 0..2 * PUZZLES {
        let template = TEMPLATES[[2, 7][number % 2]];
        let id = ids(template).nth(number / 2).expect("a task");
        let scene = Task::load(id).expect("a task").scene;
        if number == PUZZLES {
            let json = memory.to_json(Some("weights"));
            memory = Memory::default();
            memory.read_json(json.as_bytes(), Some("weights")).expect("a memory");
        }
        let recollection = memory.begin(PuzzleSource::Task(id), &scene);
        let candidates = recollection.random_candidates(&scene, id.seed(0), ATTEMPTS);
        let mut agent = OnlineAgent::new(candidates, Similarity::OF_BALLS);
        let first = (1..=ATTEMPTS).find(|_| {
            let proposal = agent.propose().expect("a candidate is left");
            let chance = proposal.chance().expect("a probability");
            let reminder = recollection.reminder(proposal.ball);
            let change = reminder.map_or(0, |reminder| reminder.change.to_bits());
            md5.update(format!("{id} {} {:016x} {change:016x}\n", proposal.ball, chance.to_bits()));
            let solved = solves(&scene, proposal.ball.x);
            memory.observe(proposal.ball, chance, solved);
            agent.observe(&Observation { solved, paths: None });
            solved
        });
        firsts.push(first.unwrap_or(ATTEMPTS + 1));
    }
    let halves: [usize; 2] = [&firsts[..PUZZLES], &firsts[PUZZLES..]].map(|half| half.iter().sum());
    assert!(halves[1] < halves[0], "it learns: {firsts:?}");
    md5.update(memory.to_json(None));
    let digest: String = md5.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
    assert_eq!(digest, GOLDEN);
}

/// Returns whether a ball is near the green object's column.
fn solves(scene: &Scene, x: f64) -> bool {
    (x - scene.bodies[scene.body1].x).abs() < 16.0
}

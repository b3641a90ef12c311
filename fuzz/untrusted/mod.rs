//! Untrusted input: one function for each kind, the fuzz targets, from the bytes to what becomes of them. None may
//! panic, hang, or refuse without a word, whatever the bytes are.
//!
//! `targets/` feeds them with libFuzzer, `lab/tests/untrusted_input.rs` with the corpus and mutations of it. The
//! parsers of the player's command line are modules of its binary, so they are included here by their paths.

use std::path::Path;
use std::str;

use pathlight::agents;
use pathlight::agents::memory::Memory;
use pathlight::nets::PathNet;
use pathlight::nets::success_net::logit_index;
use pathlight::puzzle::custom_scene::{CustomScene, sentences};
use pathlight::puzzle::rollout::Rollout;
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::raster;
use pathlight::session::puzzle::Puzzle;
use pathlight::simulator::simulate;
use pathlight::verification::{AttemptLine, Verdict};
use pathlight_lab::data::labels::LabelledBalls;
use pathlight_lab::data::solutions::TaskSolutions;
use pathlight_lab::files::journal::{self, Entry};
use serde_json::Value;

use commands::json_lines::{Lines, MAX_LINE, parse};
use commands::simulate::start::{Place, Request};

mod any_scene;
mod weights_file;

#[path = "../../src/commands"]
#[allow(dead_code)]
mod commands {
    pub mod agent {
        pub mod lines;
    }
    pub mod json_lines;
    pub mod simulate {
        pub mod start;
    }
}

/// Takes any bytes, and panics if what becomes of them breaks a promise.
pub type Target = fn(&[u8]);

/// All targets by name.
pub const ALL: [(&str, Target); 10] = [
    ("scene", scene),
    ("task", task),
    ("batch", batch),
    ("weights", weights),
    ("solutions", solutions),
    ("labels", labels),
    ("agent", agent),
    ("memory", memory),
    ("attempts", attempts),
    ("simulator", simulator),
];

/// A custom scene as a file, a link or the page's storage holds it.
pub fn scene(bytes: &[u8]) {
    let Ok(value) = serde_json::from_slice::<Value>(bytes) else { return };
    let custom = match CustomScene::read(value.clone()) {
        Ok(custom) => custom,
        Err(problems) => return assert!(!problems.is_empty() && problems.iter().all(is_sentence)),
    };
    match Puzzle::read(value) {
        Ok(puzzle) => {
            let written = serde_json::to_vec(&custom).expect("plain data");
            let again = serde_json::from_slice(&written).expect("JSON");
            assert_eq!(CustomScene::read(again), Ok(custom), "a scene is read as it was written");
            run(&puzzle.scene);
        }
        Err(problems) => assert!(!problems.is_empty() && problems.iter().all(is_sentence)),
    }
}

/// Lines of an id of a task, an action and a ball, as a person types them.
pub fn task(bytes: &[u8]) {
    let Ok(text) = str::from_utf8(bytes) else { return };
    let mut lines = text.lines();
    let mut line = || lines.next().unwrap_or_default();
    let (id, action, ball) = (line(), line(), line());
    let action = commands::simulate::start::parse_action(action);
    let ball = commands::simulate::start::parse_ball(ball);
    let id = match id.parse::<TaskId>() {
        Ok(id) => id,
        Err(why) => return says_why(&why),
    };
    assert_eq!(id.to_string(), id.to_string().parse::<TaskId>().expect("an id").to_string());
    let task = match Task::load(id) {
        Ok(task) => task,
        Err(why) => return says_why(&why),
    };
    if let Ok(placed) = action.map(|action| action.place(&task.scene)) {
        assert!(placed.map_or_else(|why| !why.to_string().is_empty(), |ball| ball.check(&task.scene).is_ok()));
    }
    if let Ok(ball) = ball {
        let _ = simulate(&task.scene, Some(ball)).inspect_err(says_why);
    }
}

/// Lines of `pathlight simulate --batch`.
pub fn batch(bytes: &[u8]) {
    for line in Lines::new(bytes, MAX_LINE).take(4) {
        let text = line.map_err(Into::into).and_then(|line| line.text);
        let request = text.and_then(|text| parse::<Request>(&text, "write another"));
        let Ok(Request { place, start }) = request.inspect_err(says_why) else { continue };
        let puzzle = match place {
            Place::Task(task) => Task::load(task).map(Puzzle::from).map_err(|why| why.to_string()),
            Place::Scene(scene) => Puzzle::read(scene).map_err(|problems| sentences(&problems)),
        };
        let Ok(Puzzle { scene, .. }) = puzzle.inspect_err(says_why) else { continue };
        let placed = start.place(&scene).inspect_err(says_why);
        let _ = placed.and_then(|ball| simulate(&scene, ball)).inspect_err(says_why);
    }
}

/// A file of weights: the bytes, and the shipped file with its head changed by the bytes.
pub fn weights(bytes: &[u8]) {
    for file in [bytes.to_vec(), weights_file::changed(bytes)] {
        let _ = PathNet::load(&file).inspect_err(says_why);
    }
}

/// A file of `pathlight-lab data collect`.
pub fn solutions(bytes: &[u8]) {
    journal::<TaskSolutions>(bytes);
}

/// A file of `pathlight-lab data label`. What it lets through can be trained on.
pub fn labels(bytes: &[u8]) {
    for line in journal::<LabelledBalls>(bytes) {
        assert!(line.solved.iter().chain(&line.failed).all(|&ball| logit_index(ball).is_ok()));
    }
}

/// Lines that `pathlight agent` is told.
pub fn agent(bytes: &[u8]) {
    use commands::agent::lines::{Begun, Line, MAX_LINE};
    for line in Lines::new(bytes, MAX_LINE) {
        match line.map_err(Into::into).and_then(|line| line.text).and_then(|text| Line::parse(&text)) {
            Ok(Line::Begin { puzzle: Begun::Scene(scene), .. }) => look_at(&scene),
            Ok(Line::Begin { puzzle: Begun::Custom(puzzle), .. }) => look_at(&puzzle.scene),
            Ok(Line::Begin { puzzle: Begun::Task(id), .. }) => drop(Task::load(id).inspect_err(says_why)),
            Ok(Line::Forget | Line::Outcome { .. }) => {}
            Err(why) => says_why(&why),
        }
    }
}

/// A file of what an agent remembers.
pub fn memory(bytes: &[u8]) {
    let read = |json: &[u8]| {
        let mut memory = Memory::default();
        memory.read_json(json, None).map(|()| memory)
    };
    let Ok(memory) = read(bytes).inspect_err(says_why) else { return };
    let written = memory.to_json(None);
    let again = read(written.as_bytes()).expect("a memory that was written");
    assert_eq!(again.to_json(None), written, "a memory is read as it was written");
}

/// A line of an attempt that the page exports, imports and verifies.
pub fn attempts(bytes: &[u8]) {
    let Ok(line) = serde_json::from_slice::<AttemptLine>(bytes).inspect_err(says_why) else { return };
    match line.verify() {
        Verdict::Same => {}
        Verdict::OtherOutcome { reason, .. } | Verdict::NotValid { reason, .. } => says_why(&reason),
    }
}

/// Any scene that a caller of the library can build, and any ball.
pub fn simulator(bytes: &[u8]) {
    let Ok((scene, ball)) = any_scene::from_bytes(bytes) else { return };
    match (scene.check_form(), ball) {
        (Ok(()), None) => run(&scene),
        (Ok(()), Some(ball)) => match simulate(&scene, Some(ball)) {
            Ok(rollout) => check(&scene, &rollout),
            Err(why) => says_why(&why),
        },
        (Err(why), _) => {
            says_why(&why);
            assert!(simulate(&scene, ball).is_err());
        }
    }
}

fn journal<E: Entry>(bytes: &[u8]) -> Vec<E> {
    match journal::parse::<E>(bytes, Path::new("a file")) {
        Ok(contents) => contents.entries,
        Err(why) => {
            says_why(&why);
            Vec::new()
        }
    }
}

/// Simulates a scene of the right form and draws it.
fn run(scene: &Scene) {
    check(scene, &simulate(scene, None).expect("a scene of the right form"));
    look_at(scene);
}

/// Draws a rollout, whose poses are numbers.
fn check(scene: &Scene, rollout: &Rollout) {
    assert!(rollout.poses.as_flattened().iter().all(|number| number.is_finite()), "a pose is no number");
    assert_eq!(rollout.poses.len(), (rollout.steps + 1) * rollout.bodies.len());
    raster::path_image(&scene.bodies[scene.body1], rollout, scene.body1);
}

/// Does what an agent without nets does.
fn look_at(scene: &Scene) {
    raster::scene_channels(scene);
    raster::scene_coverage(scene);
    for proposal in agents::random(scene, 0, 2) {
        assert_eq!(proposal.ball.check(scene), Ok(()));
    }
}

/// Asserts that an error is more than a word, and not a page.
fn says_why(why: &impl ToString) {
    let said = why.to_string();
    assert!(said.len() > 10 && said.len() < 100_000, "refused with {said:?}");
}

fn is_sentence(problem: &pathlight::puzzle::custom_scene::Problem) -> bool {
    problem.sentence.ends_with('.') && problem.sentence.len() > 20
}

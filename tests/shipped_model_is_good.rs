//! A lower bound for the shipped model: on test tasks that it has not seen, it is far better than chance.
#![cfg(not(target_arch = "wasm32"))]

use pathlight::agents::{self, Proposal};
use pathlight::benchmark::auccess::{MAX_ATTEMPTS, auccess};
use pathlight::benchmark::folds::Fold;
use pathlight::nets::PathNet;
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::simulator::outcome;

const WEIGHTS: &[u8] = include_bytes!("../assets/within-0.safetensors");

/// Required lead over the random agent in AUCCESS on these tasks, percentage points. A smaller lead means that the
/// proposals have become worse, and not by chance.
const MARGIN: f64 = 40.0;

#[test]
fn one_test_task_of_each_template_is_solved_much_sooner_than_at_random() {
    let (nets, card) = PathNet::load(WEIGHTS).expect("our own weights");
    let test = Fold::new(card.setup, card.fold).test;
    let tasks: Vec<TaskId> = test.chunk_by(|a, b| a.template == b.template).map(|tasks| tasks[0]).collect();
    let score = |propose: &dyn Fn(TaskId, &Scene) -> Vec<Proposal>| {
        let first_solved: Vec<Option<usize>> = tasks
            .iter()
            .map(|&id| {
                let scene = Task::load(id).expect("a task of the fold").scene;
                let solves = |one: &Proposal| outcome(&scene, Some(one.ball)).expect("a valid ball").solved;
                propose(id, &scene).iter().position(solves).map(|index| index + 1)
            })
            .collect();
        auccess(&first_solved)
    };
    let random = score(&|id, scene| agents::random(scene, id.seed(0), MAX_ATTEMPTS));
    let dynamics = score(&|id, scene| agents::propose(&nets, scene, id.seed(0), MAX_ATTEMPTS));
    let paper = score(&|id, scene| agents::from_map(&nets, scene, id.seed(0), MAX_ATTEMPTS));
    println!("{} tasks: dynamics {dynamics:.1}, paper {paper:.1}, random {random:.1}", tasks.len());
    assert!(dynamics > random + MARGIN, "dynamics {dynamics:.1}, random {random:.1}");
    assert!(paper > random + MARGIN / 2.0, "paper {paper:.1}, random {random:.1}");
}

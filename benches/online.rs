//! Chooses the online agent's similarity: prints the auccess on the dev tasks of the weights' fold for a grid of
//! similarities.
//!
//! Every candidate of these tasks is simulated once in advance, so a turn takes little time. This is only for choosing
//! constants: an agent learns only from its counted attempts. The figures predict performance on new tasks only if the
//! weights were trained without the dev tasks: `cargo bench --features ndarray --bench online -- WEIGHTS`.

use std::io::{self, Write};

use pathlight::agents::imagined_candidates::imagined_candidates;
use pathlight::agents::online::{Candidate, OnlineAgent, Similarity};
use pathlight::agents::squared_exponential::SquaredExponential;
use pathlight::agents::{Agent, Observation};
use pathlight::benchmark::auccess::{MAX_ATTEMPTS, auccess, solved_within};
use pathlight::benchmark::folds::Fold;
use pathlight::nets::PathNet;
use pathlight::puzzle::task::Task;
use pathlight::simulator::sampled_paths;
use rayon::prelude::*;

/// Variances and length scales, px, of balls and of paths; a variance of zero disables the term.
const BALLS: [(f64, f64); 6] = [(0.0, 1.0), (8.0, 4.5), (16.0, 4.5), (16.0, 7.0), (32.0, 4.5), (32.0, 7.0)];
const PATHS: [(f64, f64); 6] = [(0.0, 1.0), (0.5, 8.0), (1.0, 10.0), (2.0, 8.0), (4.0, 10.0), (4.0, 18.0)];

/// The candidates of a task, and the outcome of each.
type Puzzle = (Vec<Candidate>, Vec<Observation>);

fn main() -> io::Result<()> {
    let words: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    let Some(weights) = words.first() else {
        return writeln!(io::stderr(), "name the weights: cargo bench --features ndarray --bench online -- FILE");
    };
    let bytes = std::fs::read(weights)?;
    let (nets, card) = PathNet::load(&bytes).map_err(io::Error::other)?;
    let mut out = io::stdout();
    if !card.dynamics.is_some_and(|dynamics| dynamics.without_dev) {
        writeln!(out, "{weights} was trained on the dev tasks too: the figures are too good")?;
    }
    let tasks = Fold::new(card.setup, card.fold).dev;
    let puzzles: Vec<Puzzle> = tasks
        .par_iter()
        .map(|&id| {
            let scene = Task::load(id).expect("a task of the fold").scene;
            let candidates = imagined_candidates(&nets, &scene, MAX_ATTEMPTS).expect("the weights have a dynamics net");
            let told = candidates.iter().map(|candidate| {
                let (outcome, paths) = sampled_paths(&scene, candidate.ball).expect("a valid ball");
                Observation { solved: outcome.solved, paths: Some(paths) }
            });
            let told = told.collect();
            (candidates, told)
        })
        .collect();
    writeln!(
        out,
        "{} dev tasks; variance and length scale of balls, of paths; auccess, solved at once, within 10",
        tasks.len()
    )?;
    for balls in BALLS {
        for paths in PATHS {
            let kernel = |(variance, length_scale)| SquaredExponential { variance, length_scale };
            let similarity = Similarity { balls: kernel(balls), paths: kernel(paths) };
            for (told, what) in [(true, "paths told"), (false, "outcomes alone")] {
                let first: Vec<_> = puzzles.par_iter().map(|puzzle| first_solved(puzzle, similarity, told)).collect();
                let [one, ten] = [1, 10].map(|attempts| 100.0 * solved_within(&first, attempts));
                writeln!(out, "{balls:?} {paths:?} {what}: {:.2} {one:.0} % {ten:.0} %", auccess(&first))?;
            }
        }
    }
    Ok(())
}

fn first_solved((candidates, outcomes): &Puzzle, similarity: Similarity, told: bool) -> Option<usize> {
    let mut agent = OnlineAgent::new(candidates.clone(), similarity);
    (1..=MAX_ATTEMPTS).find(|_| {
        let Some(proposal) = agent.propose() else { return false };
        let index = candidates.iter().position(|candidate| candidate.ball == proposal.ball).expect("a candidate");
        let Observation { solved, paths } = outcomes[index];
        agent.observe(&Observation { solved, paths: paths.filter(|_| told) });
        solved
    })
}

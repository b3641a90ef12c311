//! Measures agents that keep what they learned from task to task, as PHYRE's DQN-O does (Bakhtin et al. 2019): they
//! play the tasks of a fold in sequence and are never reset. Only counted attempts are simulated.

use pathlight::agents::agent_name::Loaded;
use pathlight::agents::memory::{Memory, PuzzleSource};
use pathlight::benchmark::auccess::MAX_ATTEMPTS;
use pathlight::puzzle::stable_shuffle::stable_shuffle;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::session::turn::Turn;
use rayon::prelude::*;

use super::report::{Order, Player, Score};
use crate::progress::Progress;

/// Measures players on some tasks, which each player plays in sequence.
///
/// # Errors
/// If the benchmark lacks a task.
pub fn scores(
    players: &[Player],
    loaded: Loaded,
    tasks: &[TaskId],
    seed: u64,
    progress: &mut dyn Progress,
) -> anyhow::Result<Vec<Score>> {
    if players.is_empty() {
        return Ok(Vec::new());
    }
    progress.begin(players.len() as u64);
    let play = |&player: &Player| Ok(Score::new(player, first_solved(player, loaded, tasks, seed)?));
    let scores = players.par_iter().map(play).collect::<anyhow::Result<Vec<_>>>()?;
    progress.advance(players.len() as u64, "orders played".to_string());
    progress.finish(&format!("{} orders played with a memory", players.len()));
    Ok(scores)
}

/// Returns the first solving attempts, in the order of `tasks`.
fn first_solved(player: Player, loaded: Loaded, tasks: &[TaskId], seed: u64) -> anyhow::Result<Vec<Option<usize>>> {
    let in_order: Vec<usize> = (0..tasks.len()).collect();
    let order = match player.memory {
        Some(Order::Shuffled(seed)) => stable_shuffle(in_order, &seed.to_string()),
        Some(Order::Ids) | None => in_order,
    };
    let mut memory = Memory::default();
    let mut firsts = vec![None; tasks.len()];
    for index in order {
        let Task { id, scene, .. } = Task::load(tasks[index])?;
        let recollection = memory.begin(PuzzleSource::Task(id), &scene);
        let agent = player.agent.start_with(loaded, &scene, id.seed(seed), MAX_ATTEMPTS, &recollection);
        let mut turn = Turn::new(scene, agent);
        for attempt in 1.. {
            let Some((proposal, rollout)) = turn.attempt().expect("agents propose valid balls") else { break };
            memory.observe(proposal.ball, proposal.chance().unwrap_or_default(), rollout.solved);
            if rollout.solved {
                firsts[index] = Some(attempt);
            }
        }
    }
    Ok(firsts)
}

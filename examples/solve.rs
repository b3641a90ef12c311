// Solves a task with the model, ball by ball: cargo run --release --example solve

use std::error::Error;
use std::fs;

use pathlight::agents;
use pathlight::nets::PathNet;
use pathlight::puzzle::task::Task;
use pathlight::session::ending::Ending;
use pathlight::session::turn::Turn;

fn main() -> Result<(), Box<dyn Error>> {
    let task = Task::load("00007:008".parse()?)?;
    let (nets, _) = PathNet::load(&fs::read("assets/within-0.safetensors")?)?;
    println!("{}", task.goal);

    let agent = agents::start(&nets, &task.scene, task.id.seed(0), 100);
    let mut turn = Turn::new(task.scene, agent);
    while let Some((proposal, rollout)) = turn.attempt()? {
        let Ending { solved, longest_touch, .. } = Ending::of(&rollout);
        println!("{:?}: solved {solved}, {longest_touch} steps on the goal", proposal.ball);
    }
    Ok(())
}

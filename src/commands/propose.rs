//! `pathlight propose`: the model's proposals for a fold's test tasks, as JSON lines. Nothing is simulated, so that the
//! proposals can be evaluated elsewhere, for example on PHYRE's own engine.

use std::io::{self, Write};
use std::path::PathBuf;

use pathlight::agents;
use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::folds::FoldId;
use pathlight::command_line::fold_args::FoldArgs;
use pathlight::command_line::progress::Progress;
use pathlight::command_line::replace_file::{check_replaceable, replace_file};
use pathlight::command_line::weights_file::ModelFile;
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::session::puzzle::Puzzle;
use rayon::prelude::*;
use serde::Serialize;

use super::custom_scene_file;

/// Write the model's proposals as JSON lines, best first, without simulating
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    fold: FoldArgs,

    /// Task to propose for, like 00007:008; can be repeated [default: all test tasks of the fold]
    #[arg(long = "task", value_name = "TASK")]
    tasks: Vec<TaskId>,

    /// Propose for the custom scene in this file instead ("-" is standard input), JSON as described by `tasks --schema`
    #[arg(long, value_name = "FILE", conflicts_with = "tasks")]
    scene: Option<PathBuf>,

    /// Proposals per task
    #[arg(long, default_value_t = 100, value_parser = clap::value_parser!(u16).range(1..=1000))]
    attempts: u16,

    /// Seed of all random draws
    #[arg(long, default_value_t = 0)]
    seed: u64,

    /// File to write; "-" is standard output
    #[arg(long, default_value = "-")]
    out: PathBuf,

    /// Weights of the model [default: assets/SETUP-FOLD.safetensors]
    #[arg(long, value_name = "FILE")]
    weights: Option<PathBuf>,
}

/// A line of output: the valid balls of a task, px, best first.
#[derive(Serialize)]
struct TaskProposals {
    /// Absent for a custom scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    task: Option<TaskId>,
    balls: Vec<Ball>,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let fold = FoldId::from(self.fold);
        let to_stdout = self.out.as_os_str() == "-";
        if !to_stdout {
            check_replaceable(&self.out)?;
        }
        let model = ModelFile::read(self.weights.as_deref(), fold)?;
        model.check(AgentName::default_of(&model.nets), fold)?;
        let custom = self.scene.as_deref().map(custom_scene_file::read).transpose()?;
        let tasks = if custom.is_some() {
            Vec::new()
        } else if self.tasks.is_empty() {
            fold.tasks().test
        } else {
            self.tasks
        };
        // A file is written once all lines are complete, standard output line by line.
        let (mut stdout, mut file) = (io::stdout().lock(), Vec::new());
        let out: &mut dyn Write = if to_stdout { &mut stdout } else { &mut file };
        let proposals = |Puzzle { id, scene, .. }: Puzzle| {
            let proposals = agents::propose(&model.nets, &scene, id.seed(self.seed), self.attempts.into());
            TaskProposals { task: id.task(), balls: proposals.into_iter().map(|proposal| proposal.ball).collect() }
        };
        if let Some(puzzle) = custom {
            writeln!(out, "{}", serde_json::to_string(&proposals(puzzle))?)?;
        }
        let mut progress = Progress::new(Some(tasks.len() as u64));
        for tasks in tasks.chunks(25) {
            let lines: Vec<TaskProposals> =
                tasks.par_iter().map(|&task| Ok(proposals(Task::load(task)?.into()))).collect::<anyhow::Result<_>>()?;
            for line in lines {
                writeln!(out, "{}", serde_json::to_string(&line)?)?;
            }
            progress.advance(tasks.len() as u64, "tasks".to_string());
        }
        if !to_stdout {
            replace_file(&self.out, &file)?;
        }
        progress.finish(&format!("{} puzzles", tasks.len().max(1)));
        Ok(())
    }
}

//! `pathlight agent`: an agent that plays against any simulator, over JSON lines. `simulate --batch - --paths` is its
//! counterpart: it reads the agent's lines and writes the lines that the agent reads.
//!
//! `json_lines` defines the protocol, and `player` answers. A line that cannot be used changes nothing.

use std::io::{self, Write};
use std::path::PathBuf;

use anyhow::{Context, ensure};
use pathlight::agents::agent_name::{AgentName, Needs};
use pathlight::command_line::agent_arg::agent;
use pathlight::command_line::fold_args::FoldArgs;
use pathlight::command_line::weights_file::{ModelFile, read_dqn};

use super::json_lines::{Lines, Numbered, Refusal};
use lines::{Line, MAX_LINE};
use memory_file::MemoryFile;
use player::Player;

mod lines;
mod memory_file;
mod player;

/// Play against any simulator: read tasks and outcomes as JSON lines, and answer each with the next ball
///
/// {"task":"00007:008"} begins a puzzle. So does {"scene":{…}}, with a scene as printed by `tasks --json` or
/// `tasks --custom`. The answer is {"line","task","ball":[x,y,r]}: the number of the line, and the first ball in px.
///
/// {"status":"solved"}, "not_solved" or "invalid" is the outcome of that ball. The line may also have
/// "paths":{"object":[[x,y,angle],…],"ball":[…]}, the poses of the green object and of the ball at the start and at
/// every tenth step, in px and radians. The answer is the next ball, or "ball":null once the puzzle is solved, 100
/// attempts have been made or no ball is left.
///
/// {"task":"00007:008","remember":true} begins a puzzle with what earlier puzzles with "remember" taught, and remembers
/// its attempts. The answer may have "reminder": the puzzle that changed the chance of the ball most. {"forget":true}
/// forgets everything, and the answer is {"line","remembered":0}.
///
/// A line that cannot be used changes nothing, and the answer is {"line","error"}. If there was one, the exit code is
/// 2. Blank lines are not answered.
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    fold: FoldArgs,

    /// Agent to play with [default: the first of online, success and paper for which the weights have the nets]
    #[arg(long, value_parser = agent())]
    agent: Option<AgentName>,

    /// Seed of all random draws
    #[arg(long, default_value_t = 0)]
    seed: u64,

    /// Weights of the model [default: assets/SETUP-FOLD.safetensors]
    #[arg(long, value_name = "FILE")]
    weights: Option<PathBuf>,

    /// Weights of DQN, the benchmark's baseline [default for --agent dqn:
    /// target/train/SETUP-FOLD/dqn/weights.safetensors]
    #[arg(long, value_name = "FILE")]
    dqn: Option<PathBuf>,

    /// Keep what puzzles with "remember" teach in this file, and begin with what it holds; one process at a time can
    /// use it, which FILE.lock ensures
    #[arg(long, value_name = "FILE")]
    memory: Option<PathBuf>,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let fold = self.fold.into();
        let (mut weights, mut nets, mut dqn) = (None, None, None);
        let agent = match self.agent {
            Some(agent) if agent.needs() == Needs::Nothing => agent,
            Some(AgentName::Dqn) => {
                dqn = Some(read_dqn(self.dqn.as_deref(), fold)?.0);
                AgentName::Dqn
            }
            named => {
                let model = ModelFile::read(self.weights.as_deref(), fold)?;
                let agent = named.unwrap_or_else(|| AgentName::default_of(&model.nets));
                model.check(agent, fold)?;
                (weights, nets) = (Some(model.digest), Some(model.nets));
                agent
            }
        };
        if self.memory.is_some() {
            agent.check_remembers()?;
        }
        let opened = self.memory.as_deref().map(|path| MemoryFile::open(path, weights)).transpose()?;
        let (mut file, memory) = opened.unzip();
        let memory = memory.unwrap_or_default();
        let mut player = Player { agent, nets, dqn, seed: self.seed, memory, puzzle: None };
        let played = play(&mut player, file.as_mut());
        if let Some(file) = &mut file {
            file.save(&player.memory)?;
        }
        let refused = played?;
        ensure!(
            refused == 0,
            "{refused} line{} could not be used; the answers say why",
            if refused == 1 { "" } else { "s" }
        );
        Ok(())
    }
}

/// Answers the lines of standard input, and returns how many could not be used.
fn play(player: &mut Player, mut file: Option<&mut MemoryFile>) -> anyhow::Result<usize> {
    let mut out = io::stdout().lock();
    let mut refused = 0;
    for read in Lines::new(io::stdin().lock(), MAX_LINE) {
        let read = read.context("cannot read standard input")?;
        if read.is_blank() {
            continue;
        }
        let line = read.number;
        let mut begins = false;
        let answer = read.text.and_then(|text| {
            let line = Line::parse(&text)?;
            begins = matches!(line, Line::Begin { .. });
            player.answer(line)
        });
        match answer {
            Ok(answer) => {
                // A puzzle may also end because the next one begins.
                if (answer.ends_puzzle() || begins)
                    && let Some(file) = &mut file
                {
                    file.save(&player.memory)?;
                }
                serde_json::to_writer(&mut out, &Numbered { line, answer })?;
            }
            Err(error) => {
                refused += 1;
                serde_json::to_writer(&mut out, &Numbered { line, answer: Refusal::from(&error) })?;
            }
        }
        writeln!(out)?;
        out.flush()?;
    }
    Ok(refused)
}

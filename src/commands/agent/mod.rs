//! `pathlight agent`: an agent that plays against any simulator, over JSON lines. `simulate --batch - --paths` is the
//! other side: it reads the agent's lines and writes the lines that the agent reads.
//!
//! `json_lines` has the protocol. A line that cannot be used changes nothing. `player` answers.

use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;

use anyhow::{Context, ensure};
use pathlight::agents::agent_name::AgentName;
use pathlight::agents::memory::Memory;

use super::agent_arg::agent;
use super::fold_args::FoldArgs;
use super::json_lines::{Lines, Numbered, Refusal};
use super::model_args::{DqnArgs, ModelArgs};
use lines::{Line, MAX_LINE};
use player::Player;

mod lines;
mod player;

/// Play against any simulator: read tasks and outcomes as JSON lines, and answer each with the next ball
///
/// {"task":"00007:008"} begins a puzzle. So does {"scene":{…}}, with a scene as `tasks --json` or `tasks --custom`
/// prints it. The answer is {"line","task","ball":[x,y,r]}: the number of the line, and the first ball in px.
///
/// {"status":"solved"}, "not_solved" or "invalid" is the outcome of that ball. The line may also have
/// "paths":{"object":[[x,y,angle],…],"ball":[…]}, the poses of the green object and of the ball at the start and at
/// every tenth step, in px and radians. The answer is the next ball, or "ball":null once the puzzle is solved, 100
/// attempts are made or no ball is left.
///
/// {"task":"00007:008","remember":true} begins a puzzle with what earlier such puzzles taught, and remembers its
/// attempts. The answer may have "reminder": the puzzle that changed the chance of the ball most. {"forget":true}
/// forgets all, and is answered with {"line","remembered":0}.
///
/// A line that cannot be used changes nothing and is answered with {"line","error"}; if there was one, the exit code is
/// 2. Blank lines are not answered.
#[derive(clap::Args)]
pub struct Args {
    #[command(flatten)]
    fold: FoldArgs,

    /// Agent that plays [default: the first that the weights allow of online, success and paper]
    #[arg(long, value_parser = agent())]
    agent: Option<AgentName>,

    /// Seed of all random draws
    #[arg(long, default_value_t = 0)]
    seed: u64,

    #[command(flatten)]
    model: ModelArgs,

    #[command(flatten)]
    dqn: DqnArgs,

    /// Keep what puzzles with "remember" teach in this file, and begin with what it holds
    #[arg(long, value_name = "FILE")]
    memory: Option<PathBuf>,
}

impl Args {
    pub fn run(self) -> anyhow::Result<()> {
        let fold = self.fold.into();
        let mut weights = None;
        let (agent, nets, dqn) = if self.agent == Some(AgentName::Random) {
            (AgentName::Random, None, None)
        } else if self.agent == Some(AgentName::Dqn) {
            (AgentName::Dqn, None, Some(self.dqn.load(fold)?))
        } else {
            let (nets, digest) = self.model.load_with_digest(fold)?;
            weights = Some(digest);
            let default = match (&nets.dynamics, &nets.success) {
                (Some(_), _) => AgentName::Online,
                (None, Some(_)) => AgentName::Success,
                (None, None) => AgentName::Paper,
            };
            let agent = self.agent.unwrap_or(default);
            agent.check(&nets)?;
            (agent, Some(nets), None)
        };
        let mut player = Player { agent, nets, dqn, seed: self.seed, memory: Memory::default(), puzzle: None };
        if let Some(path) = self.memory.as_deref().filter(|path| path.exists()) {
            let name = path.display();
            let json = fs::read(path).with_context(|| format!("cannot read the memory in {name}"))?;
            let read = player.memory.read_json(&json, weights.as_deref());
            read.with_context(|| format!("cannot use the memory in {name}"))?;
        }
        // A file that cannot be written is found before anything is learned.
        self.save(&player.memory, weights.as_deref())?;
        let played = self.play(&mut player, weights.as_deref());
        self.save(&player.memory, weights.as_deref())?;
        let refused = played?;
        ensure!(
            refused == 0,
            "{refused} line{} could not be used; the answers say why",
            if refused == 1 { "" } else { "s" }
        );
        Ok(())
    }

    /// Answers the lines of standard input, and returns how many could not be used.
    fn play(&self, player: &mut Player, weights: Option<&str>) -> anyhow::Result<usize> {
        let mut out = io::stdout().lock();
        let mut refused = 0;
        let mut saved = player.memory.attempts();
        for read in Lines::new(io::stdin().lock(), MAX_LINE) {
            let read = read?;
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
                    // A puzzle may also be left for the next one.
                    let attempts = player.memory.attempts();
                    if answer.ends_puzzle() || (begins && attempts != saved) {
                        self.save(&player.memory, weights)?;
                        saved = attempts;
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

    /// Writes the memory, if it is kept in a file. The file that was there stays until the new one is complete, so
    /// that a program that is ended meanwhile loses one puzzle at most.
    fn save(&self, memory: &Memory, weights: Option<&str>) -> anyhow::Result<()> {
        let Some(path) = &self.memory else { return Ok(()) };
        // A link goes on leading to the file.
        let file = path.canonicalize().unwrap_or_else(|_| path.clone());
        let mut part = file.clone().into_os_string();
        part.push(".part");
        fs::write(&part, memory.to_json(weights))
            .and_then(|()| fs::rename(&part, &file))
            .with_context(|| format!("cannot write the memory to {}", path.display()))
    }
}

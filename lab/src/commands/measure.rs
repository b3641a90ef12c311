//! `pathlight-lab measure …`

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use pathlight::agents::agent_name::AgentName;
use pathlight::command_line::agent_arg::agent;
use pathlight::command_line::engine_arg::EngineArg;
use pathlight::command_line::fold_args::FoldArgs;
use pathlight_lab::data::collect::SOLUTIONS;
use pathlight_lab::files::json_file;
use pathlight_lab::measure::measured_scenes::MeasuredScenes;
use pathlight_lab::measure::report::Order;
use pathlight_lab::measure::task_set::TaskSet;
use pathlight_lab::measure::{calibration, evaluate, fidelity, forecasts};
use pathlight_lab::progress::Progress;
use serde::Serialize;

use super::shared_args::{count, random_scenes};

#[derive(clap::Subcommand)]
pub enum Command {
    Evaluate(Evaluate),
    Forecasts(Forecasts),
    Calibration(Calibration),
    Fidelity(Fidelity),
}

impl Command {
    pub fn run(self, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let text = match self {
            Command::Evaluate(args) => args.run(progress)?,
            Command::Forecasts(args) => args.run()?,
            Command::Calibration(args) => args.run()?,
            Command::Fidelity(Fidelity { reference, limit, engine: EngineArg { engine } }) => {
                let settings = fidelity::Settings { reference, limit, engine };
                return settings.compare(&mut io::stdout().lock(), progress);
            }
        };
        Ok(io::stdout().write_all(text.as_bytes())?)
    }
}

/// Measure agents on the test tasks of a fold
#[derive(clap::Args)]
pub struct Evaluate {
    /// Agent to measure; can be repeated. The random agent is always measured too [default: every agent that the
    /// weights support, except online-by-balls and listed; dqn only with --dqn]
    #[arg(long = "agent", value_parser = agent())]
    agents: Vec<AgentName>,

    #[command(flatten)]
    fold: FoldArgs,

    /// Measure on the dev tasks instead of the test tasks, to choose settings
    #[arg(long)]
    dev: bool,

    /// Use at most the first N of these tasks per template
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    limit: Option<u16>,

    /// Seed of all random draws
    #[arg(long, default_value_t = 0)]
    seed: u64,

    /// Write the settings and the first solving attempt at every task to this file, as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,

    #[command(flatten)]
    engine: EngineArg,

    /// Weights of the model [default: assets/SETUP-FOLD.safetensors]
    #[arg(long)]
    weights: Option<PathBuf>,

    /// Weights of DQN, the benchmark's baseline [default for --agent dqn:
    /// target/train/SETUP-FOLD/dqn/weights.safetensors]
    #[arg(long, value_name = "FILE")]
    dqn: Option<PathBuf>,

    /// Measure the agents that support a memory with one too: they play the tasks in order of ids and use at each task
    /// what they learned from the attempts at earlier ones
    #[arg(long, conflicts_with = "engine")]
    memory: bool,

    /// With a memory, also play the tasks in an order shuffled with this seed; can be repeated
    #[arg(long = "shuffle", value_name = "SEED", requires = "memory")]
    shuffles: Vec<u64>,
}

impl Evaluate {
    fn run(self, progress: &mut dyn Progress) -> anyhow::Result<String> {
        let Evaluate {
            agents,
            fold,
            dev,
            limit,
            seed,
            json,
            engine: EngineArg { engine },
            weights,
            dqn,
            memory,
            shuffles,
        } = self;
        let tasks = if dev { TaskSet::Dev } else { TaskSet::Test };
        let orders = memory.then_some(Order::Ids).into_iter().chain(shuffles.into_iter().map(Order::Shuffled));
        json_file::check(json.as_deref())?;
        let (fold, memory) = (fold.into(), orders.collect());
        let settings = evaluate::Settings { agents, fold, tasks, limit, seed, memory, engine, weights, dqn };
        let report = settings.measure(progress)?;
        write_json(json.as_deref(), &report, report.table()?)
    }
}

/// Measure how well the dynamics net imagines paths and outcomes, on the test tasks of a fold or in random scenes
#[derive(clap::Args)]
pub struct Forecasts {
    #[command(flatten)]
    fold: FoldArgs,

    /// Measure on the dev tasks instead of the test tasks, to choose settings
    #[arg(long, conflicts_with = "random_scenes")]
    dev: bool,

    /// Measure in N random scenes, which no net has seen, instead of on tasks
    #[arg(long, value_name = "N", value_parser = random_scenes(), conflicts_with = "limit")]
    random_scenes: Option<u32>,

    /// Random balls per scene, in addition to solutions
    #[arg(long, value_name = "N", default_value_t = forecasts::Settings::default().balls)]
    balls: u16,

    /// Solutions from `data collect`
    #[arg(long, default_value = SOLUTIONS)]
    solutions: PathBuf,

    /// Use at most the first N test tasks of each template
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    limit: Option<u16>,

    /// Seed of the random balls
    #[arg(long, default_value_t = 0)]
    seed: u64,

    /// Weights of the model [default: assets/SETUP-FOLD.safetensors]
    #[arg(long)]
    weights: Option<PathBuf>,
}

impl Forecasts {
    fn run(self) -> anyhow::Result<String> {
        let Forecasts { fold, dev, random_scenes, balls, solutions, limit, seed, weights } = self;
        let tasks = MeasuredScenes::Tasks(if dev { TaskSet::Dev } else { TaskSet::Test });
        let (fold, scenes) = (fold.into(), random_scenes.map_or(tasks, MeasuredScenes::Random));
        forecasts::Settings { fold, scenes, balls, solutions, limit, seed, weights }.measure()
    }
}

/// Measure how often balls with a given predicted chance solve, on the test tasks of a fold
#[derive(clap::Args)]
pub struct Calibration {
    #[command(flatten)]
    fold: FoldArgs,

    /// Random balls per task, and the same number of the model's candidates
    #[arg(
        long,
        value_name = "N",
        default_value_t = calibration::Settings::default().balls,
        value_parser = clap::value_parser!(u16).range(1..)
    )]
    balls: u16,

    /// Use at most the first N test tasks of each template
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    limit: Option<u16>,

    /// Seed of the random balls
    #[arg(long, default_value_t = 0)]
    seed: u64,

    /// Write the bins to this file, as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,

    /// Weights of the model [default: assets/SETUP-FOLD.safetensors]
    #[arg(long)]
    weights: Option<PathBuf>,
}

impl Calibration {
    fn run(self) -> anyhow::Result<String> {
        let Calibration { fold, balls, limit, seed, json, weights } = self;
        json_file::check(json.as_deref())?;
        let calibration = calibration::Settings { fold: fold.into(), balls, limit, seed, weights }.measure()?;
        write_json(json.as_deref(), &calibration, calibration.table()?)
    }
}

/// Compare the simulator with PHYRE's rollouts and outcomes
#[derive(clap::Args)]
pub struct Fidelity {
    /// Folder with outcomes.jsonl
    #[arg(long, value_name = "DIR")]
    reference: PathBuf,

    /// Use only the first N tasks of each template, for a quick look
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = count())]
    limit: usize,

    #[command(flatten)]
    engine: EngineArg,
}

/// Writes the file, if one is named, and returns the table to print. The file is written first, so that a closed pipe
/// does not lose it.
///
/// # Errors
/// If the file cannot be written. The table has then been printed, so that the measurement is not lost.
fn write_json(path: Option<&Path>, value: &impl Serialize, table: String) -> anyhow::Result<String> {
    let written = json_file::write(path, value);
    if written.is_err() {
        // Return the error of the file, not that of standard output.
        let _ = writeln!(io::stdout(), "{table}");
    }
    written.map(|()| table)
}

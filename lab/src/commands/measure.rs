//! `pathlight-lab measure …`

use std::io::{self, Write};
use std::path::PathBuf;

use pathlight::agents::agent_name::AgentName;
use pathlight_lab::data::collect::SOLUTIONS;
use pathlight_lab::files::json_file;
use pathlight_lab::measure::task_set::TaskSet;
use pathlight_lab::measure::{calibration, carried, evaluate, fidelity, forecasts, paper_table};
use pathlight_lab::progress::Progress;
use pathlight_lab::reproduce::RESULTS;
use pathlight_lab::reproduce::other_data::{self, Table};

use super::agent_arg::agent;
use super::at_least_one::count;
use super::engine_arg::EngineArg;
use super::fold_args::FoldArgs;
use super::json_output;
use super::scenes_args::ScenesArgs;

#[derive(clap::Subcommand)]
pub enum Command {
    Evaluate(Evaluate),
    Carried(Carried),
    Paper(Paper),
    /// Print the results of a dynamics net that learned from random scenes alone, which `measure evaluate --all-tasks`
    /// wrote, beside the main results, as Markdown
    RandomScenes(OtherData),
    /// Print the results of dynamics nets that learned from balls they had proposed, which `measure evaluate` wrote,
    /// beside the main results, as Markdown
    ProposedBalls(OtherData),
    Forecasts(Forecasts),
    Calibration(Calibration),
    Fidelity(Fidelity),
}

impl Command {
    pub fn run(self, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let text = match self {
            Command::Evaluate(args) => args.run(progress)?,
            Command::Carried(args) => args.run()?,
            Command::Paper(Paper { folder }) => paper_table::page(&folder)?,
            Command::RandomScenes(args) => args.page(Table::RandomScenes)?,
            Command::ProposedBalls(args) => args.page(Table::ProposedBalls)?,
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
    /// Agent to measure; can be repeated. The random agent is always measured too [default: every agent that
    /// the weights allow except online-by-balls and listed; dqn only with --dqn]
    #[arg(long = "agent", value_parser = agent())]
    agents: Vec<AgentName>,

    #[command(flatten)]
    fold: FoldArgs,

    /// Use the dev tasks, to choose settings on, instead of the test tasks
    #[arg(long)]
    dev: bool,

    /// Use all 2,500 tasks; the dynamics net must have been trained on random scenes alone
    #[arg(long, conflicts_with_all = ["dev", "dqn"])]
    all_tasks: bool,

    /// Use at most the first N of these tasks of each template
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    limit: Option<u16>,

    /// Seed of all random draws
    #[arg(long, default_value_t = 0)]
    seed: u64,

    /// Write the settings and the first solving attempt of every task to this file, as JSON
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

    /// Measure agents that remember: what the attempts at one task taught is used for the next, in order of ids. Also
    /// measures them without memory, and with parts of it left out
    #[arg(long, conflicts_with_all = ["agents", "engine", "dqn"])]
    carry: bool,

    /// Also play the tasks in an order shuffled with this seed; can be repeated
    #[arg(long = "shuffle", value_name = "SEED", requires = "carry")]
    shuffles: Vec<u64>,
}

impl Evaluate {
    fn run(self, progress: &mut dyn Progress) -> anyhow::Result<String> {
        let Evaluate {
            agents,
            fold,
            dev,
            all_tasks,
            limit,
            seed,
            json,
            engine: EngineArg { engine },
            weights,
            dqn,
            carry,
            shuffles,
        } = self;
        let (fold, tasks) = (fold.into(), task_set(dev, all_tasks));
        json_file::check(json.as_deref())?;
        if carry {
            let settings = carried::Settings { fold, tasks, limit, seed, shuffles, weights };
            let report = settings.measure(progress)?;
            return json_output::write(json.as_deref(), &report, report.markdown()?);
        }
        let settings = evaluate::Settings { agents, fold, tasks, limit, seed, engine, weights, dqn };
        let report = settings.measure(progress)?;
        json_output::write(json.as_deref(), &report, report.table()?)
    }
}

fn task_set(dev: bool, all: bool) -> TaskSet {
    match (dev, all) {
        (true, _) => TaskSet::Dev,
        (false, true) => TaskSet::All,
        (false, false) => TaskSet::Test,
    }
}

/// Print the results of agents that remember, which `measure evaluate --carry` wrote, as Markdown
#[derive(clap::Args)]
pub struct Carried {
    /// Folder of the results
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

impl Carried {
    fn run(self) -> anyhow::Result<String> {
        Ok(carried::page(&carried::read(&self.folder)?)?)
    }
}

/// Print the results of the paper's four nets, which `measure evaluate --agent paper` wrote, beside the published ones,
/// as Markdown
#[derive(clap::Args)]
pub struct Paper {
    /// Folder of the results
    #[arg(value_name = "DIR")]
    folder: PathBuf,
}

#[derive(clap::Args)]
pub struct OtherData {
    /// Folder of the results
    #[arg(value_name = "DIR")]
    folder: PathBuf,

    /// Folder of the main results, from `reproduce`
    #[arg(long, value_name = "DIR", default_value = RESULTS)]
    main: PathBuf,
}

impl OtherData {
    fn page(self, table: Table) -> anyhow::Result<String> {
        other_data::page(table, &self.folder, &self.main)
    }
}

/// Measure how well the dynamics net imagines what balls lead to, on the test tasks of a fold or in other scenes
#[derive(clap::Args)]
pub struct Forecasts {
    #[command(flatten)]
    fold: FoldArgs,

    #[command(flatten)]
    scenes: ScenesArgs,

    /// Random balls for each scene; solutions come on top
    #[arg(long, value_name = "N", default_value_t = forecasts::Settings::default().balls)]
    balls: usize,

    /// Solutions, from `data collect`
    #[arg(long, default_value = SOLUTIONS)]
    solutions: PathBuf,

    /// Use at most the first N test tasks of each template
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    limit: Option<u16>,

    /// Seed of the random balls
    #[arg(long, default_value_t = 0)]
    seed: u64,

    /// Write the soft IoU of imagined and real paths, by template, to this file, as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,

    /// Weights of the model [default: assets/SETUP-FOLD.safetensors]
    #[arg(long)]
    weights: Option<PathBuf>,
}

impl Forecasts {
    fn run(self) -> anyhow::Result<String> {
        let Forecasts { fold, scenes, balls, solutions, limit, seed, json, weights } = self;
        let (fold, scenes) = (fold.into(), scenes.into());
        json_file::check(json.as_deref())?;
        let settings = forecasts::Settings { fold, scenes, balls, solutions, limit, seed, weights };
        let (forecasts, table) = settings.measure()?;
        json_output::write(json.as_deref(), &forecasts, table)
    }
}

/// Measure how often balls of a given predicted chance solve, on the test tasks of a fold or in other scenes
#[derive(clap::Args)]
pub struct Calibration {
    #[command(flatten)]
    fold: FoldArgs,

    #[command(flatten)]
    scenes: ScenesArgs,

    /// Random balls for each scene, and as many of the model's candidates
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
        let Calibration { fold, scenes, balls, limit, seed, json, weights } = self;
        let (fold, scenes) = (fold.into(), scenes.into());
        json_file::check(json.as_deref())?;
        let calibration = calibration::Settings { fold, scenes, balls, limit, seed, weights }.measure()?;
        json_output::write(json.as_deref(), &calibration, calibration.table()?)
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

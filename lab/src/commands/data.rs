//! `pathlight-lab data …`

use std::io::{self, Write};
use std::path::PathBuf;

use pathlight::benchmark::folds::{FoldId, Setup};
use pathlight::command_line::fold_args::{fold, setup};
use pathlight::command_line::template_arg::template;
use pathlight::puzzle::templates::Template;
use pathlight_lab::data::collect::{self, SOLUTIONS};
use pathlight_lab::data::difficulty;
use pathlight_lab::data::label::{self, LABELS, Scenes};
use pathlight_lab::data::task_selection::TaskSelection;
use pathlight_lab::progress::Progress;

use super::shared_args::{count, random_scenes};

#[derive(clap::Subcommand)]
pub enum Command {
    Collect(Collect),
    Label(Label),
    Difficulty(Difficulty),
}

impl Command {
    pub fn run(self, progress: &mut dyn Progress) -> anyhow::Result<()> {
        match self {
            Command::Collect(args) => args.run(progress),
            Command::Label(args) => args.run(progress),
            Command::Difficulty(args) => args.run(progress),
        }
    }
}

/// Tasks of the benchmark.
#[derive(clap::Args)]
struct SelectionArgs {
    /// Use only the tasks of this template, like 00007
    #[arg(long, value_name = "TEMPLATE", value_parser = template)]
    template: Option<&'static Template>,

    /// Use at most the first N tasks of each template
    #[arg(long, value_name = "N", default_value_t = TaskSelection::default().limit, value_parser = count())]
    limit: usize,
}

impl From<SelectionArgs> for TaskSelection {
    fn from(SelectionArgs { template, limit }: SelectionArgs) -> TaskSelection {
        TaskSelection { template, limit }
    }
}

/// Find solutions of the tasks by drawing balls uniformly, to train on
#[derive(clap::Args)]
pub struct Collect {
    /// File to write or continue
    #[arg(long, default_value = SOLUTIONS)]
    out: PathBuf,

    /// Solutions to find per task
    #[arg(long, value_name = "N", default_value_t = collect::Settings::default().per_task, value_parser = count())]
    per_task: usize,

    /// Maximum number of balls to simulate per task
    #[arg(long, value_name = "N", default_value_t = collect::Settings::default().max_rollouts, value_parser = count())]
    max_rollouts: usize,

    #[command(flatten)]
    selection: SelectionArgs,

    /// Seed of all random draws
    #[arg(long, default_value_t = 0)]
    seed: u64,
}

impl Collect {
    fn run(self, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let Collect { out, per_task, max_rollouts, selection, seed } = self;
        let settings = collect::Settings { out, per_task, max_rollouts, selection: selection.into(), seed };
        Ok(io::stdout().write_all(settings.search(progress)?.as_bytes())?)
    }
}

/// Simulate balls on all tasks and record their outcomes, to train a success net, a dynamics net or DQN
#[derive(clap::Args)]
pub struct Label {
    /// File to write or continue
    #[arg(long, default_value = LABELS)]
    out: PathBuf,

    /// Solutions to sample balls around, from `data collect`
    #[arg(long, default_value = SOLUTIONS)]
    solutions: PathBuf,

    /// Number of rounds; each tries 64 balls per scene
    #[arg(long, default_value_t = label::Settings::default().rounds, value_parser = count())]
    rounds: usize,

    #[command(flatten)]
    selection: SelectionArgs,

    /// Label the balls that the dynamics net in FILE proposes, likeliest first, instead of sampled ones; each round
    /// takes the next 64. The net must belong to the fold of --setup or have been trained on no task; in random scenes,
    /// on random scenes alone
    #[arg(long, value_name = "FILE")]
    weights: Option<PathBuf>,

    /// Label balls in random scenes instead of tasks: of the first N scenes, all that some ball solves and a sixth of
    /// the rest
    #[arg(
        long,
        value_name = "N",
        value_parser = random_scenes(),
        conflicts_with_all = ["unlisted", "setup", "template", "limit"]
    )]
    random_scenes: Option<u32>,

    /// Label balls in unlisted tasks instead, up to N per template: tasks that its script lays out but the benchmark
    /// does not list
    #[arg(long, value_name = "N", value_parser = count(), conflicts_with = "limit")]
    unlisted: Option<usize>,

    /// Label only the training tasks of one fold of this setup, and sample only around their solutions
    #[arg(long, value_parser = setup(), requires = "fold")]
    setup: Option<Setup>,

    /// The fold of --setup
    #[arg(long, requires = "setup", value_parser = fold)]
    fold: Option<u8>,

    /// Seed of all random draws
    #[arg(long, default_value_t = 0)]
    seed: u64,
}

impl Label {
    fn run(self, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let scenes = self.scenes();
        let settings = label::Settings {
            out: self.out,
            solutions: self.solutions,
            rounds: self.rounds,
            selection: self.selection.into(),
            scenes,
            weights: self.weights,
            training_tasks_of: self.setup.zip(self.fold).map(|(setup, fold)| FoldId { setup, fold }),
            seed: self.seed,
        };
        settings.label(progress)
    }

    fn scenes(&self) -> Scenes {
        match *self {
            Label { unlisted: Some(count), .. } => Scenes::Unlisted(count),
            Label { random_scenes: Some(count), .. } => Scenes::Random(count),
            _ => Scenes::Tasks,
        }
    }
}

/// Measure how hard each task is: how many of N uniformly drawn valid balls solve it, as JSON
#[derive(clap::Args)]
pub struct Difficulty {
    /// Valid balls per task
    #[arg(
        long,
        value_name = "N",
        default_value_t = difficulty::Settings::default().balls,
        value_parser = clap::value_parser!(u32).range(1..)
    )]
    balls: u32,

    /// Use only the first N tasks of each template, for a quick look
    #[arg(long, value_name = "N", default_value_t = difficulty::Settings::default().limit, value_parser = count())]
    limit: usize,

    /// Seed of the balls
    #[arg(long, default_value_t = 0)]
    seed: u64,
}

impl Difficulty {
    fn run(self, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let Difficulty { balls, limit, seed } = self;
        let counts = difficulty::Settings { balls, limit, seed }.measure(progress);
        Ok(writeln!(io::stdout(), "{}", serde_json::to_string(&counts)?)?)
    }
}

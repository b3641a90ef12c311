//! `pathlight-lab train …`

use std::path::PathBuf;

use pathlight::command_line::fold_args::FoldArgs;
use pathlight_lab::data::collect::SOLUTIONS;
use pathlight_lab::data::label::LABELS;
use pathlight_lab::progress::Progress;
use pathlight_lab::training::dynamics::DynamicsRecipe;
use pathlight_lab::training::settings::PathsRecipe;
use pathlight_lab::training::{dqn, dynamics, paths, success};

use super::shared_args::{OptimiserName, PathWeightsArgs, RunArgs, at_least_one, count};

#[derive(clap::Subcommand)]
pub enum Command {
    Paths(Paths),
    Success(Success),
    Dynamics(Dynamics),
    Dqn(Dqn),
}

impl Command {
    pub fn run(self, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let (weights, of) = match self {
            Command::Paths(args) => (paths::Settings::from(args).train(progress)?, "of the four nets "),
            Command::Success(args) => (success::Settings::from(args).train(progress)?, "of all five nets "),
            Command::Dynamics(args) => (dynamics::Settings::from(args).train(progress)?, "of all nets "),
            Command::Dqn(args) => (dqn::Settings::from(args).train(progress)?, ""),
        };
        if let Some(weights) = weights {
            progress.say(&format!("the weights {of}are in {}", weights.display()));
        }
        Ok(())
    }
}

/// Train the four nets on the training tasks of a fold
#[derive(clap::Args)]
pub struct Paths {
    #[command(flatten)]
    fold: FoldArgs,

    /// Solutions to train on, from `data collect`
    #[arg(long, default_value = SOLUTIONS)]
    solutions: PathBuf,

    /// Passes over the samples
    #[arg(long, default_value_t = paths::Settings::default().epochs, value_parser = count())]
    epochs: usize,

    /// Number of final epochs over which the learning rate decays linearly to zero
    #[arg(long, value_name = "EPOCHS", default_value_t = PathsRecipe::default().decay_epochs)]
    decay_epochs: usize,

    /// Mirror half of the samples left to right; PHYRE's world is symmetric
    #[arg(long)]
    mirror: bool,

    /// Train without the dev tasks, so that settings can be chosen on them with `measure evaluate --dev`
    #[arg(long)]
    without_dev: bool,

    #[command(flatten)]
    run: RunArgs,
}

impl From<Paths> for paths::Settings {
    fn from(args: Paths) -> paths::Settings {
        let recipe = PathsRecipe {
            batch: args.run.batch,
            learning_rate: args.run.learning_rate,
            decay_epochs: args.decay_epochs,
            mirror: args.mirror,
            without_dev: args.without_dev,
        };
        let Paths { fold, solutions, epochs, run, .. } = args;
        paths::Settings { fold: fold.into(), solutions, epochs, recipe, run: run.into() }
    }
}

/// Train the success net, which predicts which balls solve, and add it to the weights of the four nets; it replaces a
/// dynamics net in them
#[derive(clap::Args)]
pub struct Success {
    #[command(flatten)]
    fold: FoldArgs,

    /// Weights of the model [default: assets/SETUP-FOLD.safetensors]
    #[arg(long)]
    weights: Option<PathBuf>,

    /// Labelled balls from `data label`
    #[arg(long, default_value = LABELS)]
    labels: PathBuf,

    /// Passes over the scenes
    #[arg(long, default_value_t = success::Settings::default().epochs, value_parser = count())]
    epochs: usize,

    /// Balls per scene in a batch, resampled for each batch
    #[arg(
        long,
        value_name = "N",
        default_value_t = success::Settings::default().recipe.balls_per_scene,
        value_parser = at_least_one()
    )]
    balls_per_scene: u16,

    /// Optimiser
    #[arg(long, value_enum, default_value_t)]
    optimiser: OptimiserName,

    #[command(flatten)]
    run: RunArgs,
}

impl From<Success> for success::Settings {
    fn from(Success { fold, weights, labels, epochs, balls_per_scene, optimiser, run }: Success) -> success::Settings {
        let recipe = run.labels_recipe(optimiser, balls_per_scene);
        success::Settings { fold: fold.into(), weights, labels, epochs, recipe, run: run.into() }
    }
}

/// Train the dynamics net, which imagines the paths and outcomes of balls, and add it to the weights of the four nets
#[derive(clap::Args)]
pub struct Dynamics {
    #[command(flatten)]
    fold: FoldArgs,

    /// Weights of the model [default: assets/SETUP-FOLD.safetensors]
    #[arg(long)]
    weights: Option<PathBuf>,

    /// Labelled balls from `data label`; can be repeated
    #[arg(long, default_value = LABELS)]
    labels: Vec<PathBuf>,

    /// Passes over the scenes
    #[arg(long, default_value_t = dynamics::Settings::default().epochs, value_parser = count())]
    epochs: usize,

    /// Balls per scene in a batch, resampled for each batch
    #[arg(
        long,
        value_name = "N",
        default_value_t = DynamicsRecipe::default().balls_per_scene,
        value_parser = at_least_one()
    )]
    balls_per_scene: u16,

    /// Balls per scene in a batch whose paths are learned too; at most --balls-per-scene
    #[arg(
        long,
        value_name = "N",
        default_value_t = DynamicsRecipe::default().imagined_per_scene,
        value_parser = at_least_one()
    )]
    imagined_per_scene: u16,

    #[command(flatten)]
    path_weights: PathWeightsArgs,

    /// Optimiser
    #[arg(long, value_enum, default_value_t)]
    optimiser: OptimiserName,

    /// Train without the fold's dev tasks, so that settings can be chosen on them
    #[arg(long)]
    without_dev: bool,

    /// Start from the dynamics net in this file instead of random weights
    #[arg(long, value_name = "FILE")]
    from: Option<PathBuf>,

    #[command(flatten)]
    run: RunArgs,
}

impl From<Dynamics> for dynamics::Settings {
    fn from(args: Dynamics) -> dynamics::Settings {
        dynamics::Settings {
            fold: args.fold.into(),
            weights: args.weights,
            labels: args.labels,
            epochs: args.epochs,
            recipe: DynamicsRecipe {
                batch: args.run.batch,
                optimiser: args.optimiser.into(),
                learning_rate: args.run.learning_rate,
                balls_per_scene: args.balls_per_scene,
                imagined_per_scene: args.imagined_per_scene,
                path_weights: args.path_weights.into(),
            },
            without_dev: args.without_dev,
            from: args.from,
            run: args.run.into(),
        }
    }
}

/// Train DQN, the benchmark's baseline: a net that predicts how likely an action is to solve a scene
#[derive(clap::Args)]
pub struct Dqn {
    #[command(flatten)]
    fold: FoldArgs,

    /// Labelled balls from `data label`; can be repeated
    #[arg(long, default_value = LABELS)]
    labels: Vec<PathBuf>,

    /// Passes over the scenes
    #[arg(long, default_value_t = dqn::Settings::default().epochs, value_parser = count())]
    epochs: usize,

    /// Balls per scene in a batch, half of them solutions, resampled for each batch
    #[arg(
        long,
        value_name = "N",
        default_value_t = dqn::Settings::default().recipe.balls_per_scene,
        value_parser = at_least_one()
    )]
    balls_per_scene: u16,

    /// Optimiser
    #[arg(long, value_enum, default_value_t)]
    optimiser: OptimiserName,

    /// Train without the fold's dev tasks, so that settings can be chosen on them
    #[arg(long)]
    without_dev: bool,

    #[command(flatten)]
    run: RunArgs,
}

impl From<Dqn> for dqn::Settings {
    fn from(Dqn { fold, labels, epochs, balls_per_scene, optimiser, without_dev, run }: Dqn) -> dqn::Settings {
        let recipe = run.labels_recipe(optimiser, balls_per_scene);
        dqn::Settings { fold: fold.into(), labels, epochs, recipe, without_dev, run: run.into() }
    }
}

//! `pathlight-lab reproduce`

use std::io::{self, Write};
use std::path::PathBuf;

use clap::ValueEnum;
use pathlight::benchmark::folds::{FOLDS, FoldId, Setup};
use pathlight_lab::data::collect::SOLUTIONS;
use pathlight_lab::data::label::LABELS;
use pathlight_lab::progress::Progress;
use pathlight_lab::reproduce::fold_result::{DataFiles, Hyperparameters};
use pathlight_lab::reproduce::{RESULTS, Settings};

use super::at_least_one::at_least_one;
use super::fold_args::{fold, setup};

/// Train and measure every fold of both setups, continuing where an earlier run stopped: data, folds, report
#[derive(clap::Args)]
pub struct Args {
    /// Do only this part
    #[arg(long, value_enum)]
    only: Option<Part>,

    /// Only folds of this setup
    #[arg(long, value_parser = setup())]
    setup: Option<Setup>,

    /// Only this fold; can be repeated [default: all ten]
    #[arg(long = "fold", value_name = "FOLD", value_parser = fold)]
    folds: Vec<u8>,

    /// Folder of the results and of the report
    #[arg(long, value_name = "DIR", default_value = RESULTS)]
    results: PathBuf,

    /// Solutions of all tasks: collected until complete, and trained on
    #[arg(long, default_value = SOLUTIONS)]
    solutions: PathBuf,

    /// Balls with their outcome: labelled until complete, and trained on by the success net, the dynamics net and DQN
    #[arg(long, default_value = LABELS)]
    labels: PathBuf,

    /// Folder of the training runs, each in its own subfolder SETUP-FOLD
    #[arg(long, value_name = "DIR", default_value_os_t = Settings::default().train_dir)]
    train_dir: PathBuf,

    #[command(flatten)]
    hyperparameters: HyperparameterArgs,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Part {
    /// Solutions and labelled balls, which all folds share
    Data,
    /// Training and evaluation: a JSON file per setup and fold
    Folds,
    /// README.md and costs.md of the existing results
    Report,
}

/// `Hyperparameters`.
#[derive(clap::Args)]
struct HyperparameterArgs {
    /// Seed of training and evaluation
    #[arg(long, default_value_t = Hyperparameters::default().seed)]
    seed: u64,

    /// Rounds of labelling; every task tries 64 balls per round
    #[arg(long, value_name = "ROUNDS", default_value_t = Hyperparameters::default().label_rounds)]
    label_rounds: u16,

    /// Epochs of the success net and of the dynamics net
    #[arg(long, default_value_t = Hyperparameters::default().epochs, value_parser = at_least_one())]
    epochs: u16,

    /// Epochs of DQN
    #[arg(
        long,
        value_name = "EPOCHS",
        default_value_t = Hyperparameters::default().dqn_epochs,
        value_parser = at_least_one()
    )]
    dqn_epochs: u16,

    /// Use at most the first N test tasks of each template
    #[arg(long, value_name = "N", default_value_t = Hyperparameters::default().limit, value_parser = at_least_one())]
    limit: u16,
}

impl From<HyperparameterArgs> for Hyperparameters {
    fn from(args: HyperparameterArgs) -> Hyperparameters {
        Hyperparameters {
            seed: args.seed,
            label_rounds: args.label_rounds,
            epochs: args.epochs,
            dqn_epochs: args.dqn_epochs,
            limit: args.limit,
        }
    }
}

impl Args {
    pub fn run(self, progress: &mut dyn Progress) -> anyhow::Result<()> {
        let Args { only, setup, folds, results, solutions, labels, train_dir, hyperparameters } = self;
        let data = DataFiles { solutions, labels };
        let settings = Settings { results, data, train_dir, hyperparameters: hyperparameters.into() };
        let asked = |part| only.is_none_or(|only| only == part);
        if asked(Part::Data) {
            settings.make_data(progress)?;
        }
        if asked(Part::Folds) {
            for fold in chosen_folds(setup, folds) {
                settings.make_result(fold, progress)?;
            }
        }
        if asked(Part::Report) {
            // All is written before anything is printed, so that a closed pipe does not stop halfway.
            io::stdout().write_all(settings.report()?.as_bytes())?;
        }
        Ok(())
    }
}

/// The folds to make results of, both setups of a fold one after the other.
fn chosen_folds(setup: Option<Setup>, folds: Vec<u8>) -> Vec<FoldId> {
    let folds = if folds.is_empty() { (0..FOLDS).collect() } else { folds };
    let setups: Vec<Setup> = setup.map_or(vec![Setup::Within, Setup::Cross], |setup| vec![setup]);
    folds.into_iter().flat_map(|fold| setups.iter().map(move |&setup| FoldId { setup, fold })).collect()
}

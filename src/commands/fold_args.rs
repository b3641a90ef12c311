//! The arguments that name a fold of a setup.

use std::fmt;
use std::path::PathBuf;

use clap::ValueEnum;
use clap::builder::{EnumValueParser, TypedValueParser};
use pathlight::benchmark::folds::{FOLDS, Fold, Setup};
use pathlight::puzzle::task::TaskId;

/// A fold of the benchmark; part of the arguments of other commands.
#[derive(Clone, Copy, clap::Args)]
pub struct FoldArgs {
    /// What the model has to generalise to
    #[arg(long, value_parser = setup(), default_value = "within")]
    pub setup: Setup,

    /// Fold of the benchmark, 0 to 9
    #[arg(long, default_value_t = 0, value_parser = fold)]
    pub fold: u8,
}

impl FoldArgs {
    /// The tasks of the fold.
    pub fn tasks(&self) -> Fold {
        Fold::new(self.setup, self.fold)
    }

    /// The tasks to train on, ascending: PHYRE's training tasks, with or without its dev tasks.
    pub fn training_tasks(&self, without_dev: bool) -> Vec<TaskId> {
        let fold = self.tasks();
        if without_dev { fold.train } else { fold.all_train() }
    }

    /// The test tasks, at most the first `limit` of each template.
    pub fn test_tasks(&self, limit: Option<u16>) -> Vec<TaskId> {
        first_of_each_template(&self.tasks().test, limit)
    }

    /// Default folder of its training runs.
    pub fn folder(&self) -> PathBuf {
        format!("target/train/{self}").into()
    }
}

impl fmt::Display for FoldArgs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}-{}", self.setup, self.fold)
    }
}

/// Parses the number of a fold.
pub fn fold(text: &str) -> Result<u8, String> {
    let number = text.parse().ok().filter(|number| *number < FOLDS);
    number.ok_or_else(|| format!("the folds are 0 to {}", FOLDS - 1))
}

/// Returns at most the first `limit` tasks of each template, of tasks in ascending order.
pub fn first_of_each_template(tasks: &[TaskId], limit: Option<u16>) -> Vec<TaskId> {
    let limit = limit.map_or(usize::MAX, usize::from);
    let templates = tasks.chunk_by(|a, b| a.template == b.template);
    templates.flat_map(|tasks| tasks.iter().copied().take(limit)).collect()
}

/// The names of the setups on the command line; the library does not know clap.
#[derive(Clone, Copy, ValueEnum)]
enum SetupName {
    /// New tasks of known templates
    Within,
    /// New templates
    Cross,
}

/// Parses the name of a setup.
pub fn setup() -> impl TypedValueParser<Value = Setup> {
    EnumValueParser::<SetupName>::new().map(|name| match name {
        SetupName::Within => Setup::Within,
        SetupName::Cross => Setup::Cross,
    })
}

//! The arguments that select a fold of a setup; used by the lab's binary too.

use crate::benchmark::folds::{FOLDS, FoldId, Setup};
use clap::ValueEnum;
use clap::builder::{EnumValueParser, TypedValueParser};

/// A fold of the benchmark, to include in a command's arguments.
#[derive(Clone, Copy, clap::Args)]
pub struct FoldArgs {
    /// What the model must generalise to
    #[arg(long, value_parser = setup(), default_value = "within")]
    setup: Setup,

    /// Fold of the benchmark, 0 to 9
    #[arg(long, default_value_t = 0, value_parser = fold)]
    fold: u8,
}

impl From<FoldArgs> for FoldId {
    fn from(FoldArgs { setup, fold }: FoldArgs) -> FoldId {
        FoldId { setup, fold }
    }
}

/// The names of the setups on the command line. The library does not depend on clap.
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

/// Parses the number of a fold.
pub fn fold(text: &str) -> Result<u8, String> {
    let number = text.parse().ok().filter(|number| *number < FOLDS);
    number.ok_or_else(|| format!("the folds are 0 to {}", FOLDS - 1))
}

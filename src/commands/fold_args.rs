//! Which fold of which setup a command is about; part of the arguments of others.

use std::fmt;
use std::path::PathBuf;

use pathlight::benchmark::folds::{Fold, Setup};

#[derive(clap::Args)]
pub struct Which {
    /// within: new tasks of known templates; cross: new templates
    #[arg(long, value_parser = setup, default_value = "within")]
    pub setup: Setup,

    /// Fold of the benchmark
    #[arg(long, default_value_t = 0, value_parser = clap::value_parser!(u8).range(0..10))]
    pub fold: u8,
}

impl Which {
    /// The tasks of the fold.
    pub fn tasks(&self) -> Fold {
        Fold::new(self.setup, self.fold)
    }

    /// Where its training runs live, if nothing else is said.
    pub fn folder(&self) -> PathBuf {
        format!("target/train/{self}").into()
    }
}

impl fmt::Display for Which {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}-{}", self.setup, self.fold)
    }
}

/// `within` or `cross`.
pub fn setup(text: &str) -> Result<Setup, String> {
    match text {
        "within" => Ok(Setup::Within),
        "cross" => Ok(Setup::Cross),
        _ => Err("the setups are within and cross".to_string()),
    }
}

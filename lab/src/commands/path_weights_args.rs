//! How much the paths count in the loss of a dynamics net, as arguments.

use pathlight::nets::PathWeights;

/// The weights of the paths in the loss.
#[derive(clap::Args)]
pub struct PathWeightsArgs {
    /// Weight of the paths in the loss
    #[arg(long, value_name = "W", default_value_t = PathWeights::default().all, value_parser = weight)]
    path_weight: f64,

    /// Weight of the paths of balls that solve, relative to those of other balls
    #[arg(long, value_name = "W", default_value_t = PathWeights::default().solving, value_parser = weight)]
    solving_path_weight: f64,
}

impl From<PathWeightsArgs> for PathWeights {
    fn from(args: PathWeightsArgs) -> PathWeights {
        PathWeights { all: args.path_weight, solving: args.solving_path_weight }
    }
}

fn weight(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(weight) if weight > 0.0 && weight < f64::INFINITY => Ok(weight),
        _ => Err("it has to be a number above 0".into()),
    }
}

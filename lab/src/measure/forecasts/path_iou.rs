//! The `--json` file of `measure forecasts`: by template, the soft IoU of imagined paths and those that happen.

use pathlight::benchmark::folds::Setup;
use pathlight::nets::Card;
use serde::{Deserialize, Serialize};

use super::Forecast;

/// The `--json` file.
#[derive(Serialize, Deserialize)]
pub struct Forecasts {
    pub setup: Setup,
    pub fold: u8,
    pub seed: u64,
    /// `simulator::VERSION`
    pub simulator: u32,
    /// How the model was trained.
    pub card: Card,
    /// Test tasks.
    pub tasks: usize,
    /// Random balls for each task; its known solutions come on top.
    pub balls: usize,
    pub all: PathIous,
    /// The templates that have test tasks, ascending.
    pub templates: Vec<TemplateIous>,
}

#[derive(Serialize, Deserialize)]
pub struct TemplateIous {
    pub template: usize,
    pub overlap: PathIous,
}

/// Means of soft IoU, 0..=1; null where there is nothing to measure.
#[derive(Serialize, Deserialize)]
pub struct PathIous {
    /// Of the map of the base path, beside the path of the green object without a ball.
    pub base: Option<f64>,
    /// Of the map of the target path, beside that of the green object in known solutions.
    pub target: Option<f64>,
    /// Of the map of the action path, beside that of the ball in known solutions.
    pub action: Option<f64>,
    /// Of what the dynamics net imagines for balls that solve.
    pub solved: BallIous,
    pub not_solved: BallIous,
}

/// Means over balls of the soft IoU of the paths that the dynamics net imagines.
#[derive(Serialize, Deserialize)]
pub struct BallIous {
    pub balls: usize,
    pub object: Option<f64>,
    /// Of an object that stays where it starts.
    pub resting: Option<f64>,
    /// Of the ball.
    pub ball: Option<f64>,
}

/// The soft IoU of the maps of one task; of target and action path the mean over its known solutions.
pub struct MapIous {
    pub base: f64,
    pub target: Option<f64>,
    pub action: Option<f64>,
}

impl PathIous {
    /// Returns the means over tasks and balls.
    pub fn mean<'a>(of: impl Iterator<Item = &'a (MapIous, Vec<Forecast>)> + Clone) -> PathIous {
        let maps = || of.clone().map(|(maps, _)| maps);
        let paths = |solved: bool| {
            let balls = || of.clone().flat_map(|(_, balls)| balls).filter(move |ball| ball.solved == solved);
            BallIous {
                balls: balls().count(),
                object: mean(balls().map(|ball| ball.object_iou)),
                resting: mean(balls().map(|ball| ball.resting_iou)),
                ball: mean(balls().map(|ball| ball.ball_iou)),
            }
        };
        PathIous {
            base: mean(maps().map(|maps| maps.base)),
            target: mean(maps().filter_map(|maps| maps.target)),
            action: mean(maps().filter_map(|maps| maps.action)),
            solved: paths(true),
            not_solved: paths(false),
        }
    }
}

/// The mean to four decimals; `None` of nothing.
pub fn mean(values: impl Iterator<Item = f64>) -> Option<f64> {
    let (count, sum) = values.fold((0u32, 0.0), |(count, sum), value| (count + 1, sum + value));
    (count > 0).then(|| (1e4 * sum / f64::from(count)).round() / 1e4)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mean_of_nothing_is_none() {
        assert_eq!(mean([].into_iter()), None);
        assert_eq!(mean([0.25, 0.75, 0.00004].into_iter()), Some(0.3333));
    }
}

//! Which scenes a command measures on.

use pathlight_lab::measure::measured_scenes::MeasuredScenes;
use pathlight_lab::measure::task_set::TaskSet;

/// The most random scenes: their ids are listed in memory.
pub const MOST_RANDOM_SCENES: i64 = 10_000_000;

/// Scenes to measure on instead of test tasks.
#[derive(clap::Args)]
pub struct ScenesArgs {
    /// Measure on the dev tasks, to choose settings on
    #[arg(long, conflicts_with_all = ["variants", "random_scenes", "json"])]
    dev: bool,

    /// Measure in a variant of each test task, with its bodies moved, turned and resized at random
    #[arg(long, conflicts_with_all = ["random_scenes", "json"])]
    variants: bool,

    /// Measure in this many random scenes, which no net has seen
    #[arg(
        long,
        value_name = "N",
        value_parser = clap::value_parser!(u32).range(1..=MOST_RANDOM_SCENES),
        conflicts_with_all = ["json", "limit"]
    )]
    random_scenes: Option<u32>,
}

impl From<ScenesArgs> for MeasuredScenes {
    fn from(ScenesArgs { dev, variants, random_scenes }: ScenesArgs) -> MeasuredScenes {
        match random_scenes {
            Some(count) => MeasuredScenes::Random(count),
            None if variants => MeasuredScenes::Variants,
            None if dev => MeasuredScenes::Tasks(TaskSet::Dev),
            None => MeasuredScenes::default(),
        }
    }
}

//! The lines of a file of `data label`, and reading them.

use std::num::{NonZeroU32, NonZeroUsize};
use std::path::Path;

use anyhow::ensure;
use pathlight::benchmark::folds::Setup;
use pathlight::simulator;
use serde::{Deserialize, Serialize};

use crate::data::label_use::Proposer;
use crate::data::labels::{LabelledBalls, PATHS_LEN};
use crate::data::scene_id::SceneId;
use crate::files::journal::{self, check_ball, check_task};

/// What determines the content of a file. Absent fields take their defaults.
#[derive(Serialize, Deserialize)]
pub struct LabelSettings {
    pub seed: u64,
    pub tasks: NonZeroUsize,
    #[serde(default)]
    pub template: Option<usize>,
    #[serde(default = "default_limit")]
    pub limit: usize,
    /// `simulator::VERSION`
    pub simulator: u32,
    /// SHA-256 of the file of solutions.
    pub solutions: String,
    /// SHA-256 of the weights whose most probable balls are labelled; absent if balls were sampled.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weights: Option<String>,
    /// Whether the net of these weights has not learned from the fold's dev tasks.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub net_without_dev: bool,
    /// Whether it has learned from random scenes alone.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub net_of_random_scenes: bool,
    /// Whether balls were tried in variants of the scenes.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub variants: bool,
    /// The number of blends of each task; absent if balls were not tried in blends.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub blends: Option<NonZeroU32>,
    /// Whether balls were tried in random scenes; `tasks` is then their number.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub random_scenes: bool,
    /// How many unlisted tasks of each template were labelled instead of the tasks, at most.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub unlisted: Option<usize>,
    /// Setup and fold if only the fold's training tasks were used; absent if all tasks were.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub training_tasks_of: Option<(Setup, u8)>,
}

fn default_limit() -> usize {
    100
}

impl journal::Entry for LabelledBalls {
    type Settings = LabelSettings;
    const COMMAND: &'static str = "data label";

    fn check(&self) -> Result<(), String> {
        self.scene.task().map_or(Ok(()), check_task)?;
        if let SceneId::Blend(_, second, _) = self.scene {
            check_task(second)?;
        }
        let (paths, balls) = (self.paths.0.len(), self.count());
        if paths != 0 && paths != balls * PATHS_LEN {
            return Err(format!("{} has {balls} balls, but {paths} bytes of paths", self.scene));
        }
        if !self.siblings.is_empty() && self.siblings.len() != balls {
            return Err(format!("{} has {balls} balls, but {} siblings", self.scene, self.siblings.len()));
        }
        self.siblings.iter().flatten().try_for_each(|&sibling| check_task(sibling))?;
        self.solved.iter().chain(&self.failed).try_for_each(|ball| check_ball(&self.scene, ball))
    }
}

/// What a file of `data label` holds.
pub struct Labelled {
    /// A line per task and round.
    pub lines: Vec<LabelledBalls>,
    /// Setup and fold if only the fold's training tasks were used.
    pub training_tasks_of: Option<(Setup, u8)>,
    /// The net that proposed the balls; `None` if they were sampled.
    pub proposer: Option<Proposer>,
    /// The balls are in variants of the scenes.
    pub variants: bool,
    /// The balls are in blends of the scenes.
    pub blends: bool,
    /// The balls are in random scenes.
    pub random_scenes: bool,
    /// The balls are in unlisted tasks.
    pub unlisted: bool,
    tasks: NonZeroUsize,
}

impl Labelled {
    /// Number of rounds; `None` if the last round is not complete.
    pub fn rounds(&self) -> Option<usize> {
        let (lines, tasks) = (self.lines.len(), self.tasks.get());
        lines.is_multiple_of(tasks).then(|| lines / tasks)
    }
}

/// Reads a file of `data label`.
///
/// # Errors
/// If the file is missing or damaged, or was made with another version of the simulator.
pub fn read_labels(path: &Path) -> anyhow::Result<Labelled> {
    let (settings, lines) = journal::read::<LabelledBalls>(path)?;
    let LabelSettings {
        simulator: version,
        tasks,
        training_tasks_of,
        weights,
        net_without_dev: without_dev,
        net_of_random_scenes,
        variants,
        blends,
        random_scenes,
        unlisted,
        ..
    } = settings;
    ensure!(
        version == simulator::VERSION,
        "{} was labelled by simulator {version}, this is simulator {}: label the balls again",
        path.display(),
        simulator::VERSION
    );
    Ok(Labelled {
        lines,
        training_tasks_of,
        proposer: weights.map(|_| match net_of_random_scenes {
            true => Proposer::RandomScenes,
            false => Proposer::Tasks { without_dev },
        }),
        variants,
        blends: blends.is_some(),
        random_scenes,
        unlisted: unlisted.is_some(),
        tasks,
    })
}

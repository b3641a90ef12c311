//! The lines of a `data label` file, and their reader.

use std::num::NonZeroUsize;
use std::path::Path;

use anyhow::ensure;
use pathlight::benchmark::folds::Setup;
use pathlight::nets::LearnedFrom;
use pathlight::simulator;
use serde::{Deserialize, Serialize};

use super::Scenes;
use crate::data::label_use::Proposer;
use crate::data::labels::{LabelledBalls, PATHS_LEN};
use crate::files::journal::{self, check_ball, check_task};

/// Settings that determine the content of a file.
#[derive(Serialize, Deserialize)]
pub struct LabelSettings {
    pub seed: u64,
    pub tasks: NonZeroUsize,
    pub template: Option<usize>,
    pub limit: usize,
    /// `simulator::VERSION`
    pub simulator: u32,
    /// SHA-256 of the solutions file; null if no ball was sampled around one.
    pub solutions: Option<String>,
    /// SHA-256 of the weights that proposed the balls; absent if the balls were sampled.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub weights: Option<String>,
    /// Whether the proposing net was trained without the fold's dev tasks.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub net_without_dev: bool,
    /// What the proposing net has learned from; absent if the balls were sampled.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub net_learned_from: Option<LearnedFrom>,
    #[serde(flatten)]
    pub scene_fields: SceneFields,
    /// Setup and fold if only the fold's training tasks were used; absent if all tasks were.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub training_tasks_of: Option<(Setup, u8)>,
}

/// The fields for the scenes that balls were tried in; all are absent for the scenes of tasks.
#[derive(Default, Serialize, Deserialize)]
#[serde(default)]
pub struct SceneFields {
    /// Whether the scenes are random; `tasks` then counts them.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    random_scenes: bool,
    /// Maximum number of unlisted tasks per template.
    #[serde(skip_serializing_if = "Option::is_none")]
    unlisted: Option<usize>,
}

impl From<Scenes> for SceneFields {
    fn from(scenes: Scenes) -> SceneFields {
        let none = SceneFields::default();
        match scenes {
            Scenes::Tasks => none,
            Scenes::Unlisted(count) => SceneFields { unlisted: Some(count), ..none },
            Scenes::Random(_) => SceneFields { random_scenes: true, ..none },
        }
    }
}

impl journal::Entry for LabelledBalls {
    type Settings = LabelSettings;
    const COMMAND: &'static str = "data label";

    fn check(&self) -> Result<(), String> {
        self.scene.task().map_or(Ok(()), check_task)?;
        let (paths, siblings, balls) = (self.paths.0.len(), self.siblings.len(), self.count());
        if paths != balls * PATHS_LEN || siblings != balls {
            return Err(format!(
                "{} has {balls} balls, but {siblings} siblings and {paths} bytes of paths",
                self.scene
            ));
        }
        self.siblings.iter().flatten().try_for_each(|&sibling| check_task(sibling))?;
        self.solved.iter().chain(&self.failed).try_for_each(|ball| check_ball(&self.scene, ball))
    }
}

/// The content of a `data label` file.
pub struct Labelled {
    /// One line per scene and round.
    pub lines: Vec<LabelledBalls>,
    /// Setup and fold if only the fold's training tasks were used.
    pub training_tasks_of: Option<(Setup, u8)>,
    /// The net that proposed the balls; `None` if they were sampled.
    pub proposer: Option<Proposer>,
    tasks: NonZeroUsize,
}

impl Labelled {
    /// Whether the file ends with a complete round.
    pub fn is_complete(&self) -> bool {
        self.lines.len().is_multiple_of(self.tasks.get())
    }
}

/// Reads a `data label` file.
///
/// # Errors
/// If the file is missing or damaged, or if its balls were tried in other scenes or by another version of the
/// simulator.
pub fn read_labels(path: &Path) -> anyhow::Result<Labelled> {
    let (settings, lines) = journal::read::<LabelledBalls>(path)?;
    let LabelSettings {
        simulator: version,
        tasks,
        training_tasks_of,
        net_without_dev: without_dev,
        net_learned_from,
        ..
    } = settings;
    ensure!(
        version == simulator::VERSION,
        "{} was labelled by simulator {version}, but this is simulator {}: label the balls again",
        path.display(),
        simulator::VERSION
    );
    // A scene is known by its number, so its layout may have changed since.
    if let Some(line) = lines.iter().find(|line| line.count() > 0) {
        ensure!(
            line.tried_again()? == *line,
            "{} has other outcomes than this program finds: label the balls again",
            path.display()
        );
    }
    Ok(Labelled {
        lines,
        training_tasks_of,
        proposer: net_learned_from.map(|learned_from| Proposer { learned_from, without_dev }),
        tasks,
    })
}

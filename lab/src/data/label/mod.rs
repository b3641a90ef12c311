//! Labels balls with their outcomes in all tasks, in unlisted tasks or in random scenes, and writes them as JSON lines,
//! to train a success net, a dynamics net or DQN.
//!
//! The file is a journal: the settings, then for each round one line per scene. The number of lines tells where to
//! continue an interrupted run. The balls depend only on the settings and the solutions.

use std::collections::BTreeSet;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};
use pathlight::agents::agent_name::AgentName;
use pathlight::benchmark::folds::FoldId;
use pathlight::command_line::weights_file::ModelFile;
use pathlight::nets::LearnedFrom;
use pathlight::puzzle::task::TaskId;
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator;
use rayon::prelude::*;

use crate::data::collect::{SOLUTIONS, read_solutions};
use crate::data::labels::LabelledBalls;
use crate::data::scene_id::SceneId;
use crate::data::task_selection::TaskSelection;
use crate::data::unlisted_tasks::unlisted_tasks;
use crate::files::digest;
use crate::files::journal::Journal;
use crate::progress::Progress;
use labeller::{KnownSolutions, Labeller};
pub use lines::{LabelSettings, Labelled, read_labels};

mod labeller;
mod lines;

/// Balls per line, which holds one scene in one round.
pub const BALLS: usize = 64;

/// Of the random scenes that no ball solves, one in this many is labelled.
const UNSOLVED: u32 = 6;

/// Lines written together.
const BLOCK: usize = 100;

/// The default file of labelled balls.
pub const LABELS: &str = "target/labels.jsonl";

/// The scenes that balls are tried in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Scenes {
    /// The scenes of the tasks.
    #[default]
    Tasks,
    /// Up to this many unlisted tasks of each template.
    Unlisted(usize),
    /// Random scenes: of the first N, all that some ball solves and a sixth of the rest.
    Random(u32),
}

/// What to label, and where to write it.
pub struct Settings {
    /// File to write or continue.
    pub out: PathBuf,
    /// Solutions to sample balls around.
    pub solutions: PathBuf,
    /// Number of rounds; each tries 64 balls per scene.
    pub rounds: usize,
    pub selection: TaskSelection,
    pub scenes: Scenes,
    /// Label the balls that the dynamics net in this file proposes, likeliest first, instead of sampled ones; each
    /// round takes the next 64. The net must have been trained on tasks of `training_tasks_of` or on no task; to label
    /// random scenes, on random scenes alone.
    pub weights: Option<PathBuf>,
    /// Label only the training tasks of this fold, and sample only around their solutions.
    pub training_tasks_of: Option<FoldId>,
    /// Seed of all random draws.
    pub seed: u64,
}

impl Default for Settings {
    fn default() -> Settings {
        Settings {
            out: LABELS.into(),
            solutions: SOLUTIONS.into(),
            rounds: 8,
            selection: TaskSelection::default(),
            scenes: Scenes::default(),
            weights: None,
            training_tasks_of: None,
            seed: 0,
        }
    }
}

impl Settings {
    /// Starts or continues labelling.
    ///
    /// # Errors
    /// If the data or the weights cannot be used, or the file cannot be continued or written.
    pub fn label(&self, progress: &mut dyn Progress) -> anyhow::Result<()> {
        // Test tasks must not influence where balls are sampled, so their solutions are left out too.
        let allowed = self.training_tasks_of.map(|fold| fold.tasks().all_train());
        let allows = |id: TaskId| allowed.as_ref().is_none_or(|allowed| allowed.binary_search(&id).is_ok());
        let tasks: Vec<TaskId> = self.selection.ids().filter(|&id| allows(id)).collect();
        let scenes: Vec<SceneId> = match self.scenes {
            Scenes::Tasks => tasks.iter().copied().map(SceneId::Task).collect(),
            Scenes::Unlisted(count) => {
                let templates: BTreeSet<usize> = tasks.iter().map(|task| task.template).collect();
                let of_template = |template: usize| {
                    let combinations = unlisted_tasks(TEMPLATES[template], count);
                    combinations.into_iter().map(move |combination| SceneId::Unlisted(template, combination))
                };
                templates.into_iter().flat_map(of_template).collect()
            }
            Scenes::Random(count) => (0..count).map(SceneId::Random).collect(),
        };
        let proposing = self.weights.as_deref().map(|path| self.proposing_model(path)).transpose()?;
        let with_solutions = self.scenes == Scenes::Tasks && proposing.is_none();
        let card = proposing.as_ref().and_then(|model| model.card.dynamics.as_ref());
        let settings = LabelSettings {
            seed: self.seed,
            tasks: NonZeroUsize::new(scenes.len())
                .context("no task is left to label: choose another --template, --fold or --limit")?,
            template: self.selection.template(),
            limit: self.selection.limit,
            simulator: simulator::VERSION,
            solutions: with_solutions.then(|| digest(&self.solutions)).transpose()?,
            weights: proposing.as_ref().map(|model| model.digest.clone()),
            net_without_dev: card.is_some_and(|card| card.without_dev),
            net_learned_from: card.map(|card| card.learned_from),
            scene_fields: self.scenes.into(),
            training_tasks_of: self.training_tasks_of.map(|FoldId { setup, fold }| (setup, fold)),
        };
        let solutions = if with_solutions { read_solutions(&self.solutions)? } else { Vec::new() };
        let solutions = solutions.into_iter().filter(|one| allows(one.task));
        let nets = proposing.map(|model| model.nets);
        let labeller = Labeller { settings: self, nets, known: KnownSolutions::new(solutions) };
        let total = self.rounds * scenes.len();
        let (mut journal, lines) = Journal::open::<LabelledBalls>(&self.out, &settings, progress)?;
        for (line, scene) in lines.iter().zip(scenes.iter().cycle()) {
            ensure!(
                line.scene == *scene,
                "{} has balls of {} where balls of {scene} are expected: remove the file",
                self.out.display(),
                line.scene,
            );
        }
        let (out, rounds) = (self.out.display(), self.rounds);
        ensure!(lines.len() <= total, "{out} holds more rounds than {rounds}: raise --rounds, or name another file");
        let mut done = lines.len();
        let mut balls: usize = lines.iter().map(LabelledBalls::count).sum();
        progress.begin(total as u64);
        progress.advance(done as u64, format!("{balls} balls"));
        while done < total {
            let block: Vec<LabelledBalls> = (done..total.min(done + BLOCK))
                .into_par_iter()
                .map(|line| labeller.label(scenes[line % scenes.len()], line / scenes.len()))
                .collect();
            journal.append(&block)?;
            done += block.len();
            balls += block.iter().map(LabelledBalls::count).sum::<usize>();
            progress.advance(block.len() as u64, format!("{balls} balls"));
        }
        let what = match self.scenes {
            Scenes::Tasks => "tasks",
            Scenes::Unlisted(_) => "unlisted tasks",
            Scenes::Random(_) => "random scenes",
        };
        progress.finish(&format!("{balls} balls of {} {what}", scenes.len()));
        Ok(())
    }

    /// Reads the weights whose dynamics net proposes balls, if it may do so in the scenes.
    fn proposing_model(&self, path: &Path) -> anyhow::Result<ModelFile> {
        let name = path.display();
        let model = ModelFile::read(Some(path), FoldId::default())?;
        AgentName::Dynamics.check(&model.nets).with_context(|| format!("cannot use {name}"))?;
        let learned_from = model.card.dynamics.as_ref().map(|card| card.learned_from);
        match (self.scenes, self.training_tasks_of) {
            // A net trained on random scenes alone must not learn about tasks through the balls proposed there.
            (Scenes::Random(_), _) => ensure!(
                learned_from == Some(LearnedFrom::RandomScenes),
                "{name} has learned from tasks: for balls in random scenes, name weights that were trained on random \
                 scenes alone"
            ),
            (_, None) => ensure!(
                learned_from != Some(LearnedFrom::Tasks),
                "{name} has learned from tasks: name its fold with --setup and --fold, to label balls of its training \
                 tasks"
            ),
            (_, Some(fold)) => model.check(AgentName::Dynamics, fold)?,
        }
        Ok(model)
    }
}

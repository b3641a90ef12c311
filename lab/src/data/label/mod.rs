//! Balls with their outcome for all tasks, as JSON lines, to train a success net, a dynamics net or DQN on.
//!
//! The file is a journal: the settings, then one line per task and round, in that order, so the number of lines
//! says where an interrupted run continues. The balls depend only on the settings and the solutions.

use std::collections::BTreeMap;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use anyhow::{Context, bail, ensure};
use pathlight::agents::ranking::ranked;
use pathlight::benchmark::folds::FoldId;
use pathlight::nets::{DynamicsCard, PathNet};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator;
use rayon::prelude::*;

use crate::data::collect::{SOLUTIONS, read_solutions};
use crate::data::labels::LabelledBalls;
use crate::data::scene_variants::scene_variant;
use crate::data::solutions::Solution;
use crate::data::task_selection::TaskSelection;
use crate::files::digest;
use crate::files::journal::Journal;
use crate::files::weights_file::load_nets;
use crate::progress::Progress;
pub use lines::{LabelSettings, Labelled, read_labels};

mod lines;

/// Balls of a task per line.
pub const BALLS: usize = 64;

/// Lines that are written together.
const BLOCK: usize = 100;

/// The default file of labelled balls.
pub const LABELS: &str = "target/labels.jsonl";

/// What to label, and where it is kept.
pub struct Settings {
    /// File to write, or to continue.
    pub out: PathBuf,
    /// Solutions to sample balls around.
    pub solutions: PathBuf,
    /// Every task tries 64 balls per round.
    pub rounds: usize,
    pub selection: TaskSelection,
    /// Label the balls that the dynamics net of these weights finds most probable, instead of sampled ones: hard
    /// negatives. Every round takes the next 64. The weights are those of `training_tasks_of`.
    pub weights: Option<PathBuf>,
    /// Label balls in variants of the tasks' scenes, another variant in every round. Balls are sampled around the
    /// solutions of the task alone.
    pub variants: bool,
    /// Use only the training tasks of this fold: only they are labelled, and only their solutions are sampled around.
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
            weights: None,
            variants: false,
            training_tasks_of: None,
            seed: 0,
        }
    }
}

impl Settings {
    /// Labels, or continues with it.
    ///
    /// # Errors
    /// If the data or the weights cannot be used, or the file cannot be continued or written.
    pub fn label(&self, progress: &mut dyn Progress) -> anyhow::Result<()> {
        // Test tasks must not steer where balls are sampled, so their solutions are left out too.
        let allowed = self.training_tasks_of.map(|fold| fold.tasks().all_train());
        let allows = |id: TaskId| allowed.as_ref().is_none_or(|allowed| allowed.binary_search(&id).is_ok());
        let tasks: Vec<Task> = self.selection.tasks().into_iter().filter(|task| allows(task.id)).collect();
        let proposing = match (&self.weights, self.training_tasks_of) {
            (Some(path), Some(fold)) => Some(proposing_nets(path, fold)?),
            (Some(_), None) => bail!("name the fold of the weights that propose balls"),
            (None, _) => None,
        };
        let (nets, card) = proposing.unzip();
        let settings = LabelSettings {
            seed: self.seed,
            tasks: NonZeroUsize::new(tasks.len())
                .context("no task is left to label: choose another --template, --fold or --limit")?,
            template: self.selection.template(),
            limit: self.selection.limit,
            simulator: simulator::VERSION,
            solutions: digest(&self.solutions)?,
            weights: self.weights.as_deref().map(digest).transpose()?,
            net_without_dev: card.is_some_and(|card| card.without_dev),
            variants: self.variants,
            training_tasks_of: self.training_tasks_of.map(|FoldId { setup, fold }| (setup, fold)),
        };
        let mut own_solutions: BTreeMap<TaskId, Vec<Ball>> = BTreeMap::new();
        let mut sibling_solutions: Vec<Vec<Solution>> = vec![Vec::new(); TEMPLATES.len()];
        for solution in read_solutions(&self.solutions)?.solutions.into_iter().filter(|one| allows(one.task)) {
            own_solutions.entry(solution.task).or_default().push(solution.ball);
            sibling_solutions[solution.task.template].push(solution);
        }
        let total = self.rounds * tasks.len();
        let (mut journal, lines) = Journal::open::<LabelledBalls>(&self.out, &settings)?;
        for (line, task) in lines.iter().zip(tasks.iter().cycle()) {
            ensure!(
                line.task == task.id,
                "{} has balls of {} where those of {} belong: remove the file",
                self.out.display(),
                line.task,
                task.id
            );
        }
        let mut done = lines.len();
        progress.begin(total as u64);
        progress.advance(done as u64, format!("{} balls", done * BALLS));
        while done < total {
            let block: Vec<LabelledBalls> = (done..total.min(done + BLOCK))
                .into_par_iter()
                .map(|line| {
                    let (round, task) = (line / tasks.len(), &tasks[line % tasks.len()]);
                    if let Some(read) = nets.as_ref().and_then(|nets| nets.read(&task.scene)) {
                        let ranked = ranked(&read.logits, &task.scene, (round + 1) * BALLS);
                        let balls = ranked.into_iter().skip(round * BALLS).map(|proposal| proposal.ball);
                        return LabelledBalls::simulate(task, balls.collect());
                    }
                    let own = own_solutions.get(&task.id).map_or(&[][..], Vec::as_slice);
                    if self.variants {
                        return in_variant(task, own, self.seed, round);
                    }
                    LabelledBalls::sample(task, own, &sibling_solutions[task.id.template], BALLS, self.seed, round)
                })
                .collect();
            journal.append(&block)?;
            done += block.len();
            progress.advance(block.len() as u64, format!("{} balls", done * BALLS));
        }
        progress.finish(&format!("{} balls of {} tasks", done * BALLS, tasks.len()));
        Ok(())
    }
}

/// Returns the nets of a fold's weights, with their dynamics net, and the card of this.
fn proposing_nets(path: &Path, fold: FoldId) -> anyhow::Result<(PathNet, DynamicsCard)> {
    let (nets, card) = load_nets(Some(path), fold)?;
    let card = card.dynamics.with_context(|| {
        format!("{} has no dynamics net: name weights of `pathlight-lab train dynamics`", path.display())
    })?;
    Ok((nets, card))
}

/// Labels balls in a variant of a task's scene; in the scene itself if no variant of this number fits.
fn in_variant(task: &Task, own_solutions: &[Ball], seed: u64, round: usize) -> LabelledBalls {
    let number = round as u32;
    let variant = scene_variant(task, number);
    let changed = variant.is_some();
    let task = variant.map_or_else(|| task.clone(), |scene| Task { scene, ..task.clone() });
    let own: Vec<Solution> = own_solutions.iter().map(|&ball| Solution { task: task.id, ball }).collect();
    let labelled = LabelledBalls::sample(&task, own_solutions, &own, BALLS, seed, round);
    LabelledBalls { variant: changed.then_some(number), ..labelled }
}

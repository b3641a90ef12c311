//! Balls with their outcome for all tasks, in unlisted tasks or in random scenes, as JSON lines, to train a success
//! net, a dynamics net or DQN on.
//!
//! The file is a journal: the settings, then one line per scene and round, in that order, so the number of lines
//! says where an interrupted run continues. The balls depend only on the settings and the solutions.

use std::collections::{BTreeMap, BTreeSet};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};

use anyhow::{Context, bail, ensure};
use pathlight::agents::ranking::ranked;
use pathlight::benchmark::folds::FoldId;
use pathlight::nets::{DynamicsCard, PathNet};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator;
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use crate::data::collect::{SOLUTIONS, read_solutions};
use crate::data::labels::{LabelledBalls, Sampled, Tried, sample, try_balls};
use crate::data::scene_id::SceneId;
use crate::data::scene_variants::scene_variant;
use crate::data::solutions::Solution;
use crate::data::task_selection::TaskSelection;
use crate::data::unlisted_tasks::unlisted_tasks;
use crate::files::digest;
use crate::files::journal::Journal;
use crate::files::weights_file::load_nets_of_any_fold;
use crate::progress::Progress;
pub use lines::{LabelSettings, Labelled, read_labels};

mod lines;

/// Balls of a scene per line.
pub const BALLS: usize = 64;

/// Of the random scenes that no ball solves, one in this many is labelled.
const UNSOLVED: u32 = 6;

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
    /// Every scene tries 64 balls per round.
    pub rounds: usize,
    pub selection: TaskSelection,
    /// Label the balls that the dynamics net of these weights proposes, likeliest first, instead of sampled ones. Every
    /// round takes the next 64. The net has learned from tasks of `training_tasks_of`, or from random scenes alone; for
    /// balls in random scenes, from these alone.
    pub weights: Option<PathBuf>,
    /// Label balls in variants of the tasks' scenes, another variant in every round. Balls are sampled around the
    /// solutions of the task alone.
    pub variants: bool,
    /// Label balls in random scenes instead of the tasks: in those of the first N that some ball solves, and in a sixth
    /// of the others. Balls are sampled around those that solve.
    pub random_scenes: Option<u32>,
    /// Label balls in up to this many unlisted tasks of each template instead of the tasks. Balls are sampled around
    /// the solutions of its tasks.
    pub unlisted: Option<usize>,
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
            random_scenes: None,
            unlisted: None,
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
        let tasks: Vec<TaskId> = self.selection.ids().filter(|&id| allows(id)).collect();
        let scenes: Vec<SceneId> = match (self.random_scenes, self.unlisted) {
            (Some(count), _) => (0..count).map(SceneId::Random).collect(),
            (None, Some(count)) => {
                let templates: BTreeSet<usize> = tasks.iter().map(|task| task.template).collect();
                let of_template = |template: usize| {
                    let combinations = unlisted_tasks(TEMPLATES[template], count);
                    combinations.into_iter().map(move |combination| SceneId::Unlisted(template, combination))
                };
                templates.into_iter().flat_map(of_template).collect()
            }
            (None, None) => tasks.into_iter().map(SceneId::Task).collect(),
        };
        // Who learns from random scenes alone must not learn from tasks through the balls there.
        let fold = self.training_tasks_of.filter(|_| self.random_scenes.is_none());
        let proposing = self.weights.as_deref().map(|path| proposing_nets(path, fold)).transpose()?;
        let (nets, card) = proposing.unzip();
        let settings = LabelSettings {
            seed: self.seed,
            tasks: NonZeroUsize::new(scenes.len())
                .context("no task is left to label: choose another --template, --fold or --limit")?,
            template: self.selection.template(),
            limit: self.selection.limit,
            simulator: simulator::VERSION,
            solutions: digest(&self.solutions)?,
            weights: self.weights.as_deref().map(digest).transpose()?,
            net_without_dev: card.as_ref().is_some_and(|card| card.without_dev),
            net_of_random_scenes: card.is_some_and(|card| card.random_scenes_alone),
            variants: self.variants,
            random_scenes: self.random_scenes.is_some(),
            unlisted: self.unlisted,
            training_tasks_of: self.training_tasks_of.map(|FoldId { setup, fold }| (setup, fold)),
        };
        let solutions = read_solutions(&self.solutions)?.solutions.into_iter().filter(|one| allows(one.task));
        let labeller = Labeller { settings: self, nets, known: KnownSolutions::new(solutions) };
        let total = self.rounds * scenes.len();
        let (mut journal, lines) = Journal::open::<LabelledBalls>(&self.out, &settings)?;
        for (line, scene) in lines.iter().zip(scenes.iter().cycle()) {
            ensure!(
                line.scene.unchanged() == *scene,
                "{} has balls of {} where those of {scene} belong: remove the file",
                self.out.display(),
                line.scene,
            );
        }
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
        let what = match (self.random_scenes, self.unlisted) {
            (Some(_), _) => "random scenes",
            (None, Some(_)) => "unlisted tasks",
            (None, None) => "tasks",
        };
        progress.finish(&format!("{balls} balls of {} {what}", scenes.len()));
        Ok(())
    }
}

/// Known solutions of the tasks that may be used.
struct KnownSolutions {
    of_task: BTreeMap<TaskId, Vec<Ball>>,
    of_template: Vec<Vec<Solution>>,
}

impl KnownSolutions {
    fn new(solutions: impl Iterator<Item = Solution>) -> KnownSolutions {
        let mut known = KnownSolutions { of_task: BTreeMap::new(), of_template: vec![Vec::new(); TEMPLATES.len()] };
        for solution in solutions {
            known.of_task.entry(solution.task).or_default().push(solution.ball);
            known.of_template[solution.task.template].push(solution);
        }
        known
    }
}

/// Makes the lines of a file.
struct Labeller<'a> {
    settings: &'a Settings,
    /// Those that propose the balls.
    nets: Option<PathNet>,
    known: KnownSolutions,
}

impl Labeller<'_> {
    /// The balls of a scene in a round.
    fn label(&self, id: SceneId, round: usize) -> LabelledBalls {
        match id {
            SceneId::Unlisted(..) | SceneId::Random(_) => self.in_new_scene(id, round),
            SceneId::Task(task) | SceneId::Variant(task, _) => self.in_task(task, round),
        }
    }

    fn in_task(&self, id: TaskId, round: usize) -> LabelledBalls {
        let task = Task::load(id).expect("a task of the selection");
        if let Some(proposed) = self.proposed(&task.scene, round) {
            return LabelledBalls::new(SceneId::Task(id), proposed);
        }
        let own: Vec<Sampled> = self.known.of_task.get(&id).into_iter().flatten().map(|&ball| (ball, None)).collect();
        let number = round as u32;
        // If no variant of this number fits, the scene itself is used.
        let (scene_id, scene, siblings) = match self.settings.variants {
            true => match scene_variant(&task, number) {
                Some(scene) => (SceneId::Variant(id, number), scene, &[][..]),
                None => (SceneId::Task(id), task.scene, &[][..]),
            },
            false => (SceneId::Task(id), task.scene, self.known.of_template[id.template].as_slice()),
        };
        let balls = sample((scene_id, &scene), &own, siblings, BALLS, &mut self.rng(scene_id, round));
        LabelledBalls::new(scene_id, try_balls(&scene, balls))
    }

    /// The balls that the nets find most probable, if there are nets.
    fn proposed(&self, scene: &Scene, round: usize) -> Option<Vec<Tried>> {
        let read = self.nets.as_ref()?.read(scene)?;
        let ranked = ranked(&read.logits, scene, (round + 1) * BALLS);
        let balls = ranked.into_iter().skip(round * BALLS).map(|proposal| (proposal.ball, None));
        Some(try_balls(scene, balls.collect()))
    }

    /// The balls of a scene of which no solutions are known: those that nets propose, or sampled ones, of which some of
    /// the second half are near those of the first that solve. If no proposed ball solves, or none of the first half,
    /// most random scenes are left out, so that nets see about as many with solutions as without: there are no balls
    /// then.
    fn in_new_scene(&self, id: SceneId, round: usize) -> LabelledBalls {
        let scene = id.scene().expect("a scene of the selection");
        let (siblings, unsolved) = match id {
            SceneId::Unlisted(template, _) => (self.known.of_template[template].as_slice(), true),
            SceneId::Random(number) => (&[][..], number.is_multiple_of(UNSOLVED)),
            SceneId::Task(_) | SceneId::Variant(..) => (&[][..], true),
        };
        let is_left_out = |tried: &[Tried]| !unsolved && !tried.iter().any(|ball| ball.solved);
        if let Some(proposed) = self.proposed(&scene, round) {
            let balls = if is_left_out(&proposed) { Vec::new() } else { proposed };
            return LabelledBalls::new(id, balls);
        }
        let mut rng = self.rng(id, round);
        let mut tried = try_balls(&scene, sample((id, &scene), &[], siblings, BALLS / 2, &mut rng));
        if is_left_out(&tried) {
            return LabelledBalls::new(id, Vec::new());
        }
        let own: Vec<Sampled> =
            tried.iter().filter(|ball| ball.solved).map(|&Tried { ball, sibling, .. }| (ball, sibling)).collect();
        tried.extend(try_balls(&scene, sample((id, &scene), &own, siblings, BALLS / 2, &mut rng)));
        LabelledBalls::new(id, tried)
    }

    fn rng(&self, scene: SceneId, round: usize) -> Pcg64Mcg {
        Pcg64Mcg::seed_from_u64(scene.seed(self.settings.seed).wrapping_add(round as u64))
    }
}

/// Returns nets with their dynamics net, and the card of this. It has learned from tasks of the fold, or from random
/// scenes alone.
fn proposing_nets(path: &Path, fold: Option<FoldId>) -> anyhow::Result<(PathNet, DynamicsCard)> {
    let name = path.display();
    let (nets, card) = load_nets_of_any_fold(path)?;
    let trained_on = card.fold_id();
    let card = card
        .dynamics
        .with_context(|| format!("{name} has no dynamics net: name weights of `pathlight-lab train dynamics`"))?;
    match fold {
        _ if card.random_scenes_alone => {}
        Some(fold) => trained_on.check(fold).with_context(|| format!("cannot use {name}"))?,
        None => bail!(
            "{name} has learned from tasks: name its fold with --setup and --fold, to label balls of its training \
             tasks; for balls in random scenes, name weights that were trained on random scenes alone"
        ),
    }
    Ok((nets, card))
}

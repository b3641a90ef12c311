//! Makes the lines of a `data label` file: chooses balls in a scene and simulates them.

use std::collections::BTreeMap;

use pathlight::agents::ranking::ranked;
use pathlight::nets::PathNet;
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::TEMPLATES;
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use super::{BALLS, Settings, UNSOLVED};
use crate::data::labels::{LabelledBalls, Tried, sample, try_balls};
use crate::data::scene_id::SceneId;
use crate::data::solutions::Solution;

/// Known solutions of the tasks that may be used for sampling.
pub struct KnownSolutions {
    of_task: BTreeMap<TaskId, Vec<Ball>>,
    of_template: Vec<Vec<Solution>>,
}

impl KnownSolutions {
    pub fn new(solutions: impl Iterator<Item = Solution>) -> KnownSolutions {
        let mut known = KnownSolutions { of_task: BTreeMap::new(), of_template: vec![Vec::new(); TEMPLATES.len()] };
        for solution in solutions {
            known.of_task.entry(solution.task).or_default().push(solution.ball);
            known.of_template[solution.task.template].push(solution);
        }
        known
    }
}

/// Labels balls in scenes.
pub struct Labeller<'a> {
    pub settings: &'a Settings,
    /// Nets that propose the balls; `None` if balls are sampled.
    pub nets: Option<PathNet>,
    pub known: KnownSolutions,
}

impl Labeller<'_> {
    /// Labels the balls of a scene in a round.
    pub fn label(&self, id: SceneId, round: usize) -> LabelledBalls {
        match id {
            SceneId::Unlisted(..) | SceneId::Random(_) => self.in_new_scene(id, round),
            SceneId::Task(task) => self.in_task(task, round),
        }
    }

    fn in_task(&self, id: TaskId, round: usize) -> LabelledBalls {
        let scene = Task::load(id).expect("a task of the selection").scene;
        let scene_id = SceneId::Task(id);
        if let Some(proposed) = self.proposed(&scene, round) {
            return LabelledBalls::new(scene_id, proposed);
        }
        let own = self.known.of_task.get(&id).map_or(&[][..], Vec::as_slice);
        let siblings = self.known.of_template[id.template].as_slice();
        let balls = sample((scene_id, &scene), own, siblings, BALLS, &mut self.rng(scene_id, round));
        LabelledBalls::new(scene_id, try_balls(&scene, balls))
    }

    /// Labels the balls that the nets rank highest; `None` without nets.
    fn proposed(&self, scene: &Scene, round: usize) -> Option<Vec<Tried>> {
        let read = self.nets.as_ref()?.read(scene)?;
        let ranked = ranked(&read.logits, scene, (round + 1) * BALLS);
        let balls = ranked.into_iter().skip(round * BALLS).map(|proposal| (proposal.ball, None));
        Some(try_balls(scene, balls.collect()))
    }

    /// Labels balls in a scene that is no task, either proposed or sampled. If sampled, the second half includes balls
    /// near solutions found in the first half. Most random scenes without a solution, among the proposed balls or in
    /// the first half, get no balls, so that nets see about as many scenes with solutions as without.
    fn in_new_scene(&self, id: SceneId, round: usize) -> LabelledBalls {
        let scene = id.scene().expect("a scene of the selection");
        let unsolved = match id {
            SceneId::Random(number) => number.is_multiple_of(UNSOLVED),
            SceneId::Unlisted(..) | SceneId::Task(_) => true,
        };
        let is_left_out = |tried: &[Tried]| !unsolved && !tried.iter().any(|ball| ball.solved);
        if let Some(proposed) = self.proposed(&scene, round) {
            let balls = if is_left_out(&proposed) { Vec::new() } else { proposed };
            return LabelledBalls::new(id, balls);
        }
        let mut rng = self.rng(id, round);
        let mut tried = try_balls(&scene, sample((id, &scene), &[], &[], BALLS / 2, &mut rng));
        if is_left_out(&tried) {
            return LabelledBalls::new(id, Vec::new());
        }
        let own: Vec<Ball> = tried.iter().filter(|tried| tried.solved).map(|tried| tried.ball).collect();
        tried.extend(try_balls(&scene, sample((id, &scene), &own, &[], BALLS / 2, &mut rng)));
        LabelledBalls::new(id, tried)
    }

    fn rng(&self, scene: SceneId, round: usize) -> Pcg64Mcg {
        Pcg64Mcg::seed_from_u64(scene.seed(self.settings.seed).wrapping_add(round as u64))
    }
}

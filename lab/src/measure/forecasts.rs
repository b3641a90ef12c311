//! Measures how well the dynamics net imagines paths and outcomes, on test tasks of a fold or in random scenes.
//!
//! Each scene is tried with uniformly random balls and, because few of these solve, with solutions: for a task, the
//! known ones; for a random scene, those found among more random balls. Imagined and real paths are drawn alike, along
//! the sampled positions, and compared by soft IoU. The body at its start may make up half of the image of its path, so
//! a body that never moves is compared too, as a baseline.

use std::collections::BTreeMap;
use std::fmt::{self, Write as _};
use std::path::PathBuf;

use anyhow::Context;
use pathlight::agents::agent_name::AgentName;
use pathlight::agents::sigmoid;
use pathlight::benchmark::folds::FoldId;
use pathlight::command_line::weights_file::ModelFile;
use pathlight::nets::PathNet;
use pathlight::puzzle::action::{Ball, Obstacles};
use pathlight::puzzle::sampled_paths::{SAMPLED_STEPS, SAMPLES, SampledPath};
use pathlight::puzzle::sampling::uniform_ball;
use pathlight::puzzle::scene::Body;
use pathlight::puzzle::task::TaskId;
use pathlight::raster::soft_iou::soft_iou;
use pathlight::raster::trail_image;
use pathlight::simulator::{self, sampled_paths};
use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use super::measured_scenes::MeasuredScenes;
use super::task_set::TaskSet;
use crate::data::collect::{SOLUTIONS, read_solutions};
use crate::data::scene_id::SceneId;

/// Samples whose distances are printed: after 1, 3 and 6.7 s, and at the end.
const PRINTED: [usize; 4] = [3, 8, 12, SAMPLES - 1];

/// Random balls tried to find solutions of a scene without known ones, and the maximum number of solutions used.
const SEARCHED: usize = 200;
const MOST_SOLUTIONS: usize = 10;

/// What to measure.
pub struct Settings {
    pub fold: FoldId,
    pub scenes: MeasuredScenes,
    /// Random balls per scene, in addition to solutions.
    pub balls: u16,
    /// Known solutions.
    pub solutions: PathBuf,
    /// Use only the first N test tasks per template.
    pub limit: Option<u16>,
    /// Seed of the random balls.
    pub seed: u64,
    /// Weights of the model; `None` means the shipped ones.
    pub weights: Option<PathBuf>,
}

impl Default for Settings {
    fn default() -> Settings {
        let solutions = SOLUTIONS.into();
        let scenes = MeasuredScenes::Tasks(TaskSet::Test);
        Settings { fold: FoldId::default(), scenes, balls: 20, solutions, limit: None, seed: 0, weights: None }
    }
}

/// The outcome and paths of a ball compared with the imagined ones.
pub struct Forecast {
    solved: bool,
    /// Predicted chance, 0..=1.
    chance: f64,
    /// Chance predicted from the imagined paths alone, 0..=1.
    path_chance: f64,
    /// Soft IoU of the imagined and real path of the green object.
    object_iou: f64,
    /// Soft IoU if the object were imagined at rest.
    resting_iou: f64,
    /// Soft IoU of the imagined and real path of the ball.
    ball_iou: f64,
    /// Distance between imagined and real positions of the object at each of `PRINTED`, px.
    distances: [f64; PRINTED.len()],
}

impl Settings {
    /// Measures the forecasts; returns a table.
    ///
    /// # Errors
    /// If the weights or the solutions cannot be used.
    pub fn measure(&self) -> anyhow::Result<String> {
        let model = ModelFile::read(self.weights.as_deref(), self.fold)?;
        model.check(AgentName::Dynamics, self.fold)?;
        self.scenes.check(&model.card)?;
        let mut solutions: BTreeMap<TaskId, Vec<Ball>> = BTreeMap::new();
        for solution in read_solutions(&self.solutions)? {
            solutions.entry(solution.task).or_default().push(solution.ball);
        }
        let scenes = self.scenes.ids(self.fold, self.limit);
        let of_scenes: Vec<Vec<Forecast>> =
            scenes.par_iter().map(|&id| self.forecasts(&model.nets, id, &solutions)).collect::<anyhow::Result<_>>()?;
        Ok(self.table(scenes.len(), &of_scenes.iter().flatten().collect::<Vec<_>>())?)
    }

    /// Formats the means over the balls that solve and over those that do not.
    fn table(&self, scenes: usize, forecasts: &[&Forecast]) -> Result<String, fmt::Error> {
        let mut text = format!(
            "{} {}, {} {}, {} random balls each and solutions, seed {}, simulator {}\n",
            self.fold.setup,
            self.fold.fold,
            scenes,
            self.scenes.words(),
            self.balls,
            self.seed,
            simulator::VERSION
        );
        let steps = PRINTED.map(|sample| format!("{:>7}", format!("{:.1} s", SAMPLED_STEPS[sample] as f64 / 60.0)));
        writeln!(
            text,
            "{:21}{:^22}{:^28}  distance of the object, px, after",
            "", "mean chance", "soft IoU of the paths"
        )?;
        writeln!(
            text,
            "{:12}{:>9}{:>9}{:>13}{:>8}{:>13}{:>7}{}",
            "",
            "balls",
            "all",
            "paths alone",
            "object",
            "(at rest)",
            "ball",
            steps.concat()
        )?;
        for (name, solved) in [("solved", true), ("not solved", false)] {
            let of: Vec<&Forecast> = forecasts.iter().copied().filter(|forecast| forecast.solved == solved).collect();
            if of.is_empty() {
                writeln!(text, "{name:12}{:>9}", 0)?;
                continue;
            }
            let mean = |value: &dyn Fn(&Forecast) -> f64| {
                of.iter().map(|forecast| value(forecast)).sum::<f64>() / of.len() as f64
            };
            let distances: Vec<String> = (0..PRINTED.len())
                .map(|index| format!("{:>7.1}", mean(&|forecast| forecast.distances[index])))
                .collect();
            writeln!(
                text,
                "{name:12}{:>9}{:>7.1} %{:>11.1} %{:>8.2}{:>13}{:>7.2}{}",
                of.len(),
                100.0 * mean(&|forecast| forecast.chance),
                100.0 * mean(&|forecast| forecast.path_chance),
                mean(&|forecast| forecast.object_iou),
                format!("({:.2})", mean(&|forecast| forecast.resting_iou)),
                mean(&|forecast| forecast.ball_iou),
                distances.concat()
            )?;
        }
        Ok(text)
    }

    /// Compares forecasts with rollouts, for random balls and the solutions of a scene.
    fn forecasts(
        &self,
        nets: &PathNet,
        id: SceneId,
        known: &BTreeMap<TaskId, Vec<Ball>>,
    ) -> anyhow::Result<Vec<Forecast>> {
        let scene = id.scene()?;
        let mut rng = Pcg64Mcg::seed_from_u64(id.seed(self.seed));
        let obstacles = Obstacles::new(&scene);
        let mut random = std::iter::repeat_with(|| uniform_ball(&obstacles, &mut rng)).map_while(|ball| ball);
        let mut balls: Vec<Ball> = random.by_ref().take(self.balls.into()).collect();
        let solutions: Vec<Ball> = match id {
            SceneId::Task(task) => known.get(&task).cloned().unwrap_or_default(),
            SceneId::Unlisted(..) | SceneId::Random(_) => {
                let solves = |ball: &Ball| simulator::outcome(&scene, Some(*ball)).is_ok_and(|outcome| outcome.solved);
                random.take(SEARCHED).filter(solves).take(MOST_SOLUTIONS).collect()
            }
        };
        // Known solutions were found by the same draws, so some are among the random balls.
        balls.retain(|ball| !solutions.contains(ball));
        balls.extend(&solutions);
        let read = nets.read(&scene).context("the weights have no dynamics net")?;
        let object = &scene.bodies[scene.body1];
        let simulated = |ball: Ball| sampled_paths(&scene, ball).map_err(|why| anyhow::anyhow!("{id}, {ball}: {why}"));
        let forecasts = balls.iter().zip(read.imagine(&balls)).map(|(&ball, imagined)| {
            let (outcome, real) = simulated(ball)?;
            let path_of_object = image(object, &real.object);
            let iou = |body: &Body, imagined: &SampledPath, real: &SampledPath| {
                soft_iou(&image(body, imagined), &image(body, real))
            };
            Ok(Forecast {
                solved: outcome.solved,
                chance: sigmoid(imagined.logit.into()),
                path_chance: sigmoid(imagined.path_logit.into()),
                object_iou: iou(object, &imagined.paths.object, &real.object),
                resting_iou: soft_iou(&image(object, &[]), &path_of_object),
                ball_iou: iou(&ball.body(), &imagined.paths.ball, &real.ball),
                distances: PRINTED.map(|sample| {
                    let ([x, y], [u, v]) = (imagined.paths.object[sample], real.object[sample]);
                    f64::from((x - u).hypot(y - v))
                }),
            })
        });
        forecasts.collect()
    }
}

/// The image of a path, `CELLS` values.
fn image(body: &Body, path: &[[f32; 2]]) -> Vec<f32> {
    let points: Vec<[f64; 2]> = path.iter().map(|point| point.map(f64::from)).collect();
    trail_image(body, &points).to_f32().collect()
}

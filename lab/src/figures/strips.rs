//! Strips of single tasks: imagined maps and paths next to the simulated ones.
//!
//! The tasks are chosen by a rule. The agent replays them and must reproduce its evaluation.

use anyhow::{Context, ensure};
use pathlight::agents::agent_name::{AgentName, Loaded};
use pathlight::agents::{Origin, Proposal};
use pathlight::benchmark::auccess::MAX_ATTEMPTS;
use pathlight::colour::imagined_maps::ImaginedMap;
use pathlight::command_line::weights_file::ModelFile;
use pathlight::nets::{Imagined, PathNet};
use pathlight::puzzle::rollout::{Rollout, STEPS_PER_SECOND};
use pathlight::puzzle::sampled_paths::{SampledPath, SampledPaths};
use pathlight::puzzle::scene::{Body, Role};
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::raster::path_image;
use pathlight::raster::soft_iou::soft_iou;
use pathlight::session::turn::Turn;
use pathlight::simulator::simulate;
use svg::node::element::{Definitions, Group, Use};

use super::picture::{Anchor, Figure, MUTED, words};
use super::scene_drawing::{self, LineStyle, ball_outline, hatch, map, path, positions, window};
use super::shipped_folds;
use crate::measure::report::Report;
use crate::measure::shipped::Shipped;

/// Headings of the pictures in a strip.
const COLUMNS: [&str; 7] =
    ["task", "base path", "target path", "action path", "placement", "the chosen ball", "what happens"];

/// Layout, px: side of a picture, distances to the next picture and strip, width of the text on the left, margin, and
/// height of the headings.
const SIDE: f64 = 124.0;
const STEP: [f64; 2] = [SIDE + 6.0, SIDE + 24.0];
const LEFT: f64 = 128.0;
const MARGIN: f64 = 14.0;
const HEAD: f64 = 18.0;

/// Opacity of the scene below a map, 0..=1.
const BELOW: f64 = 0.35;

/// A task counts as solved late if this attempt or a later one solved it.
const LATE: usize = 10;

type Rule = fn(Option<usize>) -> bool;

/// The rules that choose the tasks of each setup, in order.
const CHOICE: [(Rule, &str); 3] = [
    (|first| first == Some(1), "solved at once"),
    (|first| matches!(first, Some(LATE..)), "solved late"),
    (|first| first.is_none(), "not solved"),
];

struct Strip {
    task: Task,
    /// The outcome, shown below the name of the task.
    note: &'static str,
    imagined: Imagined,
    /// The number of the attempt that is shown, from 1.
    attempt: usize,
    proposal: Proposal,
    /// The paths that the dynamics net imagines for the ball, if the model has such a net.
    expected: Option<SampledPaths>,
    /// The rollout without a ball.
    base: Rollout,
    rollout: Rollout,
}

/// Draws the figure.
///
/// # Errors
/// If the evaluations or the weights are missing, or do not belong together.
pub fn draw(shipped: &Shipped) -> anyhow::Result<Figure> {
    let mut definitions = Definitions::new().add(hatch());
    let mut content = Group::new();
    for (column, heading) in COLUMNS.into_iter().enumerate() {
        let at = [left(column) + SIDE / 2.0, MARGIN + 11.0];
        content = content.add(words(heading, at, 12.0, Anchor::Middle).set("font-weight", "bold"));
    }
    let (mut numbers, mut count) = (Vec::new(), 0);
    for fold in shipped_folds() {
        let (report, _) = shipped.read::<Report>(&fold.to_string())?;
        let weights = shipped.assets.join(format!("{fold}.safetensors"));
        let model = ModelFile::read(Some(&weights), fold)?;
        model.check(AgentName::Online, fold)?;
        let firsts = report.first_solved(AgentName::Online).context("the evaluation lacks the online agent")?;
        let chosen = CHOICE.into_iter().filter_map(|(rule, note)| {
            let task = report.tasks().into_iter().zip(firsts).find(|&(_, &first)| rule(first));
            task.map(|(task, &first)| (task, first, note))
        });
        for (task, first, note) in chosen {
            let strip = Strip::play(&model.nets, report.seed, task, first, note)?;
            let id = format!("scene-{count}");
            definitions = definitions.add(scene_drawing::scene(&strip.task.scene).set("id", id.as_str()));
            let (drawn, sentence) = strip.draw(&format!("{}, fold {}", fold.setup, fold.fold), count, &id)?;
            content = content.add(drawn);
            numbers.push(sentence);
            count += 1;
        }
    }
    let width = left(COLUMNS.len()) - STEP[0] + SIDE + MARGIN;
    Ok(Figure {
        name: "strips",
        title: "What the nets imagine, and what happens",
        caption: format!(
            "For each setup, the first test task of fold 0 that the agent solved at once, the first that it solved at \
             attempt {LATE} or later, and the first that it did not solve within {MAX_ATTEMPTS}. The maps show what \
             the nets imagine before anything moves. The lines over them show the simulation: without a ball over the \
             base path, with the shown ball over the target and action paths (IoU is their soft overlap), and the ball \
             itself over the placement. The shown ball is the one that solved, or the first one; the dotted lines are \
             the paths that the dynamics net imagines for it."
        ),
        numbers: numbers.join(" "),
        size: [width, MARGIN + HEAD + count as f64 * STEP[1] + 6.0],
        definitions,
        content,
    })
}

fn left(column: usize) -> f64 {
    MARGIN + LEFT + column as f64 * STEP[0]
}

impl Strip {
    /// Replays the task with the agent.
    fn play(nets: &PathNet, seed: u64, id: TaskId, first: Option<usize>, note: &'static str) -> anyhow::Result<Strip> {
        let task = Task::load(id)?;
        let scene = &task.scene;
        let agent = AgentName::Online;
        let loaded = Loaded { nets: Some(nets), dqn: None };
        let mut turn = Turn::new(scene.clone(), agent.start(loaded, scene, id.seed(seed), MAX_ATTEMPTS));
        let (mut shown, mut attempts, mut solved) = (None, 0, false);
        while let Some((proposal, rollout)) = turn.attempt()? {
            attempts += 1;
            solved = rollout.solved;
            if attempts == 1 || solved {
                shown = Some((attempts, proposal, rollout));
            }
        }
        ensure!(
            first == solved.then_some(attempts),
            "the evaluation and the weights disagree on {id}: measure the weights again with `pathlight-lab measure \
             evaluate --json`"
        );
        let (attempt, proposal, rollout) = shown.with_context(|| format!("the agent proposes no ball for {id}"))?;
        let expected = nets.read(scene).and_then(|read| read.imagine(&[proposal.ball]).first().map(|ball| ball.paths));
        let (imagined, base) = (nets.imagine(scene), simulate(scene, None)?);
        Ok(Strip { imagined, expected, base, attempt, proposal, rollout, note, task })
    }

    /// Draws the strip. Also returns its numbers as a sentence.
    fn draw(&self, fold: &str, row: usize, scene_id: &str) -> anyhow::Result<(Group, String)> {
        let Strip { task, imagined, proposal: Proposal { ball, origin, .. }, rollout, .. } = self;
        let scene = &task.scene;
        let (object, red) = (&scene.bodies[scene.body1], ball.body());
        let whole = || Group::new().add(Use::new().set("href", format!("#{scene_id}")));
        let faint = || whole().set("opacity", BELOW);
        let real = |rollout: &Rollout, body, role| path(&positions(rollout, body), role, LineStyle::Real);
        let [green_path, red_path] =
            [(scene.body1, Role::Green), (scene.bodies.len(), Role::Red)].map(|(body, role)| real(rollout, body, role));
        let shaded = |which, values: &[f32]| map(which, values, values.iter().copied().fold(0.0, f32::max));
        let overlap = |values: &[f32], body: &Body, rollout: &Rollout, index| {
            soft_iou(values, &path_image(body, rollout, index).to_f32().collect::<Vec<f32>>())
        };
        let base = overlap(&imagined.base, object, &self.base, scene.body1);
        let target = overlap(&imagined.target, object, rollout, scene.body1);
        let action = overlap(&imagined.action, &red, rollout, scene.bodies.len());
        let iou = |value: f64| format!("IoU {value:.2}");
        let chance = match origin {
            Origin::Imagined { probability, .. } | Origin::Success { probability } | Origin::Dqn { probability } => {
                format!(", chance {:.0} %", 100.0 * probability)
            }
            Origin::Map { .. } | Origin::Perturbed { .. } | Origin::Uniform => String::new(),
        };
        let attempt = format!("attempt {}{chance}", self.attempt);
        let seconds = rollout.steps as f64 / STEPS_PER_SECOND as f64;
        let ending = if rollout.solved { format!("solved after {seconds:.1} s") } else { "not solved".to_string() };
        let expected = self.expected.iter().flat_map(|paths| {
            let dotted = |from: &Body, points: &SampledPath, role| {
                let points: Vec<[f64; 2]> =
                    std::iter::once([from.x, from.y]).chain(points.iter().map(|point| point.map(f64::from))).collect();
                path(&points, role, LineStyle::Imagined)
            };
            [dotted(&red, &paths.ball, Role::Red), dotted(object, &paths.object, Role::Green)]
        });
        let pictures: [(Vec<Group>, String); COLUMNS.len()] = [
            (vec![whole()], String::new()),
            (
                vec![faint(), shaded(ImaginedMap::Base, &imagined.base), real(&self.base, scene.body1, Role::Green)],
                iou(base),
            ),
            (vec![faint(), shaded(ImaginedMap::Target, &imagined.target), green_path.clone()], iou(target)),
            (vec![faint(), shaded(ImaginedMap::Action, &imagined.action), red_path.clone()], iou(action)),
            (vec![faint(), shaded(ImaginedMap::Placement, &imagined.placement), ball_outline(*ball)], String::new()),
            ([whole(), scene_drawing::ball(*ball)].into_iter().chain(expected).collect(), attempt.clone()),
            (vec![scene_drawing::last_frame(scene, *ball, rollout), red_path, green_path], ending.clone()),
        ];
        let top = MARGIN + HEAD + row as f64 * STEP[1];
        let mut drawn = Group::new();
        let template = TEMPLATES[task.id.template].name;
        let title = [
            (template.to_string(), 12.0, "bold"),
            (task.id.to_string(), 11.0, "normal"),
            (fold.to_string(), 11.0, "normal"),
            (self.note.to_string(), 11.0, "normal"),
        ];
        for (index, (line, size, weight)) in title.into_iter().enumerate() {
            let at = [MARGIN, top + SIDE / 2.0 - 20.0 + 16.0 * index as f64];
            drawn = drawn.add(words(line, at, size, Anchor::Start).set("font-weight", weight));
        }
        for (column, (content, below)) in pictures.into_iter().enumerate() {
            drawn = drawn.add(window([left(column), top], SIDE, content));
            if !below.is_empty() {
                let at = [left(column) + SIDE / 2.0, top + SIDE + 13.0];
                drawn = drawn.add(words(below, at, 11.0, Anchor::Middle).set("fill", MUTED));
            }
        }
        let sentence = format!(
            "{} {template}, {fold}, {}: base path {}, target path {}, action path {}; {attempt}: {ending}.",
            task.id,
            self.note,
            iou(base),
            iou(target),
            iou(action),
        );
        Ok((drawn, sentence))
    }
}

//! The sheet of all templates: each with its first task, the ball at the start, and how it is solved.

use std::collections::BTreeMap;
use std::path::Path;

use anyhow::{Context, ensure};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::scene::{Role, Scene};
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::puzzle::templates::{TEMPLATES, Template};
use pathlight::simulator::simulate;
use svg::node::element::{Definitions, Group};

use super::picture::{Anchor, Figure, MUTED, words};
use super::scene_drawing::{self, LineStyle, hatch, path, positions, window};
use crate::data::collect::read_solutions;

/// Templates in a row.
const COLUMNS: usize = 5;

/// Side of a picture, space between the two of a template, and around all, px.
const SIDE: f64 = 100.0;
const GAP: f64 = 3.0;
const MARGIN: f64 = 14.0;

/// Width and height of a template, px.
const CELL: [f64; 2] = [2.0 * SIDE + GAP + 12.0, SIDE + 28.0];

/// Draws the figure.
///
/// # Errors
/// If the solutions cannot be read, or a task that is drawn has none.
pub fn draw(solutions: &Path) -> anyhow::Result<Figure> {
    let mut known: BTreeMap<TaskId, Ball> = BTreeMap::new();
    for solution in read_solutions(solutions)?.solutions {
        known.entry(solution.task).or_insert(solution.ball);
    }
    let mut content = Group::new();
    let mut numbers = Vec::new();
    for template in TEMPLATES {
        let task = Task::of(template).next().with_context(|| format!("{} has no tasks", template.name))?;
        let &ball = known.get(&task.id).with_context(|| {
            format!(
                "{} has no solution of {}: find one with `pathlight-lab data collect`",
                solutions.display(),
                task.id
            )
        })?;
        numbers.push(format!("{} {}: {}", task.id, template.name, template.story));
        content = content.add(cell(template, &task, ball)?);
    }
    let rows = TEMPLATES.len().div_ceil(COLUMNS) as f64;
    Ok(Figure {
        name: "templates",
        title: "The 25 templates",
        caption: "The first task of each template: left the start, with the red ball of the first known solution; \
                  right the end, with the paths of the green object and of the red ball. The green object has to touch \
                  the hatched goal for three seconds."
            .to_string(),
        numbers: numbers.join(" "),
        size: [COLUMNS as f64 * CELL[0] - 12.0 + 2.0 * MARGIN, rows * CELL[1] - 8.0 + 2.0 * MARGIN],
        definitions: Definitions::new().add(hatch()),
        content,
    })
}

fn cell(template: &Template, task: &Task, ball: Ball) -> anyhow::Result<Group> {
    let (column, row) = ((template.number % COLUMNS) as f64, (template.number / COLUMNS) as f64);
    let [x, y] = [MARGIN + column * CELL[0], MARGIN + row * CELL[1]];
    let start = vec![scene_drawing::scene(&task.scene), scene_drawing::ball(ball)];
    let name = words(template.name, [x, y + 11.0], 12.0, Anchor::Start);
    let number = words(task.id.to_string(), [x + 2.0 * SIDE + GAP, y + 11.0], 10.0, Anchor::End).set("fill", MUTED);
    Ok(Group::new().add(name).add(number).add(window([x, y + 16.0], SIDE, start)).add(window(
        [x + SIDE + GAP, y + 16.0],
        SIDE,
        end(&task.scene, task.id, ball)?,
    )))
}

/// The end of the rollout, and the paths.
fn end(scene: &Scene, id: TaskId, ball: Ball) -> anyhow::Result<Vec<Group>> {
    let rollout = simulate(scene, Some(ball)).map_err(|why| anyhow::anyhow!("{id}, {ball}: {why}"))?;
    ensure!(
        rollout.solved,
        "the ball {ball} does not solve {id}: the solutions are those of another simulator; find new ones with \
         `pathlight-lab data collect`"
    );
    let real = |body, role| path(&positions(&rollout, body), role, LineStyle::Real);
    Ok(vec![
        scene_drawing::last_frame(scene, ball, &rollout),
        real(scene.bodies.len(), Role::Red),
        real(scene.body1, Role::Green),
    ])
}

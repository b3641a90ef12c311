//! The lines that an agent is told: a task or a scene to begin with, and what became of a ball.

use anyhow::{Context, bail};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::own_scene::sentences;
use pathlight::puzzle::recorded_paths::RecordedPaths;
use pathlight::puzzle::rollout::Status;
use pathlight::puzzle::sampled_paths::SampledPaths;
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::TaskId;
use pathlight::session::played::Played;
use serde::Deserialize;
use serde_json::Value;

use super::super::json_lines;

/// Longest line, bytes. The paths of a rollout need about 10,000, a scene less.
pub const MAX_LINE: usize = 1 << 18;

const EXAMPLES: &str = r#"write a line like {"task":"00007:008"} or {"status":"not_solved"}"#;

/// What a line says.
pub enum Line {
    Task(TaskId),
    Scene(Scene),
    Own(Box<Played>),
    Outcome {
        /// The task and the ball that it is the outcome of, if the line names them, as those of `simulate` do.
        task: Option<TaskId>,
        ball: Option<Ball>,
        status: Status,
        paths: Option<Box<SampledPaths>>,
    },
}

/// The keys of a line; others are ignored.
#[derive(Deserialize)]
struct Keys {
    task: Option<TaskId>,
    scene: Option<Value>,
    ball: Option<Ball>,
    status: Option<Status>,
    paths: Option<RecordedPaths>,
}

impl Line {
    /// # Errors
    /// Says what is wrong with the line, and how to write it.
    pub fn parse(line: &[u8]) -> anyhow::Result<Line> {
        match json_lines::parse::<Keys>(line, EXAMPLES)? {
            Keys { task, scene: None, ball, status: Some(status), paths } => {
                let sampled = |paths: RecordedPaths| {
                    paths.sampled().context(
                    "`paths` needs at least one pose [x,y,angle] for each of `object` and `ball`: leave it out if there are none",
                )
                };
                Ok(Line::Outcome { task, ball, status, paths: paths.map(sampled).transpose()?.map(Box::new) })
            }
            Keys { task: Some(task), scene: None, status: None, .. } => Ok(Line::Task(task)),
            Keys { task: None, scene: Some(scene), status: None, .. } => scene_line(scene),
            Keys { task: None, scene: None, status: None, .. } => {
                bail!("`task`, `scene` and `status` are missing; {EXAMPLES}")
            }
            _ => bail!("`task`, `scene` and `status` belong on lines of their own; {EXAMPLES}"),
        }
    }
}

/// Returns what a scene begins: an own scene has a version, others are as `tasks --json` prints them.
fn scene_line(scene: Value) -> anyhow::Result<Line> {
    if scene.get("version").is_none() {
        let scene: Scene = serde_json::from_value(scene).map_err(|error| anyhow::anyhow!("{error}; {EXAMPLES}"))?;
        scene.check_form()?;
        return Ok(Line::Scene(scene));
    }
    Played::read(scene)
        .map(|played| Line::Own(Box::new(played)))
        .map_err(|problems| anyhow::anyhow!("{}", sentences(&problems)))
}

//! The lines that an agent reads: a task or a scene to begin, or the outcome of a ball.

use anyhow::{Context, bail, ensure};
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::custom_scene::sentences;
use pathlight::puzzle::recorded_paths::RecordedPaths;
use pathlight::puzzle::rollout::Status;
use pathlight::puzzle::sampled_paths::SampledPaths;
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::TaskId;
use pathlight::session::puzzle::Puzzle;
use serde::Deserialize;
use serde_json::Value;

use super::super::json_lines;

/// Longest line, bytes. The paths of a rollout need about 10,000; a scene needs less.
pub const MAX_LINE: usize = 1 << 18;

const EXAMPLES: &str = r#"write a line like {"task":"00007:008"} or {"status":"not_solved"}"#;

/// The content of a line.
pub enum Line {
    Begin {
        puzzle: Begun,
        /// Use what the memory holds, and remember the attempts.
        remember: bool,
    },
    /// Forget everything in the memory.
    Forget,
    Outcome {
        /// The task and the ball that the outcome belongs to, if the line names them, as the lines of `simulate` do.
        task: Option<TaskId>,
        ball: Option<Ball>,
        status: Status,
        paths: Option<Box<SampledPaths>>,
    },
}

/// A puzzle to begin.
pub enum Begun {
    Task(TaskId),
    Scene(Scene),
    Custom(Box<Puzzle>),
}

/// The keys of a line; other keys are ignored.
#[derive(Deserialize)]
struct Keys {
    task: Option<TaskId>,
    scene: Option<Value>,
    #[serde(default)]
    remember: bool,
    #[serde(default)]
    forget: bool,
    ball: Option<Ball>,
    status: Option<Status>,
    paths: Option<RecordedPaths>,
}

impl Line {
    /// # Errors
    /// If the line is not valid; the error names the fault and the remedy.
    pub fn parse(line: &str) -> anyhow::Result<Line> {
        let Keys { task, scene, remember, forget, ball, status, paths } = json_lines::parse(line, EXAMPLES)?;
        ensure!(!remember || status.is_none(), "`remember` belongs on the line that begins the puzzle; {EXAMPLES}");
        let begins = |puzzle| Line::Begin { puzzle, remember };
        match (task, scene, status, forget) {
            (None, None, None, true) if !remember => Ok(Line::Forget),
            (_, _, _, true) => bail!("`forget` belongs on a separate line: {{\"forget\":true}}"),
            (task, None, Some(status), false) => {
                let sampled = |paths: RecordedPaths| {
                    let [object, ball] = [&paths.object, &paths.ball].map(|path| path.len());
                    ensure!(
                        object == ball,
                        "`paths` has {object} poses of `object` and {ball} of `ball`: give both of each step"
                    );
                    ensure!(
                        (1..=RecordedPaths::MOST).contains(&object),
                        "`paths` has {object} poses of each body, and should have 1 to {}, at the start and at every \
                         tenth step: leave out those between, or `paths` if there are none",
                        RecordedPaths::MOST
                    );
                    paths.sampled().context("`paths` has poses that are too far apart: correct them")
                };
                Ok(Line::Outcome { task, ball, status, paths: paths.map(sampled).transpose()?.map(Box::new) })
            }
            (Some(task), None, None, false) => Ok(begins(Begun::Task(task))),
            (None, Some(scene), None, false) => scene_line(scene).map(begins),
            (None, None, None, false) => bail!("`task`, `scene` and `status` are missing; {EXAMPLES}"),
            _ => bail!("`task`, `scene` and `status` belong on separate lines; {EXAMPLES}"),
        }
    }
}

/// Returns the puzzle that a scene begins. A custom scene has a version; other scenes are as `tasks --json` prints
/// them.
fn scene_line(scene: Value) -> anyhow::Result<Begun> {
    if scene.get("version").is_none() {
        let scene: Scene = serde_json::from_value(scene).map_err(|error| anyhow::anyhow!("{error}; {EXAMPLES}"))?;
        scene.check_form()?;
        return Ok(Begun::Scene(scene));
    }
    Puzzle::read(scene)
        .map(|puzzle| Begun::Custom(Box::new(puzzle)))
        .map_err(|problems| anyhow::anyhow!("{}", sentences(&problems)))
}

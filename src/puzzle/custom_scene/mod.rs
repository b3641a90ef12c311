//! Custom scenes: scenes that people make, in the form in which they are edited, shared and stored. Versioned JSON,
//! whose schema is `assets/scene.schema.json` (`pathlight tasks --schema`).
//!
//! A body is a shape with its lengths, a position, and whether it moves. Its colour follows from the goal. `read`
//! accepts untrusted JSON, and `limit_problems` reports violated limits. `session::scene_check` adds the checks that
//! need the simulator; only it yields a scene to play.

use std::f64::consts::{FRAC_1_SQRT_2, TAU};
use std::ops::RangeInclusive;

use serde::{Deserialize, Serialize};

use super::dimensions::Dimensions;
use super::scene::{Body, Role, SIZE, Scene};

mod problem;
mod read;

pub use problem::{Fault, Problem, sentences};

/// The version of the format.
pub const VERSION: u32 = 1;

/// Allowed numbers of bodies in a scene; the benchmark's scenes have up to 61.
pub const BODIES: RangeInclusive<usize> = 2..=64;

/// Maximum number of characters in a name.
pub const NAME_LENGTH: usize = 60;

/// Maximum depth by which a dynamic body may overlap another body or a wall at the start, px. The position solver
/// separates them without giving them speed. The deepest overlap of two bodies in the benchmark is 2.73 px (00006:164).
pub const MAX_OVERLAP: f64 = 3.0;

/// Maximum distance by which a dynamic body may reach over a corner of the scene, along the diagonal, px. The walls
/// only meet at the corners: of bodies that reached over by 1.6 px or more, some slipped out between the walls.
const OVER_CORNER: f64 = 1.0;

/// Maximum distance of a static body from the scene, px. Some of the benchmark's are up to 90 px away and never
/// touched.
const OUTSIDE: f64 = 128.0;

/// A scene made by a person.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct CustomScene {
    /// The version of the format: 1.
    #[cfg_attr(not(target_arch = "wasm32"), schemars(range(min = VERSION, max = VERSION)))]
    pub version: u32,
    /// A name for people. It does not affect the puzzle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[cfg_attr(not(target_arch = "wasm32"), schemars(length(max = NAME_LENGTH)))]
    pub name: Option<String>,
    /// The green object, which must touch `body2` for three seconds: an index into `bodies`, from 0. It is dynamic.
    pub body1: usize,
    /// The goal: another index into `bodies`.
    pub body2: usize,
    /// The bodies, without the walls around the scene.
    #[cfg_attr(not(target_arch = "wasm32"), schemars(length(min = *BODIES.start(), max = *BODIES.end())))]
    pub bodies: Vec<CustomBody>,
}

/// A body of a custom scene. The scene is 256 x 256 px, with its origin at the bottom left and y up.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(not(target_arch = "wasm32"), derive(schemars::JsonSchema))]
pub struct CustomBody {
    /// The shape and its lengths.
    #[serde(flatten)]
    pub dimensions: Dimensions,
    /// Position of the origin, px.
    pub x: f64,
    /// Position of the origin, px.
    pub y: f64,
    /// Radians, counter-clockwise.
    #[cfg_attr(not(target_arch = "wasm32"), schemars(range(min = -TAU, max = TAU)))]
    pub angle: f64,
    /// Whether the body moves. A dynamic body lies inside the scene with a tolerance of 3 px, or 1 px at a corner; a
    /// static body is at most 128 px outside.
    pub dynamic: bool,
}

impl CustomScene {
    /// Returns a scene in this form; `None` if a body has none of the four shapes.
    ///
    /// ```
    /// use pathlight::puzzle::{custom_scene::CustomScene, task::Task};
    /// let task = Task::load("00007:008".parse()?)?;
    /// assert!(CustomScene::of(&task.scene).is_some_and(|custom| custom.limit_problems().is_empty()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn of(scene: &Scene) -> Option<CustomScene> {
        let body = |body: &Body| {
            let &Body { x, y, angle, dynamic, .. } = body;
            Dimensions::of(body).map(|dimensions| CustomBody { dimensions, x, y, angle, dynamic })
        };
        let bodies = scene.bodies.iter().map(body).collect::<Option<_>>()?;
        Some(CustomScene { version: VERSION, name: None, body1: scene.body1, body2: scene.body2, bodies })
    }

    /// Returns all violations of the limits; none if the scene is allowed.
    pub fn limit_problems(&self) -> Vec<Problem> {
        let mut problems = Vec::new();
        let count = self.bodies.len();
        if !BODIES.contains(&count) {
            let (least, most) = BODIES.into_inner();
            let remedy = if count < least { "fewer: add some" } else { "more: remove some" };
            problems.push(Problem::of_scene(
                Fault::Bodies { count, least, most },
                format!("A scene has {least} to {most} bodies, and this one has {remedy}."),
            ));
        }
        if self.name.as_ref().is_some_and(|name| name.chars().count() > NAME_LENGTH) {
            problems.push(Problem::of_scene(
                Fault::Name { most: NAME_LENGTH },
                format!("The name is longer than {NAME_LENGTH} characters: shorten it."),
            ));
        }
        for (name, index) in [("body1", self.body1), ("body2", self.body2)] {
            if index >= count {
                problems.push(Problem::unreadable(format!(
                    "`{name}` is {index}, but there are {count} bodies, numbered from 0: choose one of them."
                )));
            }
        }
        if self.body1 == self.body2 {
            problems.push(Problem::of_scene(
                Fault::OwnGoal,
                "The green object cannot be its own goal: choose another body as the goal.",
            ));
        } else if self.bodies.get(self.body1).is_some_and(|body| !body.dynamic) {
            let why = "The green object is static, so it never reaches a goal: make it dynamic, or choose another.";
            problems.push(Problem::of_body(self.body1, Fault::StaticObject, why));
        }
        problems.extend((0..count).filter_map(|index| self.body_problem(index)));
        problems
    }

    /// Returns the scene to play. Its shapes are convex if `limit_problems` finds none.
    pub fn to_scene(&self) -> Scene {
        let bodies = (0..self.bodies.len()).map(|index| self.body(index)).collect();
        Scene { body1: self.body1, body2: self.body2, bodies }
    }

    /// Returns a description of a body with its index: "green ball (body 0)".
    pub fn body_name(&self, index: usize) -> String {
        format!("{} (body {index})", self.body(index).name())
    }

    fn body(&self, index: usize) -> Body {
        let CustomBody { dimensions, x, y, angle, dynamic } = self.bodies[index];
        let role = match (index == self.body1, index == self.body2, dynamic) {
            (true, ..) => Role::Green,
            (_, true, true) => Role::Blue,
            (_, true, false) => Role::Purple,
            (_, _, true) => Role::Gray,
            (_, _, false) => Role::Black,
        };
        Body { x, y, angle, dynamic, shape_type: dimensions.shape_type(), role, shapes: dimensions.shapes() }
    }

    /// Returns the first problem of a body on its own.
    fn body_problem(&self, index: usize) -> Option<Problem> {
        let CustomBody { dimensions, x, y, angle, dynamic } = self.bodies[index];
        let name = self.body_name(index);
        let problem = |fault, sentence: String| Some(Problem::of_body(index, fault, sentence));
        for (key, length, allowed) in dimensions.lengths() {
            if !allowed.contains(&length) {
                let (least, most) = allowed.into_inner();
                let remedy = if length > most { "smaller" } else { "larger" };
                return problem(
                    Fault::Length { key, length, least, most },
                    format!(
                        "The {key} of the {name} is {} px, but may be {least} to {most}: make it {remedy}.",
                        px(length)
                    ),
                );
            }
        }
        if !(x.is_finite() && y.is_finite() && (-TAU..=TAU).contains(&angle)) {
            return problem(
                Fault::Place,
                format!("The {name} has no valid place: x and y must be numbers, and the angle from -2π to 2π."),
            );
        }
        let [left, bottom, right, top] = self.body(index).bounds();
        if dynamic {
            let out = [-left, -bottom, right - SIZE, top - SIZE].into_iter().fold(0.0, f64::max);
            let over = over_a_corner(&self.body(index));
            let remedy = "move it inside or make it smaller";
            if out > MAX_OVERLAP {
                problem(
                    Fault::SticksOut { by: out },
                    format!("The {name} sticks out of the scene by {} px: {remedy}.", px(out)),
                )
            } else if over > OVER_CORNER {
                problem(
                    Fault::SticksOutOfCorner { by: over },
                    format!("The {name} sticks out of a corner of the scene by {} px: {remedy}.", px(over)),
                )
            } else {
                None
            }
        } else {
            let away = [-right, -top, left - SIZE, bottom - SIZE].into_iter().fold(0.0, f64::max);
            if away <= OUTSIDE {
                return None;
            }
            problem(
                Fault::Outside { by: away },
                format!("The {name} is {} px outside of the scene: move it nearer, or remove it.", px(away)),
            )
        }
    }
}

/// Returns how far a body reaches over the corners of the scene, along the diagonals, px; not positive if it does not.
fn over_a_corner(body: &Body) -> f64 {
    let diagonals = [[-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0], [1.0, 1.0]];
    let over = diagonals.map(|[x, y]: [f64; 2]| {
        let corner = SIZE * (x.max(0.0) + y.max(0.0));
        body.reach([x, y].map(|part| part * FRAC_1_SQRT_2)) - corner * FRAC_1_SQRT_2
    });
    over.into_iter().fold(f64::NEG_INFINITY, f64::max)
}

/// Formats a length for a sentence; one that is far too large as a power of ten.
fn px(length: f64) -> String {
    if length.abs() < 1e5 { format!("{length:.1}") } else { format!("{length:.0e}") }
}

#[cfg(test)]
mod tests {
    use serde_json::{Value, json};

    use super::*;
    use crate::puzzle::task::Task;
    use crate::puzzle::templates::TEMPLATES;

    pub(super) fn scene() -> Value {
        json!({"version": 1, "name": "Over the wall", "body1": 0, "body2": 1, "bodies": [
            {"shape": "ball", "radius": 12.5, "x": 60, "y": 200, "angle": 0, "dynamic": true},
            {"shape": "bar", "length": 80, "thickness": 5.12, "x": 200, "y": 2.56, "angle": 0, "dynamic": false},
        ]})
    }

    /// Returns the first problem of this scene with one value replaced.
    pub(super) fn problem(pointer: &str, value: Value) -> Problem {
        let mut scene = scene();
        *scene.pointer_mut(pointer).expect("a value of the scene") = value;
        let problems = CustomScene::read(scene).map_or_else(|problems| problems, |scene| scene.limit_problems());
        problems.into_iter().next().unwrap_or_else(|| panic!("{pointer} is not refused"))
    }

    /// Tasks in which balls overlap a wall too deeply for a custom scene.
    const IN_A_WALL: [&str; 3] = ["00019:598", "00019:606", "00019:726"];

    #[test]
    fn every_task_of_the_benchmark_comes_back_the_same_and_nearly_all_are_within_the_limits() {
        for task in TEMPLATES.into_iter().flat_map(Task::of) {
            let custom = CustomScene::of(&task.scene).unwrap_or_else(|| panic!("{} has another shape", task.id));
            let refused = IN_A_WALL.contains(&task.id.to_string().as_str());
            assert_eq!(!custom.limit_problems().is_empty(), refused, "{}: {:?}", task.id, custom.limit_problems());
            let read = CustomScene::read(serde_json::to_value(&custom).expect("plain data")).expect("a scene");
            assert_eq!(read.to_scene(), task.scene, "{}", task.id);
        }
    }

    #[test]
    fn a_scene_is_read_and_written_the_same() {
        let custom = CustomScene::read(scene()).expect("a scene");
        assert_eq!(custom.limit_problems(), []);
        assert_eq!(CustomScene::read(serde_json::to_value(&custom).expect("plain data")), Ok(custom));
    }

    #[test]
    fn a_problem_names_the_body_and_the_remedy() {
        let long = problem("/bodies/1/length", json!(513));
        assert_eq!(long.body, Some(1));
        assert_eq!(
            long.sentence,
            "The length of the purple bar (body 1) is 513.0 px, but may be 2 to 512: make it smaller."
        );
        let outside = problem("/bodies/0/x", json!(-2));
        assert_eq!(
            outside.sentence,
            "The green ball (body 0) sticks out of the scene by 14.5 px: move it inside or make it smaller."
        );
        let mut cornered = scene();
        (cornered["bodies"][0]["x"], cornered["bodies"][0]["y"]) = (json!(246.0), json!(246.0));
        assert_eq!(CustomScene::read(cornered.clone()).expect("a scene").limit_problems(), []);
        cornered["bodies"][0] =
            json!({"shape": "bar", "length": 40, "thickness": 2, "x": 243, "y": 243, "angle": 0.785, "dynamic": true});
        let problems = CustomScene::read(cornered).expect("a scene").limit_problems();
        assert_eq!(
            problems[0].sentence,
            "The green bar (body 0) sticks out of a corner of the scene by 1.6 px: move it inside or make it smaller."
        );
        assert_eq!(problem("/bodies/0/dynamic", json!(false)).body, Some(0));
        assert_eq!(problem("/bodies/1/y", json!(-200)).body, Some(1));
        assert_eq!(problem("/bodies/1/angle", json!(7)).body, Some(1));
    }
}

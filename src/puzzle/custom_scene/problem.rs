//! Problems of custom scenes, as sentences and as data for programs with their own wording.

use serde::Serialize;

/// A reason why a custom scene cannot be played.
#[derive(Clone, Debug, PartialEq, Serialize, thiserror::Error)]
#[error("{sentence}")]
pub struct Problem {
    /// The affected body, as an index into `bodies`; `None` if the problem concerns the whole scene.
    pub body: Option<usize>,
    /// The second body, if the problem concerns two.
    pub other: Option<usize>,
    /// What is wrong.
    pub fault: Fault,
    /// The problem and its remedy in words.
    pub sentence: String,
}

/// The kind of problem with a custom scene; lengths in px.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
#[allow(missing_docs, reason = "the values are named as in the sentences")]
pub enum Fault {
    /// It does not have the form of the schema.
    Unreadable,
    /// Too few bodies or too many.
    Bodies { count: usize, least: usize, most: usize },
    /// Its name is too long.
    Name { most: usize },
    /// The green object is its own goal.
    OwnGoal,
    /// The green object is static.
    StaticObject,
    /// A length of a body is too small or too large; `key` is that of the schema.
    Length { key: &'static str, length: f64, least: f64, most: f64 },
    /// The position or angle of a body is not a usable number.
    Place,
    /// A dynamic body sticks out of the scene.
    SticksOut { by: f64 },
    /// A dynamic body sticks out of a corner of the scene.
    SticksOutOfCorner { by: f64 },
    /// A static body is too far away.
    Outside { by: f64 },
    /// Two bodies overlap.
    Overlap { by: f64, most: f64 },
}

impl Problem {
    /// Returns a problem of the scene as a whole.
    pub fn of_scene(fault: Fault, sentence: impl Into<String>) -> Problem {
        Problem { body: None, other: None, fault, sentence: sentence.into() }
    }

    /// Returns the problem of something that does not have the form of a scene.
    pub fn unreadable(sentence: impl Into<String>) -> Problem {
        Problem::of_scene(Fault::Unreadable, sentence)
    }

    /// Returns a problem of a body.
    pub fn of_body(body: usize, fault: Fault, sentence: impl Into<String>) -> Problem {
        Problem { body: Some(body), ..Problem::of_scene(fault, sentence) }
    }
}

/// Joins the sentences of problems into one text.
pub fn sentences(problems: &[Problem]) -> String {
    problems.iter().map(|problem| problem.sentence.as_str()).collect::<Vec<_>>().join(" ")
}

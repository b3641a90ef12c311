//! The start of a rollout in text or JSON: a ball in px, an action, or no ball.
//!
//! An action's ball is rounded to whole px, so a ball in px must have whole numbers too.

use pathlight::puzzle::action::{Action, Ball, Invalid};
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::TaskId;
use serde::{Deserialize, Deserializer};
use serde_json::Value;

/// The start of a rollout.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start {
    /// A ball of whole px, or none.
    Ball(Option<Ball>),
    Action(Action),
}

impl Start {
    /// Returns the action, if the start is one.
    pub fn action(self) -> Option<Action> {
        match self {
            Start::Ball(_) => None,
            Start::Action(action) => Some(action),
        }
    }

    /// Returns the ball to simulate, if any. The simulator checks balls in px.
    ///
    /// # Errors
    ///
    /// The reason why the action is invalid in this scene.
    pub fn place(self, scene: &Scene) -> Result<Option<Ball>, Invalid> {
        match self {
            Start::Ball(ball) => Ok(ball),
            Start::Action(action) => action.place(scene).map(Some),
        }
    }
}

/// One line of a batch: a task or a custom scene, and its start. Other keys are ignored.
#[derive(Debug, Deserialize, PartialEq)]
#[serde(try_from = "Keys")]
pub struct Request {
    pub place: Place,
    pub start: Start,
}

/// The task or the scene in which a ball is placed.
#[derive(Debug, PartialEq)]
pub enum Place {
    Task(TaskId),
    /// A scene that has not been parsed.
    Scene(Value),
}

#[derive(Deserialize)]
struct Keys {
    task: Option<TaskId>,
    scene: Option<Value>,
    /// Null means no ball; a missing key does not.
    #[serde(default, deserialize_with = "present")]
    ball: Option<Option<Ball>>,
    action: Option<Action>,
}

fn present<'de, D: Deserializer<'de>>(value: D) -> Result<Option<Option<Ball>>, D::Error> {
    Option::deserialize(value).map(Some)
}

impl TryFrom<Keys> for Request {
    type Error = &'static str;

    fn try_from(Keys { task, scene, ball, action }: Keys) -> Result<Request, &'static str> {
        let place = match (task, scene) {
            (Some(task), None) => Place::Task(task),
            (None, Some(scene)) => Place::Scene(scene),
            (Some(_), Some(_)) => return Err("`task` and `scene` exclude each other: omit one"),
            (None, None) => return Err("`task` or `scene` is missing"),
        };
        let start = match (ball, action) {
            (Some(ball), None) => Start::Ball(ball.map(whole).transpose()?),
            (None, Some(action)) => Start::Action(action),
            (Some(_), Some(_)) => return Err("`ball` and `action` exclude each other: omit one"),
            (None, None) => return Err("`ball` or `action` is missing; \"ball\":null simulates without a ball"),
        };
        Ok(Request { place, start })
    }
}

/// Refuses a ball that is not in whole px.
fn whole(ball: Ball) -> Result<Ball, &'static str> {
    // The cast saturates and drops fractions, so a number that it changes is not a whole number of px.
    if <[f64; 3]>::from(ball).iter().all(|&number| f64::from(number as i32) == number) {
        Ok(ball)
    } else {
        Err("a ball is three whole numbers of px, like 128,200,15; an action takes fractions")
    }
}

/// Parses `x,y,r` of an action.
pub fn parse_action(text: &str) -> Result<Action, &'static str> {
    three_numbers(text).map(Action::from).ok_or("an action is three numbers from 0 to 1, like 0.5,0.8,0.4")
}

/// Parses `X,Y,R` of a ball.
pub fn parse_ball(text: &str) -> Result<Ball, &'static str> {
    three_numbers(text).map(Ball::from).ok_or("a ball is three whole numbers of px, like 128,200,15").and_then(whole)
}

fn three_numbers(text: &str) -> Option<[f64; 3]> {
    let finite = |number: &str| number.trim().parse().ok().filter(|number: &f64| number.is_finite());
    text.split(',').map(finite).collect::<Option<Vec<f64>>>()?.try_into().ok()
}

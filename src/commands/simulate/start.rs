//! How a rollout starts, as a person or a program writes it: with a ball in px, with an action, or with no ball.
//!
//! A ball in px is what an action has become after rounding, so its three numbers are whole.

use pathlight::puzzle::action::{Action, Ball, Invalid};
use pathlight::puzzle::scene::Scene;
use pathlight::puzzle::task::TaskId;
use serde::{Deserialize, Deserializer, Serialize};

/// A ball: x, y and radius, whole numbers of px.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "[f64; 3]")]
pub struct Pixels([i32; 3]);

/// What to begin with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Start {
    Ball(Option<Pixels>),
    Action(Action),
}

impl Start {
    /// The ball to simulate, if any.
    ///
    /// # Errors
    /// Says why the action is invalid in this scene. A ball in px is left for the simulator to judge.
    pub fn place(self, scene: &Scene) -> Result<Option<Pixels>, Invalid> {
        match self {
            Start::Ball(ball) => Ok(ball),
            Start::Action(action) => action.place(scene).map(|ball| {
                let whole = <[f64; 3]>::from(ball);
                Some(Pixels::try_from(whole).expect("an action places a ball of whole px"))
            }),
        }
    }
}

/// One line of a batch: a task and its start. Other keys are left alone.
#[derive(Debug, Deserialize, PartialEq)]
#[serde(try_from = "Keys")]
pub struct Request {
    pub task: TaskId,
    pub start: Start,
}

#[derive(Deserialize)]
struct Keys {
    task: TaskId,
    /// Null means no ball, which is not the same as no key.
    #[serde(default, deserialize_with = "present")]
    ball: Option<Option<Pixels>>,
    action: Option<Action>,
}

fn present<'de, D: Deserializer<'de>>(value: D) -> Result<Option<Option<Pixels>>, D::Error> {
    Option::deserialize(value).map(Some)
}

impl TryFrom<Keys> for Request {
    type Error = &'static str;

    fn try_from(Keys { task, ball, action }: Keys) -> Result<Request, &'static str> {
        let start = match (ball, action) {
            (Some(ball), None) => Start::Ball(ball),
            (None, Some(action)) => Start::Action(action),
            (Some(_), Some(_)) => return Err("give either `ball` or `action`, not both"),
            (None, None) => return Err("`ball` or `action` is missing; \"ball\":null simulates with no ball"),
        };
        Ok(Request { task, start })
    }
}

impl TryFrom<[f64; 3]> for Pixels {
    type Error = &'static str;

    fn try_from(numbers: [f64; 3]) -> Result<Pixels, &'static str> {
        // The cast saturates and drops fractions: whatever it changes is no whole number of px.
        let whole = numbers.map(|number| number as i32);
        if whole.map(f64::from) == numbers {
            Ok(Pixels(whole))
        } else {
            Err("a ball is three whole numbers of px, like 128,200,15; an action takes fractions")
        }
    }
}

impl From<Pixels> for Ball {
    fn from(Pixels(numbers): Pixels) -> Ball {
        numbers.map(f64::from).into()
    }
}

/// `x,y,r` of an action.
pub fn parse_action(text: &str) -> Result<Action, &'static str> {
    three_numbers(text).map(Action::from).ok_or("an action is three numbers in 0..1, like 0.5,0.8,0.4")
}

/// `X,Y,R` of a ball.
pub fn parse_ball(text: &str) -> Result<Pixels, &'static str> {
    three_numbers(text).ok_or("a ball is three whole numbers of px, like 128,200,15").and_then(Pixels::try_from)
}

fn three_numbers(text: &str) -> Option<[f64; 3]> {
    let numbers: Vec<f64> = text.split(',').map(|number| number.trim().parse().ok()).collect::<Option<_>>()?;
    numbers.try_into().ok()
}

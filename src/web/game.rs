//! One puzzle on the page: a task and the game on it. The page checks balls here and makes attempts; `game_view` is
//! the other half, which replays, compares and draws them.

use serde::Serialize;
use wasm_bindgen::prelude::*;

use super::describe::{about, invalid_reason};
use super::error::{Code, error, from_js, to_js, whole_number};
use super::paint::LineStyle;
use super::puzzle_from_js::{load, written};
use super::recording::Recording;
use crate::puzzle::action::{Ball, Invalid, Obstacles};
use crate::puzzle::nearest_place::nearest_place;
use crate::puzzle::scene::Body;
use crate::raster::trail_image;
use crate::session::game::{self, Attempt, Author, Refused};
use crate::session::puzzle::Puzzle;

/// How far the centre of an invalid ball may be from the place that it goes to instead, px.
const REACH: f64 = 64.0;

/// A puzzle on the page: the attempts of player and model, and what is drawn of them.
#[wasm_bindgen]
pub struct Game {
    pub(super) puzzle: Puzzle,
    pub(super) game: game::Game,
    /// The current recordings: none, one, or two over each other.
    pub(super) recordings: Vec<Recording>,
}

/// An attempt as the page lists it.
#[derive(Serialize)]
pub(super) struct ListedAttempt {
    /// From 1.
    number: usize,
    #[serde(flatten)]
    attempt: Attempt,
}

impl ListedAttempt {
    pub(super) fn new(number: usize, attempt: Attempt) -> ListedAttempt {
        ListedAttempt { number, attempt }
    }
}

/// Why a ball on the page is invalid; the page has the words.
#[derive(Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub(super) enum InvalidBall {
    Radius,
    Outside,
    /// The index of a body of the scene.
    Overlaps {
        body: usize,
    },
}

impl InvalidBall {
    pub(super) fn of(why: Invalid) -> InvalidBall {
        match why {
            Invalid::Radius => InvalidBall::Radius,
            Invalid::Overlaps(body) => InvalidBall::Overlaps { body },
            // A puzzle's scene can always be simulated, so these all mean that the ball is outside it.
            Invalid::Outside | Invalid::OutOfRange | Invalid::Scene(_) => InvalidBall::Outside,
        }
    }
}

#[wasm_bindgen]
impl Game {
    /// Opens a task by its id, or a custom scene.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played.
    #[wasm_bindgen(constructor)]
    pub fn new(#[wasm_bindgen(unchecked_param_type = "Puzzle")] puzzle: JsValue) -> Result<Game, JsValue> {
        let puzzle = load(puzzle)?;
        let game = game::Game::new(puzzle.scene.clone());
        Ok(Game { puzzle, game, recordings: Vec::new() })
    }

    /// Returns what the puzzle is.
    #[wasm_bindgen(unchecked_return_type = "About")]
    pub fn about(&self) -> Result<JsValue, JsValue> {
        about(&self.puzzle)
    }

    /// Returns why a ball is invalid; undefined if it is valid.
    #[wasm_bindgen(js_name = whyInvalid, unchecked_return_type = "InvalidBall | undefined")]
    pub fn why_invalid(&self, x: f64, y: f64, r: f64) -> Result<JsValue, JsValue> {
        match (Ball { x, y, r }).check(&self.puzzle.scene) {
            Ok(()) => Ok(JsValue::UNDEFINED),
            Err(why) => to_js(&InvalidBall::of(why)),
        }
    }

    /// Returns the nearest valid ball of the same radius, if one is not far away.
    #[wasm_bindgen(js_name = nearestPlace, unchecked_return_type = "Ball | undefined")]
    pub fn nearest_place(&self, x: f64, y: f64, r: f64) -> Option<Vec<f64>> {
        let place = nearest_place(Ball { x, y, r }, &Obstacles::new(&self.puzzle.scene), REACH)?;
        Some(<[f64; 3]>::from(place).to_vec())
    }

    /// Makes an attempt of the player's, shows its rollout and returns it.
    ///
    /// # Errors
    /// `invalid_ball`, or `attempt_limit` if all attempts are used.
    #[wasm_bindgen(unchecked_return_type = "ListedAttempt")]
    pub fn attempt(&mut self, x: f64, y: f64, r: f64) -> Result<JsValue, JsValue> {
        let ball = Ball { x, y, r };
        let (number, rollout) = self.game.play(Author::Player, ball).map_err(|why| self.refusal(why))?;
        let rollout = rollout.into();
        self.recordings = vec![Recording { ball: Some(ball), rollout, line_style: LineStyle::Solid, of_model: false }];
        to_js(&ListedAttempt::new(number, self.game.attempts(Author::Player)[number - 1]))
    }

    /// Returns what a person has drawn as the path of the green object (x, y, x, y, … in px) as a mask of its path.
    #[wasm_bindgen(js_name = sketchMask)]
    pub fn sketch_mask(&self, points: &[f64]) -> Vec<f32> {
        let points: Vec<[f64; 2]> = points.chunks_exact(2).map(|point| [point[0], point[1]]).collect();
        trail_image(self.object(), &points).to_f32().collect()
    }

    /// Returns the position of the green object at the start, px.
    #[wasm_bindgen(js_name = objectStart, unchecked_return_type = "[x: number, y: number]")]
    pub fn object_start(&self) -> Vec<f64> {
        vec![self.object().x, self.object().y]
    }

    /// Adds an attempt of the model's that the worker simulated, and returns it.
    ///
    /// # Errors
    /// `invalid_ball`, or `attempt_limit` if all attempts are used.
    #[wasm_bindgen(js_name = addModelAttempt, unchecked_return_type = "ListedAttempt")]
    pub fn add_model_attempt(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Attempt")] attempt: JsValue,
    ) -> Result<JsValue, JsValue> {
        let attempt: Attempt = from_js(attempt)?;
        let number = self.game.record(Author::Model, attempt).map_err(|why| self.refusal(why))?;
        to_js(&ListedAttempt::new(number, attempt))
    }

    /// Returns all attempts of an author.
    #[wasm_bindgen(unchecked_return_type = "ListedAttempt[]")]
    pub fn attempts(&self, #[wasm_bindgen(unchecked_param_type = "Author")] who: &str) -> Result<JsValue, JsValue> {
        let attempts = self.game.attempts(author_named(who)?);
        let listed = attempts.iter().enumerate().map(|(index, &attempt)| ListedAttempt::new(index + 1, attempt));
        to_js(&listed.collect::<Vec<_>>())
    }

    /// Returns the number of attempts of an author and which of them solved the puzzle.
    #[wasm_bindgen(unchecked_return_type = "Standing")]
    pub fn standing(&self, #[wasm_bindgen(unchecked_param_type = "Author")] who: &str) -> Result<JsValue, JsValue> {
        to_js(&self.game.standing(author_named(who)?))
    }

    /// Removes one attempt of an author's; the numbers of later ones decrease by one.
    ///
    /// # Errors
    /// `no_attempt` if the author has made fewer.
    pub fn remove(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Author")] who: &str,
        #[wasm_bindgen(unchecked_param_type = "number")] number: &JsValue,
    ) -> Result<(), JsValue> {
        let who = author_named(who)?;
        let is_removed = attempt_number(number).is_some_and(|number| self.game.remove(who, number));
        if is_removed { Ok(()) } else { Err(no_attempt(number)) }
    }

    /// Removes all attempts of an author.
    pub fn clear(&mut self, #[wasm_bindgen(unchecked_param_type = "Author")] who: &str) -> Result<(), JsValue> {
        self.game.clear(author_named(who)?);
        Ok(())
    }
}

impl Game {
    fn object(&self) -> &Body {
        &self.puzzle.scene.bodies[self.puzzle.scene.body1]
    }

    /// Returns the error for a refused attempt.
    pub(super) fn refusal(&self, why: Refused) -> JsValue {
        match why {
            Refused::Invalid(why) => error(Code::InvalidBall, invalid_reason(why, &self.puzzle.scene)),
            Refused::AttemptLimit => error(Code::AttemptLimit, why),
        }
    }
}

/// Returns the number of an attempt; `None` if it cannot be one. It comes as JavaScript's value, because wasm-bindgen
/// would wrap or truncate others.
pub(super) fn attempt_number(value: &JsValue) -> Option<usize> {
    whole_number(value, 1..=u32::MAX, "").ok().map(|number| number as usize)
}

pub(super) fn no_attempt(number: &JsValue) -> JsValue {
    error(Code::NoAttempt, format!("there is no attempt {}: attempts are numbered from 1", written(number)))
}

pub(super) fn author_named(name: &str) -> Result<Author, JsValue> {
    match name {
        "player" => Ok(Author::Player),
        "model" => Ok(Author::Model),
        _ => Err(error(Code::BadData, format!("there is no author `{name}`: use player or model"))),
    }
}

//! One puzzle on the page: a task and the game on it. The page checks balls here and makes attempts; `game_view` is
//! the other half, which replays, compares and draws them.

use serde::Serialize;
use wasm_bindgen::prelude::*;

use super::describe::{describe_scene, invalid_reason};
use super::error::{Code, error, from_js, to_js};
use super::paint::LineStyle;
use super::puzzle_from_js::load;
use super::recording::Recording;
use crate::puzzle::action::{Ball, Obstacles};
use crate::puzzle::nearest_place::nearest_place;
use crate::puzzle::scene::Body;
use crate::puzzle::templates::TEMPLATES;
use crate::raster::trail_image;
use crate::session::game::{self, Attempt, Author, Refused};
use crate::session::puzzle::Puzzle;

/// The name of a custom scene that has none.
const CUSTOM_NAME: &str = "Custom scene";

/// What is said of a custom scene where a task has its story.
const CUSTOM_STORY: &str = "A person made this scene. It is none of the benchmark's tasks.";

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
    words: String,
    #[serde(flatten)]
    attempt: Attempt,
}

impl ListedAttempt {
    pub(super) fn new(number: usize, attempt: Attempt) -> ListedAttempt {
        ListedAttempt { number, words: attempt.ending.to_string(), attempt }
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

    /// Returns the name of the puzzle, its goal and a description of its scene.
    #[wasm_bindgen(unchecked_return_type = "About")]
    pub fn about(&self) -> Result<JsValue, JsValue> {
        #[derive(Serialize)]
        struct About<'a> {
            /// Null for a custom scene.
            id: Option<String>,
            name: &'a str,
            story: &'a str,
            goal: &'a str,
            description: String,
        }
        let id = self.puzzle.id.task();
        let (name, story) = match id.map(|task| TEMPLATES[task.template]) {
            Some(template) => (template.name, template.story),
            None => (self.puzzle.name().unwrap_or(CUSTOM_NAME), CUSTOM_STORY),
        };
        to_js(&About {
            id: id.map(String::from),
            name,
            story,
            goal: &self.puzzle.goal,
            description: describe_scene(&self.puzzle.scene),
        })
    }

    /// Returns why a ball is invalid, as a phrase; undefined if it is valid.
    #[wasm_bindgen(js_name = whyInvalid)]
    pub fn why_invalid(&self, x: f64, y: f64, r: f64) -> Option<String> {
        Ball { x, y, r }.check(&self.puzzle.scene).err().map(|why| invalid_reason(why, &self.puzzle.scene))
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
        self.recordings = vec![Recording { ball: Some(ball), rollout, line_style: LineStyle::Solid }];
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

    /// Returns a comparison of player and model in a sentence.
    pub fn verdict(&self) -> String {
        self.game.verdict()
    }

    /// Removes one attempt of an author's; the numbers of later ones decrease by one.
    ///
    /// # Errors
    /// `no_attempt` if the author has made fewer.
    pub fn remove(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Author")] who: &str,
        number: usize,
    ) -> Result<(), JsValue> {
        if self.game.remove(author_named(who)?, number) { Ok(()) } else { Err(no_attempt(number)) }
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

pub(super) fn no_attempt(number: usize) -> JsValue {
    error(Code::NoAttempt, format!("there is no attempt {number}"))
}

pub(super) fn author_named(name: &str) -> Result<Author, JsValue> {
    match name {
        "player" => Ok(Author::Player),
        "model" => Ok(Author::Model),
        _ => Err(error(Code::BadData, format!("there is no author `{name}`: use player or model"))),
    }
}

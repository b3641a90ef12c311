//! One puzzle on the page: a task and the game on it. The page checks balls here and makes attempts; `puzzle_view` is
//! the other half, which replays, compares and draws them.

use serde::Serialize;
use wasm_bindgen::prelude::*;

use super::describe::{describe_scene, invalid_reason};
use super::error::{Code, error, from_js, to_js};
use super::paint::LineStyle;
use super::played::load;
use super::recording::Recording;
use crate::puzzle::action::Ball;
use crate::puzzle::scene::Body;
use crate::puzzle::templates::TEMPLATES;
use crate::raster::trail_image;
use crate::session::game::{Attempt, Contender, Game, Refused};
use crate::session::played::Played;

/// The name of an own scene that has none.
const OWN_NAME: &str = "Own scene";

/// What is said of an own scene where a task has its story.
const OWN_STORY: &str = "A person made this scene. It is none of the benchmark's tasks.";

#[wasm_bindgen]
pub struct Puzzle {
    pub(super) played: Played,
    pub(super) game: Game,
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
impl Puzzle {
    /// Opens a task by its id, or an own scene.
    ///
    /// # Errors
    /// `bad_task` if there is no such task, `bad_scene` if the scene may not be played.
    #[wasm_bindgen(constructor)]
    pub fn new(#[wasm_bindgen(unchecked_param_type = "Played")] played: JsValue) -> Result<Puzzle, JsValue> {
        let played = load(played)?;
        let game = Game::new(played.scene.clone());
        Ok(Puzzle { played, game, recordings: Vec::new() })
    }

    /// Returns the name of the puzzle, its goal and a description of its scene.
    #[wasm_bindgen(unchecked_return_type = "About")]
    pub fn about(&self) -> Result<JsValue, JsValue> {
        #[derive(Serialize)]
        struct About<'a> {
            /// Null for an own scene.
            id: Option<String>,
            name: &'a str,
            story: &'a str,
            goal: &'a str,
            description: String,
        }
        let id = self.played.id.task();
        let (name, story) = match id.map(|task| TEMPLATES[task.template]) {
            Some(template) => (template.name, template.story),
            None => (self.played.name().unwrap_or(OWN_NAME), OWN_STORY),
        };
        to_js(&About {
            id: id.map(String::from),
            name,
            story,
            goal: &self.played.goal,
            description: describe_scene(&self.played.scene),
        })
    }

    /// Returns why a ball is invalid, as a phrase; undefined if it is valid.
    #[wasm_bindgen(js_name = whyInvalid)]
    pub fn why_invalid(&self, x: f64, y: f64, r: f64) -> Option<String> {
        Ball { x, y, r }.check(&self.played.scene).err().map(|why| invalid_reason(why, &self.played.scene))
    }

    /// Makes an attempt of the player's, shows its rollout and returns it.
    ///
    /// # Errors
    /// `invalid_ball`, or `attempt_limit` if all attempts are used.
    #[wasm_bindgen(unchecked_return_type = "ListedAttempt")]
    pub fn attempt(&mut self, x: f64, y: f64, r: f64) -> Result<JsValue, JsValue> {
        let ball = Ball { x, y, r };
        let (number, rollout) = self.game.play(Contender::Player, ball).map_err(|why| self.refusal(why))?;
        self.recordings = vec![Recording { ball: Some(ball), rollout, line_style: LineStyle::Solid }];
        to_js(&ListedAttempt::new(number, self.game.attempts(Contender::Player)[number - 1]))
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
        let number = self.game.record(Contender::Model, attempt).map_err(|why| self.refusal(why))?;
        to_js(&ListedAttempt::new(number, attempt))
    }

    /// Returns all attempts of a contender.
    #[wasm_bindgen(unchecked_return_type = "ListedAttempt[]")]
    pub fn attempts(&self, #[wasm_bindgen(unchecked_param_type = "Contender")] who: &str) -> Result<JsValue, JsValue> {
        let attempts = self.game.attempts(contender_named(who)?);
        let listed = attempts.iter().enumerate().map(|(index, &attempt)| ListedAttempt::new(index + 1, attempt));
        to_js(&listed.collect::<Vec<_>>())
    }

    /// Returns the number of attempts of a contender and which of them solved the puzzle.
    #[wasm_bindgen(unchecked_return_type = "Standing")]
    pub fn standing(&self, #[wasm_bindgen(unchecked_param_type = "Contender")] who: &str) -> Result<JsValue, JsValue> {
        to_js(&self.game.standing(contender_named(who)?))
    }

    /// Returns a comparison of player and model in a sentence.
    pub fn verdict(&self) -> String {
        self.game.verdict()
    }

    /// Removes one attempt of a contender's; the numbers of later ones decrease by one.
    ///
    /// # Errors
    /// `no_attempt` if the contender has made fewer.
    pub fn remove(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Contender")] who: &str,
        number: usize,
    ) -> Result<(), JsValue> {
        if self.game.remove(contender_named(who)?, number) { Ok(()) } else { Err(no_attempt(number)) }
    }

    /// Removes all attempts of a contender.
    pub fn clear(&mut self, #[wasm_bindgen(unchecked_param_type = "Contender")] who: &str) -> Result<(), JsValue> {
        self.game.clear(contender_named(who)?);
        Ok(())
    }
}

impl Puzzle {
    fn object(&self) -> &Body {
        &self.played.scene.bodies[self.played.scene.body1]
    }

    /// Returns the error for a refused attempt.
    pub(super) fn refusal(&self, why: Refused) -> JsValue {
        match why {
            Refused::Invalid(why) => error(Code::InvalidBall, invalid_reason(why, &self.played.scene)),
            Refused::AttemptLimit => error(Code::AttemptLimit, why),
        }
    }
}

pub(super) fn no_attempt(number: usize) -> JsValue {
    error(Code::NoAttempt, format!("there is no attempt {number}"))
}

pub(super) fn contender_named(name: &str) -> Result<Contender, JsValue> {
    match name {
        "player" => Ok(Contender::Player),
        "model" => Ok(Contender::Model),
        _ => Err(error(Code::BadData, format!("there is no contender `{name}`: use player or model"))),
    }
}

//! One puzzle on the page: a task, the game on it, and the rollouts that are shown.
//!
//! The page checks balls here, makes, replays and compares attempts, and draws every frame. Only the scene is shown until an
//! attempt, a replay, a comparison or the scene alone runs.

use serde::Serialize;
use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use super::describe::{describe_scene, invalid_reason};
use super::error::{Code, error, from_js, to_js};
use super::frame::{self, View};
use super::paint::LineStyle;
use super::recording::Recording;
use crate::play::ending::Ending;
use crate::play::game::{Attempt, Contender, Game, Refused};
use crate::puzzle::action::Ball;
use crate::puzzle::scene::Body;
use crate::puzzle::task::Task;
use crate::puzzle::templates::TEMPLATES;
use crate::raster::trail_image;
use crate::simulator::simulate;

#[wasm_bindgen]
pub struct Puzzle {
    task: Task,
    game: Game,
    /// What is shown: nothing, one rollout, or two over each other.
    recordings: Vec<Recording>,
}

/// An attempt as the page lists it.
#[derive(Serialize)]
struct ListedAttempt {
    /// From 1.
    number: usize,
    words: String,
    #[serde(flatten)]
    attempt: Attempt,
}

impl ListedAttempt {
    fn new(number: usize, attempt: Attempt) -> ListedAttempt {
        ListedAttempt { number, words: attempt.ending.to_string(), attempt }
    }
}

#[wasm_bindgen]
impl Puzzle {
    /// Opens a task by its id.
    ///
    /// # Errors
    /// `bad_task` if there is no such task.
    #[wasm_bindgen(constructor)]
    pub fn new(id: &str) -> Result<Puzzle, JsValue> {
        let task = super::load(id)?;
        let game = Game::new(task.scene.clone());
        Ok(Puzzle { task, game, recordings: Vec::new() })
    }

    /// Returns the name of the puzzle, its goal and a description of its scene.
    #[wasm_bindgen(unchecked_return_type = "About")]
    pub fn about(&self) -> Result<JsValue, JsValue> {
        #[derive(Serialize)]
        struct About<'a> {
            id: String,
            name: &'a str,
            story: &'a str,
            goal: &'a str,
            description: String,
        }
        let template = TEMPLATES[self.task.id.template];
        to_js(&About {
            id: self.task.id.to_string(),
            name: template.name,
            story: template.story,
            goal: &self.task.goal,
            description: describe_scene(&self.task.scene),
        })
    }

    /// Returns why a ball is invalid, as a phrase; undefined if it is valid.
    #[wasm_bindgen(js_name = whyInvalid)]
    pub fn why_invalid(&self, x: f64, y: f64, r: f64) -> Option<String> {
        Ball { x, y, r }.check(&self.task.scene).err().map(|why| invalid_reason(why, &self.task.scene))
    }

    /// Makes an attempt of the player's, shows its rollout and returns it.
    ///
    /// # Errors
    /// `invalid_ball`, or `spent` if all attempts are used.
    #[wasm_bindgen(unchecked_return_type = "ListedAttempt")]
    pub fn attempt(&mut self, x: f64, y: f64, r: f64) -> Result<JsValue, JsValue> {
        let ball = Ball { x, y, r };
        let (number, rollout) = self.game.play(Contender::Player, ball).map_err(|why| self.refusal(why))?;
        self.recordings =
            vec![Recording { attempt: Some((Contender::Player, ball)), rollout, line_style: LineStyle::Solid }];
        to_js(&ListedAttempt::new(number, self.game.attempts(Contender::Player)[number - 1]))
    }

    /// Shows the scene running without a ball.
    pub fn watch(&mut self) -> Result<(), JsValue> {
        let rollout = simulate(&self.task.scene, None).map_err(|why| self.refusal(why.into()))?;
        self.recordings = vec![Recording { attempt: None, rollout, line_style: LineStyle::Solid }];
        Ok(())
    }

    /// Shows an attempt again and returns it.
    ///
    /// # Errors
    /// `no_attempt` if the agent has made fewer.
    #[wasm_bindgen(unchecked_return_type = "ListedAttempt")]
    pub fn replay(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Contender")] agent: &str,
        number: usize,
    ) -> Result<JsValue, JsValue> {
        let (recording, listed) = self.simulate_again(agent, number)?;
        self.recordings = vec![recording];
        to_js(&listed)
    }

    /// Shows two attempts over each other, the second with dashed lines, and returns both.
    ///
    /// # Errors
    /// `no_attempt` if an agent has made fewer.
    #[wasm_bindgen(unchecked_return_type = "[ListedAttempt, ListedAttempt]")]
    pub fn overlay(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Contender")] first_agent: &str,
        first_number: usize,
        #[wasm_bindgen(unchecked_param_type = "Contender")] second_agent: &str,
        second_number: usize,
    ) -> Result<JsValue, JsValue> {
        let (first, first_listed) = self.simulate_again(first_agent, first_number)?;
        let (second, second_listed) = self.simulate_again(second_agent, second_number)?;
        self.recordings = vec![
            Recording { line_style: LineStyle::Solid, ..first },
            Recording { line_style: LineStyle::Dashed, ..second },
        ];
        to_js(&[first_listed, second_listed])
    }

    /// Shows a ball of the model's without counting an attempt; the number of the attempt that it returns is 0.
    ///
    /// # Errors
    /// `invalid_ball`.
    #[wasm_bindgen(unchecked_return_type = "ListedAttempt")]
    pub fn rehearse(&mut self, x: f64, y: f64, r: f64) -> Result<JsValue, JsValue> {
        let ball = Ball { x, y, r };
        let rollout = simulate(&self.task.scene, Some(ball)).map_err(|why| self.refusal(why.into()))?;
        let attempt = Attempt { ball, ending: Ending::of(&rollout) };
        self.recordings =
            vec![Recording { attempt: Some((Contender::Model, ball)), rollout, line_style: LineStyle::Dashed }];
        to_js(&ListedAttempt::new(0, attempt))
    }

    /// Returns the real paths of each rollout that is shown, as masks of 64 x 64 zeros and ones, row 0 at the bottom.
    #[wasm_bindgen(unchecked_return_type = "PathMasks[]")]
    pub fn paths(&self) -> Result<js_sys::Array, JsValue> {
        self.recordings.iter().map(|recording| recording.path_masks(&self.task.scene)).collect()
    }

    /// Returns what a person has drawn as the path of the green object (x, y, x, y, … in px) as a mask of its path.
    pub fn sketch(&self, points: &[f64]) -> Vec<f32> {
        let points: Vec<[f64; 2]> = points.chunks_exact(2).map(|point| [point[0], point[1]]).collect();
        trail_image(self.object(), &points).to_f32().collect()
    }

    /// Returns the position of the green object at the start, px.
    #[wasm_bindgen(unchecked_return_type = "[x: number, y: number]")]
    pub fn start(&self) -> Vec<f64> {
        vec![self.object().x, self.object().y]
    }

    /// Shows the best attempts of player and model over each other and returns both; null for an agent without attempts.
    #[wasm_bindgen(unchecked_return_type = "[player: ListedAttempt | null, model: ListedAttempt | null]")]
    pub fn compare(&mut self) -> Result<JsValue, JsValue> {
        let best = [Contender::Player, Contender::Model].map(|agent| (agent, self.game.best(agent)));
        let recordings =
            best.iter().filter_map(|&(agent, best)| best.map(|(_, attempt)| self.record_again(agent, attempt)));
        self.recordings = recordings.collect::<Result<_, _>>()?;
        to_js(&best.map(|(_, best)| best.map(|(number, attempt)| ListedAttempt::new(number, attempt))))
    }

    /// Shows only the scene again.
    pub fn reset(&mut self) {
        self.recordings.clear();
    }

    /// Adds an attempt of the model's that the worker simulated, and returns it.
    ///
    /// # Errors
    /// `invalid_ball`, or `spent` if all attempts are used.
    #[wasm_bindgen(unchecked_return_type = "ListedAttempt")]
    pub fn record(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Attempt")] attempt: JsValue,
    ) -> Result<JsValue, JsValue> {
        let attempt: Attempt = from_js(attempt)?;
        let number = self.game.record(Contender::Model, attempt).map_err(|why| self.refusal(why))?;
        to_js(&ListedAttempt::new(number, attempt))
    }

    /// Returns all attempts of an agent.
    #[wasm_bindgen(unchecked_return_type = "ListedAttempt[]")]
    pub fn attempts(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Contender")] agent: &str,
    ) -> Result<JsValue, JsValue> {
        let attempts = self.game.attempts(agent_named(agent)?);
        let listed = attempts.iter().enumerate().map(|(index, &attempt)| ListedAttempt::new(index + 1, attempt));
        to_js(&listed.collect::<Vec<_>>())
    }

    /// Returns the number of attempts of an agent and which of them solved the puzzle.
    #[wasm_bindgen(unchecked_return_type = "Standing")]
    pub fn score(&self, #[wasm_bindgen(unchecked_param_type = "Contender")] agent: &str) -> Result<JsValue, JsValue> {
        to_js(&self.game.standing(agent_named(agent)?))
    }

    /// Returns a comparison of player and model in a sentence.
    pub fn verdict(&self) -> String {
        self.game.verdict()
    }

    /// Removes one attempt of an agent's; the numbers of later ones decrease by one.
    ///
    /// # Errors
    /// `no_attempt` if the agent has made fewer.
    pub fn remove(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Contender")] agent: &str,
        number: usize,
    ) -> Result<(), JsValue> {
        if self.game.remove(agent_named(agent)?, number) { Ok(()) } else { Err(no_attempt(number)) }
    }

    /// Removes all attempts of an agent.
    pub fn clear(&mut self, #[wasm_bindgen(unchecked_param_type = "Contender")] agent: &str) -> Result<(), JsValue> {
        self.game.clear(agent_named(agent)?);
        Ok(())
    }

    /// Returns the last step of what is shown; 0 if only the scene is.
    pub fn steps(&self) -> usize {
        self.recordings.iter().map(|recording| recording.rollout.steps).max().unwrap_or(0)
    }

    /// Returns the intervals in which the green object touches the goal in the first rollout that is shown.
    #[wasm_bindgen(unchecked_return_type = "[first: number, last: number][]")]
    pub fn touches(&self) -> Result<JsValue, JsValue> {
        to_js(&self.recordings.first().map(Recording::touches).unwrap_or_default())
    }

    /// Draws a frame into a square canvas: the scene, the maps over it, then paths, balls and the ring.
    ///
    /// # Errors
    /// `bad_data` if the view does not have the agreed form.
    pub fn paint(
        &self,
        context: &CanvasRenderingContext2d,
        #[wasm_bindgen(unchecked_param_type = "View")] view: JsValue,
        maps: Vec<HtmlCanvasElement>,
    ) -> Result<(), JsValue> {
        frame::paint(context, &self.task.scene, &self.recordings, &from_js(view)?, &maps)
    }

    /// Draws the scene into a square canvas.
    #[wasm_bindgen(js_name = paintThumbnail)]
    pub fn paint_thumbnail(&self, context: &CanvasRenderingContext2d, dark: bool) -> Result<(), JsValue> {
        super::paint_scene(context, &self.task.scene, dark)
    }

    /// Draws the end of an attempt, with its whole paths, into a square canvas.
    ///
    /// # Errors
    /// `no_attempt` if the agent has made fewer.
    #[wasm_bindgen(js_name = paintAttempt)]
    pub fn paint_attempt(
        &self,
        context: &CanvasRenderingContext2d,
        #[wasm_bindgen(unchecked_param_type = "Contender")] agent: &str,
        number: usize,
        dark: bool,
    ) -> Result<(), JsValue> {
        let (recording, _) = self.simulate_again(agent, number)?;
        frame::paint(context, &self.task.scene, &[recording], &View::ended(dark), &[])
    }
}

impl Puzzle {
    fn object(&self) -> &Body {
        &self.task.scene.bodies[self.task.scene.body1]
    }

    fn record_again(&self, agent: Contender, attempt: Attempt) -> Result<Recording, JsValue> {
        let rollout = simulate(&self.task.scene, Some(attempt.ball)).map_err(|why| self.refusal(why.into()))?;
        let line_style = if agent == Contender::Model { LineStyle::Dashed } else { LineStyle::Solid };
        Ok(Recording { attempt: Some((agent, attempt.ball)), rollout, line_style })
    }

    /// Simulates an earlier attempt once more.
    fn simulate_again(&self, agent: &str, number: usize) -> Result<(Recording, ListedAttempt), JsValue> {
        let agent = agent_named(agent)?;
        let attempt = number.checked_sub(1).and_then(|index| self.game.attempts(agent).get(index).copied());
        let attempt = attempt.ok_or_else(|| no_attempt(number))?;
        Ok((self.record_again(agent, attempt)?, ListedAttempt::new(number, attempt)))
    }

    fn refusal(&self, why: Refused) -> JsValue {
        match why {
            Refused::Invalid(why) => error(Code::InvalidBall, invalid_reason(why, &self.task.scene)),
            Refused::AttemptLimit => error(Code::Spent, why),
        }
    }
}

fn no_attempt(number: usize) -> JsValue {
    error(Code::NoAttempt, format!("there is no attempt {number}"))
}

fn agent_named(name: &str) -> Result<Contender, JsValue> {
    match name {
        "player" => Ok(Contender::Player),
        "model" => Ok(Contender::Model),
        _ => Err(error(Code::BadData, format!("there is no agent `{name}`: they are player and model"))),
    }
}

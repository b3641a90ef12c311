//! One puzzle on the page: a task, the game on it, and the rollouts being shown.
//!
//! The page asks here whether a ball is valid, runs it, replays and compares attempts, and has every frame
//! drawn. Nothing is shown but the scene until an attempt, a replay, a comparison or the scene alone runs.

use serde::Serialize;
use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use super::describe::{described, reason};
use super::error::{Code, error, from_plain, plain};
use super::frame::{self, View};
use super::paint::Line;
use super::recording::Take;
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
    /// What is shown: nothing, one rollout, or the player's and then the model's.
    takes: Vec<Take>,
}

/// An attempt as the page lists it.
#[derive(Serialize)]
struct Listed {
    /// From 1.
    number: usize,
    words: String,
    #[serde(flatten)]
    attempt: Attempt,
}

impl Listed {
    fn new(number: usize, attempt: Attempt) -> Listed {
        Listed { number, words: attempt.ending.to_string(), attempt }
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
        Ok(Puzzle { task, game, takes: Vec::new() })
    }

    /// `{ id, name, story, goal, description }`: what the puzzle is called, asks for and looks like, in words.
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
        plain(&About {
            id: self.task.id.to_string(),
            name: template.name,
            story: template.story,
            goal: &self.task.goal,
            description: described(&self.task.scene),
        })
    }

    /// Why a ball may not be placed, in words; nothing if it may.
    #[wasm_bindgen(js_name = whyInvalid)]
    pub fn why_invalid(&self, x: f64, y: f64, r: f64) -> Option<String> {
        Ball { x, y, r }.check(&self.task.scene).err().map(|why| reason(why, &self.task.scene))
    }

    /// Lets the player try a ball and shows its rollout: `{ number, words, ball, ending }`.
    ///
    /// # Errors
    /// `invalid_ball`, or `spent` after a hundred attempts.
    pub fn attempt(&mut self, x: f64, y: f64, r: f64) -> Result<JsValue, JsValue> {
        let ball = Ball { x, y, r };
        let (number, rollout) = self.game.play(Contender::Player, ball).map_err(|why| self.refusal(why))?;
        self.takes = vec![Take { attempt: Some((Contender::Player, ball)), rollout, line: Line::Solid }];
        plain(&Listed::new(number, self.game.attempts(Contender::Player)[number - 1]))
    }

    /// Shows what happens without a ball.
    pub fn watch(&mut self) -> Result<(), JsValue> {
        let rollout = simulate(&self.task.scene, None).map_err(|why| self.refusal(why.into()))?;
        self.takes = vec![Take { attempt: None, rollout, line: Line::Solid }];
        Ok(())
    }

    /// Shows an attempt again: its `{ number, words, ball, ending }`.
    ///
    /// # Errors
    /// `no_attempt` if the agent (`player` or `model`) has made fewer.
    pub fn replay(&mut self, agent: &str, number: usize) -> Result<JsValue, JsValue> {
        let (take, listed) = self.again(agent, number)?;
        self.takes = vec![take];
        plain(&listed)
    }

    /// Shows two attempts over each other, the second dashed: `[first, second]`, each as in `replay`.
    ///
    /// # Errors
    /// `no_attempt` if an agent (`player` or `model`) has made fewer.
    pub fn overlay(&mut self, agent: &str, number: usize, other: &str, over: usize) -> Result<JsValue, JsValue> {
        let ((first, one), (second, two)) = (self.again(agent, number)?, self.again(other, over)?);
        self.takes = vec![Take { line: Line::Solid, ..first }, Take { line: Line::Dashed, ..second }];
        plain(&[one, two])
    }

    /// Shows what a ball of the model's comes to, without counting it: as `replay`, with the number 0.
    ///
    /// # Errors
    /// `invalid_ball`.
    pub fn rehearse(&mut self, x: f64, y: f64, r: f64) -> Result<JsValue, JsValue> {
        let ball = Ball { x, y, r };
        let rollout = simulate(&self.task.scene, Some(ball)).map_err(|why| self.refusal(why.into()))?;
        let attempt = Attempt { ball, ending: Ending::of(&rollout) };
        self.takes = vec![Take { attempt: Some((Contender::Model, ball)), rollout, line: Line::Dashed }];
        plain(&Listed::new(0, attempt))
    }

    /// The real paths of what is shown: for each rollout `{ object, ball }`, Float32Arrays of 64 x 64 zeros and
    /// ones, row 0 at the bottom; `ball` is missing if the scene runs alone.
    pub fn paths(&self) -> Result<js_sys::Array, JsValue> {
        self.takes.iter().map(|take| take.pictures(&self.task.scene)).collect()
    }

    /// What a person draws as the path of the green object, as such a picture: x, y, x, y, … in px.
    pub fn sketch(&self, points: &[f64]) -> Vec<f32> {
        let points: Vec<[f64; 2]> = points.chunks_exact(2).map(|point| [point[0], point[1]]).collect();
        trail_image(self.object(), &points).to_f32().collect()
    }

    /// Where the green object is at first, px: `[x, y]`.
    pub fn start(&self) -> Vec<f64> {
        vec![self.object().x, self.object().y]
    }

    /// Shows the best attempts of player and model over each other: `[player, model]`, each as in `replay` or null.
    pub fn compare(&mut self) -> Result<JsValue, JsValue> {
        let best = [Contender::Player, Contender::Model].map(|agent| (agent, self.game.best(agent)));
        let takes = best.iter().filter_map(|&(agent, best)| best.map(|(_, attempt)| self.take(agent, attempt)));
        self.takes = takes.collect::<Result<_, _>>()?;
        plain(&best.map(|(_, best)| best.map(|(number, attempt)| Listed::new(number, attempt))))
    }

    /// Shows the scene at rest again.
    pub fn reset(&mut self) {
        self.takes.clear();
    }

    /// Adds an attempt `{ ball, ending }` that the worker simulated for the model: as it is listed.
    ///
    /// # Errors
    /// `invalid_ball`, or `spent` after a hundred attempts.
    pub fn record(&mut self, attempt: JsValue) -> Result<JsValue, JsValue> {
        let attempt: Attempt = from_plain(attempt)?;
        let number = self.game.record(Contender::Model, attempt).map_err(|why| self.refusal(why))?;
        plain(&Listed::new(number, attempt))
    }

    /// All attempts of an agent: `[{ number, words, ball, ending }, …]`.
    pub fn attempts(&self, agent: &str) -> Result<JsValue, JsValue> {
        let attempts = self.game.attempts(agent_named(agent)?);
        let listed = attempts.iter().enumerate().map(|(index, &attempt)| Listed::new(index + 1, attempt));
        plain(&listed.collect::<Vec<_>>())
    }

    /// `{ used, solved_at }` of an agent; `solved_at` is null as long as no attempt solved the puzzle.
    pub fn score(&self, agent: &str) -> Result<JsValue, JsValue> {
        plain(&self.game.standing(agent_named(agent)?))
    }

    /// Player and model against each other, in words.
    pub fn verdict(&self) -> String {
        self.game.verdict()
    }

    /// Forgets one attempt of an agent's; those after it move up by one.
    ///
    /// # Errors
    /// `no_attempt` if the agent has made fewer.
    pub fn remove(&mut self, agent: &str, number: usize) -> Result<(), JsValue> {
        if self.game.remove(agent_named(agent)?, number) { Ok(()) } else { Err(none(number)) }
    }

    /// Forgets an agent's attempts.
    pub fn clear(&mut self, agent: &str) -> Result<(), JsValue> {
        self.game.clear(agent_named(agent)?);
        Ok(())
    }

    /// The last step of what is shown; 0 if only the scene is.
    pub fn steps(&self) -> usize {
        self.takes.iter().map(|take| take.rollout.steps).max().unwrap_or(0)
    }

    /// When the green object touches the goal in the first rollout shown: `[[first step, last step], …]`.
    pub fn touches(&self) -> Result<JsValue, JsValue> {
        plain(&self.takes.first().map(Take::touches).unwrap_or_default())
    }

    /// Draws a frame into a square canvas: the scene, the maps given over it, then paths, balls and ring.
    ///
    /// # Errors
    /// `bad_data` if the view lacks something.
    pub fn paint(
        &self,
        context: &CanvasRenderingContext2d,
        view: JsValue,
        maps: Vec<HtmlCanvasElement>,
    ) -> Result<(), JsValue> {
        frame::paint(context, &self.task.scene, &self.takes, &from_plain(view)?, &maps)
    }

    /// Draws how an attempt ended, with its whole paths, into a square canvas.
    ///
    /// # Errors
    /// `no_attempt` if the agent has made fewer.
    #[wasm_bindgen(js_name = paintAttempt)]
    pub fn paint_attempt(
        &self,
        context: &CanvasRenderingContext2d,
        agent: &str,
        number: usize,
        dark: bool,
    ) -> Result<(), JsValue> {
        let (take, _) = self.again(agent, number)?;
        frame::paint(context, &self.task.scene, &[take], &View::ended(dark), &[])
    }
}

impl Puzzle {
    fn object(&self) -> &Body {
        &self.task.scene.bodies[self.task.scene.body1]
    }

    fn take(&self, agent: Contender, attempt: Attempt) -> Result<Take, JsValue> {
        let rollout = simulate(&self.task.scene, Some(attempt.ball)).map_err(|why| self.refusal(why.into()))?;
        let line = if agent == Contender::Model { Line::Dashed } else { Line::Solid };
        Ok(Take { attempt: Some((agent, attempt.ball)), rollout, line })
    }

    /// An attempt that was made, simulated once more, and as it is listed.
    fn again(&self, agent: &str, number: usize) -> Result<(Take, Listed), JsValue> {
        let agent = agent_named(agent)?;
        let attempt = number.checked_sub(1).and_then(|index| self.game.attempts(agent).get(index).copied());
        let attempt = attempt.ok_or_else(|| none(number))?;
        Ok((self.take(agent, attempt)?, Listed::new(number, attempt)))
    }

    fn refusal(&self, why: Refused) -> JsValue {
        match why {
            Refused::Invalid(why) => error(Code::InvalidBall, reason(why, &self.task.scene)),
            Refused::AttemptLimit => error(Code::Spent, why),
        }
    }
}

fn none(number: usize) -> JsValue {
    error(Code::NoAttempt, format!("there is no attempt {number}"))
}

fn agent_named(name: &str) -> Result<Contender, JsValue> {
    match name {
        "player" => Ok(Contender::Player),
        "model" => Ok(Contender::Model),
        _ => Err(error(Code::BadData, format!("there is no agent `{name}`: they are player and model"))),
    }
}

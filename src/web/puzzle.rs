//! One puzzle on the page: a task, the game on it, and the rollouts being shown.
//!
//! The page asks here whether a ball is valid, runs it, replays and compares attempts, and has every frame
//! drawn. Nothing is shown but the scene until an attempt, a replay, a comparison or the scene alone runs.

use serde::{Deserialize, Serialize};
use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use super::error::{Code, error, from_plain, plain};
use super::paint::{Painter, reach};
use super::take::Take;
use crate::action::{Ball, Invalid};
use crate::game::{Agent, Attempt, Game, Refused, held};
use crate::rollout::GOAL_STEPS;
use crate::scene::{Body, Role, Scene};
use crate::simulator::simulate;
use crate::task::Task;
use crate::templates::TEMPLATES;

#[wasm_bindgen]
pub struct Puzzle {
    task: Task,
    game: Game,
    /// What is shown: nothing, one rollout, or the player's and then the model's.
    takes: Vec<Take>,
}

/// What a frame shows.
#[derive(Deserialize)]
struct View {
    /// Steps since the start; may lie between two.
    step: f64,
    /// The ball being placed.
    ball: Option<Ball>,
    /// The radius of the knob on that ball, px; 0 draws none.
    knob: f64,
    /// Draws paths whole and not only up to the step.
    whole: bool,
    /// How much the maps cover, 0..=1.
    opacity: f64,
    dark: bool,
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
        let (number, rollout) = self.game.play(Agent::Player, ball).map_err(|why| self.refusal(why))?;
        self.takes = vec![Take { attempt: Some((Agent::Player, ball)), rollout }];
        plain(&Listed::new(number, self.game.attempts(Agent::Player)[number - 1]))
    }

    /// Shows what happens without a ball.
    pub fn watch(&mut self) -> Result<(), JsValue> {
        let rollout = simulate(&self.task.scene, None).map_err(|why| self.refusal(why.into()))?;
        self.takes = vec![Take { attempt: None, rollout }];
        Ok(())
    }

    /// Shows an attempt again: its `{ number, words, ball, ending }`.
    ///
    /// # Errors
    /// `no_attempt` if the agent (`player` or `model`) has made fewer.
    pub fn replay(&mut self, agent: &str, number: usize) -> Result<JsValue, JsValue> {
        let agent = agent_named(agent)?;
        let attempt = number.checked_sub(1).and_then(|index| self.game.attempts(agent).get(index).copied());
        let attempt = attempt.ok_or_else(|| error(Code::NoAttempt, format!("there is no attempt {number}")))?;
        self.takes = vec![self.take(agent, attempt)?];
        plain(&Listed::new(number, attempt))
    }

    /// Shows the best attempts of player and model over each other: `[player, model]`, each as in `replay` or null.
    pub fn compare(&mut self) -> Result<JsValue, JsValue> {
        let best = [Agent::Player, Agent::Model].map(|agent| (agent, self.game.best(agent)));
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
        let number = self.game.record(Agent::Model, attempt).map_err(|why| self.refusal(why))?;
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
        plain(&self.game.score(agent_named(agent)?))
    }

    /// Player and model against each other, in words.
    pub fn verdict(&self) -> String {
        self.game.verdict()
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
        let view: View = from_plain(view)?;
        let painter = Painter::new(context, view.dark)?;
        let scene = &self.task.scene;
        let main = self.takes.first();
        let bodies = |dynamic| {
            let mut bodies = scene.bodies.iter().enumerate().filter(|(_, body)| body.dynamic == dynamic);
            bodies.try_for_each(|(index, body)| {
                let pose = main.and_then(|take| take.pose(view.step, index));
                painter.body(body, pose, index == scene.body2)
            })
        };
        bodies(false)?;
        for map in &maps {
            painter.layer(map, view.opacity)?;
        }
        if !maps.is_empty() {
            // What stands still shows through the maps; what moves lies over them.
            painter.cover(0.6);
            bodies(false)?;
            painter.cover(1.0);
        }
        for take in &self.takes {
            self.paint_paths(&painter, take, &view)?;
        }
        bodies(true)?;
        for (place, take) in self.takes.iter().enumerate() {
            self.paint_ball(&painter, take, view.step, place > 0)?;
        }
        if let Some(take) = main {
            self.paint_ring(&painter, take, view.step)?;
        } else if let Some(ball) = view.ball {
            painter.ball(ball, 0.0, ball.check(scene).is_ok())?;
            if view.knob > 0.0 {
                painter.handle(ball, view.knob)?;
            }
        }
        Ok(())
    }
}

impl Puzzle {
    fn take(&self, agent: Agent, attempt: Attempt) -> Result<Take, JsValue> {
        let rollout = simulate(&self.task.scene, Some(attempt.ball)).map_err(|why| self.refusal(why.into()))?;
        Ok(Take { attempt: Some((agent, attempt.ball)), rollout })
    }

    /// The paths of green object and ball in one rollout.
    fn paint_paths(&self, painter: &Painter, take: &Take, view: &View) -> Result<(), JsValue> {
        let Scene { bodies, body1, .. } = &self.task.scene;
        let until = if view.whole { f64::INFINITY } else { view.step };
        painter.path(take.path(until, *body1), Role::Green, take.line())?;
        painter.path(take.path(until, bodies.len()), Role::Red, take.line())
    }

    /// The ball of one rollout. A rollout that is only laid over another shows ball and green object as outlines.
    fn paint_ball(&self, painter: &Painter, take: &Take, step: f64, outlined: bool) -> Result<(), JsValue> {
        let Scene { bodies, body1, .. } = &self.task.scene;
        if outlined && let Some(pose) = take.pose(step, *body1) {
            painter.ghost(&bodies[*body1], pose, take.line())?;
        }
        match (take.attempt, take.pose(step, bodies.len())) {
            (Some((_, ball)), Some(pose)) if outlined => painter.ghost(&ball.body(), pose, take.line()),
            (Some((_, ball)), Some([x, y, angle])) => {
                painter.ball(Ball { x: x.into(), y: y.into(), ..ball }, angle.into(), true)
            }
            _ => Ok(()),
        }
    }

    /// The ring round the green object while it touches the goal.
    fn paint_ring(&self, painter: &Painter, take: &Take, step: f64) -> Result<(), JsValue> {
        let held = held(&take.rollout, step as usize);
        let object = &self.task.scene.bodies[self.task.scene.body1];
        match take.pose(step, self.task.scene.body1) {
            Some([x, y, _]) if held > 0 => {
                let radius = reach(object).min(24.0) + 5.0;
                painter.ring([x.into(), y.into()], radius, held as f64 / GOAL_STEPS as f64)
            }
            _ => Ok(()),
        }
    }

    fn refusal(&self, why: Refused) -> JsValue {
        match why {
            Refused::Invalid(why) => error(Code::InvalidBall, reason(why, &self.task.scene)),
            Refused::Spent => error(Code::Spent, why),
        }
    }
}

fn agent_named(name: &str) -> Result<Agent, JsValue> {
    match name {
        "player" => Ok(Agent::Player),
        "model" => Ok(Agent::Model),
        _ => Err(error(Code::BadData, format!("there is no agent `{name}`: they are player and model"))),
    }
}

/// Why a ball is invalid, with the name of the body in its way.
fn reason(why: Invalid, scene: &Scene) -> String {
    match why {
        Invalid::Overlaps(body) => format!("the ball overlaps the {}", scene.bodies[body].name()),
        why => why.to_string(),
    }
}

/// The scene for someone who does not see it: every body with its place, what matters first.
fn described(scene: &Scene) -> String {
    let place = |body: &Body| format!("{} at x {:.0}, y {:.0}", body.name(), body.x, body.y);
    let (object, target) = (&scene.bodies[scene.body1], &scene.bodies[scene.body2]);
    let others: Vec<String> = (0..scene.bodies.len())
        .filter(|&index| index != scene.body1 && index != scene.body2)
        .map(|index| place(&scene.bodies[index]))
        .collect();
    let rest = if others.is_empty() { "Nothing else.".to_string() } else { format!("Also: {}.", others.join("; ")) };
    format!("256 by 256, y is up. The {}; the goal is the {}. {rest}", place(object), place(target))
}

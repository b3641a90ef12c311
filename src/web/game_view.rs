//! The view of an open puzzle: its current recordings, their paths, and every frame of them.
//!
//! The second half of the exports of `Game`: `replay`, `compare`, `preview`, `paint`. Without a recording only the
//! scene is drawn; an attempt, a replay, a comparison or `watch` sets the current recordings.

use serde::Serialize;
use wasm_bindgen::prelude::*;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use super::error::{from_js, to_js};
use super::frame::{self, View};
use super::game::{Game, ListedAttempt, attempt_number, author_named, no_attempt};
use super::imagined_paths::paths_to_js;
use super::paint::LineStyle;
use super::recording::Recording;
use crate::puzzle::action::Ball;
use crate::puzzle::sampled_paths::SampledPaths;
use crate::session::ending::Ending;
use crate::session::game::{Attempt, Author};
use crate::session::moments::{deciding_touch, quiet_stretches};
use crate::simulator::{Contact, closest_approach, first_contact, simulate};

#[wasm_bindgen]
impl Game {
    /// Shows the scene running without a ball.
    pub fn watch(&mut self) -> Result<(), JsValue> {
        let rollout = simulate(&self.puzzle.scene, None).map_err(|why| self.refusal(why.into()))?.into();
        self.recordings = vec![Recording { ball: None, rollout, line_style: LineStyle::Solid, of_model: false }];
        Ok(())
    }

    /// Shows an attempt again and returns it.
    ///
    /// # Errors
    /// `no_attempt` if the author has made fewer.
    #[wasm_bindgen(unchecked_return_type = "ListedAttempt")]
    pub fn replay(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Author")] who: &str,
        #[wasm_bindgen(unchecked_param_type = "number")] number: &JsValue,
    ) -> Result<JsValue, JsValue> {
        let (recording, listed) = self.simulate_again(who, number)?;
        self.recordings = vec![recording];
        to_js(&listed)
    }

    /// Shows two attempts over each other, the second with dashed lines, and returns both.
    ///
    /// # Errors
    /// `no_attempt` if an author has made fewer.
    #[wasm_bindgen(unchecked_return_type = "[ListedAttempt, ListedAttempt]")]
    pub fn overlay(
        &mut self,
        #[wasm_bindgen(unchecked_param_type = "Author")] first_who: &str,
        #[wasm_bindgen(unchecked_param_type = "number")] first_number: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "Author")] second_who: &str,
        #[wasm_bindgen(unchecked_param_type = "number")] second_number: &JsValue,
    ) -> Result<JsValue, JsValue> {
        let (first, first_listed) = self.simulate_again(first_who, first_number)?;
        let (second, second_listed) = self.simulate_again(second_who, second_number)?;
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
    pub fn preview(&mut self, x: f64, y: f64, r: f64) -> Result<JsValue, JsValue> {
        let ball = Ball { x, y, r };
        let rollout = simulate(&self.puzzle.scene, Some(ball)).map_err(|why| self.refusal(why.into()))?;
        let attempt = Attempt { ball, ending: Ending::of(&rollout) };
        let rollout = rollout.into();
        self.recordings = vec![Recording { ball: Some(ball), rollout, line_style: LineStyle::Dashed, of_model: true }];
        to_js(&ListedAttempt::new(0, attempt))
    }

    /// Returns the real paths of each current recording, as masks of 64 x 64 zeros and ones, row 0 at the bottom.
    #[wasm_bindgen(js_name = pathMasks, unchecked_return_type = "PathMasks[]")]
    pub fn path_masks(&self) -> Result<js_sys::Array, JsValue> {
        self.recordings.iter().map(|recording| recording.path_masks(&self.puzzle.scene)).collect()
    }

    /// Returns where the green object and the ball really were in the first of the current recordings, after the steps
    /// of an `ImaginedBall`; undefined without a ball.
    #[wasm_bindgen(js_name = sampledPaths, unchecked_return_type = "Pick<ImaginedBall, \"object\" | \"ball\"> | undefined")]
    pub fn sampled_paths(&self) -> Result<JsValue, JsValue> {
        let scene = &self.puzzle.scene;
        let sampled = |recording: &Recording| SampledPaths::of(&recording.rollout, scene.body1, scene.bodies.len());
        self.recordings
            .first()
            .and_then(sampled)
            .map_or(Ok(JsValue::UNDEFINED), |paths| paths_to_js(&paths).map(Into::into))
    }

    /// Shows the best attempts of player and model over each other and returns both; null for an author without
    /// attempts.
    #[wasm_bindgen(unchecked_return_type = "[player: ListedAttempt | null, model: ListedAttempt | null]")]
    pub fn compare(&mut self) -> Result<JsValue, JsValue> {
        let best = [Author::Player, Author::Model].map(|who| (who, self.game.best(who)));
        let recordings =
            best.iter().filter_map(|&(who, best)| best.map(|(_, attempt)| self.record_again(who, attempt)));
        self.recordings = recordings.collect::<Result<_, _>>()?;
        to_js(&best.map(|(_, best)| best.map(|(number, attempt)| ListedAttempt::new(number, attempt))))
    }

    /// Shows only the scene again.
    pub fn reset(&mut self) {
        self.recordings.clear();
    }

    /// Returns the last step of the current recordings at which anything changes; 0 if there are none.
    pub fn steps(&self) -> usize {
        self.recordings.iter().map(|recording| recording.rollout.still_from()).max().unwrap_or(0)
    }

    /// Returns when and where the green object came nearest to its goal in the first of the current recordings;
    /// undefined if there are none.
    #[wasm_bindgen(js_name = closestApproach, unchecked_return_type = "ClosestApproach | undefined")]
    pub fn closest_approach(&self) -> Result<JsValue, JsValue> {
        let approach = |recording: &Recording| closest_approach(&self.puzzle.scene, &recording.rollout);
        self.recordings.first().map(approach).map_or(Ok(JsValue::UNDEFINED), |approach| to_js(&approach))
    }

    /// Returns the moments that playback treats in a special way. Two recordings have only stretches in which nothing
    /// moves in either.
    #[wasm_bindgen(unchecked_return_type = "Moments")]
    pub fn moments(&self) -> Result<JsValue, JsValue> {
        #[derive(Serialize)]
        struct Moments {
            quiet: Vec<[usize; 2]>,
            contact: Option<Contact>,
            deciding: Option<usize>,
        }
        let quiet = quiet_stretches(self.recordings.iter().map(|recording| &*recording.rollout));
        let (contact, deciding) = match self.recordings.as_slice() {
            [Recording { ball, rollout, .. }] => {
                (ball.and_then(|ball| first_contact(&self.puzzle.scene, ball, rollout)), deciding_touch(rollout))
            }
            _ => (None, None),
        };
        to_js(&Moments { quiet, contact, deciding })
    }

    /// Returns the intervals in which the green object touches the goal in the first of the current recordings.
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
        frame::paint(context, &self.puzzle.scene, &self.recordings, &from_js(view)?, &maps)
    }

    /// Draws the scene into a square canvas.
    #[wasm_bindgen(js_name = paintThumbnail)]
    pub fn paint_thumbnail(&self, context: &CanvasRenderingContext2d, dark: bool) -> Result<(), JsValue> {
        super::paint_scene(context, &self.puzzle.scene, dark)
    }

    /// Draws the end of an attempt, with its whole paths, into a square canvas.
    ///
    /// # Errors
    /// `no_attempt` if the author has made fewer.
    #[wasm_bindgen(js_name = paintAttempt)]
    pub fn paint_attempt(
        &self,
        context: &CanvasRenderingContext2d,
        #[wasm_bindgen(unchecked_param_type = "Author")] who: &str,
        #[wasm_bindgen(unchecked_param_type = "number")] number: &JsValue,
        dark: bool,
    ) -> Result<(), JsValue> {
        let (recording, _) = self.simulate_again(who, number)?;
        frame::paint(context, &self.puzzle.scene, &[recording], &View::ended(dark), &[])
    }

    /// Draws the ends of an attempt of the player's and of one of the model's over each other into a square canvas,
    /// with their whole paths; the model's lines are dashed.
    ///
    /// # Errors
    /// `no_attempt` if player or model have made fewer.
    #[wasm_bindgen(js_name = paintPair)]
    pub fn paint_pair(
        &self,
        context: &CanvasRenderingContext2d,
        #[wasm_bindgen(unchecked_param_type = "number")] player: &JsValue,
        #[wasm_bindgen(unchecked_param_type = "number")] model: &JsValue,
        dark: bool,
    ) -> Result<(), JsValue> {
        let (player, _) = self.simulate_again("player", player)?;
        let (model, _) = self.simulate_again("model", model)?;
        frame::paint(context, &self.puzzle.scene, &[player, model], &View::ended(dark), &[])
    }
}

impl Game {
    fn record_again(&self, who: Author, attempt: Attempt) -> Result<Recording, JsValue> {
        let rollout = simulate(&self.puzzle.scene, Some(attempt.ball)).map_err(|why| self.refusal(why.into()))?.into();
        let of_model = who == Author::Model;
        let line_style = if of_model { LineStyle::Dashed } else { LineStyle::Solid };
        Ok(Recording { ball: Some(attempt.ball), rollout, line_style, of_model })
    }

    /// Simulates an earlier attempt once more.
    fn simulate_again(&self, who: &str, number: &JsValue) -> Result<(Recording, ListedAttempt), JsValue> {
        let who = author_named(who)?;
        let attempt = |number: usize| Some((number, *self.game.attempts(who).get(number - 1)?));
        let (number, attempt) = attempt_number(number).and_then(attempt).ok_or_else(|| no_attempt(number))?;
        Ok((self.record_again(who, attempt)?, ListedAttempt::new(number, attempt)))
    }
}

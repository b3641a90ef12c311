//! One session on one puzzle: the player's attempts and the model's, under the same rules, compared.
//!
//! Only valid balls count, at most 100 for each agent, and the same ball twice counts once. An attempt keeps
//! its ball and how it ended; its rollout is simulated again when it is replayed. Used by `web` on the page
//! and in the worker. Knows nothing of canvases, nets or links.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::benchmark::auccess::MAX_ATTEMPTS;
use crate::puzzle::action::{Ball, Invalid};
use crate::puzzle::rollout::{GOAL_STEPS, Rollout, STEPS_PER_SECOND};
use crate::puzzle::scene::Scene;
use crate::simulator::simulate;

/// Most attempts of each agent at one puzzle: as many as PHYRE's metric counts.
pub const ATTEMPT_LIMIT: usize = MAX_ATTEMPTS;

/// Who places the ball.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Agent {
    Player,
    Model,
}

/// How a rollout ended, in brief. Its `Display` is the result in words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Ending {
    pub solved: bool,
    /// Steps simulated.
    pub steps: usize,
    /// The longest that the green object touched the goal without a break, steps.
    pub longest: usize,
    /// How long it had been touching when the rollout ended, steps; 0 if it was not.
    pub last: usize,
}

/// One valid ball and what came of it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Attempt {
    pub ball: Ball,
    pub ending: Ending,
}

/// Why a ball is no attempt.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum Refused {
    #[error(transparent)]
    Invalid(#[from] Invalid),
    #[error("all {ATTEMPT_LIMIT} attempts are used: clear them to begin again")]
    Spent,
}

/// Where an agent stands.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Score {
    /// Attempts made.
    pub used: usize,
    /// The number of the first attempt that solved the puzzle, from 1.
    pub solved_at: Option<usize>,
}

/// The attempts of both agents on one scene.
pub struct Game {
    scene: Scene,
    player: Vec<Attempt>,
    model: Vec<Attempt>,
}

impl Game {
    pub fn new(scene: Scene) -> Game {
        Game { scene, player: Vec::new(), model: Vec::new() }
    }

    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Lets an agent try a ball: its number (from 1) and the rollout. A ball tried before keeps its number.
    ///
    /// # Errors
    /// Refuses an invalid ball, and any new one after the hundredth.
    pub fn play(&mut self, agent: Agent, ball: Ball) -> Result<(usize, Rollout), Refused> {
        ball.check(&self.scene)?;
        let before = self.number_of(agent, ball);
        if before.is_none() && self.attempts(agent).len() == ATTEMPT_LIMIT {
            return Err(Refused::Spent);
        }
        let rollout = simulate(&self.scene, Some(ball))?;
        let number = before.unwrap_or_else(|| self.push(agent, Attempt { ball, ending: Ending::of(&rollout) }));
        Ok((number, rollout))
    }

    /// Adds an attempt that was simulated elsewhere, by the same simulator: the number it gets, from 1.
    ///
    /// # Errors
    /// Refuses like `play`.
    pub fn record(&mut self, agent: Agent, attempt: Attempt) -> Result<usize, Refused> {
        attempt.ball.check(&self.scene)?;
        match self.number_of(agent, attempt.ball) {
            Some(number) => Ok(number),
            None if self.attempts(agent).len() == ATTEMPT_LIMIT => Err(Refused::Spent),
            None => Ok(self.push(agent, attempt)),
        }
    }

    /// Forgets one attempt of an agent's; those after it move up by one. Says whether there was such a number.
    pub fn remove(&mut self, agent: Agent, number: usize) -> bool {
        let attempts = self.list(agent);
        let there = (1..=attempts.len()).contains(&number);
        if there {
            attempts.remove(number - 1);
        }
        there
    }

    /// Forgets an agent's attempts.
    pub fn clear(&mut self, agent: Agent) {
        self.list(agent).clear();
    }

    /// An agent's attempts, in order.
    pub fn attempts(&self, agent: Agent) -> &[Attempt] {
        match agent {
            Agent::Player => &self.player,
            Agent::Model => &self.model,
        }
    }

    pub fn score(&self, agent: Agent) -> Score {
        let attempts = self.attempts(agent);
        let solved_at = attempts.iter().position(|attempt| attempt.ending.solved).map(|index| index + 1);
        Score { used: attempts.len(), solved_at }
    }

    /// The attempt to show for an agent: the first that solved, else the first of those that touched longest.
    pub fn best(&self, agent: Agent) -> Option<(usize, Attempt)> {
        let longest = |&(_, attempt): &(usize, &Attempt)| (attempt.ending.solved, attempt.ending.longest);
        // `max_by_key` keeps the last of equals; the list is walked backwards to keep the first.
        let best = self.attempts(agent).iter().enumerate().rev().max_by_key(longest);
        best.map(|(index, attempt)| (index + 1, *attempt))
    }

    /// Player and model against each other, in words.
    pub fn verdict(&self) -> String {
        let (player, model) = (self.score(Agent::Player), self.score(Agent::Model));
        match (player.solved_at, model.solved_at) {
            (Some(you), Some(it)) if you < it => {
                format!("You solved it on attempt {you}, the model on attempt {it}. You were quicker.")
            }
            (Some(you), Some(it)) if you > it => {
                format!("The model solved it on attempt {it}, you on attempt {you}. The model was quicker.")
            }
            (Some(you), Some(_)) => format!("You and the model both solved it on attempt {you}. A draw."),
            (Some(you), None) if model.used == 0 => {
                format!("You solved it on attempt {you}. The model has not had its turn.")
            }
            (Some(you), None) => format!("You solved it on attempt {you}. The model has not, in {}.", model.used),
            (None, Some(it)) if player.used == 0 => {
                format!("The model solved it on attempt {it}. Now you: you have not tried yet.")
            }
            (None, Some(it)) => format!("The model solved it on attempt {it}. You have not yet, in {}.", player.used),
            (None, None) if player.used + model.used == 0 => "Nobody has tried yet.".to_string(),
            (None, None) => {
                format!("Not solved yet: {} by you, {} by the model.", tries(player.used), tries(model.used))
            }
        }
    }

    fn number_of(&self, agent: Agent, ball: Ball) -> Option<usize> {
        self.attempts(agent).iter().position(|attempt| attempt.ball == ball).map(|index| index + 1)
    }

    fn push(&mut self, agent: Agent, attempt: Attempt) -> usize {
        self.list(agent).push(attempt);
        self.attempts(agent).len()
    }

    fn list(&mut self, agent: Agent) -> &mut Vec<Attempt> {
        match agent {
            Agent::Player => &mut self.player,
            Agent::Model => &mut self.model,
        }
    }
}

impl Ending {
    pub fn of(rollout: &Rollout) -> Ending {
        let longest = (0..=rollout.steps).map(|step| held(rollout, step)).max().unwrap_or(0);
        Ending { solved: rollout.solved, steps: rollout.steps, longest, last: held(rollout, rollout.steps) }
    }
}

/// How many steps the green object has touched the goal without a break, up to and with this one; at most 180.
pub fn held(rollout: &Rollout, step: usize) -> usize {
    rollout.touching[..=step.min(rollout.steps)].iter().rev().take(GOAL_STEPS).take_while(|&&touches| touches).count()
}

impl fmt::Display for Ending {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let seconds = |steps: usize| match steps as f64 / STEPS_PER_SECOND as f64 {
            short if short < 0.05 => "a moment".to_string(),
            long => format!("{long:.1} s"),
        };
        match self {
            Ending { solved: true, steps, .. } => write!(f, "solved after {}", seconds(*steps)),
            Ending { longest: 0, .. } => write!(f, "never touched"),
            Ending { last, .. } if *last > 0 => write!(f, "touching for {} when time ran out", seconds(*last)),
            Ending { longest, .. } => write!(f, "touched for {}, then lost", seconds(*longest)),
        }
    }
}

fn tries(count: usize) -> String {
    format!("{count} attempt{}", if count == 1 { "" } else { "s" })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::Task;

    /// A game on the first task, where the sky is free and the floor is not.
    fn game() -> Game {
        let id = "00000:000".parse().expect("an id");
        Game::new(Task::load(id).expect("a task of the benchmark").scene)
    }

    /// Small balls along the top of the scene: valid there, and all different.
    fn ball(number: usize) -> Ball {
        Ball { x: (10 + number) as f64, y: 250.0, r: 3.0 }
    }

    fn attempt(number: usize, solved: bool, longest: usize) -> Attempt {
        Attempt { ball: ball(number), ending: Ending { solved, steps: 1000, longest, last: 0 } }
    }

    fn rollout(touching: &[bool], solved: bool) -> Rollout {
        let steps = touching.len() - 1;
        Rollout { solved, steps, bodies: Vec::new(), poses: Vec::new(), touching: touching.to_vec() }
    }

    #[test]
    fn an_invalid_ball_is_refused_and_does_not_count() {
        let mut game = game();
        let outside = Ball { x: 1.0, y: 1.0, r: 10.0 };
        assert_eq!(game.play(Agent::Player, outside).unwrap_err(), Refused::Invalid(Invalid::Outside));
        assert_eq!(game.score(Agent::Player), Score { used: 0, solved_at: None });
    }

    #[test]
    fn the_same_ball_twice_counts_once_and_the_agents_count_apart() {
        let mut game = game();
        let (first, rollout) = game.play(Agent::Player, ball(0)).expect("valid");
        assert_eq!(game.play(Agent::Player, ball(1)).expect("valid").0, 2);
        assert_eq!(game.play(Agent::Player, ball(0)).expect("valid"), (first, rollout));
        assert_eq!(game.score(Agent::Player).used, 2);
        assert_eq!(game.play(Agent::Model, ball(1)).expect("valid").0, 1);
    }

    #[test]
    fn the_hundredth_attempt_is_the_last() {
        let mut game = game();
        for number in 0..ATTEMPT_LIMIT {
            game.record(Agent::Model, attempt(number, false, 0)).expect("within the hundred");
        }
        assert_eq!(game.record(Agent::Model, attempt(ATTEMPT_LIMIT, true, 180)), Err(Refused::Spent));
        assert_eq!(game.play(Agent::Model, ball(ATTEMPT_LIMIT)).unwrap_err(), Refused::Spent);
        // One of the hundred can still be looked at.
        assert_eq!(game.play(Agent::Model, ball(4)).expect("made before").0, 5);
        game.clear(Agent::Model);
        assert_eq!(game.record(Agent::Model, attempt(0, true, 180)), Ok(1));
    }

    #[test]
    fn the_best_attempt_is_the_first_that_solved_or_else_touched_longest() {
        let mut game = game();
        assert_eq!(game.best(Agent::Player), None);
        for (number, longest) in [3, 60, 60].into_iter().enumerate() {
            game.record(Agent::Player, attempt(number, false, longest)).expect("valid");
        }
        assert_eq!(game.best(Agent::Player).expect("three").0, 2);
        game.record(Agent::Player, attempt(3, true, 180)).expect("valid");
        game.record(Agent::Player, attempt(4, true, 180)).expect("valid");
        assert_eq!(game.best(Agent::Player).expect("five").0, 4);
        assert_eq!(game.score(Agent::Player), Score { used: 5, solved_at: Some(4) });
    }

    #[test]
    fn an_attempt_that_is_removed_makes_room_and_the_later_ones_move_up() {
        let mut game = game();
        for number in 0..ATTEMPT_LIMIT {
            game.record(Agent::Player, attempt(number, number == 2, 0)).expect("within the hundred");
        }
        assert!(!game.remove(Agent::Player, 0) && !game.remove(Agent::Player, ATTEMPT_LIMIT + 1));
        assert!(!game.remove(Agent::Model, 1));
        assert!(game.remove(Agent::Player, 2));
        assert_eq!(game.score(Agent::Player), Score { used: ATTEMPT_LIMIT - 1, solved_at: Some(2) });
        assert_eq!(game.record(Agent::Player, attempt(1, false, 0)), Ok(ATTEMPT_LIMIT));
    }

    #[test]
    fn the_verdict_names_the_quicker() {
        let mut game = game();
        assert_eq!(game.verdict(), "Nobody has tried yet.");
        game.record(Agent::Player, attempt(0, false, 0)).expect("valid");
        assert_eq!(game.verdict(), "Not solved yet: 1 attempt by you, 0 attempts by the model.");
        game.record(Agent::Model, attempt(0, true, 180)).expect("valid");
        assert_eq!(game.verdict(), "The model solved it on attempt 1. You have not yet, in 1.");
        game.record(Agent::Player, attempt(1, true, 180)).expect("valid");
        assert_eq!(game.verdict(), "The model solved it on attempt 1, you on attempt 2. The model was quicker.");
    }

    #[test]
    fn the_ending_is_told_in_words() {
        let words = |touching: &[bool], solved| Ending::of(&rollout(touching, solved)).to_string();
        let (yes, no) = ([true; 84], [false; 10]);
        assert_eq!(words(&no, false), "never touched");
        assert_eq!(words(&[&no[..], &yes, &no, &yes[..6], &no].concat(), false), "touched for 1.4 s, then lost");
        assert_eq!(words(&[&no[..], &yes[..1], &no].concat(), false), "touched for a moment, then lost");
        assert_eq!(words(&[&no[..], &yes].concat(), false), "touching for 1.4 s when time ran out");
        assert_eq!(words(&[&[false; 133][..], &[true; 180]].concat(), true), "solved after 5.2 s");
    }

    #[test]
    fn the_hold_starts_again_after_a_break() {
        let rollout = rollout(&[true, true, false, true, true, true], false);
        let held: Vec<_> = (0..=5).map(|step| held(&rollout, step)).collect();
        assert_eq!(held, [1, 2, 0, 1, 2, 3]);
    }
}

//! One session on one puzzle: the player's attempts and the model's, under the same rules, compared.
//!
//! Only valid balls count, at most `ATTEMPT_LIMIT` for each of the two, and the same ball twice counts once. An attempt
//! keeps its ball and its ending; its rollout is simulated again to replay it. Used by `web`, on the page and in the
//! worker. Must not depend on canvases, nets or links.

use serde::{Deserialize, Serialize};

use super::ending::Ending;
use crate::benchmark::auccess::MAX_ATTEMPTS;
use crate::puzzle::action::{Ball, Invalid};
use crate::puzzle::rollout::Rollout;
use crate::puzzle::scene::Scene;
use crate::simulator::simulate;

/// Maximum number of attempts of each author at one puzzle: as many as PHYRE's metric counts.
pub const ATTEMPT_LIMIT: usize = MAX_ATTEMPTS;

/// Who places the ball.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Author {
    /// The person.
    Player,
    /// The nets.
    Model,
}

/// A valid ball and the ending of its rollout.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Attempt {
    /// The ball, px.
    pub ball: Ball,
    /// How its rollout ended.
    pub ending: Ending,
}

/// Why a ball is not accepted as an attempt.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[allow(missing_docs, reason = "the messages say it")]
pub enum Refused {
    #[error(transparent)]
    Invalid(#[from] Invalid),
    #[error("all {ATTEMPT_LIMIT} attempts are used: clear them to begin again")]
    AttemptLimit,
}

/// How an author is doing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Standing {
    /// Attempts made.
    pub used: usize,
    /// The number of the first attempt that solved the puzzle, from 1.
    pub solved_at: Option<usize>,
}

/// The attempts of both authors on one scene.
pub struct Game {
    scene: Scene,
    player: Vec<Attempt>,
    model: Vec<Attempt>,
}

impl Game {
    /// Returns a game without attempts.
    pub fn new(scene: Scene) -> Game {
        Game { scene, player: Vec::new(), model: Vec::new() }
    }

    /// Returns the scene.
    pub fn scene(&self) -> &Scene {
        &self.scene
    }

    /// Simulates a ball for an author. Returns the number of the attempt (from 1) and the rollout; a ball that was
    /// tried before keeps its number.
    ///
    /// # Errors
    /// Refuses an invalid ball, and a new one when all attempts are used.
    pub fn play(&mut self, who: Author, ball: Ball) -> Result<(usize, Rollout), Refused> {
        ball.check(&self.scene)?;
        let before = self.number_of(who, ball);
        if before.is_none() && self.attempts(who).len() == ATTEMPT_LIMIT {
            return Err(Refused::AttemptLimit);
        }
        let rollout = simulate(&self.scene, Some(ball))?;
        let number = before.unwrap_or_else(|| self.push(who, Attempt { ball, ending: Ending::of(&rollout) }));
        Ok((number, rollout))
    }

    /// Adds an attempt that was simulated elsewhere by the same simulator. Returns its number, from 1.
    ///
    /// # Errors
    /// Refuses like `play`.
    pub fn record(&mut self, who: Author, attempt: Attempt) -> Result<usize, Refused> {
        attempt.ball.check(&self.scene)?;
        match self.number_of(who, attempt.ball) {
            Some(number) => Ok(number),
            None if self.attempts(who).len() == ATTEMPT_LIMIT => Err(Refused::AttemptLimit),
            None => Ok(self.push(who, attempt)),
        }
    }

    /// Removes one attempt of an author; later ones move up by one. Returns whether there was an attempt of this
    /// number.
    pub fn remove(&mut self, who: Author, number: usize) -> bool {
        let attempts = self.list(who);
        let there = (1..=attempts.len()).contains(&number);
        if there {
            attempts.remove(number - 1);
        }
        there
    }

    /// Removes all attempts of an author.
    pub fn clear(&mut self, who: Author) {
        self.list(who).clear();
    }

    /// Returns the attempts of an author, in order.
    pub fn attempts(&self, who: Author) -> &[Attempt] {
        match who {
            Author::Player => &self.player,
            Author::Model => &self.model,
        }
    }

    /// Returns how an author is doing.
    pub fn standing(&self, who: Author) -> Standing {
        let attempts = self.attempts(who);
        let solved_at = attempts.iter().position(|attempt| attempt.ending.solved).map(|index| index + 1);
        Standing { used: attempts.len(), solved_at }
    }

    /// Returns the best attempt of an author with its number: the first that solved, else the first with the longest
    /// touch.
    pub fn best(&self, who: Author) -> Option<(usize, Attempt)> {
        let key = |&(_, attempt): &(usize, &Attempt)| (attempt.ending.solved, attempt.ending.longest_touch);
        // `max_by_key` returns the last of equals; in reverse order that is the first.
        let best = self.attempts(who).iter().enumerate().rev().max_by_key(key);
        best.map(|(index, attempt)| (index + 1, *attempt))
    }

    fn number_of(&self, who: Author, ball: Ball) -> Option<usize> {
        self.attempts(who).iter().position(|attempt| attempt.ball == ball).map(|index| index + 1)
    }

    fn push(&mut self, who: Author, attempt: Attempt) -> usize {
        self.list(who).push(attempt);
        self.attempts(who).len()
    }

    fn list(&mut self, who: Author) -> &mut Vec<Attempt> {
        match who {
            Author::Player => &mut self.player,
            Author::Model => &mut self.model,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::rollout::{GOAL_STEPS, MAX_STEPS};
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

    fn attempt(number: usize, solved: bool, longest_touch: usize) -> Attempt {
        let ending = Ending { solved, steps: MAX_STEPS, longest_touch, final_touch: 0 };
        Attempt { ball: ball(number), ending }
    }

    #[test]
    fn an_invalid_ball_is_refused_and_does_not_count() {
        let mut game = game();
        let outside = Ball { x: 1.0, y: 1.0, r: 10.0 };
        assert_eq!(game.play(Author::Player, outside).unwrap_err(), Refused::Invalid(Invalid::Outside));
        assert_eq!(game.standing(Author::Player), Standing { used: 0, solved_at: None });
    }

    #[test]
    fn the_same_ball_twice_counts_once_and_each_author_has_its_own_count() {
        let mut game = game();
        let (first, rollout) = game.play(Author::Player, ball(0)).expect("valid");
        assert_eq!(game.play(Author::Player, ball(1)).expect("valid").0, 2);
        assert_eq!(game.play(Author::Player, ball(0)).expect("valid"), (first, rollout));
        assert_eq!(game.standing(Author::Player).used, 2);
        assert_eq!(game.play(Author::Model, ball(1)).expect("valid").0, 1);
    }

    #[test]
    fn no_new_attempt_after_the_limit() {
        let mut game = game();
        for number in 0..ATTEMPT_LIMIT {
            game.record(Author::Model, attempt(number, false, 0)).expect("within the limit");
        }
        assert_eq!(game.record(Author::Model, attempt(ATTEMPT_LIMIT, true, GOAL_STEPS)), Err(Refused::AttemptLimit));
        assert_eq!(game.play(Author::Model, ball(ATTEMPT_LIMIT)).unwrap_err(), Refused::AttemptLimit);
        // An attempt that was made before can still be replayed.
        assert_eq!(game.play(Author::Model, ball(4)).expect("made before").0, 5);
        game.clear(Author::Model);
        assert_eq!(game.record(Author::Model, attempt(0, true, GOAL_STEPS)), Ok(1));
    }

    #[test]
    fn the_best_attempt_is_the_first_that_solved_or_else_touched_longest() {
        let mut game = game();
        assert_eq!(game.best(Author::Player), None);
        for (number, longest) in [3, 60, 60].into_iter().enumerate() {
            game.record(Author::Player, attempt(number, false, longest)).expect("valid");
        }
        assert_eq!(game.best(Author::Player).expect("three").0, 2);
        game.record(Author::Player, attempt(3, true, GOAL_STEPS)).expect("valid");
        game.record(Author::Player, attempt(4, true, GOAL_STEPS)).expect("valid");
        assert_eq!(game.best(Author::Player).expect("five").0, 4);
        assert_eq!(game.standing(Author::Player), Standing { used: 5, solved_at: Some(4) });
    }

    #[test]
    fn a_removed_attempt_makes_room_and_later_ones_move_up() {
        let mut game = game();
        for number in 0..ATTEMPT_LIMIT {
            game.record(Author::Player, attempt(number, number == 2, 0)).expect("within the limit");
        }
        assert!(!game.remove(Author::Player, 0) && !game.remove(Author::Player, ATTEMPT_LIMIT + 1));
        assert!(!game.remove(Author::Model, 1));
        assert!(game.remove(Author::Player, 2));
        assert_eq!(game.standing(Author::Player), Standing { used: ATTEMPT_LIMIT - 1, solved_at: Some(2) });
        assert_eq!(game.record(Author::Player, attempt(1, false, 0)), Ok(ATTEMPT_LIMIT));
    }
}

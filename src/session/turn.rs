//! An agent's turn on one puzzle: ball by ball, each simulated once and then observed by the agent, until the puzzle is
//! solved or all attempts are used.
//!
//! The page's worker and `evaluate` both run agents this way, so the measured behaviour is the behaviour on the page.

use crate::agents::{Agent, Observation, Proposal};
use crate::benchmark::auccess::MAX_ATTEMPTS;
use crate::puzzle::action::Invalid;
use crate::puzzle::recorded_paths::RecordedPaths;
use crate::puzzle::rollout::Rollout;
use crate::puzzle::scene::Scene;
use crate::simulator::Engine;

/// An agent at work on a scene.
///
/// ```
/// use pathlight::session::turn::Turn;
/// use pathlight::{agents, puzzle::task::Task};
///
/// let task = Task::load("00002:007".parse()?)?;
/// let agent = agents::random(&task.scene, task.id.seed(0), 100).into_iter();
/// let solved_at = Turn::new(task.scene, Box::new(agent)).first_solved()?;
/// assert_eq!(solved_at, Some(2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Turn {
    scene: Scene,
    agent: Box<dyn Agent>,
    engine: Engine,
    /// Number of attempts made.
    used: usize,
    solved: bool,
}

impl Turn {
    /// Starts the turn of an agent that is at work on this scene.
    pub fn new(scene: Scene, agent: Box<dyn Agent>) -> Turn {
        Turn::in_engine(scene, agent, Engine::default())
    }

    /// Starts a turn like `new`, in any engine.
    pub fn in_engine(scene: Scene, agent: Box<dyn Agent>, engine: Engine) -> Turn {
        Turn { scene, agent, engine, used: 0, solved: false }
    }

    /// Simulates the agent's next ball. Returns `None` once the puzzle is solved, all attempts are used or the agent
    /// has no more balls.
    ///
    /// # Errors
    ///
    /// If the agent proposes an invalid ball.
    pub fn attempt(&mut self) -> Result<Option<(Proposal, Rollout)>, Invalid> {
        if self.solved || self.used == MAX_ATTEMPTS {
            return Ok(None);
        }
        let Some(proposal) = self.agent.propose() else { return Ok(None) };
        let rollout = self.engine.simulate(&self.scene, Some(proposal.ball))?;
        let paths = RecordedPaths::of(&rollout, &self.scene).and_then(|paths| paths.sampled());
        self.agent.observe(&Observation { solved: rollout.solved, paths });
        self.used += 1;
        self.solved = rollout.solved;
        Ok(Some((proposal, rollout)))
    }

    /// Makes the remaining attempts. Returns the number, from 1, of the attempt that solved the puzzle, if any.
    ///
    /// # Errors
    ///
    /// If the agent proposes an invalid ball.
    pub fn first_solved(mut self) -> Result<Option<usize>, Invalid> {
        while self.attempt()?.is_some() {}
        Ok(self.solved.then_some(self.used))
    }
}

#[cfg(test)]
mod tests {
    use std::sync::mpsc::{Sender, channel};

    use super::*;
    use crate::agents::Origin;
    use crate::puzzle::action::Ball;
    use crate::puzzle::task::Task;
    use crate::simulator::simulate;

    /// Proposes these balls, last first, and passes on its observations.
    struct Witness(Vec<Ball>, Sender<Observation>);

    impl Agent for Witness {
        fn propose(&mut self) -> Option<Proposal> {
            self.0.pop().map(|ball| Proposal { ball, origin: Origin::Uniform })
        }

        fn observe(&mut self, observation: &Observation) {
            self.1.send(*observation).expect("the test listens");
        }
    }

    #[test]
    fn an_agent_observes_each_attempt_until_one_solves() {
        let scene = Task::load("00000:000".parse().expect("an id")).expect("a task").scene;
        let solves = |ball: &Ball| simulate(&scene, Some(*ball)).is_ok_and(|rollout| rollout.solved);
        let balls = (4..60).map(|x| Ball { x: (4 * x) as f64, y: 236.0, r: 12.0 });
        let valid: Vec<Ball> = balls.filter(|ball| ball.check(&scene).is_ok()).collect();
        let solution = *valid.iter().find(|ball| solves(ball)).expect("a solution");
        let failure = *valid.iter().find(|ball| !solves(ball)).expect("a failure");
        let (sender, observed) = channel();
        let mut turn = Turn::new(scene.clone(), Box::new(Witness(vec![failure, solution, failure], sender)));
        for (ball, solved) in [(failure, false), (solution, true)] {
            let (proposal, rollout) = turn.attempt().expect("valid").expect("a ball is left");
            assert_eq!((proposal.ball, rollout.solved), (ball, solved));
            let observation = observed.try_recv().expect("it was told");
            assert_eq!(observation.solved, solved);
            let last = observation.paths.expect("the paths").ball[15];
            let [x, y, _] = rollout.pose(rollout.steps / 10 * 10, scene.bodies.len()).expect("the ball moves");
            assert_eq!(last, [x, y]);
        }
        assert!(turn.attempt().expect("valid").is_none(), "solved");
    }

    #[test]
    fn a_turn_ends_with_the_last_attempt_that_counts() {
        let scene = Task::load("00000:000".parse().expect("an id")).expect("a task").scene;
        let ball = Ball { x: 128.0, y: 250.0, r: 2.0 };
        let proposal = Proposal { ball, origin: Origin::Uniform };
        let turn = |count: usize| Turn::new(scene.clone(), Box::new(vec![proposal; count].into_iter()));
        assert_eq!(turn(3).first_solved(), Ok(None));
        let mut long = turn(MAX_ATTEMPTS + 1);
        let made = std::iter::from_fn(|| long.attempt().expect("valid")).count();
        assert_eq!(made, MAX_ATTEMPTS);
    }
}

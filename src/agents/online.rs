//! The online agent: tries the most promising candidates and learns from each failed attempt. Candidates near the
//! failed ball, and candidates whose imagined paths resemble its paths, become less probable; other candidates keep
//! their chances.
//!
//! In PHYRE's paper (Bakhtin et al. 2019), an online agent learns during the counted attempts. Here the learning is
//! Gaussian process classification, updated by each outcome. Nothing is drawn at random.

use super::gaussian_process::{GaussianProcessClassifier, Kernel};
use super::squared_exponential::{Points, SquaredExponential};
use super::{Agent, Observation, Origin, Proposal, sigmoid};
use crate::puzzle::action::Ball;
use crate::puzzle::sampled_paths::{SAMPLES, SampledPaths};

/// Logits are equal if they round to the same multiple of this, because the order must not depend on the last bits.
const RESOLUTION: f64 = 1.0 / 65536.0;

/// An attempt is named as the reason only if it lowered a logit by at least this much.
const NOTICEABLE: f64 = 0.25;

/// A valid ball to try, and its predicted outcome.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// The ball, px.
    pub ball: Ball,
    /// The logit of the chance that it solves; finite.
    pub logit: f64,
    /// The imagined paths.
    pub paths: SampledPaths,
}

/// The similarity of two candidates: the sum of the covariances of their balls and of their paths.
#[derive(Clone, Copy, Debug)]
pub struct Similarity {
    /// The covariance by x, y and radius, px.
    pub balls: SquaredExponential,
    /// The covariance by the positions of the green object, px.
    pub paths: SquaredExponential,
}

impl Similarity {
    /// Chosen on dev tasks with `cargo bench --features ndarray --bench online -- FILE`, where FILE holds the weights.
    pub const DEFAULT: Similarity = Similarity {
        balls: SquaredExponential { variance: 16.0, length_scale: 4.5 },
        paths: SquaredExponential { variance: 4.0, length_scale: 10.0 },
    };

    /// Compares only the balls, wherever they lead.
    pub const OF_BALLS: Similarity =
        Similarity { paths: SquaredExponential { variance: 0.0, ..Similarity::DEFAULT.paths }, ..Similarity::DEFAULT };
}

/// The input of the comparison: a ball, and its imagined paths.
type Idea = (Ball, SampledPaths);

impl Kernel for Similarity {
    type Input = Idea;
    /// Balls, and the green object's paths.
    type Inputs = [Points; 2];

    fn arrange(&self, ideas: &[Idea]) -> [Points; 2] {
        let balls: Vec<_> = ideas.iter().map(|(ball, _)| place(ball)).collect();
        let paths: Vec<_> = ideas.iter().map(|(_, paths)| coordinates(paths)).collect();
        [Points::new(&balls), Points::new(&paths)]
    }

    fn covariances(&self, [balls, paths]: &[Points; 2], (ball, path): &Idea) -> Vec<f64> {
        let mut covariances = self.balls.of_all(balls, &place(ball));
        if self.paths.variance != 0.0 {
            let of_paths = self.paths.of_all(paths, &coordinates(path));
            covariances.iter_mut().zip(of_paths).for_each(|(covariance, of_paths)| *covariance += of_paths);
        }
        covariances
    }

    fn covariance(&self, (ball, paths): &Idea, (other_ball, other_paths): &Idea) -> f64 {
        let balls = self.balls.of(&place(ball), &place(other_ball));
        if self.paths.variance == 0.0 {
            return balls;
        }
        balls + self.paths.of(&coordinates(paths), &coordinates(other_paths))
    }
}

fn place(ball: &Ball) -> [f32; 3] {
    [ball.x as f32, ball.y as f32, ball.r as f32]
}

/// The coordinates of the green object.
fn coordinates(paths: &SampledPaths) -> [f32; 2 * SAMPLES] {
    std::array::from_fn(|index| paths.object[index / 2][index % 2])
}

/// An agent at work on one scene.
pub struct OnlineAgent {
    candidates: Vec<Candidate>,
    process: GaussianProcessClassifier<Similarity>,
    tried: Vec<bool>,
    /// The index of the candidate that was proposed last.
    last: Option<usize>,
    /// Number of attempts observed.
    attempts: usize,
    /// For each candidate, the number, from 1, of the attempt that lowered its logit most, and by how much.
    lowered: Vec<(usize, f64)>,
}

impl OnlineAgent {
    /// Creates an agent that has made no attempt yet.
    pub fn new(candidates: Vec<Candidate>, similarity: Similarity) -> OnlineAgent {
        let ideas: Vec<Idea> = candidates.iter().map(|candidate| (candidate.ball, candidate.paths)).collect();
        let logits = candidates.iter().map(|candidate| candidate.logit).collect();
        OnlineAgent {
            process: GaussianProcessClassifier::new(similarity, logits, &ideas),
            tried: vec![false; candidates.len()],
            lowered: vec![(0, 0.0); candidates.len()],
            candidates,
            last: None,
            attempts: 0,
        }
    }

    /// Returns the `count` balls that the agent tries if every attempt fails and no real paths are reported: a fixed
    /// list, which learns nothing from the attempts.
    pub fn list(mut self, count: usize) -> Vec<Proposal> {
        let next = || {
            let proposal = self.propose()?;
            self.observe(&Observation { solved: false, paths: None });
            Some(proposal)
        };
        std::iter::from_fn(next).take(count).collect()
    }
}

impl Agent for OnlineAgent {
    fn propose(&mut self) -> Option<Proposal> {
        let means = self.process.means();
        let rounded = |index: usize| (means[index] / RESOLUTION).round() as i64;
        let untried = (0..means.len()).filter(|&index| !self.tried[index]);
        // `max_by_key` returns the last of equals, which in reverse order is the first.
        let best = untried.rev().max_by_key(|&index| rounded(index))?;
        self.tried[best] = true;
        self.last = Some(best);
        let (attempt, fall) = self.lowered[best];
        let origin = Origin::Imagined {
            prior: sigmoid(self.candidates[best].logit),
            probability: sigmoid(means[best]),
            lowered_by: (fall >= NOTICEABLE).then_some(attempt),
        };
        Some(Proposal { ball: self.candidates[best].ball, origin })
    }

    fn observe(&mut self, observation: &Observation) {
        let Some(last) = self.last.take() else { return };
        self.attempts += 1;
        let Candidate { ball, paths, .. } = self.candidates[last];
        // The outcome counts twice: for the imagined paths, and for the observed ones.
        let mut rises = self.process.observe(last, (ball, paths), observation.solved);
        if let Some(real_paths) = observation.paths {
            let more = self.process.observe(last, (ball, real_paths), observation.solved);
            rises.iter_mut().zip(more).for_each(|(rise, more)| *rise += more);
        }
        for (lowered, rise) in self.lowered.iter_mut().zip(rises) {
            if -rise > lowered.1 {
                *lowered = (self.attempts, -rise);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A ball that leaves the green object at rest at `object`.
    fn candidate(x: f64, logit: f64, object: f32) -> Candidate {
        let paths = SampledPaths { object: [[object, 50.0]; SAMPLES], ball: [[x as f32, 10.0]; SAMPLES] };
        Candidate { ball: Ball { x, y: 100.0, r: 5.0 }, logit, paths }
    }

    /// Two ideas: the first three candidates lead the object to 60 px, the rest to 200 px.
    fn two_ideas() -> Vec<Candidate> {
        vec![
            candidate(100.0, 2.0, 60.0),
            candidate(140.0, 1.9, 61.0),
            candidate(180.0, 1.8, 62.0),
            candidate(220.0, 1.5, 200.0),
            candidate(221.0, 0.4, 201.0),
        ]
    }

    const FAILED: Observation = Observation { solved: false, paths: None };

    fn places(agent: &mut dyn Agent, observation: Observation) -> Vec<f64> {
        let mut next = || {
            let proposal = agent.propose()?;
            agent.observe(&observation);
            Some(proposal.ball.x)
        };
        std::iter::from_fn(&mut next).collect()
    }

    fn agent(candidates: Vec<Candidate>) -> OnlineAgent {
        OnlineAgent::new(candidates, Similarity::DEFAULT)
    }

    #[test]
    fn a_failure_lowers_what_leads_to_the_same_paths_wherever_it_starts() {
        assert_eq!(places(&mut agent(two_ideas()), FAILED)[..2], [100.0, 220.0]);
        let balls = &mut OnlineAgent::new(two_ideas(), Similarity::OF_BALLS);
        assert_eq!(places(balls, FAILED)[..3], [100.0, 140.0, 180.0]);
    }

    #[test]
    fn what_really_happened_counts_too() {
        let elsewhere = Observation { paths: Some(candidate(0.0, 0.0, 201.0).paths), ..FAILED };
        let mut agent = agent(two_ideas());
        agent.propose();
        agent.observe(&elsewhere);
        assert!(agent.process.means()[3] < 1.5 - NOTICEABLE, "the other idea fails too");
    }

    #[test]
    fn a_ball_beside_one_that_failed_falls() {
        let near = vec![candidate(100.0, 2.0, 60.0), candidate(103.0, 1.9, 120.0), candidate(140.0, 1.0, 200.0)];
        assert_eq!(places(&mut agent(near), FAILED), [100.0, 140.0, 103.0]);
    }

    #[test]
    fn a_proposal_names_the_attempt_that_lowered_it_most() {
        let mut agent = agent(two_ideas());
        let mut origins = Vec::new();
        while let Some(Proposal { origin: Origin::Imagined { prior, probability, lowered_by }, .. }) = agent.propose() {
            origins.push((prior, probability, lowered_by));
            agent.observe(&FAILED);
        }
        assert_eq!(origins.len(), 5);
        assert_eq!(origins[0], (sigmoid(2.0), sigmoid(2.0), None));
        assert_eq!(origins[1].2, None, "nothing like it was tried");
        for (prior, probability, lowered_by) in &origins[2..] {
            assert!(probability < prior);
            assert!(matches!(lowered_by, Some(1 | 2)), "{origins:?}");
        }
    }

    #[test]
    fn a_list_is_what_it_tries_if_all_fails_as_imagined() {
        let list: Vec<f64> = agent(two_ideas()).list(3).iter().map(|proposal| proposal.ball.x).collect();
        assert_eq!(list, places(&mut agent(two_ideas()), FAILED)[..3]);
        assert!(agent(Vec::new()).list(3).is_empty());
    }

    #[test]
    fn of_equal_candidates_the_first_comes_first_and_an_invalid_ball_teaches_nothing() {
        let equal = (0..4).map(|index| candidate(10.0 * f64::from(index), 1.0 + 1e-9 * f64::from(index), 70.0));
        let mut agent = agent(equal.collect());
        // No outcome is observed for balls that another simulator calls invalid.
        let places: Vec<f64> = std::iter::from_fn(|| agent.propose()).map(|proposal| proposal.ball.x).collect();
        assert_eq!(places, [0.0, 10.0, 20.0, 30.0]);
    }
}

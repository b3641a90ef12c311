//! The candidates of the agents that reason in paths: the most promising balls of a scene, each imagined by the dynamics net.

use super::online::Candidate;
use super::ranking;
use crate::nets::PathNet;
use crate::puzzle::action::Ball;
use crate::puzzle::scene::Scene;

/// Balls that are imagined for a scene, unless more are asked for: four times as many as there are attempts.
const CANDIDATES: usize = 400;

/// Returns the candidates of a scene, at least `count` if as many balls fit, some of which may be much alike; `None` if the
/// weights have no dynamics net, or damaged weights know no chance.
pub fn imagined_candidates(nets: &PathNet, scene: &Scene, count: usize) -> Option<Vec<Candidate>> {
    let read = nets.read(scene)?;
    let ranked = ranking::ranked(&read.logits, scene, count.max(CANDIDATES));
    let balls: Vec<Ball> = ranked.into_iter().map(|proposal| proposal.ball).collect();
    let candidates = balls.iter().zip(read.imagine(&balls)).map(|(&ball, imagined)| Candidate {
        ball,
        logit: imagined.logit.into(),
        paths: imagined.paths,
    });
    let finite = |candidate: &Candidate| {
        let paths = candidate.paths.object.iter().chain(&candidate.paths.ball).flatten();
        candidate.logit.is_finite() && paths.into_iter().all(|coordinate| coordinate.is_finite())
    };
    let candidates: Vec<Candidate> = candidates.filter(finite).collect();
    (!candidates.is_empty()).then_some(candidates)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::agents::{Origin, propose, start};
    use crate::nets::{DynamicsNet, flex};
    use crate::puzzle::task::Task;

    #[test]
    fn a_dynamics_net_yields_valid_balls_that_the_model_tries() {
        let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
        let mut nets = PathNet::new(&flex());
        assert!(imagined_candidates(&nets, &scene, 100).is_none());
        let kind = |nets: &PathNet| start(nets, &scene, 0, 1).propose().expect("a ball").origin;
        assert!(!matches!(kind(&nets), Origin::Imagined { .. }));
        nets.dynamics = Some(DynamicsNet::new(&flex()));
        assert!(matches!(kind(&nets), Origin::Imagined { .. }));
        let candidates = imagined_candidates(&nets, &scene, 100).expect("a dynamics net");
        assert_eq!(candidates.len(), CANDIDATES);
        for (index, Candidate { ball, .. }) in candidates.iter().enumerate() {
            assert_eq!(ball.check(&scene), Ok(()));
            assert!(candidates[..index].iter().all(|before| before.ball != *ball), "{ball} twice");
        }
        assert_eq!(propose(&nets, &scene, 0, 100).len(), 100);
    }
}

//! The candidates of the agents that reason in paths: the most promising balls of a scene, each imagined by the
//! dynamics net.
//!
//! The places and radii that the net ranks are some px apart, and often a single px is decisive. So the likeliest
//! candidates take one step of steepest-ascent hill climbing: each is replaced by its likeliest neighbour. Further
//! steps, longer steps or more candidates bring no gain on dev tasks.

use super::memory::Recollection;
use super::online::{Candidate, OnlineAgent, Similarity};
use super::{Proposal, ranking};
use crate::nets::{ImaginedBall, PathNet, ReadScene};
use crate::puzzle::action::{Ball, Obstacles};
use crate::puzzle::scene::Scene;

/// Default number of candidates of a scene: four times the number of attempts.
pub(super) const CANDIDATES: usize = 400;

/// The likeliest candidates, whose neighbours are imagined too. Other candidates are hardly ever tried.
const CLIMBERS: usize = 100;

/// Difference of a neighbour in x, y or radius, px.
const STEP: f64 = 1.0;

/// Returns the distinct candidates of a scene: at least `count`, unless fewer balls fit. `None` if the weights have no
/// dynamics net, or are so damaged that no chance is a number.
pub fn imagined_candidates(nets: &PathNet, scene: &Scene, count: usize) -> Option<Vec<Candidate>> {
    candidates_of(&nets.read(scene)?, scene, count)
}

/// Returns the candidates of a scene that the dynamics net has read.
pub(super) fn candidates_of(read: &ReadScene, scene: &Scene, count: usize) -> Option<Vec<Candidate>> {
    let ranked = ranking::ranked(&read.logits, scene, count.max(CANDIDATES));
    let balls: Vec<Ball> = ranked.into_iter().map(|proposal| proposal.ball).collect();
    let mut candidates: Vec<Candidate> = imagine(read, &balls).filter(is_finite).collect();
    climb(&mut candidates, read, &Obstacles::new(scene));
    (!candidates.is_empty()).then_some(candidates)
}

/// Returns the candidates plus balls that solved similar scenes, with logits adjusted by a memory.
pub fn remembered(
    mut candidates: Vec<Candidate>,
    read: &ReadScene,
    scene: &Scene,
    recollection: &Recollection,
) -> Vec<Candidate> {
    let suggested = recollection.suggestions(scene, |ball| candidates.iter().any(|known| known.ball == *ball));
    candidates.extend(imagine(read, &suggested).filter(is_finite));
    recollection.change_logits(&mut candidates);
    candidates
}

/// Returns up to `count` proposals: the candidates in the order in which the online agent tries them if all attempts
/// fail, then the next balls in the net's ranking. A longer list begins with the balls of a shorter one.
pub(super) fn proposals(candidates: Vec<Candidate>, nets: &PathNet, scene: &Scene, count: usize) -> Vec<Proposal> {
    let mut proposals = OnlineAgent::new(candidates, Similarity::DEFAULT).list(count);
    if proposals.len() < count
        && let Some(read) = nets.read(scene)
    {
        // More than are missing, because some are already candidates, reached by climbing.
        let ranked = ranking::ranked(&read.logits, scene, count + CANDIDATES);
        for proposal in ranked.into_iter().skip(CANDIDATES) {
            if proposals.iter().all(|before| before.ball != proposal.ball) {
                proposals.push(proposal);
            }
        }
        proposals.truncate(count);
    }
    proposals
}

/// Replaces each of the likeliest candidates by its likeliest neighbour, if that is likelier and not yet a candidate.
fn climb(candidates: &mut [Candidate], read: &ReadScene, obstacles: &Obstacles) {
    let mut order: Vec<usize> = (0..candidates.len()).collect();
    order.sort_by(|&a, &b| candidates[b].logit.total_cmp(&candidates[a].logit));
    order.truncate(CLIMBERS);
    let (climbers, neighbours): (Vec<usize>, Vec<Ball>) = order
        .into_iter()
        .flat_map(|index| neighbours(candidates[index].ball, obstacles).map(move |ball| (index, ball)))
        .unzip();
    for (index, neighbour) in climbers.into_iter().zip(imagine(read, &neighbours)) {
        let likelier = is_finite(&neighbour) && neighbour.logit > candidates[index].logit;
        if likelier && candidates.iter().all(|candidate| candidate.ball != neighbour.ball) {
            candidates[index] = neighbour;
        }
    }
}

/// Returns the valid neighbours of a ball.
fn neighbours(ball: Ball, obstacles: &Obstacles) -> impl Iterator<Item = Ball> {
    let Ball { x, y, r } = ball;
    let moved = [-STEP, STEP].into_iter().flat_map(move |step| {
        [Ball { x: x + step, ..ball }, Ball { y: y + step, ..ball }, Ball { r: r + step, ..ball }]
    });
    moved.filter(|neighbour| obstacles.check(neighbour).is_ok())
}

fn imagine(read: &ReadScene, balls: &[Ball]) -> impl Iterator<Item = Candidate> {
    #[cfg(test)]
    tests::IMAGINED.set(tests::IMAGINED.get() + balls.len());
    let imagined = read.imagine(balls).into_iter().zip(balls);
    imagined.map(|(ImaginedBall { logit, paths, .. }, &ball)| Candidate { ball, logit: logit.into(), paths })
}

/// Returns whether the logit and all coordinates are finite. With damaged weights they may not be.
fn is_finite(candidate: &Candidate) -> bool {
    let paths = candidate.paths.object.iter().chain(&candidate.paths.ball).flatten();
    candidate.logit.is_finite() && paths.into_iter().all(|coordinate| coordinate.is_finite())
}

#[cfg(test)]
pub(super) mod tests {
    use std::cell::Cell;

    use super::*;
    use crate::agents::{Origin, propose, start};
    use crate::nets::DynamicsNet;
    use crate::puzzle::task::Task;

    thread_local! {
        /// Number of balls that this thread has imagined.
        pub static IMAGINED: Cell<usize> = const { Cell::new(0) };
    }

    #[test]
    fn a_dynamics_net_yields_valid_balls_that_the_model_tries() {
        let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
        let mut nets = PathNet::fresh(0);
        assert!(imagined_candidates(&nets, &scene, 100).is_none());
        let kind = |nets: &PathNet| start(nets, &scene, 0, 1).propose().expect("a ball").origin;
        assert!(!matches!(kind(&nets), Origin::Imagined { .. }));
        nets.dynamics = Some(DynamicsNet::fresh(0));
        assert!(matches!(kind(&nets), Origin::Imagined { .. }));
        let candidates = imagined_candidates(&nets, &scene, 100).expect("a dynamics net");
        assert_eq!(candidates.len(), CANDIDATES);
        for (index, Candidate { ball, .. }) in candidates.iter().enumerate() {
            assert_eq!(ball.check(&scene), Ok(()));
            assert!(candidates[..index].iter().all(|before| before.ball != *ball), "{ball} twice");
        }
    }

    #[test]
    fn a_longer_list_begins_with_the_balls_of_a_shorter_one() {
        let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
        let mut nets = PathNet::fresh(0);
        nets.dynamics = Some(DynamicsNet::fresh(0));
        let longest = propose(&nets, &scene, 0, 1000);
        assert_eq!(longest.len(), 1000);
        for (index, Proposal { ball, .. }) in longest.iter().enumerate() {
            assert_eq!(ball.check(&scene), Ok(()));
            assert!(longest[..index].iter().all(|before| before.ball != *ball), "{ball} twice");
        }
        for count in [1, 100, CANDIDATES, CANDIDATES + 1, 700] {
            assert_eq!(propose(&nets, &scene, 0, count), longest[..count], "{count}");
        }
    }

    #[test]
    fn the_likeliest_candidates_climb_one_step_at_most() {
        let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
        let mut nets = PathNet::fresh(0);
        nets.dynamics = Some(DynamicsNet::fresh(0));
        let read = nets.read(&scene).expect("a dynamics net");
        let ranked: Vec<Ball> =
            ranking::ranked(&read.logits, &scene, CANDIDATES).iter().map(|proposal| proposal.ball).collect();
        let before: Vec<Candidate> = imagine(&read, &ranked).collect();
        let after = imagined_candidates(&nets, &scene, 100).expect("a dynamics net");
        let mut moved = 0;
        for (before, after) in before.iter().zip(&after) {
            let [dx, dy, dr] = [0, 1, 2].map(|axis| {
                let [from, to]: [[f64; 3]; 2] = [before.ball.into(), after.ball.into()];
                (to[axis] - from[axis]).abs()
            });
            if before.ball == after.ball {
                assert_eq!(before, after);
            } else {
                assert_eq!(dx + dy + dr, STEP, "{} to {}", before.ball, after.ball);
                assert!(after.logit > before.logit);
                moved += 1;
            }
        }
        assert!((1..=CLIMBERS).contains(&moved), "{moved} moved");
    }
}

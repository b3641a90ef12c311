//! DQN's attempts: a fixed list of actions, the same for every task, ranked by its logits (Bakhtin et al. 2019).

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::{Origin, Proposal, sigmoid};
use crate::nets::Dqn;
use crate::puzzle::action::{Action, Ball, Obstacles};
use crate::puzzle::scene::Scene;

/// Actions in the list, as published. Those that are invalid in a scene are not attempts.
const ACTIONS: usize = 10_000;

/// Returns the list, drawn uniformly from the action space.
fn actions() -> impl Iterator<Item = Action> {
    let mut rng = Pcg64Mcg::seed_from_u64(0);
    std::iter::repeat_with(move || Action { x: rng.random(), y: rng.random(), r: rng.random() }).take(ACTIONS)
}

/// Returns up to `attempts` valid balls of the list, the most probable first. Actions whose logit is not finite are
/// omitted.
pub(crate) fn ranked(dqn: &Dqn, scene: &Scene, attempts: usize) -> Vec<Proposal> {
    let obstacles = Obstacles::new(scene);
    let placed = actions().filter_map(|action| Some((action, obstacles.place(action).ok()?)));
    let (actions, balls): (Vec<Action>, Vec<Ball>) = placed.unzip();
    let mut scored: Vec<(f32, Ball)> = dqn.logits(scene, &actions).into_iter().zip(balls).collect();
    scored.retain(|(logit, _)| logit.is_finite());
    scored.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    let proposal =
        |(logit, ball): (f32, Ball)| Proposal { ball, origin: Origin::Dqn { probability: sigmoid(logit.into()) } };
    scored.into_iter().take(attempts).map(proposal).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::Task;

    #[test]
    fn valid_actions_of_the_list_come_in_the_order_of_their_logits() {
        let scene = Task::load("00002:007".parse().expect("an id")).expect("a task").scene;
        let dqn = Dqn::fresh(3);
        let found = ranked(&dqn, &scene, 100);
        assert_eq!(found.len(), 100);
        let listed: Vec<Ball> = actions().filter_map(|action| action.place(&scene).ok()).collect();
        assert!((1000..ACTIONS).contains(&listed.len()));
        let probability = |proposal: &Proposal| match proposal.origin {
            Origin::Dqn { probability } => probability,
            origin => panic!("{origin:?}"),
        };
        assert!(found.is_sorted_by(|a, b| probability(a) >= probability(b)));
        assert!(found.iter().all(|proposal| listed.contains(&proposal.ball)));
    }
}

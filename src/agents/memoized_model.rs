//! The model, with a cache of what its dynamics net imagined for the last scene. A page asks about one scene for its
//! candidates, for single balls, for the list of proposals and for a turn; all of these start from the same candidates.

use std::cell::{OnceCell, RefCell};

use super::imagined_candidates::{CANDIDATES, candidates_of, remembered};
use super::memory::Recollection;
use super::online::{Candidate, OnlineAgent, Similarity};
use super::{Agent, Proposal, propose_from, start_from};
use crate::nets::{ImaginedBall, PathNet, ReadScene};
use crate::puzzle::action::Ball;
use crate::puzzle::scene::Scene;

/// Nets with a cache for the last scene.
pub struct MemoizedModel {
    /// The nets.
    pub nets: PathNet,
    last: RefCell<Option<Memo>>,
}

/// A scene, and the dynamics net's results for it.
struct Memo {
    scene: Scene,
    read: ReadScene,
    candidates: OnceCell<Option<Vec<Candidate>>>,
}

impl MemoizedModel {
    /// Creates the model with an empty cache.
    pub fn new(nets: PathNet) -> MemoizedModel {
        MemoizedModel { nets, last: RefCell::new(None) }
    }

    /// Imagines a ball; `None` if the weights have no dynamics net.
    pub fn imagine(&self, scene: &Scene, ball: Ball) -> Option<ImaginedBall> {
        self.with_memo(scene, |memo| memo.read.imagine(&[ball]).pop())?
    }

    /// Like `imagined_candidates`.
    pub fn candidates(&self, scene: &Scene, count: usize) -> Option<Vec<Candidate>> {
        self.with_memo(scene, |Memo { read, candidates, .. }| {
            // A longer list consists of different candidates.
            if count > CANDIDATES {
                return candidates_of(read, scene, count);
            }
            candidates.get_or_init(|| candidates_of(read, scene, CANDIDATES)).clone()
        })?
    }

    /// Like `agents::start`.
    pub fn start(&self, scene: &Scene, seed: u64, count: usize) -> Box<dyn Agent> {
        start_from(self.candidates(scene, count), &self.nets, scene, seed, count)
    }

    /// Starts the model on a scene, with what a memory says about its balls; `None` if the weights have no dynamics
    /// net.
    pub fn start_with(&self, scene: &Scene, count: usize, recollection: &Recollection) -> Option<Box<dyn Agent>> {
        let candidates = self.candidates(scene, count)?;
        let candidates = self.with_memo(scene, |memo| remembered(candidates, &memo.read, scene, recollection))?;
        Some(Box::new(OnlineAgent::new(candidates, Similarity::OF_BALLS)))
    }

    /// Like `agents::propose`.
    pub fn propose(&self, scene: &Scene, seed: u64, count: usize) -> Vec<Proposal> {
        propose_from(self.candidates(scene, CANDIDATES), &self.nets, scene, seed, count)
    }

    /// Calls `ask` with the results for a scene, which is read first unless it was the last; `None` without a dynamics
    /// net.
    fn with_memo<Answer>(&self, scene: &Scene, ask: impl FnOnce(&Memo) -> Answer) -> Option<Answer> {
        let mut last = self.last.borrow_mut();
        if last.as_ref().is_none_or(|memo| memo.scene != *scene) {
            let read = self.nets.read(scene);
            *last = read.map(|read| Memo { scene: scene.clone(), read, candidates: OnceCell::new() });
        }
        last.as_ref().map(ask)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::agents::imagined_candidates::imagined_candidates;
    use crate::agents::imagined_candidates::tests::IMAGINED;
    use crate::agents::{propose, start};
    use crate::nets::DynamicsNet;
    use crate::puzzle::task::Task;

    fn scene(id: &str) -> Scene {
        Task::load(id.parse().expect("an id")).expect("a task").scene
    }

    /// Returns how many balls a function imagines.
    fn imagined(act: impl FnOnce()) -> usize {
        let before = IMAGINED.get();
        act();
        IMAGINED.get() - before
    }

    #[test]
    fn the_candidates_of_a_scene_are_imagined_once() {
        let mut nets = PathNet::fresh(0);
        nets.dynamics = Some(DynamicsNet::fresh(0));
        let [first, second] = ["00002:007", "00007:008"].map(scene);
        let candidates = imagined_candidates(&nets, &first, 100);
        let proposals = propose(&nets, &first, 0, 100);
        let tried = start(&nets, &first, 0, 100).propose();
        let longer = propose(&nets, &first, 0, CANDIDATES + 1);
        let alone = imagined(|| drop(imagined_candidates(&nets, &first, 100)));
        assert!(alone >= CANDIDATES, "{alone}");

        let model = MemoizedModel::new(nets);
        let all = imagined(|| {
            assert_eq!(model.candidates(&first, 100), candidates);
            assert_eq!(model.propose(&first, 0, 100), proposals);
            assert_eq!(model.start(&first, 0, 100).propose(), tried);
        });
        assert_eq!(all, alone);
        assert_eq!(model.propose(&first, 0, CANDIDATES + 1), longer);
        assert_ne!(model.candidates(&second, 100), candidates);
        assert_eq!(model.candidates(&first, 100), candidates);
    }

    #[test]
    fn nets_without_a_dynamics_net_propose_as_without_a_memo() {
        let scene = scene("00002:007");
        let model = MemoizedModel::new(PathNet::fresh(0));
        assert_eq!(model.candidates(&scene, 100), None);
        assert_eq!(model.propose(&scene, 3, 10), propose(&model.nets, &scene, 3, 10));
    }
}

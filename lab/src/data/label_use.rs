//! Rules for which labelled balls a net may learn from, so that nothing about its test tasks leaks into training.

use pathlight::benchmark::folds::{FoldId, Setup};
use pathlight::nets::LearnedFrom;

/// Origin of the balls of a file.
#[derive(Clone, Copy, Debug)]
pub struct LabelOrigin {
    /// The fold whose training tasks alone were used; `None` if all tasks were used.
    pub training_tasks_of: Option<FoldId>,
    /// The net that proposed the balls; `None` if they were sampled, uniformly and around known solutions.
    pub proposer: Option<Proposer>,
}

/// Training data of the net that proposed the balls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Proposer {
    pub learned_from: LearnedFrom,
    /// Whether the dev tasks of its fold were left out.
    pub without_dev: bool,
}

/// Why a net may not learn from a file. The text follows the name of the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    NetOfUnknownFold,
    NetKnowsAllTemplates,
    NetKnowsDevTasks,
    OtherFold { of: FoldId, learner: FoldId },
}

/// Checks whether a net of the fold `learner` may learn from a file. With `without_dev`, the net may not learn from the
/// fold's dev tasks.
///
/// | balls were | using the training tasks of | the learner's setup | allowed? |
/// | --- | --- | --- | --- |
/// | proposed by a net of random scenes | any fold, or all tasks | any | yes |
/// | proposed by a net of unlisted tasks | any fold, or all tasks | within | yes |
/// | proposed by a net of unlisted tasks | any fold, or all tasks | cross | no: the net has seen the test templates |
/// | proposed by a net of tasks | an unknown fold | any | no: the net may have seen the learner's test tasks |
/// | proposed by a net of tasks | another fold | any | no: the net has seen test tasks of the learner |
/// | proposed by a net of tasks | its fold | any | yes |
/// | proposed by a net of tasks, also dev tasks | its fold | any, without dev tasks | no |
/// | proposed by a net of tasks, not dev tasks | its fold | any, without dev tasks | yes |
/// | sampled | any fold, or all tasks | cross | yes: they depend only on solutions of their own template |
/// | sampled | its fold, or all tasks | within | yes, except balls near solutions of tasks outside its training tasks |
/// | sampled | another fold | within | no: solutions of test tasks influenced where balls were sampled |
///
/// From an allowed file, a net learns only from balls in training tasks, in unlisted tasks of their templates and in
/// random scenes. Balls that were sampled around a solution of a task outside its training tasks are left out.
///
/// # Errors
/// If the net may not learn from the file.
pub fn may_learn(origin: LabelOrigin, learner: FoldId, without_dev: bool) -> Result<(), Refusal> {
    match (origin.proposer, origin.training_tasks_of) {
        (Some(proposer), _) if proposer.learned_from.serves_all_folds(learner.setup) => Ok(()),
        (Some(Proposer { learned_from: LearnedFrom::UnlistedTasks, .. }), _) => Err(Refusal::NetKnowsAllTemplates),
        (Some(_), None) => Err(Refusal::NetOfUnknownFold),
        (None, _) if learner.setup == Setup::Cross => Ok(()),
        (_, Some(of)) if of != learner => Err(Refusal::OtherFold { of, learner }),
        (Some(Proposer { without_dev: false, .. }), _) if without_dev => Err(Refusal::NetKnowsDevTasks),
        _ => Ok(()),
    }
}

impl std::fmt::Display for Refusal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Refusal::NetOfUnknownFold => f.write_str(
                "does not name the fold of the net that proposed its balls: label again with --setup and --fold",
            ),
            Refusal::NetKnowsAllTemplates => f.write_str(
                "holds balls proposed by a net that has learned from unlisted tasks of every template: only a net \
                 within templates may learn from them",
            ),
            Refusal::NetKnowsDevTasks => f.write_str(
                "holds balls proposed by a net that may have learned from the fold's dev tasks: leave it out, or label \
                 again with weights from `pathlight-lab train dynamics --without-dev`",
            ),
            Refusal::OtherFold { of, learner } => write!(
                f,
                "holds balls of the training tasks of {} {} only: label those of {} {}",
                of.setup, of.fold, learner.setup, learner.fold
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WITHIN: FoldId = FoldId { setup: Setup::Within, fold: 3 };
    const CROSS: FoldId = FoldId { setup: Setup::Cross, fold: 3 };
    const OTHER: FoldId = FoldId { setup: Setup::Within, fold: 4 };

    #[test]
    fn a_net_learns_from_nothing_that_knows_what_it_must_not() {
        use Refusal::{NetKnowsAllTemplates, NetKnowsDevTasks, NetOfUnknownFold, OtherFold};
        let of = |learned_from, without_dev| Proposer { learned_from, without_dev };
        let (of_tasks, of_train) = (of(LearnedFrom::Tasks, false), of(LearnedFrom::Tasks, true));
        let (of_random, of_unlisted) = (of(LearnedFrom::RandomScenes, false), of(LearnedFrom::UnlistedTasks, false));
        for learner in [WITHIN, CROSS] {
            let told = |proposer, training_tasks_of, without_dev| {
                may_learn(LabelOrigin { training_tasks_of, proposer }, learner, without_dev)
            };
            let other = Err(OtherFold { of: OTHER, learner });
            for without_dev in [false, true] {
                for of in [None, Some(WITHIN), Some(CROSS), Some(OTHER)] {
                    assert_eq!(told(Some(of_random), of, without_dev), Ok(()));
                    let expected = if learner == WITHIN { Ok(()) } else { Err(NetKnowsAllTemplates) };
                    assert_eq!(told(Some(of_unlisted), of, without_dev), expected);
                }
                assert_eq!(told(Some(of_tasks), None, without_dev), Err(NetOfUnknownFold));
                assert_eq!(told(Some(of_train), Some(OTHER), without_dev), other);
                assert_eq!(told(Some(of_train), Some(learner), without_dev), Ok(()));
                assert_eq!(told(None, None, without_dev), Ok(()));
                assert_eq!(told(None, Some(learner), without_dev), Ok(()));
                assert_eq!(told(None, Some(OTHER), without_dev), if learner == CROSS { Ok(()) } else { other.clone() });
            }
            assert_eq!(told(Some(of_tasks), Some(learner), false), Ok(()));
            assert_eq!(told(Some(of_tasks), Some(learner), true), Err(NetKnowsDevTasks));
        }
    }
}

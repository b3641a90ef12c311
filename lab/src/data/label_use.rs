//! Which labelled balls a net may learn from, so that it learns nothing of the tasks that it is tested on.

use pathlight::benchmark::folds::{FoldId, Setup};

/// Where the balls of a file come from.
#[derive(Clone, Copy, Debug)]
pub struct LabelOrigin {
    /// The fold whose training tasks alone were used; `None` if all tasks were.
    pub training_tasks_of: Option<FoldId>,
    /// The net that proposed them; `None` if they were sampled, uniformly and around known solutions.
    pub proposer: Option<Proposer>,
}

/// What the net that proposed balls has learned from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Proposer {
    /// Random scenes alone, so it knows no task.
    RandomScenes,
    /// Training tasks of the fold, with or without its dev tasks.
    Tasks { without_dev: bool },
}

/// Why a net may not learn from a file; follows the name of the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    NetOfUnknownFold,
    NetKnowsDevTasks,
    OtherFold { of: FoldId, learner: FoldId },
}

/// Whether a net may learn from a file. It is one of the fold `learner`, and `without_dev` if it may not learn from
/// the fold's dev tasks.
///
/// | balls were | using the training tasks of | the learner's setup | may it? |
/// | --- | --- | --- | --- |
/// | proposed by a net that knows no task | any fold, or all tasks | any | yes |
/// | proposed by a net | an unknown fold | any | no: the net may know the learner's test tasks |
/// | proposed by a net | another fold | any | no: the net knows test tasks of the learner |
/// | proposed by a net | its fold | any | yes |
/// | proposed by a net that knows the dev tasks | its fold | any, without dev tasks | no |
/// | proposed by a net without dev tasks | its fold | any, without dev tasks | yes |
/// | sampled | any fold, or all tasks | cross | yes: they come from solutions of their own template alone |
/// | sampled | its fold, or all tasks | within | yes, but for balls near solutions of other tasks than its own |
/// | sampled | another fold | within | no: solutions of test tasks steered where balls lie |
///
/// Of a file that may be used, a net learns only from balls in training tasks, in unlisted tasks of their templates
/// and in random scenes, and from none that was sampled around a solution of
/// a task that is not a training task.
///
/// # Errors
/// If it may not.
pub fn may_learn(origin: LabelOrigin, learner: FoldId, without_dev: bool) -> Result<(), Refusal> {
    match (origin.proposer, origin.training_tasks_of) {
        (Some(Proposer::RandomScenes), _) => Ok(()),
        (Some(Proposer::Tasks { .. }), None) => Err(Refusal::NetOfUnknownFold),
        (None, _) if learner.setup == Setup::Cross => Ok(()),
        (_, Some(of)) if of != learner => Err(Refusal::OtherFold { of, learner }),
        (Some(Proposer::Tasks { without_dev: false }), _) if without_dev => Err(Refusal::NetKnowsDevTasks),
        (Some(Proposer::Tasks { .. }) | None, _) => Ok(()),
    }
}

impl std::fmt::Display for Refusal {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Refusal::NetOfUnknownFold => f.write_str(
                "does not say which fold the net that proposed its balls belongs to: label again with --setup and \
                 --fold",
            ),
            Refusal::NetKnowsDevTasks => f.write_str(
                "does not say that the net that proposed its balls has not learned from the fold's dev tasks: leave it \
                 out, or label again with weights of `pathlight-lab train dynamics --without-dev`",
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
        use Refusal::{NetKnowsDevTasks, NetOfUnknownFold, OtherFold};
        let (of_tasks, of_train) = (Proposer::Tasks { without_dev: false }, Proposer::Tasks { without_dev: true });
        for learner in [WITHIN, CROSS] {
            let told = |proposer, training_tasks_of, without_dev| {
                may_learn(LabelOrigin { training_tasks_of, proposer }, learner, without_dev)
            };
            let other = Err(OtherFold { of: OTHER, learner });
            for without_dev in [false, true] {
                for of in [None, Some(WITHIN), Some(CROSS), Some(OTHER)] {
                    assert_eq!(told(Some(Proposer::RandomScenes), of, without_dev), Ok(()));
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

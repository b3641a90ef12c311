//! Which labelled balls a net may learn from, so that it learns nothing of the tasks that it is tested on.

use pathlight::benchmark::folds::{FoldId, Setup};

/// Where the balls of a file come from.
#[derive(Clone, Copy, Debug)]
pub struct LabelOrigin {
    /// The fold whose training tasks alone were used; `None` if all tasks were.
    pub training_tasks_of: Option<FoldId>,
    /// How the balls were chosen.
    pub choice: Choice,
}

/// How the balls of a file were chosen.
#[derive(Clone, Copy, Debug)]
pub enum Choice {
    /// Sampled, uniformly and around known solutions. `tells_siblings`: the file says around solutions of which tasks.
    Sampled { tells_siblings: bool },
    /// Proposed by a net.
    Proposed(Proposer),
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
    UnknownSiblings,
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
/// | sampled | its fold | within | yes |
/// | sampled | another fold | within | no: solutions of test tasks steered where balls lie |
/// | sampled, and each says around which task's solution | all tasks | within | yes, but for balls near test tasks |
/// | sampled, and they do not say | all tasks | within | no: balls near solutions of test tasks cannot be left out |
/// | sampled, and they do not say | its fold | within, without dev tasks | no: nor can those of dev tasks |
///
/// Of a file that may be used, a net learns only from balls in training tasks, in their variants, in blends of two of
/// them, in unlisted tasks of their templates and in random scenes, and from none that was sampled around a solution of
/// a task that is not a training task.
///
/// # Errors
/// If it may not.
pub fn may_learn(origin: LabelOrigin, learner: FoldId, without_dev: bool) -> Result<(), Refusal> {
    match (origin.choice, origin.training_tasks_of) {
        (Choice::Proposed(Proposer::RandomScenes), _) => Ok(()),
        (Choice::Proposed(Proposer::Tasks { .. }), None) => Err(Refusal::NetOfUnknownFold),
        (Choice::Proposed(Proposer::Tasks { .. }), Some(of)) if of != learner => {
            Err(Refusal::OtherFold { of, learner })
        }
        (Choice::Proposed(Proposer::Tasks { without_dev: false }), Some(_)) if without_dev => {
            Err(Refusal::NetKnowsDevTasks)
        }
        (Choice::Proposed(Proposer::Tasks { .. }), Some(_)) => Ok(()),
        (Choice::Sampled { .. }, _) if learner.setup == Setup::Cross => Ok(()),
        (Choice::Sampled { .. }, Some(of)) if of != learner => Err(Refusal::OtherFold { of, learner }),
        (Choice::Sampled { tells_siblings: true }, _) => Ok(()),
        (Choice::Sampled { tells_siblings: false }, Some(_)) if !without_dev => Ok(()),
        (Choice::Sampled { tells_siblings: false }, _) => Err(Refusal::UnknownSiblings),
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
            Refusal::UnknownSiblings => f.write_str(
                "does not say which balls were sampled around solutions of test or dev tasks: label the balls again",
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

    /// What a net of a fold is told about balls that were chosen so.
    fn told(choice: Choice, training_tasks_of: Option<FoldId>, learner: FoldId) -> Result<(), Refusal> {
        may_learn(LabelOrigin { training_tasks_of, choice }, learner, false)
    }

    const PROPOSED: Choice = Choice::Proposed(Proposer::Tasks { without_dev: false });
    const SAMPLED: Choice = Choice::Sampled { tells_siblings: true };
    const UNTOLD: Choice = Choice::Sampled { tells_siblings: false };

    #[test]
    fn balls_of_a_net_of_an_unknown_fold_are_refused() {
        for learner in [WITHIN, CROSS] {
            assert_eq!(told(PROPOSED, None, learner), Err(Refusal::NetOfUnknownFold));
        }
    }

    #[test]
    fn balls_of_a_net_of_another_fold_are_refused() {
        for learner in [WITHIN, CROSS] {
            assert_eq!(told(PROPOSED, Some(OTHER), learner), Err(Refusal::OtherFold { of: OTHER, learner }));
        }
    }

    #[test]
    fn balls_of_a_net_of_the_same_fold_are_taken() {
        for learner in [WITHIN, CROSS] {
            assert_eq!(told(PROPOSED, Some(learner), learner), Ok(()));
        }
    }

    #[test]
    fn a_net_that_knows_the_dev_tasks_is_refused_without_them() {
        for learner in [WITHIN, CROSS] {
            let origin = LabelOrigin { training_tasks_of: Some(learner), choice: PROPOSED };
            assert_eq!(may_learn(origin, learner, true), Err(Refusal::NetKnowsDevTasks));
        }
    }

    #[test]
    fn a_net_that_does_not_know_the_dev_tasks_is_taken_without_them() {
        for learner in [WITHIN, CROSS] {
            let choice = Choice::Proposed(Proposer::Tasks { without_dev: true });
            let origin = LabelOrigin { training_tasks_of: Some(learner), choice };
            assert_eq!(may_learn(origin, learner, true), Ok(()));
        }
    }

    #[test]
    fn balls_of_a_net_that_knows_no_task_are_taken() {
        for learner in [WITHIN, CROSS] {
            for of in [None, Some(WITHIN), Some(CROSS), Some(OTHER)] {
                let origin = LabelOrigin { training_tasks_of: of, choice: Choice::Proposed(Proposer::RandomScenes) };
                for without_dev in [false, true] {
                    assert_eq!(may_learn(origin, learner, without_dev), Ok(()));
                }
            }
        }
    }

    #[test]
    fn across_templates_all_sampled_balls_are_taken() {
        for choice in [SAMPLED, UNTOLD] {
            for of in [None, Some(WITHIN), Some(CROSS), Some(OTHER)] {
                assert_eq!(told(choice, of, CROSS), Ok(()));
            }
        }
    }

    #[test]
    fn within_templates_sampled_balls_of_the_same_fold_are_taken() {
        for choice in [SAMPLED, UNTOLD] {
            assert_eq!(told(choice, Some(WITHIN), WITHIN), Ok(()));
        }
    }

    #[test]
    fn within_templates_sampled_balls_of_another_fold_are_refused() {
        for choice in [SAMPLED, UNTOLD] {
            for of in [OTHER, CROSS] {
                assert_eq!(told(choice, Some(of), WITHIN), Err(Refusal::OtherFold { of, learner: WITHIN }));
            }
        }
    }

    #[test]
    fn within_templates_sampled_balls_of_all_tasks_are_taken_if_they_say_around_which() {
        assert_eq!(told(SAMPLED, None, WITHIN), Ok(()));
    }

    #[test]
    fn within_templates_sampled_balls_of_all_tasks_are_refused_if_they_do_not_say_around_which() {
        assert_eq!(told(UNTOLD, None, WITHIN), Err(Refusal::UnknownSiblings));
    }

    #[test]
    fn within_templates_and_without_dev_tasks_sampled_balls_are_refused_if_they_do_not_say_around_which() {
        for (choice, may) in [(SAMPLED, Ok(())), (UNTOLD, Err(Refusal::UnknownSiblings))] {
            let origin = LabelOrigin { training_tasks_of: Some(WITHIN), choice };
            assert_eq!(may_learn(origin, WITHIN, true), may);
        }
    }
}

//! The tables of nets that learned from other data: their setups, their words, and what makes them.

use pathlight::benchmark::folds::Setup;

/// A table of nets that learned from other data than those of the main results.
#[derive(Clone, Copy)]
pub enum Table {
    /// Balls that an earlier net of the same fold proposed, in the setup within.
    ProposedBalls,
    /// Random scenes alone, on the folds of the setup cross.
    RandomScenes,
}

impl Table {
    /// What makes the results.
    pub fn script(self) -> &'static str {
        match self {
            Table::ProposedBalls => "scripts/proposed-balls-table",
            Table::RandomScenes => "scripts/random-scenes-table",
        }
    }

    pub fn setup(self) -> Setup {
        match self {
            Table::ProposedBalls => Setup::Within,
            Table::RandomScenes => Setup::Cross,
        }
    }

    /// Its name, which the command that prints it and its folder have too.
    pub fn name(self) -> &'static str {
        match self {
            Table::ProposedBalls => "proposed-balls",
            Table::RandomScenes => "random-scenes",
        }
    }

    pub fn title(self) -> &'static str {
        match self {
            Table::ProposedBalls => "With proposed balls",
            Table::RandomScenes => "With random scenes",
        }
    }

    /// The heading of the column of its nets.
    pub fn column(self) -> &'static str {
        match self {
            Table::ProposedBalls => "with proposed balls",
            Table::RandomScenes => "random scenes alone",
        }
    }

    pub fn introduction(self) -> &'static str {
        match self {
            Table::ProposedBalls => {
                "Each dynamics net first learned from sampled balls in the training tasks and in variants of them; the \
                 known solutions are [uniform](../../docs/reproducing.md#data). Then it proposed balls in its training \
                 tasks and in [blends](../../docs/glossary.md) of them, and was trained further on the sampled and the \
                 proposed balls. The nets of the [main results](../README.md) learned from sampled balls in the \
                 training tasks alone, in fewer epochs. All these nets learned from the training tasks and from \
                 scenes made of them alone, so these results can be compared with published ones as the main results \
                 can."
            }
            Table::RandomScenes => {
                "One dynamics net learned from random scenes alone, which have no template. It has seen no task, so \
                 the test tasks of all folds are new to it. The nets of the [main results](../README.md) learned from \
                 training tasks alone, in fewer batches."
            }
        }
    }
}

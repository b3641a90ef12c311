//! PHYRE's ten folds in two setups, which divide the tasks into training and test tasks.
//!
//! `within` trains on four fifths of the tasks of each template and tests on the remaining fifth. `cross` trains on
//! four fifths of the templates and tests on the remaining fifth. One fifth of the training part is the dev part. All
//! parts are cut from lists shuffled by PHYRE's `stable_shuffle`, with PHYRE's salts.

use std::fmt;

use serde::{Deserialize, Serialize};

use crate::puzzle::stable_shuffle::stable_shuffle;
use crate::puzzle::task::{TaskId, ids};
use crate::puzzle::templates::TEMPLATES;

/// Number of folds in each setup.
pub const FOLDS: u8 = 10;

/// What an agent must generalise to (PHYRE's evaluation setups).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Setup {
    /// New tasks of templates that it was trained on.
    #[default]
    Within,
    /// New templates.
    Cross,
}

impl fmt::Display for Setup {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Setup::Within => "within",
            Setup::Cross => "cross",
        })
    }
}

/// A fold, identified by its setup and number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct FoldId {
    /// What an agent must generalise to.
    pub setup: Setup,
    /// `0..FOLDS`
    pub fold: u8,
}

impl FoldId {
    /// All folds, within before cross, ascending.
    pub fn all() -> impl Iterator<Item = FoldId> {
        [Setup::Within, Setup::Cross].into_iter().flat_map(|setup| (0..FOLDS).map(move |fold| FoldId { setup, fold }))
    }

    /// Returns the tasks of the fold.
    ///
    /// ```
    /// use pathlight::benchmark::folds::{FoldId, Setup};
    ///
    /// let fold = FoldId { setup: Setup::Cross, fold: 0 }.tasks();
    /// assert_eq!(fold.test.len(), 500);
    /// ```
    pub fn tasks(self) -> Fold {
        Fold::new(self.setup, self.fold)
    }
}

/// Formats the fold as in file names: `within-0`.
impl fmt::Display for FoldId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}-{}", self.setup, self.fold)
    }
}

/// The task ids of one fold. `dev` and `train` together are PHYRE's training tasks: settings are chosen on
/// `dev`, never on `test`.
#[derive(Clone, Debug, PartialEq)]
pub struct Fold {
    /// Tasks to train on.
    pub train: Vec<TaskId>,
    /// Tasks to choose settings on.
    pub dev: Vec<TaskId>,
    /// Tasks to measure on, once.
    pub test: Vec<TaskId>,
}

impl Fold {
    /// Returns the fold of this setup and number, `0..FOLDS`.
    pub fn new(setup: Setup, fold: u8) -> Fold {
        match setup {
            Setup::Within => within(fold),
            Setup::Cross => cross(fold),
        }
    }

    /// PHYRE's training tasks: `train` and `dev`.
    pub fn all_train(&self) -> Vec<TaskId> {
        let mut tasks = [self.train.as_slice(), &self.dev].concat();
        tasks.sort();
        tasks
    }
}

fn within(fold: u8) -> Fold {
    let (mut train, mut test) = (vec![], vec![]);
    for template in TEMPLATES {
        let mut tasks = stable_shuffle(ids(template).collect(), &format!("ball_online_ind_tasks{fold}"));
        test.extend(tasks.split_off(four_fifths(tasks.len())));
        train.extend(tasks);
    }
    let mut train = stable_shuffle(train, &format!("make_dev{fold}"));
    let dev = train.split_off(four_fifths(train.len()));
    Fold { train: sorted(train), dev: sorted(dev), test: sorted(test) }
}

fn cross(fold: u8) -> Fold {
    let numbers = (0..TEMPLATES.len()).map(TemplateNumber).collect();
    let mut train = stable_shuffle(numbers, &format!("ball_cross_template_half_{fold}"));
    let test = train.split_off(four_fifths(train.len()));
    let mut train = stable_shuffle(train, &format!("dev_ball_cross_template_half_{fold}"));
    let dev = train.split_off(four_fifths(train.len()));
    let tasks = |numbers: Vec<TemplateNumber>| {
        sorted(numbers.iter().flat_map(|&TemplateNumber(number)| ids(TEMPLATES[number])).collect())
    };
    Fold { train: tasks(train), dev: tasks(dev), test: tasks(test) }
}

/// Returns PHYRE's training share of a list of 100 tasks, 25 templates, 20 templates or 2,000 tasks.
fn four_fifths(count: usize) -> usize {
    count * 4 / 5
}

/// A template's number as PHYRE hashes it: five digits.
#[derive(Clone, Copy)]
struct TemplateNumber(usize);

impl fmt::Display for TemplateNumber {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:05}", self.0)
    }
}

fn sorted(mut tasks: Vec<TaskId>) -> Vec<TaskId> {
    tasks.sort();
    tasks
}

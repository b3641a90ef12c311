//! The benchmark's ten folds: which tasks an agent trains on and which it is tested on.
//!
//! `within`: 80 tasks of each template train, the other 20 test. `cross`: 20 templates train, the other 5
//! test. Lists are shuffled as PHYRE does it: sorted by the MD5 of the item's text followed by a salt.

use std::fmt;

use md5::{Digest, Md5};
use serde::{Deserialize, Serialize};

use crate::puzzle::task::{TaskId, ids};
use crate::puzzle::templates::TEMPLATES;

/// Folds of each setup.
pub const FOLDS: u8 = 10;

/// What an agent has to generalise to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Setup {
    /// To new tasks of the templates it knows.
    Within,
    /// To new templates.
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

/// The task ids of one fold. `dev` and `train` together are PHYRE's training tasks: settings are chosen on
/// `dev`, never on `test`.
#[derive(Clone, Debug, PartialEq)]
pub struct Fold {
    pub train: Vec<TaskId>,
    pub dev: Vec<TaskId>,
    pub test: Vec<TaskId>,
}

impl Fold {
    /// The fold of this setup and number, 0..=9.
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
        let tasks = shuffled(ids(template).collect(), &format!("ball_online_ind_tasks{fold}"));
        train.extend_from_slice(&tasks[..80]);
        test.extend_from_slice(&tasks[80..]);
    }
    let mut train = shuffled(train, &format!("make_dev{fold}"));
    let dev = train.split_off(1600);
    Fold { train: sorted(train), dev: sorted(dev), test: sorted(test) }
}

fn cross(fold: u8) -> Fold {
    let numbers = (0..TEMPLATES.len()).map(Number).collect();
    let mut train = shuffled(numbers, &format!("ball_cross_template_half_{fold}"));
    let test = train.split_off(20);
    let mut train = shuffled(train, &format!("dev_ball_cross_template_half_{fold}"));
    let dev = train.split_off(16);
    let tasks = |numbers: Vec<Number>| sorted(numbers.iter().flat_map(|&Number(n)| ids(TEMPLATES[n])).collect());
    Fold { train: tasks(train), dev: tasks(dev), test: tasks(test) }
}

/// A template's number, written as PHYRE hashes it.
#[derive(Clone, Copy)]
struct Number(usize);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:05}", self.0)
    }
}

fn shuffled<T: fmt::Display>(mut items: Vec<T>, salt: &str) -> Vec<T> {
    items.sort_by_cached_key(|item| <[u8; 16]>::from(Md5::digest(format!("{item}{salt}"))));
    items
}

fn sorted(mut tasks: Vec<TaskId>) -> Vec<TaskId> {
    tasks.sort();
    tasks
}

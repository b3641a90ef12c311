//! The 25 ball templates: each a story, a grid of parameters, and a short script.
//!
//! A template's combinations are shuffled by the MD5 of their number, laid out in that order, and numbered
//! as they come, those that the script skips left out; the benchmark keeps 100 of the numbers (`selected`).
//! So a task id means the same as in PHYRE v0.2.2. `task` is the way in for everyone else.

use md5::{Digest, Md5};
use serde_json::{Map, Value};

use crate::layout::{Goal, Layout};
use crate::scene::Scene;

mod t00_two_drops;

/// All templates, in the order of their numbers.
pub static TEMPLATES: [&Template; 1] = [&t00_two_drops::TEMPLATE];

/// One template of tasks.
pub struct Template {
    /// 0..=24; `00000`..`00024` when written.
    pub number: usize,
    /// Our own short name.
    pub name: &'static str,
    /// What happens and what is wanted, in one sentence.
    pub story: &'static str,
    /// Name and values of each parameter, sorted by name; the last varies fastest.
    pub grid: &'static [(&'static str, Grid)],
    /// Lays out one combination; `None` if it is skipped.
    pub script: fn(&Params, &mut Layout) -> Option<Goal>,
    /// The 100 task numbers that the benchmark keeps, ascending.
    pub selected: [u16; 100],
}

/// The values that a parameter takes.
pub enum Grid {
    /// `Lin(a, b, n)`: n values from a to b, evenly spaced.
    Lin(f64, f64, usize),
    /// `Mul(c, i, j)`: k c for k in i..=j.
    Mul(f64, i32, i32),
    /// `Ints(i, j)`: i..=j.
    Ints(i32, i32),
    List(&'static [f64]),
    /// True, then false.
    Flag,
    Words(&'static [&'static str]),
}

impl Grid {
    fn len(&self) -> usize {
        match self {
            Grid::Lin(_, _, n) => *n,
            Grid::Mul(_, i, j) | Grid::Ints(i, j) => (j - i + 1) as usize,
            Grid::List(values) => values.len(),
            Grid::Flag => 2,
            Grid::Words(words) => words.len(),
        }
    }

    fn value(&self, index: usize) -> Value {
        match *self {
            // The last value is b itself, not what rounding makes of it.
            Grid::Lin(_, b, n) if n > 1 && index == n - 1 => b.into(),
            Grid::Lin(a, b, n) if n > 1 => (a + index as f64 * ((b - a) / (n - 1) as f64)).into(),
            Grid::Lin(a, ..) => a.into(),
            Grid::Mul(c, i, _) => (f64::from(i + index as i32) * c).into(),
            Grid::Ints(i, _) => (i + index as i32).into(),
            Grid::List(values) => values[index].into(),
            Grid::Flag => (index == 0).into(),
            Grid::Words(words) => words[index].into(),
        }
    }
}

/// One value for each parameter of a template.
pub struct Params(Map<String, Value>);

impl Params {
    /// A number; integers too. Panics if the template has no such number: that is a slip in its script.
    pub fn num(&self, name: &str) -> f64 {
        self.0.get(name).and_then(Value::as_f64).unwrap_or_else(|| panic!("no number named {name}"))
    }

    /// A truth value. Panics like `num`.
    pub fn flag(&self, name: &str) -> bool {
        self.0.get(name).and_then(Value::as_bool).unwrap_or_else(|| panic!("no flag named {name}"))
    }

    /// A quoted word. Panics like `num`.
    pub fn word(&self, name: &str) -> &str {
        self.0.get(name).and_then(Value::as_str).unwrap_or_else(|| panic!("no word named {name}"))
    }

    /// Name and value of each parameter, as JSON.
    pub fn into_json(self) -> Map<String, Value> {
        self.0
    }
}

impl Template {
    /// The benchmark's tasks of this template, ascending: number, parameters and scene of each.
    pub fn tasks(&self) -> impl Iterator<Item = (u16, Params, Scene)> {
        self.numbered().filter(|(number, ..)| self.selected.binary_search(number).is_ok()).take(self.selected.len())
    }

    /// One of the benchmark's tasks, by its number.
    pub fn task(&self, number: u16) -> Option<(Params, Scene)> {
        self.selected.binary_search(&number).ok()?;
        self.numbered().nth(number.into()).map(|(_, params, scene)| (params, scene))
    }

    /// Every combination that no rule skips, in shuffled order, numbered from 0.
    fn numbered(&self) -> impl Iterator<Item = (u16, Params, Scene)> {
        let laid_out = shuffled(self.combinations()).into_iter().filter_map(|combination| {
            let params = self.params(combination);
            let mut layout = Layout::default();
            let goal = (self.script)(&params, &mut layout)?;
            Some((params, layout.scene(goal)))
        });
        (0..).zip(laid_out).map(|(number, (params, scene))| (number, params, scene))
    }

    fn combinations(&self) -> usize {
        self.grid.iter().map(|(_, values)| values.len()).product()
    }

    /// The digits of a combination's number are the indices into the grids, the last name the lowest digit.
    fn params(&self, mut combination: usize) -> Params {
        let mut params = Map::new();
        for (name, values) in self.grid.iter().rev() {
            params.insert((*name).to_string(), values.value(combination % values.len()));
            combination /= values.len();
        }
        Params(params)
    }
}

/// 0..count in the order of the MD5 of their decimal digits.
fn shuffled(count: usize) -> Vec<usize> {
    let mut numbers: Vec<usize> = (0..count).collect();
    numbers.sort_by_cached_key(|number| <[u8; 16]>::from(Md5::digest(number.to_string())));
    numbers
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_shuffle_is_by_md5_of_the_digits() {
        assert_eq!(shuffled(10), [6, 9, 7, 4, 1, 2, 8, 0, 5, 3]);
    }
}

//! The parameters of a template: the values that each takes, and one combination of them.
//!
//! Used by the template scripts. How a value is computed is part of what a task id means, down to the last
//! bit: some rules of the scripts are met with equality.

use serde_json::{Map, Value};

/// The values that a parameter takes.
pub enum Grid {
    /// `Lin(a, b, n)`: n values from a to b, evenly spaced.
    Lin(f64, f64, usize),
    /// `Mul(c, i, j)`: k c for k in i..=j.
    Mul(f64, i32, i32),
    /// `Ints(i, j)`: i..=j.
    Ints(i32, i32),
    /// These numbers.
    List(&'static [f64]),
    /// True, then false.
    Flag,
    /// These words.
    Words(&'static [&'static str]),
}

impl Grid {
    /// How many values there are.
    pub(super) fn len(&self) -> usize {
        match self {
            Grid::Lin(_, _, n) => *n,
            Grid::Mul(_, i, j) | Grid::Ints(i, j) => (j - i + 1) as usize,
            Grid::List(values) => values.len(),
            Grid::Flag => 2,
            Grid::Words(words) => words.len(),
        }
    }

    /// One of them, counted from 0.
    pub(super) fn value(&self, index: usize) -> Value {
        match *self {
            Grid::Lin(a, b, n) => evenly(a, b, n, index).into(),
            Grid::Mul(c, i, _) => (f64::from(i + index as i32) * c).into(),
            Grid::Ints(i, _) => (i + index as i32).into(),
            Grid::List(values) => values[index].into(),
            Grid::Flag => (index == 0).into(),
            Grid::Words(words) => words[index].into(),
        }
    }
}

/// Value `index` of `n` evenly spaced ones from a to b; the last is b itself, not what rounding makes of it.
pub fn evenly(a: f64, b: f64, n: usize, index: usize) -> f64 {
    match (n, index) {
        (1, _) => a,
        _ if index == n - 1 => b,
        _ => a + index as f64 * ((b - a) / (n - 1) as f64),
    }
}

/// One value for each parameter of a template.
pub struct Params(Map<String, Value>);

impl Params {
    /// The digits of a combination's number are the indices into the grids, the last name the lowest digit.
    pub(super) fn of(grid: &[(&str, Grid)], mut combination: usize) -> Params {
        let mut params = Map::new();
        for (name, values) in grid.iter().rev() {
            params.insert((*name).to_string(), values.value(combination % values.len()));
            combination /= values.len();
        }
        Params(params)
    }

    /// A number; integers too. Panics if the template has no such number: that is a slip in its script.
    pub fn num(&self, name: &str) -> f64 {
        self.0.get(name).and_then(Value::as_f64).unwrap_or_else(|| panic!("no number named {name}"))
    }

    /// An integer. Panics like `num`.
    pub fn int(&self, name: &str) -> usize {
        let value = self.0.get(name).and_then(Value::as_u64);
        value.and_then(|value| value.try_into().ok()).unwrap_or_else(|| panic!("no integer named {name}"))
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

//! The parameter grid of a template: the values of each parameter, and one combination of them.
//!
//! Used by the template scripts. A task id depends on every bit of these values, because some rules of the scripts
//! compare them for equality.

use serde_json::{Map, Value};

/// The values of a parameter.
pub enum Grid {
    /// `Lin(a, b, n)`: n values from a to b, evenly spaced.
    Lin(f64, f64, usize),
    /// `Mul(c, i, j)`: k c for k in i..=j.
    Mul(f64, i32, i32),
    /// `Ints(i, j)`: i..=j.
    Ints(i32, i32),
    /// The given numbers.
    List(&'static [f64]),
    /// True, then false.
    Flag,
    /// The given words.
    Words(&'static [&'static str]),
}

impl Grid {
    /// Returns the number of values.
    pub(super) fn len(&self) -> usize {
        match self {
            Grid::Lin(_, _, n) => *n,
            Grid::Mul(_, i, j) | Grid::Ints(i, j) => (j - i + 1) as usize,
            Grid::List(values) => values.len(),
            Grid::Flag => 2,
            Grid::Words(words) => words.len(),
        }
    }

    /// Returns the value at an index, from 0.
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

/// Returns value `index` of `n` evenly spaced values from a to b (NumPy's `linspace`); the last is exactly b.
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
    /// Decodes the number of a combination. Its digits are the indices into the grid; the last parameter is the lowest
    /// digit.
    pub(super) fn of(grid: &[(&str, Grid)], mut combination: usize) -> Params {
        let mut params = Map::new();
        for (name, values) in grid.iter().rev() {
            params.insert((*name).to_string(), values.value(combination % values.len()));
            combination /= values.len();
        }
        Params(params)
    }

    /// Returns a number, which may be an integer. Panics if the template has no number of this name, which means that
    /// its script is wrong.
    pub fn num(&self, name: &str) -> f64 {
        self.0.get(name).and_then(Value::as_f64).unwrap_or_else(|| panic!("no number named {name}"))
    }

    /// Returns an integer. Panics like `num`.
    pub fn int(&self, name: &str) -> usize {
        let value = self.0.get(name).and_then(Value::as_u64);
        value.and_then(|value| value.try_into().ok()).unwrap_or_else(|| panic!("no integer named {name}"))
    }

    /// Returns a boolean. Panics like `num`.
    pub fn flag(&self, name: &str) -> bool {
        self.0.get(name).and_then(Value::as_bool).unwrap_or_else(|| panic!("no flag named {name}"))
    }

    /// Returns a word. Panics like `num`.
    pub fn word(&self, name: &str) -> &str {
        self.0.get(name).and_then(Value::as_str).unwrap_or_else(|| panic!("no word named {name}"))
    }

    /// Returns the name and value of each parameter as JSON.
    pub fn into_json(self) -> Map<String, Value> {
        self.0
    }
}

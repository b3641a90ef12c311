//! The 25 ball templates: each a story, a grid of parameters, and a short script.
//!
//! A template's combinations are shuffled by the MD5 of their number, laid out in that order, and numbered
//! as they come, those that the script skips left out; the benchmark keeps 100 of the numbers (`selected`).
//! So a task id means the same as in PHYRE v0.2.2. `task` is the way in for everyone else.

use md5::{Digest, Md5};

use crate::puzzle::scene::Scene;
use grid::Grid::{self, Flag, Ints, Lin, List, Mul, Words};
use grid::{Params, evenly};
use selection::kept;

pub mod grid;
mod numpy;
mod selection;
mod t00_two_drops;
mod t01_tray_with_lips;
mod t02_awning;
mod t03_topple_to_the_wall;
mod t04_seesaw_catch;
mod t05_miss_the_jar;
mod t06_jar_through_the_gap;
mod t07_funnel;
mod t08_stairs_and_jar;
mod t09_off_the_ledge;
mod t10_spill_into_the_valley;
mod t11_two_slopes;
mod t12_switchback_pegs;
mod t13_peg_thicket;
mod t14_over_the_divide;
mod t15_cradle;
mod t16_ski_jump;
mod t17_ball_on_a_post;
mod t18_covered_ball;
mod t19_chaperone;
mod t20_louvers;
mod t21_teeter_gap;
mod t22_tip_into_the_jar;
mod t23_rolling_bridge;
mod t24_hole_and_plug;

/// All templates, in the order of their numbers.
pub static TEMPLATES: [&Template; 25] = [
    &t00_two_drops::TEMPLATE,
    &t01_tray_with_lips::TEMPLATE,
    &t02_awning::TEMPLATE,
    &t03_topple_to_the_wall::TEMPLATE,
    &t04_seesaw_catch::TEMPLATE,
    &t05_miss_the_jar::TEMPLATE,
    &t06_jar_through_the_gap::TEMPLATE,
    &t07_funnel::TEMPLATE,
    &t08_stairs_and_jar::TEMPLATE,
    &t09_off_the_ledge::TEMPLATE,
    &t10_spill_into_the_valley::TEMPLATE,
    &t11_two_slopes::TEMPLATE,
    &t12_switchback_pegs::TEMPLATE,
    &t13_peg_thicket::TEMPLATE,
    &t14_over_the_divide::TEMPLATE,
    &t15_cradle::TEMPLATE,
    &t16_ski_jump::TEMPLATE,
    &t17_ball_on_a_post::TEMPLATE,
    &t18_covered_ball::TEMPLATE,
    &t19_chaperone::TEMPLATE,
    &t20_louvers::TEMPLATE,
    &t21_teeter_gap::TEMPLATE,
    &t22_tip_into_the_jar::TEMPLATE,
    &t23_rolling_bridge::TEMPLATE,
    &t24_hole_and_plug::TEMPLATE,
];

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
    pub script: fn(&Params) -> Option<Scene>,
    /// The 100 task numbers that the benchmark keeps, ascending.
    pub selected: [u16; 100],
}

/// Leaves the combination out if the rule holds; a script says `skip(rule)?`.
fn skip(rule: bool) -> Option<()> {
    (!rule).then_some(())
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

    /// The valid combinations with their task numbers. Endless numbering would outgrow 16 bits; nobody asks
    /// for more than the last task that is kept.
    fn numbered(&self) -> impl Iterator<Item = (u16, Params, Scene)> {
        (0..).zip(self.valid()).map(|(number, (_, params, scene))| (number, params, scene))
    }

    /// Every combination that no rule skips, in shuffled order: its number, its parameters and its scene.
    fn valid(&self) -> impl Iterator<Item = (usize, Params, Scene)> {
        shuffled(self.combinations()).into_iter().filter_map(|combination| {
            let params = Params::of(self.grid, combination);
            let scene = (self.script)(&params)?;
            Some((combination, params, scene))
        })
    }

    fn combinations(&self) -> usize {
        self.grid.iter().map(|(_, values)| values.len()).product()
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
    fn the_table_is_in_order() {
        for (number, template) in TEMPLATES.iter().enumerate() {
            assert_eq!(template.number, number, "{}", template.name);
            assert!(template.grid.is_sorted_by_key(|(name, _)| *name), "the parameters of {}", template.name);
        }
    }

    #[test]
    fn the_shuffle_is_by_md5_of_the_digits() {
        assert_eq!(shuffled(10), [6, 9, 7, 4, 1, 2, 8, 0, 5, 3]);
        assert_eq!(shuffled(20), [6, 19, 9, 11, 18, 17, 7, 15, 4, 14, 12, 1, 13, 16, 2, 8, 0, 10, 5, 3]);
    }

    /// Of each template: combinations, how many are valid, and the combination that is task 000; in PHYRE.
    const FIGURES: [(usize, usize, usize); 25] = [
        (16245, 4690, 1970),
        (2560, 1848, 363),
        (385, 245, 168),
        (400, 320, 363),
        (6720, 4320, 1970),
        (324, 315, 168),
        (6400, 448, 4527),
        (400, 360, 363),
        (1600, 636, 363),
        (2560, 1280, 1970),
        (540, 540, 363),
        (10000, 9040, 5329),
        (1000, 1000, 363),
        (300, 300, 168),
        (640, 640, 363),
        (500, 500, 363),
        (900, 900, 363),
        (625, 625, 363),
        (1350, 1242, 363),
        (65536, 65536, 5329),
        (400, 200, 363),
        (405, 126, 363),
        (36000, 30300, 5329),
        (11700, 7020, 5329),
        (960, 696, 363),
    ];

    #[test]
    fn as_many_combinations_are_valid_as_in_phyre() {
        for (template, expected) in TEMPLATES.iter().zip(FIGURES) {
            let mut valid = template.valid().map(|(combination, ..)| combination);
            let first = valid.next().expect("a template has tasks");
            assert_eq!((template.combinations(), 1 + valid.count(), first), expected, "{}", template.name);
        }
    }
}

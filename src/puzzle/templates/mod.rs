//! The 25 ball templates of PHYRE v0.2.2: each a story, a grid of parameters, and a short script.
//!
//! PHYRE's `stable_shuffle` orders all combinations of parameters, and a task number is the position of a combination
//! among the valid ones. The benchmark keeps 100 of a template's tasks. A template lists their numbers and their
//! combinations, so that a task can be laid out directly; the test below derives the combinations independently. Other
//! modules use `task` as the entry point.

use crate::puzzle::scene::Scene;
use grid::Grid::{self, Flag, Ints, Lin, List, Mul, Words};
use grid::{Params, evenly};
use task_numbers::task_numbers;

pub mod grid;
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
mod task_numbers;

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

/// One template: tasks that differ only in their parameters.
pub struct Template {
    /// 0..=24; `00000`..`00024` when written.
    pub number: usize,
    /// This project's short name for it.
    pub name: &'static str,
    /// The situation and the goal in one sentence.
    pub story: &'static str,
    /// Name and values of each parameter, sorted by name; the last varies fastest.
    pub grid: &'static [(&'static str, Grid)],
    /// Lays out one combination of parameters; `None` if one of PHYRE's rules skips it.
    pub script: fn(&Params) -> Option<Scene>,
    /// The numbers of the benchmark's 100 tasks, ascending.
    pub task_numbers: [u16; TASKS],
    /// The combination of each of these tasks. Its digits are the indices into the grid; the last parameter is the
    /// lowest digit.
    pub combinations: [u16; TASKS],
}

/// Number of the benchmark's tasks per template.
pub const TASKS: usize = 100;

/// Skips the combination if the rule holds; scripts call `skip(rule)?`.
fn skip(rule: bool) -> Option<()> {
    (!rule).then_some(())
}

impl Template {
    /// Returns the parameters and scene of one of the benchmark's tasks, by its number; `None` if the number is not
    /// among them.
    pub fn task(&self, number: u16) -> Option<(Params, Scene)> {
        let index = self.task_numbers.binary_search(&number).ok()?;
        self.lay_out(self.combinations[index].into())
    }

    /// Returns the number of combinations of the parameters, including those that a rule skips.
    pub fn combinations(&self) -> u32 {
        self.grid.iter().map(|(_, values)| values.len() as u32).product()
    }

    /// Returns the scene of a combination that is not one of the benchmark's tasks; `None` if it is one, if a rule
    /// skips it, or if there is no such combination.
    pub fn unlisted(&self, combination: u32) -> Option<Scene> {
        if combination >= self.combinations() {
            return None;
        }
        let is_listed = self.combinations.iter().any(|&listed| u32::from(listed) == combination);
        let (_, scene) = self.lay_out(combination as usize).filter(|_| !is_listed)?;
        Some(scene)
    }

    /// Lays out one combination; `None` if a rule skips it.
    fn lay_out(&self, combination: usize) -> Option<(Params, Scene)> {
        let params = Params::of(self.grid, combination);
        let scene = (self.script)(&params)?;
        Some((params, scene))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::stable_shuffle::stable_shuffle;

    #[test]
    fn there_are_no_unlisted_tasks_beyond_the_last_combination() {
        for template in TEMPLATES {
            let listed = u32::from(template.combinations[0]);
            assert!(template.unlisted(listed).is_none());
            assert!(template.unlisted(template.combinations() + listed).is_none());
        }
    }

    #[test]
    fn the_table_is_in_order() {
        for (number, template) in TEMPLATES.iter().enumerate() {
            assert_eq!(template.number, number, "{}", template.name);
            assert!(template.grid.is_sorted_by_key(|(name, _)| *name), "the parameters of {}", template.name);
        }
    }

    /// For each template in PHYRE: combinations, valid combinations, and the combination of task 000.
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

    /// PHYRE's numbering: task n is the n-th combination, in the order of the shuffle, that no rule skips.
    #[test]
    fn numbers_and_combinations_of_tasks_follow_from_the_shuffle() {
        for (template, (combinations, valid, first)) in TEMPLATES.iter().zip(FIGURES) {
            let count = template.combinations() as usize;
            let mut numbered = stable_shuffle((0..count).collect(), "");
            numbered.retain(|&combination| template.lay_out(combination).is_some());
            assert_eq!((count, numbered.len(), numbered[0]), (combinations, valid, first), "{}", template.name);
            let derived = template.task_numbers.map(|number| numbered[usize::from(number)]);
            assert_eq!(template.combinations.map(usize::from), derived, "the combinations of {}", template.name);
        }
    }
}

//! The shipped counts of src/benchmark/difficulty.json belong to this simulator and cover the whole benchmark.
#![cfg(not(target_arch = "wasm32"))]

use pathlight::benchmark::difficulty::Difficulty;
use pathlight::puzzle::task;
use pathlight::puzzle::templates::TEMPLATES;
use pathlight::simulator;

#[test]
fn every_task_has_a_count_of_this_simulator() {
    let shipped = Difficulty::shipped();
    assert_eq!(
        shipped.simulator,
        simulator::VERSION,
        "run `pathlight-lab data difficulty > src/benchmark/difficulty.json` again"
    );
    for template in TEMPLATES {
        let rates: Vec<f64> = task::ids(template).filter_map(|id| shipped.solve_rate(id)).collect();
        assert_eq!(rates.len(), template.task_numbers.len(), "{}", template.name);
        assert!(rates.iter().any(|&rate| rate > 0.0), "{}: no ball solved any task", template.name);
    }
}

#[test]
fn the_list_of_solve_rates_is_in_the_order_of_the_tasks() {
    let shipped = Difficulty::shipped();
    let one_by_one = TEMPLATES.iter().flat_map(|template| task::ids(template)).filter_map(|id| shipped.solve_rate(id));
    assert!(shipped.solve_rates().eq(one_by_one));
}

//! Parsing task ids and loading tasks: the error for a wrong id names the reason and the remedy.
#![cfg(not(target_arch = "wasm32"))]

use pathlight::puzzle::task::{Task, TaskError, TaskId, ids};
use pathlight::puzzle::templates::TEMPLATES;
use proptest::prelude::*;

fn error_of(text: &str) -> String {
    let task = text.parse().and_then(|id: TaskId| Task::load(id));
    task.expect_err("not a task").to_string()
}

#[test]
fn an_id_loads_the_task_of_the_enumeration() {
    for template in TEMPLATES {
        let tasks: Vec<Task> = Task::of(template).collect();
        assert!(tasks.iter().map(|task| task.id).eq(ids(template)), "{}", template.name);
        for task in tasks.iter().step_by(33) {
            assert_eq!(Task::load(task.id).as_ref(), Ok(task));
        }
    }
}

#[test]
fn there_are_2500_ids() {
    let all: Vec<TaskId> = TEMPLATES.iter().flat_map(|template| ids(template)).collect();
    assert_eq!(all.len(), 2500);
    assert!(all.is_sorted_by(|a, b| a < b));
}

#[test]
fn an_unknown_task_gets_a_reason_and_a_remedy() {
    assert_eq!(error_of("7:13"), "`7:13` is not a task id: write template and number like 00007:008");
    assert_eq!(error_of("00025:000"), "unknown template `00025`: templates run from 00000 to 00024");
    assert_eq!(
        error_of("00007:000"),
        "task 00007:000 is not in the benchmark: `pathlight tasks --template 00007` lists the tasks of this template"
    );
}

#[test]
fn a_task_is_json_in_the_form_of_the_benchmark() {
    let task = Task::load("00003:000".parse().unwrap()).unwrap();
    let json = serde_json::to_value(&task).unwrap();
    assert_eq!(json["id"], "00003:000");
    assert_eq!(json["goal"], "Make sure the green bar is touching the purple bar.");
    assert_eq!((json["body1"].as_u64(), json["body2"].as_u64()), (Some(1), Some(2)));
    assert_eq!(json["bodies"].as_array().map(Vec::len), Some(3), "the walls are left out");
    let pole = &json["bodies"][1];
    assert_eq!((&pole["shape"], &pole["role"], &pole["dynamic"]), (&"bar".into(), &"green".into(), &true.into()));
    assert_eq!(pole["parts"][0]["polygon"].as_array().map(Vec::len), Some(4));
    assert!(["x", "y", "angle"].iter().all(|name| pole[name].is_f64()));
}

proptest! {
    #[test]
    fn an_id_parses_as_it_prints(template in 0_usize..100_000, number in 0_u16..1000) {
        let id = TaskId { template, number };
        prop_assert_eq!(id.to_string().parse::<TaskId>(), Ok(id));
        prop_assert_eq!(id.to_string().len(), 9);
    }

    #[test]
    fn any_other_text_is_refused(text in "[0-9:a-zµ ٣-]{0,12}") {
        match text.parse::<TaskId>() {
            Ok(id) => prop_assert_eq!(id.to_string(), text),
            Err(error) => prop_assert_eq!(error, TaskError::Malformed(text)),
        }
    }
}

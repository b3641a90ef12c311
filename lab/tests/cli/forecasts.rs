//! `pathlight-lab measure forecasts`: imagined paths and outcomes compared with simulated ones.

use tempfile::tempdir;

use super::{assert_refused, changed_weights, output_of, without_dynamics};

#[test]
fn solved_and_missed_balls_are_counted_and_imagined_better_than_at_rest() {
    let table = output_of(&["measure", "forecasts", "--limit", "1", "--balls", "4"]);
    let row = |name: &str| -> Vec<f64> {
        let line = table.lines().find_map(|line| line.strip_prefix(name)).expect("a row");
        assert_eq!(line.matches('(').count(), line.matches(')').count(), "{line}");
        let numbers = line.split_whitespace().filter_map(|word| word.trim_matches(['(', ')']).parse().ok());
        numbers.collect()
    };
    let (solved, missed) = (row("solved "), row("not solved"));
    assert_eq!((solved.len(), missed.len()), (10, 10), "{table}");
    assert!(solved[0] > 25.0 && solved[0] + missed[0] <= 25.0 * (4.0 + 10.0), "{table}");
    assert!(solved[1] > missed[1] + 10.0, "the chance tells them apart: {table}");
    assert!(solved[2] > missed[2] + 10.0, "and the paths alone do: {table}");
    for [_, _, _, object, at_rest, ball, first, .., last] in
        [solved, missed].map(|row| <[f64; 10]>::try_from(row).expect("ten"))
    {
        assert!(at_rest < object && object < 1.0 && object < ball && first < last, "{table}");
    }
}

#[test]
fn random_scenes_are_measured_too() {
    let counts = |table: &str| {
        let balls = |name: &str| {
            let line = table.lines().find_map(|line| line.strip_prefix(name)).expect("a row");
            line.split_whitespace().next().and_then(|word| word.parse::<usize>().ok()).expect("a number")
        };
        (balls("solved "), balls("not solved"))
    };
    let random = output_of(&["measure", "forecasts", "--random-scenes", "12", "--balls", "3"]);
    let (solved, missed) = counts(&random);
    assert!(random.contains("12 random scenes, 3 random balls each and solutions"), "{random}");
    assert!(solved > 0 && missed <= 12 * 3 && solved + missed >= 12 * 3, "{random}");
}

#[test]
fn weights_that_imagine_no_balls_are_refused() {
    let folder = tempdir().expect("a folder");
    assert_refused(&["measure", "forecasts", "--weights", &without_dynamics(folder.path())], "have no dynamics net");
}

#[test]
fn dev_tasks_are_for_nets_that_have_not_learned_from_them() {
    let folder = tempdir().expect("a folder");
    let weights = changed_weights(&folder.path().join("without-dev"), |_, card| {
        card.dynamics.as_mut().expect("a dynamics net").without_dev = true;
    });
    let dev = ["measure", "forecasts", "--dev", "--limit", "1", "--balls", "2"];
    let table = output_of(&[&dev[..], &["--weights", &weights]].concat());
    assert!(table.contains("25 dev tasks"), "{table}");
    assert_refused(&dev, "were trained on the dev tasks too");
}

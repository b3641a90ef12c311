//! `pathlight-lab reproduce`: results by recipes, and the table of them.

use std::fs;
use std::path::Path;

use pathlight_lab::files::digest;
use pathlight_lab::measure::report::Report;
use pathlight_lab::reproduce::recipes::{RECIPES, Recipes};
use pathlight_lab::reproduce::report;
use serde_json::Value;
use tempfile::tempdir;

use super::{assert_refused, output_of, pathlight_lab, root};

/// Little data, little training, few tasks.
const SMALL: &str = r#"
    [[recipe]]
    name = "small"
    learns_from = "few balls"
    steps = [
        "data collect --template 2 --limit 8 --per-task 2 --out {runs}/solutions.jsonl",
        "data label --template 2 --limit 8 --rounds 1 --solutions {runs}/solutions.jsonl --out {runs}/labels.jsonl",
        "train success {of} --labels {runs}/labels.jsonl --epochs 2 --batch 4 --balls-per-scene 8 --checkpoint 1 --out {runs}/nets/{fold}",
        "measure evaluate {of} --agent success --limit 1 --weights {runs}/nets/{fold}/weights.safetensors --json {result}",
    ]
    rows = [{ agent = "success", title = "tiny" }, { agent = "random", title = "chance" }]

    [[recipe]]
    name = "remembering"
    after = "small"
    learns_from = "test tasks"
    steps = ["measure evaluate {of} --agent random --memory --shuffle 1 --limit 1 --json {result}"]
    rows = [{ agent = "random", memory = { shuffled = 1 }, title = "random, which remembers" }]
"#;

/// Writes recipes that take seconds; returns the file.
pub fn small_recipes(folder: &Path) -> String {
    let path = folder.join("recipes.toml");
    fs::write(&path, SMALL).expect("written");
    path.display().to_string()
}

#[test]
fn recipes_make_results_and_the_table_reads_them() {
    let folder = tempdir().expect("a folder");
    let recipes = small_recipes(folder.path());
    let [results, runs] = ["results", "runs"].map(|name| folder.path().join(name).display().to_string());
    let words = ["reproduce", "--recipes", &recipes, "--results", &results, "--runs", &runs];
    let reproduce = |more: &[&str]| {
        let output = pathlight_lab().args([&words[..], more].concat()).output().expect("the binary runs");
        let said = String::from_utf8(output.stderr).expect("messages");
        assert!(output.status.success(), "{said}");
        (String::from_utf8(output.stdout).expect("a table"), said)
    };
    let file = |path: &str| folder.path().join(path);
    let (_, said) = reproduce(&["--only", "results", "--setup", "within", "--fold", "0"]);
    // The printed commands are the ones it ran: run again, they find their own runs complete.
    let commands: Vec<&str> = said.lines().filter_map(|line| line.strip_prefix("$ pathlight-lab ")).collect();
    assert_eq!(commands.len(), 4 + 4, "{said}");
    let weights = digest(&file("runs/nets/within-0/weights.safetensors")).expect("weights");
    for command in &commands[..3] {
        output_of(&command.split(' ').collect::<Vec<_>>());
    }
    assert_eq!(digest(&file("runs/nets/within-0/weights.safetensors")).expect("weights"), weights);

    let made = file("results/small/within-0.json");
    let report = Report::read(&made, "").expect("a result");
    assert_eq!((report.tasks().len(), report.made_by.len()), (25, 4));
    assert!(report.core_minutes.is_some_and(|minutes| minutes >= 0.0));
    assert_eq!(report.card.and_then(|card| card.success).map(|success| success.epochs), Some(2));
    let (table, said) = reproduce(&["--recipe", "small", "--setup", "within", "--fold", "0"]);
    assert!(said.contains("within-0.json exists\n"), "{said}");
    assert_eq!(table, fs::read_to_string(file("results/README.md")).expect("a table"));
    let row = |title: &str| table.lines().find(|line| line.starts_with(title)).expect("a row").to_string();
    let [tiny, chance] = [0, 1].map(|index| report.agents[index].auccess);
    let first = format!("| **tiny** | few balls | {tiny:.1} (1 of 10 folds) | – | ");
    assert!(row("| **tiny").starts_with(&first), "{table}");
    assert!(row("| chance").starts_with(&format!("| chance |  | {chance:.1} (1 of 10 folds) | – | ")), "{table}");
    let remembering = Report::read(&file("results/remembering/within-0.json"), "").expect("a result");
    let [alone, by_ids, shuffled] = [0, 1, 2].map(|index| remembering.agents[index].auccess);
    assert_eq!(alone, chance, "the random agent without a memory");
    assert!(row("| **random, which").contains(&format!(" {shuffled:.1} (1 of 10")) && by_ids > 0.0, "{table}");

    // Results of other versions, tasks or recipes do not belong in the same row.
    let text = fs::read_to_string(&made).expect("a result");
    let stray = file("results/small/within-1.json");
    fs::write(&stray, &text).expect("written");
    let report_alone = [&words[..], &["--only", "report"]].concat();
    assert_refused(&report_alone, "within-1.json does not hold the agents of the recipe small on within-1");
    for (key, value) in [("agents_version", Value::from(99)), ("limit", 1.into()), ("made_by", Value::Array(vec![]))] {
        let mut other: Value = serde_json::from_str(&text).expect("JSON");
        (other["fold"], other["limit"], other[key]) = (1.into(), 1.into(), value);
        fs::write(&stray, other.to_string()).expect("written");
        if key != "limit" {
            assert_refused(&report_alone, "within-1.json was made differently from within-0.json (steps");
        }
    }
    let (_, said) = reproduce(&["--only", "results", "--recipe", "small", "--setup", "within", "--fold", "1"]);
    assert!(said.contains("within-1.json exists, made by an earlier recipe: remove it to make it again"), "{said}");
    let mut cut: Value = serde_json::from_str(&text).expect("JSON");
    cut["agents"][0]["first_solved"].as_array_mut().expect("a list").pop();
    fs::write(&stray, cut.to_string()).expect("written");
    assert_refused(&report_alone, "does not hold an attempt for each of its 25 tasks");

    assert_refused(&[&words[..], &["--recipe", "none"]].concat(), "no recipe none: name one of small, remembering");
    fs::write(file("wrong.toml"), SMALL.replace("after = \"small\"", "after = \"large\"")).expect("written");
    let wrong = file("wrong.toml").display().to_string();
    assert_refused(&["reproduce", "--recipes", &wrong], "remembering must come below the one in its `after`");
    fs::write(file("wrong.toml"), SMALL.replace("train success", "train everything")).expect("written");
    let others = ["--results", &format!("{results}-others"), "--runs", &runs, "--recipe", "small", "--fold", "2"];
    assert_refused(&[&["reproduce", "--recipes", &wrong][..], &others].concat(), "the recipe small cannot be followed");
}

#[test]
fn the_table_of_the_repository_is_that_of_its_results() {
    let recipes = Recipes::parse(RECIPES).expect("our own");
    let text = report::text(&root("results"), &recipes).expect("a table");
    let committed = fs::read_to_string(root("results/README.md")).expect("a table");
    assert!(text == committed, "run `pathlight-lab reproduce --only report`");
}

//! `pathlight simulate`: the outcome of a ball, one at a time or in a batch.

use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Write as _};
use std::process::Stdio;

use serde_json::{Value, json};

use crate::{assert_refused, output_of, pathlight, run, stderr, stdout};

/// Two balls that drop, side by side.
const TASK: &str = "00000:000";

#[test]
fn tells_the_outcome_of_one_ball() {
    let answer = parsed(&output_of(&["simulate", "--task", TASK, "--ball", "221,222,20"]));
    assert_eq!(answer["task"], TASK);
    assert_eq!(answer["ball"], json!([221, 222, 20]));
    assert!(answer["status"] == "solved" || answer["status"] == "not_solved");
    assert_eq!(answer["reason"], Value::Null);
    assert!(answer.get("poses").is_none());
}

#[test]
fn an_action_is_the_ball_that_it_places() {
    let action = output_of(&["simulate", "--task", TASK, "--action", "0.5,0.9,0.4"]);
    assert_eq!(parsed(&action)["ball"], json!([127, 229, 14]));
    assert_eq!(action, output_of(&["simulate", "--task", TASK, "--ball", "127,229,14"]));
}

#[test]
fn the_other_engine_names_itself_in_answers_and_attempts() {
    let of = |args: &[&str]| output_of(&[&["simulate", "--task", TASK, "--ball", "221,222,20"], args].concat());
    let (first, other) = (of(&[]), of(&["--engine", "rapier"]));
    assert_eq!(first, of(&["--engine", "box2d"]));
    assert_eq!((parsed(&first).get("engine"), &parsed(&other)["engine"]), (None, &json!("rapier")));
    let request = json!({"task": TASK, "ball": [221, 222, 20]}).to_string();
    assert_eq!(stdout(&run(&["simulate", "--batch", "-", "--engine", "rapier"], &request)), other);
    let lines = of(&["--verifiable", "--engine", "rapier"]) + &of(&["--verifiable"]);
    assert!(lines.contains(r#""engine":"rapier""#), "{lines}");
    assert_eq!(run(&["verify", "-"], &lines).status.code(), Some(0));
    assert_refused(&["simulate", "--task", TASK, "--engine", "soup"], "the engine soup is not known");
}

#[test]
fn luck_counts_the_balls_beside_one_and_asks_the_other_engine() {
    let ball = ["simulate", "--task", TASK, "--ball", "221,222,20"];
    let luck = parsed(&output_of(&[&ball[..], &["--luck"]].concat()))["luck"].clone();
    let rapier = parsed(&output_of(&[&ball[..], &["--engine", "rapier"]].concat()))["status"] == "solved";
    assert_eq!(luck["rapier"], rapier);
    assert!((1..=27).contains(&luck["valid"].as_u64().expect("a count")), "{luck}");
    assert!(luck["solved"].as_u64() <= luck["valid"].as_u64());
    assert_eq!(parsed(&output_of(&["simulate", "--task", TASK, "--luck"])).get("luck"), None, "without a ball");
}

#[test]
fn prints_a_row_of_poses_for_the_start_and_every_step() {
    let answer = parsed(&output_of(&["simulate", "--task", TASK, "--ball", "221,222,20", "--poses"]));
    let steps = answer["steps"].as_u64().expect("a number") as usize;
    let rows = answer["poses"].as_array().expect("rows");
    assert_eq!(rows.len(), steps + 1);
    assert_eq!(answer["touching"].as_array().expect("one a row").len(), steps + 1);
    assert!(rows.iter().all(|row| row.as_array().is_some_and(|row| row.len() == 3)), "two balls and the red one");
    assert_eq!(rows[0][2], json!([221.0, 222.0, 0.0]));
}

#[test]
fn with_no_ball_the_scene_runs_alone() {
    let answer = parsed(&output_of(&["simulate", "--task", TASK]));
    assert_eq!(answer["ball"], Value::Null);
    assert_eq!(answer["status"], "not_solved");
}

#[test]
fn an_invalid_ball_is_an_answer_with_a_reason() {
    for (flag, values) in [("--ball", "-3,5,4"), ("--ball", "89,58,5"), ("--action", "0.5,1.5,0"), ("--ball", "9,9,1")]
    {
        let answer = parsed(&output_of(&["simulate", "--task", TASK, flag, values]));
        assert_eq!((&answer["status"], &answer["steps"]), (&json!("invalid"), &json!(0)), "{values}");
        assert!(answer["reason"].as_str().is_some_and(|reason| !reason.is_empty()), "{values}");
    }
}

#[test]
fn refuses_what_is_no_ball_in_words() {
    assert_refused(&["simulate"], "--task <TASK>|--scene <FILE>|--batch <FILE>");
    assert_refused(&["simulate", "--task", TASK, "--ball", "128.5,200,15"], "whole numbers of px");
    assert_refused(&["simulate", "--task", TASK, "--ball", "NaN,200,15"], "whole numbers of px");
    assert_refused(&["simulate", "--task", TASK, "--ball", "1,2"], "three whole numbers");
    assert_refused(&["simulate", "--task", TASK, "--action", "a,b,c"], "three numbers in 0..1");
    assert_refused(&["simulate", "--task", "00000:999", "--ball", "1,2,3"], "task 00000:999 is not in the benchmark");
    assert_refused(&["simulate", "--batch", "no/such/file"], "cannot read no/such/file");
}

#[test]
fn a_batch_answers_in_order_what_single_runs_answer() {
    let balls = [json!([221, 222, 20]), json!([30, 200, 10]), json!([89, 58, 5]), Value::Null];
    let mut requests = String::new();
    for ball in &balls {
        writeln!(requests, "{}", json!({"task": TASK, "ball": ball, "kind": "another key"})).expect("a string");
    }
    requests.push_str(r#"{"task":"00000:000","action":[0.5,0.9,0.4]}"#);
    let output = run(&["simulate", "--batch", "-"], &requests);
    assert!(output.status.success(), "{}", stderr(&output));
    let mut singles: String = ["221,222,20", "30,200,10", "89,58,5"]
        .map(|ball| output_of(&["simulate", "--task", TASK, "--ball", ball]))
        .concat();
    singles += &output_of(&["simulate", "--task", TASK]);
    singles += &output_of(&["simulate", "--task", TASK, "--action", "0.5,0.9,0.4"]);
    assert_eq!(stdout(&output), singles);
}

/// More lines than one chunk has: every kind of outcome, in the order asked.
#[test]
fn a_long_batch_keeps_its_order() {
    let mut requests = String::new();
    for (x, y) in (0..24).flat_map(|x| (0..24).map(move |y| (10 * x + 8, 10 * y + 8))) {
        writeln!(requests, "{}", json!({"task": TASK, "ball": [x, y, 16]})).expect("a string");
    }
    let output = run(&["simulate", "--batch", "-"], &requests);
    assert!(output.status.success(), "{}", stderr(&output));
    let answers: Vec<Value> = stdout(&output).lines().map(parsed).collect();
    let asked: Vec<Value> = requests.lines().map(|line| parsed(line)["ball"].clone()).collect();
    let answered: Vec<Value> = answers.iter().map(|answer| answer["ball"].clone()).collect();
    assert_eq!(answered, asked);
    for status in ["solved", "not_solved", "invalid"] {
        assert!(answers.iter().any(|answer| answer["status"] == status), "{status}");
    }
}

#[test]
fn a_bad_line_is_named_and_the_rest_goes_on() {
    let good = r#"{"task":"00000:000","ball":[221,222,20]}"#;
    let bad = [
        "nonsense",
        r#"{"task":"00000:000"}"#,
        r#"{"task":"00000:999","ball":null}"#,
        r#"{"task":"00099:000","ball":null}"#,
        r#"{"task":"00000:000","ball":[1,2]}"#,
        r#"{"task":"00000:000","ball":[1.5,2,3]}"#,
        r#"{"task":"00000:000","ball":[1,2,3],"action":[0,0,0]}"#,
        r#"{"task":"00000:000","scene":{},"ball":null}"#,
        r#"{"ball":null}"#,
    ];
    let output = run(&["simulate", "--batch", "-"], &format!("{good}\n\n{}\n{good}\n", bad.join("\n")));
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(stdout(&output).lines().count(), 2);
    let said = stderr(&output);
    let named: Vec<_> = said.lines().filter(|line| line.starts_with("error: line ")).collect();
    assert_eq!(named.len(), bad.len(), "{said}");
    for (number, line) in (3..).zip(named) {
        assert!(line.starts_with(&format!("error: line {number}: ")), "{line}");
    }
    assert!(said.contains("error: 9 lines could not be simulated"), "{said}");
}

#[test]
fn a_line_without_end_is_refused() {
    let good = r#"{"task":"00000:000","ball":[221,222,20]}"#;
    let output = run(&["simulate", "--batch", "-"], &format!("{good}\n{}", " ".repeat(1 << 20)));
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert_eq!(stdout(&output).lines().count(), 1);
    assert!(stderr(&output).contains("error: line 2 of - is longer than 65536 bytes"), "{}", stderr(&output));
}

#[test]
fn a_batch_answers_a_line_before_the_next_one_comes() {
    let mut child = pathlight()
        .args(["simulate", "--batch", "-"])
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .expect("the binary starts");
    let mut stdin = child.stdin.take().expect("piped");
    let mut answers = BufReader::new(child.stdout.take().expect("piped")).lines();
    for x in [30, 31] {
        writeln!(stdin, "{}", json!({"task": TASK, "ball": [x, 200, 10]})).expect("it listens");
        let answer = answers.next().expect("an answer").expect("UTF-8");
        assert_eq!(parsed(&answer)["ball"][0], x);
    }
    drop(stdin);
    assert!(child.wait().expect("the binary ends").success());
}

fn parsed(line: &str) -> Value {
    serde_json::from_str(line).unwrap_or_else(|error| panic!("{error}: {line}"))
}

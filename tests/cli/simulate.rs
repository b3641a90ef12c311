//! `pathlight simulate`: the outcome of a ball, one at a time or in a batch.

use std::fmt::Write as _;
use std::io::{BufRead, BufReader, Write as _};
use std::process::Stdio;

use serde_json::{Value, json};

use crate::{assert_refused, output_of, pathlight, run, stderr, stdout, without_line};

/// A task in which two balls drop side by side.
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
    let mut action = parsed(&output_of(&["simulate", "--task", TASK, "--action", "0.5,0.9,0.4"]));
    assert_eq!(action["ball"], json!([127, 229, 14]));
    assert_eq!(action.as_object_mut().and_then(|answer| answer.remove("action")), Some(json!([0.5, 0.9, 0.4])));
    assert_eq!(action, parsed(&output_of(&["simulate", "--task", TASK, "--ball", "127,229,14"])));
}

#[test]
fn the_other_engine_names_itself_in_answers_and_attempts() {
    let of = |args: &[&str]| output_of(&[&["simulate", "--task", TASK, "--ball", "221,222,20"], args].concat());
    let (first, other) = (of(&[]), of(&["--engine", "rapier"]));
    assert_eq!(first, of(&["--engine", "box2d"]));
    assert_eq!((parsed(&first).get("engine"), &parsed(&other)["engine"]), (None, &json!("rapier")));
    let request = json!({"task": TASK, "ball": [221, 222, 20]}).to_string();
    let batch = stdout(&run(&["simulate", "--batch", "-", "--engine", "rapier"], &request));
    assert_eq!(without_line(1, &batch), parsed(&other));
    let lines = of(&["--verifiable", "--engine", "rapier"]) + &of(&["--verifiable"]);
    assert!(lines.contains(r#""engine":"rapier""#), "{lines}");
    assert_eq!(run(&["verify", "-"], &lines).status.code(), Some(0));
    assert_refused(&["simulate", "--task", TASK, "--engine", "soup"], "unknown engine soup");
}

#[test]
fn luck_counts_the_balls_beside_one_and_asks_the_other_engine() {
    let ball = ["simulate", "--task", TASK, "--ball", "221,222,20"];
    let luck = parsed(&output_of(&[&ball[..], &["--luck"]].concat()))["luck"].clone();
    let rapier = parsed(&output_of(&[&ball[..], &["--engine", "rapier"]].concat()))["status"] == "solved";
    assert_eq!(luck["rapier"], rapier);
    assert!((1..=27).contains(&luck["valid"].as_u64().expect("a count")), "{luck}");
    assert!(luck["solved"].as_u64() <= luck["valid"].as_u64());
    assert_refused(&["simulate", "--task", TASK, "--luck"], "--luck needs a ball: place one with --ball or --action");
    for action in ["nan,0.5,0.5", "0.5,inf,0.5"] {
        assert_refused(&["simulate", "--task", TASK, "--action", action], "an action is three numbers from 0 to 1");
    }
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
    assert_refused(&["simulate", "--task", TASK, "--action", "a,b,c"], "three numbers from 0 to 1");
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
    let answers = stdout(&output);
    assert_eq!(answers.lines().count(), singles.lines().count());
    for (line, (answer, single)) in (1..).zip(answers.lines().zip(singles.lines())) {
        assert_eq!(without_line(line, answer), parsed(single));
    }
}

/// More lines than fit into one chunk, with every kind of outcome, in the requested order.
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
    for flags in [&[][..], &["--paths"], &["--verifiable"]] {
        let args = [&["simulate", "--batch", "-"], flags].concat();
        let output = run(&args, &format!("{good}\n\n{}\n{good}\n", bad.join("\n")));
        assert_eq!(output.status.code(), Some(2));
        let answers: Vec<Value> = stdout(&output).lines().map(parsed).collect();
        let (last, refused) = answers[1..].split_last().expect("answers");
        assert_eq!((&answers[0]["status"], &last["status"]), (&json!("solved"), &json!("solved")), "{answers:?}");
        assert_eq!(last["line"], if flags == ["--verifiable"] { Value::Null } else { json!(12) });
        let said = stderr(&output);
        let named: Vec<_> = said.lines().filter(|line| line.starts_with("error: line ")).collect();
        assert_eq!((named.len(), refused.len()), (bad.len(), bad.len()), "{said}");
        for ((number, line), answer) in (3..).zip(named).zip(refused) {
            assert_eq!(answer["line"], number);
            assert_eq!(line, format!("error: line {number}: {}", answer["error"].as_str().expect("a sentence")));
        }
        assert!(said.contains("error: 9 lines could not be simulated"), "{said}");
    }
}

#[test]
fn a_line_that_is_too_long_is_answered_and_the_next_one_simulated() {
    let good = r#"{"task":"00000:000","ball":[221,222,20]}"#;
    let endless = " ".repeat(3 << 20);
    let output = run(&["simulate", "--batch", "-"], &format!("{good}\n{endless}\n{good}\n{endless}"));
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    let answers: Vec<Value> = stdout(&output).lines().map(parsed).collect();
    assert_eq!(answers.iter().map(|answer| &answer["line"]).collect::<Vec<_>>(), [1, 2, 3, 4]);
    for (index, answer) in answers.iter().enumerate() {
        let error = answer["error"].as_str().unwrap_or_default();
        assert_eq!(error.contains("longer than 65536 bytes"), index % 2 == 1, "{answer}");
    }
    // A line may be exactly as long as the limit.
    let longest = format!("{good}{}\n", " ".repeat((1 << 16) - good.len()));
    assert!(run(&["simulate", "--batch", "-"], &longest).status.success());
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
    // After the second line comes a blank one, after the third a part of the next.
    for (x, more) in [(30, ""), (31, "\n"), (32, r#"{"task":"00000:000","ball":"#), (33, "")] {
        let request = json!({"task": TASK, "ball": [x, 200, 10]}).to_string();
        let rest = if x == 33 { "[33,200,10]}" } else { &request };
        write!(stdin, "{rest}\n{more}").expect("it listens");
        let answer = answers.next().expect("an answer").expect("UTF-8");
        assert_eq!(parsed(&answer)["ball"][0], x);
    }
    drop(stdin);
    assert!(child.wait().expect("the binary ends").success());
}

fn parsed(line: &str) -> Value {
    serde_json::from_str(line).unwrap_or_else(|error| panic!("{error}: {line}"))
}

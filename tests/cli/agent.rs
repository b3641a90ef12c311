//! `pathlight agent`: plays against any simulator over JSON lines, here against `pathlight simulate --batch - --paths`.

use std::io::{BufRead, BufReader, Lines, Write};
use std::process::{Child, ChildStdin, ChildStdout, Command, Output, Stdio};

use serde_json::{Value, json};
use tempfile::tempdir;

use crate::{assert_refused, output_of, pathlight, run, stderr, stdout, without_dynamics};

/// The tasks of examples/client.py.
const TASKS: [&str; 2] = ["00007:008", "00002:007"];

const AGENT: [&str; 1] = ["agent"];
const SIMULATOR: [&str; 4] = ["simulate", "--batch", "-", "--paths"];

/// A process that answers each line with one line.
pub struct Partner {
    process: Child,
    stdin: ChildStdin,
    answers: Lines<BufReader<ChildStdout>>,
}

impl Partner {
    pub fn new(args: &[&str]) -> Partner {
        let mut command = pathlight();
        command.args(args).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::null());
        let mut process = command.spawn().expect("the binary starts");
        let stdin = process.stdin.take().expect("piped");
        let answers = BufReader::new(process.stdout.take().expect("piped")).lines();
        Partner { process, stdin, answers }
    }

    pub fn ask(&mut self, line: &str) -> String {
        writeln!(self.stdin, "{line}").expect("it listens");
        self.answers.next().expect("an answer").expect("UTF-8")
    }

    fn ask_value(&mut self, line: &Value) -> Value {
        parsed(&self.ask(&line.to_string()))
    }

    /// Kills the process, as a crash would.
    pub fn kill(mut self) {
        self.process.kill().expect("it runs");
        self.process.wait().expect("it ends");
    }

    fn ends_well(mut self) {
        drop(self.stdin);
        assert!(self.process.wait().expect("it ends").success());
    }
}

/// The two commands understand each other's lines unchanged, and the attempts are those that `propose` lists.
#[test]
fn agent_and_simulator_play_several_tasks_by_their_own_lines() {
    let mut agent = Partner::new(&["agent", "--agent", "dynamics"]);
    let mut simulator = Partner::new(&SIMULATOR);
    for task in TASKS {
        let listed = parsed(&output_of(&["propose", "--task", task]))["balls"].clone();
        let mut asked = agent.ask(&json!({ "task": task }).to_string());
        for attempt in 0.. {
            let line = parsed(&asked);
            assert_eq!(line["task"], task);
            if line["ball"].is_null() {
                assert!((1..=100).contains(&attempt), "{attempt}");
                break;
            }
            let expected: Vec<f64> = serde_json::from_value(listed[attempt].clone()).expect("three numbers");
            assert_eq!(line["ball"], json!(expected.iter().map(|&number| number as u32).collect::<Vec<_>>()));
            let outcome = simulator.ask(&asked);
            let paths = &parsed(&outcome)["paths"];
            let poses = |body: &str| paths[body].as_array().expect("poses").len();
            assert_eq!(poses("object"), poses("ball"));
            assert_eq!(poses("ball"), parsed(&outcome)["steps"].as_u64().expect("a number") as usize / 10 + 1);
            asked = agent.ask(&outcome);
        }
    }
    agent.ends_well();
    simulator.ends_well();
}

/// Both commands answer a client that writes a line and waits, whatever the line is.
#[test]
fn a_client_is_never_left_waiting() {
    let good = json!({"task": TASKS[0], "ball": null}).to_string();
    for args in [&["agent", "--agent", "random"][..], &SIMULATOR] {
        let mut partner = Partner::new(args);
        for (number, line, words) in [
            (1, good.clone(), ""),
            (2, "nonsense".to_string(), "at column 2; write a line like"),
            (3, json!({"task": "00007:800", "ball": null}).to_string(), "not in the benchmark"),
            (4, " ".repeat(1 << 19), "longer than"),
            (6, format!("\n{good}"), ""),
        ] {
            let answer = parsed(&partner.ask(&line));
            assert_eq!(answer["line"], number, "{answer}");
            match words {
                "" => assert_eq!(answer["task"], TASKS[0], "{answer}"),
                words => assert!(answer["error"].as_str().is_some_and(|said| said.contains(words)), "{answer}"),
            }
        }
        drop(partner.stdin);
        assert_eq!(partner.process.wait().expect("it ends").code(), Some(2), "{args:?}");
    }
}

#[test]
fn after_a_hundred_attempts_or_a_solution_there_is_no_ball() {
    let mut agent = Partner::new(&["agent", "--agent", "random"]);
    let mut answer = agent.ask_value(&json!({ "task": TASKS[0] }));
    // Invalid balls are not attempts.
    for status in std::iter::repeat_n("invalid", 7).chain(std::iter::repeat_n("not_solved", 100)) {
        assert!(answer["ball"].is_array(), "{answer}");
        answer = agent.ask_value(&json!({ "status": status }));
    }
    assert_eq!(answer["ball"], Value::Null);
    assert!(agent.ask_value(&json!({ "status": "not_solved" }))["error"].is_string());
    assert!(agent.ask_value(&json!({ "task": TASKS[1] }))["ball"].is_array());
    assert_eq!(agent.ask_value(&json!({ "status": "solved" }))["ball"], Value::Null);
}

#[test]
fn a_scene_of_its_own_is_a_puzzle_too() {
    let mut agent = Partner::new(&AGENT);
    let of_task = agent.ask_value(&json!({ "task": TASKS[0] }));
    let scene = parsed(&output_of(&["tasks", "--json", TASKS[0]]));
    let of_scene = agent.ask_value(&json!({ "scene": scene }));
    assert_eq!(of_scene["ball"], of_task["ball"]);
    assert!(of_scene.get("task").is_none());
    for key in ["body1", "body2"] {
        let mut broken = scene.clone();
        broken[key] = json!(99);
        assert!(agent.ask_value(&json!({ "scene": broken }))["error"].is_string(), "{key}");
    }
    for (pointer, value) in [
        ("/bodies/0/x", json!(1e300)),
        ("/bodies/0/parts", json!([])),
        ("/bodies/0/parts", json!([{"circle": 0}])),
        ("/bodies/0/parts", json!([{"polygon": [[0, 0], [1, 1]]}])),
        ("/bodies/0/parts", json!([{"polygon": [[0, 0], [1, 1], [0, 1e9]]}])),
    ] {
        let mut broken = scene.clone();
        *broken.pointer_mut(pointer).expect("a body") = value;
        let said = agent.ask_value(&json!({ "scene": broken }));
        assert!(said["error"].as_str().is_some_and(|said| said.contains("body 0")), "{pointer}: {said}");
    }
}

#[test]
fn a_bad_line_is_answered_with_an_error_and_changes_nothing() {
    let ball = parsed(&stdout(&run(&AGENT, &json!({ "task": TASKS[0] }).to_string())))["ball"].clone();
    let bad = [
        (r#"{"status":"not_solved"}"#.to_string(), "no ball is waiting"),
        ("nonsense".to_string(), "at column 2; write a line like"),
        ("{}".to_string(), "are missing"),
        (r#"{"task":"00000:999"}"#.to_string(), "not in the benchmark"),
        (r#"{"status":"perhaps"}"#.to_string(), "unknown variant `perhaps`"),
    ];
    let unlike = [
        (json!({"status": "not_solved", "task": "00000:000"}), "another task"),
        (json!({"status": "not_solved", "ball": [1, 2, 3]}), "another ball"),
        (json!({"status": "not_solved", "paths": {"object": [], "ball": []}}), "`paths` has 0 poses"),
        (
            json!({"status": "not_solved", "paths": {"object": [[0, 0, 0]], "ball": []}}),
            "1 poses of `object` and 0 of `ball`",
        ),
        (
            json!({"status": "not_solved", "paths": {"object": vec![[0; 3]; 102], "ball": vec![[0; 3]; 102]}}),
            "should have 1 to 101",
        ),
        (
            json!({"status": "not_solved", "paths": {
                "object": [[3e38, 0, 0], [-3e38, 0, 0], [3e38, 0, 0], [0, 0, 0]],
                "ball": vec![[0; 3]; 4],
            }}),
            "too far apart",
        ),
        (
            json!({"status": "not_solved", "paths": {"object": [[1e39, 0, 0]], "ball": [[0, 0, 0]]}}),
            "number out of range",
        ),
        (json!({"status": "not_solved", "paths": {"object": [[1, 2]]}}), "at column"),
        (json!({"status": "not_solved", "scene": null, "task": 7}), "at column"),
        (json!({"note": " ".repeat(1 << 18)}), "longer than"),
    ];
    let mut lines: Vec<String> = bad.iter().map(|(line, _)| line.clone()).collect();
    lines.push(json!({ "task": TASKS[0] }).to_string());
    lines.extend(unlike.iter().map(|(line, _)| line.to_string()));
    lines.extend([String::new(), json!({"status": "invalid", "ball": ball, "task": TASKS[0]}).to_string()]);
    let output = run(&AGENT, &lines.join("\n"));
    let said: Vec<Value> = stdout(&output).lines().map(parsed).collect();
    let expected =
        bad.iter().map(|(_, words)| *words).chain([""]).chain(unlike.iter().map(|(_, words)| *words)).chain([""]);
    assert_eq!(said.len(), bad.len() + unlike.len() + 2);
    assert_eq!(said.last().expect("answers")["line"], lines.len());
    for (said, words) in said.iter().zip(expected) {
        match words {
            "" => assert!(said["ball"].is_array(), "{said}"),
            words => assert!(said["error"].as_str().is_some_and(|said| said.contains(words)), "{said} without {words}"),
        }
    }
    assert_eq!(output.status.code(), Some(2));
    assert!(stderr(&output).contains("error: 15 lines could not be used"), "{}", stderr(&output));
    assert_refused(&["agent", "--weights", "no/such/file"], "cannot read the weights in no/such/file");
    let folder = tempdir().expect("a folder");
    let elsewhere = pathlight().arg("propose").current_dir(folder.path()).output().expect("the binary starts");
    let missing = folder.path().canonicalize().expect("a path").join("assets/within-0.safetensors");
    let words = format!("cannot read the weights in {}: run this in Pathlight's folder", missing.display());
    assert!(stderr(&elsewhere).contains(&words), "{}", stderr(&elsewhere));
    let without = without_dynamics(folder.path());
    for agent in ["online", "online-by-balls", "dynamics"] {
        let words = "the weights have no dynamics net: train one with `pathlight-lab train dynamics`";
        assert_refused(&["agent", "--weights", &without, "--agent", agent], words);
    }
}

/// Input after the example: bad lines are answered, and so are the good ones after them.
const BAD_AND_GOOD_LINES: &str = r#"
for process in [agent, simulator]:
    try:
        ask(process, {"task": "00007:999", "ball": None})
    except ValueError as error:
        print("refused:", error)
    print("answered:", ask(process, {"task": "00007:008", "ball": None})["task"])
"#;

/// Runs Python with `pathlight` on the PATH; `None` if it is missing.
fn python(arguments: &[&str]) -> Option<Output> {
    let binary = std::path::Path::new(env!("CARGO_BIN_EXE_pathlight")).parent().expect("a folder");
    let path = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths([binary.to_path_buf()].into_iter().chain(std::env::split_paths(&path)));
    Command::new("python3").args(arguments).env("PATH", path.expect("a path")).output().ok()
}

#[test]
fn the_example_in_python_plays() {
    let example = std::fs::read_to_string("examples/client.py").expect("it is there");
    let Some(output) = python(&["-c", &format!("{example}{BAD_AND_GOOD_LINES}")]) else {
        eprintln!("skipped: python3 is missing");
        return;
    };
    assert!(output.status.success(), "{}", stderr(&output));
    let said = stdout(&output);
    for task in TASKS {
        let line = said.lines().find(|line| line.starts_with(task)).unwrap_or_else(|| panic!("{task}: {said}"));
        assert!(line.contains("solved"), "{line}");
    }
    for (words, count) in [("refused: task 00007:999 is not in the benchmark", 2), ("answered: 00007:008", 2)] {
        assert_eq!(said.matches(words).count(), count, "{said}");
    }
}

fn parsed(line: &str) -> Value {
    serde_json::from_str(line).unwrap_or_else(|error| panic!("{error}: {line}"))
}

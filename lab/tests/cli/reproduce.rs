//! `pathlight-lab reproduce`: results by the job array's script, and the report on them.

use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Output, Stdio};

use pathlight_lab::files::digest;
use serde_json::Value;
use tempfile::tempdir;

use super::{assert_refused, output_of, pathlight_lab, root};

/// Arguments for all processes here: little data, little training, few tasks.
fn small(folder: &Path) -> Vec<String> {
    let within = |name: &str| folder.join(name).display().to_string();
    let words = [
        "--results",
        &within("results"),
        "--train-dir",
        &within("runs"),
        "--solutions",
        &within("solutions.jsonl"),
        "--labels",
        &within("labels.jsonl"),
        "--label-rounds",
        "1",
        "--epochs",
        "1",
        "--dqn-epochs",
        "1",
        "--limit",
        "1",
    ];
    words.map(String::from).to_vec()
}

/// A job of the array of folds. It names the files and the rounds of labelling itself.
fn job(index: &str, folder: &Path, words: &[String]) -> Output {
    let mut script = Command::new(root("scripts/cluster/job"));
    script
        .current_dir(root(""))
        .env("PATHLIGHT_LAB", env!("CARGO_BIN_EXE_pathlight-lab"))
        .env("SLURM_ARRAY_TASK_ID", index);
    script.env("FOLDER", folder).env("LABEL_ROUNDS", "1").arg("fold").args(&words[10..]);
    script.output().expect("the script runs")
}

#[test]
fn jobs_make_results_and_the_report_reads_them() {
    let folder = tempdir().expect("a folder");
    let words = small(folder.path());
    let (solutions, labels) = (words[5].as_str(), words[7].as_str());
    output_of(&["data", "collect", "--template", "2", "--limit", "10", "--per-task", "3", "--out", solutions]);
    let few = ["--template", "2", "--limit", "6", "--rounds", "1", "--solutions", solutions];
    output_of(&[&["data", "label", "--out", labels], &few[..]].concat());

    for index in ["3", "10"] {
        let made = job(index, folder.path(), &words);
        let said = String::from_utf8_lossy(&made.stderr);
        assert!(made.status.success(), "{said}");
        // The commands that it names are those that it ran: run again, they find their own runs complete.
        let commands: Vec<&str> = said.lines().filter_map(|line| line.strip_prefix("$ pathlight-lab ")).collect();
        assert_eq!(commands.len(), 6, "{said}");
        for command in commands {
            output_of(&command.split(' ').collect::<Vec<_>>());
        }
    }
    let results = folder.path().join("results");
    let file = |name: &str| fs::read(results.join(name)).expect("a result");
    let result: Value = serde_json::from_slice(&file("within-3.json")).expect("JSON");
    let four_nets = digest(&folder.path().join("runs/within-3/weights.safetensors")).expect("a file");
    for (net, path) in [("success", "/success/card/success"), ("dynamics", "/dynamics/card/dynamics")] {
        let card = result.pointer(path).unwrap_or_else(|| panic!("{path}"));
        assert_eq!((&card["epochs"], &card["optimiser"]), (&1.into(), &"muon".into()), "{net}");
        assert_eq!(result[net]["added_to"], four_nets, "{net}");
    }
    for (run, losses) in [("success", 1), ("dynamics", 5), ("dqn", 1)] {
        assert_eq!(result[run]["losses"].as_array().map(Vec::len), Some(losses), "{run}");
        let (epoch, done, last) =
            serde_json::from_value::<(usize, usize, Vec<f32>)>(result[run]["log"][0].clone()).expect("a line");
        assert!(
            epoch == done - 1 && last.len() == losses && last.iter().all(|loss| (0.0..2.0).contains(loss)),
            "{run}"
        );
    }
    let agents: Vec<&Value> = result["report"]["agents"].as_array().expect("agents").iter().collect();
    let names: Vec<_> = agents.iter().map(|one| &one["agent"]).collect();
    assert_eq!(names, ["online", "online-by-balls", "dynamics", "success", "dqn", "random"]);
    assert!(agents.iter().all(|one| one["first_solved"].as_array().is_some_and(|tasks| tasks.len() == 25)));

    let before = file("cross-0.json");
    let again = job("10", folder.path(), &words);
    assert!(String::from_utf8_lossy(&again.stderr).contains("cross-0.json exists"));
    assert_eq!(file("cross-0.json"), before);
    let other: Vec<String> = [&words[..], &["--seed".to_string(), "1".to_string()]].concat();
    let refused = job("10", folder.path(), &other);
    assert!(
        String::from_utf8_lossy(&refused.stderr).contains("`seed` is 0 instead of 1), and one report cannot have both")
    );

    let report = ["reproduce", "--only", "report", "--results", &words[1]];
    fs::write(results.join("within-4.json"), result.to_string()).expect("written");
    assert_refused(&report, "within-4.json holds the result of within 3");
    let mut result_of_within_4 = result.clone();
    result_of_within_4["report"]["fold"] = 4.into();

    // Results of other settings, of other agents or of weights trained in another way do not belong in the same table.
    for (key, value, difference) in [
        ("/hyperparameters/epochs", Value::from(7), "`epochs` is 7 instead of 1"),
        ("/report/agents_version", Value::from(99), "`agents_version` is 99 instead of"),
        ("/solutions", Value::from("0"), "`solutions` is \"0\" instead of"),
        ("/success/card/success/optimiser", Value::from("adam"), "`success.optimiser` is"),
        ("/dynamics/card/dynamics/batch", Value::from(9), "`dynamics.batch` is 9 instead of 32"),
        ("/dynamics/card/dynamics/epochs", Value::from(9), "`dynamics.epochs` is 9 instead of 1"),
        ("/dqn/card/batch", Value::from(9), "`dqn.batch` is 9 instead of 16"),
    ] {
        let mut stray = result_of_within_4.clone();
        *stray.pointer_mut(key).unwrap_or_else(|| panic!("{key}")) = value;
        fs::write(results.join("within-4.json"), stray.to_string()).expect("written");
        assert_refused(&report, "within-4.json was made with other settings");
        assert_refused(&report, difference);
        if key == "/report/agents_version" {
            let made = job("4", folder.path(), &words);
            assert!(String::from_utf8_lossy(&made.stderr).contains(difference), "{made:?}");
        }
    }
    // Neither do those of nets that were not trained as `reproduce` trains them.
    for (key, value) in [
        ("/success/data", Value::from("0")),
        ("/dqn/data", Value::from("0")),
        ("/dynamics/card/dynamics/without_dev", true.into()),
    ] {
        let mut stray = result_of_within_4.clone();
        *stray.pointer_mut(key).unwrap_or_else(|| panic!("{key}")) = value;
        fs::write(results.join("within-4.json"), stray.to_string()).expect("written");
        assert_refused(&report, "within-4.json is not as `pathlight-lab reproduce` makes it: remove it");
    }
    // The setups differ in the weights of the paths.
    let mut stray: Value = serde_json::from_slice(&file("cross-0.json")).expect("JSON");
    assert_eq!(stray["dynamics"]["card"]["dynamics"]["path_weights"]["all"], 2.0);
    stray["report"]["fold"] = 4.into();
    stray["dynamics"]["card"]["dynamics"]["path_weights"]["all"] = 0.5.into();
    fs::remove_file(results.join("within-4.json")).expect("removed");
    fs::write(results.join("cross-4.json"), stray.to_string()).expect("written");
    assert_refused(&report, "`dynamics.path_weights.all` is 0.5 instead of 2");
    fs::remove_file(results.join("cross-4.json")).expect("removed");

    // The paper's nets are measured apart, on the same tasks.
    fs::create_dir(results.join("paper")).expect("a folder");
    let printed = output_of(&report);
    assert!(printed.contains("| **the paper's four nets** | ours | – | – |"), "{printed}");
    let mut of_paper = result["report"].clone();
    of_paper["agents"][0]["agent"] = "paper".into();
    fs::write(results.join("paper/within-3.json"), of_paper.to_string()).expect("written");
    assert_refused(&report, "does not hold the agents paper, random, of this version, on all test tasks of within-3");
    fs::remove_dir_all(results.join("paper")).expect("removed");

    for (index, name) in [(0, "online"), (4, "DQN, smaller"), (5, "random")] {
        let measured = agents[index]["auccess"].as_f64().expect("a number");
        let row = printed.lines().find(|line| line.starts_with(&format!("| **{name}** |"))).expect("a row");
        assert!(row.contains(&format!("| {measured:.1} |")), "{row}");
    }
    let score = |index: usize| agents[index]["auccess"].as_f64().expect("a number");
    for (row, [one, other]) in [("dynamics – success net", [2, 3]), ("online – online, by balls", [0, 1])] {
        let difference = score(one) - score(other);
        let row = printed.lines().find(|line| line.starts_with(&format!("| {row} |"))).expect("a row");
        assert!(row.contains(&format!("| {difference:.1}, {} of 1 |", usize::from(difference > 0.0))), "{row}");
    }
    for title in ["The success net", "The dynamics net", "DQN"] {
        let rows = printed.split(&format!("\n### {title}\n")).nth(1).expect("a table");
        assert!(
            rows.lines()
                .skip(3)
                .take(2)
                .all(|row| row.starts_with("| within | 3 |") || row.starts_with("| cross | 0 |"))
        );
        assert!(!rows.contains("NaN"), "{rows}");
    }
    assert_eq!(printed, fs::read_to_string(results.join("README.md")).expect("a report"));
    let costs = fs::read_to_string(results.join("costs.md")).expect("costs");
    assert!(
        costs.contains("\n| within | 1 | ") && costs.contains("\n| cross | 1 | ") && costs.contains("\n| 200 | "),
        "{costs}"
    );
}

#[test]
fn data_that_are_complete_stay_as_they_are() {
    let folder = tempdir().expect("a folder");
    let file = |name: &str| folder.path().join(name);
    // As if they were of today's simulator.
    let shipped = fs::read_to_string(root("assets/solutions.jsonl")).expect("ours");
    let (settings, lines) = shipped.split_once('\n').expect("lines");
    let mut settings: serde_json::Value = serde_json::from_str(settings).expect("settings");
    settings["simulator"] = pathlight::simulator::VERSION.into();
    let complete = format!("{settings}\n{lines}");
    fs::write(file("solutions.jsonl"), &complete).expect("a copy");
    let [solutions, labels] = ["solutions.jsonl", "labels.jsonl"].map(|name| file(name).display().to_string());
    let files = ["--solutions", &solutions, "--labels", &labels];
    let data = [&["reproduce", "--only", "data", "--label-rounds", "0"], &files[..]].concat();
    for _ in 0..2 {
        output_of(&data);
        assert_eq!(fs::read_to_string(file("solutions.jsonl")).expect("solutions"), complete);
        let labelled = fs::read_to_string(&labels).expect("labels");
        assert!(labelled.lines().count() == 1 && labelled.contains("\"tasks\":2500"), "{labelled}");
    }
    let results = file("results").display().to_string();
    let folds = [&["reproduce", "--only", "folds", "--results", &results, "--label-rounds", "3"], &files[..]].concat();
    assert_refused(&folds, "does not hold the balls of 3 rounds: run `pathlight-lab reproduce --only data`");
    let variants = file("variants.jsonl").display().to_string();
    output_of(&["data", "label", "--variants", "--template", "2", "--limit", "1", "--rounds", "1", "--out", &variants]);
    let folds = ["reproduce", "--only", "folds", "--results", &results, "--labels", &variants, "--label-rounds", "1"];
    assert_refused(&folds, "variants.jsonl holds other balls than --labels takes");
}

#[test]
fn results_of_other_settings_are_found_before_a_fold_is_trained() {
    let folder = tempdir().expect("a folder");
    fs::copy(root("results/within-0.json"), folder.path().join("within-0.json")).expect("a copy");
    let results = folder.path().display().to_string();
    let fold = |fold| ["reproduce", "--only", "folds", "--setup", "within", "--fold", fold, "--results", &results];
    let labels = ["--labels", "no/labels.jsonl"];
    assert_refused(&[&fold("0")[..], &labels].concat(), "run `pathlight-lab reproduce --only data` first");
    let solutions = root("assets/solutions.jsonl").display().to_string();
    assert_refused(&[&fold("1")[..], &["--labels", &solutions]].concat(), "and one report cannot have both");
}

#[test]
fn a_file_that_another_process_uses_is_left_alone() {
    let folder = tempdir().expect("a folder");
    let path = folder.path().join("lock");
    let locked = fs::File::create(&path).expect("a file");
    locked.lock().expect("a lock");
    let few = folder.path().join("few.jsonl").display().to_string();
    let collect = ["data", "collect", "--template", "2", "--limit", "4", "--per-task", "2", "--out"];
    let mut waiting =
        pathlight_lab().args(collect).arg(&path).stderr(Stdio::piped()).spawn().expect("the binary starts");
    let mut lines = BufReader::new(waiting.stderr.take().expect("piped")).lines();
    assert!(lines.any(|line| line.expect("text").contains("waiting until it has ended")));
    assert_eq!(fs::metadata(&path).expect("a file").len(), 0);
    locked.unlock().expect("unlocked");
    lines.for_each(drop);
    assert!(waiting.wait().expect("it ends").success());
    output_of(&[&collect[..], &[&few]].concat());
    assert_eq!(fs::read(&path).expect("a file"), fs::read(&few).expect("a file"));
    locked.lock().expect("a lock");
    let train = ["train", "paths", "--solutions", &few, "--out", &folder.path().display().to_string()];
    assert_refused(&train, "another process uses");
}

#[test]
fn the_report_and_the_readme_are_those_of_the_results() {
    let folder = tempdir().expect("a folder");
    for of in ["", "proposed-balls", "random-scenes", "paper"] {
        let copies = folder.path().join(of);
        fs::create_dir_all(&copies).expect("a folder");
        for file in fs::read_dir(root("results").join(of)).expect("results") {
            let path = file.expect("a file").path();
            if path.extension().is_some_and(|extension| extension == "json") {
                fs::copy(&path, copies.join(path.file_name().expect("a name"))).expect("a copy");
            }
        }
    }
    let results = folder.path().display().to_string();
    let report = output_of(&["reproduce", "--only", "report", "--results", &results]);
    let remedy = "run `pathlight-lab reproduce --only report`";
    assert_eq!(fs::read_to_string(root("results/README.md")).expect("a report"), report, "{remedy}");

    let readme = fs::read_to_string(root("README.md")).expect("the README");
    let table = |text: &str| -> Vec<String> {
        let from_head = text.lines().skip_while(|line| *line != "| agent | simulator | within | cross |");
        from_head.take_while(|line| line.starts_with('|')).map(str::to_string).collect()
    };
    let (rows, shown) = (table(&report), table(&readme));
    assert!(shown.len() >= 2 + 5, "the README shows five agents at least");
    for row in shown {
        assert!(rows.contains(&row), "{remedy}, and copy this row of the README from its table: {row}");
    }
}

#[test]
fn what_is_missing_is_named() {
    let folder = tempdir().expect("a folder");
    let words = small(folder.path());
    let with = |part: &'static str| {
        ["reproduce", "--only", part].into_iter().chain(words.iter().map(String::as_str)).collect::<Vec<_>>()
    };
    assert_refused(&with("report"), "holds no results");
    assert_refused(&with("folds"), "run `pathlight-lab data label` first");
    fs::create_dir(folder.path().join("results")).expect("a folder");
    fs::write(folder.path().join("results/within-0.json"), "{").expect("a file");
    assert_refused(&with("folds"), "is not a result of `pathlight-lab reproduce`");
    for (index, named) in [("25", "submit the job with"), ("20", "some of 0-19"), ("within", "submit the job with")] {
        let refused = job(index, folder.path(), &words);
        assert!(String::from_utf8_lossy(&refused.stderr).contains(named), "{index}");
    }
}

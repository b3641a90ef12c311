//! `pathlight-lab data merge`: the files of single templates make the file of all, byte for byte.

use std::fs;
use std::path::Path;

use tempfile::tempdir;

use super::{assert_refused, output_of};

/// Runs a command for each template, and returns the names of the files.
fn shards(command: &[&str], folder: &Path, name: &str) -> Vec<String> {
    let shard = |template: usize| {
        let out = folder.join(format!("{name}-{template}.jsonl")).display().to_string();
        output_of(&[command, &["--template", &template.to_string(), "--out", &out]].concat());
        out
    };
    (0..25).map(shard).collect()
}

fn merge(files: &[String], out: &str) {
    let files: Vec<&str> = files.iter().map(String::as_str).collect();
    output_of(&[&["data", "merge"], &files[..], &["--out", out]].concat());
}

#[test]
fn files_of_single_templates_make_the_file_of_all() {
    let folder = tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let equal = |one: &str, other: &str| {
        assert!(fs::read(path(one)).expect("a file") == fs::read(path(other)).expect("a file"), "{one} is not {other}");
    };
    let collect = ["data", "collect", "--limit", "2", "--per-task", "2", "--max-rollouts", "100"];
    let solutions = path("solutions.jsonl");
    output_of(&[&collect[..], &["--out", &solutions]].concat());
    let mut files = shards(&collect, folder.path(), "solutions");
    files.reverse();
    merge(&files, &path("merged.jsonl"));
    equal("merged.jsonl", "solutions.jsonl");
    merge(&files, &path("merged.jsonl"));

    // A fold of the setup cross has training tasks of 20 templates only.
    let of_fold = ["--limit", "2", "--setup", "cross", "--fold", "0"];
    for options in [&["--limit", "2", "--variants"][..], &of_fold, &["--unlisted", "2"]] {
        let label = [&["data", "label", "--rounds", "2", "--solutions", &solutions], options].concat();
        let (all, merged) = (path("labels.jsonl"), path("labels-merged.jsonl"));
        output_of(&[&label[..], &["--out", &all]].concat());
        let labelled = fs::read_to_string(&all).expect("labels");
        let has = |template: usize| {
            let [task, unlisted] = [format!("\"{template:05}:"), format!("{{\"unlisted\":[{template},")];
            labelled.contains(&task) || labelled.contains(&unlisted)
        };
        let file = |template: usize| {
            let out = path(&format!("labels-{template}.jsonl"));
            output_of(&[&label[..], &["--template", &template.to_string(), "--out", &out]].concat());
            out
        };
        let files: Vec<String> = (0..25).filter(|&template| has(template)).map(file).collect();
        merge(&files, &merged);
        equal("labels-merged.jsonl", "labels.jsonl");
        let but_one: Vec<&str> = files[1..].iter().map(String::as_str).collect();
        let fewer = path("fewer.jsonl");
        let refused = [&["data", "merge"], &but_one[..], &["--out", &fewer]].concat();
        assert_refused(&refused, "make those with `pathlight-lab data label --template`");
        for file in files.iter().chain([&all, &merged]) {
            fs::remove_file(file).expect("removed");
        }
    }

    let merge_with = |others: &[&str], out: &str, words: &str| {
        let files: Vec<&str> = files.iter().map(String::as_str).collect();
        assert_refused(&[&["data", "merge"], &files[..], others, &["--out", out]].concat(), words);
    };
    merge_with(&[&solutions], &path("new.jsonl"), "is not of one template");
    merge_with(&[&files[3]], &path("new.jsonl"), "are of the same template");
    let no_template = fs::read_to_string(&files[0]).expect("a file").replacen("\"template\":24", "\"template\":99", 1);
    fs::write(path("none.jsonl"), no_template).expect("written");
    merge_with(&[&path("none.jsonl")], &path("new.jsonl"), "names a template that does not exist");
    fs::write(path("other.jsonl"), "kept").expect("written");
    merge_with(&[], &path("other.jsonl"), "exists with other contents");
    assert_eq!(fs::read_to_string(path("other.jsonl")).expect("a file"), "kept");
    let other_seed = path("other-seed.jsonl");
    let search = [&collect[..], &["--template", "0", "--seed", "1", "--out", &other_seed]].concat();
    output_of(&search);
    let named: Vec<&str> = files.iter().map(String::as_str).filter(|file| !file.ends_with("-0.jsonl")).collect();
    let out = path("new.jsonl");
    assert_refused(&[&["data", "merge"], &named[..], &[&other_seed, "--out", &out]].concat(), "`seed` is");
}

#[test]
fn a_search_that_was_interrupted_is_not_merged() {
    let folder = tempdir().expect("a folder");
    let collect = ["data", "collect", "--limit", "2", "--per-task", "1", "--max-rollouts", "20"];
    let files = shards(&collect, folder.path(), "solutions");
    let out = folder.path().join("merged.jsonl").display().to_string();
    let named: Vec<&str> = files.iter().map(String::as_str).collect();
    let merge = [&["data", "merge"], &named[..], &["--out", &out]].concat();
    let whole = fs::read_to_string(&files[7]).expect("a file");
    let begun: String = whole.split_inclusive('\n').take(2).collect();
    fs::write(&files[7], begun).expect("written");
    assert_refused(&merge, "continue it with the `pathlight-lab data collect` that began it");
    fs::write(&files[7], whole).expect("written");
    output_of(&merge);
}

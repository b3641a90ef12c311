//! `pathlight-lab figures`: the files show what was measured, and each describes it in words too.

use std::collections::BTreeMap;
use std::fs;

use pathlight_lab::measure::report::{Report, Score};
use svg::node::element::path::{Command, Data, Parameters};
use svg::node::element::tag::Type;
use svg::parser::Event;
use tempfile::tempdir;

use super::{assert_refused, output_of, root};

const FIGURES: [&str; 2] = ["strips", "curves"];

/// The measurements of the models on the page.
fn shipped() -> [Report; 2] {
    ["within", "cross"].map(|setup| Report::read(&root(&format!("results/shipped/{setup}-0.json")), "").expect("ours"))
}

/// Returns the text of all elements of a kind, in order; with a class, only of those that have it.
fn words(picture: &str, kind: &str, class: Option<&str>) -> Vec<String> {
    let (mut inside, mut found) = (false, Vec::new());
    for event in svg::read(picture).expect("SVG") {
        match event {
            Event::Error(error) => panic!("{error}"),
            Event::Tag(name, Type::Start, attributes) => {
                inside = name == kind && class.is_none_or(|one| attributes.get("class").is_some_and(|is| &**is == one));
            }
            Event::Tag(..) => inside = false,
            Event::Text(text) if inside => found.push(text.trim().to_string()),
            _ => {}
        }
    }
    found
}

#[test]
fn figures_hold_what_was_measured_and_say_it_in_words() {
    let folder = tempdir().expect("a folder");
    let [one, other] = ["one", "other"].map(|name| folder.path().join(name));
    for out in [&one, &other] {
        let printed = output_of(&["figures", "--out", &out.display().to_string()]);
        assert_eq!(printed.lines().count(), FIGURES.len() + 1, "{printed}");
    }
    let mut pictures = BTreeMap::new();
    for name in FIGURES {
        let file = format!("{name}.svg");
        let [made, again] = [&one, &other].map(|out| fs::read_to_string(out.join(&file)).expect("a figure"));
        assert!(made == again, "{name} is the same twice");
        assert!(made.contains("aria-labelledby=\"title desc\"") && made.contains("role=\"img\""), "{name}");
        let [title, described] = ["title", "desc"].map(|kind| words(&made, kind, None).concat());
        assert!(title.len() > 10 && described.len() > 200, "{name}: {title}: {described}");
        let page = fs::read_to_string(one.join("README.md")).expect("a page");
        assert!(page.contains(&format!("![{title}]({file})")), "{page}");
        pictures.insert(name, (made, described));
    }
    let size: usize = FIGURES.iter().map(|name| pictures[name].0.len()).sum();
    assert!(size < 700_000, "{size} bytes");

    check_curves(&pictures["curves"]);
    check_strips(&pictures["strips"]);
    // The strips need the nets, whose maps may differ in the last bit on another processor.
    for name in FIGURES.iter().filter(|name| **name != "strips") {
        let committed = fs::read_to_string(root(&format!("results/figures/{name}.svg"))).expect("a committed figure");
        assert!(committed == pictures[name].0, "results/figures/{name}.svg is old: run `pathlight-lab figures` again");
    }
}

/// Checks that each curve is labelled with its auccess, which is the area under the drawn curve.
fn check_curves((picture, described): &(String, String)) {
    let labels = words(picture, "text", None);
    let curves: Vec<(String, f64)> = svg::read(picture)
        .expect("SVG")
        .filter_map(|event| match event {
            Event::Tag("path", _, attributes) => Some((attributes["class"].to_string(), area(&attributes["d"]))),
            _ => None,
        })
        .collect();
    let reports = shipped();
    let scores: Vec<&Score> = reports.iter().flat_map(|report| &report.agents).collect();
    assert_eq!(curves.len(), scores.len());
    for Score { player, auccess, .. } in scores {
        let label = format!("{player} {auccess:.1}");
        assert!(labels.contains(&label) && described.contains(&label), "{label}: {labels:?}");
        let drawn = |(name, area): &(String, f64)| *name == player.to_string() && (100.0 * area - auccess).abs() < 0.1;
        assert!(curves.iter().any(drawn), "{label}: {curves:?}");
    }
}

/// Returns the share of the plot below a curve. The plot is 330 px wide and 230 px high, with its bottom at 268 px.
fn area(data: &str) -> f64 {
    let (mut x, mut y, mut area) = (0.0, 0.0, 0.0);
    for command in Data::parse(data).expect("a path").iter() {
        let number = |parameters: &Parameters, index: usize| f64::from(parameters[index]);
        match command {
            Command::Move(_, to) => (x, y) = (number(to, 0), number(to, 1)),
            Command::HorizontalLine(_, to) => {
                area += (number(to, 0) - x) * (268.0 - y);
                x = number(to, 0);
            }
            Command::VerticalLine(_, to) => y = number(to, 0),
            other => panic!("{other:?}"),
        }
    }
    area / (330.0 * 230.0)
}

/// Checks that the tasks are those that the rules choose.
fn check_strips((picture, described): &(String, String)) {
    for report in shipped() {
        let (setup, firsts) = (report.setup, &report.agents[0].first_solved);
        type Rule = fn(Option<usize>) -> bool;
        let rules: [(&str, Rule); 3] = [
            ("solved at once", |first| first == Some(1)),
            ("solved late", |first| first >= Some(10)),
            ("not solved", |first| first.is_none()),
        ];
        for (outcome, rule) in rules {
            let index = firsts.iter().position(|&first| rule(first)).expect("a task");
            let (id, attempt) = (report.tasks()[index].to_string(), firsts[index].unwrap_or(1));
            let sentence = described.split(&id).nth(1).expect("a sentence");
            assert!(sentence.contains(&format!("{setup}, fold 0, {outcome}")), "{id}: {sentence}");
            assert!(sentence.contains(&format!("attempt {attempt}, chance ")), "{id}: {sentence}");
            assert!(words(picture, "text", None).contains(&id));
        }
    }
    assert_eq!(picture.matches("class=\"map\"").count(), 6 * 4);
}

#[test]
fn what_is_missing_is_named_with_what_makes_it() {
    let folder = tempdir().expect("a folder");
    let path = |name: &str| folder.path().join(name).display().to_string();
    let figures = |results: &str| ["figures".to_string(), "--results".to_string(), path(results)];
    let refused = |words: &str| assert_refused(&figures("").each_ref().map(String::as_str), words);
    refused(
        "within-0.json: write it with `pathlight-lab measure evaluate --setup within --fold 0 --weights \
         assets/within-0.safetensors --json ",
    );
    fs::create_dir(folder.path().join("shipped")).expect("a folder");
    assert_refused(&["figures", "--out", &path("out"), "--assets", &path("")], "within-0.safetensors");
    fs::write(folder.path().join("shipped/within-0.json"), "{").expect("a file");
    refused(
        "within-0.json is damaged, or another command wrote it: write it again with `pathlight-lab measure evaluate \
         --setup within --fold 0 --weights assets/within-0.safetensors --json ",
    );
}

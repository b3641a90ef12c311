//! `pathlight-lab figures`: what the files show is what was measured, and each says it in words too.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use pathlight::benchmark::auccess::auccess;
use serde_json::Value;
use svg::node::element::path::{Command, Data, Parameters};
use svg::node::element::tag::Type;
use svg::parser::Event;
use tempfile::tempdir;

use super::{assert_refused, output_of, root};

const FIGURES: [&str; 6] = ["templates", "strips", "weakest", "curves", "auccess-by-template", "overlap-by-template"];

/// The first solving attempts on tasks of a template, or of all; from the reports of a group.
struct Agent {
    name: String,
    folds: Vec<Vec<(usize, Option<usize>)>>,
}

impl Agent {
    fn auccess(&self, template: Option<usize>) -> Option<f64> {
        let of_fold = |fold: &Vec<(usize, Option<usize>)>| -> Vec<Option<usize>> {
            let asked = fold.iter().filter(|(of, _)| template.is_none_or(|one| one == *of));
            asked.map(|&(_, first)| first).collect()
        };
        let scores: Vec<f64> =
            self.folds.iter().map(of_fold).filter(|firsts| !firsts.is_empty()).map(|firsts| auccess(&firsts)).collect();
        (!scores.is_empty()).then(|| scores.iter().sum::<f64>() / scores.len() as f64)
    }
}

fn json(path: &Path) -> Value {
    serde_json::from_slice(&fs::read(path).expect("a file")).expect("JSON")
}

/// The report of a fold, with the score of the paper's nets before that of DQN.
fn with_paper(file: &Path) -> Value {
    let mut report = json(file)["report"].take();
    let paper = json(&file.with_file_name("paper").join(file.file_name().expect("a name")));
    let place = |report: &Value, agent| {
        let agents = report["agents"].as_array().expect("agents");
        agents.iter().position(|score| score["agent"] == agent).expect("a score")
    };
    let (from, to) = (place(&paper, "paper"), place(&report, "dqn"));
    report["agents"].as_array_mut().expect("agents").insert(to, paper["agents"][from].clone());
    report
}

/// The agents of each group in the order of the figures, read from the JSON files.
fn groups() -> Vec<Vec<Agent>> {
    let shipped = ["within", "cross"].map(|setup| vec![json(&root(&format!("results/shipped/{setup}-0.json")))]);
    let reproduced = ["within", "cross"].map(|setup| {
        let files = (0..10).map(|fold| format!("results/{setup}-{fold}.json"));
        files.map(|file| root(&file)).filter(|file| file.exists()).map(|file| with_paper(&file)).collect()
    });
    shipped
        .into_iter()
        .chain(reproduced)
        .filter(|reports: &Vec<Value>| !reports.is_empty())
        .map(|reports| agents(&reports))
        .collect()
}

fn agents(reports: &[Value]) -> Vec<Agent> {
    let mut agents: Vec<Agent> = Vec::new();
    for score in reports.iter().flat_map(|report| report["agents"].as_array().expect("agents")) {
        let name = score["agent"].as_str().expect("a name").to_string();
        let firsts = score["first_solved"].as_array().expect("tasks").iter().map(|task| {
            let template = task[0].as_str().and_then(|id| id[..5].parse().ok()).expect("an id");
            (template, task[1].as_u64().map(|first| first as usize))
        });
        match agents.iter().position(|agent| agent.name == name) {
            Some(index) => agents[index].folds.push(firsts.collect()),
            None => agents.push(Agent { name, folds: vec![firsts.collect()] }),
        }
    }
    agents
}

/// The words of the elements of a kind that have this class, in their order; of all of the kind without a class.
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
    assert!(size < 1_500_000, "{size} bytes");

    let groups = groups();
    check_curves(&pictures["curves"], &groups);
    check_bars(&pictures["auccess-by-template"], &groups);
    check_overlaps(&pictures["overlap-by-template"]);
    check_strips(&pictures["strips"]);
    check_weakest(&pictures["weakest"], &groups);
    let (sheet, _) = &pictures["templates"];
    assert_eq!(words(sheet, "text", None).len(), 2 * 25);
    // The strips need the nets, whose maps may differ in the last bit on another processor.
    for name in FIGURES.iter().filter(|name| !["strips", "weakest"].contains(name)) {
        let committed = fs::read_to_string(root(&format!("results/figures/{name}.svg"))).expect("a committed figure");
        assert!(committed == pictures[name].0, "results/figures/{name}.svg is old: run `pathlight-lab figures` again");
    }
}

/// Each curve's label is its auccess, which is the area under the curve that is drawn.
fn check_curves((picture, described): &(String, String), groups: &[Vec<Agent>]) {
    let labels = words(picture, "text", None);
    let curves: Vec<(String, f64)> = svg::read(picture)
        .expect("SVG")
        .filter_map(|event| match event {
            Event::Tag("path", _, attributes) => Some((attributes["class"].to_string(), area(&attributes["d"]))),
            _ => None,
        })
        .collect();
    let agents: Vec<&Agent> = groups.iter().flatten().collect();
    assert_eq!(curves.len(), agents.len());
    for agent in agents {
        let score = agent.auccess(None).expect("tasks");
        let label = format!("{} {score:.1}", agent.name);
        assert!(labels.contains(&label) && described.contains(&label), "{label}: {labels:?}");
        let drawn = |(name, area): &(String, f64)| *name == agent.name && (100.0 * area - score).abs() < 0.1;
        assert!(curves.iter().any(drawn), "{label}: {curves:?}");
    }
}

/// The share of the plot that lies below a curve: 330 px wide, 230 px high, its bottom at 268 px.
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

fn check_bars((picture, described): &(String, String), groups: &[Vec<Agent>]) {
    let rows = || (0..25).map(Some).chain([None]);
    let scores = |agent: &Agent| rows().filter_map(|template| agent.auccess(template)).collect::<Vec<_>>();
    let expected: Vec<String> = groups.iter().flatten().flat_map(scores).map(|score| format!("{score:.0}")).collect();
    assert_eq!(words(picture, "text", Some("value")), expected);
    let random = groups[0].last().expect("agents").auccess(Some(0)).expect("tasks");
    assert!(described.contains("00000 Two Drops: within") && described.contains(&format!("random {random:.0}")));
}

fn check_overlaps((picture, _): &(String, String)) {
    let parts =
        ["/base", "/target", "/action", "/solved/object", "/not_solved/object", "/solved/ball", "/not_solved/ball"];
    let mut expected = Vec::new();
    for setup in ["within", "cross"] {
        let measured = json(&root(&format!("results/shipped/{setup}-0-forecasts.json")));
        let templates = measured["templates"].as_array().expect("templates").iter().map(|one| &one["overlap"]);
        let rows: Vec<&Value> = templates.chain([&measured["all"]]).collect();
        for part in parts {
            let values = rows.iter().filter_map(|row| row.pointer(part).expect("a value").as_f64());
            expected.extend(values.map(|value| format!("{value:.2}")));
        }
    }
    assert_eq!(words(picture, "text", Some("value")), expected);
}

/// The tasks are those of the rule.
fn check_strips((picture, described): &(String, String)) {
    for setup in ["within", "cross"] {
        let report = json(&root(&format!("results/shipped/{setup}-0.json")));
        let tasks = report["agents"][0]["first_solved"].as_array().expect("tasks");
        type Rule = fn(Option<u64>) -> bool;
        let rules: [(&str, Rule); 3] = [
            ("solved at once", |first| first == Some(1)),
            ("solved late", |first| first >= Some(10)),
            ("not solved", |first| first.is_none()),
        ];
        for (outcome, rule) in rules {
            let chosen = tasks.iter().find(|task| rule(task[1].as_u64())).expect("a task");
            let (id, attempt) = (chosen[0].as_str().expect("an id"), chosen[1].as_u64().unwrap_or(1));
            let sentence = described.split(id).nth(1).expect("a sentence");
            assert!(sentence.contains(&format!("{setup}, fold 0, {outcome}")), "{id}: {sentence}");
            assert!(sentence.contains(&format!("attempt {attempt}, chance ")), "{id}: {sentence}");
            assert!(words(picture, "text", None).iter().any(|text| text == id));
        }
    }
    assert_eq!(picture.matches("class=\"map\"").count(), 6 * 4);
}

/// The templates are those of the lowest auccess, and the tasks were not solved at once.
fn check_weakest((picture, described): &(String, String), groups: &[Vec<Agent>]) {
    for (setup, agents) in ["within", "cross"].into_iter().zip(groups) {
        let online = &agents[0];
        let mut scores: Vec<(usize, f64)> =
            (0..25).filter_map(|template| Some((template, online.auccess(Some(template))?))).collect();
        scores.sort_by(|one, other| one.1.total_cmp(&other.1));
        for (template, score) in &scores[..3] {
            let not_at_once = |&&(of, first): &&(usize, Option<usize>)| of == *template && first != Some(1);
            let (_, first) = online.folds[0].iter().find(not_at_once).expect("a task");
            let name = format!("{template:05}:");
            let strip = format!("{setup}, fold 0, template's auccess {score:.0}: ");
            let mut sentences = described.split(&name).skip(1).filter(|sentence| sentence.contains(&strip));
            let sentence = sentences.next().expect("a sentence");
            assert!(sentence.contains(&format!("attempt {}, chance ", first.unwrap_or(1))), "{sentence}");
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
    for name in ["shipped/within-0.json", "shipped/cross-0.json", "within-0.json"] {
        fs::copy(root("results").join(name), folder.path().join(name)).expect("a copy");
        if name == "shipped/cross-0.json" {
            refused("holds no results: run `pathlight-lab reproduce` first");
        }
    }
    refused(
        "within-0-forecasts.json: write it with `pathlight-lab measure forecasts --setup within --fold 0 --weights \
         assets/within-0.safetensors --json ",
    );
    let without = path("no-solutions.jsonl");
    assert_refused(&["figures", "--out", &path("out"), "--solutions", &without], "no-solutions.jsonl");
    assert_refused(&["figures", "--out", &path("out"), "--assets", &path("")], "within-0.safetensors");
    fs::write(folder.path().join("shipped/within-0.json"), "{").expect("a file");
    refused(
        "within-0.json is damaged, or another command wrote it: write it again with `pathlight-lab measure evaluate \
         --setup within --fold 0 --weights assets/within-0.safetensors --json ",
    );
}

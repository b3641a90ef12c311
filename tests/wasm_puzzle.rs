//! The wasm exports that need no document, called from Node in the same way as by the page and by scripts.
#![cfg(target_arch = "wasm32")]

use js_sys::{JSON, Number, Object, Reflect};
use pathlight::nets::{Card, DynamicsCard, DynamicsNet, LearnedFrom, Optimiser, PathNet, PathWeights, SuccessCard};
use pathlight::web::{
    Model, OpenPuzzle, SolutionSearch, SolveMap, attempt_line, auccess, constants, custom_scene, difficulty, fold,
    luck, raster, scene_digest, scene_limits, scene_problems, simulate, soft_iou, templates, verify_attempt,
    why_invalid,
};
use serde_json::{Value, json};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

const TASK: &str = "00000:000";
const WEIGHTS: &[u8] = include_bytes!("../assets/within-0.safetensors");
const TYPES: &str = include_str!("../src/web/types.d.ts");

/// Returns a JavaScript value of JSON.
fn js<T: From<JsValue>>(value: &Value) -> T {
    JSON::parse(&value.to_string()).expect("JSON").into()
}

fn task<T: From<JsValue>>() -> T {
    js(&json!(TASK))
}

/// Returns the JSON of a JavaScript value, in which typed arrays are objects.
fn json(value: impl Into<JsValue>) -> Value {
    let text = JSON::stringify(&value.into()).expect("plain data").as_string().expect("a value");
    serde_json::from_str(&text).expect("JSON")
}

/// Returns the values of a typed array.
fn values(from: &Value, name: &str) -> Vec<f64> {
    let array = from[name].as_object().expect("a typed array");
    (0..array.len()).map(|index| array[&index.to_string()].as_f64().expect("a number")).collect()
}

/// Returns the code of an error, which must be a JavaScript `Error` with a sentence.
fn code(error: JsValue) -> String {
    let error: js_sys::Error = error.dyn_into().expect("a real Error");
    assert!(String::from(error.message()).len() > 10, "an error says what is wrong");
    Reflect::get(&error, &"code".into()).expect("an object").as_string().expect("a code")
}

/// Returns the fields of a type of `types.d.ts`, sorted; optional ones end in `?`.
fn declared(name: &str) -> Vec<String> {
    let start = ["interface", "type"].iter().find_map(|kind| TYPES.find(&format!("export {kind} {name} ")));
    let text =
        TYPES[start.unwrap_or_else(|| panic!("no type {name}"))..].split("\n\n").next().expect("its declaration");
    let is_comment = |line: &&str| ["/**", "*"].iter().any(|sign| line.trim_start().starts_with(sign));
    let (mut head, mut body, mut depth) = (String::new(), String::new(), 0);
    for character in text.lines().filter(|line| !is_comment(line)).flat_map(str::chars) {
        depth -= i32::from(character == '}');
        match depth {
            0 => head.push(character),
            1 => body.push(character),
            _ => {}
        }
        depth += i32::from(character == '{');
    }
    let own = body.split(';').filter_map(|field| Some(field.split_once(':')?.0.trim().to_string()));
    // The keys of Record and Pick.
    let optional = if head.contains("Partial<") { "?" } else { "" };
    let keys = head.split('"').skip(1).step_by(2).map(|key| format!("{key}{optional}"));
    let bases = head.split_once("extends ").map_or("", |(_, bases)| bases).split([',', '{']).map(str::trim);
    let is_name = |base: &&str| !base.is_empty() && base.chars().all(char::is_alphanumeric);
    let mut fields: Vec<String> = own.chain(keys).chain(bases.filter(is_name).flat_map(declared)).collect();
    fields.sort_unstable();
    fields
}

/// Returns the scene of a puzzle.
fn scene(puzzle: &Value) -> Value {
    json(OpenPuzzle::new(js(puzzle)).expect("it opens").about().expect("facts"))["scene"].take()
}

fn fields(value: &Value) -> Vec<String> {
    let mut fields: Vec<String> = value.as_object().expect("an object").keys().cloned().collect();
    fields.sort_unstable();
    fields
}

/// Returns the fields of a value with all optional fields, sorted; those that the minimal value lacks end in `?`.
fn fields_of_all(fullest: &Value, barest: &Value) -> Vec<String> {
    let barest = fields(barest);
    let marked = |field: String| if barest.contains(&field) { field } else { field + "?" };
    fields(fullest).into_iter().map(marked).collect()
}

#[wasm_bindgen_test]
fn every_template_opens() {
    let list = json(templates().expect("a list"));
    let list = list.as_array().expect("an array");
    assert_eq!((list.len(), fields(&list[0])), (25, declared("Template")));
    for template in list {
        assert_eq!(template["tasks"].as_array().expect("tasks").len(), 100);
        let first = &template["tasks"][0];
        let about = json(OpenPuzzle::new(js(first)).expect("it opens").about().expect("facts"));
        assert_eq!((fields(&about), &about["id"], &about["name"]), (declared("About"), first, &Value::Null));
    }
    assert_eq!(fields(&json(difficulty(TASK).expect("two figures"))), declared("Difficulty"));
}

#[wasm_bindgen_test]
fn an_unknown_task_is_an_error_with_a_code() {
    for id in ["", "00007", "00025:000", "00000:999", "7:13"] {
        assert_eq!(code(OpenPuzzle::new(js(&json!(id))).err().expect("refused")), "bad_task", "{id}");
        assert_eq!(code(difficulty(id).expect_err("refused")), "bad_task", "{id}");
    }
    assert_eq!(code(SolveMap::new(js(&json!(7)), 12.0).err().expect("refused")), "bad_task");
}

#[wasm_bindgen_test]
fn an_invalid_ball_names_what_it_overlaps() {
    let puzzle = OpenPuzzle::new(task()).expect("a task");
    // Two Drops has a green ball; a red one at its position overlaps it.
    let scene = scene(&json!(TASK));
    assert_eq!((fields(&scene), fields(&scene["bodies"][0])), (declared("Scene"), declared("Body")));
    let [x, y] = ["x", "y"].map(|key| scene["bodies"][0][key].as_f64().expect("a number"));
    let why = |x, y, r| puzzle.why_invalid(x, y, r).expect("a reason");
    assert_eq!(json(why(x, y, 5.0)), json!({"kind": "overlaps", "body": 0}));
    assert_eq!(json(why(1.0, 250.0, 9.0)), json!({"kind": "outside"}));
    assert_eq!(json(why(128.0, 250.0, 99.0)), json!({"kind": "radius"}));
    assert!(why(128.0, 250.0, 4.0).is_undefined());
    let phrase = why_invalid(task(), js(&json!([x, y, 5]))).expect("a task");
    assert_eq!(phrase.as_deref(), Some("the ball overlaps the green ball"));
    assert_eq!(code(puzzle.rollout(js(&json!([x, y, 5]))).expect_err("refused")), "invalid_ball");
    for ball in [json!("ball"), json!([1, 2]), json!([128, 230, 8, 1]), json!({"x": 1})] {
        assert_eq!(code(puzzle.rollout(js(&ball)).expect_err("refused")), "bad_data", "{ball}");
        assert_eq!(code(simulate(task(), js(&ball)).expect_err("refused")), "bad_data", "{ball}");
    }
}

#[wasm_bindgen_test]
fn a_script_simulates_what_an_open_puzzle_answers() {
    let puzzle = OpenPuzzle::new(task()).expect("a task");
    let [x, y, r] = puzzle.nearest_place(128.0, 230.0, 8.0).expect("there is room").try_into().expect("a ball");
    let ball = json!([x, y, r]);
    let facts = json(puzzle.rollout(js(&ball)).expect("a valid ball"));
    assert_eq!((fields(&facts), fields(&facts["ending"])), (declared("RolloutFacts"), declared("Ending")));
    assert_eq!(facts["line"], json(attempt_line(task(), js(&ball)).expect("a line")));
    assert_eq!(["object", "ball"].map(|path| values(&facts["paths"], path).len()), [32; 2]);
    let simulated = json(simulate(task(), js(&ball)).expect("a rollout"));
    assert_eq!(fields(&simulated), declared("Rollout"));
    assert_eq!(simulated["reason"], Value::Null);
    for name in declared("Ending") {
        assert_eq!(facts["ending"][&name], simulated[&name], "{name}");
    }
    let steps = simulated["steps"].as_u64().expect("a number") as usize;
    assert!(facts["last"].as_u64() <= Some(steps as u64), "the page may stop when all lies still");
    let [bodies, poses, touching] = ["bodies", "poses", "touching"].map(|name| values(&simulated, name));
    assert_eq!((touching.len(), poses.len()), (steps + 1, (steps + 1) * bodies.len() * 3));
    let body_count = scene(&json!(TASK))["bodies"].as_array().expect("bodies").len();
    assert_eq!(bodies.last(), Some(&(body_count as f64)), "the ball comes last");
    assert_eq!(poses[3 * (bodies.len() - 1)..][..2], [x, y].map(|place| f64::from(place as f32)));

    // More balls than are cached, and then the first again.
    for x in 60..80 {
        let _ = puzzle.rollout(js(&json!([x, 230, 8])));
    }
    assert_eq!(json(puzzle.rollout(js(&ball)).expect("a valid ball")), facts);
    assert_eq!(json(puzzle.rollout(js(&Value::Null)).expect("the scene alone"))["paths"], Value::Null);

    let invalid = json(simulate(task(), js(&json!([1, 250, 9]))).expect("an outcome"));
    assert_eq!((&invalid["status"], &invalid["steps"]), (&json!("invalid"), &json!(0)));
    assert_eq!(invalid["reason"], json!(why_invalid(task(), js(&json!([1, 250, 9]))).expect("a task")));
    assert_eq!(raster(task()).expect("five channels").len(), 5 * 64 * 64);
}

#[wasm_bindgen_test]
fn the_real_paths_are_masks() {
    let puzzle = OpenPuzzle::new(task()).expect("a task");
    let paths = json(puzzle.path_masks(js(&json!([128, 250, 4]))).expect("two paths"));
    let mask = |name: &str| values(&paths, name).iter().map(|&value| value as f32).collect::<Vec<f32>>();
    let (object, ball) = (mask("object"), mask("ball"));
    assert_eq!(soft_iou(&object, &object).expect("two maps"), 1.0);
    assert!(soft_iou(&object, &ball).expect("two maps") < 1.0);
    let alone = json(puzzle.path_masks(js(&Value::Null)).expect("a path"));
    assert_eq!(fields_of_all(&paths, &alone), ["ball?", "object"]);
    assert_eq!(fields_of_all(&paths, &alone), declared("PathMasks"));
}

#[wasm_bindgen_test]
fn a_sketch_of_any_points_is_a_mask_that_holds_the_green_object() {
    let puzzle = OpenPuzzle::new(task()).expect("a task");
    let bare = puzzle.sketch_mask(&[]);
    assert!(bare.iter().sum::<f32>() > 0.0);
    let points: &[&[f64]] = &[&[1.0], &[f64::NAN, f64::INFINITY, -1e300, 1e300], &[-5.0, 900.0, 10.0, 10.0]];
    for points in points {
        let sketch = puzzle.sketch_mask(points);
        assert_eq!(sketch.len(), bare.len());
        assert!(bare.iter().zip(&sketch).all(|(bare, drawn)| bare <= drawn), "{points:?}");
    }
    assert_eq!(puzzle.sketch_mask(&[200.0, 20.0, 200.0, 200.0])[25 * 64 + 50], 1.0, "half way");
}

#[wasm_bindgen_test]
fn metrics_refuse_malformed_maps_and_lists() {
    assert_eq!(code(soft_iou(&[0.0; 9], &[0.0; 9]).expect_err("too small")), "bad_map");
    assert_eq!(code(auccess(&"soup".into()).expect_err("no list")), "bad_data");
    let score = |firsts: Value| auccess(&js(&firsts));
    assert_eq!(score(json!([1, null])).expect("two tasks"), 50.0);
    for first in [json!(0), json!(-1), json!(1.5), json!("1"), json!([1])] {
        let refused: js_sys::Error = score(json!([1, first])).expect_err("refused").dyn_into().expect("a real Error");
        let said = String::from(refused.message());
        assert!(said.contains("item 1") && said.ends_with(&format!("counted from 1, or null, not {first}")), "{said}");
    }
}

#[wasm_bindgen_test]
fn the_folds_are_those_of_the_benchmark() {
    let within = json(fold("within".into(), &0.into()).expect("a fold"));
    assert_eq!(["train", "dev", "test"].map(|part| within[part].as_array().expect("a list").len()), [1600, 400, 500]);
    for number in [-1.0, 0.5, 10.0, f64::NAN] {
        assert_eq!(code(fold("cross".into(), &number.into()).expect_err("refused")), "bad_data");
    }
    assert_eq!(code(fold("both".into(), &0.into()).expect_err("refused")), "bad_data");
}

#[wasm_bindgen_test]
fn a_solve_map_fills_up_and_refuses_radii() {
    assert_eq!(code(SolveMap::new(task(), f64::NAN).err().expect("refused")), "invalid_ball");
    let mut map = SolveMap::new(task(), 32.0).expect("a map");
    assert!(map.outcomes().iter().all(|&outcome| outcome == 0));
    for _ in 0..64 {
        assert!(map.advance());
    }
    assert_eq!(map.progress(), 64.0 / 4096.0);
    assert!(map.outcomes().iter().all(|outcome| (1..=3).contains(outcome)));
}

#[wasm_bindgen_test]
fn a_model_says_how_it_was_trained_and_proposes_balls() {
    assert_eq!(code(Model::new(&[1, 2, 3], None).err().expect("refused")), "bad_weights");
    let model = Model::new(WEIGHTS, None).expect("the shipped weights");
    let card: Card = serde_json::from_value(json(model.card().expect("a card"))).expect("a card");
    let (_, shipped) = PathNet::load(WEIGHTS).expect("the shipped weights");
    assert_eq!(card, shipped, "its fields are those of the test below");
    let propose = |seed: Value, count: Option<f64>| model.propose(task(), &js(&seed), count.map(Number::from));
    let proposals = json(propose(json!(0), None).expect("proposals"));
    assert_eq!(proposals.as_array().expect("a list").len(), 100);
    assert_eq!(fields(&proposals[0]), declared("Proposal"));
    assert_eq!(proposals[0]["origin"]["kind"], "imagined");
    assert_eq!(json(propose(json!(u32::MAX), Some(3.0)).expect("three")).as_array().expect("a list").len(), 3);
    for count in [0.0, 2.5, -1.0, 1001.0, f64::INFINITY, f64::NAN] {
        assert_eq!(code(propose(json!(0), Some(count)).expect_err("refused")), "bad_data", "{count}");
    }
    for seed in [json!(-1), json!(1.5), json!("a"), json!(1_u64 << 32), json!(null)] {
        assert_eq!(code(propose(seed.clone(), None).expect_err("refused")), "bad_data", "{seed}");
        assert_eq!(code(model.turn(task(), &js(&seed)).err().expect("refused")), "bad_data", "{seed}");
    }
}

#[wasm_bindgen_test]
fn cards_have_the_fields_that_their_types_declare() {
    let (_, shipped) = PathNet::load(WEIGHTS).expect("weights");
    let success = SuccessCard {
        seed: 0,
        epochs: 1,
        batch: 1,
        balls_per_scene: 1,
        optimiser: Optimiser::Muon,
        learning_rate: 0.1,
        balls: 1,
    };
    let dynamics = shipped.dynamics.clone().expect("the shipped weights have a dynamics net");
    let barest = DynamicsCard {
        optimiser: Optimiser::Adam,
        path_weights: PathWeights::default(),
        unlisted: 0,
        random_scenes: 0,
        learned_from: LearnedFrom::Tasks,
        from: None,
        ..dynamics.clone()
    };
    let fullest = DynamicsCard {
        optimiser: Optimiser::Muon,
        path_weights: PathWeights { all: 2.0, solving: 4.0 },
        unlisted: 1,
        random_scenes: 1,
        learned_from: LearnedFrom::RandomScenes,
        from: Some("0".repeat(64)),
        ..dynamics
    };
    let json = |card: &Card| serde_json::to_value(card).expect("JSON");
    let with_adam = SuccessCard { optimiser: Optimiser::Adam, ..success.clone() };
    let bare = json(&Card { success: Some(with_adam), dynamics: Some(barest), ..shipped.clone() });
    let full = json(&Card { success: Some(success), dynamics: Some(fullest), ..shipped.clone() });
    let none = json(&Card { success: None, dynamics: None, ..shipped });
    assert_eq!(fields_of_all(&full, &none), declared("ModelCard"));
    assert_eq!(fields_of_all(&full["dynamics"], &bare["dynamics"]), declared("DynamicsCard"));
    assert_eq!(fields_of_all(&full["success"], &bare["success"]), declared("SuccessCard"));
    assert!(TYPES.contains("path_weights?: { all: number; solving: number };"));
    assert_eq!(fields(&full["dynamics"]["path_weights"]), ["all", "solving"]);
}

#[wasm_bindgen_test]
fn the_model_imagines_each_map() {
    let model = Model::new(WEIGHTS, None).expect("the shipped weights");
    let maps = model.imagine(task()).expect("maps");
    let names = json(Object::keys(&maps));
    assert_eq!(json(constants().expect("constants"))["maps"], names, "in the order of the constants");
    let names = names.as_array().expect("a list");
    let maps = json(maps);
    assert!(names.iter().all(|name| values(&maps, name.as_str().expect("a name")).len() == 64 * 64));
}

#[wasm_bindgen_test]
fn a_ball_is_imagined_by_weights_that_have_a_dynamics_net() {
    let (mut nets, mut card) = PathNet::load(WEIGHTS).expect("the shipped weights");
    let of_dynamics = card.dynamics.take();
    nets.dynamics = None;
    let without = Model::new(&nets.save(&card).expect("weights"), None).expect("a model");
    assert!(without.imagine_ball(task(), js(&json!([128, 230, 8]))).expect("no error").is_undefined());
    assert!(without.candidates(task()).expect("no error").is_undefined());
    (nets.dynamics, card.dynamics) = (Some(DynamicsNet::fresh(0)), of_dynamics);
    let model = Model::new(&nets.save(&card).expect("weights"), None).expect("a model");
    let imagine = |id: &str, ball: Value| model.imagine_ball(js(&json!(id)), js(&ball));
    let imagined = |id: &str, x: u32| json(imagine(id, json!([x, 230, 8])).expect("a valid ball"));
    let first = imagined(TASK, 128);
    assert_eq!(fields(&first), declared("ImaginedBall"));
    for (name, length) in [("steps", 16), ("object", 32), ("ball", 32), ("errors", 32)] {
        assert_eq!(values(&first, name).len(), length, "{name}");
    }
    assert!(first["probability"].as_f64().is_some_and(|probability| (0.0..=1.0).contains(&probability)));
    // The last task is cached; another one is read again.
    assert_ne!(imagined("00007:008", 128)["object"], first["object"]);
    assert_eq!(imagined(TASK, 128), first);
    assert_ne!(imagined(TASK, 90)["ball"], first["ball"]);
    let candidate = &json(model.candidates(task()).expect("candidates"))[0];
    assert_eq!((fields(candidate), values(candidate, "object").len()), (declared("Candidate"), 32));
    let tried = json(model.turn(task(), &0.into()).expect("a turn").attempt().expect("an attempt"));
    let with_reminder = [fields(&tried), vec!["reminder?".to_string()]].concat();
    assert_eq!((with_reminder, &tried["origin"]["kind"]), (declared("TriedProposal"), &json!("imagined")));
    let refused = |id: &str, ball: Value| code(imagine(id, ball).expect_err("refused"));
    assert_eq!(refused(TASK, json!([2, 2, 8])), "invalid_ball");
    assert_eq!(refused(TASK, Value::Null), "bad_data");
    assert_eq!(refused("7:1", json!([128, 230, 8])), "bad_task");
}

#[wasm_bindgen_test]
fn a_custom_scene_takes_the_place_of_its_task() {
    let custom = json(custom_scene(task()).expect("a task"));
    assert_eq!(scene(&custom), scene(&json!(TASK)));
    assert_eq!(raster(js(&custom)).expect("channels"), raster(task()).expect("channels"));
    let about = json(OpenPuzzle::new(js(&custom)).expect("it opens").about().expect("facts"));
    assert_eq!((&about["id"], &about["name"]), (&Value::Null, &Value::Null));
    assert_eq!(about["digest"], json!(scene_digest(&js(&custom)).expect("a scene")));
    assert_eq!(json(scene_problems(&js(&custom)).expect("a list")), json!([]));
    assert_eq!(fields(&json(scene_limits().expect("limits"))), declared("SceneLimits"));
    let line = |puzzle: &Value| json(attempt_line(js(puzzle), js(&Value::Null)).expect("a line"));
    let (of_custom, of_task) = (line(&custom), line(&json!(TASK)));
    assert_eq!((&of_custom["digest"], of_custom.get("task")), (&of_task["digest"], None));
    for line in [&of_custom, &of_task] {
        assert_eq!(json(verify_attempt(&js(line)).expect("a verdict"))["verdict"], "same");
    }
    let mut search = SolutionSearch::new(js(&custom)).expect("it begins");
    assert!(search.advance());
    assert_eq!(fields(&json(search.found().expect("an object"))), declared("FoundSolutions"));
    let lucky = luck(js(&custom), js(&json!([128, 250, 4]))).expect("two counts");
    assert_eq!(fields(&json(lucky)), declared("Luck"));
}

#[wasm_bindgen_test]
fn the_numbers_of_a_custom_scene_are_read_to_the_last_bit() {
    let mut custom = json(custom_scene(task()).expect("a task"));
    // Of these angles a fast reader of decimals gets some wrong, like 0.13659098493868665.
    for part in 1..200 {
        custom["bodies"][0]["angle"] = json!(std::f64::consts::PI / f64::from(part));
        assert_eq!(json(custom_scene(js(&custom)).expect("a scene")), custom);
    }
}

#[wasm_bindgen_test]
fn foreign_values_are_sentences_and_never_crash() {
    let nested = (0..20_000).fold(JsValue::NULL, |inner, _| js_sys::Array::of1(&inner).into());
    let deep = Object::new();
    Reflect::set(&deep, &"version".into(), &nested).expect("an object");
    Reflect::set(&deep, &"bodies".into(), &nested).expect("an object");
    let circular = Object::new();
    Reflect::set(&circular, &"version".into(), &circular).expect("an object");
    for value in [
        JsValue::UNDEFINED,
        JsValue::NULL,
        7.into(),
        "soup".into(),
        js(&json!({"version": 1})),
        deep.into(),
        circular.into(),
    ] {
        let problems = json(scene_problems(&value).expect("a list"));
        assert!(problems[0]["sentence"].as_str().is_some_and(|sentence| sentence.ends_with('.')));
        assert_eq!(json(verify_attempt(&value).expect("a verdict"))["verdict"], "not_valid");
    }
    let line = json(attempt_line(task(), js(&Value::Null)).expect("a line"));
    for (key, name) in [("task", "beach"), ("task", "00000:999"), ("task", "00099:000"), ("engine", "rapier")] {
        let mut line = line.clone();
        line[key] = name.into();
        let verdict = json(verify_attempt(&js(&line)).expect("a verdict"));
        let reason = verdict["reason"].as_str().expect("a sentence");
        assert!(reason.contains(name.split(':').next().expect("a part")) && !reason.contains("variant"), "{reason}");
    }
    let mut custom = json(custom_scene(task()).expect("a task"));
    custom["bodies"][0]["x"] = 999.into();
    assert_eq!(code(simulate(js(&custom), js(&Value::Null)).expect_err("refused")), "bad_scene");
    assert_eq!(code(scene_digest(&js(&custom)).expect_err("refused")), "bad_scene");
    assert_eq!(json(scene_problems(&js(&custom)).expect("a list"))[0]["body"], 0);
}

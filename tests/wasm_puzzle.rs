//! The wasm exports that need no document, called from Node as the page calls them.
#![cfg(target_arch = "wasm32")]

use js_sys::Reflect;
use pathlight::nets::{Card, DynamicsCard, DynamicsNet, Optimiser, PathNet, PathWeights, SuccessCard};
use pathlight::session::game::ATTEMPT_LIMIT;
use pathlight::web::{
    Game, Model, OpenPuzzle, SolutionSearch, SolveMap, attempt_line, auccess, constants, custom_scene, fold, luck,
    palette, raster, scene, scene_problems, simulate, soft_iou, templates, verify_attempt, why_invalid,
};
use serde_json::{Value, json};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;

const TASK: &str = "00000:000";

fn json(value: JsValue) -> Value {
    serde_wasm_bindgen::from_value(value).expect("plain data")
}

/// Returns the code of an error, which must be a JavaScript `Error` with a sentence.
fn code(error: JsValue) -> String {
    let error: js_sys::Error = error.dyn_into().expect("a real Error");
    assert!(String::from(error.message()).len() > 10, "an error says what is wrong");
    Reflect::get(&error, &"code".into()).expect("an object").as_string().expect("a code")
}

fn open(id: &str) -> Game {
    Game::new(id.into()).unwrap_or_else(|error| panic!("{id} does not open: {error:?}"))
}

/// Returns valid balls all over the scene.
fn balls(game: &Game) -> impl Iterator<Item = (f64, f64, f64)> {
    let all = (1..25).flat_map(|x| (1..25).flat_map(move |y| [4, 10, 20].map(|r| (x * 10, y * 10, r))));
    all.map(|(x, y, r)| (f64::from(x), f64::from(y), f64::from(r)))
        .filter(|&(x, y, r)| game.why_invalid(x, y, r).is_ok_and(|reason| reason.is_undefined()))
}

#[wasm_bindgen_test]
fn every_template_opens_with_its_name_and_goal() {
    let list = json(templates().expect("a list"));
    let list = list.as_array().expect("an array");
    assert_eq!(list.len(), 25);
    for template in list {
        assert_eq!(template["tasks"].as_array().expect("tasks").len(), 100);
        let first = template["tasks"][0].as_str().expect("an id");
        let about = json(open(first).about().expect("facts"));
        assert_eq!(about["id"], first);
        assert_eq!(about["name"], Value::Null);
        assert_eq!(about["scene"], json(scene(first.into()).expect("a scene")));
    }
}

#[wasm_bindgen_test]
fn an_unknown_task_is_an_error_with_a_code() {
    for id in ["", "00007", "00025:000", "00000:999", "7:13"] {
        assert_eq!(code(Game::new(id.into()).err().expect("refused")), "bad_task", "{id}");
    }
}

#[wasm_bindgen_test]
fn an_invalid_ball_names_what_it_overlaps_and_does_not_count() {
    let mut game = open(TASK);
    // Two Drops has a green ball; a red one at its place overlaps it.
    let scene = json(game.about().expect("facts"))["scene"].clone();
    let [x, y] = ["x", "y"].map(|key| scene["bodies"][0][key].as_f64().expect("a number"));
    let why = |x, y, r| json(game.why_invalid(x, y, r).expect("a reason"));
    assert_eq!(why(x, y, 5.0), serde_json::json!({"kind": "overlaps", "body": 0}));
    assert_eq!(why(1.0, 250.0, 9.0), serde_json::json!({"kind": "outside"}));
    assert!(game.why_invalid(128.0, 250.0, 4.0).expect("none").is_undefined());
    assert_eq!(code(game.attempt(x, y, 5.0).expect_err("refused")), "invalid_ball");
    assert_eq!(json(game.standing("player").expect("a score"))["used"], 0);
    assert_eq!(game.steps(), 0);
}

#[wasm_bindgen_test]
fn attempts_run_until_solved_and_replay_the_same() {
    let mut game = open(TASK);
    let tries: Vec<_> = balls(&game).collect();
    let mut solved = None;
    for (x, y, r) in tries {
        if json(game.standing("player").expect("a score"))["used"] == ATTEMPT_LIMIT {
            game.clear("player").expect("cleared");
        }
        let attempt = json(game.attempt(x, y, r).expect("valid"));
        if attempt["ending"]["solved"] == true {
            solved = Some((attempt, game.steps()));
            break;
        }
    }
    let (attempt, steps) = solved.expect("one of the balls solves Two Drops");
    game.reset();
    assert_eq!(game.steps(), 0);
    let number = attempt["number"].as_u64().expect("a number") as usize;
    assert_eq!(json(game.replay("player", &number.into()).expect("made")), attempt);
    assert_eq!(game.steps(), steps);
    assert_eq!(json(game.standing("player").expect("a score"))["solved_at"], number);
    // The object touched its goal for the last three seconds.
    let touches = json(game.touches().expect("intervals"));
    let last = touches.as_array().and_then(|all| all.last()).expect("it touched");
    assert_eq!(last[1], steps);
}

#[wasm_bindgen_test]
fn two_attempts_are_overlaid_and_one_is_removed() {
    let mut game = open(TASK);
    let tries: Vec<_> = balls(&game).take(2).collect();
    let made: Vec<_> = tries.iter().map(|&(x, y, r)| json(game.attempt(x, y, r).expect("valid"))).collect();
    let steps = |game: &mut Game, number: u32| {
        game.replay("player", &number.into()).expect("made");
        game.steps()
    };
    let longest = steps(&mut game, 1).max(steps(&mut game, 2));
    let pair = json(game.overlay("player", &2.into(), "player", &1.into()).expect("both made"));
    assert_eq!((&pair[0], &pair[1]), (&made[1], &made[0]));
    assert_eq!(game.steps(), longest);
    assert_eq!(code(game.overlay("player", &1.into(), "model", &1.into()).expect_err("refused")), "no_attempt");

    game.remove("player", &1.into()).expect("made");
    assert_eq!(json(game.attempts("player").expect("a list"))[0]["ball"], made[1]["ball"]);
    for number in [2.0, 1.9, 4_294_967_297.0, -4_294_967_295.0, f64::NAN] {
        assert_eq!(code(game.remove("player", &number.into()).expect_err("refused")), "no_attempt", "{number}");
    }
}

#[wasm_bindgen_test]
fn what_was_never_tried_cannot_be_replayed() {
    let mut game = open(TASK);
    for number in [0, 1] {
        assert_eq!(code(game.replay("player", &number.into()).expect_err("refused")), "no_attempt");
    }
    assert_eq!(code(game.replay("nobody", &1.into()).expect_err("refused")), "bad_data");
    assert_eq!(code(game.add_model_attempt(JsValue::from("ball")).expect_err("refused")), "bad_data");
}

#[wasm_bindgen_test]
fn bytes_that_are_not_weights_are_refused() {
    assert_eq!(code(Model::new(&[1, 2, 3], None).err().expect("refused")), "bad_weights");
}

#[wasm_bindgen_test]
fn the_real_paths_are_masks_with_soft_iou_1_to_themselves() {
    let mut game = open(TASK);
    assert_eq!(game.path_masks().expect("no paths").length(), 0, "nothing has run yet");
    let (x, y, r) = balls(&game).next().expect("a valid ball");
    game.attempt(x, y, r).expect("valid");
    let paths = game.path_masks().expect("the paths of one rollout");
    assert_eq!(paths.length(), 1);
    let mask = |name: &str| {
        let value = Reflect::get(&paths.get(0), &name.into()).expect("an object");
        value.dyn_into::<js_sys::Float32Array>().expect("a mask").to_vec()
    };
    let (object, ball) = (mask("object"), mask("ball"));
    assert_eq!(soft_iou(&object, &object).expect("two maps"), 1.0);
    assert!(soft_iou(&object, &ball).expect("two maps") < 1.0);
    game.watch().expect("it runs");
    let alone = game.path_masks().expect("the path of one rollout").get(0);
    assert!(Reflect::get(&alone, &"ball".into()).expect("an object").is_undefined(), "there is no ball");
}

#[wasm_bindgen_test]
fn a_sketch_of_any_points_is_a_mask_that_holds_the_green_object() {
    let game = open(TASK);
    let bare = game.sketch_mask(&[]);
    assert!(bare.iter().sum::<f32>() > 0.0);
    let points: &[&[f64]] = &[&[1.0], &[f64::NAN, f64::INFINITY, -1e300, 1e300], &[-5.0, 900.0, 10.0, 10.0]];
    for points in points {
        let sketch = game.sketch_mask(points);
        assert_eq!(sketch.len(), bare.len());
        assert!(bare.iter().zip(&sketch).all(|(bare, drawn)| bare <= drawn), "{points:?}");
    }
}

#[wasm_bindgen_test]
fn a_preview_returns_the_ending_and_counts_nothing() {
    let mut game = open(TASK);
    let (x, y, r) = balls(&game).next().expect("a valid ball");
    let previewed = json(game.preview(x, y, r).expect("valid"));
    assert_eq!(json(game.standing("model").expect("a score"))["used"], 0);
    let tried = json(game.attempt(x, y, r).expect("valid"));
    assert_eq!(previewed["ending"], tried["ending"]);
    assert_eq!(code(game.preview(1.0, 1.0, 30.0).expect_err("it sticks out")), "invalid_ball");
}

#[wasm_bindgen_test]
fn metrics_refuse_malformed_maps_and_lists() {
    assert_eq!(code(soft_iou(&[0.0; 9], &[0.0; 9]).expect_err("too small")), "bad_map");
    assert_eq!(code(auccess(JsValue::from_str("soup")).expect_err("no list")), "bad_data");
    let score = |firsts: Value| auccess(js(&firsts));
    assert_eq!(score(json!([1, null])).expect("two tasks"), 50.0);
    for first in [json!(0), json!(-1), json!(1.5), json!("1"), json!([1])] {
        let refused: js_sys::Error = score(json!([1, first])).expect_err("refused").dyn_into().expect("a real Error");
        let said = String::from(refused.message());
        assert!(said.contains("item 1") && said.ends_with(&format!("counted from 1, or null, not {first}")), "{said}");
    }
}

#[wasm_bindgen_test]
fn a_script_simulates_what_the_game_attempts() {
    let mut game = open(TASK);
    let (x, y, r) = balls(&game).next().expect("a valid ball");
    let ball = |ball: [f64; 3]| serde_wasm_bindgen::to_value(&ball).expect("a ball");
    let rollout = simulate(TASK.into(), ball([x, y, r])).expect("a rollout");
    let array = |name: &str| Reflect::get(&rollout, &name.into()).expect("an object");
    let poses = array("poses").dyn_into::<js_sys::Float32Array>().expect("poses").to_vec();
    let bodies = array("bodies").dyn_into::<js_sys::Uint32Array>().expect("bodies").to_vec();
    let touching = array("touching").dyn_into::<js_sys::Uint8Array>().expect("touching");
    let attempt = json(game.attempt(x, y, r).expect("valid"));
    let steps = attempt["ending"]["steps"].as_u64().expect("a number") as usize;
    assert!(game.steps() <= steps, "the page may stop when all lies still");
    assert_eq!(touching.length() as usize, steps + 1);
    assert_eq!(poses.len(), (steps + 1) * bodies.len() * 3);
    assert_eq!(Reflect::get(&rollout, &"steps".into()).expect("steps"), steps as f64);
    let body_count = json(scene(TASK.into()).expect("a scene"))["bodies"].as_array().expect("bodies").len();
    assert_eq!(bodies.last().copied(), Some(body_count as u32), "the ball comes last");
    assert_eq!(poses[3 * (bodies.len() - 1)..][..2], [x as f32, y as f32]);

    let invalid = simulate(TASK.into(), ball([1.0, 250.0, 9.0])).expect("an outcome");
    let status = Reflect::get(&invalid, &"status".into()).expect("a status");
    assert_eq!(status, "invalid");
    let reason = why_invalid(TASK.into(), ball([1.0, 250.0, 9.0])).expect("a task");
    assert_eq!(Reflect::get(&invalid, &"reason".into()).expect("a reason").as_string(), reason);
    assert_eq!(code(simulate(TASK.into(), JsValue::from("ball")).expect_err("refused")), "bad_data");
    assert_eq!(code(simulate("7:13".into(), JsValue::NULL).expect_err("refused")), "bad_task");
    assert_eq!(raster(TASK.into()).expect("five channels").len(), 5 * 64 * 64);
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
fn a_solve_map_fills_up_and_refuses_unknown_tasks_and_radii() {
    assert_eq!(code(SolveMap::new("7:13".into(), 12.0).err().expect("refused")), "bad_task");
    assert_eq!(code(SolveMap::new(TASK.into(), f64::NAN).err().expect("refused")), "invalid_ball");
    let mut map = SolveMap::new(TASK.into(), 32.0).expect("a map");
    assert!(map.outcomes().iter().all(|&outcome| outcome == 0));
    for _ in 0..64 {
        assert!(map.advance());
    }
    assert_eq!(map.progress(), 64.0 / 4096.0);
    assert!(map.outcomes().iter().all(|outcome| (1..=3).contains(outcome)));
}

/// The fields of an interface of `types.d.ts`, sorted; those that may be missing end in `?`.
fn declared(interface: &str) -> Vec<String> {
    let types = include_str!("../src/web/types.d.ts");
    let start = types.find(&format!("interface {interface} ")).unwrap_or_else(|| panic!("no interface {interface}"));
    let body = types[start..].split('{').nth(1).and_then(|rest| rest.split('}').next()).expect("a body");
    let lines = body.lines().map(str::trim).filter(|line| line.ends_with(';'));
    let mut fields: Vec<String> = lines.filter_map(|line| line.split(':').next()).map(String::from).collect();
    fields.sort_unstable();
    fields
}

fn fields(value: &Value) -> Vec<String> {
    let mut fields: Vec<String> = value.as_object().expect("an object").keys().cloned().collect();
    fields.sort_unstable();
    fields
}

#[wasm_bindgen_test]
fn an_open_puzzle_answers_what_a_script_simulates() {
    let puzzle = OpenPuzzle::new(TASK.into()).expect("a task");
    assert_eq!(fields(&json(puzzle.about().expect("facts"))), declared("About"));
    let ball = json!(puzzle.nearest_place(128.0, 230.0, 8.0).expect("there is room"));
    let rollout = |ball: &Value| puzzle.rollout(js(ball));
    let facts = rollout(&ball).expect("a valid ball");
    let mut names: Vec<String> =
        js_sys::Object::keys(&facts.clone().into()).iter().filter_map(|key| key.as_string()).collect();
    names.sort_unstable();
    assert_eq!(names, declared("RolloutFacts"));
    Reflect::delete_property(&facts.clone().into(), &"paths".into()).expect("an object");
    let facts = json(facts);
    assert_eq!(facts["line"], json(attempt_line(TASK.into(), js(&ball)).expect("a line")));
    let simulated = simulate(TASK.into(), js(&ball)).expect("a rollout");
    let number = |name: &str| Reflect::get(&simulated, &name.into()).expect("an object").as_f64();
    assert_eq!(facts["ending"]["longest_touch"].as_f64(), number("longest_touch"));
    assert!(facts["last"].as_f64() <= number("steps"));
    // More balls than are kept, and the first again.
    for x in 60..80 {
        let _ = rollout(&json!([x, 230, 8]));
    }
    let again = rollout(&ball).expect("a valid ball");
    Reflect::delete_property(&again.clone().into(), &"paths".into()).expect("an object");
    assert_eq!(json(again), facts);
    assert_eq!(code(rollout(&json!([2, 2, 8])).expect_err("outside")), "invalid_ball");
    assert_eq!(code(rollout(&json!("ball")).expect_err("no ball")), "bad_data");
    assert_eq!(json(puzzle.why_invalid(2.0, 2.0, 8.0).expect("a reason")), json!({ "kind": "outside" }));
    let alone = rollout(&Value::Null).expect("the scene alone");
    assert!(Reflect::get(&alone, &"paths".into()).expect("an object").is_null());
}

#[wasm_bindgen_test]
fn values_have_the_fields_that_their_types_declare() {
    let mut game = open(TASK);
    let (x, y, r) = balls(&game).next().expect("a valid ball");
    let attempt = json(game.attempt(x, y, r).expect("valid"));
    let mut listed = [declared("Attempt"), declared("ListedAttempt")].concat();
    listed.sort_unstable();
    assert_eq!(fields(&attempt), listed);
    assert_eq!(fields(&attempt["ending"]), declared("Ending"));
    assert_eq!(fields(&json(game.moments().expect("moments"))), declared("Moments"));
    assert_eq!(fields(&json(game.about().expect("facts"))), declared("About"));
    assert_eq!(fields(&json(game.standing("player").expect("a standing"))), declared("Standing"));
    assert_eq!(fields(&json(constants().expect("constants"))), declared("Constants"));
    assert_eq!(fields(&json(palette(true).expect("colours"))), declared("Palette"));
    assert_eq!(fields(&json(templates().expect("a list"))[0]), declared("Template"));
    assert_eq!(fields(&json(fold("within".into(), &0.into()).expect("a fold"))), declared("Fold"));
    let scene = json(scene(TASK.into()).expect("a scene"));
    assert_eq!(fields(&scene), declared("Scene"));
    assert_eq!(fields(&scene["bodies"][0]), declared("Body"));
    let rollout = simulate(TASK.into(), JsValue::NULL).expect("a rollout");
    let mut names: Vec<String> =
        js_sys::Object::keys(&rollout.into()).iter().filter_map(|key| key.as_string()).collect();
    names.sort_unstable();
    let mut expected = [declared("Ending"), declared("Rollout")].concat();
    expected.sort_unstable();
    assert_eq!(names, expected);

    let bytes = include_bytes!("../assets/within-0.safetensors");
    let model = Model::new(bytes, None).expect("the shipped weights");
    let card: Card = serde_json::from_value(json(model.card().expect("a card"))).expect("a card");
    let (_, shipped) = PathNet::load(bytes).expect("the shipped weights");
    assert_eq!(card, shipped, "its fields are those of the test below");
    let propose = |seed: Value, count: JsValue| model.propose(TASK.into(), &js(&seed), &count);
    let proposals = json(propose(json!(0), JsValue::UNDEFINED).expect("proposals"));
    assert_eq!(fields(&proposals[0]), declared("Proposal"));
    assert_eq!(proposals[0]["origin"]["kind"], "imagined");
    assert_eq!(json(propose(json!(u32::MAX), 3.into()).expect("three")).as_array().expect("a list").len(), 3);
    for count in [0.0, 2.5, -1.0, 1001.0, f64::INFINITY, f64::NAN] {
        assert_eq!(code(propose(json!(0), count.into()).expect_err("refused")), "bad_data", "{count}");
    }
    for seed in [json!(-1), json!(1.5), json!("a"), json!(1_u64 << 32), json!(null)] {
        assert_eq!(code(propose(seed.clone(), JsValue::UNDEFINED).expect_err("refused")), "bad_data", "{seed}");
        assert_eq!(code(model.turn(TASK.into(), &js(&seed)).err().expect("refused")), "bad_data", "{seed}");
    }
}

/// The fields of a value that has all that it may have, sorted; those that the barest lacks end in `?`.
fn fields_of_all(fullest: &Value, barest: &Value) -> Vec<String> {
    let barest = fields(barest);
    let marked = |field: String| if barest.contains(&field) { field } else { field + "?" };
    fields(fullest).into_iter().map(marked).collect()
}

#[wasm_bindgen_test]
fn cards_have_the_fields_that_their_types_declare() {
    let (_, shipped) = PathNet::load(include_bytes!("../assets/within-0.safetensors")).expect("weights");
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
        blends: 0,
        unlisted: 0,
        random_scenes: 0,
        random_scenes_alone: false,
        without_paths: false,
        from: None,
        ..dynamics.clone()
    };
    let fullest = DynamicsCard {
        optimiser: Optimiser::Muon,
        path_weights: PathWeights { all: 2.0, solving: 4.0 },
        blends: 1,
        unlisted: 1,
        random_scenes: 1,
        random_scenes_alone: true,
        without_paths: true,
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
    assert_eq!(fields(&full["dynamics"]["path_weights"]), declared("PathWeights"));
}

#[wasm_bindgen_test]
fn the_model_imagines_each_map() {
    let model = Model::new(include_bytes!("../assets/within-0.safetensors"), None).expect("the shipped weights");
    let maps = model.imagine(TASK.into()).expect("maps");
    let map_names = json(constants().expect("constants"))["maps"].clone();
    let map_names: Vec<&str> = map_names.as_array().expect("a list").iter().filter_map(Value::as_str).collect();
    let names: Vec<String> =
        js_sys::Object::keys(&maps.clone().into()).iter().filter_map(|key| key.as_string()).collect();
    assert_eq!(names, map_names, "in the order of the constants");
    for name in names {
        let map: js_sys::Float32Array =
            Reflect::get(&maps, &name.into()).expect("an object").dyn_into().expect("a map");
        assert_eq!(map.length(), 64 * 64);
    }
    let declared =
        include_str!("../src/web/types.d.ts").split("export type MapName = ").nth(1).expect("the type MapName");
    let declared = declared.split(';').next().expect("its end");
    assert_eq!(declared, map_names.iter().map(|name| format!("\"{name}\"")).collect::<Vec<_>>().join(" | "));
}

#[wasm_bindgen_test]
fn a_ball_is_imagined_by_weights_that_have_a_dynamics_net() {
    let bytes = include_bytes!("../assets/within-0.safetensors");
    let (mut nets, mut card) = PathNet::load(bytes).expect("the shipped weights");
    (nets.dynamics, card.dynamics) = (None, None);
    let without = Model::new(&nets.save(&card).expect("weights"), None).expect("a model");
    let ball = |x: f64, y: f64, r: f64| serde_wasm_bindgen::to_value(&[x, y, r]).expect("a ball");
    assert!(without.imagine_ball(TASK.into(), ball(128.0, 230.0, 8.0)).expect("no error").is_undefined());
    assert!(without.candidates(TASK.into()).expect("no error").is_undefined());
    nets.dynamics = Some(DynamicsNet::fresh(0));
    let model = Model::new(&nets.save(&card).expect("weights"), None).expect("a model");
    let imagined = |id: &str, x: f64| model.imagine_ball(id.into(), ball(x, 230.0, 8.0)).expect("a valid ball");
    let first = imagined(TASK, 128.0);
    let mut names: Vec<String> =
        js_sys::Object::keys(&first.clone().into()).iter().filter_map(|key| key.as_string()).collect();
    names.sort_unstable();
    assert_eq!(names, declared("ImaginedBall"));
    let values = |from: &JsValue, name: &str| -> Vec<f64> {
        let field = Reflect::get(from, &name.into()).expect("a field");
        js_sys::Array::from(&field).iter().filter_map(|value| value.as_f64()).collect()
    };
    for (name, length) in [("steps", 16), ("object", 32), ("ball", 32), ("errors", 32)] {
        assert_eq!(values(&first, name).len(), length, "{name}");
    }
    let probability = Reflect::get(&first, &"probability".into()).expect("a field").as_f64().expect("a number");
    assert!((0.0..=1.0).contains(&probability));
    // The task that was read last is kept; another one is read anew.
    assert_ne!(values(&imagined("00007:008", 128.0), "object"), values(&first, "object"));
    assert_eq!(values(&imagined(TASK, 128.0), "object"), values(&first, "object"));
    assert_ne!(values(&imagined(TASK, 90.0), "ball"), values(&first, "ball"));
    let candidate = js_sys::Array::from(&model.candidates(TASK.into()).expect("candidates")).get(0);
    let names = js_sys::Object::keys(&candidate.clone().into());
    assert_eq!(names.length() as usize, declared("Candidate").len());
    assert_eq!(values(&candidate, "object").len(), 32);
    let tried = json(model.turn(TASK.into(), &0.into()).expect("a turn").attempt().expect("an attempt"));
    assert_eq!(fields(&tried), ["ball", "ending", "origin", "rejected"]);
    assert_eq!(tried["origin"]["kind"], "imagined");
    let refused = |id: &str, ball: JsValue| code(model.imagine_ball(id.into(), ball).expect_err("refused"));
    assert_eq!(refused(TASK, ball(2.0, 2.0, 8.0)), "invalid_ball");
    assert_eq!(refused(TASK, JsValue::NULL), "bad_data");
    assert_eq!(refused("7:1", ball(128.0, 230.0, 8.0)), "bad_task");
}

/// A JavaScript value of JSON.
fn js(value: &Value) -> JsValue {
    js_sys::JSON::parse(&value.to_string()).expect("JSON")
}

#[wasm_bindgen_test]
fn a_custom_scene_takes_the_place_of_its_task() {
    let custom = custom_scene(TASK.into()).expect("a task");
    assert_eq!(json(scene(custom.clone()).expect("a scene")), json(scene(TASK.into()).expect("a scene")));
    assert_eq!(raster(custom.clone()).expect("channels"), raster(TASK.into()).expect("channels"));
    let about = json(Game::new(custom.clone()).expect("it opens").about().expect("facts"));
    assert_eq!((&about["id"], &about["name"]), (&Value::Null, &Value::Null));
    assert_eq!(scene_problems(custom.clone()).map(json).expect("a list"), serde_json::json!([]));
    let line = |puzzle: JsValue| json(attempt_line(puzzle, JsValue::NULL).expect("a line"));
    let (of_custom, of_task) = (line(custom.clone()), line(TASK.into()));
    assert_eq!((&of_custom["digest"], of_custom.get("task")), (&of_task["digest"], None));
    for line in [&of_custom, &of_task] {
        assert_eq!(json(verify_attempt(js(line)).expect("a verdict"))["verdict"], "same");
    }
    let mut search = SolutionSearch::new(custom.clone()).expect("it begins");
    assert!(search.advance());
    assert_eq!(fields(&json(search.found().expect("an object"))), declared("FoundSolutions"));
    let ball = serde_wasm_bindgen::to_value(&[128.0, 250.0, 4.0]).expect("a ball");
    assert_eq!(fields(&json(luck(custom, ball).expect("two counts"))), declared("Luck"));
}

#[wasm_bindgen_test]
fn foreign_values_are_sentences_and_never_crash() {
    let nested = (0..20_000).fold(JsValue::NULL, |inner, _| js_sys::Array::of1(&inner).into());
    let deep = js_sys::Object::new();
    Reflect::set(&deep, &"version".into(), &nested).expect("an object");
    Reflect::set(&deep, &"bodies".into(), &nested).expect("an object");
    for value in [
        JsValue::UNDEFINED,
        JsValue::NULL,
        7.into(),
        "soup".into(),
        js(&serde_json::json!({"version": 1})),
        deep.into(),
    ] {
        let problems = json(scene_problems(value.clone()).expect("a list"));
        assert!(problems[0]["sentence"].as_str().is_some_and(|sentence| sentence.ends_with('.')));
        assert_eq!(json(verify_attempt(value).expect("a verdict"))["verdict"], "not_valid");
    }
    let line = json(attempt_line(TASK.into(), JsValue::NULL).expect("a line"));
    let named = |key: &str, name: &str| {
        let mut line = line.clone();
        line[key] = name.into();
        json(verify_attempt(js(&line)).expect("a verdict"))["reason"].as_str().expect("a sentence").to_string()
    };
    for (key, name) in [("task", "beach"), ("task", "00000:999"), ("task", "00099:000"), ("engine", "rapier")] {
        let reason = named(key, name);
        assert!(reason.contains(name.split(':').next().expect("a part")), "{reason}");
    }
    let mut custom = json(custom_scene(TASK.into()).expect("a task"));
    custom["bodies"][0]["x"] = 999.into();
    assert_eq!(code(simulate(js(&custom), JsValue::NULL).expect_err("refused")), "bad_scene");
    assert_eq!(json(scene_problems(js(&custom)).expect("a list"))[0]["body"], 0);
}

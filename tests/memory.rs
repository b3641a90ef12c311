//! The effect of a memory on an agent, and its storage in files.

use pathlight::agents::memory::{Attempt, CAPACITY, Memory, PuzzleSource, Recollection, Reminder};
use pathlight::agents::sigmoid;
use pathlight::puzzle::action::Ball;
use pathlight::puzzle::scene::{Body, SIZE, Scene, Shape};
use pathlight::puzzle::task::{Task, TaskId, ids};
use pathlight::puzzle::templates::TEMPLATES;

fn task(id: &str) -> Task {
    Task::load(id.parse().expect("an id")).expect("a task")
}

fn begin(memory: &mut Memory, id: &str) -> Recollection {
    let Task { id, scene, .. } = task(id);
    memory.begin(PuzzleSource::Task(id), &scene)
}

/// Returns what a memory says about a scene.
fn recall(memory: &Memory, scene: &Scene) -> Recollection {
    memory.clone().begin(PuzzleSource::Scene(Box::new(scene.clone())), scene)
}

/// A ball that is valid in all scenes of these tests.
const BALL: Ball = Ball { x: 30.0, y: 230.0, r: 8.0 };

const UNLIKELY: f64 = 0.1;

/// Returns a memory of one attempt.
fn taught(id: &str, solved: bool) -> Memory {
    let mut memory = Memory::default();
    begin(&mut memory, id);
    memory.observe(BALL, UNLIKELY, solved);
    memory
}

#[test]
fn a_success_raises_like_balls_in_like_scenes_more_than_a_failure_lowers_them() {
    let [solved, failed] = [true, false].map(|solved| taught("00002:007", solved));
    let change =
        |memory: &Memory, id: &str, dx: f64| recall(memory, &task(id).scene).change(Ball { x: BALL.x + dx, ..BALL });
    let [same, near, far] = [0.0, 6.0, 60.0].map(|dx| change(&solved, "00002:017", dx));
    assert!(same > near && near > 0.0, "{same} {near}");
    assert_eq!(far, 0.0);
    let unlike = change(&solved, "00007:008", 0.0);
    assert!(unlike < same / 4.0, "{unlike} {same}");
    let lowered = change(&failed, "00002:017", 0.0);
    assert!(lowered < 0.0 && -lowered < same, "{lowered} {same}");
}

#[test]
fn an_attempt_teaches_nothing_about_the_puzzle_that_is_being_played() {
    let mut memory = Memory::default();
    let recollection = begin(&mut memory, "00002:007");
    memory.observe(BALL, UNLIKELY, true);
    assert_eq!(recollection.change(BALL), 0.0);
}

#[test]
fn a_mirrored_scene_is_as_good_as_the_scene() {
    let memory = taught("00002:007", true);
    let scene = task("00002:017").scene;
    let mut mirrored = scene.clone();
    for body in &mut mirrored.bodies {
        body.x = SIZE - body.x;
        body.angle = -body.angle;
    }
    for dx in [0.0, 3.0, 9.0] {
        let ball = Ball { x: BALL.x + dx, ..BALL };
        let mirrored_ball = Ball { x: SIZE - ball.x, ..ball };
        let [plain, mirror] = [recall(&memory, &scene).change(ball), recall(&memory, &mirrored).change(mirrored_ball)];
        // The pixels of a mirrored polygon may differ at its edges.
        assert!(plain > 0.1 && (plain - mirror).abs() < 0.05 * plain, "{plain} {mirror}");
    }
    let reminder = recall(&memory, &mirrored).reminder(Ball { x: SIZE - BALL.x, ..BALL }).expect("a puzzle");
    assert!(reminder.mirrored);
    assert_eq!(reminder.ball, BALL, "the ball as it was tried");
}

#[test]
fn a_reminder_names_the_puzzle_that_counts_most() {
    let mut memory = taught("00007:008", true);
    begin(&mut memory, "00002:007");
    memory.observe(Ball { x: 200.0, ..BALL }, UNLIKELY, false);
    memory.observe(BALL, UNLIKELY, true);
    let recollection = begin(&mut memory, "00002:017");
    let Reminder { puzzle, task, ball, solved, change, mirrored } = recollection.reminder(BALL).expect("a puzzle");
    assert_eq!((puzzle, task), (2, Some("00002:007".parse().expect("an id"))));
    assert_eq!((ball, solved, mirrored), (BALL, true, false));
    assert!(change > recollection.change(BALL) / 2.0);
    assert_eq!(recollection.reminder(Ball { x: 128.0, y: 60.0, r: 30.0 }), None, "nothing is known of this ball");
}

#[test]
fn what_solved_a_like_scene_is_suggested_where_it_fits() {
    let memory = taught("00002:007", true);
    let scene = task("00002:017").scene;
    let recollection = recall(&memory, &scene);
    let suggestions = recollection.suggestions(&scene, |_| false);
    assert_eq!(suggestions[0], BALL);
    assert!(suggestions.iter().all(|ball| ball.check(&scene).is_ok()));
    assert!(!recollection.suggestions(&scene, |ball| *ball == BALL).contains(&BALL), "it is known");
    let failed = recall(&taught("00002:007", false), &scene);
    assert!(failed.suggestions(&scene, |_| false).is_empty());
}

/// Makes attempts that depend on the memory, as an agent's do.
fn play(memory: &mut Memory, tasks: &[TaskId]) {
    for &id in tasks {
        let recollection = memory.begin(PuzzleSource::Task(id), &Task::load(id).expect("a task").scene);
        for attempt in 0..4 {
            let chance = sigmoid(recollection.change(BALL) - f64::from(attempt));
            memory.observe(BALL, chance, attempt == 3);
        }
    }
}

#[test]
fn a_memory_that_is_kept_and_read_again_goes_on_as_if_it_were_the_same() {
    let tasks: Vec<TaskId> = ids(TEMPLATES[2]).take(12).collect();
    let mut one = Memory::default();
    play(&mut one, &tasks);
    let mut first = Memory::default();
    play(&mut first, &tasks[..5]);
    let mut second = Memory::default();
    second.read_json(first.to_json(Some("w")).as_bytes(), Some("w")).expect("a memory");
    play(&mut second, &tasks[5..]);
    assert_eq!(second.to_json(None), one.to_json(None));
    let [one, second] = [&mut one, &mut second].map(|memory| begin(memory, "00002:017").change(BALL).to_bits());
    assert_eq!(one, second);
}

#[test]
fn a_scene_that_is_no_task_is_kept_too() {
    let mut scene = task("00002:007").scene;
    // A number that serde_json reads one bit off.
    scene.bodies[0].x = 94.67968503937009;
    let mut memory = Memory::default();
    memory.begin(PuzzleSource::Scene(Box::new(scene.clone())), &scene);
    memory.observe(BALL, UNLIKELY, true);
    let mut read = Memory::default();
    read.read_json(memory.to_json(None).as_bytes(), None).expect("a memory");
    let (number, played, attempts) = read.puzzles().next().expect("a puzzle");
    assert_eq!((number, attempts), (1, &[Attempt { ball: BALL, chance: UNLIKELY, solved: true }][..]));
    let PuzzleSource::Scene(kept) = played else { panic!("{played:?}") };
    assert!((kept.bodies[0].x - scene.bodies[0].x).abs() < 1e-6, "{kept:?}");
    assert_eq!(read.to_json(None), memory.to_json(None));
    let [kept, read] = [&mut memory, &mut read].map(|memory| begin(memory, "00002:017").change(BALL).to_bits());
    assert_eq!(kept, read);
}

#[test]
fn attempts_of_others_are_remembered_by_puzzle_and_count_as_random_balls() {
    let mut memory = Memory::default();
    let other = |memory: &mut Memory, id: &str, solved: bool| {
        let Task { id, scene, .. } = task(id);
        memory.observe_other(PuzzleSource::Task(id), &scene, BALL, solved);
    };
    other(&mut memory, "00002:007", false);
    other(&mut memory, "00002:007", true);
    let expected = begin(&mut memory, "00002:017").chance_of_random(BALL);
    other(&mut memory, "00002:017", true);
    let chances: Vec<Vec<f64>> =
        memory.puzzles().map(|(_, _, attempts)| attempts.iter().map(|attempt| attempt.chance).collect()).collect();
    let [first, second] = chances.as_slice() else { panic!("two puzzles: {chances:?}") };
    assert!(first.len() == 2 && first[0] == first[1] && first[0] < 0.05, "what it does not yet know: {first:?}");
    assert!(second.len() == 1 && second[0] > first[0], "{second:?}");
    assert!((second[0] - expected).abs() < 1e-4, "the puzzle itself does not count: {second:?} {expected}");
}

#[test]
fn a_memory_that_has_forgotten_is_empty() {
    let mut memory = taught("00002:007", true);
    memory.forget();
    assert_eq!(memory.attempts(), 0);
    assert_eq!(begin(&mut memory, "00002:017").change(BALL), 0.0);
    assert_eq!(memory.to_json(None), Memory::default().to_json(None));
}

#[test]
fn a_memory_that_cannot_be_used_is_refused_and_changes_nothing() {
    let json = taught("00002:007", true).to_json(Some("w"));
    let damaged = |from: &str, to: &str| {
        assert!(json.contains(from), "{json}");
        json.replace(from, to)
    };
    for (json, weights, says) in [
        ("{".to_string(), Some("w"), "damaged"),
        (json[..json.len() / 2].to_string(), Some("w"), "damaged"),
        (damaged("\"version\":1", "\"version\":2"), Some("w"), "format 2"),
        (damaged("\"forgotten\":0", "\"forgotten\":4294967295"), Some("w"), "4294967295 puzzles"),
        (json.clone(), Some("x"), "other weights"),
        (json.clone(), None, "other weights"),
        (damaged("00002:007", "00002:999"), Some("w"), "puzzle 1"),
        (damaged("0.1", "1.5"), Some("w"), "attempt 1 at puzzle 1"),
        (damaged("0.1", "0.123456"), Some("w"), "attempt 1 at puzzle 1"),
        (damaged("[30.0", "[-30.0"), Some("w"), "attempt 1 at puzzle 1"),
    ] {
        let mut memory = taught("00007:008", false);
        let before = memory.to_json(None);
        let error = memory.read_json(json.as_bytes(), weights).expect_err(says).to_string();
        assert!(error.contains(says), "{error}");
        assert_eq!(memory.to_json(None), before);
    }
}

#[test]
fn of_ten_thousand_attempts_the_latest_are_remembered_under_their_numbers() {
    let puzzle = r#"{"task":"00002:007","attempts":["#.to_string()
        + &[r#"{"ball":[30,230,8],"chance":0.25,"solved":false}"#; 10].join(",")
        + "]}";
    let json = |puzzles: usize| {
        format!(r#"{{"version":1,"forgotten":0,"puzzles":[{}]}}"#, vec![puzzle.as_str(); puzzles].join(","))
    };
    let mut memory = Memory::default();
    memory.read_json(json(1000).as_bytes(), None).expect("a memory");
    assert_eq!(memory.attempts(), CAPACITY);
    let numbers: Vec<usize> = memory.puzzles().map(|(number, ..)| number).collect();
    assert_eq!(numbers, (1001 - CAPACITY / 10..=1000).collect::<Vec<_>>());
    assert!(begin(&mut memory, "00002:017").change(BALL) < 0.0);
    memory.observe(BALL, UNLIKELY, true);
    assert_eq!(memory.puzzles().last().expect("a puzzle").0, 1001);
    assert!(memory.attempts() <= CAPACITY);
}

#[test]
fn of_too_many_attempts_at_one_puzzle_the_latest_are_remembered() {
    let mut memory = taught("00002:007", false);
    begin(&mut memory, "00002:017");
    for _ in 0..CAPACITY + 2 {
        memory.observe(BALL, UNLIKELY, false);
    }
    memory.observe(BALL, UNLIKELY, true);
    assert_eq!(memory.attempts(), CAPACITY);
    let last = memory.puzzles().last().and_then(|(number, _, attempts)| Some((number, attempts.last()?.solved)));
    assert_eq!(last, Some((2, true)));
}

#[test]
fn a_ball_that_touches_a_body_of_a_custom_scene_is_read_again() {
    let Task { mut scene, .. } = task("00002:007");
    // A bar as long as the scene, whose ends move most when the angle is rounded.
    scene.bodies.push(Body {
        x: 100.0,
        y: 128.0,
        angle: std::f64::consts::FRAC_PI_2,
        shapes: vec![Shape::Polygon(vec![[-128.0, -4.0], [128.0, -4.0], [128.0, 4.0], [-128.0, 4.0]])],
        ..scene.bodies[0].clone()
    });
    let mut memory = Memory::default();
    memory.begin(PuzzleSource::Scene(Box::new(scene.clone())), &scene);
    let touching: Vec<Ball> = [[16.0, 240.0], [16.0, 16.0]]
        .into_iter()
        .flat_map(|[r, y]| [100.0 - 4.0 - r, 100.0 + 4.0 + r].map(|x| Ball { x, y, r }))
        .collect();
    for ball in touching {
        memory.observe(ball, UNLIKELY, false);
    }
    let json = memory.to_json(None);
    Memory::default().read_json(json.as_bytes(), None).expect("a memory that it wrote");
}

#[test]
fn a_ball_that_touches_a_wall_is_read_again() {
    let mut memory = Memory::default();
    begin(&mut memory, "00000:000");
    for ball in [
        Ball { x: 224.079_999_999_999_98, y: 200.0, r: 31.92 },
        Ball { x: 128.0, y: 256.0 - 7.000_000_4, r: 7.000_000_4 },
        Ball { x: 7.000_000_6, y: 200.0, r: 7.000_000_6 },
    ] {
        ball.check(&task("00000:000").scene).expect("valid");
        memory.observe(ball, UNLIKELY, false);
    }
    let json = memory.to_json(None);
    Memory::default().read_json(json.as_bytes(), None).expect("a memory that it wrote");
    let outside = json.replacen("224.08", "224.09", 1);
    assert_ne!(outside, json);
    let refused = Memory::default().read_json(outside.as_bytes(), None).expect_err("outside of the scene");
    assert!(refused.to_string().contains("attempt 1 at puzzle 1"), "{refused}");
}

#[test]
fn a_puzzle_without_attempts_has_no_number() {
    let mut memory = Memory::default();
    begin(&mut memory, "00002:007");
    let scene = task("00002:017").scene;
    let other = PuzzleSource::Task("00002:017".parse().expect("an id"));
    memory.observe_other(other, &scene, BALL, false);
    let numbers: Vec<usize> = memory.puzzles().map(|(number, ..)| number).collect();
    assert_eq!(numbers, [1]);
}

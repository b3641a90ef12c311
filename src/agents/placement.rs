//! From the placement map to balls: step 5 of Harter et al. (2020), without calling the simulator.
//!
//! Up to five balls are placed on cells of the map above a threshold, with random radii. Five rounds of hill climbing
//! then improve how well each ball fits the map. These are the first attempts. Further attempts are random walks from
//! these five in turn, as in the authors' published code: short steps that grow slowly from the first ball, long steps
//! from the rest. Proposals are valid and distinct. Starts and ends of walks also keep a minimum distance from each
//! other, unless a walk does not soon find such a place.

use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::{Origin, Proposal};
use crate::puzzle::action::{Action, Ball, Obstacles};
use crate::puzzle::sampling::{gaussian, uniform_balls};
use crate::puzzle::scene::Scene;
use crate::raster::{ball_image, cell_centre};

/// Balls placed by the map itself, before those from random walks.
const STARTS: usize = 5;

/// Rounds of hill climbing per ball.
const IMPROVEMENTS: usize = 5;

/// Distance of a neighbour in x, y or radius in the first round, px; it halves from round to round.
const INITIAL_STEP: f64 = 16.0;

/// A ball may start on a cell whose value is above this fraction of the maximum.
const THRESHOLD: f32 = 0.5;

/// Standard deviation of a step of a walk in x, y and radius, as fractions of the action space, at temperature 1. This
/// and the next four constants come from the authors' code.
const STEP: [f64; 3] = [0.02, 0.01, 0.02];

/// Shorter steps are redrawn.
const MIN_STEP: f64 = 0.05;

/// A walk ends where the action is this far from all earlier ones.
const MIN_DISTANCE: f64 = 0.02;

/// Growth of the temperature with each step, up to its maximum.
const WARMING: f64 = 1.04;
const MAX_TEMPERATURE: f64 = 5.0;

/// Draws for one start before it is skipped: the map may be high only where no ball fits, or lead to the same ball
/// every time.
const MAX_START_DRAWS: usize = 200;

/// Steps after which a walk may end near another proposal.
const STEPS_APART: usize = 2_000;

/// Draws for one proposal before the search ends, because the scene has no room for another ball.
const MAX_PROPOSAL_DRAWS: usize = 100_000;

/// The logit of the first proposal under a memory, and the slope by which the logits fall with the logarithm of the
/// rank, because the map gives no chances. They match roughly how often the n-th attempt at a new task solves it.
const FIRST_LOGIT: f64 = -0.3;
const FALL: f64 = 0.75;

/// Returns `attempts` valid, distinct balls, best guess first, or fewer if the scene has no room for that many. `map`
/// holds 64 x 64 values in 0..=1, row 0 at the bottom. The same seed returns the same balls.
pub fn proposals(map: &[f32], scene: &Scene, seed: u64, attempts: usize) -> Vec<Proposal> {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let obstacles = Obstacles::new(scene);
    let highest = map.iter().copied().fold(0.0, f32::max);
    let cells: Vec<usize> = (0..map.len()).filter(|&cell| map[cell] > THRESHOLD * highest).collect();
    let mut found: Vec<Proposal> = Vec::new();
    let mut tried: Vec<Action> = Vec::new();
    for _ in 0..STARTS.min(attempts) {
        let proposal = (0..MAX_START_DRAWS).find_map(|_| {
            let (ball, [x, y]) = improved_start(map, &obstacles, &cells, &mut rng)?;
            is_far(ball.action(), &tried).then_some(Proposal { ball, origin: Origin::Map { x, y } })
        });
        tried.extend(proposal.iter().map(|proposal| proposal.ball.action()));
        found.extend(proposal);
    }
    let starts = tried.clone();
    let mut temperatures: Vec<f64> =
        (0..starts.len()).map(|start| if start == 0 { 1.0 } else { MAX_TEMPERATURE }).collect();
    for index in 0..attempts - found.len() {
        let proposal = if starts.is_empty() {
            let mut draws = uniform_balls(&obstacles, &mut rng);
            draws.find(|&ball| is_new(ball, &found)).map(|ball| Proposal { ball, origin: Origin::Uniform })
        } else {
            let start = index % starts.len();
            let (mut action, temperature) = (starts[start], &mut temperatures[start]);
            (0..MAX_PROPOSAL_DRAWS).find_map(|draws| {
                action = step(action, *temperature, &mut rng);
                *temperature = (*temperature * WARMING).min(MAX_TEMPERATURE);
                let ball = obstacles.place(action).ok()?;
                let is_apart = draws >= STEPS_APART || is_far(action, &tried);
                if !is_apart || !is_new(ball, &found) {
                    return None;
                }
                tried.push(action);
                Some(Proposal { ball, origin: Origin::Perturbed { number: start + 1 } })
            })
        };
        let Some(proposal) = proposal else { break };
        found.push(proposal);
    }
    found
}

/// Returns the prior logit of a proposal under a memory, by its rank from 1.
pub(super) fn logit_of_rank(rank: usize) -> f64 {
    FIRST_LOGIT - FALL * libm::log(rank as f64)
}

/// Returns an action that is one random step away from `from`.
fn step(from: Action, temperature: f64, rng: &mut impl Rng) -> Action {
    loop {
        let [x, y, r] = STEP.map(|deviation| deviation * temperature * gaussian(rng));
        if x * x + y * y + r * r >= MIN_STEP * MIN_STEP {
            let moved = |value: f64, change: f64| (value + change).clamp(0.0, 1.0);
            return Action { x: moved(from.x, x), y: moved(from.y, y), r: moved(from.r, r) };
        }
    }
}

/// Returns whether an action is at least `MIN_DISTANCE` away from all `others`.
fn is_far(action: Action, others: &[Action]) -> bool {
    let squared = |value: f64| value * value;
    others.iter().all(|other| {
        let distance = squared(action.x - other.x) + squared(action.y - other.y) + squared(action.r - other.r);
        distance >= MIN_DISTANCE * MIN_DISTANCE
    })
}

fn is_new(ball: Ball, found: &[Proposal]) -> bool {
    found.iter().all(|before| before.ball != ball)
}

/// Places a ball of random radius on one of the cells and improves it. Returns the ball and the centre of the cell, px;
/// `None` if the ball is invalid or there is no cell.
fn improved_start(map: &[f32], obstacles: &Obstacles, cells: &[usize], rng: &mut impl Rng) -> Option<(Ball, [f64; 2])> {
    let cell = *cells.get(rng.random_range(0..cells.len().max(1)))?;
    let [x, y] = cell_centre(cell);
    let start = Ball { x, y, r: rng.random_range(2.0..32.0) };
    let mut ball = obstacles.place(start.action()).ok()?;
    let mut best = fit(map, ball);
    let mut step = INITIAL_STEP;
    for _ in 0..IMPROVEMENTS {
        for (dx, dy, dr) in NEIGHBOURS {
            let neighbour = Ball { x: ball.x + dx * step, y: ball.y + dy * step, r: ball.r + dr * step };
            let Ok(neighbour) = obstacles.place(neighbour.action()) else { continue };
            let score = fit(map, neighbour);
            if score > best {
                (ball, best) = (neighbour, score);
            }
        }
        step = (step / 2.0).max(1.0);
    }
    Some((ball, [start.x, start.y]))
}

const NEIGHBOURS: [(f64, f64, f64); 6] =
    [(-1.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, -1.0), (0.0, 0.0, 1.0)];

/// Returns how well a ball fits the map: the sum of the map under it divided by the square root of its area. A larger
/// ball fits better as long as the cells that it gains are more than half as high as the mean under it.
fn fit(map: &[f32], ball: Ball) -> f32 {
    let image = ball_image(ball);
    let under: f32 = image.cells().map(|cell| map[cell]).sum();
    under / (image.count().max(1) as f32).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::sampling::uniform_ball;
    use crate::puzzle::scene::{Body, Role, SIZE, Shape, ShapeType};
    use crate::puzzle::task::Task;
    use crate::raster::CELLS;

    fn scene() -> Scene {
        Task::load("00002:007".parse().expect("an id")).expect("a task").scene
    }

    /// The map of nets that are certain of one ball.
    fn certain_of(ball: Ball) -> Vec<f32> {
        ball_image(ball).to_f32().collect()
    }

    #[test]
    fn the_first_balls_lie_where_the_map_says() {
        let scene = scene();
        let mut rng = Pcg64Mcg::seed_from_u64(3);
        for _ in 0..20 {
            let expected = uniform_ball(&Obstacles::new(&scene), &mut rng).expect("the scene has room");
            let first = proposals(&certain_of(expected), &scene, 0, 1)[0].ball;
            assert!((first.x - expected.x).abs() <= 8.0 && (first.y - expected.y).abs() <= 8.0, "{expected}: {first}");
            assert!((first.r - expected.r).abs() <= 8.0, "{expected}: {first}");
        }
    }

    #[test]
    fn a_hundred_valid_balls_and_no_two_alike_whatever_the_map() {
        let scene = scene();
        let everywhere = vec![1.0; CELLS];
        // A map that is certain of a place occupied by a body.
        let body = &scene.bodies[scene.body1];
        let blocked = certain_of(Ball { x: body.x, y: body.y, r: 4.0 });
        for map in [vec![0.0; CELLS], everywhere, blocked, vec![f32::NAN; CELLS]] {
            let found = proposals(&map, &scene, 5, 100);
            let balls: Vec<Ball> = found.iter().map(|proposal| proposal.ball).collect();
            assert_eq!(balls.len(), 100);
            for (index, ball) in balls.iter().enumerate() {
                assert_eq!(ball.check(&scene), Ok(()));
                assert!(!balls[..index].contains(ball), "{ball} twice");
            }
            assert_eq!(found, proposals(&map, &scene, 5, 100), "the same seed yields the same balls");
        }
    }

    /// The scene with a wall over everything except the cells left of `right` and below `top`, px.
    fn walled(right: f64, top: f64) -> Scene {
        let mut scene = scene();
        let wall = |left: f64, bottom: f64| Body {
            x: left,
            y: bottom,
            angle: 0.0,
            dynamic: false,
            shape_type: ShapeType::Bar,
            role: Role::Black,
            shapes: vec![Shape::Polygon(vec![[0.0, 0.0], [SIZE, 0.0], [SIZE, SIZE], [0.0, SIZE]])],
        };
        scene.bodies = vec![wall(right, 0.0), wall(0.0, top)];
        scene
    }

    #[test]
    fn a_scene_without_room_gets_as_many_balls_as_fit() {
        let scene = walled(12.0, 6.0);
        let full = walled(3.0, 3.0);
        let in_the_corner = certain_of(Ball { x: 6.0, y: 3.0, r: 2.0 });
        // 9 x 3 places for a radius of 2 px and 7 for one of 3 px; chance decides how many of them are drawn.
        let found = proposals(&in_the_corner, &scene, 0, 100);
        assert!((1..=34).contains(&found.len()), "{}", found.len());
        assert!(found.iter().all(|proposal| proposal.ball.check(&scene).is_ok()));
        assert!(proposals(&[0.0; CELLS], &scene, 0, 100).len() <= 34);
        assert_eq!(proposals(&in_the_corner, &full, 0, 100), []);
        assert_eq!(proposals(&[0.0; CELLS], &full, 0, 100), []);
    }

    #[test]
    fn walks_end_away_from_all_before_and_those_of_the_first_start_end_nearest() {
        let scene = scene();
        let expected =
            uniform_ball(&Obstacles::new(&scene), &mut Pcg64Mcg::seed_from_u64(3)).expect("the scene has room");
        let actions: Vec<Action> =
            proposals(&certain_of(expected), &scene, 0, 100).iter().map(|found| found.ball.action()).collect();
        let distance = |a: Action, b: Action| libm::hypot(libm::hypot(a.x - b.x, a.y - b.y), a.r - b.r);
        // Positions of balls are rounded to whole px.
        let rounding = 3.0 / SIZE;
        for (index, &action) in actions.iter().enumerate() {
            let is_near = |&other: &Action| distance(action, other) < MIN_DISTANCE - rounding;
            assert!(!actions[..index].iter().any(is_near), "{action:?}");
        }
        // The first steps of the first start are still short.
        let walked =
            |start: usize| (1..5).map(|turn| distance(actions[start], actions[start + turn * STARTS])).sum::<f64>();
        assert!((1..STARTS).all(|start| walked(0) < walked(start)));
    }

    #[test]
    fn every_proposal_has_its_origin() {
        let scene = scene();
        let expected =
            uniform_ball(&Obstacles::new(&scene), &mut Pcg64Mcg::seed_from_u64(3)).expect("the scene has room");
        let found = proposals(&certain_of(expected), &scene, 0, 20);
        let origins: Vec<Origin> = found.iter().map(|proposal| proposal.origin).collect();
        for origin in &origins[..STARTS] {
            let Origin::Map { x, y } = *origin else { panic!("{origin:?} is a start") };
            assert!(
                libm::hypot(x - expected.x, y - expected.y) < expected.r + 4.0,
                "{x}, {y} is not a cell of the map"
            );
        }
        for (index, origin) in origins[STARTS..].iter().enumerate() {
            assert_eq!(*origin, Origin::Perturbed { number: index % STARTS + 1 });
        }
        assert_eq!(proposals(&[0.0; CELLS], &scene, 0, 1)[0].origin, Origin::Uniform);
    }
}

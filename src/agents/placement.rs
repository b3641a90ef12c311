//! From the placement map to balls: step 5 of Harter et al. (2020), without calling the simulator.
//!
//! Up to five balls are placed on cells of the map above a threshold, with random radii, and each is improved in five
//! rounds of hill climbing on how well it fits the map. These are the first attempts. The others are the same balls
//! with Gaussian noise that slowly grows. Proposals are valid, and no two are equal.

use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::{Origin, Proposal};
use crate::puzzle::action::{Action, Ball, Obstacles};
use crate::puzzle::sampling::{perturbed, random_ball};
use crate::puzzle::scene::Scene;
use crate::raster::{ball_image, cell_centre};

/// Balls that the map itself places, before noise.
const STARTS: usize = 5;

/// Rounds of improvement of each.
const IMPROVEMENTS: usize = 5;

/// Distance of a neighbour in x, y or radius in the first round, px; it halves from round to round.
const INITIAL_STEP: f64 = 16.0;

/// A ball may start on a cell whose value is above this fraction of the highest.
const THRESHOLD: f32 = 0.5;

/// Standard deviation of the noise of the first perturbed action, as a fraction of the action space, and its growth
/// with each. Chosen on the dev tasks of fold 0, the best mean of both setups.
const INITIAL_NOISE: f64 = 0.08;
const NOISE_GROWTH: f64 = 0.004;

/// Rejected draws for one proposal before the noise is doubled, because the map lies where no ball may be.
const MAX_REJECTIONS: usize = 200;

/// Draws for one proposal before the search ends, because the scene has no room for another ball.
const MAX_PROPOSAL_DRAWS: usize = 100_000;

/// Returns `attempts` valid, distinct balls, best guess first, or fewer if the scene has no room for as many. `map`
/// holds 64 x 64 values in 0..=1, row 0 at the bottom. The same seed returns the same balls.
pub fn proposals(map: &[f32], scene: &Scene, seed: u64, attempts: usize) -> Vec<Proposal> {
    let mut rng = Pcg64Mcg::seed_from_u64(seed);
    let obstacles = Obstacles::new(scene);
    let highest = map.iter().copied().fold(0.0, f32::max);
    let mean = map.iter().sum::<f32>() / map.len() as f32;
    let theirs = crate::suspects::on("starts");
    let threshold = if theirs { mean } else { THRESHOLD * highest };
    let cells: Vec<usize> = (0..map.len()).filter(|&cell| map[cell] > threshold).collect();
    let masked: Vec<f32> = map.iter().map(|&value| if theirs && value <= mean { 0.0 } else { value }).collect();
    let map = &masked[..];
    let mut found: Vec<Proposal> = Vec::with_capacity(attempts);
    for _ in 0..STARTS.min(attempts) {
        let proposal = (0..MAX_REJECTIONS).find_map(|rejected| {
            let tries = ["best2", "best5", "best10", "best20", "best50"].iter().zip([2, 5, 10, 20, 50]);
            let tries = tries.filter(|(name, _)| crate::suspects::on(name)).map(|(_, tries)| tries).next().unwrap_or(1);
            let mut candidates: Vec<(Ball, [f64; 2])> =
                (0..tries).filter_map(|_| improved_start(map, &obstacles, &cells, &mut rng)).collect();
            candidates.sort_by(|a, b| fit(map, b.0).total_cmp(&fit(map, a.0)));
            let &(ball, [x, y]) = candidates.first()?;
            if crate::suspects::on("walk") && !far(ball.action(), &found) {
                return None;
            }
            is_new(ball, &found).then_some(Proposal { ball, origin: Origin::Map { x, y }, rejected })
        });
        found.extend(proposal);
    }
    let mut temperature = 1.0;
    let starts: Vec<Action> = found.iter().map(|start| start.ball.action()).collect();
    if crate::suspects::on("walk") && !starts.is_empty() {
        let count = starts.len();
        let mut temperature = 1.0;
        let mut lists: Vec<Vec<Proposal>> = Vec::new();
        let mut tried: Vec<Action> = starts.clone();
        for (number, &start) in starts.iter().enumerate() {
            let mut list = vec![found[number].clone()];
            while list.len() < attempts {
                let mut action = start;
                let mut rejected = 0;
                let ball = loop {
                    let valid = obstacles.place(action).ok();
                    let near = tried.iter().any(|other| distance(*other, action) < 0.02);
                    if let (Some(ball), false) = (valid, near) {
                        break Some(ball);
                    }
                    rejected += 1;
                    if rejected > 5000 {
                        break None;
                    }
                    let noise = loop {
                        let noise = [0.02, 0.01, 0.02].map(|s| s * temperature * crate::puzzle::sampling::gaussian(&mut rng));
                        if noise.iter().map(|v| v * v).sum::<f64>().sqrt() >= 0.05 {
                            break noise;
                        }
                    };
                    if temperature < 5.0 {
                        temperature *= 1.04;
                    }
                    let clamp = |value: f64| value.clamp(0.0, 1.0);
                    action = Action {
                        x: clamp(action.x + noise[0]),
                        y: clamp(action.y + noise[1]),
                        r: clamp(action.r + noise[2]),
                    };
                };
                let Some(ball) = ball else { break };
                tried.push(action);
                list.push(Proposal { ball, origin: Origin::Perturbed { number: number + 1 }, rejected: 0 });
            }
            lists.push(list);
        }
        found.clear();
        for index in 0..attempts {
            for list in &lists {
                if let Some(proposal) = list.get(index) {
                    if is_new(proposal.ball, &found) && found.len() < attempts {
                        found.push(proposal.clone());
                    }
                }
            }
        }
        let _ = count;
    }
    for index in 0..attempts - found.len() {
        let proposal = if starts.is_empty() {
            let mut draws =
                (0..MAX_PROPOSAL_DRAWS).map_while(|rejected| Some((rejected, random_ball(scene, &mut rng)?)));
            draws.find(|&(_, ball)| is_new(ball, &found)).map(|(rejected, ball)| Proposal {
                ball,
                origin: Origin::Uniform,
                rejected,
            })
        } else {
            let start = index % starts.len();
            if crate::suspects::on("noise") || crate::suspects::on("text-noise") {
                let Some(proposal) = theirs_perturbed(&starts, &obstacles, &found, &mut temperature, &mut rng) else {
                    break;
                };
                found.push(proposal);
                continue;
            }
            let mut deviation = INITIAL_NOISE + NOISE_GROWTH * index as f64;
            (0..MAX_PROPOSAL_DRAWS).find_map(|rejected| {
                if rejected % MAX_REJECTIONS == MAX_REJECTIONS - 1 {
                    deviation = (deviation * 2.0).min(1.0);
                }
                let ball = obstacles.place(perturbed(starts[start], deviation, &mut rng)).ok()?;
                let origin = Origin::Perturbed { number: start + 1 };
                is_new(ball, &found).then_some(Proposal { ball, origin, rejected })
            })
        };
        let Some(proposal) = proposal else { break };
        found.push(proposal);
    }
    found
}

fn distance(a: Action, b: Action) -> f64 {
    ((a.x - b.x).powi(2) + (a.y - b.y).powi(2) + (a.r - b.r).powi(2)).sqrt()
}

fn far(action: Action, found: &[Proposal]) -> bool {
    found.iter().all(|before| distance(before.ball.action(), action) >= 0.02)
}

fn is_new(ball: Ball, found: &[Proposal]) -> bool {
    found.iter().all(|before| before.ball != ball)
}

/// A ball on one of the cells, of random radius, improved, and the centre of that cell, px; `None` if the ball is
/// invalid or there is no cell.
fn improved_start(map: &[f32], obstacles: &Obstacles, cells: &[usize], rng: &mut impl Rng) -> Option<(Ball, [f64; 2])> {
    let cell = *cells.get(rng.random_range(0..cells.len().max(1)))?;
    let [x, y] = cell_centre(cell);
    let radius = rng.random_range(2.0..32.0);
    let radius = if crate::suspects::on("radii") { 256.0 * (0.04 + 0.05 * (radius - 2.0) / 30.0) } else { radius };
    let start = Ball { x, y, r: radius };
    let mut ball = obstacles.place(start.action()).ok()?;
    let mut best = fit(map, ball);
    if crate::suspects::on("moves") {
        for _ in 0..IMPROVEMENTS {
            let from = ball;
            for (dx, dy) in [(-1.0, 0.0), (1.0, 0.0), (0.0, -1.0), (0.0, 1.0)] {
                let step = 256.0 / 30.0;
                // A move, and growth only together with a move.
                for dr in [0.0, 0.005, 0.01, 0.03, -0.01] {
                    let next = Ball { x: from.x + dx * step, y: from.y + dy * step, r: from.r + dr * 256.0 };
                    let Ok(next) = obstacles.place(next.action()) else { continue };
                    let score = fit(map, next);
                    if score > best {
                        (ball, best) = (next, score);
                    }
                }
            }
        }
        return Some((ball, [start.x, start.y]));
    }
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

/// How well a ball fits the map: the sum of the map under it divided by the square root of its area. A larger ball fits
/// better as long as the cells that it gains are more than half as high as the mean under it.
fn fit(map: &[f32], ball: Ball) -> f32 {
    let image = ball_image(ball);
    let under: f32 = image.cells().map(|cell| map[cell]).sum();
    let area = image.count().max(1) as f32;
    if crate::suspects::on("fit") { under / area.powf(2.0 / 3.0) } else { under / area.sqrt() }
}

/// The noise of the authors' code: (0.02, 0.01, 0.02) times a temperature, at least 0.05 long, which grows by 1.04 with
/// each draw up to 5; a ball nearer than 0.02 to one tried is drawn again. The noise of the text has no least length,
/// is the same in all three, and ends at 0.1.
fn theirs_perturbed(
    starts: &[Action],
    obstacles: &Obstacles,
    found: &[Proposal],
    temperature: &mut f64,
    rng: &mut impl Rng,
) -> Option<Proposal> {
    use crate::puzzle::sampling::gaussian;
    let code = crate::suspects::on("noise");
    for rejected in 0..MAX_PROPOSAL_DRAWS {
        let number = rng.random_range(0..starts.len());
        let start = starts[number];
        let scale = if code { [0.02, 0.01, 0.02] } else { [0.02; 3] };
        let noise = scale.map(|scale| scale * *temperature * gaussian(rng));
        let length = noise.iter().map(|value| value * value).sum::<f64>().sqrt();
        if code && length < 0.05 {
            continue;
        }
        if *temperature < 5.0 {
            *temperature *= 1.04;
        }
        let clamp = |value: f64| value.clamp(0.0, 1.0);
        let action = Action { x: clamp(start.x + noise[0]), y: clamp(start.y + noise[1]), r: clamp(start.r + noise[2]) };
        let Ok(ball) = obstacles.place(action) else { continue };
        let near = |before: &Proposal| {
            let other = before.ball.action();
            let [x, y, r] = [other.x - action.x, other.y - action.y, other.r - action.r];
            (x * x + y * y + r * r).sqrt() < 0.02
        };
        // In the authors' code a scene in which every ball is near one tried has no end; here the rule is given up.
        if code && rejected < 1000 && found.iter().any(near) {
            continue;
        }
        if !is_new(ball, found) {
            continue;
        }
        return Some(Proposal { ball, origin: Origin::Perturbed { number: number + 1 }, rejected });
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
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
            let expected = random_ball(&scene, &mut rng).expect("the scene has room");
            let first = proposals(&certain_of(expected), &scene, 0, 1)[0].ball;
            assert!((first.x - expected.x).abs() <= 8.0 && (first.y - expected.y).abs() <= 8.0, "{expected}: {first}");
            assert!((first.r - expected.r).abs() <= 8.0, "{expected}: {first}");
        }
    }

    #[test]
    fn a_hundred_valid_balls_and_no_two_alike_whatever_the_map() {
        let scene = scene();
        let everywhere = vec![1.0; CELLS];
        // A map that is certain of a place where the scene has a body.
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

    /// The scene with a wall over all of it but the cells left of `right` and below `top`, px.
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
        // 9 x 3 places for a radius of 2 px and 7 for one of 3 px; luck decides how many of them are drawn.
        let found = proposals(&in_the_corner, &scene, 0, 100);
        assert!((1..=34).contains(&found.len()), "{}", found.len());
        assert!(found.iter().all(|proposal| proposal.ball.check(&scene).is_ok()));
        assert!(proposals(&[0.0; CELLS], &scene, 0, 100).len() <= 34);
        assert_eq!(proposals(&in_the_corner, &full, 0, 100), []);
        assert_eq!(proposals(&[0.0; CELLS], &full, 0, 100), []);
    }

    #[test]
    fn every_proposal_has_its_origin() {
        let scene = scene();
        let expected = random_ball(&scene, &mut Pcg64Mcg::seed_from_u64(3)).expect("the scene has room");
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

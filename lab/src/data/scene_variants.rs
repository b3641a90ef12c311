//! Variants of a task's scene, to train on more scenes than the benchmark has: its groups of touching bodies are moved,
//! turned and resized at random (domain randomization, Tobin et al. 2017).
//!
//! A variant knows only the scene that it is made from, so that variants of training tasks tell nothing of test tasks.
//! Static bodies that touch stay together, and so do dynamic ones; what lies on a static body moves with it.

use pathlight::puzzle::action::RADIUS;
use pathlight::puzzle::sampling::gaussian;
use pathlight::puzzle::scene::{Body, SIZE, Scene, Shape};
use pathlight::puzzle::task::Task;
use pathlight::simulator::distance::distance;
use pathlight::simulator::outcome;
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

/// Standard deviations of the moves of a variant, one drawn per variant, px.
const MOVES: [f64; 3] = [4.0, 8.0, 16.0];

/// Standard deviation of the logarithm of the factor by which a free body is resized.
const RESIZING: f64 = 0.12;

/// Standard deviation of the angle by which a tilted free static body is turned, radians.
const TURNING: f64 = 0.07;

/// Bodies nearer than this touch, px.
const TOUCHING: f64 = 1.0;

/// Any two bodies keep at least this distance, px, or theirs if it was less.
const CLEARANCE: f64 = 0.3;

/// Draws per variant.
const DRAWS: i32 = 40;

/// What the changes of a draw are multiplied by after each that does not fit.
const SHRINKING: f64 = 0.93;

/// Returns a variant of a task's scene, the same for the same number; `None` if every draw made bodies overlap, stick
/// out of the scene, or solve the task by themselves.
pub fn scene_variant(task: &Task, number: u32) -> Option<Scene> {
    let mut rng = Pcg64Mcg::seed_from_u64(task.id.seed(u64::from(number)));
    let scene = &task.scene;
    let groups = Groups::of(scene);
    let moves = MOVES[rng.random_range(0..MOVES.len())];
    (0..DRAWS).find_map(|draw| {
        let variant = groups.moved(scene, libm::pow(SHRINKING, f64::from(draw)), moves, &mut rng);
        let fits = keeps_clear(scene, &variant) && !outcome(&variant, None).is_ok_and(|alone| alone.solved);
        fits.then_some(variant)
    })
}

/// The bodies of a scene that move together.
struct Groups {
    /// The group of each body: the lowest index of its bodies.
    of_body: Vec<usize>,
    /// For each body the static body that its group touches, if it is dynamic.
    support: Vec<Option<usize>>,
    /// Whether a body's group touches the floor or a side wall.
    on_floor: Vec<bool>,
    at_side: Vec<bool>,
}

impl Groups {
    fn of(scene: &Scene) -> Groups {
        let bodies = &scene.bodies;
        let touch = |a: usize, b: usize| distance(&bodies[a], &bodies[b]) < TOUCHING;
        let mut of_body: Vec<usize> = (0..bodies.len()).collect();
        for a in 0..bodies.len() {
            for b in 0..a {
                if bodies[a].dynamic == bodies[b].dynamic && touch(a, b) {
                    let (from, to) = (of_body[a].max(of_body[b]), of_body[a].min(of_body[b]));
                    of_body.iter_mut().filter(|group| **group == from).for_each(|group| *group = to);
                }
            }
        }
        let members = |body: usize| {
            let group = of_body[body];
            let of_body = &of_body;
            bodies.iter().enumerate().filter(move |(other, _)| of_body[*other] == group)
        };
        let support = |body: usize| {
            let mut statics = (0..bodies.len()).filter(|&other| bodies[body].dynamic && !bodies[other].dynamic);
            statics.find(|&on| members(body).any(|(member, _)| touch(member, on)))
        };
        let low = |body: &Body| body.bounds()[1] < TOUCHING;
        let beside = |body: &Body| {
            let [left, _, right, _] = body.bounds();
            left < TOUCHING || right > SIZE - TOUCHING
        };
        let on_floor = (0..bodies.len()).map(|body| members(body).any(|(_, member)| low(member))).collect();
        let at_side = (0..bodies.len()).map(|body| members(body).any(|(_, member)| beside(member))).collect();
        let support = (0..bodies.len()).map(support).collect();
        Groups { support, on_floor, at_side, of_body }
    }

    /// The scene with its groups moved by normal draws of this deviation, px, and its free bodies changed; `scale`
    /// multiplies all changes.
    fn moved(&self, scene: &Scene, scale: f64, deviation: f64, rng: &mut impl Rng) -> Scene {
        let mut variant = scene.clone();
        let count = scene.bodies.len();
        let mut offsets = vec![[0.0; 2]; count];
        for dynamic in [false, true] {
            for body in (0..count).filter(|&body| self.of_body[body] == body && scene.bodies[body].dynamic == dynamic) {
                let [mut x, mut y] = [(); 2].map(|()| (scale * deviation * gaussian(rng)).round());
                let slides = rng.random::<bool>();
                if self.on_floor[body] {
                    y = 0.0;
                }
                if self.at_side[body] {
                    x = 0.0;
                }
                if let Some(on) = self.support[body] {
                    let [with_x, with_y] = offsets[self.of_body[on]];
                    let slides = slides && is_flat(&scene.bodies[on]);
                    (x, y) = (with_x + if slides { x } else { 0.0 }, with_y);
                }
                offsets[body] = [x, y];
            }
        }
        for (index, body) in variant.bodies.iter_mut().enumerate() {
            let [x, y] = offsets[self.of_body[index]];
            (body.x, body.y) = (body.x + x, body.y + y);
            if self.of_body.iter().filter(|&&group| group == self.of_body[index]).count() > 1 {
                continue;
            }
            let held = self.support[index].is_some() || self.on_floor[index];
            let factor = libm::exp(scale * RESIZING * gaussian(rng));
            let turned = scale * TURNING * gaussian(rng);
            if self.support[index].is_none_or(|on| is_flat(&scene.bodies[on])) {
                resize(body, factor, held);
            }
            if !body.dynamic && !is_axis_aligned(body) && !self.on_floor[index] && !self.at_side[index] {
                body.angle += turned;
            }
        }
        variant
    }
}

/// Resizes a ball to a radius of a whole number and a half, as PHYRE's are, or a bar along its length. A ball that is
/// held stays on what holds it.
fn resize(body: &mut Body, factor: f64, held: bool) {
    match body.shapes.as_mut_slice() {
        [Shape::Circle(radius)] => {
            let resized = (*radius * factor).clamp(*RADIUS.start(), 2.0 * RADIUS.end()).floor() + 0.5;
            if held {
                body.y += resized - *radius;
            }
            *radius = resized;
        }
        [Shape::Polygon(corners)] if !(held && body.dynamic) => {
            for corner in corners {
                corner[0] *= factor;
            }
        }
        _ => {}
    }
}

/// Whether a body is a single shape that is not tilted: on a bar like this, others can slide.
fn is_flat(body: &Body) -> bool {
    body.angle == 0.0 && body.shapes.len() == 1
}

fn is_axis_aligned(body: &Body) -> bool {
    let quarter_turns = body.angle / std::f64::consts::FRAC_PI_2;
    (quarter_turns - quarter_turns.round()).abs() < 1e-6
}

/// Whether no two bodies came nearer than they may, and none sticks out of the scene farther than before.
fn keeps_clear(before: &Scene, after: &Scene) -> bool {
    let inside = before.bodies.iter().zip(&after.bodies).all(|(before, after)| {
        let ([left, bottom, right, top], was) = (after.bounds(), before.bounds());
        left >= was[0].min(0.0) && bottom >= was[1].min(0.0) && right <= was[2].max(SIZE) && top <= was[3].max(SIZE)
    });
    inside && bodies_keep_apart(&[before], after)
}

/// Whether no two bodies are nearer than `CLEARANCE`, or than they were in one of the scenes that this one was made
/// from.
pub(super) fn bodies_keep_apart(before: &[&Scene], after: &Scene) -> bool {
    let apart = |a: usize, b: usize| {
        let between = |scene: &Scene| distance(&scene.bodies[a], &scene.bodies[b]);
        let now = between(after);
        now >= CLEARANCE || before.iter().any(|before| now >= between(before) - 1e-3)
    };
    (0..after.bodies.len()).all(|a| (0..a).all(|b| apart(a, b)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use pathlight::puzzle::task::ids;
    use pathlight::puzzle::templates::TEMPLATES;

    /// The first task of each template with its first variants.
    fn variants() -> impl Iterator<Item = (Task, Vec<Scene>)> {
        TEMPLATES.iter().map(|template| {
            let task = Task::load(ids(template).next().expect("a task")).expect("a task");
            let variants = (0..20).filter_map(|number| scene_variant(&task, number)).collect();
            (task, variants)
        })
    }

    #[test]
    fn most_templates_have_many_variants_and_each_is_another_scene() {
        let mut total = 0;
        for (task, variants) in variants() {
            assert!(!variants.contains(&task.scene), "{} is its own variant", task.id);
            assert!((1..variants.len()).all(|a| variants[..a].iter().all(|b| *b != variants[a])), "{}", task.id);
            total += variants.len();
        }
        assert!(total > 420, "{total} of 500");
    }

    #[test]
    fn a_variant_has_the_same_bodies_inside_the_scene_and_does_not_solve_itself() {
        for (Task { id, scene, .. }, variants) in variants() {
            for variant in variants {
                assert_eq!((variant.body1, variant.body2), (scene.body1, scene.body2), "{id}");
                let kinds =
                    |scene: &Scene| scene.bodies.iter().map(|body| (body.dynamic, body.role)).collect::<Vec<_>>();
                assert_eq!(kinds(&variant), kinds(&scene), "{id}");
                assert!(keeps_clear(&scene, &variant), "{id}");
                assert!(!outcome(&variant, None).expect("no ball, so none is invalid").solved, "{id}");
            }
        }
    }

    #[test]
    fn a_number_gives_the_same_variant_every_time() {
        let task = Task::load("00007:008".parse().expect("an id")).expect("a task");
        assert_eq!(scene_variant(&task, 3), scene_variant(&task, 3));
        assert_ne!(scene_variant(&task, 3), scene_variant(&task, 4));
    }
}

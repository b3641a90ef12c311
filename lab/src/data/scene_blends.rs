//! Blends of two tasks of a template, to train on more scenes than the benchmark has: every position, angle and size is
//! interpolated, so that a blend lies between their scenes (as in mixup, Zhang et al. 2017, but in the parameters of
//! the scene, and labelled by simulation).
//!
//! A blend knows only the two scenes that it is made from, so a blend of training tasks is made from no test task. It
//! may lie near one by chance.

use pathlight::puzzle::scene::{Body, SIZE, Scene, Shape};
use pathlight::puzzle::task::{Task, TaskId};
use pathlight::simulator::outcome;
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::scene_variants::bodies_keep_apart;

/// Range of a blend's share of the way from the first scene (0) to the second (1): near the ends it would hardly differ
/// from a task.
const SHARES: std::ops::Range<f64> = 0.1..0.9;

/// How much farther than in both scenes a body may stick out, px: rounding errors.
const TOLERANCE: f64 = 1e-3;

/// Partners tried for a blend.
const DRAWS: usize = 30;

/// Returns a partner among `tasks`, which are of the same template, and the blend with it; both are the same for the
/// same number. `None` if no partner that was tried gives a blend.
pub fn blend_of(task: &Task, number: u32, tasks: &[TaskId]) -> Option<(TaskId, Scene)> {
    let mut rng = Pcg64Mcg::seed_from_u64(task.id.seed(u64::from(number)));
    (0..DRAWS).find_map(|_| {
        let partner = *tasks.choose(&mut rng).filter(|&&partner| partner != task.id)?;
        let scene = scene_blend(task, &Task::load(partner).ok()?, number)?;
        Some((partner, scene))
    })
}

/// Returns a blend of two tasks, the same for the same number. `None` if their scenes differ in more than numbers, or
/// if bodies would overlap that are apart in both, stick out of the scene, or solve the task by themselves. Bodies that
/// touch in one of the scenes may overlap in the blend.
pub fn scene_blend(first: &Task, second: &Task, number: u32) -> Option<Scene> {
    let seed = first.id.seed(u64::from(number)) ^ second.id.seed(0).rotate_left(32);
    let share = Pcg64Mcg::seed_from_u64(seed).random_range(SHARES);
    let scenes = [&first.scene, &second.scene];
    let blend = interpolated(scenes, share)?;
    let fits = is_inside(scenes, &blend) && bodies_keep_apart(&scenes, &blend);
    (fits && !outcome(&blend, None).is_ok_and(|alone| alone.solved)).then_some(blend)
}

/// The scene at this share of the way from the first to the second.
fn interpolated([first, second]: [&Scene; 2], share: f64) -> Option<Scene> {
    let same_bodies = first.bodies.len() == second.bodies.len();
    if !same_bodies || (first.body1, first.body2) != (second.body1, second.body2) {
        return None;
    }
    let between = |from: f64, to: f64| from + share * (to - from);
    let shape = |from: &Shape, to: &Shape| match (from, to) {
        (Shape::Circle(from), Shape::Circle(to)) => Some(Shape::Circle(between(*from, *to))),
        (Shape::Polygon(from), Shape::Polygon(to)) if from.len() == to.len() => {
            let corners = from.iter().zip(to).map(|(from, to)| [between(from[0], to[0]), between(from[1], to[1])]);
            Some(Shape::Polygon(corners.collect()))
        }
        _ => None,
    };
    let body = |from: &Body, to: &Body| {
        let kind = |body: &Body| (body.dynamic, body.role, body.shape_type, body.shapes.len());
        let shapes = from.shapes.iter().zip(&to.shapes).map(|(from, to)| shape(from, to)).collect::<Option<_>>()?;
        (kind(from) == kind(to)).then(|| Body {
            x: between(from.x, to.x),
            y: between(from.y, to.y),
            angle: between(from.angle, to.angle),
            shapes,
            ..from.clone()
        })
    };
    let bodies = first.bodies.iter().zip(&second.bodies).map(|(from, to)| body(from, to)).collect::<Option<_>>()?;
    Some(Scene { bodies, ..first.clone() })
}

/// Whether no body sticks out of the scene farther than in the scenes that were blended.
fn is_inside(scenes: [&Scene; 2], blend: &Scene) -> bool {
    blend.bodies.iter().enumerate().all(|(index, body)| {
        let [left, bottom, right, top] = body.bounds();
        let [a, b] = scenes.map(|scene| scene.bodies[index].bounds());
        let low = |side: usize| a[side].min(b[side]).min(0.0) - TOLERANCE;
        let high = |side: usize| a[side].max(b[side]).max(SIZE) + TOLERANCE;
        left >= low(0) && bottom >= low(1) && right <= high(2) && top <= high(3)
    })
}

#[cfg(test)]
mod tests {
    use pathlight::puzzle::task::ids;
    use pathlight::puzzle::templates::TEMPLATES;

    use super::*;

    /// The first task of each template with its first blends with others.
    fn blends() -> impl Iterator<Item = (Task, Vec<(Task, Scene)>)> {
        TEMPLATES.iter().map(|template| {
            let tasks: Vec<TaskId> = ids(template).collect();
            let task = Task::load(tasks[0]).expect("a task");
            let blends = (0..20).filter_map(|number| blend_of(&task, number, &tasks));
            let blends = blends.map(|(partner, scene)| (Task::load(partner).expect("a task"), scene)).collect();
            (task, blends)
        })
    }

    #[test]
    fn most_templates_have_many_blends_and_each_is_another_scene() {
        let mut with_many = 0;
        for (task, blends) in blends() {
            for (index, (partner, scene)) in blends.iter().enumerate() {
                assert!(*scene != task.scene && *scene != partner.scene, "{} and {}", task.id, partner.id);
                assert!(blends[..index].iter().all(|(_, other)| other != scene), "{}", task.id);
            }
            with_many += usize::from(blends.len() >= 15);
        }
        assert!(with_many >= 22, "{with_many} of 25 templates");
    }

    #[test]
    fn a_blend_lies_between_two_scenes_and_does_not_solve_itself() {
        let numbers = |scene: &Scene| -> Vec<f64> {
            let of_shape = |shape: &Shape| match shape {
                Shape::Circle(radius) => vec![*radius],
                Shape::Polygon(corners) => corners.concat(),
            };
            let of_shapes = scene.bodies.iter().flat_map(|body| &body.shapes).flat_map(of_shape);
            scene.bodies.iter().flat_map(|body| [body.x, body.y, body.angle]).chain(of_shapes).collect()
        };
        for (task, blends) in blends() {
            for (partner, scene) in blends {
                let ends = numbers(&task.scene).into_iter().zip(numbers(&partner.scene));
                for ((from, to), at) in ends.zip(numbers(&scene)) {
                    let between = from.min(to) - 1e-9..=from.max(to) + 1e-9;
                    assert!(between.contains(&at), "{} and {}: {at} of {from} to {to}", task.id, partner.id);
                }
                let scenes = [&task.scene, &partner.scene];
                assert!(
                    is_inside(scenes, &scene) && bodies_keep_apart(&scenes, &scene),
                    "{} and {}",
                    task.id,
                    partner.id
                );
                assert!(!outcome(&scene, None).expect("no ball, so none is invalid").solved, "{}", task.id);
            }
        }
    }

    #[test]
    fn an_id_makes_the_scene_that_was_found_again() {
        let tasks: Vec<TaskId> = ids(TEMPLATES[2]).collect();
        let task = Task::load(tasks[0]).expect("a task");
        let (partner, scene) = blend_of(&task, 3, &tasks).expect("a blend");
        assert_eq!(blend_of(&task, 3, &tasks), Some((partner, scene.clone())));
        let partner = Task::load(partner).expect("a task");
        assert_eq!(scene_blend(&task, &partner, 3), Some(scene));
    }

    #[test]
    fn scenes_with_other_bodies_have_no_blend() {
        let [first, second] =
            [2, 3].map(|number| Task::load(ids(TEMPLATES[number]).next().expect("a task")).expect("a task"));
        assert_eq!(interpolated([&first.scene, &second.scene], 0.5), None);
    }
}

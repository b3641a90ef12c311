//! How near the green object came to its goal in a rollout, and when. The page shows this after a miss.

use rapier2d::math::Vector;
use serde::{Deserialize, Serialize};

use super::distance::{Outline, pose_of};
use super::units::{PX_PER_METRE, point_in_px};
use crate::puzzle::rollout::Rollout;
use crate::puzzle::scene::Scene;

/// The moment at which the green object was nearest to its goal.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct ClosestApproach {
    /// The first step with the smallest distance.
    pub step: usize,
    /// Distance of their surfaces, px; 0 if they overlap.
    pub gap: f64,
    /// The nearest points of the object and of the goal at that step, px; the same point if they overlap.
    pub points: [[f64; 2]; 2],
}

/// Returns the closest approach of the green object to its goal in a rollout of this scene.
pub fn closest_approach(scene: &Scene, rollout: &Rollout) -> ClosestApproach {
    let indices = [scene.body1, scene.body2];
    let bodies = indices.map(|index| &scene.bodies[index]);
    let [object, goal] = bodies.map(Outline::of);
    let poses = |step| [0, 1].map(|side| rollout.pose(step, indices[side]).unwrap_or_else(|| pose_of(bodies[side])));
    let mut closest = (0, f32::MAX, [Vector::ZERO; 2]);
    let mut last = None;
    for step in 0..=rollout.steps {
        let poses = poses(step);
        if last.replace(poses) == Some(poses) {
            continue;
        }
        if let Some([p, q]) = object.nearest_points(poses[0], &goal, poses[1], closest.1) {
            closest = (step, (q - p).length(), [p, q]);
            if p == q {
                break;
            }
        }
    }
    approach(closest)
}

fn approach((step, gap, points): (usize, f32, [Vector; 2])) -> ClosestApproach {
    let points = points.map(|point| point_in_px(point).map(f64::from));
    ClosestApproach { step, gap: f64::from(gap * PX_PER_METRE), points }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::action::Ball;
    use crate::puzzle::task::Task;
    use crate::simulator::simulate;

    fn scene(task: &str) -> Scene {
        Task::load(task.parse().expect("an id")).expect("a task").scene
    }

    #[test]
    fn between_two_balls_it_is_the_distance_of_their_centres_less_their_radii() {
        let scene = scene("00000:000");
        let [object, goal] = [scene.body1, scene.body2];
        let radii: f64 = [object, goal].iter().filter_map(|&index| scene.bodies[index].ball_radius()).sum();
        let rollout = simulate(&scene, None).expect("no ball is refused");
        let distance = |step: usize| {
            let [a, b] =
                [object, goal].map(|index| rollout.pose(step, index).unwrap_or_else(|| pose_of(&scene.bodies[index])));
            libm::hypot(f64::from(a[0] - b[0]), f64::from(a[1] - b[1])) - radii
        };
        let nearest = (0..=rollout.steps).min_by(|&a, &b| distance(a).total_cmp(&distance(b))).expect("steps");
        let closest = closest_approach(&scene, &rollout);
        assert!((closest.gap - distance(nearest).max(0.0)).abs() < 1e-3, "{closest:?}, {}", distance(nearest));
        assert!((distance(closest.step) - distance(nearest)).abs() < 1e-3);
        let [[x1, y1], [x2, y2]] = closest.points;
        assert!((libm::hypot(x1 - x2, y1 - y2) - closest.gap).abs() < 1e-3, "the points are the ends of the gap");
    }

    #[test]
    fn it_is_zero_exactly_where_the_object_touches() {
        let mut counts = [0; 2];
        for id in ["00000:000", "00001:005", "00002:007", "00007:008", "00014:006", "00020:000"] {
            let task = Task::load(id.parse().expect("an id")).expect("a task");
            let balls = (1..24).map(|x| Ball { x: f64::from(10 * x), y: 225.0, r: 22.0 });
            for rollout in balls.filter_map(|ball| simulate(&task.scene, Some(ball)).ok()) {
                let closest = closest_approach(&task.scene, &rollout);
                let touched = rollout.touching.contains(&true);
                // Contacts begin within the skins of both bodies: two of 0.01 m, and Box2D's slop.
                assert_eq!(touched, closest.gap < 0.2, "{}: {closest:?}", task.id);
                counts[usize::from(touched)] += 1;
            }
        }
        assert!(counts.into_iter().all(|count| count > 5), "misses and touches: {counts:?}");
    }
}

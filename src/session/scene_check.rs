//! Checks whether a custom scene can be played: it must keep its limits, and nothing may overlap at the start deeper
//! than the engine can separate. The page runs this check for every frame of a drag.

use crate::puzzle::custom_scene::{CustomScene, Fault, MAX_OVERLAP, Problem};
use crate::puzzle::scene::Scene;
use crate::simulator::penetration::overlaps;

/// Returns the reasons why a scene cannot be played: one for each body, or overlaps if there are no others. Empty if
/// the scene can be played.
pub fn problems(custom: &CustomScene) -> Vec<Problem> {
    let mut problems = custom.limit_problems();
    // Bodies that violate the limits have no shapes to compare.
    if problems.is_empty() {
        let deep = overlaps(&custom.to_scene()).into_iter().filter(|overlap| overlap.depth > MAX_OVERLAP);
        problems.extend(deep.map(|overlap| {
            let [first, second] = overlap.bodies.map(|body| custom.body_name(body));
            let depth = overlap.depth;
            let sentence = format!(
                "The {first} and the {second} overlap by {depth:.1} px, more than {MAX_OVERLAP}: move them apart."
            );
            let fault = Fault::Overlap { by: depth, most: MAX_OVERLAP };
            Problem { other: Some(overlap.bodies[1]), ..Problem::of_body(overlap.bodies[0], fault, sentence) }
        }));
    }
    problems
}

/// Returns the scene to simulate.
///
/// # Errors
///
/// The reasons why it cannot be played.
pub fn checked(custom: &CustomScene) -> Result<Scene, Vec<Problem>> {
    let problems = problems(custom);
    if problems.is_empty() { Ok(custom.to_scene()) } else { Err(problems) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::puzzle::task::Task;
    use crate::puzzle::templates::TEMPLATES;

    #[test]
    fn no_bodies_of_the_benchmark_overlap_too_deep() {
        for task in TEMPLATES.into_iter().flat_map(Task::of) {
            let custom = CustomScene::of(&task.scene).expect("the four shapes");
            assert_eq!(problems(&custom), custom.limit_problems(), "{}", task.id);
        }
    }

    #[test]
    fn a_body_in_another_is_named() {
        let task = Task::load("00000:000".parse().expect("an id")).expect("a task");
        let mut custom = CustomScene::of(&task.scene).expect("the four shapes");
        (custom.bodies[1].x, custom.bodies[1].y) = (custom.bodies[0].x + 1.0, custom.bodies[0].y);
        let problems = problems(&custom);
        assert_eq!((problems.len(), problems[0].body, problems[0].other), (1, Some(0), Some(1)));
        assert!(problems[0].sentence.starts_with("The green ball (body 0) and the blue ball (body 1) overlap by "));
    }
}

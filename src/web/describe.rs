//! Descriptions in words: why a ball is invalid, and a scene for people who cannot see it.

use crate::puzzle::action::Invalid;
use crate::puzzle::scene::{Body, Scene};

/// Returns why a ball is invalid, with the name of the body that it overlaps.
pub(crate) fn invalid_reason(why: Invalid, scene: &Scene) -> String {
    match why {
        Invalid::Overlaps(body) => format!("the ball overlaps the {}", scene.bodies[body].name()),
        why => why.to_string(),
    }
}

/// Describes a scene for people who cannot see it: every body with its position, object and goal first.
pub(crate) fn describe_scene(scene: &Scene) -> String {
    let position = |body: &Body| format!("{} at x {:.0}, y {:.0}", body.name(), body.x, body.y);
    let (object, target) = (&scene.bodies[scene.body1], &scene.bodies[scene.body2]);
    let others: Vec<String> = (0..scene.bodies.len())
        .filter(|&index| index != scene.body1 && index != scene.body2)
        .map(|index| position(&scene.bodies[index]))
        .collect();
    let rest = if others.is_empty() { "Nothing else.".to_string() } else { format!("Also: {}.", others.join("; ")) };
    format!("256 by 256, y is up. The {}; the goal is the {}. {rest}", position(object), position(target))
}

//! A puzzle in words: what is in the way of a ball, and the scene for someone who does not see it.

use crate::puzzle::action::Invalid;
use crate::puzzle::scene::{Body, Scene};

/// Why a ball is invalid, with the name of the body in its way.
pub fn reason(why: Invalid, scene: &Scene) -> String {
    match why {
        Invalid::Overlaps(body) => format!("the ball overlaps the {}", scene.bodies[body].name()),
        why => why.to_string(),
    }
}

/// The scene for someone who does not see it: every body with its place, what matters first.
pub fn described(scene: &Scene) -> String {
    let place = |body: &Body| format!("{} at x {:.0}, y {:.0}", body.name(), body.x, body.y);
    let (object, target) = (&scene.bodies[scene.body1], &scene.bodies[scene.body2]);
    let others: Vec<String> = (0..scene.bodies.len())
        .filter(|&index| index != scene.body1 && index != scene.body2)
        .map(|index| place(&scene.bodies[index]))
        .collect();
    let rest = if others.is_empty() { "Nothing else.".to_string() } else { format!("Also: {}.", others.join("; ")) };
    format!("256 by 256, y is up. The {}; the goal is the {}. {rest}", place(object), place(target))
}

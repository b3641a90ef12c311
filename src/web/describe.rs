//! Why a ball is invalid, in words.

use crate::puzzle::action::Invalid;
use crate::puzzle::scene::Scene;

/// Returns why a ball is invalid, with the name of the body that it overlaps.
pub(crate) fn invalid_reason(why: Invalid, scene: &Scene) -> String {
    match why {
        Invalid::Overlaps(body) => format!("the ball overlaps the {}", scene.bodies[body].name()),
        why => why.to_string(),
    }
}

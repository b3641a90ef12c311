//! The constants that the page's modules need before the wasm is loaded. `scripts/constants.mjs` writes them to a
//! module.

use serde_json::json;
use wasm_bindgen::prelude::*;

use super::data::to_js;
use crate::benchmark::auccess::MAX_ATTEMPTS;
use crate::colour::imagined_maps::ImaginedMap;
use crate::colour::palette::palette;
use crate::puzzle::action::RADIUS;
use crate::puzzle::dimensions;
use crate::puzzle::rollout::{GOAL_STEPS, STEPS_PER_SECOND};
use crate::puzzle::scene::SIZE;
use crate::raster::{PX_PER_CELL, SIDE};

/// Returns the constants and colours that the page shares with the Rust code. Lengths are in px.
#[wasm_bindgen(unchecked_return_type = "Record<string, unknown>")]
pub fn constants() -> Result<JsValue, JsValue> {
    to_js(&json!({
        "scene_size": SIZE,
        // The number of cells along a side of a map, and the side of a cell.
        "grid_side": SIDE,
        "cell_size": PX_PER_CELL,
        "min_radius": RADIUS.start(),
        "max_radius": RADIUS.end(),
        "attempt_limit": MAX_ATTEMPTS,
        "steps_per_second": STEPS_PER_SECOND,
        "goal_steps": GOAL_STEPS,
        "maps": ImaginedMap::ALL.map(ImaginedMap::name),
        // Degrees from the horizontal.
        "stick_lean": dimensions::STICK_LEAN,
        "half_stick": dimensions::HALF_STICK,
        "jar_height_per_width": dimensions::JAR_HEIGHT_PER_WIDTH,
        "jar_base": dimensions::JAR_BASE,
        "light_palette": palette(false),
        "dark_palette": palette(true),
    }))
}

//! The wasm exports, which the page and its worker call, and the painter. The only user of wasm_bindgen and web_sys.
//!
//! `open_puzzle` is a puzzle to play, `custom_scene` a puzzle to edit, and `frame` draws both. `model` holds the nets
//! in the worker, `memory` what they remember, and `search` finds solutions by simulation. `scripting` has the
//! functions for scripts that take a puzzle; `benchmark` and `constants` have those that take none. Data go to
//! JavaScript as plain objects with the field names of the Rust types, which `types.d.ts` declares, or as typed arrays.
//!
//! Functions that take a puzzle throw `bad_task` if the task does not exist, and `bad_scene` if the scene cannot be
//! played. Any function throws `bad_data` for a value of the wrong form. The docs name only other errors.

use wasm_bindgen::prelude::wasm_bindgen;

mod benchmark;
mod constants;
mod custom_scene;
mod data;
mod error;
mod frame;
mod imagined;
mod maps;
mod marks;
#[cfg(feature = "nets")]
mod memory;
#[cfg(feature = "nets")]
mod model;
mod open_puzzle;
mod paint;
mod puzzle;
mod scripting;
mod search;
mod static_layer;

pub use benchmark::{auccess, difficulty, fold, soft_iou, solve_rates, templates};
pub use constants::constants;
pub use custom_scene::{custom_scene, paint_edited_scene, scene_digest, scene_limits, scene_problems};
pub use error::throw_panics;
pub use frame::paint_thumbnail;
pub use maps::{paint_map, paint_outcomes};
pub use open_puzzle::OpenPuzzle;
pub use puzzle::{JsBall, JsBallOrNull, JsPuzzle};
pub use scripting::{attempt_line, raster, simulate, verify_attempt, why_invalid};
pub use search::{SolutionSearch, SolveMap, luck};
#[cfg(feature = "nets")]
pub use {memory::Memory, model::Model, model::Turn};

/// The types of the objects that are passed. wasm-bindgen copies them into the package's declarations.
#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("types.d.ts");

#[wasm_bindgen(typescript_custom_section)]
const MAP_NAME: &str = crate::colour::imagined_maps::ImaginedMap::NAME_TYPE;

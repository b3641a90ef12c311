//! The TypeScript types of the objects passed between Rust and JavaScript, for `tsc` and for editors.
//!
//! They are declared in `types.d.ts`, which wasm-bindgen copies into the package's declarations; the exports name them
//! as the types of their parameters and results. A Node test compares their fields with the values that Rust sends.

use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("types.d.ts");

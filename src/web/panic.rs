//! Turns a Rust panic into a JavaScript `Error` with the message of the panic and the code `panic`.
//!
//! Without it a panic is a `RuntimeError: unreachable`. The error is thrown from the panic hook, before the wasm traps,
//! so nothing is unwound: the instance must not be used again.

use std::panic;

use wasm_bindgen::prelude::*;

use super::error::{Code, error};

/// Installs the panic hook. wasm-bindgen calls it when the module is instantiated.
#[wasm_bindgen(start)]
pub fn throw_panics() {
    panic::set_hook(Box::new(|info| {
        wasm_bindgen::throw_val(error(Code::Panic, format!("Pathlight has a defect: {info}")))
    }));
}

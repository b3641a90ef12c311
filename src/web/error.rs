//! Errors for JavaScript: an `Error` whose message is a sentence and whose `code` is stable. Panics are among them.

use std::fmt::Display;
use std::panic;

use js_sys::Reflect;
use serde::Serialize;
use wasm_bindgen::prelude::*;

/// What went wrong, for code that handles errors; the sentence is for people. `types.d.ts` documents each code.
#[derive(Clone, Copy, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Code {
    BadTask,
    BadScene,
    BadMap,
    #[cfg(feature = "nets")]
    BadWeights,
    #[cfg(feature = "nets")]
    BadMemory,
    InvalidBall,
    BadData,
    Panic,
}

/// Returns a JavaScript `Error` with a `code`.
pub(crate) fn error(code: Code, sentence: impl Display) -> JsValue {
    let error = js_sys::Error::new(&sentence.to_string());
    let code = serde_wasm_bindgen::to_value(&code).expect("a text");
    Reflect::set(&error, &"code".into(), &code).expect("an Error takes properties");
    error.into()
}

/// Makes a panic throw an `Error` with its message, where wasm alone would throw `RuntimeError: unreachable`. The panic
/// hook throws it, so nothing is unwound, and the instance must not be used again. wasm-bindgen calls this when the
/// module is instantiated.
#[wasm_bindgen(start)]
pub fn throw_panics() {
    panic::set_hook(Box::new(|info| {
        wasm_bindgen::throw_val(error(Code::Panic, format!("Pathlight has a defect: {info}")))
    }));
}

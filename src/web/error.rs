//! Errors as JavaScript knows them: a real `Error` whose message is a sentence and whose `code` stays the same.

use std::fmt::Display;

use serde::Serialize;
use wasm_bindgen::prelude::*;

/// What went wrong, for code that has to tell; people read the sentence.
#[derive(Clone, Copy)]
pub enum Code {
    /// No such task.
    BadTask,
    /// A map that is none: wrong name or size.
    BadMap,
    /// Weights that are none.
    BadWeights,
    /// A ball that may not be placed.
    InvalidBall,
    /// The hundred attempts are used.
    Spent,
    /// There is no such attempt.
    NoAttempt,
    /// Data from JavaScript that does not have the agreed form.
    BadData,
}

impl Code {
    fn name(self) -> &'static str {
        match self {
            Code::BadTask => "bad_task",
            Code::BadMap => "bad_map",
            Code::BadWeights => "bad_weights",
            Code::InvalidBall => "invalid_ball",
            Code::Spent => "spent",
            Code::NoAttempt => "no_attempt",
            Code::BadData => "bad_data",
        }
    }
}

/// A JavaScript `Error` with a `code`.
pub fn error(code: Code, sentence: impl Display) -> JsValue {
    let error = js_sys::Error::new(&sentence.to_string());
    js_sys::Reflect::set(&error, &"code".into(), &code.name().into()).expect("an Error takes properties");
    error.into()
}

/// A value as a plain JavaScript object: maps become objects, and what is missing is `null`.
pub fn plain(value: &impl Serialize) -> Result<JsValue, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::json_compatible();
    value.serialize(&serializer).map_err(|reason| error(Code::BadData, reason))
}

/// A value from a JavaScript object.
pub fn from_plain<T: serde::de::DeserializeOwned>(value: JsValue) -> Result<T, JsValue> {
    serde_wasm_bindgen::from_value(value).map_err(|reason| error(Code::BadData, reason))
}

//! Errors for JavaScript: an `Error` whose message is a sentence and whose `code` is stable. Conversion of plain data.

use std::fmt::Display;
use std::ops::RangeInclusive;

use serde::Serialize;
use wasm_bindgen::prelude::*;

use super::puzzle_from_js::written;

/// What went wrong, for code that handles it; people read the sentence.
#[derive(Clone, Copy)]
pub(crate) enum Code {
    /// No such task.
    BadTask,
    /// A custom scene that may not be played.
    BadScene,
    /// A map of an unknown name or of a wrong size.
    BadMap,
    /// Not weights of these nets.
    #[cfg(feature = "nets")]
    BadWeights,
    /// Not a memory of attempts that this version and these weights can use.
    #[cfg(feature = "nets")]
    BadMemory,
    /// An invalid ball.
    InvalidBall,
    /// All attempts are used.
    AttemptLimit,
    /// There is no such attempt.
    NoAttempt,
    /// Data from JavaScript that do not have the agreed form.
    BadData,
    /// A defect in the Rust code.
    Panic,
}

impl Code {
    fn name(self) -> &'static str {
        match self {
            Code::BadTask => "bad_task",
            Code::BadScene => "bad_scene",
            Code::BadMap => "bad_map",
            #[cfg(feature = "nets")]
            Code::BadWeights => "bad_weights",
            #[cfg(feature = "nets")]
            Code::BadMemory => "bad_memory",
            Code::InvalidBall => "invalid_ball",
            Code::AttemptLimit => "attempt_limit",
            Code::NoAttempt => "no_attempt",
            Code::BadData => "bad_data",
            Code::Panic => "panic",
        }
    }
}

/// Returns a JavaScript `Error` with a `code`.
pub(crate) fn error(code: Code, sentence: impl Display) -> JsValue {
    let error = js_sys::Error::new(&sentence.to_string());
    js_sys::Reflect::set(&error, &"code".into(), &code.name().into()).expect("an Error takes properties");
    error.into()
}

/// Converts a value to a plain JavaScript object: maps become objects, and `None` becomes `null`.
pub(crate) fn to_js(value: &impl Serialize) -> Result<JsValue, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::json_compatible();
    value.serialize(&serializer).map_err(|reason| error(Code::BadData, reason))
}

/// Converts a JavaScript object to a value.
///
/// # Errors
/// `bad_data` if it does not have the form of the type.
pub(crate) fn from_js<T: serde::de::DeserializeOwned>(value: JsValue) -> Result<T, JsValue> {
    serde_wasm_bindgen::from_value(value).map_err(|reason| error(Code::BadData, reason))
}

/// Returns a whole number. It comes as JavaScript's value, because wasm-bindgen would wrap or truncate others.
///
/// # Errors
/// `bad_data` if it is not a whole number in the range; `rule` says what it has to be.
pub(crate) fn whole_number(value: &JsValue, range: RangeInclusive<u32>, rule: impl Display) -> Result<u32, JsValue> {
    let range = f64::from(*range.start())..=f64::from(*range.end());
    let number = value.as_f64().filter(|number| number.fract() == 0.0 && range.contains(number));
    let refused = || error(Code::BadData, format!("{rule}, not {}", written(value)));
    number.map(|number| number as u32).ok_or_else(refused)
}

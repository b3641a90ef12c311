//! Converts data between Rust and JavaScript: plain objects with the field names of the Rust types, typed arrays, JSON.

use std::fmt::Display;
use std::ops::RangeInclusive;

use js_sys::{Float32Array, JSON};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use wasm_bindgen::JsCast;
use wasm_bindgen::prelude::*;

use super::error::{Code, error};
use crate::puzzle::sampled_paths::{SampledPath, SampledPaths};

/// A typed array in a plain object.
#[derive(Serialize)]
pub(crate) struct Typed<Array: JsCast>(#[serde(with = "serde_wasm_bindgen::preserve")] pub Array);

/// Sampled paths as typed arrays, each with x and y alternating.
#[derive(Serialize)]
pub(crate) struct TypedPaths {
    object: Typed<Float32Array>,
    ball: Typed<Float32Array>,
}

impl From<&SampledPaths> for TypedPaths {
    fn from(SampledPaths { object, ball }: &SampledPaths) -> TypedPaths {
        TypedPaths { object: object.into(), ball: ball.into() }
    }
}

impl From<&SampledPath> for Typed<Float32Array> {
    fn from(path: &SampledPath) -> Typed<Float32Array> {
        Typed(Float32Array::from(path.as_flattened()))
    }
}

/// Converts a value to a plain JavaScript object: maps become objects, and `None` becomes `null`.
pub(crate) fn to_js(value: &impl Serialize) -> Result<JsValue, JsValue> {
    let serializer = serde_wasm_bindgen::Serializer::json_compatible();
    value.serialize(&serializer).map_err(|reason| error(Code::BadData, reason))
}

/// Converts a JavaScript object to a value.
pub(crate) fn from_js<T: DeserializeOwned>(value: JsValue) -> Result<T, JsValue> {
    serde_wasm_bindgen::from_value(value).map_err(|reason| error(Code::BadData, reason))
}

/// Returns a foreign value as JSON. Returns null if it has no JSON form, or is nested so deeply that conversion
/// overflows the stack.
pub(crate) fn json(value: &JsValue) -> Value {
    let text = JSON::stringify(value).ok().and_then(|text| text.as_string());
    text.and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default()
}

/// Returns a whole number. It comes as a JavaScript value, because wasm-bindgen would wrap or truncate others.
///
/// # Errors
///
/// `bad_data` if it is not a whole number in the range; `rule` states the requirement.
pub(crate) fn whole_number(value: &JsValue, range: RangeInclusive<u32>, rule: impl Display) -> Result<u32, JsValue> {
    let range = f64::from(*range.start())..=f64::from(*range.end());
    let number = value.as_f64().filter(|number| number.fract() == 0.0 && range.contains(number));
    let refused = || error(Code::BadData, format!("{rule}, not {}", written(value)));
    number.map(|number| number as u32).ok_or_else(refused)
}

/// Formats a value that is not a string as a person would write it, for the error that names it.
pub(crate) fn written(value: &JsValue) -> String {
    // JSON has no NaN and no infinity.
    let number = value.as_f64().map(|number| number.to_string());
    number.or_else(|| JSON::stringify(value).ok()?.as_string()).unwrap_or_else(|| "undefined".to_string())
}

//! Names the fields in which two values differ, for errors about settings that do not match.

use std::collections::BTreeSet;

use serde::Serialize;
use serde_json::{Map, Value};

/// Lists the differing fields with both values: "`seed` is 0 instead of 5". Empty if there are none.
pub fn differences<T: Serialize>(found: &T, expected: &T) -> String {
    let fields = |value: &T| match serde_json::to_value(value).expect("settings are plain data") {
        Value::Object(fields) => fields,
        other => [("value".to_string(), other)].into_iter().collect(),
    };
    let (found, expected) = (fields(found), fields(expected));
    // An absent field is an `Option` that is not written when it is `None`.
    let names: BTreeSet<&String> = found.keys().chain(expected.keys()).collect();
    let value = |fields: &Map<String, Value>, name: &str| match fields.get(name) {
        None | Some(Value::Null) => "none".to_string(),
        Some(value) => value.to_string(),
    };
    names
        .into_iter()
        .map(|name| (name, value(&found, name), value(&expected, name)))
        .filter(|(_, found, expected)| found != expected)
        .map(|(name, found, expected)| format!("`{name}` is {found} instead of {expected}"))
        .collect::<Vec<_>>()
        .join(", ")
}

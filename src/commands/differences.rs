//! Names the fields in which two values differ, for errors about settings that do not match.

use serde::Serialize;
use serde_json::Value;

/// Lists the differing fields with both values: "`seed` is 0 there and 5 now". Empty if there are none.
pub fn differences<T: Serialize>(there: &T, now: &T) -> String {
    let fields = |value: &T| match serde_json::to_value(value).expect("settings are plain data") {
        Value::Object(fields) => fields,
        other => [("value".to_string(), other)].into_iter().collect(),
    };
    let (there, now) = (fields(there), fields(now));
    // An absent field is an `Option` that is not written when it is `None`.
    let names: std::collections::BTreeSet<&String> = there.keys().chain(now.keys()).collect();
    let value = |fields: &serde_json::Map<String, Value>, name: &str| match fields.get(name) {
        None | Some(Value::Null) => "not set".to_string(),
        Some(value) => value.to_string(),
    };
    names
        .into_iter()
        .map(|name| (name, value(&there, name), value(&now, name)))
        .filter(|(_, there, now)| there != now)
        .map(|(name, there, now)| format!("`{name}` is {there} there and {now} now"))
        .collect::<Vec<_>>()
        .join(", ")
}

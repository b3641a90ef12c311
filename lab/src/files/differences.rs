//! Names the fields in which two values differ, for errors about settings that do not match.

use std::collections::BTreeSet;

use serde::Serialize;
use serde_json::Value;

/// Lists the differing fields with both values: "`seed` is 0 instead of 5". A nested field is named like `dqn.batch`.
/// Empty if the values are equal.
pub fn differences<T: Serialize>(found: &T, expected: &T) -> String {
    let [found, expected] = [found, expected].map(|value| serde_json::to_value(value).expect("plain data"));
    let mut listed = Vec::new();
    list("", &found, &expected, &mut listed);
    listed.join(", ")
}

fn list(name: &str, found: &Value, expected: &Value, listed: &mut Vec<String>) {
    if let (Value::Object(found), Value::Object(expected)) = (found, expected) {
        // A field is absent if it is an `Option` that is `None`.
        let fields: BTreeSet<&String> = found.keys().chain(expected.keys()).collect();
        for field in fields {
            let [found, expected] = [found, expected].map(|fields| fields.get(field).unwrap_or(&Value::Null));
            let name = if name.is_empty() { field.clone() } else { format!("{name}.{field}") };
            list(&name, found, expected, listed);
        }
    } else if found != expected {
        let [found, expected] = [found, expected].map(|value| match value {
            Value::Null => "none".to_string(),
            value => value.to_string(),
        });
        let name = if name.is_empty() { "value" } else { name };
        listed.push(format!("`{name}` is {found} instead of {expected}"));
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn fields_at_any_depth_are_named() {
        let found = json!({"seed": 0, "dqn": {"batch": 9, "rate": 1}, "more": null});
        let expected = json!({"seed": 5, "dqn": {"batch": 16, "rate": 1}});
        assert_eq!(differences(&found, &expected), "`dqn.batch` is 9 instead of 16, `seed` is 0 instead of 5");
        assert_eq!(differences(&found, &found), "");
        assert_eq!(
            differences(&json!({"success": {"seed": 1}}), &json!({})),
            "`success` is {\"seed\":1} instead of none"
        );
    }
}

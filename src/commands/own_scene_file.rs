//! Own scenes in files. Their numbers are read to the last bit, which serde_json alone does not: a rollout depends on it.

use std::fs;
use std::path::Path;

use anyhow::{Context, bail};
use jiter::JsonValue;
use pathlight::play::played::Played;
use pathlight::puzzle::own_scene::sentences;
use serde_json::{Number, Value};

/// Largest file, bytes. The largest scene needs some 10,000.
const MAX_SIZE: u64 = 1 << 20;

/// Reads an own scene that may be played.
///
/// # Errors
/// If the file cannot be read, is no scene, or the scene may not be played: then all reasons.
pub fn read(path: &Path) -> anyhow::Result<(Value, Played)> {
    let shown = path.display();
    let size = fs::metadata(path).with_context(|| format!("cannot read {shown}"))?.len();
    anyhow::ensure!(size <= MAX_SIZE, "{shown} is larger than {MAX_SIZE} bytes, so it is no scene");
    let bytes = fs::read(path).with_context(|| format!("cannot read {shown}"))?;
    let value = exact_json(&bytes).with_context(|| format!("in {shown}"))?;
    match Played::read(value.clone()) {
        Ok(played) => Ok((value, played)),
        Err(problems) => bail!("the scene of {shown} may not be played. {}", sentences(&problems)),
    }
}

/// Parses JSON with exactly rounded numbers.
///
/// # Errors
/// Where it is no JSON.
pub fn exact_json(bytes: &[u8]) -> anyhow::Result<Value> {
    let parsed = JsonValue::parse(bytes, false).map_err(|error| anyhow::anyhow!("{}", error.description(bytes)))?;
    Ok(converted(&parsed))
}

fn converted(value: &JsonValue) -> Value {
    match value {
        JsonValue::Null => Value::Null,
        JsonValue::Bool(truth) => Value::Bool(*truth),
        JsonValue::Int(number) => Value::Number((*number).into()),
        JsonValue::Float(number) => Number::from_f64(*number).map_or(Value::Null, Value::Number),
        JsonValue::Str(text) => Value::String(text.to_string()),
        JsonValue::Array(values) => values.iter().map(converted).collect(),
        JsonValue::Object(entries) => entries.iter().map(|(key, value)| (key.to_string(), converted(value))).collect(),
    }
}

//! Reads custom scenes from untrusted JSON. The problems name each body that cannot be read.

use serde_json::{Map, Value};

use super::{CustomBody, CustomScene, Fault, Problem, VERSION};

impl CustomScene {
    /// Reads a scene from JSON. Unknown keys are ignored.
    ///
    /// # Errors
    ///
    /// All values that do not have the form of the schema. Limits are not checked.
    pub fn read(value: Value) -> Result<CustomScene, Vec<Problem>> {
        let Value::Object(mut keys) = value else {
            return Err(vec![Problem::unreadable(
                "This is not a scene: a scene is a JSON object with `version`, `body1`, `body2` and `bodies`.",
            )]);
        };
        match keys.get("version") {
            Some(version) if version.as_f64() == Some(f64::from(VERSION)) => {}
            Some(version) => {
                let remedy = if version.as_f64().is_some_and(|version| version > f64::from(VERSION)) {
                    "use a newer Pathlight".to_string()
                } else {
                    format!("set it to {VERSION} if it is a scene")
                };
                return Err(vec![Problem::unreadable(format!(
                    "The version of this scene is {version}, and this Pathlight reads version {VERSION}: {remedy}."
                ))]);
            }
            None if keys.contains_key("id") && keys.contains_key("params") => {
                return Err(vec![Problem::unreadable(
                    "This is a task as `pathlight tasks --json` prints it: use `pathlight tasks --custom` to make a scene of it.",
                )]);
            }
            None if keys.get("bodies").is_some_and(|bodies| bodies.pointer("/0/parts").is_some()) => {
                return Err(vec![Problem::unreadable(
                    "This is a scene as it is drawn, whose bodies have parts: make a custom scene by `pathlight tasks \
                     --custom`, or by `customScene` of the npm package.",
                )]);
            }
            None => {
                return Err(vec![Problem::unreadable(format!(
                    "A scene has `\"version\": {VERSION}`, and this one has none: add it if it is a scene."
                ))]);
            }
        }
        let mut problems = Vec::new();
        let mut bodies = Vec::new();
        match keys.remove("bodies") {
            Some(Value::Array(values)) => {
                for (index, value) in values.into_iter().enumerate() {
                    if let Some((key, found)) = no_number(&value) {
                        let why = format!("its `{key}` is {found}, and has to be a number");
                        problems.push(unreadable_body(index, &why));
                        continue;
                    }
                    match serde_json::from_value(value) {
                        Ok(body) => bodies.push(without_negative_zero(body)),
                        Err(reason) => problems.push(unreadable_body(index, &reason.to_string())),
                    }
                }
            }
            _ => problems.push(Problem::unreadable("`bodies` of a scene is a list of bodies: add it.")),
        }
        let index = |name: &str, problems: &mut Vec<Problem>| {
            let index = keys.get(name).and_then(whole_number);
            if index.is_none() {
                problems.push(Problem::unreadable(format!(
                    "`{name}` of a scene is the index of one of its bodies, from 0: correct it."
                )));
            }
            index.unwrap_or_default()
        };
        let (body1, body2) = (index("body1", &mut problems), index("body2", &mut problems));
        let name = name_of(&keys).unwrap_or_else(|problem| {
            problems.push(problem);
            None
        });
        let scene = CustomScene { version: VERSION, name, body1, body2, bodies };
        if problems.is_empty() { Ok(scene) } else { Err(problems) }
    }
}

fn unreadable_body(index: usize, why: &str) -> Problem {
    let sentence = format!("Body {index} cannot be read: {why}. Correct it as the schema says.");
    Problem::of_body(index, Fault::Unreadable, sentence)
}

/// Returns a key of a body that should be a number and is not; serde's error would not name it.
fn no_number(body: &Value) -> Option<(&'static str, &Value)> {
    let numbers = ["x", "y", "angle", "radius", "length", "thickness", "height"];
    let mut found = numbers.into_iter().filter_map(|key| Some((key, body.get(key)?)));
    found.find(|(_, value)| !value.is_number())
}

/// Returns a body with every -0 replaced by 0, as JavaScript writes it; its digest and its poses stay the same.
fn without_negative_zero(body: CustomBody) -> CustomBody {
    CustomBody { x: body.x + 0.0, y: body.y + 0.0, angle: body.angle + 0.0, ..body }
}

/// Returns a whole number, including one that JavaScript wrote with a fraction of zero.
fn whole_number(value: &Value) -> Option<usize> {
    let number =
        value.as_f64().filter(|number| number.fract() == 0.0 && (0.0..=f64::from(u32::MAX)).contains(number))?;
    Some(number as usize)
}

fn name_of(keys: &Map<String, Value>) -> Result<Option<String>, Problem> {
    match keys.get("name") {
        None | Some(Value::Null) => Ok(None),
        Some(Value::String(name)) => Ok(Some(name.clone())),
        Some(_) => Err(Problem::unreadable("`name` of a scene is a text: correct it, or leave it out.")),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::super::NAME_LENGTH;
    use super::super::tests::{problem, scene};
    use super::*;

    #[test]
    fn negative_zero_is_read_as_zero() {
        let mut turned = scene();
        turned["bodies"][0]["angle"] = json!(-0.0);
        assert!(CustomScene::read(turned).expect("a scene").bodies[0].angle.is_sign_positive());
    }

    #[test]
    fn what_is_not_a_scene_is_a_sentence() {
        for value in [json!(null), json!([1]), json!("scene"), json!({}), json!({"version": 2})] {
            assert!(CustomScene::read(value.clone()).is_err(), "{value}");
        }
        let wrong = [
            ("/version", json!("1")),
            ("/name", json!(7)),
            ("/name", json!("x".repeat(NAME_LENGTH + 1))),
            ("/body1", json!(1)),
            ("/body1", json!(-1)),
            ("/body2", json!(2)),
            ("/body2", json!(0.5)),
            ("/bodies", json!({})),
            ("/bodies", json!([])),
            ("/bodies/0", json!(null)),
            ("/bodies/0/shape", json!("blob")),
            ("/bodies/0/radius", json!(null)),
            ("/bodies/0/x", json!(1e300)),
            ("/bodies/1/y", json!(-1e300)),
        ];
        for (pointer, value) in wrong {
            assert!(problem(pointer, value).sentence.ends_with('.'), "{pointer}");
        }
        assert_eq!(
            problem("/bodies/1/y", json!("60")).sentence,
            "Body 1 cannot be read: its `y` is \"60\", and has to be a number. Correct it as the schema says."
        );
        let drawn = CustomScene::read(json!({"body1": 0, "body2": 1, "bodies": [{"x": 1, "parts": []}]}));
        assert!(drawn.expect_err("no custom scene")[0].sentence.contains("`customScene`"));
        for (version, remedy) in [(json!(2), "use a newer Pathlight."), (json!("1"), "set it to 1 if it is a scene.")] {
            let sentence = problem("/version", version).sentence;
            assert!(sentence.ends_with(remedy), "{sentence}");
        }
    }
}

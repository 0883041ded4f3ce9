//! Objects of JavaScript as values of Rust: `stepLength` there is `step_length` here.

use crate::failed;
use js_sys::JSON;
use serde::de::DeserializeOwned;
use serde_json::Value;
use wasm_bindgen::{JsError, JsValue};

/// A plain object, by its fields.
pub(crate) fn plain<T: DeserializeOwned>(object: &JsValue) -> Result<T, JsError> {
    let text = JSON::stringify(object).map_err(|_| failed("the options are no plain object"))?;
    let value: Value = serde_json::from_str(&String::from(text)).map_err(failed)?;
    serde_json::from_value(snake(value))
        .map_err(|error| failed(format!("the options: {}", camel(&error.to_string()))))
}

/// All keys with `_` where a capital letter was.
fn snake(value: Value) -> Value {
    match value {
        Value::Object(fields) => {
            Value::Object(fields.into_iter().map(|(key, value)| (snaked(&key), snake(value))).collect())
        }
        Value::Array(items) => Value::Array(items.into_iter().map(snake).collect()),
        other => other,
    }
}

fn snaked(key: &str) -> String {
    let mut found = String::with_capacity(key.len() + 2);
    for letter in key.chars() {
        if letter.is_ascii_uppercase() {
            found.push('_');
        }
        found.push(letter.to_ascii_lowercase());
    }
    found
}

/// A message with the names of fields as JavaScript has them: they stand between backticks.
fn camel(message: &str) -> String {
    let mut found = String::with_capacity(message.len());
    for (at, part) in message.split('`').enumerate() {
        if at > 0 {
            found.push('`');
        }
        let (mut letters, is_name) = (part.chars(), at % 2 == 1);
        while let Some(letter) = letters.next() {
            match letter {
                '_' if is_name => found.extend(letters.next().map(|next| next.to_ascii_uppercase())),
                letter => found.push(letter),
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_go_there_and_back() {
        assert_eq!(snaked("stepFrequency"), "step_frequency");
        let message = "unknown field `step_freq`, expected one of `gait`, `step_frequency`; a_b stays";
        assert_eq!(
            camel(message),
            "unknown field `stepFreq`, expected one of `gait`, `stepFrequency`; a_b stays"
        );
        let nested = serde_json::json!({"thenTurn": [{"stepLength": 1}]});
        assert_eq!(snake(nested), serde_json::json!({"then_turn": [{"step_length": 1}]}));
    }
}

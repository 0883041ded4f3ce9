//! Reference data that is not part of the project.

use serde_json::Value;
use std::path::PathBuf;

/// The text of a file of the reference data; where it is absent that is said aloud.
pub(crate) fn text(name: &str) -> Option<String> {
    let path = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data")).join(name);
    let text = std::fs::read_to_string(&path).ok();
    if text.is_none() {
        #[expect(clippy::print_stderr, reason = "a test that does not test anything says so")]
        {
            eprintln!("SKIPPED: {} is not here", path.display());
        }
    }
    text
}

/// A file of reference numbers.
pub(crate) fn json(name: &str) -> Option<Value> {
    text(name).map(|text| serde_json::from_str(&text).expect("JSON"))
}

/// A list of numbers.
pub(crate) fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|number| number.as_f64().expect("a number")).collect()
}

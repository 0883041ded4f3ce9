//! Errors of maps of two parameters.

/// Why a map of two parameters cannot be drawn.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
#[allow(missing_docs, reason = "each message says what its fields are")]
pub enum MapError {
    #[error(
        "{parameter} from {lower} to {upper} is no span of a map; it needs two numbers, the lesser first"
    )]
    Span { parameter: &'static str, lower: f64, upper: f64 },
    #[error("axis {axis} of a map is parameter {index}; {}", indices(*.parameters))]
    Axis { axis: &'static str, index: usize, parameters: usize },
    #[error("{found} values for the {expected} parameters of a map")]
    Values { found: usize, expected: usize },
    #[error("a map of {places} places a side; it must be {least} to {most}")]
    Places { places: usize, least: usize, most: usize },
}

/// What an index of so many parameters must be.
fn indices(parameters: usize) -> String {
    match parameters.checked_sub(1) {
        Some(last) => format!("it must be 0 to {last}"),
        None => "there are no parameters".to_owned(),
    }
}

//! The engine in a browser: a thin face for JavaScript over the libraries. See `package/README.md`.

#![allow(
    clippy::missing_errors_doc,
    reason = "what throws says why in its message; JavaScript declares none of it"
)]
#![allow(clippy::needless_pass_by_value, reason = "what JavaScript hands over is the callee's")]
#![allow(clippy::struct_field_names, reason = "each wraps what has its name in the libraries")]

mod dynamics;
mod figure;
mod motion;
mod options;
#[cfg(feature = "full")]
mod scene;
#[cfg(feature = "studio")]
mod studio;
mod walk;
mod walker;

pub use dynamics::Dynamics;
pub use figure::Figure;
pub use motion::Motion;
#[cfg(feature = "full")]
pub use scene::run;
#[cfg(feature = "studio")]
pub use studio::*;
pub use walk::{WalkOptions, walk};
pub use walker::Walker;

use wasm_bindgen::JsError;

/// What failed, as JavaScript's `Error`.
fn failed(error: impl std::fmt::Display) -> JsError {
    JsError::new(&error.to_string())
}

/// Refuses an array of another length.
fn check(name: &str, found: usize, expected: usize) -> Result<(), JsError> {
    if found == expected {
        return Ok(());
    }
    Err(JsError::new(&format!("{name} has {found} numbers; it must have {expected}")))
}

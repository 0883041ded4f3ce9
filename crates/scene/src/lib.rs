#![doc = include_str!("../README.md")]

mod complete;
mod error;
mod loader;
mod member;
mod read;
mod scene;
mod soles;
mod spelled;

pub use complete::{Completion, Completions, complete};
pub use error::SceneError;
pub use loader::{Loader, NoFiles};
pub use member::OneOfSeveral;
pub use scene::{Scene, Simulated};
pub use soles::read_soles;

use solaris_model::TextError;

/// The scene that a text describes; `loader` fetches the figures that it names as files.
///
/// # Errors
///
/// [`TextError`] with every fault, in the order of the text: what is no RON, what is unknown, missing, of the wrong kind or
/// out of range, names of degrees of freedom and links that the figure has not, walks that cannot be.
pub fn read(text: &str, loader: &mut dyn Loader) -> Result<Scene, TextError> {
    read::read(text, loader)
}

/// Whether a text is meant to be a scene: its first word is `Scene`.
pub fn is_scene(text: &str) -> bool {
    solaris_model::text::first_word(text) == Some("Scene")
}

//! Figures that stand in files of their own.

use solaris_model::Figure;

/// Fetches the figures that a scene names as files. This crate opens none itself.
pub trait Loader {
    /// The figure of a file, with the gravity that the file says; `path` is as it is written in the scene.
    ///
    /// # Errors
    ///
    /// Why there is none, in a sentence that follows the path.
    fn figure(&mut self, path: &str) -> Result<Figure, String>;
}

/// For scenes that need no files.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl Loader for NoFiles {
    fn figure(&mut self, _path: &str) -> Result<Figure, String> {
        Err("files are not read here; write the figure into the scene".to_owned())
    }
}

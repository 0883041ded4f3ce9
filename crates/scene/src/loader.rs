//! Figures, motions and parts of scenes that stand in files of their own.

use nalgebra::Vector3;
use solaris_model::{Actuator, Figure, Motion, Tie};

/// Fetches the figures, motions and parts of a scene that it names as files. This crate opens none itself.
pub trait Loader {
    /// The figure of a file, with the gravity that the file says; `path` is as it is written in the scene.
    ///
    /// # Errors
    ///
    /// Why there is none, in a sentence that follows the path.
    fn figure(&mut self, path: &str) -> Result<Figure, String>;

    /// The motors of a figure of a file, by the names that its degrees of freedom or joints have there.
    ///
    /// # Errors
    ///
    /// Why there are none, in a sentence that follows the path.
    fn actuators(&mut self, path: &str) -> Result<Vec<Actuator>, String> {
        let _ = path;
        Err("actuators in files are not read here".to_owned())
    }

    /// What a file holds together that the tree of its figure has open, by the names that its links have there.
    ///
    /// # Errors
    ///
    /// Why that is not known, in a sentence that follows the path.
    fn ties(&mut self, path: &str) -> Result<Vec<Tie>, String> {
        let _ = path;
        Err("loops in files are not read here".to_owned())
    }

    /// The motion of a figure, under a gravity (m/s²), in a file; velocities and accelerations may be unknown. Only the degrees of freedom
    /// `dofs` (indices in `v`) follow it: what it says of others is not used.
    ///
    /// # Errors
    ///
    /// Why there is none, in a sentence that follows the path.
    fn motion(
        &mut self,
        path: &str,
        figure: &Figure,
        gravity: &Vector3<f64>,
        dofs: &[usize],
    ) -> Result<Motion, String> {
        let _ = (path, figure, gravity, dofs);
        Err("motions in files are not read here".to_owned())
    }

    /// The text of a scene that another includes.
    ///
    /// # Errors
    ///
    /// Why there is none, in a sentence that follows the path.
    fn text(&mut self, path: &str) -> Result<String, String> {
        let _ = path;
        Err("scenes in files are not read here; write it into the scene".to_owned())
    }
}

/// For scenes that need no files.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFiles;

impl Loader for NoFiles {
    fn figure(&mut self, _path: &str) -> Result<Figure, String> {
        Err("files are not read here; write the figure into the scene".to_owned())
    }
}

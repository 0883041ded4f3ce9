//! Scenes, and the files that they name.

use crate::error::FileError;
use crate::files::Source;
use crate::{motion, read};
use solaris_io::{CoordinateDefault, IoError, record};
use solaris_model::text::first_word;
use solaris_model::{Actuator, Figure, Motion, Tie, Vector3};
use solaris_scene::{Loader, Scene};
use std::path::{Path, PathBuf};

/// A scene, and the files that it was read from.
#[derive(Debug)]
pub struct LoadedScene {
    /// The scene.
    pub scene: Scene,
    /// The files, its own first.
    pub reads: Vec<PathBuf>,
}

/// What a scene's file is, for people.
pub const SCENE: &str = "a scene is .ron: a figure, what drives it, and for how long";

impl<'f> Source<'f> {
    /// Reads a scene; its files are relative to it.
    ///
    /// # Errors
    ///
    /// Files that cannot be read, and every fault of the scene, with its place.
    pub fn scene(self, path: &Path) -> Result<LoadedScene, FileError> {
        read::refuse_unread(path, SCENE)?;
        self.refuse_others(path)?;
        self.scene_of(path, &self.text(path)?)
    }

    /// Reads a scene whose text is at hand, as if it stood at `path`.
    ///
    /// # Errors
    ///
    /// Every fault of the scene, with its place.
    pub fn scene_of(self, path: &Path, text: &str) -> Result<LoadedScene, FileError> {
        if let Some("Figure") = first_word(text) {
            return Err(figure_for_scene(path, "Solaris figure"));
        }
        let folder = path.parent().map(Path::to_owned).unwrap_or_default();
        let mut files = Named { source: self, folder, reads: vec![path.to_owned()] };
        let scene =
            solaris_scene::read(text, &mut files).map_err(|faults| FileError::faulty(path, text, faults))?;
        Ok(LoadedScene { scene, reads: files.reads })
    }

    /// What fetches the files that a scene in this folder names.
    pub fn loader(self, folder: &Path) -> impl Loader + use<'f> {
        Named { source: self, folder: folder.to_owned(), reads: Vec::new() }
    }

    /// Refuses a figure of another program, and a motion.
    fn refuse_others(self, path: &Path) -> Result<(), FileError> {
        if motion::is_motion(path) {
            let why = format!(
                "it is a motion, and it has run already: solaris convert, metrics, inverse and ground take motions; {SCENE}"
            );
            return Err(FileError::input(path, &why));
        }
        match self.language(path) {
            Some(language) => Err(figure_for_scene(path, language.name())),
            None => Ok(()),
        }
    }
}

/// [`Source::scene`] of the disk.
///
/// # Errors
///
/// As there.
pub fn scene(path: &Path) -> Result<LoadedScene, FileError> {
    Source::disk().scene(path)
}

/// A figure where a scene goes, and the least scene with it.
fn figure_for_scene(path: &Path, what: &str) -> FileError {
    let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let why = format!(
        "it is a figure ({what}); {SCENE}. `solaris check {}` tells what the figure is. Beside it, this scene lets it go for \
         two seconds:\n\nScene(version: 1, figures: {{\"it\": File(\"{name}\")}}, duration: 2.0)",
        path.display()
    );
    FileError::input(path, &why)
}

/// Files that a scene names, in its folder.
struct Named<'f> {
    source: Source<'f>,
    folder: PathBuf,
    reads: Vec<PathBuf>,
}

impl Loader for Named<'_> {
    fn figure(&mut self, name: &str) -> Result<Figure, String> {
        let path = self.folder.join(name);
        let body = self.source.body(&path).map_err(|error| error.in_short())?;
        self.reads.push(path);
        Ok(body.figure)
    }

    fn motion(
        &mut self,
        name: &str,
        figure: &Figure,
        gravity: &Vector3<f64>,
        dofs: &[usize],
    ) -> Result<Motion, String> {
        let path = self.folder.join(name);
        let (table, _) = self.source.motion(&path, figure).map_err(|error| error.in_short())?;
        let read = record::read_with_defaults(figure, *gravity, &table, &held(figure, dofs)?);
        let motion = read.map_err(|error| match error {
            IoError::MissingColumns { .. } => {
                format!("{error}; or name what it moves: `dofs: [\"right_*\"]`")
            }
            error => error.to_string(),
        });
        let motion = motion?.motion;
        self.reads.push(path);
        Ok(motion)
    }

    fn actuators(&mut self, name: &str) -> Result<Vec<Actuator>, String> {
        self.source.actuators(&self.folder.join(name)).map_err(|error| error.in_short())
    }

    fn ties(&mut self, name: &str) -> Result<Vec<Tie>, String> {
        self.source.ties(&self.folder.join(name)).map_err(|error| error.in_short())
    }

    fn text(&mut self, name: &str) -> Result<String, String> {
        let path = self.folder.join(name);
        let text = self.source.text(&path).map_err(|error| error.in_short())?;
        self.reads.push(path);
        Ok(text)
    }
}

/// The coordinates of all but these degrees of freedom, of which a motion need not tell anything.
fn held(figure: &Figure, dofs: &[usize]) -> Result<Vec<CoordinateDefault>, String> {
    let layout = figure.layout();
    let mut neutral = vec![0.0; layout.nq()];
    figure.neutral(&mut neutral).map_err(|error| error.to_string())?;
    let mut is_told = vec![false; layout.nq()];
    for coordinate in dofs.iter().filter_map(|dof| layout.coordinate(*dof)) {
        is_told[coordinate] = true;
    }
    let held = layout.q_names().iter().zip(neutral).zip(is_told).filter(|(_, is_told)| !is_told);
    let held = held.map(|((name, value), _)| CoordinateDefault {
        name: name.clone(),
        value,
        is_locked: true,
        is_clamped: false,
    });
    Ok(held.collect())
}

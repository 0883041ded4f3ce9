//! Scenes, and the files that they name.

use crate::error::FileError;
use crate::{figure, motion, read};
use solaris_io::record;
use solaris_model::text::first_word;
use solaris_model::{Actuator, Figure, Motion, Vector3};
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

/// Reads a scene; its files are relative to it.
///
/// # Errors
///
/// Files that cannot be read, and every fault of the scene, with its place.
pub fn scene(path: &Path) -> Result<LoadedScene, FileError> {
    read::refuse_unread(path, SCENE)?;
    refuse_others(path)?;
    let text = read::text(path)?;
    if let Some("Figure") = first_word(&text) {
        return Err(figure_for_scene(path, "Solaris figure"));
    }
    let folder = path.parent().map(Path::to_owned).unwrap_or_default();
    let mut files = Files { folder, reads: vec![path.to_owned()] };
    let scene =
        solaris_scene::read(&text, &mut files).map_err(|faults| FileError::faulty(path, &text, faults))?;
    Ok(LoadedScene { scene, reads: files.reads })
}

/// Refuses a figure of another program, and a motion.
fn refuse_others(path: &Path) -> Result<(), FileError> {
    if motion::is_motion(path) {
        let why = format!(
            "it is a motion, and it has run already: solaris convert, metrics, inverse and ground take motions; {SCENE}"
        );
        return Err(FileError::input(path, &why));
    }
    match figure::language(path) {
        Some(language) => Err(figure_for_scene(path, language.name())),
        None => Ok(()),
    }
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

/// Files in the folder of a scene.
struct Files {
    folder: PathBuf,
    reads: Vec<PathBuf>,
}

impl Loader for Files {
    fn figure(&mut self, name: &str) -> Result<Figure, String> {
        let path = self.folder.join(name);
        let body = figure::body(&path).map_err(|error| error.in_short())?;
        self.reads.push(path);
        Ok(body.figure)
    }

    fn motion(&mut self, name: &str, figure: &Figure, gravity: &Vector3<f64>) -> Result<Motion, String> {
        let path = self.folder.join(name);
        let (table, _) = motion::motion(&path, figure).map_err(|error| error.in_short())?;
        let motion = record::read(figure, *gravity, &table).map_err(|error| error.to_string())?.motion;
        self.reads.push(path);
        Ok(motion)
    }

    fn actuators(&mut self, name: &str) -> Result<Vec<Actuator>, String> {
        figure::actuators(&self.folder.join(name)).map_err(|error| error.in_short())
    }

    fn text(&mut self, name: &str) -> Result<String, String> {
        let path = self.folder.join(name);
        let text = read::text(&path).map_err(|error| error.in_short())?;
        self.reads.push(path);
        Ok(text)
    }
}

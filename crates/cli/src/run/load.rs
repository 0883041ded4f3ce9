//! A scene, and the figures beside it.

use crate::error::CliError;
use crate::input;
use solaris::io::record;
use solaris::model::text::first_word;
use solaris::model::{Actuator, Figure, Motion, TextError, Tie, Vector3};
use solaris::scene::{Loader, Scene, read};
use std::path::{Path, PathBuf};

/// A scene, and the files that it was read from.
pub(crate) struct Loaded {
    pub(crate) scene: Scene,
    pub(crate) reads: Vec<PathBuf>,
}

/// Reads a scene; its files are relative to it.
pub(crate) fn load(path: &Path) -> Result<Loaded, CliError> {
    input::refuse_unread(path, SCENE)?;
    refuse_others(path)?;
    let text = input::text(path)?;
    if let Some("Figure") = first_word(&text) {
        return Err(figure_for_scene(path, "Solaris figure"));
    }
    let folder = path.parent().map(Path::to_owned).unwrap_or_default();
    let mut files = Files { folder, reads: vec![path.to_owned()] };
    let scene = read(&text, &mut files).map_err(|faults| input::faulty(path, &text, faults))?;
    Ok(Loaded { scene, reads: files.reads })
}

const SCENE: &str = "a scene is .ron: a figure, what drives it, and for how long";

/// Refuses a figure of another program, and a motion.
fn refuse_others(path: &Path) -> Result<(), CliError> {
    if input::is_motion(path) {
        let why = format!(
            "it is a motion, and it has run already: solaris convert, metrics, inverse and ground take motions; {SCENE}"
        );
        return Err(CliError::input(path, &why));
    }
    match input::foreign(path) {
        Some(language) => Err(figure_for_scene(path, language.name())),
        None => Ok(()),
    }
}

/// A figure where a scene goes, and the least scene with it.
fn figure_for_scene(path: &Path, what: &str) -> CliError {
    let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let why = format!(
        "it is a figure ({what}); {SCENE}. `solaris check {}` tells what the figure is. Beside it, this scene lets it go for \
         two seconds:\n\nScene(version: 1, figures: {{\"it\": File(\"{name}\")}}, duration: 2.0)",
        path.display()
    );
    CliError::input(path, &why)
}

/// Files in the folder of a scene.
struct Files {
    folder: PathBuf,
    reads: Vec<PathBuf>,
}

impl Loader for Files {
    fn figure(&mut self, name: &str) -> Result<Figure, String> {
        let path = self.folder.join(name);
        let body = input::body(&path).map_err(|error| why(&error))?;
        self.reads.push(path);
        Ok(body.figure)
    }

    fn motion(&mut self, name: &str, figure: &Figure, gravity: &Vector3<f64>) -> Result<Motion, String> {
        let path = self.folder.join(name);
        let (table, _) = input::motion(&path, figure).map_err(|error| why(&error))?;
        let motion = record::read(figure, *gravity, &table).map_err(|error| error.to_string())?.motion;
        self.reads.push(path);
        Ok(motion)
    }

    fn actuators(&mut self, name: &str) -> Result<Vec<Actuator>, String> {
        input::actuators(&self.folder.join(name)).map_err(|error| why(&error))
    }

    fn ties(&mut self, name: &str) -> Result<Vec<Tie>, String> {
        input::ties(&self.folder.join(name)).map_err(|error| why(&error))
    }

    fn text(&mut self, name: &str) -> Result<String, String> {
        let path = self.folder.join(name);
        let text = input::text(&path).map_err(|error| why(&error))?;
        self.reads.push(path);
        Ok(text)
    }
}

/// Why a file has no figure, without its path.
fn why(error: &CliError) -> String {
    match error {
        CliError::Input { why, .. } => why.clone(),
        CliError::Text { faults, .. } => first_of(faults, 0),
        CliError::Files { error, .. } => {
            let others = error.files.iter().skip(1).map(|file| file.error.faults.len() + file.error.omitted);
            error.files.first().map_or_else(String::new, |file| first_of(&file.error, others.sum()))
        }
        other => other.to_string(),
    }
}

/// The first fault of a text, and how many there are with `others`.
fn first_of(faults: &TextError, others: usize) -> String {
    let count = faults.faults.len() + faults.omitted + others;
    let first = faults.faults.first().map(|fault| format!("{}: {}", fault.place, fault.message));
    let first = first.unwrap_or_default();
    if count == 1 {
        first
    } else {
        format!("{count} faults, which 'solaris check' shows; the first: {first}")
    }
}

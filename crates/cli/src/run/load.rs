//! A scene, and the figures beside it.

use crate::error::CliError;
use crate::input;
use solaris::model::Figure;
use solaris::scene::{Loader, Scene, read};
use std::path::{Path, PathBuf};

/// A scene, and the files that it was read from.
pub(crate) struct Loaded {
    pub(crate) scene: Scene,
    pub(crate) reads: Vec<PathBuf>,
}

/// Reads a scene; its files are relative to it.
pub(crate) fn load(path: &Path) -> Result<Loaded, CliError> {
    let text = input::text(path)?;
    let folder = path.parent().map(Path::to_owned).unwrap_or_default();
    let mut files = Files { folder, reads: vec![path.to_owned()] };
    let scene = read(&text, &mut files).map_err(|faults| input::faulty(path, &text, faults))?;
    Ok(Loaded { scene, reads: files.reads })
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
}

/// Why a file has no figure, without its path.
fn why(error: &CliError) -> String {
    match error {
        CliError::Input { why, .. } => why.clone(),
        CliError::Text { faults, .. } => {
            let count = faults.faults.len() + faults.omitted;
            let first = faults.faults.first().map(|fault| format!("{}: {}", fault.place, fault.message));
            let first = first.unwrap_or_default();
            if count == 1 {
                first
            } else {
                format!("{count} faults, which 'solaris check' shows; the first: {first}")
            }
        }
        other => other.to_string(),
    }
}

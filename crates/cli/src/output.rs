//! Output files: all of them are written beside their places and then renamed, or none is left.

use crate::error::CliError;
use std::fs::{self, OpenOptions};
use std::io::{BufWriter, Write};
use std::path::{Path, PathBuf};

/// What a file holds, by its extension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Format {
    Html,
    Csv,
    Bvh,
    Json,
}

/// Formats of a motion, by extension.
const MOTION_FORMATS: [(&str, Format); 3] =
    [("html", Format::Html), ("csv", Format::Csv), ("bvh", Format::Bvh)];

/// One file to write.
#[derive(Debug)]
struct Output {
    option: &'static str,
    path: PathBuf,
    format: Format,
}

/// The files that a command is to write, checked before the work begins.
#[derive(Debug)]
pub(crate) struct Outputs(Vec<Output>);

impl Outputs {
    /// Motions at `paths` and a report at `report`.
    pub(crate) fn new<'a>(
        paths: impl Iterator<Item = &'a PathBuf>,
        report: Option<&PathBuf>,
    ) -> Result<Self, CliError> {
        let mut outputs: Vec<Output> = Vec::new();
        for path in paths {
            let format = motion_format(path)
                .ok_or_else(|| refuse("-o", path, "its extension must be .html, .csv or .bvh".to_owned()))?;
            outputs.push(Output { option: "-o", path: path.clone(), format });
        }
        if let Some(path) = report {
            if !extension(path).is_some_and(|extension| extension == "json") {
                return Err(refuse("--report", path, "its extension must be .json".to_owned()));
            }
            outputs.push(Output { option: "--report", path: path.clone(), format: Format::Json });
        }
        let mut places: Vec<PathBuf> = Vec::new();
        for output in &outputs {
            let place = place(output)?;
            if places.contains(&place) {
                let why = "two outputs have this name; give each its own".to_owned();
                return Err(refuse(output.option, &output.path, why));
            }
            places.push(place);
        }
        Ok(Self(outputs))
    }

    /// The paths, in order.
    pub(crate) fn paths(&self) -> impl Iterator<Item = &Path> {
        self.0.iter().map(|output| output.path.as_path())
    }

    /// Writes all files by `write`, or leaves none and what was there before.
    pub(crate) fn write(
        &self,
        mut write: impl FnMut(Format, &mut dyn Write) -> Result<(), CliError>,
    ) -> Result<(), CliError> {
        let mut parts: Vec<Part> = Vec::new();
        for output in &self.0 {
            let part = Part::create(output)?;
            part.fill(output, |writer| write(output.format, writer))?;
            parts.push(part);
        }
        for i in 0..parts.len() {
            if let Err(error) = parts[i].install() {
                parts[..i].iter().for_each(Part::withdraw);
                return Err(refuse(self.0[i].option, &self.0[i].path, error.to_string()));
            }
        }
        parts.iter_mut().for_each(Part::keep);
        Ok(())
    }
}

fn extension(path: &Path) -> Option<String> {
    path.extension().map(|extension| extension.to_string_lossy().to_lowercase())
}

fn motion_format(path: &Path) -> Option<Format> {
    let extension = extension(path)?;
    MOTION_FORMATS.iter().find(|(known, _)| *known == extension).map(|(_, format)| *format)
}

fn refuse(option: &'static str, path: &Path, why: String) -> CliError {
    CliError::Output { option, path: path.to_owned(), why }
}

/// The folder that a file is to stand in.
fn folder(path: &Path) -> &Path {
    path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or_else(|| Path::new("."))
}

/// Where a file will stand, without links and dots on the way.
fn place(output: &Output) -> Result<PathBuf, CliError> {
    let folder = folder(&output.path);
    let refuse = |why: String| refuse(output.option, &output.path, why);
    let name = output.path.file_name().ok_or_else(|| refuse("it names no file".to_owned()))?;
    match fs::metadata(folder) {
        Ok(found) if !found.is_dir() => {
            Err(refuse(format!("'{}' is a file, not a folder", folder.display())))
        }
        Ok(_) if output.path.is_dir() => Err(refuse("it is a folder; name a file".to_owned())),
        Ok(_) => fs::canonicalize(folder).map(|folder| folder.join(name)).map_err(|e| refuse(e.to_string())),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
            Err(refuse(format!("there is no folder '{}'; make it first", folder.display())))
        }
        Err(error) if error.kind() == std::io::ErrorKind::NotADirectory => {
            Err(refuse(format!("a part of '{}' is a file, not a folder", folder.display())))
        }
        Err(error) => Err(refuse(error.to_string())),
    }
}

/// A file under construction; whatever of it is left is removed when it is dropped before it is kept.
struct Part {
    part: PathBuf,
    target: PathBuf,
    /// What stood in the target's place, while the whole may still fail.
    before: Option<PathBuf>,
    kept: bool,
}

impl Part {
    fn create(output: &Output) -> Result<Self, CliError> {
        let name = output.path.file_name().unwrap_or_default().to_string_lossy();
        let beside =
            |suffix: &str| folder(&output.path).join(format!(".{name}.{}.{suffix}", std::process::id()));
        let before = output.path.exists().then(|| beside("before"));
        let part = Self { part: beside("part"), target: output.path.clone(), before, kept: false };
        match OpenOptions::new().write(true).create_new(true).open(&part.part) {
            Ok(_) => Ok(part),
            Err(error) => Err(refuse(output.option, &output.path, error.to_string())),
        }
    }

    fn fill(
        &self,
        output: &Output,
        write: impl FnOnce(&mut dyn Write) -> Result<(), CliError>,
    ) -> Result<(), CliError> {
        let refuse = |error: std::io::Error| refuse(output.option, &output.path, error.to_string());
        let file = OpenOptions::new().write(true).open(&self.part).map_err(refuse)?;
        let mut writer = BufWriter::new(file);
        write(&mut writer)?;
        let file = writer.into_inner().map_err(|error| refuse(error.into_error()))?;
        file.sync_all().map_err(refuse)
    }

    /// Puts the file in its place, what was there beside it.
    fn install(&self) -> std::io::Result<()> {
        if let Some(before) = &self.before {
            fs::rename(&self.target, before)?;
        }
        fs::rename(&self.part, &self.target).inspect_err(|_| self.restore())
    }

    /// Takes the file from its place again.
    fn withdraw(&self) {
        // The error that led here is told; one more says nothing new.
        let _ = fs::remove_file(&self.target);
        self.restore();
    }

    fn restore(&self) {
        if let Some(before) = &self.before {
            let _ = fs::rename(before, &self.target);
        }
    }

    fn keep(&mut self) {
        if let Some(before) = &self.before {
            let _ = fs::remove_file(before);
        }
        self.kept = true;
    }
}

impl Drop for Part {
    fn drop(&mut self) {
        if !self.kept {
            let _ = fs::remove_file(&self.part);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(folder)
            .expect("a folder")
            .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }

    fn outputs(folder: &Path, files: &[&str]) -> Outputs {
        let paths: Vec<PathBuf> = files.iter().map(|file| folder.join(file)).collect();
        Outputs::new(paths.iter(), None).expect("good outputs")
    }

    #[test]
    fn a_writer_that_fails_leaves_what_was_there() {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("a.csv"), "old").expect("written");
        let error = outputs(folder.path(), &["a.csv", "b.html"])
            .write(|format, writer| match format {
                Format::Csv => writer.write_all(b"new").map_err(CliError::Stdout),
                _ => Err(CliError::other(std::io::Error::other("no space left on device"))),
            })
            .expect_err("the second fails");
        assert!(error.to_string().contains("no space left"), "{error}");
        assert_eq!(names(folder.path()), ["a.csv"]);
        assert_eq!(fs::read_to_string(folder.path().join("a.csv")).expect("there"), "old");
    }

    #[test]
    fn a_place_that_is_taken_on_the_way_takes_all_back() {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("a.csv"), "old").expect("written");
        let outputs = outputs(folder.path(), &["a.csv", "b.bvh"]);
        let blocked = folder.path().join("b.bvh");
        let error = outputs
            .write(|format, writer| {
                if format == Format::Bvh {
                    fs::create_dir(&blocked).expect("made");
                    fs::write(blocked.join("x"), "").expect("written");
                }
                writer.write_all(b"new").map_err(CliError::Stdout)
            })
            .expect_err("a folder cannot be replaced");
        assert!(error.to_string().contains("b.bvh"), "{error}");
        assert_eq!(names(folder.path()), ["a.csv", "b.bvh"]);
        assert_eq!(fs::read_to_string(folder.path().join("a.csv")).expect("there"), "old");
    }

    #[test]
    fn all_are_written_and_nothing_else_stays() {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("a.csv"), "old").expect("written");
        let outputs = outputs(folder.path(), &["a.csv", "b.bvh"]);
        outputs.write(|_, writer| writer.write_all(b"new").map_err(CliError::Stdout)).expect("written");
        assert_eq!(names(folder.path()), ["a.csv", "b.bvh"]);
        assert_eq!(fs::read_to_string(folder.path().join("a.csv")).expect("there"), "new");
    }
}

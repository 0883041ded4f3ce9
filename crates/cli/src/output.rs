//! Output files: all of them are written beside their places and then renamed, or none is left.

mod part;

use crate::error::CliError;
use crate::input::extension;
use part::Part;
use std::fs;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

/// What a file may hold, by its extension.
pub(crate) type Formats<F> = &'static [(&'static str, F)];

/// One file to write.
#[derive(Debug)]
struct Output<F> {
    option: &'static str,
    path: PathBuf,
    format: F,
    /// Where the file will stand, links followed.
    place: PathBuf,
    /// Whether there is a file already, which it replaces.
    replaces: bool,
}

impl<F> Output<F> {
    fn refuse(&self, why: &dyn ToString) -> CliError {
        refuse(self.option, &self.path, why.to_string())
    }
}

/// The files that a command is to write, checked before the work begins.
#[derive(Debug)]
pub(crate) struct Outputs<F>(Vec<Output<F>>);

impl<F: Copy + 'static> Outputs<F> {
    /// Files of these options at these paths, each with the formats that it may have.
    pub(crate) fn new<'a>(
        files: impl IntoIterator<Item = (&'static str, &'a PathBuf, Formats<F>)>,
    ) -> Result<Self, CliError> {
        let mut outputs: Vec<Output<F>> = Vec::new();
        for (option, path, formats) in files {
            let refuse = |why: String| refuse(option, path, why);
            let place = place(path).map_err(refuse)?;
            let extension = extension(path);
            let format = formats.iter().find(|(known, _)| *known == extension).map(|(_, format)| *format);
            let format =
                format.ok_or_else(|| refuse(format!("its extension must be {}", listed(formats))))?;
            if let Some(other) = outputs.iter().find(|output| output.place == place) {
                let (option, path) = (other.option, other.path.display());
                return Err(refuse(format!("{option} {path} is the same file; give each its own")));
            }
            let replaces = place.exists();
            outputs.push(Output { option, path: path.clone(), format, place, replaces });
        }
        Ok(Self(outputs))
    }

    /// Refuses to write over what is read.
    pub(crate) fn keep_off<'a>(&self, inputs: impl IntoIterator<Item = &'a Path>) -> Result<(), CliError> {
        for input in inputs {
            let place = fs::canonicalize(input).ok();
            if let Some(output) = self.0.iter().find(|output| Some(&output.place) == place.as_ref()) {
                return Err(output.refuse(&"it is what is read here; name another file"));
            }
        }
        Ok(())
    }

    /// The paths, in order.
    pub(crate) fn paths(&self) -> impl Iterator<Item = &Path> {
        self.0.iter().map(|output| output.path.as_path())
    }

    /// A line for each file that was written, in order; what was replaced is said.
    pub(crate) fn written(&self) -> impl Iterator<Item = String> {
        self.0.iter().map(|output| {
            let replaces = if output.replaces { ", in place of the file that was there" } else { "" };
            format!("wrote {}{replaces}", output.path.display())
        })
    }

    /// Refuses what cannot be written in a format, as `check` finds.
    pub(crate) fn try_out(&self, check: impl Fn(F) -> Result<(), CliError>) -> Result<(), CliError> {
        self.0.iter().try_for_each(|output| check(output.format).map_err(|error| output.refuse(&error)))
    }

    /// Writes all files by `write`, or leaves none and what was there before.
    pub(crate) fn write(
        &self,
        mut write: impl FnMut(F, &mut dyn Write) -> Result<(), CliError>,
    ) -> Result<(), CliError> {
        let mut parts: Vec<Part> = Vec::new();
        for output in &self.0 {
            let part = Part::create(&output.place).map_err(|error| output.refuse(&error))?;
            part.fill(|writer| write(output.format, writer)).map_err(|error| output.refuse(&error))?;
            parts.push(part);
        }
        for i in 0..parts.len() {
            if let Err(error) = parts[i].install() {
                parts[..i].iter().for_each(Part::withdraw);
                return Err(self.0[i].refuse(&error));
            }
        }
        parts.iter_mut().for_each(Part::keep);
        Ok(())
    }
}

/// Whether a path is meant as a folder: it is one, or it ends like one.
pub(crate) fn is_folder(path: &Path) -> bool {
    path.is_dir() || path.as_os_str().to_string_lossy().ends_with(std::path::is_separator)
}

/// Makes a folder where there is none.
pub(crate) fn make_folder(option: &'static str, path: &Path) -> Result<(), CliError> {
    if path.is_dir() {
        return Ok(());
    }
    fs::create_dir(path).map_err(|error| match error.kind() {
        ErrorKind::NotFound => {
            refuse(option, path, "the folder that it is to be in is not there; make it first".into())
        }
        ErrorKind::AlreadyExists => refuse(option, path, "it is a file, and a folder is needed".into()),
        _ => refuse(option, path, error.to_string()),
    })
}

/// Extensions as people list them.
fn listed<F>(formats: &[(&str, F)]) -> String {
    let names: Vec<String> = formats.iter().map(|(extension, _)| format!(".{extension}")).collect();
    match names.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, others)) => format!("{} or {last}", others.join(", ")),
        None => String::new(),
    }
}

fn refuse(option: &'static str, path: &Path, why: String) -> CliError {
    CliError::Output { option, path: path.to_owned(), why }
}

/// The folder that a file is to stand in.
fn folder(path: &Path) -> &Path {
    path.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or_else(|| Path::new("."))
}

/// Where a file will stand, without links and dots on the way, or why it cannot.
fn place(path: &Path) -> Result<PathBuf, String> {
    let folder = folder(path);
    let is_folder = "it is a folder; name a file";
    if path.as_os_str().to_string_lossy().ends_with(std::path::is_separator) {
        return Err(is_folder.to_owned());
    }
    let name = path.file_name().ok_or("it names no file")?;
    let shown = folder.display();
    match fs::metadata(folder) {
        Ok(found) if found.is_dir() => {}
        Ok(_) => return Err(format!("'{shown}' is a file, not a folder")),
        Err(error) => {
            return Err(match error.kind() {
                ErrorKind::NotFound => format!("there is no folder '{shown}'; make it first"),
                ErrorKind::NotADirectory => format!("a part of '{shown}' is a file, not a folder"),
                _ => error.to_string(),
            });
        }
    }
    match fs::metadata(path) {
        Ok(found) if found.is_dir() => Err(is_folder.to_owned()),
        Ok(found) if !found.is_file() => Err("it is there and no ordinary file".to_owned()),
        Ok(found) if found.permissions().readonly() => {
            Err("it is there and must not be written; make it writable or name another".to_owned())
        }
        // A link is followed: what it points at is replaced, not the link.
        Ok(_) => fs::canonicalize(path).map_err(|error| error.to_string()),
        Err(error) if error.kind() != ErrorKind::NotFound => Err(error.to_string()),
        Err(_) if fs::symlink_metadata(path).is_ok() => Err("it is a link to nothing; remove it".to_owned()),
        Err(_) => fs::canonicalize(folder).map(|folder| folder.join(name)).map_err(|e| e.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[derive(Clone, Copy, Debug, PartialEq)]
    enum Format {
        Csv,
        Html,
        Bvh,
    }

    const FORMATS: Formats<Format> = &[("csv", Format::Csv), ("html", Format::Html), ("bvh", Format::Bvh)];

    fn names(folder: &Path) -> Vec<String> {
        let mut names: Vec<String> = fs::read_dir(folder)
            .expect("a folder")
            .map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        names
    }

    fn outputs(folder: &Path, files: &[&str]) -> Outputs<Format> {
        let paths: Vec<PathBuf> = files.iter().map(|file| folder.join(file)).collect();
        Outputs::new(paths.iter().map(|path| ("-o", path, FORMATS))).expect("good outputs")
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
        let told: Vec<bool> = outputs.written().map(|line| line.ends_with("that was there")).collect();
        assert_eq!(told, [true, false]);
    }

    #[test]
    fn what_a_killed_run_left_is_no_obstacle() {
        let folder = tempfile::tempdir().expect("a folder");
        // Process numbers come again, in containers at once.
        let left = format!(".solaris-{}-0.part", std::process::id());
        fs::write(folder.path().join(&left), "half").expect("written");
        let outputs = outputs(folder.path(), &["a.csv", "b.bvh"]);
        outputs.write(|_, writer| writer.write_all(b"new").map_err(CliError::Stdout)).expect("written");
        assert_eq!(names(folder.path()), [left.as_str(), "a.csv", "b.bvh"]);
    }

    #[test]
    fn an_error_while_writing_names_the_file() {
        let folder = tempfile::tempdir().expect("a folder");
        let fails = |_: Format, _: &mut dyn Write| Err(CliError::other(std::io::Error::other("it broke")));
        let error = outputs(folder.path(), &["a.csv"]).write(fails).expect_err("it fails");
        let path = folder.path().join("a.csv");
        assert_eq!(error.to_string(), format!("-o {}: it broke", path.display()));
        assert!(names(folder.path()).is_empty());
    }
}

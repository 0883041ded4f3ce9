//! Why a file cannot be used.

use solaris_io::FilesError;
use solaris_model::TextError;
use std::path::{Path, PathBuf};

/// Why a file cannot be used.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FileError {
    /// It cannot be read, or does not hold what is needed.
    #[error("{path}: {why}", path = .path.display())]
    Input {
        /// The file.
        path: PathBuf,
        /// What is wrong with it, and what to do.
        why: String,
    },
    /// A text with faults that have places.
    #[error("{path} cannot be used\n{faults}", path = .path.display())]
    Text {
        /// The file.
        path: PathBuf,
        /// What it holds.
        text: String,
        /// Its faults.
        faults: TextError,
    },
    /// A folder that is said to hold a model's files, and does not.
    #[error("{folder}: {why}", folder = .folder.display())]
    Folder {
        /// The folder.
        folder: PathBuf,
        /// What is wrong with it.
        why: String,
    },
    /// A model with faults in its file, or in others that it names.
    #[error("{path} cannot be used\n{error}", path = .path.display())]
    Files {
        /// The model's file.
        path: PathBuf,
        /// The faults, file by file.
        error: FilesError,
    },
}

impl FileError {
    /// A file that is at fault.
    pub fn input(path: &Path, why: &dyn ToString) -> Self {
        Self::Input { path: path.to_owned(), why: why.to_string() }
    }

    /// A text with faults.
    pub fn faulty(path: &Path, text: &str, faults: TextError) -> Self {
        Self::Text { path: path.to_owned(), text: text.to_owned(), faults }
    }

    /// Why, in one line and without the path: of faults the first, and how many there are.
    pub fn in_short(&self) -> String {
        match self {
            Self::Input { why, .. } | Self::Folder { why, .. } => why.clone(),
            Self::Text { faults, .. } => first_of(faults, 0),
            Self::Files { error, .. } => {
                let others =
                    error.files.iter().skip(1).map(|file| file.error.faults.len() + file.error.omitted);
                error.files.first().map_or_else(String::new, |file| first_of(&file.error, others.sum()))
            }
        }
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

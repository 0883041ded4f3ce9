//! Files that are names and bytes: what is dropped on a page, or comes out of an archive.

use crate::error::FileError;
use crate::files::Files;
use crate::read::MOST_BYTES;
use solaris_io::Loader;
use std::cell::RefCell;
use std::cmp::Reverse;
use std::path::{Path, PathBuf};

/// Files by name, each with its bytes, and which of them anybody asked for.
///
/// A name is a file's way from whatever folder was dropped with it, or its last part alone: who drops files has lost where they lay.
/// So of all files the one is meant whose name agrees with most of the last parts of a path, upper and lower case being the same; what
/// agrees in case, and then what has fewer parts, comes first.
///
/// ```
/// use solaris_files::{Files, Given};
/// use std::path::Path;
///
/// let files = Given::new([("robot/Arm.STL", &b"solid arm"[..]), ("leg.stl", b"solid leg")]);
/// assert!(files.exists(Path::new("package/meshes/arm.stl")));
/// assert!(!files.exists(Path::new("robot/head.stl")));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Given {
    files: Vec<GivenFile>,
    /// Indices of those that were read.
    read: RefCell<Vec<usize>>,
}

/// A file that was given.
#[derive(Clone, Debug)]
struct GivenFile {
    name: String,
    bytes: Vec<u8>,
}

impl Given {
    /// Of names and bytes.
    pub fn new<N: Into<String>, B: Into<Vec<u8>>>(files: impl IntoIterator<Item = (N, B)>) -> Self {
        let mut given = Self::default();
        files.into_iter().for_each(|(name, bytes)| given.add(name, bytes));
        given
    }

    /// One file more; it takes the place of one of the same name.
    pub fn add(&mut self, name: impl Into<String>, bytes: impl Into<Vec<u8>>) {
        let file = GivenFile { name: name.into(), bytes: bytes.into() };
        match self.files.iter_mut().find(|known| known.name == file.name) {
            Some(known) => *known = file,
            None => self.files.push(file),
        }
    }

    /// The names, in the order in which they were given.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.files.iter().map(|file| file.name.as_str())
    }

    /// The name of the file that is meant by a path.
    pub fn find(&self, path: &Path) -> Option<&str> {
        self.at(path).map(|at| self.files[at].name.as_str())
    }

    /// Whether the file of this name was asked for since [`Given::forget`].
    pub(crate) fn was_read(&self, name: &str) -> bool {
        self.read.borrow().iter().any(|at| self.files[*at].name == name)
    }

    /// The names of files that were asked for.
    pub(crate) fn forget(&self) {
        self.read.borrow_mut().clear();
    }

    /// The file that is meant by a path.
    fn at(&self, path: &Path) -> Option<usize> {
        let wanted = parts(&path.to_string_lossy());
        let agree = |(at, file): (usize, &GivenFile)| {
            let own = parts(&file.name);
            let pairs = || own.iter().rev().zip(wanted.iter().rev());
            let folded = pairs().take_while(|(a, b)| a.to_lowercase() == b.to_lowercase()).count();
            let exact = pairs().take_while(|(a, b)| a == b).count();
            (folded > 0).then_some(((folded, exact, Reverse(own.len()), Reverse(at)), at))
        };
        self.files.iter().enumerate().filter_map(agree).max_by_key(|(rank, _)| *rank).map(|(_, at)| at)
    }

    fn load(&self, path: &Path) -> Result<Vec<u8>, String> {
        let Some(at) = self.at(path) else {
            return Err("there is no such file among those that are given; give it too".to_owned());
        };
        let mut read = self.read.borrow_mut();
        if !read.contains(&at) {
            read.push(at);
        }
        let bytes = &self.files[at].bytes;
        if bytes.len() as u64 > MOST_BYTES {
            return Err(format!("it has more than {MOST_BYTES} bytes, the most that is read"));
        }
        Ok(bytes.clone())
    }
}

/// The parts of a path, without `.`, and each `..` with what stands before it.
fn parts(path: &str) -> Vec<String> {
    let mut parts: Vec<String> = Vec::new();
    for part in path.split(['/', '\\']) {
        match part {
            "" | "." => {}
            ".." => drop(parts.pop()),
            part => parts.push(part.to_owned()),
        }
    }
    parts
}

impl Files for Given {
    fn bytes(&self, path: &Path) -> Result<Vec<u8>, FileError> {
        self.load(path).map_err(|why| FileError::input(path, &why))
    }

    fn exists(&self, path: &Path) -> bool {
        self.at(path).is_some()
    }

    fn beside<'f>(&'f self, model: &Path, _files: Option<&Path>) -> Result<Box<dyn Loader + 'f>, FileError> {
        // The model as it was given says more than a path to it.
        let model = self.find(model).map_or_else(|| model.to_owned(), PathBuf::from);
        let folder = parts(&model.parent().map(Path::to_string_lossy).unwrap_or_default()).join("/");
        Ok(Box::new(Beside { given: self, folder }))
    }
}

/// What a model names, among files that are given.
struct Beside<'f> {
    given: &'f Given,
    folder: String,
}

impl Loader for Beside<'_> {
    fn folder(&self) -> String {
        self.folder.clone()
    }

    fn load(&mut self, path: &str) -> Result<Vec<u8>, String> {
        self.given.load(Path::new(path))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_means_the_file_that_agrees_with_most_of_its_end() {
        let files = Given::new([
            ("a/mesh.stl", &b"a"[..]),
            ("b/mesh.stl", b"b"),
            ("MESH.STL", b"upper"),
            ("leg.obj", b"leg"),
        ]);
        let found = |path: &str| files.find(Path::new(path)).map(str::to_owned);
        assert_eq!(found("b/mesh.stl").as_deref(), Some("b/mesh.stl"));
        assert_eq!(found("x\\B\\mesh.stl").as_deref(), Some("b/mesh.stl"));
        // The same parts agree with all three: case decides, then order.
        assert_eq!(found("c/mesh.stl").as_deref(), Some("a/mesh.stl"));
        assert_eq!(found("c/MESH.STL").as_deref(), Some("MESH.STL"));
        assert_eq!(found("./x/../Leg.obj").as_deref(), Some("leg.obj"));
        assert_eq!(found("g.obj"), None);
    }

    #[test]
    fn it_is_known_which_files_were_read() {
        let mut files = Given::new([("a.txt", &b"a"[..]), ("b.txt", b"b")]);
        files.add("b.txt", *b"c");
        assert_eq!(files.names().count(), 2);
        assert_eq!(files.bytes(Path::new("in/b.txt")).ok().as_deref(), Some(&b"c"[..]));
        assert!(files.was_read("b.txt") && !files.was_read("a.txt"));
        files.forget();
        assert!(!files.was_read("b.txt"));
        let why = files.bytes(Path::new("c.txt")).expect_err("not given").to_string();
        assert_eq!(why, "c.txt: there is no such file among those that are given; give it too");
    }
}

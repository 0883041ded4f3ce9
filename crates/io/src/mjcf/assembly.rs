//! The text of a model that stands in several files.
//!
//! `<include file="…"/>` is replaced by what the root of that file holds, and `<model file="…"/>` of `<asset>` gets the root
//! of its file as its content, so that the rest of the reader sees one text. What is said of it is put back to the files.

use crate::loader::{FileError, FilesError, Loader, folder_of, within};
use crate::xml::{self, Node, tag, value_span};
use solaris_model::{Finding, Place, TextError};
use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::ops::Range;
use std::rc::Rc;

/// The most bytes of the text that files make together.
const MOST_BYTES: usize = 1 << 27;
/// How often files are named.
const MOST_NAMED: usize = 10_000;
/// How deep files may name each other.
const DEEPEST: usize = 100;

/// One text, and where it comes from.
pub(super) struct Assembly<'t> {
    pub(super) text: Cow<'t, str>,
    files: Vec<File>,
    /// In the order of the text; none where it is one file's.
    pieces: Vec<Piece>,
    /// The folder of the model's own file.
    folder: String,
}

/// A file that was read; the first is the model's own.
struct File {
    path: String,
    text: Rc<str>,
}

/// The bytes of the text from `at` on are those of a file from `from` on.
struct Piece {
    at: usize,
    file: usize,
    from: usize,
}

impl<'t> Assembly<'t> {
    /// Of the model's own text.
    pub(super) fn of(text: &'t str, loader: &mut dyn Loader) -> Result<Self, FilesError> {
        let named = text.contains("<include") || text.contains("<model");
        let folder = loader.folder();
        let own = |text: &'t str| Self {
            text: Cow::Borrowed(text),
            files: Vec::new(),
            pieces: Vec::new(),
            folder: folder.clone(),
        };
        if !named {
            return Ok(own(text));
        }
        let mut assembler = Assembler::new(text, loader);
        if let Ok(document) = xml::parse(text, usize::MAX) {
            let mut scope = Scope { folder: folder.clone(), included: HashSet::new() };
            assembler.write(0, document.root_element(), 0..text.len(), &mut scope, 0);
        } else {
            // The reader will say what is wrong.
            return Ok(own(text));
        }
        let Assembler { out, files, pieces, faults, .. } = assembler;
        let assembly = Self { text: Cow::Owned(out), files, pieces, folder };
        if faults.is_empty() { Ok(assembly) } else { Err(assembly.by_files(faults, 0)) }
    }

    /// The folder of the file that a place is in, from that of all files.
    pub(super) fn folder(&self, at: usize) -> &str {
        match self.files.get(self.locate(at).0) {
            Some(file) if !file.path.is_empty() => folder_of(&file.path),
            _ => &self.folder,
        }
    }

    /// What the faults of the text are in its files.
    pub(super) fn error(&self, error: TextError) -> FilesError {
        let TextError { faults, omitted } = error;
        let faults = faults.into_iter().map(|fault| {
            let (file, span) = self.span(&fault.place.span);
            (file, span, fault.message)
        });
        self.by_files(faults.collect(), omitted)
    }

    /// Puts findings about the text to its files.
    pub(super) fn place(&self, findings: &mut [Finding]) {
        if self.pieces.is_empty() {
            return;
        }
        let mut lines: HashMap<usize, Vec<usize>> = HashMap::new();
        for finding in findings {
            let Some(place) = &mut finding.place else { continue };
            let (file, span) = self.span(&place.span);
            let File { path, text } = &self.files[file];
            let starts = lines.entry(file).or_insert_with(|| {
                std::iter::once(0).chain(text.match_indices('\n').map(|(at, _)| at + 1)).collect()
            });
            let line = starts.partition_point(|start| *start <= span.start);
            let column =
                text.get(starts[line - 1]..span.start).map_or(0, |before| before.chars().count()) + 1;
            *place = Place { span, line, column };
            if !path.is_empty() {
                finding.message = format!("{} (in {path})", finding.message);
            }
        }
    }

    /// Where a place of the text is, for a message: `line 3`, `line 3 of arm.xml`.
    pub(super) fn line(&self, span: &Range<usize>) -> String {
        let (file, span) = self.span(span);
        let Some(File { path, text }) = self.files.get(file) else {
            return format!("line {}", Place::of(&self.text, span).line);
        };
        let of = if path.is_empty() { String::new() } else { format!(" of {path}") };
        format!("line {}{of}", Place::of(text, span).line)
    }

    /// The file and the byte in it of a byte of the text.
    fn locate(&self, at: usize) -> (usize, usize) {
        let after = self.pieces.partition_point(|piece| piece.at <= at);
        let Some(piece) = after.checked_sub(1).and_then(|i| self.pieces.get(i)) else { return (0, at) };
        let from = piece.from + (at - piece.at);
        (piece.file, from.min(self.files[piece.file].text.len()))
    }

    fn span(&self, span: &Range<usize>) -> (usize, Range<usize>) {
        let (file, start) = self.locate(span.start);
        let length = self.files.get(file).map_or(usize::MAX, |file| file.text.len());
        (file, start..(start + span.len()).min(length))
    }

    fn by_files(&self, faults: Vec<(usize, Range<usize>, String)>, omitted: usize) -> FilesError {
        let mut grouped: HashMap<usize, Vec<(Range<usize>, String)>> = HashMap::new();
        let mut order = Vec::new();
        for (file, span, message) in faults {
            if !grouped.contains_key(&file) {
                order.push(file);
            }
            grouped.entry(file).or_default().push((span, message));
        }
        order.sort_unstable();
        let error = |file: usize| {
            let whole = || (String::new(), self.text.to_string());
            let (path, text) =
                self.files.get(file).map_or_else(whole, |file| (file.path.clone(), file.text.to_string()));
            let error = TextError::new(&text, grouped.remove(&file).unwrap_or_default());
            FileError { path, text, error }
        };
        let mut files: Vec<FileError> = order.into_iter().map(error).collect();
        if let Some(last) = files.last_mut() {
            last.error.omitted += omitted;
        }
        FilesError { files }
    }
}

/// The files of one model: its folder, and what it has included.
struct Scope {
    folder: String,
    included: HashSet<String>,
}

/// Writes the text.
struct Assembler<'l> {
    loader: &'l mut dyn Loader,
    files: Vec<File>,
    /// By their paths.
    known: HashMap<String, usize>,
    /// The files that are being written, each named by the one before it as a model.
    open: Vec<usize>,
    out: String,
    pieces: Vec<Piece>,
    faults: Vec<(usize, Range<usize>, String)>,
    /// How many files were named so far.
    named: usize,
    full: bool,
}

impl<'l> Assembler<'l> {
    fn new(text: &str, loader: &'l mut dyn Loader) -> Self {
        Self {
            loader,
            files: vec![File { path: String::new(), text: Rc::from(text) }],
            known: HashMap::new(),
            open: Vec::new(),
            out: String::new(),
            pieces: Vec::new(),
            faults: Vec::new(),
            named: 0,
            full: false,
        }
    }

    /// Writes a range of a file, in which `root` is all that there is.
    fn write(&mut self, file: usize, root: Node, range: Range<usize>, scope: &mut Scope, depth: usize) {
        let mut from = range.start;
        for node in root.descendants().filter(Node::is_element) {
            let is_model = node.tag_name().name() == "model"
                && node.parent_element().is_some_and(|parent| parent.tag_name().name() == "asset");
            let is_include = node.tag_name().name() == "include";
            if !is_model && !is_include {
                continue;
            }
            self.copy(file, from..node.range().start, tag(node));
            from = node.range().end;
            self.named += 1;
            if depth == DEEPEST || self.named > MOST_NAMED {
                self.full = true;
                let message = format!(
                    "files name each other more than {DEEPEST} deep, or {MOST_NAMED} times: put into one what belongs together"
                );
                self.fault(file, node, message);
            } else if is_include {
                self.include(file, node, scope, depth + 1);
            } else {
                self.model(file, node, scope, depth + 1);
            }
            if self.full {
                return;
            }
        }
        self.copy(file, from..range.end, tag(root));
    }

    fn include(&mut self, file: usize, node: Node, scope: &mut Scope, depth: usize) {
        if xml::elements(node).next().is_some() {
            return self.fault(file, node, "an <include> holds no elements".to_owned());
        }
        let Some(found) = self.open(file, node, &scope.folder) else { return };
        let path = self.files[found].path.clone();
        if !scope.included.insert(path.clone()) {
            let message =
                format!("'{path}' is included already; each file may be included once, as in MuJoCo");
            return self.fault(file, node, message);
        }
        let text = Rc::clone(&self.files[found].text);
        let Some(document) = self.parse(found, &text) else { return };
        let root = document.root_element();
        if xml::elements(root).next().is_none() {
            return self.fault(
                file,
                node,
                format!("'{path}' has no elements in <{}> to include", root.tag_name().name()),
            );
        }
        let inside = root.first_child().map_or(0, |child| child.range().start)
            ..root.last_child().map_or(0, |child| child.range().end);
        self.write(found, root, inside, scope, depth);
    }

    fn model(&mut self, file: usize, node: Node, scope: &Scope, depth: usize) {
        let Some(found) = self.open(file, node, &scope.folder) else { return };
        let path = self.files[found].path.clone();
        if self.open.contains(&found) {
            return self.fault(file, node, format!("'{path}' names itself as a model, by way of others"));
        }
        let text = Rc::clone(&self.files[found].text);
        let Some(document) = self.parse(found, &text) else { return };
        let root = document.root_element();
        if root.tag_name().name() != "mujoco" {
            let message =
                format!("'{path}' is no MJCF: its root is <{}>, not <mujoco>", root.tag_name().name());
            return self.fault(file, node, message);
        }
        let last = node.attributes().map(|attribute| attribute.range().end).max();
        self.copy(file, node.range().start..last.unwrap_or(node.range().end), tag(node));
        self.out.push('>');
        self.open.push(found);
        let mut scope = Scope { folder: folder_of(&path).to_owned(), included: HashSet::from([path]) };
        self.write(found, root, root.range(), &mut scope, depth);
        self.open.pop();
        self.out.push_str("</model>");
    }

    /// The file that an element names, read.
    fn open(&mut self, file: usize, node: Node, folder: &str) -> Option<usize> {
        let Some(name) = node.attribute("file") else {
            self.fault(file, node, format!("<{}> has no attribute 'file'", node.tag_name().name()));
            return None;
        };
        // From the model's folder, or else from that of the file that names it.
        let own = &self.files[file].path;
        let beside = if own.is_empty() { folder.to_owned() } else { folder_of(own).to_owned() };
        let mut first = None;
        for folder in [folder, &beside] {
            let answer = within(folder, name).and_then(|path| self.load(&path));
            match answer {
                Ok(found) => return Some(found),
                Err(why) => first = first.or(Some(why)),
            }
        }
        let why = first.unwrap_or_default();
        let message = format!("<{}> '{}': {why}", node.tag_name().name(), xml::shown(name));
        self.faults.push((file, value_span(node, "file"), message));
        None
    }

    fn load(&mut self, path: &str) -> Result<usize, String> {
        if let Some(known) = self.known.get(path) {
            return Ok(*known);
        }
        let bytes = self.loader.load(path)?;
        let text = String::from_utf8(bytes).map_err(|error| {
            format!("it is no text: byte {} is not UTF-8", error.utf8_error().valid_up_to())
        })?;
        self.files.push(File { path: path.to_owned(), text: Rc::from(text) });
        self.known.insert(path.to_owned(), self.files.len() - 1);
        Ok(self.files.len() - 1)
    }

    fn parse<'x>(&mut self, file: usize, text: &'x str) -> Option<roxmltree::Document<'x>> {
        match xml::parse(text, usize::MAX) {
            Ok(document) => Some(document),
            Err(error) => {
                let faults = error.faults.into_iter().map(|fault| (file, fault.place.span, fault.message));
                self.faults.extend(faults);
                None
            }
        }
    }

    fn copy(&mut self, file: usize, range: Range<usize>, blame: Range<usize>) {
        if self.out.len() + range.len() > MOST_BYTES && file > 0 {
            self.full = true;
            let message =
                format!("the files that the model names make more than {MOST_BYTES} bytes of text together");
            self.faults.push((file, blame, message));
        }
        if range.is_empty() || self.full {
            return;
        }
        self.pieces.push(Piece { at: self.out.len(), file, from: range.start });
        let text = Rc::clone(&self.files[file].text);
        self.out.push_str(&text[range]);
    }

    fn fault(&mut self, file: usize, node: Node, message: String) {
        self.faults.push((file, tag(node), message));
    }
}

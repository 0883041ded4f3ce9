//! `<include>`: models in files of their own.

use super::model::{self, Contents, Context, Given};
use super::{DEEPEST, pose, version};
use crate::loader::{Loader, folder_of, within};
use crate::xml::{self, Node, Reader, element, elements_called, tag, text_of};
use solaris_model::FindingKind;
use std::collections::HashSet;
use std::ops::Range;

/// The most files that are included, each as often as it is, and their bytes together.
const MOST_FILES: usize = 1000;
const MOST_BYTES: usize = 1 << 26;

/// The files that are included.
pub(super) struct Files<'l> {
    loader: &'l mut dyn Loader,
    /// Those that are being read, each included by the one before.
    open: Vec<String>,
    /// Those whose findings have been told.
    told: HashSet<String>,
    count: usize,
    bytes: usize,
}

impl<'l> Files<'l> {
    pub(super) fn new(loader: &'l mut dyn Loader) -> Self {
        Self { loader, open: Vec::new(), told: HashSet::new(), count: 0, bytes: 0 }
    }
}

/// Why a file is not read.
enum Refusal {
    /// It is not there.
    Absent(String),
    /// It must not be opened.
    Forbidden(String),
}

/// Reads the model that an `<include>` names into the scope of `context`. A model of a world that is not there is left out,
/// with a finding; a part of a model that is not there is a fault.
pub(super) fn read(reader: &mut Reader, node: Node, contents: &mut Contents, context: &Context) {
    reader.check_attributes(node, &["merge"]);
    reader.check_elements(
        node,
        &["uri", "name", "pose", "static", "placement_frame"],
        &["plugin", "namespace"],
    );
    let here = tag(node);
    let uri = element(node, "uri").map(|uri| text_of(uri).0).filter(|uri| !uri.is_empty());
    let Some(uri) = uri else {
        reader.fault(here, "<include> has no <uri>");
        return;
    };
    let found = find(contents, uri);
    let (path, text) = match found {
        Ok(found) => found,
        Err(Refusal::Absent(why)) if context.scope == 0 => {
            let message = format!("it cannot be included, and is left out: {why}");
            reader.suspect(here.clone(), uri, &*message);
            contents.left_out.push((here, format!("'{}': {message}", xml::shown(uri))));
            return;
        }
        Err(Refusal::Absent(why) | Refusal::Forbidden(why)) => {
            reader.fault(here, format!("'{}' cannot be included: {why}", xml::shown(uri)));
            return;
        }
    };
    let merge = node.attribute("merge").is_some_and(is_true);
    let named = element(node, "name").map(|name| text_of(name).0.to_owned()).filter(|name| !name.is_empty());
    let placed = element(node, "placement_frame").map(|frame| text_of(frame));
    let placed =
        placed.filter(|(name, _)| !name.is_empty()).map(|(name, at)| (name.to_owned(), context.at(at)));
    let given = Given {
        name: named,
        pose: element(node, "pose").map(|_| pose::of(reader, node, context.version)),
        placed,
        is_static: element(node, "static").map(|it| is_true(text_of(it).0)),
        merge,
    };
    contents.files.open.push(path.clone());
    file(reader, &text, &path, contents, context, given, &here);
    contents.files.open.pop();
}

/// Whether a word says yes.
pub(super) fn is_true(word: &str) -> bool {
    matches!(word.trim(), "true" | "True" | "TRUE" | "1")
}

/// Reads the model of a text; what is said of it stands at `span`.
fn file(
    outer: &mut Reader,
    text: &str,
    path: &str,
    contents: &mut Contents,
    context: &Context,
    given: Given,
    span: &Range<usize>,
) {
    let text = &*xml::mended(text);
    let document = match xml::parse(text, DEEPEST) {
        Ok(document) => document,
        Err(error) => return say_faults(outer, path, span, &error),
    };
    let root = document.root_element();
    let version = match version(text, root) {
        Ok(version) => version,
        Err(error) => return say_faults(outer, path, span, &error),
    };
    let mut reader = Reader::new(text);
    reader.check_attributes(root, &["version"]);
    let models: Vec<Node> = elements_called(root, "model").collect();
    if models.is_empty() && ["light", "actor"].iter().any(|other| element(root, other).is_some()) {
        outer.aside("<include> of a light or actor", span.clone());
        return;
    }
    let [model] = models[..] else {
        let message = format!("{path} holds {} models; a file that is included holds one", models.len());
        outer.fault(span.clone(), message);
        return;
    };
    let inner = Context { version, span: Some(context.at(span.clone())), ..context.clone() };
    model::read(&mut reader, model, contents, &inner, Some(given));
    if let Some(error) = reader.error() {
        say_faults(outer, path, span, &error);
    }
    if !contents.files.told.insert(path.to_owned()) {
        return;
    }
    for finding in reader.findings() {
        let line = finding.place.map_or(1, |place| place.line);
        let message = format!("{} ({path}, line {line})", finding.message);
        match finding.kind {
            FindingKind::Missing => outer.missing(span.clone(), finding.subject, message),
            FindingKind::Suspect => outer.suspect(span.clone(), finding.subject, message),
            FindingKind::Unsupported => outer.unsupported(span.clone(), finding.subject, message),
            FindingKind::Note => outer.note(span.clone(), finding.subject, message),
        }
    }
}

fn say_faults(outer: &mut Reader, path: &str, span: &Range<usize>, error: &solaris_model::TextError) {
    for fault in &error.faults {
        outer.fault(span.clone(), format!("{path}, line {}: {}", fault.place.line, fault.message));
    }
}

/// The file that a URI names, and its text.
fn find(contents: &mut Contents, uri: &str) -> Result<(String, String), Refusal> {
    let files = &mut contents.files;
    let (scheme, rest) = uri.split_once("://").unwrap_or(("", uri));
    let folder = match scheme {
        "model" | "package" => String::new(),
        "" | "file" => match files.open.last() {
            Some(file) => folder_of(file).to_owned(),
            None => files.loader.folder(),
        },
        _ => {
            return Err(Refusal::Absent(
                "it is not among the files beside the model; download it, and include it by model:// or its path".to_owned(),
            ));
        }
    };
    let path = within(&folder, rest).map_err(Refusal::Forbidden)?;
    let is_file = [".sdf", ".world", ".xml"].iter().any(|ending| path.ends_with(ending));
    let path = if is_file { path } else { in_folder(files, &path)? };
    if files.open.contains(&path) {
        return Err(Refusal::Forbidden(format!("{path} includes itself (a cycle)")));
    }
    let text = load(files, &path)?;
    Ok((path, text))
}

/// The file of a model's folder, as its `model.config` says.
fn in_folder(files: &mut Files, folder: &str) -> Result<String, Refusal> {
    let usual = format!("{folder}/model.sdf");
    let Ok(config) = load(files, &format!("{folder}/model.config")) else { return Ok(usual) };
    let named = xml::parse(&config, DEEPEST).ok().and_then(|document| {
        // The last one has the newest version.
        let root = document.root_element();
        let file = elements_called(root, "sdf").last().map(|file| text_of(file).0.to_owned());
        file.filter(|name| !name.is_empty())
    });
    named.map_or(Ok(usual), |name| within(folder, &name).map_err(Refusal::Forbidden))
}

fn load(files: &mut Files, path: &str) -> Result<String, Refusal> {
    if files.count >= MOST_FILES || files.bytes > MOST_BYTES {
        let message = format!("more than {MOST_FILES} files or {MOST_BYTES} bytes are included");
        return Err(Refusal::Forbidden(message));
    }
    files.count += 1;
    let absent = |why: String| Refusal::Absent(format!("{path}: {why}"));
    let bytes = files.loader.load(path).map_err(absent)?;
    files.bytes += bytes.len();
    String::from_utf8(bytes).map_err(|_| Refusal::Forbidden(format!("{path} is no text (not UTF-8)")))
}

//! Scenes in several texts: what a scene includes is read as if it stood at its beginning.

use crate::loader::Loader;
use solaris_model::TextError;
use solaris_model::text::{Content, Fault, Group, Named, Node, Reader, Value, parse};
use std::ops::Range;

const EXAMPLE: &str = "[\"people.ron\"]";
/// The most texts that a scene can include, and how large all of them together may be (bytes).
const MOST: usize = 200;
const LARGEST: usize = 16 << 20;

/// A text that is included.
pub(super) struct Included {
    path: String,
    text: String,
    /// How long all texts before it are, which its places are moved by, so that no two bytes of a scene have the same place.
    base: usize,
    /// Where the scene itself includes it, or what includes it.
    place: Range<usize>,
}

/// Fetches what a scene includes, and what that does, each text once; in the order in which they are to be read.
pub(super) struct Gathering<'l> {
    loader: &'l mut dyn Loader,
    pub(super) reader: Reader,
    found: Vec<Included>,
    /// The texts that wait for the one that is looked at, from the scene on.
    open: Vec<String>,
    base: usize,
}

impl<'l> Gathering<'l> {
    /// For a scene whose own text is so long (bytes).
    pub(super) fn new(loader: &'l mut dyn Loader, length: usize) -> Self {
        Self { loader, reader: Reader::default(), found: Vec::new(), open: Vec::new(), base: length + 1 }
    }

    /// What a tree includes; `within` is where the scene includes that tree, unless it is the scene's own.
    pub(super) fn gather(&mut self, tree: &Node<'_>, within: Option<&Range<usize>>) {
        let Some(node) = field(tree, "include") else { return };
        for item in self.reader.items(node, "include", EXAMPLE).unwrap_or_default() {
            let Some(path) = self.reader.name(item, "the path of a scene") else { continue };
            let place = within.cloned().unwrap_or_else(|| item.span.clone());
            if let Some(first) = self.open.iter().position(|open| open == path) {
                let round: Vec<String> = self.open[first..].iter().map(|open| format!("'{open}'")).collect();
                let message = format!(
                    "{} includes '{path}', which goes round without end; leave one of them out",
                    round.join(" includes ")
                );
                self.reader.fault(item.span.clone(), message);
            } else if self.found.iter().all(|found| found.path != path) {
                self.one(path, item, place);
            }
        }
    }

    /// Fetches one text, and before it what it includes itself.
    fn one(&mut self, path: &str, item: &Node<'_>, place: Range<usize>) {
        let refuse = |why: String| (item.span.clone(), format!("'{path}': {why}"));
        if self.open.len() + self.found.len() >= MOST {
            let (span, why) = refuse(format!("a scene includes {MOST} texts at most"));
            return self.reader.fault(span, why);
        }
        let fetched = self.loader.text(path).and_then(|text| {
            if text.len() + self.base > LARGEST {
                Err(format!("the texts of a scene have {LARGEST} bytes at most"))
            } else {
                Ok(text)
            }
        });
        let text = match fetched.map_err(refuse) {
            Ok(text) => text,
            Err((span, why)) => return self.reader.fault(span, why),
        };
        let base = self.base;
        match parse(&text, "scene", "Scene(version: 1, …)") {
            Ok(tree) => {
                self.base += text.len() + 1;
                self.open.push(path.to_owned());
                self.gather(&tree.moved(base), Some(&place));
                self.open.pop();
            }
            Err(error) => return self.reader.fault(item.span.clone(), format!("'{path}', {error}")),
        }
        self.found.push(Included { path: path.to_owned(), text, base, place });
    }

    /// The texts, and the faults on the way.
    pub(super) fn finish(self) -> (Vec<Included>, Reader) {
        (self.found, self.reader)
    }
}

impl Included {
    /// Its tree.
    ///
    /// # Errors
    ///
    /// As [`parse`]; none where it has been gathered.
    pub(super) fn tree(&self) -> Result<Node<'_>, TextError> {
        parse(&self.text, "scene", "Scene(version: 1, …)").map(|tree| tree.moved(self.base))
    }
}

/// A field of a group.
fn field<'n, 'a>(tree: &'n Node<'a>, name: &str) -> Option<&'n Node<'a>> {
    let Content::Fields(fields) = &tree.group()?.content else { return None };
    fields.iter().find(|(named, _)| named.name == name).map(|(_, node)| node)
}

/// The fields that a tree has itself.
pub(super) fn own_fields<'n, 'a>(tree: &'n Node<'a>) -> impl Iterator<Item = &'a str> + use<'n, 'a> {
    let fields = match tree.group().map(|group| &group.content) {
        Some(Content::Fields(fields)) => &fields[..],
        _ => &[],
    };
    fields.iter().map(|(named, _)| named.name)
}

/// Puts an included tree before what a tree says: maps and lists are one after the other; what both say otherwise is a fault.
pub(super) fn put_before<'a>(tree: &mut Node<'a>, included: Node<'a>, reader: &mut Reader) {
    let head = included.head();
    if head.as_ref().is_none_or(|head| head.name != "Scene") {
        let message = format!("what is included must be a Scene(version: 1, …), not {}", included.describe());
        return reader.fault(included.place(), message);
    }
    let Some(fields) = into_fields(included) else { return };
    let Value::Group(group) = &mut tree.value else { return };
    let Content::Fields(own) = &mut group.content else { return };
    for (named, node) in fields {
        if matches!(named.name, "version" | "include") {
            continue;
        }
        match own.iter_mut().find(|(known, _)| known.name == named.name) {
            None => own.push((named, node)),
            Some((_, known)) => join(known, &named, node, reader),
        }
    }
}

fn into_fields(node: Node<'_>) -> Option<Vec<(Named<'_>, Node<'_>)>> {
    match node.value {
        Value::Group(group) => match group.content {
            Content::Fields(fields) => Some(fields),
            _ => None,
        },
        _ => None,
    }
}

/// Puts the entries of a map or list before those of another.
fn join<'a>(known: &mut Node<'a>, named: &Named<'a>, node: Node<'a>, reader: &mut Reader) {
    let both = format!("another part of the scene says '{0}' too; keep one of them", named.name);
    let (Value::Group(known), Value::Group(group)) = (&mut known.value, node.value) else {
        return reader.fault(named.span.clone(), both);
    };
    match (&mut known.content, *group) {
        (Content::Map(own), Group { content: Content::Map(mut first), .. }) => {
            first.append(own);
            *own = first;
        }
        (Content::List(own), Group { content: Content::List(mut first), .. }) => {
            first.append(own);
            *own = first;
        }
        _ => reader.fault(named.span.clone(), both),
    }
}

/// The error of a scene of several texts: what is wrong in an included one stands where the scene includes it, with the file's name, line
/// and column.
///
/// # Errors
///
/// [`TextError`] where there are faults.
pub(super) fn finish(reader: Reader, text: &str, included: &[Included]) -> Result<(), TextError> {
    let faults = reader.into_faults();
    if faults.is_empty() {
        return Ok(());
    }
    let placed = |fault: Fault| {
        let span = &fault.span;
        let within = included.iter().find(|one| (one.base..=one.base + one.text.len()).contains(&span.start));
        let Some(one) = within else { return fault };
        let own = span.start - one.base..span.end.max(span.start) - one.base;
        let error = TextError::one(&one.text, own, fault.message);
        (one.place.clone(), format!("'{}', {error}", one.path)).into()
    };
    Err(TextError::new(text, faults.into_iter().map(placed).collect()))
}

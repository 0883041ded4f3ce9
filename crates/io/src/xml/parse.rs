//! The parser: text to a tree of nodes, within bounds of memory, time and depth.

use super::tag;
use roxmltree::{Document, Error, ParsingOptions, TextPos};
use solaris_model::TextError;
use std::ops::Range;

/// The most nodes of a document: some 200 MB of them.
const NODES: u32 = 2_500_000;
/// The most attributes of one element: the parser compares each with all before it.
const ATTRIBUTES: usize = 4096;
/// The most declarations of namespaces: the parser copies them down the tree.
const NAMESPACES: usize = 1000;

/// The document, whose elements are nested at most `deepest` deep (the root is at 1).
///
/// There are no declarations of entities or elements, and no entities but XML's own five. The parser does not recurse, so that nesting
/// costs no stack here; a reader that recurses asks for a small `deepest`.
pub(crate) fn parse(text: &str, deepest: usize) -> Result<Document<'_>, TextError> {
    if text.trim().is_empty() {
        return Err(TextError::one(text, 0..0, "the file is empty"));
    }
    check_size(text)?;
    // A declaration of a document type that declares nothing is none.
    let declared = text.find("<!DOCTYPE").map(|at| &text[at..]);
    let allow_dtd =
        declared.and_then(|rest| rest.find(['[', '>']).map(|end| rest.as_bytes()[end])) == Some(b'>');
    let options = ParsingOptions { nodes_limit: NODES, allow_dtd, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options).map_err(|error| placed(text, &error))?;
    check_depth(text, &document, deepest)?;
    Ok(document)
}

/// Refuses what would take the parser more than linear time.
fn check_size(text: &str) -> Result<(), TextError> {
    if let Some((at, _)) = text.match_indices("xmlns").nth(NAMESPACES) {
        let message = format!("more than {NAMESPACES} namespaces are declared");
        return Err(TextError::one(text, at..at + 5, message));
    }
    let bytes = text.as_bytes();
    let (mut start, mut count) = (0, 0);
    for (i, byte) in bytes.iter().enumerate() {
        match byte {
            b'<' => (start, count) = (i, 0),
            b'=' if matches!(bytes.get(i + 1), Some(b'"' | b'\'' | b' ' | b'\t' | b'\r' | b'\n')) => {
                count += 1;
            }
            _ => {}
        }
        if count > ATTRIBUTES {
            return Err(TextError::one(
                text,
                start..start + 1,
                format!("an element has more than {ATTRIBUTES} attributes"),
            ));
        }
    }
    Ok(())
}

fn check_depth(text: &str, document: &Document, deepest: usize) -> Result<(), TextError> {
    // Parents come before their children.
    let mut depths: Vec<u32> = Vec::new();
    for node in document.descendants() {
        let above = node.parent().map_or(0, |parent| depths[parent.id().get_usize()]);
        let depth = above + u32::from(node.is_element());
        if depth as usize > deepest {
            let name = node.tag_name().name();
            let message = format!("<{name}> is nested {depth} elements deep; at most {deepest} are read");
            return Err(TextError::one(text, tag(node), message));
        }
        depths.push(depth);
    }
    Ok(())
}

/// The parser's error in the words of these messages.
fn placed(text: &str, error: &Error) -> TextError {
    let pos = error.pos();
    let (span, message) = match error {
        Error::UnexpectedEndOfStream | Error::UnclosedRootNode => (
            text.len()..text.len(),
            "the text ends before its root element is closed: it is cut off".to_owned(),
        ),
        Error::NoRootNode => (0..0, "there is no element: this is no XML".to_owned()),
        Error::DtdDetected => {
            let at = text.find("<!DOCTYPE").unwrap_or(0);
            (at..at + 9, "document type declarations (<!DOCTYPE …>) are not read; remove it".to_owned())
        }
        Error::NodesLimitReached => (0..0, format!("the file has more than {NODES} elements and texts")),
        Error::UnknownNamespace(prefix, _) => {
            let advice = format!(
                "declare it in the root element (xmlns:{prefix}=\"…\") or remove what it stands before"
            );
            (bytes_of(text, pos), format!("the prefix '{prefix}:' is not declared; {advice}"))
        }
        Error::UnexpectedCloseTag(expected, found, _) => {
            (bytes_of(text, pos), format!("<{expected}> is open here, and </{found}> closes another element"))
        }
        other => {
            (bytes_of(text, pos), format!("no XML: {}", other.to_string().replace(&format!(" at {pos}"), "")))
        }
    };
    TextError::one(text, span, message)
}

/// The character at a line and column (from 1).
fn bytes_of(text: &str, pos: TextPos) -> Range<usize> {
    let mut start = 0;
    for _ in 1..pos.row {
        start += text[start..].find('\n').map_or(text.len() - start, |newline| newline + 1);
    }
    let mut rest = text[start..].char_indices().skip(pos.col.saturating_sub(1) as usize);
    rest.next().map_or(text.len()..text.len(), |(at, c)| start + at..start + at + c.len_utf8())
}

//! Values of a text written, changed and taken away, all else left as it stands.

use crate::error::TextError;
use crate::node::{Content, Node, Value};
use crate::parse::parse;
use std::ops::Range;

/// Spaces of a level.
const INDENT: usize = 4;

/// The text with another `value` at a `path` of fields and keys of maps, or without what stands there where there is no value. What is on the
/// way and missing is written, with the brackets that are asked for: a step is a field's name, or a key of a map in quotes.
///
/// ```
/// use solaris_text::edit;
///
/// let scene = "Scene(\n    version: 1, // the first\n    drives: {\"*\": Frozen},\n)\n";
/// let bent = edit(scene, "scene", "Scene(…)", &["start", "\"knee.rx\""], Some("deg(30)"))?;
/// assert_eq!(
///     bent,
///     "Scene(\n    version: 1, // the first\n    drives: {\"*\": Frozen},\n    start: {\"knee.rx\": deg(30)},\n)\n"
/// );
/// assert_eq!(edit(&bent, "scene", "Scene(…)", &["start"], None)?, scene);
/// # Ok::<(), solaris_text::TextError>(())
/// ```
///
/// # Errors
///
/// [`TextError`] where the text cannot be read, or something on the way is neither fields nor a map.
pub fn edit(
    text: &str,
    noun: &'static str,
    begins: &'static str,
    path: &[&str],
    value: Option<&str>,
) -> Result<String, TextError> {
    let tree = parse(text, noun, begins)?;
    let Some((last, way)) = path.split_last() else {
        return Ok(value.unwrap_or_default().to_owned());
    };
    let mut node = &tree;
    for (depth, step) in way.iter().enumerate() {
        let Some(entry) = entries(text, node)?.into_iter().find(|entry| entry.is(step)) else {
            let Some(value) = value else { return Ok(text.to_owned()) };
            return Ok(added(text, node, depth, step, &nested(&path[depth + 1..], value)));
        };
        node = entry.value;
    }
    let found = entries(text, node)?.into_iter().find(|entry| entry.is(last));
    Ok(match (found, value) {
        (Some(entry), Some(value)) => replaced(text, entry.value.span.clone(), value),
        (Some(entry), None) => replaced(text, whole(text, entry.key.start..entry.value.span.end), ""),
        (None, Some(value)) => added(text, node, way.len(), last, value),
        (None, None) => text.to_owned(),
    })
}

/// A field, or a key of a map, and what stands there.
struct Entry<'a> {
    name: String,
    key: Range<usize>,
    value: &'a Node<'a>,
}

impl Entry<'_> {
    fn is(&self, step: &str) -> bool {
        self.name == step
    }
}

fn entries<'a>(text: &str, node: &'a Node<'a>) -> Result<Vec<Entry<'a>>, TextError> {
    match node.group().map(|group| &group.content) {
        Some(Content::Fields(fields)) => Ok(fields
            .iter()
            .map(|(named, value)| Entry { name: named.name.to_owned(), key: named.span.clone(), value })
            .collect()),
        Some(Content::Map(pairs)) => Ok(pairs
            .iter()
            .filter_map(|(key, value)| match &key.value {
                Value::Text(name) => {
                    Some(Entry { name: format!("\"{name}\""), key: key.span.clone(), value })
                }
                _ => None,
            })
            .collect()),
        Some(Content::Tuple(items)) if items.is_empty() => Ok(Vec::new()),
        _ => Err(TextError::one(text, node.place(), "nothing can be written in here; it must be (…) or {…}")),
    }
}

/// Brackets around what comes below a missing step.
fn nested(path: &[&str], value: &str) -> String {
    match path.split_first() {
        None => value.to_owned(),
        Some((step, rest)) => {
            let inner = format!("{step}: {}", nested(rest, value));
            if step.starts_with('"') { format!("{{{inner}}}") } else { format!("({inner})") }
        }
    }
}

fn replaced(text: &str, span: Range<usize>, with: &str) -> String {
    [&text[..span.start], with, &text[span.end..]].concat()
}

/// The node with one more entry at its end.
fn added(text: &str, node: &Node<'_>, depth: usize, step: &str, value: &str) -> String {
    let close = node.span.end - 1;
    let last = match node.group().map(|group| &group.content) {
        Some(Content::Fields(fields)) => fields.last().map(|(_, value)| value.span.end),
        Some(Content::Map(pairs)) => pairs.last().map(|(_, value)| value.span.end),
        _ => None,
    };
    let Some(last) = last else {
        return replaced(text, close..close, &format!("{step}: {value}"));
    };
    let comma = comma_after(text, last);
    let at = comma.unwrap_or(last);
    if !text[last..close].contains('\n') {
        let lead = if comma.is_some() { " " } else { ", " };
        return replaced(text, at..at, &format!("{lead}{step}: {value}"));
    }
    // Behind what is said of the line.
    let mut at = at;
    if comma.is_some() {
        at += text[at..close].find('\n').unwrap_or_default();
    }
    let indent = " ".repeat(INDENT * (depth + 1));
    let lead = if comma.is_some() { "" } else { "," };
    replaced(text, at..at, &format!("{lead}\n{indent}{step}: {value},"))
}

/// Just behind the comma that follows a value, if one does.
fn comma_after(text: &str, mut at: usize) -> Option<usize> {
    loop {
        let rest = &text[at..];
        let gap = rest.len() - rest.trim_start().len();
        let rest = &rest[gap..];
        at += gap;
        if rest.starts_with(',') {
            return Some(at + 1);
        }
        if rest.starts_with("//") {
            at += rest.find('\n')?;
        } else if rest.starts_with("/*") {
            at += rest.find("*/")? + 2;
        } else {
            return None;
        }
    }
}

/// An entry with its comma and the line that it would leave empty.
fn whole(text: &str, entry: Range<usize>) -> Range<usize> {
    let line = text[..entry.start].rfind('\n').map_or(0, |newline| newline + 1);
    let alone = text[line..entry.start].trim().is_empty();
    let mut end = comma_after(text, entry.end).unwrap_or(entry.end);
    let rest = &text[end..];
    let blank = rest.find('\n').filter(|newline| rest[..*newline].trim().is_empty());
    if let (true, Some(newline)) = (alone, blank) {
        return line..end + newline + 1;
    }
    if end > entry.end {
        end += rest.len() - rest.trim_start_matches(' ').len();
        return entry.start..end;
    }
    // The last one on its line goes with the comma before it.
    let before = text[..entry.start].trim_end();
    if before.ends_with(',') { before.len() - 1..end } else { entry.start..end }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn set(text: &str, path: &[&str], value: Option<&str>) -> String {
        edit(text, "scene", "Scene(…)", path, value).expect("a text")
    }

    #[test]
    fn values_are_changed_where_they_stand() {
        let text = "Scene(a: 1, m: {\"x\": [1, 2], /* kept */ \"y\": 3})";
        assert_eq!(
            set(text, &["m", "\"x\""], Some("Free")),
            "Scene(a: 1, m: {\"x\": Free, /* kept */ \"y\": 3})"
        );
        assert_eq!(
            set(text, &["m", "\"z\""], Some("4")),
            "Scene(a: 1, m: {\"x\": [1, 2], /* kept */ \"y\": 3, \"z\": 4})"
        );
        assert_eq!(
            set(text, &["b", "c", "\"d\""], Some("5")),
            "Scene(a: 1, m: {\"x\": [1, 2], /* kept */ \"y\": 3}, b: (c: {\"d\": 5}))"
        );
    }

    #[test]
    fn entries_are_taken_away_with_their_commas() {
        assert_eq!(set("Scene(a: 1, b: 2, c: 3)", &["b"], None), "Scene(a: 1, c: 3)");
        assert_eq!(set("Scene(a: 1, b: 2)", &["b"], None), "Scene(a: 1)");
        assert_eq!(set("Scene(a: 1)", &["a"], None), "Scene()");
        assert_eq!(set("Scene(a: {\"x\": 1})", &["a", "\"x\""], None), "Scene(a: {})");
        assert_eq!(set("Scene(a: {})", &["a", "\"x\""], Some("1")), "Scene(a: {\"x\": 1})");
        assert_eq!(set("Scene(a: 1)", &["b", "\"x\""], None), "Scene(a: 1)");
    }

    #[test]
    fn what_is_said_of_a_line_stays_with_it() {
        let text = "Scene(\n    a: 1, // one\n    b: 2 // two, without a comma\n)";
        let more = set(text, &["c"], Some("3"));
        assert_eq!(more, "Scene(\n    a: 1, // one\n    b: 2,\n    c: 3, // two, without a comma\n)");
        assert_eq!(set(&more, &["c"], Some("4")).matches("c: 4").count(), 1);
        let commented = "Scene(\n    a: 1, // one, (\n)";
        assert_eq!(set(commented, &["b"], Some("2")), "Scene(\n    a: 1, // one, (\n    b: 2,\n)");
    }

    #[test]
    fn what_has_no_names_is_refused() {
        let error = edit("Scene(a: [1])", "scene", "Scene(…)", &["a", "b"], Some("1")).expect_err("a list");
        assert!(error.to_string().contains("nothing can be written in here"), "{error}");
    }

    proptest::proptest! {
        #[test]
        fn what_is_written_is_read_again(keys in proptest::collection::vec("[a-z]{1,6}", 1..6), gone in 0_usize..6) {
            let mut text = "Scene(\n    version: 1,\n)\n".to_owned();
            for (i, key) in keys.iter().enumerate() {
                text = set(&text, &["drives", &format!("\"{key}\"")], Some(&i.to_string()));
            }
            let gone = &keys[gone % keys.len()];
            text = set(&text, &["drives", &format!("\"{gone}\"")], None);
            let tree = parse(&text, "scene", "Scene(…)").expect("RON");
            let drives = entries(&text, &tree).expect("fields").pop().expect("drives").value;
            let left: Vec<String> = entries(&text, drives).expect("a map").into_iter().map(|entry| entry.name).collect();
            let mut wanted: Vec<String> = Vec::new();
            for key in keys.iter().filter(|key| *key != gone) {
                let key = format!("\"{key}\"");
                if !wanted.contains(&key) { wanted.push(key); }
            }
            proptest::prop_assert_eq!(left, wanted);
        }
    }
}

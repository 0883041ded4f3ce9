//! What other parsers pass over and this one does not: made into XML without moving a byte.

use std::borrow::Cow;
use std::collections::BTreeSet;

/// The text, with what is common in files written by hand put right: blanks before the declaration, `--` inside of
/// comments, prefixes that nobody declares (`<sensor:ray>`, as it stands in what simulators are told).
///
/// Every byte stays where it is, so that places in it are places in the file.
pub(crate) fn mended(text: &str) -> Cow<'_, str> {
    let mut bytes = Cow::Borrowed(text.as_bytes());
    declaration_first(&mut bytes);
    comments(&mut bytes);
    prefixes(&mut bytes);
    match bytes {
        Cow::Borrowed(_) => Cow::Borrowed(text),
        // Only letters of ASCII were exchanged for such.
        Cow::Owned(bytes) => String::from_utf8(bytes).map_or(Cow::Borrowed(text), Cow::Owned),
    }
}

/// Exchanges blanks before `<?xml …?>` with it; a byte order mark stays first.
fn declaration_first(bytes: &mut Cow<[u8]>) {
    const MARK: &[u8] = "\u{feff}".as_bytes();
    let mark = if bytes.starts_with(MARK) { MARK.len() } else { 0 };
    let blanks = bytes[mark..].iter().take_while(|byte| byte.is_ascii_whitespace()).count();
    let start = mark + blanks;
    if blanks == 0 || !bytes[start..].starts_with(b"<?xml") {
        return;
    }
    if let Some(end) = find(&bytes[start..], b"?>") {
        bytes.to_mut()[mark..start + end + 2].rotate_left(blanks);
    }
}

/// Blanks out comments with `--` in them.
fn comments(bytes: &mut Cow<[u8]>) {
    let mut at = 0;
    while let Some(found) = find(&bytes[at..], b"<!") {
        let start = at + found;
        let (open, close): (&[u8], &[u8]) = match &bytes[start..] {
            rest if rest.starts_with(b"<!--") => (b"<!--", b"-->"),
            rest if rest.starts_with(b"<![CDATA[") => (b"<![CDATA[", b"]]>"),
            _ => {
                at = start + 2;
                continue;
            }
        };
        let inside = start + open.len();
        let Some(length) = find(&bytes[inside..], close) else { return };
        let end = inside + length;
        let content = &bytes[inside..end];
        if open.len() == 4 && (find(content, b"--").is_some() || content.ends_with(b"-")) {
            bytes.to_mut()[inside..end]
                .iter_mut()
                .filter(|byte| !byte.is_ascii_whitespace())
                .for_each(|byte| *byte = b' ');
        }
        at = end + close.len();
    }
}

/// Makes `prefix_name` of the name `prefix:name` of an element or attribute where no one declares the prefix.
fn prefixes(bytes: &mut Cow<[u8]>) {
    let mut declared: BTreeSet<Vec<u8>> = BTreeSet::from([b"xml".to_vec(), b"xmlns".to_vec()]);
    let mut at = 0;
    while let Some(found) = find(&bytes[at..], b"xmlns:") {
        at += found + 6;
        declared.insert(bytes[at..].iter().copied().take_while(|byte| is_of_name(*byte)).collect());
    }
    let mut colons = Vec::new();
    let mut place = Place::Text;
    // Where the name began that is being passed.
    let mut name = None;
    for (i, &byte) in bytes.iter().enumerate() {
        place = match (place, byte) {
            (Place::Text, b'<') if !matches!(bytes.get(i + 1), Some(b'!' | b'?')) => Place::Tag,
            (Place::Tag, b'>') => Place::Text,
            (Place::Tag, b'"' | b'\'') => Place::Value(byte),
            (Place::Value(quote), _) if byte == quote => Place::Tag,
            (place, _) => place,
        };
        match (place, byte) {
            // OpenSim writes names of classes, `HuntCrossleyForce::ContactParametersSet`.
            (Place::Tag, b':') if i > 0 && colons.last() == Some(&(i - 1)) => colons.push(i),
            (Place::Tag, b':') => {
                colons.extend(name.take().filter(|start| !declared.contains(&bytes[*start..i])).map(|_| i));
            }
            (Place::Tag, _) if is_of_name(byte) => name = name.or(Some(i)),
            _ => name = None,
        }
    }
    for colon in colons {
        bytes.to_mut()[colon] = b'_';
    }
}

/// What is being passed.
#[derive(Clone, Copy)]
enum Place {
    Text,
    Tag,
    /// A value in these quotes.
    Value(u8),
}

fn is_of_name(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || matches!(byte, b'_' | b'-' | b'.') || !byte.is_ascii()
}

/// Where `wanted` begins first.
fn find(bytes: &[u8], wanted: &[u8]) -> Option<usize> {
    bytes.windows(wanted.len()).position(|window| window == wanted)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::xml::parse;

    #[test]
    fn what_is_mended_is_xml_and_stays_where_it_was() {
        let text = "\n <?xml version='1.0'?>\n<!-- a -- ü --->\n<r><x:ray a='u:1' y:c = 'x'><b/></x:ray><![CDATA[<!-- -- x:]]></r>";
        let mended = mended(text);
        let document = parse(&mended, 10).expect("XML");
        let b = document.descendants().find(|node| node.has_tag_name("b")).expect("it is there");
        assert_eq!(b.range().start, text.find("<b/>").expect("it is there"));
        let ray = document.descendants().find(|node| node.has_tag_name("x_ray")).expect("it is there");
        assert_eq!((ray.attribute("a"), ray.attribute("y_c")), (Some("u:1"), Some("x")));
        assert!(mended.contains("<![CDATA[<!-- -- x:]]>"));
    }

    #[test]
    fn names_of_classes_and_late_declarations_are_read() {
        let text = "\u{feff}\n <?xml version='1.0'?>\n<a::b c='d::e'>f::g ü<h::i::j/><!-- k::l --></a::b>";
        let mended = mended(text);
        let document = parse(&mended, 10).expect("XML");
        let names: Vec<&str> = document
            .descendants()
            .filter(roxmltree::Node::is_element)
            .map(|node| node.tag_name().name())
            .collect();
        assert_eq!(names, ["a__b", "h__i__j"]);
        assert_eq!(document.root_element().attribute("c"), Some("d::e"));
        assert_eq!((mended.len(), mended.find("<h")), (text.len(), text.find("<h")));
    }

    #[test]
    fn what_needs_no_mending_is_not_copied() {
        for text in
            ["", "<", "<!-- a - b --><r xmlns:x='u'><x:a/></r>", "<!--", "<?xml?>", " <r/>", "<![CDATA["]
        {
            assert!(matches!(mended(text), Cow::Borrowed(same) if same == text), "{text}");
        }
    }
}

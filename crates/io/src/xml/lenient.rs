//! XML as programs write it that are not strict about it.

use std::borrow::Cow;

/// The text, of the same length in bytes and with everything in its place, in which
///
/// - `::` in the names of elements is `__` (OpenSim writes the names of its classes, and XML has no such names);
/// - an XML declaration after empty lines or a byte order mark is blank, and so are they.
pub(crate) fn lenient(text: &str) -> Cow<'_, str> {
    let start = text.find(|c: char| !c.is_whitespace() && c != '\u{feff}').unwrap_or(text.len());
    let declared =
        (start > 0 && text[start..].starts_with("<?xml")).then(|| text[start..].find("?>")).flatten();
    let blank = declared.map_or(0, |end| start + end + 2);
    let colons: Vec<usize> =
        text.match_indices("::").map(|(at, _)| at).filter(|&at| in_name(text, at)).collect();
    if blank == 0 && colons.is_empty() {
        return Cow::Borrowed(text);
    }
    let mut bytes = text.as_bytes().to_vec();
    for byte in bytes[..blank].iter_mut().filter(|byte| **byte != b'\n') {
        *byte = b' ';
    }
    for at in colons {
        bytes[at..at + 2].fill(b'_');
    }
    String::from_utf8(bytes).map_or(Cow::Borrowed(text), Cow::Owned)
}

/// Whether the byte stands in the name of an element: right after `<` or `</`, and no blank between.
fn in_name(text: &str, at: usize) -> bool {
    // Longer names are none of a program's.
    const LONGEST: usize = 200;
    let before = &text.as_bytes()[at.saturating_sub(LONGEST)..at];
    let ends = |byte: &u8| byte.is_ascii_whitespace() || matches!(byte, b'<' | b'>' | b'=' | b'"' | b'\'');
    before.iter().rposition(ends).is_some_and(|last| before[last] == b'<')
}

#[cfg(test)]
mod tests {
    use super::lenient;

    #[test]
    fn names_of_classes_and_late_declarations_are_read() {
        let text = "\u{feff}\n <?xml version='1.0'?>\n<a::b c='d::e'>f::g ü<h::i::j/><!-- k::l --></a::b>";
        let read = lenient(text);
        assert_eq!(read.trim_start(), "<a__b c='d::e'>f::g ü<h__i__j/><!-- k::l --></a__b>");
        assert_eq!((read.len(), read.find("<h")), (text.len(), text.find("<h")));
        let plain = "<?xml version='1.0'?><a b='c::d'/>";
        assert_eq!(lenient(plain), plain);
    }
}

//! Names of others, as they are shown.

use std::borrow::Cow;
use std::fmt::Write;

/// Whether a character is not seen where it is shown, or changes how others are: what moves the cursor, commands a terminal,
/// turns the direction of writing, joins or has no width. Blanks, tabs and ends of lines (`\n`) are seen.
///
/// ```
/// use solaris_text::is_unseen;
/// assert!(['\u{1b}', '\u{9b}', '\r', '\u{202e}', '\u{200b}', '\u{feff}'].into_iter().all(is_unseen));
/// assert!(!['a', ' ', '\n', '\t', 'é', '…', '漢', '\u{1f600}'].into_iter().any(is_unseen));
/// ```
pub fn is_unseen(c: char) -> bool {
    match c {
        '\n' | '\t' => false,
        // Marks of direction, joiners, spaces and fillers without width, ends of lines of other systems, interlinear marks, tags.
        '\u{ad}'
        | '\u{34f}'
        | '\u{61c}'
        | '\u{115f}'..='\u{1160}'
        | '\u{17b4}'..='\u{17b5}'
        | '\u{180b}'..='\u{180f}'
        | '\u{200b}'..='\u{200f}'
        | '\u{2028}'..='\u{202e}'
        | '\u{2060}'..='\u{206f}'
        | '\u{3164}'
        | '\u{feff}'
        | '\u{ffa0}'
        | '\u{fff0}'..='\u{fffb}'
        | '\u{e0000}'..='\u{e0fff}' => true,
        c => c.is_control(),
    }
}

/// A text as it may be shown: what is [not seen](is_unseen) is written out.
///
/// ```
/// assert_eq!(solaris_text::plain("a\u{1b}]0;b\u{7}\u{202e}c"), r"a\u{1b}]0;b\u{7}\u{202e}c");
/// ```
pub fn plain(text: &str) -> Cow<'_, str> {
    if !text.contains(is_unseen) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 16);
    for c in text.chars() {
        if is_unseen(c) {
            // Writing to a string does not fail.
            let _ = write!(shown, "{}", c.escape_unicode());
        } else {
            shown.push(c);
        }
    }
    Cow::Owned(shown)
}

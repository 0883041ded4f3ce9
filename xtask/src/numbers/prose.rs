//! The numbers that a page states: in its sentences, not in its code, addresses and names.

/// A text with its blanks and line ends as single blanks.
pub(super) fn flat(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The sentences of a page.
fn sentences(page: &str) -> String {
    let mut text = String::new();
    for (i, part) in page.split("\n```").enumerate() {
        // Every second part is code.
        if i % 2 == 0 {
            // What is left of the line that closes the code before it.
            text.push_str(if i == 0 { part } else { part.split_once('\n').map_or("", |(_, rest)| rest) });
            text.push('\n');
        }
    }
    let mut plain = String::new();
    for (i, part) in text.split('`').enumerate() {
        plain.push_str(if i % 2 == 0 { part } else { "_" });
    }
    let mut pieces = plain.split("](");
    let mut bare = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        bare.push(']');
        bare.push_str(piece.split_once(')').map_or("", |(_, rest)| rest));
    }
    flat(&bare)
}

/// Numbers of a page, with what is around them, that none of these phrases covers; those of its headings, which count, aside.
pub(super) fn uncovered(page: &str, phrases: &[&str]) -> Vec<String> {
    let text = sentences(page);
    let mut covered: Vec<(usize, usize)> = Vec::new();
    for phrase in phrases {
        let phrase = flat(phrase);
        covered.extend(text.match_indices(&phrase).map(|(at, found)| (at, at + found.len())));
    }
    let part_of_name = |c: char| c.is_alphanumeric() || c == '_' || c == '-' || c == '.';
    let mut missing = Vec::new();
    let mut end = 0;
    while let Some(at) = text[end..].find(|c: char| c.is_ascii_digit()).map(|found| end + found) {
        end = at + text[at..].find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len() - at);
        let is_named = text[..at].ends_with(part_of_name)
            || text[end..].starts_with(|c: char| c.is_alphabetic() || c == '_');
        let counts = text[..at].ends_with("# ") && text[at..end].ends_with('.');
        if !is_named && !counts && !covered.iter().any(|(from, to)| *from <= at && at < *to) {
            let before = text[..at].char_indices().rev().nth(24).map_or(0, |(at, _)| at);
            let after = text[end..].char_indices().nth(16).map_or(text.len(), |(at, _)| end + at);
            missing.push(format!("'…{}…'", &text[before..after]));
        }
    }
    missing
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_sentences_are_found_and_those_of_code_addresses_and_names_are_not() {
        let page = "# A\n\nIt takes 3 minutes ([see](https://x/7)).\n\n```sh\nrun 5\n```\n\nOf `f(9)`, f64, 3D and Apache-2.0,\nup to 12.5 m.\n";
        assert_eq!(uncovered(page, &[]).len(), 2, "{:?}", uncovered(page, &[]));
        assert_eq!(uncovered(page, &["takes 3 minutes", "to 12.5 m"]), Vec::<String>::new());
        let left = uncovered(page, &["takes 3 minutes"]);
        assert!(left.len() == 1 && left[0].contains("12.5"), "{left:?}");
        assert_eq!(uncovered("# A\n\n## 2. B\n\n## 3 c\n", &[]).len(), 1);
    }
}

//! The texts that stand between quotes in Rust code.

/// The literals of some code, with what their escapes stand for; of its documentation those that are raw (`r#"…"#`).
pub(super) fn literals(code: &str) -> Vec<String> {
    let documentation = |line: &&str| line.starts_with("///") || line.starts_with("//!");
    let (mut docs, mut rest) = (String::new(), String::new());
    for line in code.lines() {
        let begun = line.trim_start();
        if documentation(&begun) {
            docs.push_str(begun[3..].strip_prefix(' ').unwrap_or(&begun[3..]));
            docs.push('\n');
        } else if !begun.starts_with("//") {
            rest.push_str(line);
            rest.push('\n');
        }
    }
    let mut found = of(&docs, false);
    found.extend(of(&rest, true));
    found
}

/// The literals of text without comments; only raw ones where it is no code.
fn of(code: &str, is_code: bool) -> Vec<String> {
    let (mut found, mut rest) = (Vec::new(), code);
    while let Some(at) = rest.find('"') {
        let before = &rest[..at];
        rest = &rest[at + 1..];
        let marks = before.len() - before.trim_end_matches('#').len();
        if before[..before.len() - marks].ends_with('r') {
            let end = format!("\"{}", "#".repeat(marks));
            let Some((text, after)) = rest.split_once(&end) else { break };
            found.push(text.to_owned());
            rest = after;
        } else if is_code && !before.ends_with('\'') {
            let (text, after) = escaped(rest);
            found.push(text);
            rest = after;
        }
    }
    found
}

/// The text up to the next quote, and what comes after that.
fn escaped(rest: &str) -> (String, &str) {
    let (mut text, mut chars) = (String::new(), rest.char_indices().peekable());
    while let Some((at, c)) = chars.next() {
        match c {
            '"' => return (text, &rest[at + 1..]),
            '\\' => match chars.next() {
                Some((_, 'n')) => text.push('\n'),
                Some((_, 't')) => text.push('\t'),
                Some((_, '\n')) => while chars.next_if(|(_, c)| c.is_whitespace()).is_some() {},
                Some((_, c)) => text.push(c),
                None => break,
            },
            c => text.push(c),
        }
    }
    (text, "")
}

#[cfg(test)]
mod tests {
    use super::literals;

    #[test]
    fn texts_of_code_and_of_documentation_are_found() {
        let code = "/// Says \"no\": r#\"<a b=\"1\"/>\"#\n// \"nor this\"\nlet a = (\"x\\\n   y\\n\", '\"', r\"\\z\");";
        assert_eq!(literals(code), ["<a b=\"1\"/>", "xy\n", "\\z"]);
    }
}

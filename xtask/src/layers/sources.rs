//! The scan of library sources for what they must not mention.
//!
//! Comments, and `#[cfg(test)]` modules as rustfmt lays them out, are left out. A scan is no proof (an alias fools it),
//! but it finds what slips in.

/// A forbidden word in a source.
#[derive(Debug, PartialEq, Eq)]
pub(crate) struct Found {
    /// Line, from 1.
    line: usize,
    /// What stands there.
    what: &'static str,
}

impl Found {
    /// Whether it is about files.
    pub(crate) fn is_files(&self) -> bool {
        self.what == "std::fs"
    }

    pub(crate) fn message(&self, package: &str, file: &str) -> String {
        format!(
            "{file}:{}: crate '{package}' mentions {}, which only solaris-cli may: take text, bytes, a writer or a trait from \
             the caller instead",
            self.line, self.what
        )
    }
}

/// Paths below `std`, and macros.
const PATHS: [(&str, &str); 5] = [
    ("fs", "std::fs"),
    ("env", "std::env"),
    ("time::Instant", "std::time::Instant"),
    ("time::SystemTime", "std::time::SystemTime"),
    ("process", "std::process"),
];
const MACROS: [&str; 5] = ["println!", "eprintln!", "print!", "eprint!", "dbg!"];
const STREAMS: [&str; 3] = ["stdout()", "stderr()", "stdin()"];

/// Everything in `source` that a library must not mention.
pub(crate) fn check(source: &str) -> Vec<Found> {
    let code = code_lines(source);
    let mut found = Vec::new();
    let mut at = 0;
    while at < code.len() {
        // A `use` tree may span lines: read it as one.
        let (line, mut text) = (code[at].0, code[at].1.to_owned());
        if text.trim_start().trim_start_matches("pub ").starts_with("use ") {
            while !text.contains(';') && at + 1 < code.len() {
                at += 1;
                text.push_str(code[at].1);
            }
        }
        at += 1;
        found.extend(words(&text).into_iter().map(|what| Found { line, what }));
    }
    found
}

/// The lines of code with their numbers, without comments and test modules.
fn code_lines(source: &str) -> Vec<(usize, &str)> {
    let (mut lines, mut in_tests, mut after_cfg) = (Vec::new(), false, false);
    for (i, line) in source.lines().enumerate() {
        let code = line.find("//").map_or(line, |comment| &line[..comment]);
        if in_tests {
            in_tests = line != "}";
        } else if after_cfg && code.starts_with("mod ") && !code.contains(';') {
            in_tests = true;
        } else {
            lines.push((i + 1, code));
        }
        after_cfg = line == "#[cfg(test)]";
    }
    lines
}

fn words(code: &str) -> Vec<&'static str> {
    let paths = std_paths(&code.replace(char::is_whitespace, ""));
    let is_path =
        |wanted: &str| paths.iter().any(|path| path == wanted || path.starts_with(&format!("{wanted}::")));
    let named = PATHS.iter().filter(|(path, _)| is_path(path)).map(|(_, what)| *what);
    let macros = MACROS.iter().filter(|word| is_word(code, word)).copied();
    let streams = STREAMS.iter().filter(|word| is_word(code, word)).copied();
    named.chain(macros).chain(streams).collect()
}

/// Whether `word` stands in `code`, not as the end of a longer name.
fn is_word(code: &str, word: &str) -> bool {
    let longer = |at: usize| code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_');
    code.match_indices(word).any(|(at, _)| !longer(at))
}

/// Every path below `std` in code without white space, with `{…}` opened: `std::{fs,time::{Instant}}` has two.
fn std_paths(code: &str) -> Vec<String> {
    let starts = code.match_indices("std::").map(|(at, word)| &code[at + word.len()..]);
    starts.flat_map(|rest| expand(rest, "").0).collect()
}

/// The paths at the front of `text`, each after `prefix`, and how many bytes they take.
fn expand(text: &str, prefix: &str) -> (Vec<String>, usize) {
    let is_name = |c: char| c.is_alphanumeric() || c == '_' || c == ':' || c == '*';
    let end = text.find(|c| !is_name(c)).unwrap_or(text.len());
    let path = format!("{prefix}{}", &text[..end]);
    if !text[end..].starts_with('{') {
        return (vec![path], end);
    }
    let (mut paths, mut at) = (Vec::new(), end + 1);
    while at < text.len() && !text[at..].starts_with('}') {
        let (inner, length) = expand(&text[at..], &path);
        paths.extend(inner);
        at += length.max(1);
    }
    (paths, (at + 1).min(text.len()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(source: &str) -> Vec<(usize, &'static str)> {
        check(source).into_iter().map(|found| (found.line, found.what)).collect()
    }

    #[test]
    fn files_clocks_environment_and_output_are_found() {
        let source = "\
use std::fs::File;
use std::{
    collections::HashMap,
    time::{Duration, Instant},
    env,
};
fn f() {
    let now = std::time::SystemTime::now();
    println!(\"{now:?}\");
    let x = std :: env :: args();
    std::io::stdout().flush();
}
pub use std::fs;
";
        let expected = [
            (1, "std::fs"),
            (2, "std::env"),
            (2, "std::time::Instant"),
            (8, "std::time::SystemTime"),
            (9, "println!"),
            (10, "std::env"),
            (11, "stdout()"),
            (13, "std::fs"),
        ];
        assert_eq!(found(source), expected);
    }

    #[test]
    fn comments_tests_and_harmless_names_are_left_alone() {
        let source = "\
//! Unlike `std::fs`, nothing here opens files.
use std::io::Write;
use std::time::Duration;
use std::{fmt, error::Error};
/// ```
/// println!(\"{}\", std::env::args().count());
/// ```
fn f(out: &mut impl Write) -> fmt::Result { // println! would be wrong
    my_println!(\"{}\", env!(\"CARGO_PKG_VERSION\"));
    write!(out, \"fs\")
}

#[cfg(test)]
mod tests {
    use std::fs;
    fn g() {
        println!(\"{}\", fs::read_to_string(\"x\"));
    }
}
";
        assert_eq!(found(source), []);
    }

    #[test]
    fn code_after_a_test_module_is_still_read() {
        let source = "#[cfg(test)]\nmod tests {\n    fn f() {}\n}\nfn g() { dbg!(1); }\n";
        assert_eq!(found(source), [(5, "dbg!")]);
        let declared = "#[cfg(test)]\nmod tests;\nfn g() { dbg!(1); }\n";
        assert_eq!(found(declared), [(3, "dbg!")]);
    }

    #[test]
    fn the_message_names_place_crate_and_way_out() {
        let message = Found { line: 3, what: "std::fs" }.message("solaris-io", "crates/io/src/csv.rs");
        insta::assert_snapshot!(message, @"crates/io/src/csv.rs:3: crate 'solaris-io' mentions std::fs, which only solaris-cli may: take text, bytes, a writer or a trait from the caller instead");
    }
}

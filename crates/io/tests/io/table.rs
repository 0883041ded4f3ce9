//! A table of texts and what is said about them.

use solaris_io::Import;
use solaris_model::TextError;
use std::fmt::Write;
use std::time::{Duration, Instant};

/// The most lines of an answer that are kept.
const LINES: usize = 6;

/// What `read` says about each text, under its name; none may take long.
pub(crate) fn answers(read: impl Fn(&str) -> Result<Import, TextError>, cases: &[(&str, String)]) -> String {
    let mut out = String::new();
    for (name, text) in cases {
        let start = Instant::now();
        let answer = match read(text) {
            Err(error) => error.to_string(),
            Ok(import) => {
                let layout = import.figure.layout();
                let links = import.figure.links().len();
                let mut said = format!("{links} links, nq {}, nv {}", layout.nq(), layout.nv());
                for finding in import.findings.iter().take(LINES) {
                    write!(said, "\n{:?}: {finding}", finding.kind).expect("a string");
                }
                said
            }
        };
        let took = start.elapsed();
        assert!(took < Duration::from_mins(1), "{name} took {took:?}");
        writeln!(out, "== {name}").expect("a string");
        for line in answer.lines().take(LINES) {
            let cut: String = line.chars().take(400).collect();
            writeln!(out, "   {cut}").expect("a string");
        }
        let more = answer.lines().count().saturating_sub(LINES);
        if more > 0 {
            writeln!(out, "   … {more} more lines").expect("a string");
        }
    }
    out
}

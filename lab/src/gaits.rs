//! Random walks, too many for every `cargo test`: a million in the thesis's style, and thousands of smooth ones over all grounds and in
//! all manners, each held against the laws. They are the ignored tests of `crates/gait/tests/gait/thesis_random.rs` and `anywhere.rs`.

use crate::workspace::{cargo, cargo_with};

/// How many smooth walks, if not so many as `nightly` has, and the number of the first one.
#[derive(Debug, Default)]
pub(crate) struct Options {
    walks: Option<u64>,
    from: Option<u64>,
}

impl Options {
    /// Of the words of a command.
    pub(crate) fn parse(words: &[&str]) -> Result<Self, String> {
        let mut options = Self::default();
        for pair in words.chunks(2) {
            let (number, word, count) = match pair {
                ["--walks", count] => (&mut options.walks, "--walks", count),
                ["--from", count] => (&mut options.from, "--from", count),
                _ => return Err(format!("gaits {}: it takes --walks N and --from M alone", words.join(" "))),
            };
            *number = Some(count.parse().map_err(|_| format!("{word} {count}: it must be a whole number"))?);
        }
        Ok(options)
    }
}

/// Runs them: those of the thesis's style where nothing is said of smooth ones.
pub(crate) fn run(options: &Options) -> Result<(), String> {
    let of = |name: &'static str| {
        let test = ["test", "--release", "--package", "solaris-gait", "--tests", name];
        [&test[..], &["--", "--ignored", "--nocapture"]].concat()
    };
    if options.walks.or(options.from).is_none() {
        cargo(&of("a_million_requests"))?;
    }
    let said = [("SOLARIS_WALKS", options.walks), ("SOLARIS_WALKS_FROM", options.from)];
    let said = said.into_iter().filter_map(|(name, number)| Some((name, number?.to_string())));
    cargo_with(&of("thousands_of_walks"), &said.collect::<Vec<_>>())
}

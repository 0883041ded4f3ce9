//! Random walks, too many for every `cargo test`: a million in the thesis's style, and thousands of smooth ones over all grounds and in
//! all manners, each held against the laws. They are the ignored tests of `crates/gait/tests/gait/thesis_random.rs` and `anywhere.rs`.

use crate::workspace::{cargo, cargo_with};

/// How many smooth walks, if not so many as `nightly` has.
#[derive(Debug, Default)]
pub(crate) struct Options {
    walks: Option<u64>,
}

impl Options {
    /// Of the words of a command.
    pub(crate) fn parse(words: &[&str]) -> Result<Self, String> {
        match words {
            [] => Ok(Self::default()),
            ["--walks", count] => {
                let walks =
                    count.parse().map_err(|_| format!("--walks {count}: it must be a whole number"))?;
                Ok(Self { walks: Some(walks) })
            }
            _ => Err(format!("gaits {}: it takes --walks N alone", words.join(" "))),
        }
    }
}

/// Runs them: those of the thesis's style where no number of smooth ones is asked for.
pub(crate) fn run(options: &Options) -> Result<(), String> {
    let of = |name: &'static str| {
        let test = ["test", "--release", "--package", "solaris-gait", "--tests", name];
        [&test[..], &["--", "--ignored", "--nocapture"]].concat()
    };
    if options.walks.is_none() {
        cargo(&of("a_million_requests"))?;
    }
    let walks = options.walks.map(|walks| ("SOLARIS_WALKS", walks.to_string()));
    cargo_with(&of("thousands_of_walks"), walks.as_slice())
}

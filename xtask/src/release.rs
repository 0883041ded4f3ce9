//! The chore that goes through a release without making one: everything that must hold before something is published, step by
//! step. Nothing is uploaded, tagged or changed outside of the folder of compiled things.

mod alone;
mod bill;
mod features;
mod licences;
mod minimal;
mod packages;
mod readme;
mod state;
mod versions;

use crate::workspace::metadata;
use state::State;
use std::time::Instant;

/// What became of a step that did not fail.
#[derive(Debug, Clone, PartialEq, Eq)]
enum Done {
    /// It holds, and what there is to say of it.
    Holds(String),
    /// It was not looked at, and why.
    Skipped(String),
}

type Step = fn(&State) -> Result<Done, String>;

/// The steps: what needs no compiling first. Each has a name to ask for it by.
const STEPS: [(&str, Step); 13] = [
    ("versions", versions::equal),
    ("changelog", versions::changelog),
    ("compiler", versions::compiler),
    ("manifests", packages::manifests),
    ("packages", packages::packed),
    ("licences", licences::allowed),
    ("advisories", licences::advisories),
    ("bill", bill::write),
    ("interface", versions::interface),
    ("built", packages::built),
    ("minimal", minimal::check),
    ("features", features::check),
    ("alone", alone::check),
];

/// What the chore was asked.
#[derive(Debug, Default, PartialEq, Eq)]
pub(crate) struct Options {
    /// Steps to run in place of all.
    only: Vec<String>,
    /// Whether what only a release itself must have is asked for: a changelog with its date, a clean tree, a place in the network.
    is_final: bool,
}

impl Options {
    /// Of the words after `release`.
    pub(crate) fn parse(words: &[&str]) -> Result<Self, String> {
        let mut options = Self::default();
        let mut words = words.iter();
        while let Some(word) = words.next() {
            match *word {
                "--final" => options.is_final = true,
                "--only" => {
                    let name = words.next().copied().unwrap_or_default();
                    if !STEPS.iter().any(|(known, _)| *known == name) {
                        let known: Vec<&str> = STEPS.iter().map(|(known, _)| *known).collect();
                        return Err(format!(
                            "release --only '{name}': there is no such step; there are {}",
                            known.join(", ")
                        ));
                    }
                    options.only.push(name.to_owned());
                }
                _ => return Err(format!("release has no option '{word}'; it has --only STEP and --final")),
            }
        }
        Ok(options)
    }
}

/// Runs the steps, whatever becomes of each; an error names those that failed, each with its reason.
pub(crate) fn run(options: &Options) -> Result<(), String> {
    let state = State { metadata: metadata()?, is_final: options.is_final };
    let asked = |name: &str| options.only.is_empty() || options.only.iter().any(|only| only == name);
    let steps: Vec<_> = STEPS.iter().filter(|(name, _)| asked(name)).collect();
    let start = Instant::now();
    let (mut lines, mut failed) = (Vec::new(), Vec::new());
    for (i, (name, step)) in steps.iter().enumerate() {
        println!("[{}/{}] {name}", i + 1, steps.len());
        let begun = Instant::now();
        let line = match step(&state) {
            Ok(Done::Holds(what)) => format!("{name}: {what}"),
            Ok(Done::Skipped(why)) => format!("{name}: skipped: {why}"),
            Err(why) => {
                failed.push(format!("{name}: {why}"));
                format!("{name}: FAILED: {why}")
            }
        };
        println!("      {line} ({:.0} s)", begun.elapsed().as_secs_f64());
        lines.push(line);
    }
    println!("\n{}\n", lines.join("\n"));
    if !failed.is_empty() {
        return Err(format!("{} of {} steps failed\n{}", failed.len(), steps.len(), failed.join("\n")));
    }
    let skipped = lines.iter().filter(|line| line.contains(": skipped: ")).count();
    println!(
        "{} steps hold, {skipped} skipped, in {:.0} s",
        steps.len() - skipped,
        start.elapsed().as_secs_f64()
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_that_is_not_there_is_refused_with_those_that_are() {
        let error = Options::parse(&["--only", "licenses"]).expect_err("spelt otherwise");
        assert!(error.contains("'licenses'") && error.contains("licences"), "{error}");
        let asked = Options::parse(&["--only", "bill", "--final"]).expect("known");
        assert_eq!(asked, Options { only: vec!["bill".to_owned()], is_final: true });
    }
}

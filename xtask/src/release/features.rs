//! Features: every crate compiles with none of them, with each, with each pair of them, and with all.
//!
//! As `cargo hack --feature-powerset --depth 2` does it, without another tool to install, and without sets that switch on the same.

use super::Done;
use super::packages::built_in;
use super::state::{State, listened};
use crate::workspace::cargo;
use std::collections::{BTreeMap, BTreeSet};

type Features = BTreeMap<String, Vec<String>>;

/// Holds no code: what its features do together they do in the crates below it, which are tried with each pair.
const FACADE: &str = "solaris";

/// Checks all crates that have features, with sets of them that differ in what they switch on.
///
/// A pair finds what two features break together. More of them would take hours: the facade alone has thousands of sets.
pub(super) fn check(state: &State) -> Result<Done, String> {
    let (mut count, mut failed) = (0, Vec::new());
    for package in state.metadata.packages.iter().filter(|package| package.name.starts_with("solaris")) {
        for set in sets(&package.features, package.name != FACADE) {
            let mut command = cargo();
            command.env("CARGO_TARGET_DIR", built_in(state));
            command.args(["check", "--quiet", "--package", &package.name, "--no-default-features"]);
            command.args(["--features", &set.join(",")]);
            command.env("RUSTFLAGS", "-Dwarnings");
            let set = format!("{} with the features [{}]", package.name, set.join(", "));
            count += 1;
            if let Err(why) = listened(&mut command) {
                println!("      {set} fails");
                failed.push(format!("{set}:\n{why}"));
            }
        }
    }
    if !failed.is_empty() {
        return Err(format!("{} of {count} sets of features\n{}", failed.len(), failed.join("\n")));
    }
    Ok(Done::Holds(format!("{count} sets of features compile without a warning")))
}

/// None, each, each pair, all: one of those that switch on the same.
fn sets(features: &Features, with_pairs: bool) -> Vec<Vec<&str>> {
    let names: Vec<&str> = features.keys().map(String::as_str).filter(|name| *name != "default").collect();
    let mut sets = vec![Vec::new()];
    sets.extend(names.iter().map(|name| vec![*name]));
    for (i, first) in names.iter().enumerate().filter(|_| with_pairs) {
        sets.extend(names[i + 1..].iter().map(|second| vec![*first, *second]));
    }
    sets.push(names);
    let mut seen = BTreeSet::new();
    sets.retain(|set| seen.insert(switched_on(features, set)));
    sets
}

/// The features of the crate that are on when these are asked for.
fn switched_on<'a>(features: &'a Features, asked: &[&'a str]) -> BTreeSet<&'a str> {
    let (mut on, mut next) = (BTreeSet::new(), asked.to_vec());
    while let Some(name) = next.pop() {
        if on.insert(name) {
            let implied = features.get(name).into_iter().flatten();
            next.extend(implied.map(String::as_str).filter(|name| features.contains_key(*name)));
        }
    }
    on
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_that_switch_on_the_same_are_tried_once() {
        let feature = |name: &str, implied: &[&str]| {
            (name.to_owned(), implied.iter().map(|name| (*name).to_owned()).collect())
        };
        let features = Features::from([
            feature("default", &["a"]),
            feature("a", &["b", "dep:x"]),
            feature("b", &[]),
            feature("c", &["y/z"]),
        ]);
        let alone = sets(&features, false);
        assert_eq!(alone, [vec![], vec!["a"], vec!["b"], vec!["c"], vec!["a", "b", "c"]]);
        let sets = sets(&features, true);
        // Of the eight sets of three features, those with a and without b are none.
        assert_eq!(sets, [vec![], vec!["a"], vec!["b"], vec!["c"], vec!["a", "c"], vec!["b", "c"]]);
    }
}

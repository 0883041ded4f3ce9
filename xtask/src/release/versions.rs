//! Versions: the same everywhere, in the changelog, of a compiler that is the one that is promised, and true of the interface.

use super::Done;
use super::state::{State, listened, outside, starts, text};
use crate::workspace::root;
use std::process::Command;

/// Files that carry the version outside of the workspace: the path, and what stands before the version in it.
const ELSEWHERE: [(&str, &str); 6] = [
    ("python/Cargo.toml", "\nversion = \""),
    ("python/pyproject.toml", "\nversion = \""),
    ("bevy/Cargo.toml", "\nversion = \""),
    ("crates/web/package/package.json", "\"version\": \""),
    ("crates/view/web/package.json", "\"version\": \""),
    ("studio/package.json", "\"version\": \""),
];

/// One version, everywhere.
pub(super) fn equal(state: &State) -> Result<Done, String> {
    let version = state.version();
    let mut others = Vec::new();
    for package in &state.metadata.packages {
        if package.version != version {
            others.push(format!("{} has {}", package.name, package.version));
        }
        // What a package asks of its neighbours, once it is published.
        for dependency in package.dependencies.iter().filter(|dependency| dependency.path.is_some()) {
            let asked = dependency.requirement.as_str();
            if asked != "*" && asked.trim_start_matches('^') != version {
                others.push(format!("{} asks for {} {asked}", package.name, dependency.name));
            }
            if asked == "*" && dependency.kind.is_none() && package.publish.is_none() {
                others.push(format!("{} asks for {} without a version", package.name, dependency.name));
            }
        }
    }
    for (path, before) in ELSEWHERE {
        let text = text(path)?;
        let found = text.split_once(before).and_then(|(_, rest)| rest.split_once('"'));
        match found {
            Some((found, _)) if found == version => {}
            Some((found, _)) => others.push(format!("{path} has {found}")),
            None => others.push(format!("{path} has no version")),
        }
    }
    if others.is_empty() {
        let count = state.metadata.packages.len();
        return Ok(Done::Holds(format!("{version} in {count} crates and {} other files", ELSEWHERE.len())));
    }
    Err(format!("the version is {version}, and: {}", others.join("; ")))
}

/// The changelog speaks of the version; sections that wait for it are gathered under it when it is made.
pub(super) fn changelog(state: &State) -> Result<Done, String> {
    let headings = headings(&text("CHANGELOG.md")?);
    changelog_of(&headings, state.version(), state.is_final)
}

fn headings(text: &str) -> Vec<String> {
    text.lines().filter_map(|line| line.strip_prefix("## ")).map(str::to_owned).collect()
}

fn changelog_of(headings: &[String], version: &str, is_final: bool) -> Result<Done, String> {
    let released = headings.iter().any(|heading| {
        heading.strip_prefix(version).is_some_and(|rest| rest.is_empty() || rest.starts_with(' '))
    });
    let waiting = headings.iter().filter(|heading| heading.starts_with("Unreleased")).count();
    match (released, waiting) {
        (true, 0) => Ok(Done::Holds(format!("it has a section {version}"))),
        (true, _) if is_final => {
            Err(format!("{waiting} sections of CHANGELOG.md are still headed Unreleased beside {version}"))
        }
        (false, _) if is_final => Err(format!("CHANGELOG.md has no section '## {version} (date)'")),
        (false, 0) => Err(format!("CHANGELOG.md has neither a section '## {version}' nor an unreleased one")),
        (_, waiting) => Ok(Done::Holds(format!(
            "{waiting} sections wait for {version}; --final asks that they stand under it"
        ))),
    }
}

/// The compiler that everything is tested with is the oldest that is promised, and no dependency needs a newer one.
pub(super) fn compiler(state: &State) -> Result<Done, String> {
    let channel = text("rust-toolchain.toml")?;
    let channel = channel.split_once("channel = \"").and_then(|(_, rest)| rest.split_once('"'));
    let channel = channel.map_or("", |(channel, _)| channel);
    for package in &state.metadata.packages {
        let promised = package.rust_version.as_deref().unwrap_or("none");
        if numbers(promised).get(..2) != numbers(channel).get(..2) {
            return Err(format!(
                "{} promises rust-version {promised}, and tests run by {channel} (rust-toolchain.toml): make them equal",
                package.name
            ));
        }
    }
    let all = super::bill::resolved()?;
    let newer: Vec<String> = all
        .packages
        .iter()
        .filter(|package| {
            package.rust_version.as_deref().is_some_and(|needed| numbers(needed) > numbers(channel))
        })
        .map(|package| {
            format!(
                "{} {} needs {}",
                package.name,
                package.version,
                package.rust_version.as_deref().unwrap_or("")
            )
        })
        .collect();
    if newer.is_empty() {
        return Ok(Done::Holds(format!(
            "{channel} is promised and tested; none of {} crates needs more",
            all.packages.len()
        )));
    }
    Err(format!("{channel} is promised, and {}", newer.join("; ")))
}

fn numbers(version: &str) -> Vec<u64> {
    version.split('.').map_while(|part| part.parse().ok()).collect()
}

/// The public interface beside that of the release before, by cargo-semver-checks.
pub(super) fn interface(state: &State) -> Result<Done, String> {
    if !starts(outside(root()).args(["semver-checks", "--version"])) {
        return Ok(Done::Skipped(
            "there is no cargo-semver-checks (cargo install cargo-semver-checks)".to_owned(),
        ));
    }
    let tags = listened(Command::new("git").current_dir(root()).args([
        "tag",
        "--list",
        "v*",
        "--sort=-version:refname",
    ]))?;
    let tags = String::from_utf8_lossy(&tags.stdout).into_owned();
    let own = format!("v{}", state.version());
    let Some(before) = tags.lines().find(|tag| *tag != own) else {
        return Ok(Done::Skipped("no release before this one has a tag".to_owned()));
    };
    let mut command = outside(root());
    command.args(["semver-checks", "--baseline-rev", before]);
    for package in state.published().filter(|package| package.name != "solaris-cli") {
        command.args(["--package", &package.name]);
    }
    listened(&mut command)?;
    Ok(Done::Holds(format!("nothing is broken that {before} had, beyond what the version says")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_release_is_in_the_changelog_and_a_dry_run_may_wait() {
        let of = |text: &str, is_final| changelog_of(&headings(text), "0.1.0", is_final);
        assert!(
            matches!(of("## Unreleased: a\n## Unreleased\n", false), Ok(Done::Holds(said)) if said.starts_with("2 "))
        );
        assert!(of("## Unreleased: a\n", true).is_err_and(|why| why.contains("no section '## 0.1.0")));
        assert!(
            of("## 0.1.0 (2026-12-01)\n## Unreleased: a\n", true)
                .is_err_and(|why| why.contains("1 sections"))
        );
        assert!(of("## 0.1.0 (2026-12-01)\n", true).is_ok());
        // Another version that begins alike.
        assert!(of("## 0.1.01\n", false).is_err());
    }

    #[test]
    fn versions_are_ordered_by_number() {
        assert!(numbers("1.100") > numbers("1.95.0"));
        assert_eq!(numbers("1.95.0").get(..2), numbers("1.95").get(..2));
    }
}

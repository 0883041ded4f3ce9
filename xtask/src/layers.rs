//! The onion: a crate uses crates of lower rows only, and no library touches files, clocks, environment or output.

mod sources;

use crate::workspace::{self, Metadata};
use std::fs;
use std::path::Path;

/// Every crate of the workspace and its row; those in [`BESIDE`] stand beside the onion.
pub(crate) const ROWS: &[(&str, u8)] = &[
    ("solaris-cli", 9),
    ("solaris-ffi", 9),
    ("solaris-web", 9),
    ("solaris", 8),
    ("solaris-files", 7),
    ("solaris-scene", 6),
    ("solaris-io", 6),
    ("solaris-view", 6),
    ("solaris-gait", 5),
    ("solaris-modes", 4),
    ("solaris-analysis", 4),
    ("solaris-retarget", 4),
    ("solaris-collision", 3),
    ("solaris-dynamics", 3),
    ("solaris-skin", 3),
    ("solaris-model", 2),
    ("solaris-profiles", 2),
    ("solaris-scalar", 1),
    ("solaris-text", 1),
];

/// Crates that no other may use, and that may use any.
const BESIDE: [&str; 2] = ["solaris-lab", "xtask"];

/// The row whose crate may touch files, clocks, environment and output.
const OUTERMOST: u8 = 9;

/// The library that opens files, and may touch nothing else.
const FILES: &str = "solaris-files";

pub(crate) fn row(name: &str) -> Option<u8> {
    ROWS.iter().find(|(known, _)| *known == name).map(|(_, row)| *row)
}

/// Checks the workspace and prints every break.
pub(crate) fn run() -> Result<(), String> {
    let metadata = workspace::metadata()?;
    let mut breaks = check_dependencies(&metadata);
    let (mut crates, mut files) = (0, 0);
    for package in &metadata.packages {
        if row(&package.name).is_none_or(|row| row == OUTERMOST) {
            continue;
        }
        crates += 1;
        let folder = package.manifest_path.parent().unwrap_or(Path::new(".")).join("src");
        for file in rust_files(&folder)? {
            files += 1;
            let text = fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))?;
            let shown = file.strip_prefix(workspace::root()).unwrap_or(&file).display().to_string();
            let mut found = sources::check(&text);
            found.retain(|found| package.name != FILES || !found.is_files());
            breaks.extend(found.into_iter().map(|found| found.message(&package.name, &shown)));
        }
    }
    if breaks.is_empty() {
        println!(
            "layers: every crate uses lower rows only; {files} files of {crates} libraries leave the outside world alone"
        );
        return Ok(());
    }
    for line in &breaks {
        eprintln!("{line}");
    }
    Err(format!("the layers are broken in {} places", breaks.len()))
}

/// Every dependency that does not point to a lower row. Those of tests (`dev`) are exempt: they ship with nothing.
fn check_dependencies(metadata: &Metadata) -> Vec<String> {
    let is_ours = |name: &str| metadata.packages.iter().any(|package| package.name == name);
    let mut breaks = Vec::new();
    for package in metadata.packages.iter().filter(|package| !BESIDE.contains(&package.name.as_str())) {
        let (user, Some(own)) = (&package.name, row(&package.name)) else {
            breaks.push(format!(
                "crate '{}' stands in no row: give it one in ROWS of xtask/src/layers.rs and in ARCHITECTURE.md",
                package.name
            ));
            continue;
        };
        let counted = package.dependencies.iter().filter(|used| used.kind.as_deref() != Some("dev"));
        for used in counted.map(|used| &used.name).filter(|name| is_ours(name)) {
            match row(used) {
                Some(row) if row < own => {}
                Some(row) => breaks.push(format!(
                    "crate '{user}' (row {own}) uses '{used}' (row {row}), but only rows below {own} are open to it: move \
                     what it needs into a lower crate, or let a crate above both join them"
                )),
                None => breaks.push(format!("crate '{user}' uses '{used}', which stands in no row: no layer may use it")),
            }
        }
    }
    breaks
}

/// All Rust files below a folder, sorted, but those that hold tests alone.
fn rust_files(folder: &Path) -> Result<Vec<std::path::PathBuf>, String> {
    let (mut files, mut open) = (Vec::new(), vec![folder.to_path_buf()]);
    while let Some(folder) = open.pop() {
        let entries = fs::read_dir(&folder).map_err(|error| format!("{}: {error}", folder.display()))?;
        for entry in entries {
            let path = entry.map_err(|error| format!("{}: {error}", folder.display()))?.path();
            if path.file_stem().is_some_and(|stem| stem == "tests") {
                continue;
            }
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                files.push(path);
            }
        }
    }
    files.sort();
    Ok(files)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Metadata of crates and what they use: `("solaris-io", &["solaris-model", "dev:solaris-gait"])`.
    fn check(crates: &[(&str, &[&str])]) -> String {
        let packages: Vec<String> = crates
            .iter()
            .map(|(name, uses)| {
                let uses = uses.iter().map(|used| match used.split_once(':') {
                    Some((kind, used)) => format!(r#"{{"name": "{used}", "kind": "{kind}"}}"#),
                    None => format!(r#"{{"name": "{used}", "kind": null}}"#),
                });
                let uses = uses.collect::<Vec<_>>().join(",");
                format!(r#"{{"name": "{name}", "manifest_path": "Cargo.toml", "dependencies": [{uses}]}}"#)
            })
            .collect();
        let text = format!(r#"{{"packages": [{}], "target_directory": "target"}}"#, packages.join(","));
        let metadata = serde_json::from_str(&text).expect("well-formed");
        check_dependencies(&metadata).join("\n")
    }

    #[test]
    fn downwards_is_allowed_and_tests_may_look_anywhere() {
        let crates: &[(&str, &[&str])] = &[
            ("solaris-cli", &["solaris", "clap"]),
            ("solaris", &["solaris-io", "solaris-gait", "solaris-profiles"]),
            ("solaris-io", &["solaris-model", "csv", "dev:solaris-gait", "dev:solaris-view"]),
            ("solaris-view", &["solaris-model"]),
            ("solaris-gait", &["solaris-model"]),
            ("solaris-model", &["nalgebra", "dev:solaris-io"]),
            ("solaris-profiles", &[]),
            ("xtask", &["serde"]),
            ("solaris-lab", &["solaris-io"]),
        ];
        assert_eq!(check(crates), "");
    }

    #[test]
    fn upwards_sideways_and_build_dependencies_are_breaks() {
        let crates: &[(&str, &[&str])] = &[
            ("solaris-model", &["solaris-dynamics"]),
            ("solaris-dynamics", &["solaris-model"]),
            ("solaris-io", &["solaris-view"]),
            ("solaris-view", &["build:solaris-cli"]),
            ("solaris-cli", &["solaris-lab"]),
            ("solaris-lab", &[]),
        ];
        insta::assert_snapshot!(check(crates), @"
        crate 'solaris-model' (row 2) uses 'solaris-dynamics' (row 3), but only rows below 2 are open to it: move what it needs into a lower crate, or let a crate above both join them
        crate 'solaris-io' (row 6) uses 'solaris-view' (row 6), but only rows below 6 are open to it: move what it needs into a lower crate, or let a crate above both join them
        crate 'solaris-view' (row 6) uses 'solaris-cli' (row 9), but only rows below 6 are open to it: move what it needs into a lower crate, or let a crate above both join them
        crate 'solaris-cli' uses 'solaris-lab', which stands in no row: no layer may use it
        ");
    }

    #[test]
    fn a_crate_without_a_row_is_a_break() {
        insta::assert_snapshot!(
            check(&[("solaris-magic", &[])]),
            @"crate 'solaris-magic' stands in no row: give it one in ROWS of xtask/src/layers.rs and in ARCHITECTURE.md"
        );
    }
}

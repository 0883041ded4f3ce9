//! Packages: what the manifests must say, what each package holds, and that it is enough to compile them.

use super::state::{State, listened, text};
use super::{Done, readme};
use crate::workspace::{cargo, root};
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What every package holds.
const NEEDED: [&str; 4] = ["Cargo.toml", "README.md", "LICENSE-MIT", "LICENSE-APACHE"];
/// Folders that stay in the repository.
const AT_HOME: [&str; 6] = ["tests", "benches", "examples", "fixtures", "node_modules", "target"];
/// The most bytes of a package; the registry takes ten times as many.
const MOST_BYTES: u64 = 1 << 20;

/// What people find a crate by, and its licences.
pub(super) fn manifests(state: &State) -> Result<Done, String> {
    let mut faults = Vec::new();
    let mut without_place = 0;
    for package in state.published() {
        let mut fault = |what: &str| faults.push(format!("{}: {what}", package.name));
        if package.description.as_deref().is_none_or(|description| description.len() < 20) {
            fault("no description");
        }
        if package.license.as_deref() != Some("MIT OR Apache-2.0") {
            fault("its licence is another");
        }
        if package.keywords.is_empty() || package.keywords.len() > 5 {
            fault("it has no keywords, or more than five");
        }
        if package.keywords.iter().any(|keyword| keyword.len() > 20) {
            fault("a keyword has more than 20 letters");
        }
        if package.categories.is_empty() {
            fault("no categories");
        }
        for lacking in readme::faults(package) {
            fault(&lacking);
        }
        without_place += usize::from(package.repository.is_none());
        let folder = package.manifest_path.parent().unwrap_or(Path::new("."));
        for licence in ["LICENSE-MIT", "LICENSE-APACHE"] {
            if fs::read_to_string(folder.join(licence)).ok() != Some(text(licence)?) {
                fault(&format!("its {licence} is not the repository's (a link to ../../{licence})"));
            }
        }
    }
    if !faults.is_empty() {
        return Err(faults.join("; "));
    }
    let place = "say `repository` in [workspace.package], and `repository.workspace = true` in each crate";
    match without_place {
        0 => Ok(Done::Holds(format!("{} crates say what they are", state.published().count()))),
        count if state.is_final => {
            Err(format!("{count} crates do not say where their repository is: {place}"))
        }
        count => Ok(Done::Holds(format!(
            "{count} crates say what they are, and not yet where their repository is; --final asks for it: {place}"
        ))),
    }
}

/// Packs all crates in the order of their needs, and looks into each package.
pub(super) fn packed(state: &State) -> Result<Done, String> {
    if state.is_final {
        let changed = listened(Command::new("git").current_dir(root()).args(["status", "--porcelain"]))?;
        if !changed.stdout.is_empty() {
            return Err("files differ from what is committed: commit first".to_owned());
        }
    }
    let target = state.fresh("packages")?;
    let mut command = cargo();
    command.args(["package", "--workspace", "--no-verify", "--quiet"]).arg("--target-dir").arg(&target);
    if !state.is_final {
        command.arg("--allow-dirty");
    }
    for package in &state.metadata.packages {
        if package.publish.is_some() {
            command.args(["--exclude", &package.name]);
        }
    }
    listened(&mut command)?;
    let (mut faults, mut bytes, mut count) = (Vec::new(), 0, 0);
    for package in state.published() {
        let file = target.join(format!("package/{}-{}.crate", package.name, package.version));
        let size = fs::metadata(&file).map_err(|error| format!("{}: {error}", file.display()))?.len();
        let listed = listed(&file)?;
        let missing = NEEDED.iter().filter(|needed| !listed.iter().any(|path| path == *needed));
        faults.extend(missing.map(|missing| format!("{}: {missing} is missing", package.name)));
        let strange = listed.iter().find(|path| path.split('/').any(|part| AT_HOME.contains(&part)));
        faults
            .extend(strange.map(|path| format!("{}: {path} belongs in the repository alone", package.name)));
        if size > MOST_BYTES {
            faults.push(format!("{}: {size} bytes, more than {MOST_BYTES}", package.name));
        }
        bytes += size;
        count += 1;
    }
    if faults.is_empty() {
        return Ok(Done::Holds(format!("{count} packages, {} kB in all", bytes / 1000)));
    }
    Err(faults.join("; "))
}

/// The paths in a package, from its own folder.
fn listed(file: &Path) -> Result<Vec<String>, String> {
    let listed = listened(Command::new("tar").arg("-tzf").arg(file))?;
    let listed = String::from_utf8_lossy(&listed.stdout).into_owned();
    Ok(listed.lines().filter_map(|line| line.split_once('/')).map(|(_, path)| path.to_owned()).collect())
}

/// Compiles what the packages hold, and nothing beside it: a workspace of what is unpacked, whose members stand in for the registry.
pub(super) fn built(state: &State) -> Result<Done, String> {
    let packages = state.folder().join("packages/package");
    let folder = state.fresh("unpacked")?;
    let (mut members, mut patches) = (String::new(), String::new());
    for package in state.published() {
        let name = format!("{}-{}", package.name, package.version);
        let file = packages.join(format!("{name}.crate"));
        if !file.is_file() {
            packed(state)?;
        }
        listened(Command::new("tar").arg("-xzf").arg(&file).arg("-C").arg(&folder))?;
        // Each package brings a lock file of its own, which a member of a workspace has not.
        let _ = fs::remove_file(folder.join(&name).join("Cargo.lock"));
        let _ = write!(members, "\"{name}\", ");
        let _ = writeln!(patches, "{} = {{ path = \"{name}\" }}", package.name);
    }
    let manifest =
        format!("[workspace]\nresolver = \"3\"\nmembers = [{members}]\n\n[patch.crates-io]\n{patches}");
    let failed = |error: std::io::Error| format!("{}: {error}", folder.display());
    fs::write(folder.join("Cargo.toml"), manifest).map_err(failed)?;
    // What others wrote at the versions that are tested.
    fs::copy(root().join("Cargo.lock"), folder.join("Cargo.lock")).map_err(failed)?;
    let mut command = cargo();
    command.current_dir(&folder).env("CARGO_TARGET_DIR", built_in(state));
    listened(command.args(["check", "--workspace", "--quiet"]))?;
    Ok(Done::Holds("what the packages hold is enough to compile them".to_owned()))
}

/// Where steps that compile keep what is compiled, so that what others wrote is compiled once.
pub(super) fn built_in(state: &State) -> PathBuf {
    state.folder().join("built")
}

//! What the steps share: what cargo says of the workspace, and where they may write.

use crate::workspace::{Metadata, Package, root};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// What the steps share.
#[derive(Debug)]
pub(super) struct State {
    pub(super) metadata: Metadata,
    /// Whether what only a release itself must have is asked for.
    pub(super) is_final: bool,
}

impl State {
    /// The crates that are published, as cargo lists them.
    pub(super) fn published(&self) -> impl Iterator<Item = &Package> {
        self.metadata
            .packages
            .iter()
            .filter(|package| package.publish.as_ref().is_none_or(|to| !to.is_empty()))
    }

    /// The version of all.
    pub(super) fn version(&self) -> &str {
        self.metadata.packages.first().map_or("", |package| package.version.as_str())
    }

    /// The folder of everything that this chore writes.
    pub(super) fn folder(&self) -> PathBuf {
        self.metadata.target_directory.join("dry-run")
    }

    /// An empty folder for a step.
    pub(super) fn fresh(&self, name: &str) -> Result<PathBuf, String> {
        let folder = self.folder().join(name);
        let failed = |error: std::io::Error| format!("{}: {error}", folder.display());
        if folder.exists() {
            fs::remove_dir_all(&folder).map_err(failed)?;
        }
        fs::create_dir_all(&folder).map_err(failed)?;
        Ok(folder)
    }
}

/// A text of the repository.
pub(super) fn text(path: &str) -> Result<String, String> {
    fs::read_to_string(root().join(path)).map_err(|error| format!("{path}: {error}"))
}

/// Cargo of another toolchain, or a tool of it: what cargo says of itself to a chore would choose its own.
pub(super) fn outside(folder: &Path) -> Command {
    let mut command = Command::new("cargo");
    command.current_dir(folder).env_remove("RUSTUP_TOOLCHAIN").env_remove("CARGO").env_remove("RUSTC");
    command
}

/// Whether a command starts and says that all is well.
pub(super) fn starts(command: &mut Command) -> bool {
    command.stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok_and(|status| status.success())
}

/// Runs a command and keeps what it says; the error is the last of it.
pub(super) fn listened(command: &mut Command) -> Result<Output, String> {
    let output = command.output().map_err(|error| format!("{command:?} does not start: {error}"))?;
    if output.status.success() {
        return Ok(output);
    }
    let said =
        format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    Err(last_lines(&said, 40))
}

/// The end of a text.
fn last_lines(text: &str, most: usize) -> String {
    let lines: Vec<&str> = text.lines().collect();
    lines[lines.len().saturating_sub(most)..].join("\n")
}

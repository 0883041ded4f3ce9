//! The workspace: where it is, its pages, running cargo in it.

use std::fs;
use std::path::Path;
use std::process::Command;

/// The workspace's folder.
pub(crate) fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."))
}

/// Runs cargo in the workspace's folder, to its end.
pub(crate) fn cargo(args: &[&str]) -> Result<(), String> {
    cargo_with(args, &[])
}

/// The same with some variables of the environment.
pub(crate) fn cargo_with(args: &[&str], variables: &[(&str, String)]) -> Result<(), String> {
    let mut command = Command::new(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.envs(variables.iter().map(|(name, value)| (name, value)));
    match command.current_dir(root()).args(args).status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(format!("`cargo {}` failed ({status})", args.join(" "))),
        Err(error) => Err(format!("`cargo {}` does not start: {error}", args.join(" "))),
    }
}

/// The text of a file by its path in the workspace.
pub(crate) fn read(path: &str) -> Result<String, String> {
    fs::read_to_string(root().join(path)).map_err(|error| format!("{path}: {error}"))
}

/// Writes a file by its path in the workspace, and says so.
pub(crate) fn write(path: &str, text: &str) -> Result<(), String> {
    eprintln!("writing {path}");
    fs::write(root().join(path), text).map_err(|error| format!("{path}: {error}"))
}

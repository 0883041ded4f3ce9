//! The chore that builds the studio: the engine for WebAssembly, and the page around it.

use crate::workspace::{cargo, metadata, root, run as run_command};
use std::path::PathBuf;
use std::process::{Command, Stdio};

const TARGET: &str = "wasm32-unknown-unknown";
/// The program that joins the engine with JavaScript, and the library whose version it must have.
const BINDER: &str = "wasm-bindgen";

/// Builds `studio/dist/studio.html`; `quick`: nothing is made small.
pub(crate) fn run(options: &[&str]) -> Result<(), String> {
    let quick = match options {
        [] => false,
        ["--quick"] => true,
        _ => return Err(format!("cargo xtask studio takes --quick, not {}", options.join(" "))),
    };
    if !starts("npm", &["--version"]) || !starts("node", &["--version"]) {
        return Err("the studio's page is put together by Node.js: install node and npm".to_owned());
    }
    // Where there is no rustup, the compiler may have the target all the same.
    if starts("rustup", &["--version"]) {
        run_command(Command::new("rustup").current_dir(root()).args(["target", "add", TARGET]))?;
    }
    let binder = binder()?;
    let studio = root().join("studio");
    run_command(Command::new("npm").current_dir(&studio).args([
        "ci",
        "--no-audit",
        "--no-fund",
        "--loglevel=error",
    ]))?;
    run_command(cargo().args(["build", "--profile", "web", "--target", TARGET]).args([
        "--package",
        "solaris-web",
        "--features",
        "studio",
    ]))?;
    let mut build = Command::new("node");
    build.current_dir(&studio).arg("build.mjs").env("WASM_BINDGEN", binder);
    build.env("CARGO_TARGET_DIR", metadata()?.target_directory);
    if quick {
        build.arg("--quick");
    }
    run_command(&mut build)?;
    println!("now: cargo run --release -- studio -o studio.html");
    Ok(())
}

/// Whether a program can be started.
fn starts(program: &str, words: &[&str]) -> bool {
    let mut command = Command::new(program);
    command.args(words).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

/// The binder of the library's version: the one that is installed, or one of the project's own, compiled once.
fn binder() -> Result<PathBuf, String> {
    let version = locked()?;
    let has = |program: &PathBuf| {
        let told = Command::new(program).arg("--version").output();
        told.is_ok_and(|told| String::from_utf8_lossy(&told.stdout).trim() == format!("{BINDER} {version}"))
    };
    let own = metadata()?.target_directory.join("tools");
    let found = [PathBuf::from(BINDER), own.join("bin").join(BINDER)].into_iter().find(has);
    if let Some(found) = found {
        return Ok(found);
    }
    println!("{BINDER} {version} is compiled, once: some minutes");
    let mut install = cargo();
    install.args(["install", "wasm-bindgen-cli", "--version", &version, "--root"]).arg(&own);
    run_command(&mut install)?;
    Ok(own.join("bin").join(BINDER))
}

/// The version of the library that the workspace stands on.
fn locked() -> Result<String, String> {
    let path = root().join("Cargo.lock");
    let lock = std::fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
    let entry = lock.split("[[package]]").find(|entry| entry.contains(&format!("name = \"{BINDER}\"\n")));
    let version = entry.and_then(|entry| entry.split("version = \"").nth(1)?.split('"').next());
    version.map(str::to_owned).ok_or_else(|| format!("{} has no {BINDER}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_library_s_version_is_known() {
        let version = locked().expect("a version");
        assert!(version.split('.').all(|part| part.parse::<u32>().is_ok()), "{version}");
    }
}

//! Puts the studio into the program where it has been built (`cargo xtask studio`): none of what the program needs to be compiled.
//! Tells the program for which target and by which compiler it is built, which `solaris doctor` says.

use std::path::Path;
use std::process::Command;

fn main() {
    let built = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studio/dist");
    println!("cargo::rustc-check-cfg=cfg(studio)");
    println!("cargo::rerun-if-changed=build.rs");
    // In a clone the folder is always there; of a crate alone there is none.
    if built.is_dir() {
        println!("cargo::rerun-if-changed={}", built.display());
    }
    told_of_itself();
    let page = built.join("studio.html");
    if page.is_file() {
        println!("cargo::rustc-cfg=studio");
        println!("cargo::rustc-env=STUDIO_PAGE={}", page.display());
    }
}

/// What only the build knows.
fn told_of_itself() {
    let asked = |name: &str| std::env::var(name).unwrap_or_else(|_| "unknown".to_owned());
    println!("cargo::rustc-env=SOLARIS_TARGET={}", asked("TARGET"));
    let said = Command::new(asked("RUSTC")).arg("--version").output();
    let said = said.map(|said| String::from_utf8_lossy(&said.stdout).into_owned()).unwrap_or_default();
    // `rustc 1.95.0 (hash date)`: the hash says no more.
    let version: Vec<&str> = said.split_whitespace().take(2).collect();
    println!(
        "cargo::rustc-env=SOLARIS_COMPILER={}",
        if version.is_empty() { "rustc".to_owned() } else { version.join(" ") }
    );
}

//! Puts the studio into the program where it has been built (`cargo xtask studio`): none of what the program needs to be compiled.

use std::path::Path;

fn main() {
    let built = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../studio/dist");
    println!("cargo::rustc-check-cfg=cfg(studio)");
    println!("cargo::rerun-if-changed=build.rs");
    // In a clone the folder is always there; of a crate alone there is none.
    if built.is_dir() {
        println!("cargo::rerun-if-changed={}", built.display());
    }
    let page = built.join("studio.html");
    if page.is_file() {
        println!("cargo::rustc-cfg=studio");
        println!("cargo::rustc-env=STUDIO_PAGE={}", page.display());
    }
}

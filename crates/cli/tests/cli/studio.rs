//! The studio: the page where the program holds one, what to do where it does not.

use std::path::Path;
use std::process::{Command, Output};

fn studio(folder: &Path, words: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_solaris"));
    command.current_dir(folder).arg("studio").args(words).output().expect("the program starts")
}

#[test]
#[cfg(not(studio))]
fn without_the_page_it_says_how_to_build_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let output = studio(folder.path(), &["-o", "studio.html"]);
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("built without the studio") && said.contains("cargo xtask studio"), "{said}");
    assert!(!folder.path().join("studio.html").exists());
}

#[test]
#[cfg(studio)]
fn the_page_is_written_with_files_in_it() {
    let folder = tempfile::tempdir().expect("a folder");
    let arm = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/figures/arm.urdf");
    let output = studio(folder.path(), &[arm, "-o", "studio.html"]);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let page = std::fs::read_to_string(folder.path().join("studio.html")).expect("a page");
    let given = page.find("id=\"given\"").expect("what is given");
    assert!(page[given..].starts_with("id=\"given\">[{\"name\":\"arm.urdf\",\"base64\":\""));
    assert!(Some(given) < page.find("<script id=\"boot\">"));
}

#[test]
fn a_file_that_is_not_there_and_a_place_that_is_no_page_are_refused() {
    for (words, code, part) in [
        (["nothing.urdf", "-o", "studio.html"], 1, "nothing.urdf"),
        (["-o", "studio.pdf", "arm.urdf"], 1, "its extension must be"),
    ] {
        let folder = tempfile::tempdir().expect("a folder");
        let output = studio(folder.path(), &words);
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{said}");
        assert!(said.contains(part), "{said}");
    }
}

//! The transcripts of `tests/cmd`: what a user types, the exit code behind `?`, and what is printed.
//!
//! They run in a folder that holds the folder `clips`, the folder `walk.csv`, and the file `notes`. `[..]` stands for any
//! text in a line (run times, last digits, what only the planner decides), `...` for any lines. After a meant change,
//! `TRYCMD=overwrite cargo test -p solaris-cli --test transcripts` writes what is printed now; put the wildcards back and
//! read the difference before committing it.

use std::path::Path;

#[test]
fn transcripts_hold() {
    // No transcript is no success: a folder that is not found would pass.
    let transcripts = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cmd");
    let count = std::fs::read_dir(&transcripts).expect("the transcripts").count();
    assert!(count >= 5, "{count} transcripts");
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::create_dir(folder.path().join("clips")).expect("made");
    std::fs::create_dir(folder.path().join("walk.csv")).expect("made");
    std::fs::write(folder.path().join("notes"), "no folder").expect("written");
    // The only test of this program: nobody else asks for the folder.
    std::env::set_current_dir(folder.path()).expect("entered");
    let cases = trycmd::TestCases::new();
    cases.register_bin("solaris", Path::new(env!("CARGO_BIN_EXE_solaris")));
    cases.case(transcripts.join("*.trycmd"));
    cases.run();
}

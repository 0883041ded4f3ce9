//! The programs of `examples/`, compiled by the machine's C and C++ compilers, where it has them, under the sanitizers of addresses and
//! of undefined behaviour, where these have them.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The static library that stands beside this test's program.
fn library() -> PathBuf {
    let test = std::env::current_exe().expect("its own path");
    let folders = test.ancestors().skip(1);
    folders
        .map(|folder| folder.join("libsolaris_ffi.a"))
        .find(|path| path.is_file())
        .expect("cargo builds the static library with the crate")
}

fn run(command: &mut Command) -> Option<Output> {
    command.output().ok()
}

/// Compiles and runs a program; `None`, said aloud, where there is no compiler.
fn output(compiler: &str, source: &str, standard: &str) -> Option<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let place = tempfile::tempdir().expect("a folder");
    let program = place.path().join("program");
    let compile = |sanitizers: &[&str]| {
        let mut command = Command::new(compiler);
        command.args([standard, "-Wall", "-Wextra", "-Werror", "-g"]).args(sanitizers);
        command.arg(folder.join("examples").join(source)).arg("-I").arg(folder.join("include"));
        command.arg(library()).args(["-lm", "-lpthread", "-ldl", "-o"]).arg(&program);
        run(&mut command)
    };
    let sanitized = compile(&["-fsanitize=address,undefined", "-fno-sanitize-recover=all"]);
    let built = match sanitized {
        Some(built) if built.status.success() => built,
        Some(_) => {
            skip(&format!("{compiler} has no sanitizers here; {source} runs without"));
            compile(&[])?
        }
        None => {
            skip(&format!("there is no {compiler}: {source} is not compiled"));
            return None;
        }
    };
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    let ran = run(&mut Command::new(&program)).expect("it runs");
    assert!(ran.status.success(), "{}", String::from_utf8_lossy(&ran.stderr));
    Some(String::from_utf8(ran.stdout).expect("a text"))
}

/// Said past what keeps the words of tests that pass.
fn skip(why: &str) {
    writeln!(std::io::stderr(), "skipped: {why}").expect("stderr");
}

#[test]
fn a_c_program_steers_a_walker() {
    if let Some(said) = output("cc", "walk.c", "-std=c99") {
        let expected = "\
human stands at (1.0, 4.0): 1; her weight is 568.8 N
refused: a frame of 9 s: it must last more than 0 and at most 0.25 s
refused: q has 3 numbers; it must have 66
";
        assert_eq!(said, expected);
    }
}

#[test]
fn the_program_of_the_readme_says_what_a_person_is() {
    let readme = include_str!("../README.md");
    let (_, rest) = readme.split_once("```c\n").expect("a program");
    let (program, _) = rest.split_once("```").expect("its end");
    let place = tempfile::tempdir().expect("a folder");
    let source = place.path().join("readme.c");
    std::fs::write(&source, program).expect("written");
    if let Some(said) = output("cc", source.to_str().expect("a path"), "-std=c99") {
        assert_eq!(said, "58 kg in 66 degrees of freedom\n");
    }
}

#[test]
fn a_cpp_program_takes_snapshots() {
    if let Some(said) = output("c++", "swing.cpp", "-std=c++17") {
        let lines: Vec<&str> = said.lines().collect();
        assert_eq!(lines[..2], ["after half a swing: -0.0100 rad", "its twin: the same"]);
        assert!(
            lines[2].starts_with("refused: line 1, column ") && said.contains("did you mean 'duration'"),
            "{said}"
        );
    }
}

//! The programs of docs/engines.md for game engines, as they stand there: compiled and run against stand-ins for what they call of
//! their engine (`engines/`). No engine runs here; that names and signatures are those of the stand-ins is all that is taken on trust.

use solaris::gait::{Command as Steer, Walker};
use solaris::model::{Human, RootOrder};
use std::env::consts::{DLL_PREFIX, DLL_SUFFIX};
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Where each link is, in an engine's axes: its name, place and quaternion (x, y, z, w).
type Row = (String, [f64; 7]);

/// The program under a heading of the page.
fn program(heading: &str) -> &'static str {
    let page = include_str!("../../../docs/engines.md");
    let (_, under) = page.split_once(&format!("\n## {heading}")).expect("the heading");
    let (_, program) =
        under.split_once("```").and_then(|(_, rest)| rest.split_once('\n')).expect("a program");
    program.split_once("```").expect("its end").0
}

/// A library that stands beside this test's program.
fn library(name: &str) -> PathBuf {
    let test = std::env::current_exe().expect("its own path");
    let mut folders = test.ancestors().skip(1);
    folders.find_map(|folder| Some(folder.join(name)).filter(|path| path.is_file())).expect("cargo builds it")
}

/// Whether a program is there; said aloud where not, past what keeps the words of tests that pass.
fn has(program: &str, what: &str) -> bool {
    let there = Command::new(program).arg("--version").output().is_ok();
    if !there {
        writeln!(std::io::stderr(), "skipped: there is no {program}: {what} is not compiled")
            .expect("stderr");
    }
    there
}

fn done(command: &mut Command) -> String {
    let output = command.output().expect("it starts");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{}{said}", String::from_utf8_lossy(&output.stdout));
    assert_eq!(said, "", "nothing is refused");
    String::from_utf8(output.stdout).expect("a text")
}

fn rows(text: &str) -> Vec<Row> {
    let row = |line: &str| {
        let mut words = line.split(' ');
        let name = words.next().expect("a name").to_owned();
        let numbers: Vec<f64> = words.map(|word| word.parse().expect("a number")).collect();
        (name, numbers.try_into().expect("seven numbers"))
    };
    text.lines().map(row).collect()
}

/// Compiles and runs a C++ program between its stand-in and its `main`.
fn of_cpp(engine: &str, heading: &str) -> Option<Vec<Row>> {
    if !has("c++", heading) {
        return None;
    }
    let ffi = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = tempfile::tempdir().expect("a folder");
    let (source, binary) = (folder.path().join("engine.cpp"), folder.path().join("engine"));
    let text = format!(
        "#include \"{engine}.hpp\"\n#line 1 \"docs/engines.md: {heading}\"\n{}\n#include \"{engine}_main.cpp\"\n",
        program(heading)
    );
    std::fs::write(&source, text).expect("written");
    let mut compile = Command::new("c++");
    compile.args(["-std=c++17", "-Wall", "-Wextra", "-Werror", "-g"]).arg(&source);
    compile.arg("-I").arg(ffi.join("include")).arg("-I").arg(ffi.join("tests/engines"));
    done(compile.arg(library("libsolaris_ffi.a")).args(["-lm", "-lpthread", "-ldl", "-o"]).arg(&binary));
    Some(rows(&done(&mut Command::new(&binary))))
}

/// Where the links of the same person are after the same frames, in our axes; the stick is of single precision.
fn expected(dt: f64) -> Vec<Row> {
    let ann = Human::new(1.75, 73.0).root(RootOrder::Yzx).build().expect("a person");
    let mut walker = Walker::new(&ann).expect("a walker");
    let command = Steer::velocity(-1.4 * f64::from(0.1_f32), 1.4 * f64::from(0.9_f32));
    let mut q = Vec::new();
    for _ in 0..150 {
        q = walker.step(dt, &command).expect("a frame").to_vec();
    }
    let row = |(link, place): (&solaris::model::Link, &solaris::model::Placement)| {
        let (p, r) = (place.translation, place.rotation.coords);
        (link.name().to_owned(), [p.x, p.y, p.z, r.x, r.y, r.z, r.w])
    };
    ann.links().iter().zip(&ann.places(&q)).map(row).collect()
}

/// Compares places (m, or what `scale` makes of them) and turns, which have two quaternions each.
fn compare(found: &[Row], expected: &[Row], scale: f64, within: f64) {
    assert_eq!(found.len(), expected.len());
    for ((name, a), (_, b)) in found.iter().zip(expected) {
        let sign = if (3..7).map(|i| a[i] * b[i]).sum::<f64>() < 0.0 { -1.0 } else { 1.0 };
        for i in 0..7 {
            let off = if i < 3 { (a[i] - b[i]) / scale } else { a[i] - sign * b[i] };
            assert!(off.abs() < within, "{name}, number {i}: {} in place of {}", a[i], b[i]);
        }
    }
    let head = found.iter().find(|(name, _)| name == "head" || name == "20").expect("a head");
    assert!(head.1.iter().take(3).any(|x| x.abs() > scale), "nobody has walked: {head:?}");
}

#[test]
fn godot_s_node_walks() {
    let Some(found) = of_cpp("godot", "Godot 4") else { return };
    let mut rows = expected(1.0 / 60.0);
    rows.retain(|(name, _)| !name.contains("toes"));
    assert!(found.iter().zip(&rows).all(|(a, b)| a.0 == b.0));
    compare(&found, &rows, 1.0, 1e-6);
}

#[test]
fn unreal_s_actor_walks() {
    let Some(found) = of_cpp("unreal", "Unreal 5") else { return };
    let mut rows = expected(f64::from(1.0_f32 / 60.0));
    for (_, row) in &mut rows {
        let [x, y, z, qx, qy, qz, w] = *row;
        *row = [100.0 * z, -100.0 * x, 100.0 * y, -qz, qx, -qy, w];
    }
    assert!(found.iter().zip(&rows).all(|(a, b)| a.0 == b.0));
    compare(&found, &rows, 100.0, 1e-8);
}

#[test]
fn unity_s_script_walks() {
    if !has("mcs", "Unity (C#)") || !has("mono", "Unity (C#)") {
        return;
    }
    let folder = tempfile::tempdir().expect("a folder");
    let (source, binary) = (folder.path().join("SolarisWalker.cs"), folder.path().join("engine.exe"));
    std::fs::write(&source, program("Unity")).expect("written");
    let stand_in = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/engines/unity.cs");
    done(Command::new("mcs").arg(format!("-out:{}", binary.display())).arg(&source).arg(stand_in));
    let library = library(&format!("{DLL_PREFIX}solaris_ffi{DLL_SUFFIX}"));
    let beside = library.parent().expect("a folder");
    let mut run = Command::new("mono");
    run.arg(&binary).env("LD_LIBRARY_PATH", beside).env("DYLD_LIBRARY_PATH", beside);
    let found = rows(&done(&mut run));
    let mut rows = expected(f64::from(1.0_f32 / 60.0));
    for (_, row) in &mut rows {
        let [x, y, z, qx, qy, qz, w] = *row;
        *row = [-x, y, z, qx, -qy, -qz, w];
    }
    compare(&found, &rows, 1.0, 1e-6);
}

//! Where files come to stand, and what stood there before.

use crate::walk::{names, read, refused, solaris, succeeded};
use std::fs;

#[test]
fn names_may_have_spaces_and_any_letters() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::create_dir(folder.path().join("Gänge 歩く")).expect("made");
    let path = "Gänge 歩く/zu Fuß — 歩く.bvh";
    let said = succeeded(&solaris(folder.path(), &["walk", "--steps", "1", "-o", path]));
    assert!(said.contains(&format!("wrote {path}\n")), "{said}");
    assert_eq!(names(&folder.path().join("Gänge 歩く")), ["zu Fuß — 歩く.bvh"]);
}

#[test]
fn extensions_may_be_written_in_capitals_and_names_may_be_long() {
    let folder = tempfile::tempdir().expect("a folder");
    // 255 bytes, the most that most file systems hold.
    let longest = format!("{}.bvh", "x".repeat(251));
    succeeded(&solaris(folder.path(), &["walk", "--steps", "1", "-o", "WALK.BVH", "-o", &longest]));
    assert_eq!(names(folder.path()), ["WALK.BVH", longest.as_str()]);
    let longer = format!("x{longest}");
    assert!(refused(&solaris(folder.path(), &["walk", "-o", &longer])).contains(&longer));
}

#[test]
fn an_existing_file_is_replaced_when_all_are_written() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("walk.bvh"), "old").expect("written");
    succeeded(&solaris(folder.path(), &["walk", "--steps", "1", "-o", "walk.bvh", "--report", "walk.json"]));
    assert_eq!(names(folder.path()), ["walk.bvh", "walk.json"]);
    assert!(read(&folder.path().join("walk.bvh")).starts_with("HIERARCHY"));
}

#[test]
fn an_existing_file_stays_when_the_walk_cannot_be() {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("walk.bvh"), "old").expect("written");
    for bad in [&["--height", "17"] as &[&str], &["--step-length", "0.2"], &["-o", "nowhere/walk.csv"]] {
        refused(&solaris(folder.path(), &[&["walk", "-o", "walk.bvh"], bad].concat()));
        assert_eq!(names(folder.path()), ["walk.bvh"]);
        assert_eq!(read(&folder.path().join("walk.bvh")), "old");
    }
}

#[cfg(unix)]
mod unix {
    use crate::walk::{command, names, read, refused, solaris, succeeded};
    use std::fs::{self, Permissions};
    use std::io::Write;
    use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
    use std::os::unix::process::CommandExt;

    #[test]
    fn two_ways_to_one_file_are_found() {
        let folder = tempfile::tempdir().expect("a folder");
        fs::create_dir(folder.path().join("real")).expect("made");
        symlink("real", folder.path().join("link")).expect("linked");
        fs::write(folder.path().join("real/r.json"), "old").expect("written");
        symlink("real/r.json", folder.path().join("r.csv")).expect("linked");
        for pair in [
            ["-o", "real/a.csv", "-o", "link/a.csv"],
            ["-o", "a.csv", "-o", "./a.csv"],
            ["-o", "a.csv", "-o", "real/../a.csv"],
            ["-o", "r.csv", "--report", "link/r.json"],
        ] {
            let said = refused(&solaris(folder.path(), &[&["walk"], &pair as &[&str]].concat()));
            assert!(said.contains(&format!("{} {} is the same file", pair[0], pair[1])), "{said}");
        }
        assert_eq!(names(folder.path()), ["link", "r.csv", "real"]);
        assert_eq!(names(&folder.path().join("real")), ["r.json"]);
    }

    #[test]
    fn a_link_is_followed_and_stays() {
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("first.bvh"), "old").expect("written");
        symlink("first.bvh", folder.path().join("latest.bvh")).expect("linked");
        symlink("nothing.bvh", folder.path().join("lost.bvh")).expect("linked");
        succeeded(&solaris(folder.path(), &["walk", "--steps", "1", "-o", "latest.bvh"]));
        assert!(folder.path().join("latest.bvh").is_symlink());
        assert!(read(&folder.path().join("first.bvh")).starts_with("HIERARCHY"));
        assert!(refused(&solaris(folder.path(), &["walk", "-o", "lost.bvh"])).contains("a link to nothing"));
        assert!(folder.path().join("lost.bvh").is_symlink());
    }

    #[test]
    fn a_read_only_file_is_kept() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("walk.csv");
        fs::write(&path, "old").expect("written");
        fs::set_permissions(&path, Permissions::from_mode(0o444)).expect("set");
        assert!(
            refused(&solaris(folder.path(), &["walk", "-o", "walk.csv"])).contains("must not be written")
        );
        assert_eq!(read(&path), "old");
    }

    #[test]
    fn a_read_only_folder_takes_no_file() {
        let folder = tempfile::tempdir().expect("a folder");
        let locked = folder.path().join("locked");
        fs::create_dir(&locked).expect("made");
        let is_root = fs::metadata(&locked).expect("there").uid() == 0;
        // Anybody may write beside it, nobody in it.
        fs::set_permissions(folder.path(), Permissions::from_mode(0o777)).expect("set");
        fs::set_permissions(&locked, Permissions::from_mode(0o555)).expect("set");
        let mut run =
            command(folder.path(), &["walk", "--steps", "1", "-o", "walk.bvh", "-o", "locked/walk.csv"]);
        if is_root {
            // Root may write anywhere; the user nobody may not.
            run.uid(65534).gid(65534);
        }
        let output = match run.output() {
            Err(error) if is_root => {
                // Past the harness, which catches what is printed.
                let _ =
                    writeln!(std::io::stderr(), "skipped: the user nobody cannot run the program: {error}");
                return;
            }
            output => output.expect("the program starts"),
        };
        let said = refused(&output);
        assert!(said.contains("locked/walk.csv: Permission denied"), "{said}");
        assert_eq!(names(folder.path()), ["locked"], "nor is the other one left");
        assert!(names(&locked).is_empty());
    }
}

//! The transcripts of `tests/cmd`: what a user types, the exit code behind `?`, and what is printed.
//!
//! They run in a folder that holds the folder `clips`, the folder `walk.csv`, the file `notes`, and the fixtures: the
//! subject (`subject.osim`, `walk.mot`, `grf.mot`, `loads.xml`, `soles.ron`), the clips (`dancer.ron`, `dance.csv`, `walk.c3d`), two recordings of markers with something odd (`metres.trc`, `torn.trc`), a leg with markers (`leg.osim`, `static.trc`, `swing.trc`, its first frames with another way up `swing_z_up.trc`, `scale.xml`, `ik.xml`), the robot `arm.urdf`, the same with faults
//! (`faulty.urdf`) and with an elbow that cannot stretch (`stiff.urdf`), a motion of it (`swing.csv`), walks of a
//! sweep (`people.csv`), and of curves the keys `keys.csv` and two texts with faults (`misspelt.ron`, `faulty.ron`), and scenes: three of the fixtures, `reach.ron` of
//! the robot, the same with faults (`faulty_scene.ron`), `falls.ron` of the robot and nothing else, and a pendulum by too coarse a method (`coarse.ron`). They run at the same time: no two of them may
//! write one file.
//!
//! `[..]` stands for any text in a line (run times, last digits, what only the planner decides, and the backslash that
//! goes on in the next line, which would be read as a slash), `...` for any lines. After a meant change,
//! `TRYCMD=overwrite cargo test -p solaris-cli --test transcripts` writes what is printed now; put the wildcards back and
//! read the difference before committing it.

use std::path::Path;

/// Half a second in which the robot's arm swings forwards.
const SWING: &str = "\
time,shoulder.q,elbow.q
0.0,0.00,-0.30
0.1,-0.05,-0.32
0.2,-0.20,-0.40
0.3,-0.42,-0.52
0.4,-0.60,-0.62
0.5,-0.66,-0.65
";

/// The robot's arm reaches up, and its elbow then hangs loose.
const REACH: &str = "\
Scene(
    version: 1,
    figures: {\"robot\": File(\"arm.urdf\")},
    duration: 2.0,
    tolerance: 1e-5,
    drives: {
        \"shoulder\": Move(to: deg(-60), over: 1.0),
        \"elbow\": [Move(to: deg(-90), over: 0.5), Free],
    },
    limits: {\"elbow\": Hard(restitution: 0.5)},
)
";

/// Three walks, and two that cannot be.
const PEOPLE: &str = "\
height,mass,speed,steps,tilt
1.60,55,1.2,2,
1.85,,1.4,1,5
1.75,73,,8,
2.75,,,2,
1.75,,3,2,
";

/// A tail of two bones that swings, by a program that puts its rest pose in front.
const TAIL: &str = "\
HIERARCHY
ROOT tail
{
    OFFSET 0 0 0
    CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
    JOINT tip
    {
        OFFSET 0 -30 0
        CHANNELS 3 Zrotation Xrotation Yrotation
        End Site
        {
            OFFSET 0 -20 0
        }
    }
}
MOTION
Frames: 6
Frame Time: 0.033333
0 100 0 0 0 0 0 0 0
0 100 0 10 40 0 0 20 0
0 101 0 12 38 0 0 22 0
0 102 0 14 35 0 0 25 0
0 102 0 15 33 0 0 26 0
0 101 0 15 32 0 0 26 0
";

/// Three markers in millimetres that say metres, without times, of which one is at zeros in the second frame; the header counts two.
const METRES: &str = "\
PathFileType\t4\t(X/Y/Z)\tmetres.trc
DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame\tOrigNumFrames
100\t100\t4\t2\tm\t100\t1\t4
Frame#\tTime\tHead\t\t\tR Heel\t\t\tR Toe\t\t
\t\tX1\tY1\tZ1\tX2\tY2\tZ2\tX3\tY3\tZ3

1\t\t0\t1700\t0\t-50\t30\t100\t150\t20\t100
2\t\t0\t1700\t0\t0\t0\t0\t150\t20\t100
3\t\t0\t1700\t0\t-50\t30\t100
";

/// Puts the files there that the transcripts read.
fn furnish(folder: &Path) {
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures");
    for name in [
        "subject/subject.osim",
        "subject/walk.mot",
        "subject/grf.mot",
        "subject/loads.xml",
        "subject/soles.ron",
        "figures/arm.urdf",
        "clips/dancer.ron",
        "clips/dance.csv",
        "clips/walk.c3d",
        "markers/leg.osim",
        "markers/static.trc",
        "markers/swing.trc",
        "markers/swing_z_up.trc",
        "markers/scale.xml",
        "markers/ik.xml",
        "scenes/pendulum.ron",
        "scenes/arm_modes.ron",
        "scenes/walk_loose_arm.ron",
    ] {
        let from = fixtures.join(name);
        std::fs::copy(&from, folder.join(from.file_name().expect("a name"))).expect(name);
    }
    let arm = std::fs::read_to_string(folder.join("arm.urdf")).expect("there");
    let faulty = arm
        .replace("<mass value=\"2.0\"/>", "<mass value=\"2,0\"/>")
        .replace("<parent link=\"upper_arm\"/>", "<parent link=\"uper_arm\"/>");
    let pendulum = std::fs::read_to_string(folder.join("pendulum.ron")).expect("there");
    let stiff = arm.replace("upper=\"0.1\"", "upper=\"-0.1\"");
    for (name, text) in [
        ("faulty.urdf", faulty.as_str()),
        ("stiff.urdf", &stiff),
        ("swing.csv", SWING),
        ("tail.bvh", TAIL),
        ("tail.txt", "bone,kg\ntail,0.6\ntip,0.25\n"),
        ("cut.bvh", &TAIL.replace("0 102 0 14", "0 1o2 0 14")),
        ("reach.ron", REACH),
        (
            "faulty_scene.ron",
            &REACH.replace("\"elbow\": [Move", "\"elbw\": [Mve").replace("duration: 2.0", "duration: -2.0"),
        ),
        ("coarse.ron", &pendulum.replace("tolerance: 1e-8", "method: ExplicitEuler(step: 1e-2)")),
        (
            "faulty_soles.ron",
            "Soles(version: 1, soles: [\n    Sole(name: \"right\", foot: \"calc_r\", heel: (-0.05, -0.08, 0), \
             ball: (0.14, -0.08), tip: (0.21, -0.08, 0), widht: 0.1),\n])\n",
        ),
        ("falls.ron", "Scene(version: 1, figures: {\"it\": File(\"arm.urdf\")}, duration: 2.0)\n"),
        ("metres.trc", METRES),
        ("torn.trc", &METRES.replace("150\t20\t100\n3", "15O\t20\t100\n3")),
        ("notes", "no folder"),
        ("people.csv", PEOPLE),
        ("keys.csv", "time,position\n0,5\n1,7\n2,-9\n"),
        ("misspelt.ron", "// A motion.\nMinimumJrek(from: 0, to: 1, duration: 2)\n"),
        ("faulty.ron", "Tension(from: 0, to: 1, duration: 2,\n    stiffness: -3, end_velocity: 1)\n"),
    ] {
        std::fs::write(folder.join(name), text).expect("written");
    }
    std::fs::create_dir(folder.join("clips")).expect("made");
    std::fs::create_dir(folder.join("walk.csv")).expect("made");
}

#[test]
fn transcripts_hold() {
    // No transcript is no success: a folder that is not found would pass.
    let transcripts = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/cmd");
    let count = std::fs::read_dir(&transcripts).expect("the transcripts").count();
    assert!(count >= 10, "{count} transcripts");
    let folder = tempfile::tempdir().expect("a folder");
    furnish(folder.path());
    // The only test of this binary, which therefore stands beside `tests/cli`: nobody else asks for the folder.
    std::env::set_current_dir(folder.path()).expect("entered");
    let cases = trycmd::TestCases::new();
    cases.register_bin("solaris", Path::new(env!("CARGO_BIN_EXE_solaris")));
    cases.case(transcripts.join("*.trycmd"));
    // What the package shows of the program.
    cases.case(Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md"));
    cases.run();
}

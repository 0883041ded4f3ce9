//! TRC files, as they should be and as they are.

use solaris_io::markers::{LengthUnit, Recording};
use solaris_io::trc::{ReadOptions, read, write};
use solaris_model::{MarkerTrial, Vector3};

/// A file of two markers, HEAD and 'R Toe', with these lines for its frames.
fn file(frames: &str) -> String {
    let head = "PathFileType\t4\t(X/Y/Z)\twalk.trc\n\
        DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame\tOrigNumFrames\n\
        100\t100\t3\t2\tmm\t100\t1\t3\n\
        Frame#\tTime\tHEAD\t\t\tR Toe\t\t\n\
        \t\tX1\tY1\tZ1\tX2\tY2\tZ2\n\n";
    format!("{head}{frames}")
}

const FRAMES: &str = "7\t0.00\t100\t1700\t-50\t300\t20\t60\n\
    8\t0.01\t110\t1701\t-50\t310\t20\t60\n\
    9\t0.02\t120\t1702\t-50\t320\t20\t60\n";

fn of(text: &str) -> Recording {
    read(text, &ReadOptions::default()).unwrap_or_else(|fault| panic!("{fault}"))
}

fn said(recording: &Recording) -> Vec<String> {
    recording.findings.iter().map(ToString::to_string).collect()
}

#[test]
fn a_file_as_it_should_be_has_nothing_to_say() {
    let recording = of(&file(FRAMES));
    assert_eq!(said(&recording), Vec::<String>::new());
    assert_eq!(recording.markers.names(), ["HEAD", "R Toe"]);
    assert_eq!(
        (recording.rate, recording.first_frame, recording.unit),
        (Some(100.0), 7, LengthUnit::Millimetres)
    );
    assert_eq!(recording.markers.time(), [0.0, 0.01, 0.02]);
    assert_eq!(recording.markers.point(1, 1), Some(Vector3::new(310.0, 20.0, 60.0) * 1e-3));
}

#[test]
fn what_is_written_is_read_again() {
    let hidden = Vector3::repeat(f64::NAN);
    let points =
        vec![Vector3::new(0.1, 1.7, -0.05), hidden, Vector3::new(0.123_456_789, 1.71, 0.0), Vector3::x()];
    let names = vec!["head".to_owned(), "toe".to_owned()];
    let trial = MarkerTrial::new(names, vec![0.5, 0.508_333_333], points).expect("a trial");
    for unit in [LengthUnit::Millimetres, LengthUnit::Metres, LengthUnit::Centimetres] {
        let mut text = Vec::new();
        write(&trial, "a.trc", unit, &mut text).expect("written");
        let again = of(&String::from_utf8(text).expect("text"));
        assert_eq!(said(&again), Vec::<String>::new());
        assert_eq!((again.markers.names(), again.markers.time()), (trial.names(), trial.time()));
        for (frame, marker) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
            match (trial.point(frame, marker), again.markers.point(frame, marker)) {
                (Some(was), Some(is)) => assert!((was - is).norm() < 2e-9, "{was} {is}"),
                (was, is) => assert_eq!(was, is),
            }
        }
    }
}

/// Nine decimals made one time of two, which is not read.
#[test]
fn frames_nearer_than_a_nanosecond_are_read_again_apart() {
    for time in [vec![0.0, 2.1e-302, 0.04], vec![0.0, 5.6e-26, 1.1e-25], vec![1.0, 1.0_f64.next_up()]] {
        let points = vec![Vector3::new(0.1, 1.7, -0.05); time.len()];
        let trial = MarkerTrial::new(vec!["head".to_owned()], time.clone(), points).expect("a trial");
        let mut text = Vec::new();
        write(&trial, "a.trc", LengthUnit::Millimetres, &mut text).expect("written");
        assert_eq!(of(&String::from_utf8(text).expect("text")).markers.time(), time);
    }
}

#[test]
fn other_line_ends_marks_and_commas_change_nothing() {
    let plain = of(&file(FRAMES));
    let commas = file(FRAMES).replace("0.0", "0,0").replace("\t20\t", "\t20,0\t");
    for text in [
        file(FRAMES).replace('\n', "\r\n"),
        file(FRAMES).replace('\n', "\r"),
        format!("\u{feff}{}", file(FRAMES)),
        file(FRAMES).replace('\n', "\t\n"),
        file(FRAMES).replace("\n\n", "\n"),
        commas,
    ] {
        let recording = of(&text);
        assert_eq!(recording.markers.time(), plain.markers.time(), "{text:?}");
        for frame in 0..3 {
            assert_eq!(recording.markers.frame(frame), plain.markers.frame(frame), "{text:?}");
        }
    }
}

#[test]
fn blank_cells_and_ends_hide_a_marker() {
    let text = file("1\t0.00\t\t\t\t300\t20\t60\n2\t0.01\t100\t1700\t0\n3\t0.02\tNaN\tnan\tNaN\t300\t\t60\n");
    let recording = of(&text);
    let markers = &recording.markers;
    assert_eq!(
        (markers.point(0, 0), markers.point(1, 1), markers.point(2, 0), markers.point(2, 1)),
        (None, None, None, None)
    );
    assert_eq!((markers.seen(0), markers.seen(1)), (1, 1));
}

#[test]
fn zeros_of_a_marker_that_is_elsewhere_far_away_are_none() {
    let recording =
        of(&file("1\t0\t0\t0\t0\t0\t0\t0\n2\t0.01\t0\t1700\t0\t10\t20\t0\n3\t0.02\t0\t1700\t0\t30\t20\t0\n"));
    assert_eq!(recording.markers.point(0, 0), None);
    assert_eq!(recording.markers.point(0, 1), Some(Vector3::zeros()));
    assert_eq!(said(&recording).len(), 2, "{:?}", said(&recording));
}

#[test]
fn what_is_odd_is_read_and_said() {
    let cases = [
        ("counts that are wrong", file(FRAMES).replace("\t3\t2\tmm", "\t9\t5\tmm")),
        ("metres that are millimetres", file(FRAMES).replace("\tmm\t", "\tm\t")),
        ("a unit that is none", file(FRAMES).replace("\tmm\t", "\tells\t")),
        ("no header", file(FRAMES).lines().skip(3).collect::<Vec<_>>().join("\n")),
        (
            "names that stand twice, and none",
            file(FRAMES).replace("R Toe", "HEAD").replace("20\t60", "20\t60\t1\t2\t3"),
        ),
        ("names without their tabs", file(FRAMES).replace("HEAD\t\t\t", "HEAD\t")),
        ("no times", file("1\t\t100\t1700\t-50\t300\t20\t60\n2\t\t100\t1700\t-50\t300\t20\t60\n")),
        ("another rate", file(FRAMES).replace("100\t100\t3", "60\t60\t3")),
        ("half a place", file("1\t0\t100\t1700\t-50\t300\t\t60\n2\t0.01\t100\t1700\t-50\t300\t20\t60\n")),
        ("blanks for tabs", "Units\nmm\nFrame# Time a b\n X1 Y1 Z1 X2 Y2 Z2\n1 0 0 0 1 500 0 2\n".to_owned()),
    ];
    let told = cases.map(|(what, text)| {
        let recording = of(&text);
        let names = recording.markers.names().join(", ");
        format!(
            "{what}\n  {names}; {} Hz\n  {}",
            recording.rate.unwrap_or(0.0),
            said(&recording).join("\n  ")
        )
    });
    insta::assert_snapshot!(told.join("\n"));
}

#[test]
fn faults_are_answered_with_their_places() {
    let faults = [
        "nothing at all".to_owned(),
        String::new(),
        file("1\t0\t100\tfar\t-50\n"),
        file("1\tinf\t100\t1\t-50\n"),
        file("1\t0.01\t1\t2\t3\t4\t5\t6\n2\t0.01\t1\t2\t3\t4\t5\t6\n"),
        file("1\t\t1\t2\t3\t4\t5\t6\n").replace("100\t100", "\t100"),
        "Frame# Time a b\nX1 Y1 Z1 X2 Y2 Z2\n1 0 1 2 3\n".to_owned(),
        format!("Frame#\tTime{}\n{}", "\ta\t\t".repeat(2000), "1\t0\n".repeat(2000)),
    ]
    .map(|text| read(&text, &ReadOptions::default()).expect_err("a fault").to_string());
    insta::assert_snapshot!(faults.join("\n"));
}

/// 60 frames a second, written to the millisecond, are not 16.7 ms apart by themselves.
#[test]
fn rounded_times_are_counted_by_the_rate() {
    let rows = |times: &[f64]| {
        let row = |(i, t): (usize, &f64)| format!("{}\t{t:.3}\t100\t1700\t-50\t300\t20\t60\n", i + 1);
        file(&times.iter().enumerate().map(row).collect::<String>()).replace("100\t100\t3", "60\t60\t5")
    };
    for first in [25.0, 25.4] {
        let exact: Vec<f64> = (0..5).map(|frame| (first + f64::from(frame)) / 60.0).collect();
        let read = of(&rows(&exact));
        let steps = read.markers.time().windows(2).map(|pair| pair[1] - pair[0]);
        assert!(steps.clone().all(|step| (step - 1.0 / 60.0).abs() < 1e-12), "{:?}", read.markers.time());
        assert!((read.markers.time()[0] - exact[0]).abs() < 5.1e-4);
        assert!(said(&read).iter().any(|what| what.contains("rounded to 0.001 s")), "{:?}", said(&read));
    }
    // A frame that came late did come late.
    let late = of(&rows(&[0.0, 0.017, 0.036, 0.05, 0.067]));
    assert!((late.markers.time()[2] - 0.036).abs() < 1e-12);
}

#[test]
fn names_of_markers_are_read_back_or_not_written() {
    for name in [
        "heel",
        "a b",
        "a\u{feff}b",
        "größe",
        "\u{feff}heel",
        "heel\r",
        "a\nb",
        "a\tb",
        " heel",
        "\"heel\"",
        "",
    ] {
        let point = Vector3::new(0.1, 0.2, 0.3);
        let trial = MarkerTrial::new(vec![name.to_owned()], vec![0.0], vec![point]).expect("a trial");
        let (mut text, mut csv) = (Vec::new(), Vec::new());
        let written = write(&trial, "a\tb\r", LengthUnit::Metres, &mut text);
        let good = ["heel", "a b", "a\u{feff}b", "größe"].contains(&name);
        assert_eq!(written.is_ok(), good, "{name:?}");
        if good {
            let back = read(std::str::from_utf8(&text).expect("text"), &ReadOptions::default());
            assert_eq!(back.expect("a recording").markers.names(), [name]);
        }
        if solaris_io::markers::write_csv(&trial, &mut csv).is_ok() {
            let back =
                solaris_io::csv::read_table(std::str::from_utf8(&csv).expect("text")).expect("a table");
            assert_eq!(back.columns[1], format!("{name}.x"), "{name:?}");
        }
    }
}

/// Of markers of the legs alone, which are on one side of a floor at zero along more than one axis: up is where the pelvis is.
#[test]
fn legs_alone_stand_below_their_pelvis() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/markers/swing.trc");
    let text = std::fs::read_to_string(path).expect("a recording");
    let recording = read(&text, &ReadOptions::default()).expect("read");
    let (axes, findings) = solaris_io::markers::find_axes(&recording);
    assert!(axes.to_string().starts_with("y,"), "{axes}");
    assert!(findings[0].to_string().contains("as the pelvis is above the feet along it"), "{}", findings[0]);
}

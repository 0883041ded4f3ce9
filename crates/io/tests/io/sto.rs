//! Tables of OpenSim.

use solaris_io::{Table, sto};
use std::fmt::Write;

fn written(table: &Table) -> String {
    let mut bytes = Vec::new();
    sto::write(table, &mut bytes).expect("finite numbers and a vector");
    String::from_utf8(bytes).expect("text")
}

fn table() -> Table {
    Table {
        title: "a swing".to_owned(),
        in_degrees: Some(true),
        columns: ["time", "knee_angle_r", "pelvis_tx"].map(str::to_owned).to_vec(),
        values: vec![0.0, -0.0, 1.0 / 3.0, 0.1 + 0.2, f64::MAX, -5e-324, 1e-7, 1e22, 123_456_789.125],
        lines: vec![8, 9, 10],
        header_line: 7,
        ..Table::default()
    }
}

#[test]
fn a_table_reads_back_bit_for_bit() {
    let table = table();
    let back = sto::read(&written(&table)).expect("what was written");
    let bits = |table: &Table| table.values.iter().map(|value| value.to_bits()).collect::<Vec<_>>();
    assert_eq!((bits(&back), &back), (bits(&table), &table));
}

#[test]
fn a_table_looks_like_this() {
    insta::assert_snapshot!(written(&table()).replace('\t', " | "));
}

#[test]
fn titles_are_kept_whatever_they_begin_with() {
    for title in ["", "nRows=7", "endheader", "version of mine", "name", "two words"] {
        let table = Table { title: title.to_owned(), in_degrees: None, ..table() };
        let back = sto::read(&written(&table)).expect("what was written");
        assert_eq!((back.title.as_str(), back.in_degrees, back.len()), (title, None, 3));
    }
}

#[test]
fn headers_of_all_ages_are_read() {
    let motion = "Coordinates\nversion=1\nnRows=2\nnColumns=3\ninDegrees=yes\n\nUnits are S.I. units (second, meters, Newtons, ...)\n\
        Angles are in degrees.\n\nendheader\ntime\ta\tb\n      0.00000000\t     10.32995988\t 1\n 0.01\t2\t3\n";
    let read = sto::read(motion).expect("a motion");
    assert_eq!((read.title.as_str(), read.in_degrees, read.len()), ("Coordinates", Some(true), 2));
    assert_eq!((read.header_line, read.lines.as_slice(), read.row(0)[1]), (11, &[12, 13][..], 10.329_959_88));
    // Windows, trailing tabs, no title, blanks before the headings.
    let plates = "\u{feff}version=1\t\t\r\nnRows=1\t\t\r\nnColumns=2\t\r\ninDegrees=no\t\r\nendheader\t\r\n\r\ntime\tf\t\t\r\n0.5\t-1e3\t\t\r\n\r\n";
    let read = sto::read(plates).expect("a table");
    assert_eq!(
        (read.title.as_str(), read.in_degrees, read.values.as_slice()),
        ("", Some(false), &[0.5, -1000.0][..])
    );
    // SIMM, and files that say nothing of rows and columns.
    let simm = "name walk\ndatacolumns 2\ndatarows 1\notherdata 1\nrange 0.0 1.0\nendheader\ntime a\n0 1\n";
    assert_eq!(sto::read(simm).expect("a motion").title, "walk");
    let radians = "old\nAngles are in radians.\nendheader\ntime a\n0 1\n";
    assert_eq!(sto::read(radians).expect("a motion").in_degrees, Some(false));
    assert_eq!(sto::read("t\nendheader\ntime\n").expect("no rows").len(), 0);
    let spaced = "t\nnColumns=2\nendheader\ntime\tleft knee\n0\t1\n";
    assert_eq!(sto::read(spaced).expect("a heading of two words").columns[1], "left knee");
}

fn with(change: (&str, &str)) -> String {
    "t\nversion=1\nnRows=2\nnColumns=3\ninDegrees=no\nendheader\ntime\ta\tb\n0\t1\t2\n0.1\t3\t4\n"
        .replacen(change.0, change.1, 1)
}

#[test]
fn bad_tables_are_answered_with_line_and_column() {
    let cases = [
        ("empty", String::new()),
        ("blank", "\n \r\n".to_owned()),
        ("binary", "\u{0}\u{1}\u{2}\u{7f}".to_owned()),
        ("csv", "time,a.q\n0,1\n".to_owned()),
        ("no endheader", with(("endheader\n", ""))),
        ("ends after the header", "t\nendheader\n\n".to_owned()),
        ("nan", with(("0.1\t3", "0.1\tnan"))),
        ("infinity", with(("0.1\t3", "0.1\tinf"))),
        ("too large", with(("0.1\t3", "0.1\t1e999"))),
        ("a word", with(("0.1\t3", "0.1\tthree"))),
        ("a decimal comma", with(("0.1\t3", "0,1\t3"))),
        ("short row", with(("\t4", ""))),
        ("long row", with(("\t4", "\t4\t5"))),
        ("a gap", with(("0\t1\t2", "0\t\t2"))),
        ("cut off in a row", with(("0.1\t3\t4\n", "0.1\t3"))),
        ("rows are a word", with(("nRows=2", "nRows=two"))),
        ("rows are negative", with(("nRows=2", "nRows=-2"))),
        ("columns beyond numbers", with(("nColumns=3", "nColumns=99999999999999999999999"))),
        ("degrees perhaps", with(("inDegrees=no", "inDegrees=perhaps"))),
        ("empty heading", with(("time\ta\tb", "time\t\tb"))),
        ("no time", with(("time", "frame"))),
    ];
    let mut said = String::new();
    for (name, text) in cases {
        let error = sto::read(&text).err().map_or_else(|| "READ".to_owned(), |error| error.to_string());
        let _ = writeln!(said, "{name}: {error}");
    }
    assert!(!said.contains("READ"), "{said}");
    insta::assert_snapshot!(said);
}

/// What the notes of a table say.
fn notes(text: &str) -> String {
    let table = sto::read_mot(text).expect("odd, not wrong");
    table.notes.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}

#[test]
fn what_is_odd_is_read_and_noted() {
    let mut said = String::new();
    for (name, text) in [
        ("nothing odd", with(("t\n", "t\n"))),
        ("cut off", with(("0.1\t3\t4\n", ""))),
        ("more rows than told", with(("nRows=2", "nRows=1"))),
        ("other columns than told", with(("nColumns=3", "nColumns=4"))),
        ("heading twice", with(("\ta\tb", "\ta\ta"))),
        (
            "headings twice",
            with(("time\ta\tb\n0\t1\t2\n0.1\t3\t4", "time\ta\tb\ta\tb\n0 1 2 3 4\n1 2 3 4 5")),
        ),
        ("no version", with(("version=1\n", "")).replace("inDegrees=no\n", "")),
    ] {
        let _ = writeln!(said, "{name}: {}", notes(&text).trim_end());
    }
    insta::assert_snapshot!(said);
    // A heading that stands twice is there once.
    let twice = sto::read(&with(("\ta\tb", "\ta\ta"))).expect("odd");
    assert_eq!((twice.column("a"), twice.columns.len()), (Some(1), 3));
}

#[test]
fn a_mot_without_a_version_is_in_degrees() {
    let simm = "name walk\ndatacolumns 2\ndatarows 1\notherdata 1\nrange 0.0 1.0\nendheader\ntime a\n0 1\n";
    let told = |text: &str| sto::read_mot(text).expect("a motion").in_degrees;
    assert_eq!([told(simm), sto::read(simm).expect("a table").in_degrees], [Some(true), None]);
    assert_eq!(told(&simm.replace("name", "Angles are in radians.\nname")), Some(false));
    assert_eq!(told("t\nversion=1\nendheader\ntime a\n0 1\n"), None);
}

#[test]
fn blanks_tabs_and_capitals_do_not_matter() {
    let plain = sto::read(&with(("t\n", "t\n"))).expect("plain");
    for odd in [
        with(("endheader", "EndHeader")),
        with(("time\ta\tb", "time a \t b\t\t")),
        with(("0\t1\t2", "  0 1\t\t2\t ")),
        with(("t\n", "t\n")).replace('\n', "\r\n"),
        with(("time\ta", "\ttime\ta")),
    ] {
        let read = sto::read(&odd).unwrap_or_else(|error| panic!("{odd:?}: {error}"));
        assert_eq!((&read.columns, &read.values), (&plain.columns, &plain.values), "{odd:?}");
    }
}

#[test]
fn cells_of_vectors_are_columns_of_numbers() {
    let read = |kind: &str, heading: &str, row: &str| {
        let text =
            format!("DataRate=100\nDataType={kind}\nversion=3\nendheader\ntime\t{heading}\n0\t{row}\n");
        sto::read(&text)
    };
    let markers = read("Vec3", "head\tfoot", "1,2,3\t4,5,6").expect("markers");
    assert_eq!(markers.columns, ["time", "head.x", "head.y", "head.z", "foot.x", "foot.y", "foot.z"]);
    assert_eq!(markers.row(0), [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    let sensors = read("Quaternion", "pelvis_imu", "1,0,0,0").expect("sensors");
    assert_eq!(sensors.columns[1..], ["pelvis_imu.w", "pelvis_imu.x", "pelvis_imu.y", "pelvis_imu.z"]);
    let dressed = read("Vec3", "head\tknee", "~[1, 2,3]\t7").expect("as Simbody prints them");
    assert_eq!((dressed.columns.len(), dressed.row(0)), (5, &[0.0, 1.0, 2.0, 3.0, 7.0][..]));
    let wide = read("Vec4", "head", "1,2,3,4").expect("numbered");
    assert_eq!(wide.columns[4], "head.4");
    assert_eq!(
        markers.notes[0].to_string(),
        "its cells hold 3 numbers each (Vec3); 'head.x' and so on are columns of one"
    );
    for (row, why) in [("1,2\t3,x", "'x' is no finite number"), ("1,2", "2 fields"), ("1,2,3\t4", "fields")] {
        let text = format!("DataType=Vec2\nendheader\ntime\ta\tb\n0\t1,2\t3,4\n1\t{row}\n");
        let error = sto::read(&text).err().map(|error| error.to_string()).unwrap_or_default();
        assert!(error.contains(why) || error.contains("no finite number"), "{row}: {error}");
    }
}

#[test]
fn what_a_table_cannot_hold_is_not_written() {
    let refused = |table: Table| sto::write(&table, &mut Vec::new()).expect_err("refused").to_string();
    let mut not_finite = table();
    not_finite.values[4] = f64::NAN;
    let mut spaced = table();
    spaced.columns[1] = "left knee".to_owned();
    let mut twice = table();
    twice.columns[2] = "time".to_owned();
    let mut timeless = table();
    timeless.columns[0] = "frame".to_owned();
    insta::assert_snapshot!([not_finite, spaced, twice, timeless].map(refused).join("\n"));
}

/// Cells of several numbers are columns, but the time's.
#[test]
fn a_time_of_several_numbers_is_none() {
    let text = "DataType=Vec3\nendheader\ntime\tball\n0,0,0\t1,2,3\n0.1,0,0\t1,2,3\n";
    let error = sto::read(text).expect_err("no time").to_string();
    assert_eq!(error, "line 4, column 1 ('time'): '0,0,0' is no finite number");
    let text = "endheader\ntime\ta\tb\n0\t1\t1\t~[0\t0\n";
    assert_eq!(sto::read(text).expect_err("too long").to_string(), "line 3 has 4 fields, the header has 3");
}

/// A hundred thousand rows in well under a second.
#[test]
fn long_tables_are_read() {
    let mut text = "t\nnRows=100000\nnColumns=3\nendheader\ntime\ta\tb\n".to_owned();
    for i in 0..100_000 {
        let _ = writeln!(text, "{i}\t0.25\t-1e-3");
    }
    let table = sto::read(&text).expect("long, not wrong");
    assert_eq!((table.len(), table.lines[99_999]), (100_000, 100_005));
}

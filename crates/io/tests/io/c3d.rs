//! C3D files that the tests write themselves.

mod fixture;
mod plates;
mod writer;

use approx::assert_relative_eq;
use plates::{CENTRE, FORCE, FREE};
use solaris_io::c3d::{ReadOptions, read};
use solaris_io::markers::{Axes, LengthUnit, LoadOptions, Recording, find_axes, ground_forces};
use solaris_model::{FindingKind, Vector3};
use writer::{File, MACHINES, Machine, Value};

const FRAMES: usize = 5;
const PER_FRAME: usize = 4;

/// A head above two feet that goes along x; the toe is hidden in the second frame, and the plates bear the last frame.
fn trial(machine: Machine, is_real: bool) -> File {
    let point = |frame: usize, x: f64, y: f64, z: f64| Some([x + 500.0 * frame as f64, y, z]);
    let frames = (0..FRAMES).map(|frame| {
        let toe = point(frame, 150.0, 100.0, 20.0).filter(|_| frame != 1);
        vec![point(frame, 0.0, 0.0, 1700.5), point(frame, -50.0, 100.0, 30.0), toe]
    });
    let (signals, parameters) = plates::four(FRAMES * PER_FRAME, |at| at >= (FRAMES - 1) * PER_FRAME);
    let mut file = File {
        machine,
        is_real,
        scale: 0.1,
        rate: 50.0,
        first: 1,
        labels: ["HEAD", "RHEEL", "RTOE"].map(str::to_owned).to_vec(),
        frames: frames.collect(),
        per_frame: PER_FRAME,
        signals,
        parameters,
    };
    file.parameters.extend([
        ("EVENT", "USED", Value::Words(vec![], vec![2])),
        ("EVENT", "TIMES", Value::Reals(vec![2, 2], vec![0.0, 0.02, 1.0, 0.5])),
        ("EVENT", "LABELS", texts(&["Foot Strike", "Foot Off"])),
        ("EVENT", "CONTEXTS", texts(&["Right", "Left"])),
    ]);
    file
}

fn texts(all: &[&str]) -> Value {
    Value::Texts(all.iter().map(|text| (*text).to_owned()).collect())
}

fn read_file(file: &File) -> Recording {
    read(&file.write(), &ReadOptions::default()).expect("the file is read")
}

fn said(recording: &Recording) -> String {
    recording.findings.iter().map(ToString::to_string).collect::<Vec<_>>().join("\n")
}

#[test]
fn one_trial_is_the_same_in_six_encodings() {
    for machine in MACHINES {
        for is_real in [false, true] {
            let recording = read_file(&trial(machine, is_real));
            let markers = &recording.markers;
            assert_eq!(markers.names(), ["HEAD", "RHEEL", "RTOE"], "{machine:?} {is_real}");
            assert_eq!(
                (markers.len(), recording.rate, recording.unit),
                (FRAMES, Some(50.0), LengthUnit::Millimetres)
            );
            let head = markers.point(2, 0).expect("seen");
            assert_relative_eq!(head, Vector3::new(1.0, 0.0, 1.7005), epsilon = 1e-6);
            assert_eq!(markers.point(1, 2), None);
            assert_eq!(markers.seen(2), FRAMES - 1);
            assert_relative_eq!(recording.residuals[0], 0.3e-3, epsilon = 1e-9);
            assert!(recording.residuals[5].is_nan());
            let event = &recording.events[1];
            assert_eq!((event.label.as_str(), event.context.as_str()), ("Foot Off", "Left"));
            assert_relative_eq!(event.time, 60.5, epsilon = 1e-6);
            let channel = &recording.analog[2];
            assert_eq!((channel.label.as_str(), channel.unit.as_str(), channel.rate), ("P1C2", "N", 200.0));
            assert_relative_eq!(channel.samples[19], FORCE.z, epsilon = 1e-3);
        }
    }
}

#[test]
fn plates_of_four_types_say_the_same_load() {
    for machine in MACHINES {
        for is_real in [false, true] {
            let recording = read_file(&trial(machine, is_real));
            let kinds: Vec<u8> = recording.plates.iter().map(|plate| plate.kind.number()).collect();
            assert_eq!(kinds, [1, 2, 3, 4]);
            let (force, centre) = if is_real { (1e-3, 1e-5) } else { (0.15, 1e-3) };
            for (at, plate) in recording.plates.iter().enumerate() {
                let loads = plate.loads(&LoadOptions::default());
                assert_eq!(loads.len(), FRAMES * PER_FRAME);
                assert_eq!((loads[15].centre, loads[15].force), (None, Vector3::zeros()), "unloaded");
                let load = loads[16];
                let turn = plates::axes();
                assert_relative_eq!(load.force, turn * FORCE, epsilon = force);
                let found = load.centre.expect("loaded");
                assert_relative_eq!(found, turn * CENTRE + plates::middle(at), epsilon = centre);
                assert_relative_eq!(load.free_moment, turn * FREE, epsilon = 100.0 * centre);
            }
        }
    }
}

#[test]
fn an_origin_above_the_surface_is_turned_round_and_said() {
    let recording = read_file(&trial(Machine::Intel, true));
    assert!(said(&recording).contains("force plate 4: its origin points to above"), "{}", said(&recording));
    assert_relative_eq!(recording.plates[3].origin.z, -0.04, epsilon = 1e-9);
}

#[test]
fn moments_have_the_unit_that_their_channel_names() {
    let mut file = trial(Machine::Intel, true);
    for signal in
        file.signals.iter_mut().filter(|signal| signal.label.starts_with("P2") && signal.unit == "Nmm")
    {
        signal.unit = "N.m".to_owned();
        signal.samples.iter_mut().for_each(|value| *value *= 1e-3);
    }
    let plates = read_file(&file).plates;
    let centre = plates[1].loads(&LoadOptions::default())[17].centre.expect("loaded");
    assert_relative_eq!(centre, plates::axes() * CENTRE + plates::middle(1), epsilon = 1e-5);
}

#[test]
fn an_empty_plate_that_shows_something_is_taken_off() {
    let mut file = trial(Machine::Intel, true);
    for signal in file.signals.iter_mut().filter(|signal| signal.label == "P2C2") {
        signal.samples.iter_mut().for_each(|value| *value -= 40.0);
    }
    let plate = &read_file(&file).plates[1];
    assert_eq!(plate.baseline, Some(0..PER_FRAME));
    let bare = plate.loads(&LoadOptions::default());
    assert_relative_eq!(bare[16].force.z, 540.0, epsilon = 1e-3);
    let off = plate.loads(&LoadOptions { subtract_baseline: true, ..LoadOptions::default() });
    assert_relative_eq!(off[16].force.z, 500.0, epsilon = 1e-3);
    assert_eq!(off[0].centre, None);
}

#[test]
fn kistlers_polynomial_moves_the_centre_alone() {
    let mut file = trial(Machine::Intel, true);
    // Δx = 0.1 x of plate 3, and nothing of y.
    let mut polynomials = vec![0.0; 48];
    polynomials[24 + 5] = 0.1;
    file.parameters.push(("FORCE_PLATFORM", "FPCOPPOLY", Value::Reals(vec![6, 2, 4], polynomials)));
    let plate = &read_file(&file).plates[2];
    let load = plate.loads(&LoadOptions::default())[16];
    let moved = Vector3::new(0.9 * CENTRE.x, CENTRE.y, 0.0);
    assert_relative_eq!(
        load.centre.expect("loaded"),
        plates::axes() * moved + plates::middle(2),
        epsilon = 1e-5
    );
}

#[test]
fn plates_of_other_types_are_named() {
    let mut file = trial(Machine::Intel, false);
    file.parameters.retain(|(_, name, _)| *name != "TYPE");
    file.parameters.push(("FORCE_PLATFORM", "TYPE", Value::Words(vec![4], vec![5, 6, 21, 4])));
    let recording = read_file(&file);
    assert_eq!(recording.plates.iter().map(|plate| plate.number).collect::<Vec<_>>(), [4]);
    assert!(said(&recording).contains("it is of type 21 (AMTI's stairs"), "{}", said(&recording));
}

#[test]
fn results_of_models_are_no_markers_and_names_become_their_own() {
    let mut file = trial(Machine::Intel, false);
    file.labels = ["Anna:HEAD", "Anna:HEAD", "KneeAngle"].map(str::to_owned).to_vec();
    file.parameters.push(("POINT", "ANGLES", texts(&["KneeAngle"])));
    let recording = read_file(&file);
    assert_eq!(recording.markers.names(), ["HEAD", "HEAD_2"]);
    assert!(said(&recording).contains("1 of 3 are results of a model"));
}

#[test]
fn names_and_frames_go_on_where_a_byte_or_a_word_is_not_enough() {
    let mut file = trial(Machine::Intel, false);
    file.first = 101;
    file.parameters.extend([
        ("POINT", "LABELS", texts(&["HEAD"])),
        ("POINT", "LABELS2", texts(&["RHEEL", "RTOE"])),
        ("TRIAL", "ACTUAL_START_FIELD", Value::Words(vec![2], vec![4, 1])),
        ("TRIAL", "ACTUAL_END_FIELD", Value::Words(vec![2], vec![8, 1])),
    ]);
    let recording = read_file(&file);
    assert_eq!(recording.markers.names(), ["HEAD", "RHEEL", "RTOE"]);
    assert_eq!((recording.first_frame, recording.markers.len()), (65540, FRAMES));
    assert_relative_eq!(recording.markers.time()[0], 0.0);
    assert_relative_eq!(recording.events[0].time, 0.02 - 65539.0 / 50.0, epsilon = 1e-6);
}

#[test]
fn a_unit_in_which_nobody_has_that_size_is_corrected_unless_it_is_named() {
    let mut file = trial(Machine::Intel, false);
    file.parameters.push(("POINT", "UNITS", texts(&["m"])));
    let recording = read_file(&file);
    assert_eq!(recording.unit, LengthUnit::Millimetres);
    assert!(said(&recording).contains("unit: the file says m"), "{}", said(&recording));
    let head = recording.markers.point(0, 0).expect("seen");
    assert_relative_eq!(head.z, 1.7005, epsilon = 1e-6);
    let asked = ReadOptions { unit: Some(LengthUnit::Centimetres) };
    let recording = read(&file.write(), &asked).expect("read");
    assert_relative_eq!(recording.markers.point(0, 0).expect("seen").z, 17.005, epsilon = 1e-5);
}

#[test]
fn the_laboratory_is_turned_into_the_axes_of_opensim() {
    let recording = read_file(&trial(Machine::Mips, true));
    let (axes, findings) = find_axes(&recording);
    assert_eq!(axes.to_string(), "z,x");
    assert!(findings.iter().all(|finding| finding.kind == FindingKind::Note));
    let turned = recording.turned(&axes, &Axes::OPENSIM);
    let head = turned.markers.point(2, 0).expect("seen");
    assert_relative_eq!(head, Vector3::new(1.0, 1.7005, 0.0), epsilon = 1e-6);
    let load = turned.plates[1].loads(&LoadOptions::default())[16];
    assert_relative_eq!(load.force, Vector3::new(-20.0, 500.0, -10.0), epsilon = 1e-3);
    let table = ground_forces(&turned.plates, &LoadOptions::default()).expect("plates");
    let value = |heading: &str| table.row(16)[table.column(heading).expect(heading)];
    assert_relative_eq!(value("ground_force_2_vy"), 500.0, epsilon = 1e-3);
    assert_relative_eq!(value("ground_force_2_pz"), -0.3, epsilon = 1e-4);
    assert_relative_eq!(value("ground_torque_2_y"), -3.0, epsilon = 1e-3);
    let found = solaris_io::record::forces(&table, &["a".into(), "b".into(), "c".into(), "d".into()], "2");
    assert!(found.is_ok(), "{found:?}");
}

#[test]
fn plates_that_hold_what_the_subject_does_are_turned_round() {
    let mut file = trial(Machine::Intel, true);
    for signal in &mut file.signals {
        let is_place = signal.label == "P1C3" || signal.label == "P1C4";
        signal.samples.iter_mut().filter(|_| !is_place).for_each(|value| *value = -*value);
    }
    let axes: Axes = "z,x".parse().expect("axes");
    let turned = read_file(&file).turned(&axes, &Axes::OPENSIM);
    for plate in &turned.plates {
        assert_relative_eq!(plate.loads(&LoadOptions::default())[16].force.y, 500.0, epsilon = 1e-3);
    }
    assert!(said(&turned).contains("it pushes down with 500 N"), "{}", said(&turned));
}

#[test]
fn faults_name_the_field_its_value_and_its_byte() {
    let refused = |change: &dyn Fn(&mut Vec<u8>)| {
        let mut bytes = trial(Machine::Intel, false).write();
        change(&mut bytes);
        read(&bytes, &ReadOptions::default()).map(|read| said(&read)).expect_err("a fault").to_string()
    };
    let mut all = vec![
        refused(&|bytes| bytes[1] = 0x4b),
        refused(&|bytes| bytes[0] = 0),
        refused(&|bytes| bytes[515] = 1),
        refused(&|bytes| bytes.truncate(514)),
        refused(&|bytes| bytes[16] = 0xff),
        refused(&|bytes| bytes.truncate(2560)),
    ];
    let mut file = trial(Machine::Intel, false);
    file.parameters.push(("POINT", "RATE", Value::Reals(vec![], vec![-2.0])));
    file.rate = 0.0;
    all.push(read(&file.write(), &ReadOptions::default()).expect_err("no rate").to_string());
    insta::assert_snapshot!(all.join("\n"));
}

#[test]
fn a_file_that_was_cut_off_is_read_as_far_as_it_goes() {
    let mut bytes = trial(Machine::Dec, false).write();
    bytes.truncate(bytes.len() - 100);
    let recording = read(&bytes, &ReadOptions::default()).expect("read");
    assert_eq!(recording.markers.len(), FRAMES - 1);
    assert!(said(&recording).contains("the 4 by the file's length are read"), "{}", said(&recording));
}

#[test]
fn broken_bytes_never_panic() {
    let whole = trial(Machine::Intel, false).write();
    let options = ReadOptions::default();
    for length in (0..whole.len()).step_by(7) {
        let _ = read(&whole[..length], &options);
    }
    for at in (0..whole.len().min(4096)).filter(|at| !(24..512).contains(at)) {
        for value in [0, 1, 0x7f, 0x80, 0xff] {
            let mut bytes = whole.clone();
            bytes[at] = value;
            if let Ok(recording) = read(&bytes, &options) {
                for plate in &recording.plates {
                    let _ = plate.loads(&LoadOptions { subtract_baseline: true, ..LoadOptions::default() });
                }
            }
        }
    }
}

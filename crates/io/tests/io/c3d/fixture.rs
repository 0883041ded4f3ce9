//! The file of `fixtures/clips`, which the command line is tried on.

use super::writer::{File, Machine, Signal, Value};
use std::f64::consts::PI;
use std::path::Path;

const FRAMES: usize = 60;
const PER_FRAME: usize = 2;

/// Nine markers of somebody who goes 1.18 m along −y, over two plates of type 2.
fn walk() -> File {
    let labels = ["HEAD", "LSHO", "RSHO", "LASI", "RASI", "LHEE", "LTOE", "RHEE", "RTOE"];
    let places = [
        (0.0, 0.0, 1680.0),
        (180.0, 0.0, 1400.0),
        (-180.0, 0.0, 1400.0),
        (120.0, -80.0, 980.0),
        (-120.0, -80.0, 980.0),
        (90.0, 60.0, 40.0),
        (100.0, -140.0, 30.0),
        (-90.0, 60.0, 40.0),
        (-100.0, -140.0, 30.0),
    ];
    let frame = |frame: usize| {
        let way = -20.0 * frame as f64;
        let place = |marker: usize, (x, y, z): (f64, f64, f64)| {
            // The right shoulder is hidden for a while, and the left toe at the end.
            let is_hidden = marker == 2 && (20..27).contains(&frame) || marker == 6 && frame > 55;
            (!is_hidden).then_some([x, y + way, z])
        };
        places.iter().enumerate().map(|(marker, at)| place(marker, *at)).collect()
    };
    let mut signals = Vec::new();
    for (plate, (start, end)) in [(0.1, 0.75), (0.55, 1.15)].into_iter().enumerate() {
        let load = |at: usize| {
            let phase = (at as f64 / 100.0 - start) / (end - start);
            if (0.0..1.0).contains(&phase) { 720.0 * (PI * phase).sin() } else { 0.0 }
        };
        // Along x, y, z of the plate, of which z points down.
        for (place, (part, unit, scale)) in [
            (0.02, "N", 0.05),
            (0.05, "N", 0.05),
            (-1.0, "N", 0.05),
            (-30.0, "Nmm", 2.0),
            (12.0, "Nmm", 2.0),
            (4.0, "Nmm", 2.0),
        ]
        .into_iter()
        .enumerate()
        {
            let name = ["Fx", "Fy", "Fz", "Mx", "My", "Mz"][place];
            signals.push(Signal {
                label: format!("{name}{}", plate + 1),
                unit: unit.to_owned(),
                scale,
                offset: 0,
                samples: (0..FRAMES * PER_FRAME).map(|at| part * load(at)).collect(),
            });
        }
    }
    let corners = |y: f64| {
        [[232.0, y + 254.0, 0.0], [232.0, y - 254.0, 0.0], [-232.0, y - 254.0, 0.0], [-232.0, y + 254.0, 0.0]]
            .concat()
    };
    let texts = |all: &[&str]| Value::Texts(all.iter().map(|text| (*text).to_owned()).collect());
    File {
        machine: Machine::Intel,
        is_real: false,
        scale: 0.1,
        rate: 50.0,
        first: 11,
        labels: labels.map(|label| format!("Walker:{label}")).to_vec(),
        frames: (0..FRAMES).map(frame).collect(),
        per_frame: PER_FRAME,
        signals,
        parameters: vec![
            ("FORCE_PLATFORM", "USED", Value::Words(vec![], vec![2])),
            ("FORCE_PLATFORM", "TYPE", Value::Words(vec![2], vec![2, 2])),
            ("FORCE_PLATFORM", "ZERO", Value::Words(vec![2], vec![1, 4])),
            (
                "FORCE_PLATFORM",
                "CORNERS",
                Value::Reals(vec![3, 4, 2], [corners(-250.0), corners(-800.0)].concat()),
            ),
            ("FORCE_PLATFORM", "ORIGIN", Value::Reals(vec![3, 2], vec![0.0, 0.0, -40.0, 0.0, 0.0, 40.0])),
            ("FORCE_PLATFORM", "CHANNEL", Value::Words(vec![6, 2], (1..=12).collect())),
            ("EVENT", "USED", Value::Words(vec![], vec![2])),
            ("EVENT", "TIMES", Value::Reals(vec![2, 2], vec![0.0, 0.3, 0.0, 0.75])),
            ("EVENT", "LABELS", texts(&["Foot Strike", "Foot Strike"])),
            ("EVENT", "CONTEXTS", texts(&["Right", "Left"])),
        ],
    }
}

/// `BLESS=1 cargo test -p solaris-io --features c3d fixture` writes it.
#[test]
fn the_fixture_is_what_is_written_here() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fixtures/clips/walk.c3d");
    let bytes = walk().write();
    if std::env::var_os("BLESS").is_some() {
        std::fs::write(&path, &bytes).expect("written");
    }
    assert!(std::fs::read(&path).expect("there") == bytes, "{} differs; BLESS=1 writes it", path.display());
}

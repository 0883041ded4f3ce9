//! What is done with a recording of markers.

use crate::said;
use solaris_io::markers::{Axes, LengthUnit, LoadOptions, Recording, find_axes, ground_forces};
use solaris_io::trc;

/// Looks at a recording as `solaris check` does, turns it, and writes it as `solaris convert` does.
pub fn recording(source: &str, recording: &Recording) {
    recording.findings.iter().for_each(|finding| said(source, &finding.message));
    let (axes, findings) = find_axes(recording);
    findings.iter().for_each(|finding| said(source, &finding.message));
    let turned = recording.clone().turned(&axes, &Axes::OPENSIM);
    assert_eq!(turned.markers.len(), recording.markers.len());
    if let Some(table) = ground_forces(&turned.plates, &LoadOptions::default()) {
        assert!(table.values.iter().all(|value| !value.is_nan()), "a force that is no number");
    }
    let mut written = Vec::new();
    match trc::write(&turned.markers, "again", LengthUnit::Millimetres, &mut written) {
        Ok(()) => {
            let written = std::str::from_utf8(&written).expect("text");
            match trc::read(written, &trc::ReadOptions { unit: Some(LengthUnit::Millimetres) }) {
                Ok(again) => assert_eq!(again.markers.names(), turned.markers.names(), "names of\n{written}"),
                Err(error) => panic!("what was written is not read: {error}\n{written}"),
            }
        }
        Err(error) => crate::refused(&error),
    }
}

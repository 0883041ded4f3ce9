//! Setups of OpenSim's tools for markers: to scale, and to follow markers.
#![no_main]

use solaris_fuzz::{refused, said, target, text};
use solaris_io::opensim::{self, CoordinateTask, MarkerTask, TaskValue};

target!(|bytes: &[u8]| {
    let Some(source) = text(bytes) else { return };
    match opensim::ik_setup(&source) {
        Ok(setup) => {
            setup.findings.iter().for_each(|finding| said(&source, &finding.message));
            tasks(&setup.markers, &setup.coordinates);
            range(setup.time_range);
        }
        Err(error) => refused(&error),
    }
    match opensim::scale_setup(&source) {
        Ok(setup) => {
            setup.findings.iter().for_each(|finding| said(&source, &finding.message));
            assert!(setup.mass.is_none_or(|mass| mass.is_finite() && mass > 0.0), "{:?} kg", setup.mass);
            for manual in &setup.manual {
                assert!(manual.factors.iter().all(|x| x.is_finite()), "{manual:?}");
            }
            range(setup.time_range);
            if let Some(placer) = &setup.placer {
                tasks(&placer.markers, &placer.coordinates);
                range(placer.time_range);
            }
        }
        Err(error) => refused(&error),
    }
});

/// Panics where a weight or a value is no number.
fn tasks(markers: &[MarkerTask], coordinates: &[CoordinateTask]) {
    for marker in markers {
        assert!(marker.weight.is_finite(), "{marker:?}");
    }
    for coordinate in coordinates {
        let value = if let TaskValue::Manual(value) = coordinate.value { value } else { 0.0 };
        assert!(coordinate.weight.is_finite() && value.is_finite(), "{coordinate:?}");
    }
}

/// Panics where times are none; they may be all there are.
fn range(times: Option<(f64, f64)>) {
    assert!(times.is_none_or(|(from, to)| from <= to), "{times:?}");
}

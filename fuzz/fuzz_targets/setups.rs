//! Setups of OpenSim's tools for markers: to scale, and to follow markers.
#![no_main]

use solaris_fuzz::{refused, target, text};
use solaris_io::opensim;

target!(|bytes: &[u8]| {
    let Some(source) = text(bytes) else { return };
    match opensim::ik_setup(&source) {
        Ok(setup) => assert!(!format!("{setup:?}").contains("NaN"), "{setup:?}"),
        Err(error) => refused(&error),
    }
    match opensim::scale_setup(&source) {
        Ok(setup) => assert!(!format!("{setup:?}").contains("NaN"), "{setup:?}"),
        Err(error) => refused(&error),
    }
});

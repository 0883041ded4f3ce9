//! Models of OpenSim, and where they say that their coordinates are.
#![no_main]

use solaris_fuzz::{import, target, text};
use solaris_io::opensim;

target!(|bytes: &[u8]| {
    if let Some(text) = text(bytes) {
        let defaults = opensim::coordinate_defaults(&text);
        assert!(defaults.iter().all(|default| default.value.is_finite()), "{defaults:?}");
        import(&text, opensim::read(&text));
    }
});

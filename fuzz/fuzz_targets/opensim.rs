//! Models of OpenSim, where they say that their coordinates are, their markers, their text scaled.
#![no_main]

use solaris_fuzz::{import, target, text};
use solaris_io::opensim::{self, Rescaling};
use solaris_model::Vector3;

target!(|bytes: &[u8]| {
    if let Some(text) = text(bytes) {
        let defaults = opensim::coordinate_defaults(&text);
        assert!(defaults.iter().all(|default| default.value.is_finite()), "{defaults:?}");
        let read = opensim::read(&text);
        if let Ok(found) = &read {
            let _ = opensim::markers(&text, &found.figure);
            let factors =
                found.figure.links().iter().map(|link| (link.name().to_owned(), Vector3::new(1.1, 0.9, 1.0)));
            let rescaling = Rescaling { factors: factors.collect(), ..Rescaling::default() };
            let _ = opensim::rescale(&text, &rescaling);
        }
        import(&text, read);
    }
});

//! Profiles as text: read, written, read, and asked where they are.
#![no_main]

use solaris_fuzz::{refused, target};
use solaris_profiles::{Answers, Curve, text};

target!(|bytes: &[u8]| {
    let Ok(source) = std::str::from_utf8(bytes) else { return };
    let _ = text::read_layer(source);
    let profile = match text::read(source) {
        Ok(profile) => profile,
        Err(error) => return refused(&error),
    };
    let written = text::write(&profile);
    assert_eq!(text::read(&written).as_ref(), Ok(&profile), "written and read:\n{written}");
    match profile.curve::<f64>() {
        Ok(curve) => {
            for share in [0.0, 0.3, 0.5, 1.0] {
                let found = curve.at(share * curve.duration());
                assert!(!found.position.is_nan(), "{found:?} after {share} of\n{written}");
            }
            let _ = (curve.peaks(), curve.is_monotone());
        }
        Err(error) => refused(&error),
    }
});

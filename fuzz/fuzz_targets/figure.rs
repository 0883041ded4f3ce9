//! Figures as text.
#![no_main]

use solaris_fuzz::{figure, refused, target};
use solaris_model::text;

target!(|bytes: &[u8]| {
    let Ok(source) = std::str::from_utf8(bytes) else { return };
    match text::read(source) {
        Ok(found) => figure(source, &found),
        Err(error) => refused(&error),
    }
});

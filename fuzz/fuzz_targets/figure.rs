//! Figures as text, and soles.
#![no_main]

use solaris_fuzz::{figure, refused, target};
use solaris_model::{Figure, human, text};
use std::sync::LazyLock;

static HUMAN: LazyLock<Figure> = LazyLock::new(|| human(1.75, 73.0).expect("a person"));

target!(|bytes: &[u8]| {
    let Ok(source) = std::str::from_utf8(bytes) else { return };
    match text::read(source) {
        Ok(found) => figure(source, &found),
        Err(error) => refused(&error),
    }
    match solaris_scene::read_soles(source, &HUMAN) {
        Ok(soles) => assert!(!soles.is_empty()),
        Err(error) => refused(&error),
    }
});

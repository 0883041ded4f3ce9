//! Soles as text, of a person.
#![no_main]

use solaris_fuzz::{refused, target};
use solaris_model::{Figure, human};
use std::sync::LazyLock;

static HUMAN: LazyLock<Figure> = LazyLock::new(|| human(1.75, 73.0).expect("a person"));

target!(|bytes: &[u8]| {
    let Ok(source) = std::str::from_utf8(bytes) else { return };
    match solaris_scene::read_soles(source, &HUMAN) {
        Ok(soles) => {
            assert!(!soles.is_empty());
            let said = format!("{soles:?}");
            assert!(!said.contains("NaN") && !said.contains("inf"), "{said}");
        }
        Err(error) => refused(&error),
    }
});

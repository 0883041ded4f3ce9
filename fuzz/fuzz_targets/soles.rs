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
            for sole in &soles {
                let mut numbers = [sole.heel, sole.ball, sole.tip]
                    .into_iter()
                    .flat_map(|point| [point.x, point.y, point.z]);
                assert!(numbers.all(f64::is_finite) && sole.width.is_none_or(f64::is_finite), "{sole:?}");
            }
        }
        Err(error) => refused(&error),
    }
});

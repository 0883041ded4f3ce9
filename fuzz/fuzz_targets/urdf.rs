//! Robots as URDF.
#![no_main]

use solaris_fuzz::{import, target, text};
use solaris_io::urdf;

target!(|bytes: &[u8]| {
    if let Some(text) = text(bytes) {
        import(&text, urdf::read(&text));
    }
});

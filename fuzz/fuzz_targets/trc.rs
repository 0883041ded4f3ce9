//! Markers as TRC: read, turned, and written again.
#![no_main]

use solaris_fuzz::{recording, refused, target, text};
use solaris_io::trc::{ReadOptions, read};

target!(|bytes: &[u8]| {
    let Some(source) = text(bytes) else { return };
    match read(&source, &ReadOptions::default()) {
        Ok(found) => recording(&source, &found),
        Err(error) => refused(&error),
    }
});

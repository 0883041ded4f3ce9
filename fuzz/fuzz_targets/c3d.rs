//! Markers and force plates as C3D: read, turned, and written as TRC.
#![no_main]

use solaris_fuzz::{recording, refused, target};
use solaris_io::c3d::{ReadOptions, read};

target!(|bytes: &[u8]| {
    match read(bytes, &ReadOptions::default()) {
        // Its bytes may hold numbers that are none.
        Ok(found) => recording("nan", &found),
        Err(error) => refused(&error),
    }
});

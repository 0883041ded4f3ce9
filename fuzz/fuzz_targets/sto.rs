//! Tables of OpenSim.
#![no_main]

use solaris_fuzz::{refused, table, target};
use solaris_io::sto;

target!(|bytes: &[u8]| {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    for read in [sto::read, sto::read_mot] {
        match read(text) {
            Ok(found) => table(text, &found),
            Err(error) => refused(&error),
        }
    }
});

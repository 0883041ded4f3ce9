//! Models and worlds of Gazebo with the files that they name, each after a line `==== NAME`.
#![no_main]

use solaris_fuzz::{Files, import, target, text};
use solaris_io::sdf;

target!(|bytes: &[u8]| {
    let mut files = Files::of(bytes);
    if let Some(main) = text(files.main) {
        import(&String::from_utf8_lossy(bytes), sdf::read_with(&main, &mut files));
    }
});

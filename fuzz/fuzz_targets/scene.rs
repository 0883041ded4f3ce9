//! Scenes as text: read, their walks planned, checked, and not run.
#![no_main]

use solaris_fuzz::{figure, refused, target};
use solaris_scene::NoFiles;

target!(|bytes: &[u8]| {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    match solaris_scene::read(text, &mut NoFiles) {
        Ok(scene) => {
            figure(text, scene.figure());
            if let Err(error) = scene.check() {
                refused(&error);
            }
        }
        Err(error) => refused(&error),
    }
});

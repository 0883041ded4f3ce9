//! Models of MuJoCo with the files that they name, each after a line `==== NAME`.
#![no_main]

use solaris_fuzz::{Files, figure, refused, said, target, text};
use solaris_io::mjcf::{self, Loaded};

target!(|bytes: &[u8]| {
    let mut files = Files::of(bytes);
    let Some(main) = text(files.main) else { return };
    let source = String::from_utf8_lossy(bytes);
    match mjcf::read_with(&main, &mut files) {
        Ok(Loaded { import, .. }) => {
            import.findings.iter().for_each(|finding| said(&source, &finding.message));
            figure(&source, &import.figure.with_gravity(import.gravity).expect("finite numbers"));
        }
        Err(error) => refused(&error),
    }
});

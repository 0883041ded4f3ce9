//! Tables as CSV: of numbers, of words, of a figure's motion.
#![no_main]

use solaris_fuzz::{refused, table, target};
use solaris_io::csv;
use solaris_model::{FigureBuilder, Joint, LinkSpec, MotionInfo};

target!(|bytes: &[u8]| {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    match csv::read_table(text) {
        Ok(found) => table(text, &found),
        Err(error) => refused(&error),
    }
    let _ = csv::read_rows(text);
    let rate = csv::frame_rate(text).ok().flatten().unwrap_or(100.0);
    let root = LinkSpec::root("base", Joint::new("root").tx().named("slide").rx().named("hip")).mass(1.0);
    let figure = FigureBuilder::new("two").link(root).build().expect("a valid figure");
    if let Ok(motion) = csv::read(&figure, text, MotionInfo::on_earth(&figure, rate)) {
        assert!(!motion.columns().concat().iter().any(|x| x.is_nan()));
    }
});

//! Pages and pictures of a motion of which all names, and the title, are any text: no markup of theirs, no control characters.
#![no_main]

use solaris_fuzz::{Chosen, refused, target};
use solaris_model::{FigureBuilder, Joint, LinkSpec, Motion, MotionInfo, Vector3};
use solaris_view::{Effort, PageOptions, TableRow, efforts, page, picture_page};

target!(|bytes: &[u8]| {
    let mut chosen = Chosen(bytes);
    let root = LinkSpec::root(chosen.name(), Joint::new(chosen.name()).rx().named(chosen.name())).mass(1.0);
    let Ok(figure) = FigureBuilder::new(chosen.name()).link(root.tip(Vector3::y())).build() else { return };
    let info = MotionInfo::on_earth(&figure, 10.0);
    let columns = [vec![0.0, 0.1], vec![1.0; 2], vec![0.0; 2]];
    let Ok(motion) = Motion::new(&figure, info, vec![0.0, 0.1], columns) else { return };
    let name = chosen.name();
    let options = PageOptions {
        title: chosen.name(),
        table: vec![TableRow::new(chosen.name(), chosen.name(), chosen.name(), chosen.name())],
        bands: chosen.name(),
        ..PageOptions::default()
    };
    match page(&figure, &motion, &options) {
        Ok(page) => clean(&page),
        Err(error) => refused(&error),
    }
    let effort = Effort { name: chosen.name(), unit: chosen.name(), values: vec![1.0, 2.0], spread: None };
    let picture = efforts(&[0.0, 0.1], &[effort], &[], &[], &name);
    clean(&picture);
    let bad = |c: char| (c.is_control() && c != '\n' && c != '\t') || c == '\u{202e}';
    assert!(!picture.contains(bad), "a picture with a character that may not stand there: {picture:?}");
    clean(&picture_page(&chosen.name(), &picture));
});

/// Panics where a piece of a name is markup.
fn clean(text: &str) {
    let lower = text.to_lowercase();
    assert!(!lower.contains("<zq"), "markup out of a name: {text}");
    let (open, close) = (lower.matches("<script").count(), lower.matches("</script>").count());
    assert_eq!(open, close, "a script's end out of a name: {text}");
}

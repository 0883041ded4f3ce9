//! What is done with a table of numbers.

use solaris_io::{Table, csv, record, sto};
use solaris_model::{Figure, FigureBuilder, Joint, LinkSpec, Vector3};
use std::sync::LazyLock;

/// A figure with the names of the seeds' columns: it slides, turns, carries a ball, and has a knee.
static FIGURE: LazyLock<Figure> = LazyLock::new(|| {
    FigureBuilder::new("figure")
        .link(
            LinkSpec::root("pelvis", Joint::new("pelvis").tx().named("pelvis_tx").ry().named("hip"))
                .mass(1.0),
        )
        .link(LinkSpec::child("thigh", "pelvis", Joint::new("knee").rx()).mass(1.0))
        .link(LinkSpec::child("arm", "pelvis", Joint::ball("shoulder")).mass(1.0))
        .build()
        .expect("a valid figure")
});

/// Takes a table as the motion of a figure and as measured forces, and writes and reads it; `source` is its text.
pub fn table(source: &str, table: &Table) {
    assert!(table.values.iter().all(|x| x.is_finite()), "a table with {:?}", table.values);
    assert_eq!(table.values.len(), table.len() * table.columns.len());
    table.notes.iter().for_each(|note| crate::said(source, &note.to_string()));
    let table = &*table.without_repeated_times();
    let gravity = Vector3::new(0.0, -9.81, 0.0);
    match record::read(&FIGURE, gravity, table) {
        Ok(read) => {
            let numbers = read.motion.columns().concat();
            assert!(!numbers.iter().any(|x| x.is_nan()), "a motion with {numbers:?}");
        }
        Err(error) => crate::refused(&error),
    }
    for prefix in record::force_prefixes(table).iter().take(8) {
        match record::forces(table, &["thigh".to_owned()], prefix) {
            Ok(measured) => assert_eq!(measured.samples.len(), table.len()),
            Err(error) => crate::refused(&error),
        }
    }
    let mut written = Vec::new();
    if sto::write(table, &mut written).is_ok() {
        same(table, &written, sto::read);
    }
    written.clear();
    if csv::write_table(table, &mut written).is_ok() {
        same(table, &written, csv::read_table);
    }
}

/// Panics where what was written is not what is read.
fn same(table: &Table, written: &[u8], read: fn(&str) -> Result<Table, solaris_io::IoError>) {
    let written = std::str::from_utf8(written).expect("text");
    match read(written) {
        Ok(again) => {
            assert_eq!(again.columns, table.columns, "headings of\n{written}");
            assert_eq!(again.values, table.values, "numbers of\n{written}");
        }
        Err(error) => panic!("what was written is not read: {error}\n{written}"),
    }
}

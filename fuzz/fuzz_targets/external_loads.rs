//! What OpenSim's external loads say of a table: the document, then a file `==== table` with the table.
#![no_main]

use solaris_fuzz::{Files, refused, target, text};
use solaris_io::{Loader, opensim, sto};

target!(|bytes: &[u8]| {
    let mut files = Files::of(bytes);
    let Some(source) = text(files.main) else { return };
    match opensim::external_loads(&source) {
        Ok(loads) => {
            assert!(!loads.forces.is_empty());
            let table = files.load("table").ok().and_then(|bytes| text(&bytes));
            let Some(table) = table.and_then(|table| sto::read_mot(&table).ok()) else { return };
            if let Ok(records) = loads.records(&table) {
                let finite = |force: &solaris_model::Contact| !force.moment.iter().any(|x| x.is_nan());
                assert!(records.iter().all(|record| record.samples.iter().all(finite)), "{records:?}");
            }
        }
        Err(error) => refused(&error),
    }
});

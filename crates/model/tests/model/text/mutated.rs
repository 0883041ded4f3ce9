//! Whatever is done to a text, it is read or refused, never a panic.

use crate::text::random;
use crate::text::render::render;
use proptest::prelude::*;
use solaris_model::text::{read, write};

/// One change of the bytes.
#[derive(Clone, Debug)]
enum Change {
    Delete(usize, usize),
    Insert(usize, Vec<u8>),
    Repeat(usize, usize),
    Replace(usize, u8),
}

fn change() -> impl Strategy<Value = Change> {
    let pieces = [
        "(", ")", "[", "}", "{", ":", ",", "\"", "\\", "/*", "//", "deg", "-", "1e999", "NaN", "None", "é",
        "\u{feff}", "r#\"", "°", "_",
    ];
    let piece = proptest::sample::select(pieces.to_vec()).prop_map(|piece| piece.as_bytes().to_vec());
    prop_oneof![
        (any::<usize>(), 1_usize..40).prop_map(|(at, length)| Change::Delete(at, length)),
        (any::<usize>(), prop_oneof![piece, proptest::collection::vec(any::<u8>(), 1..5)])
            .prop_map(|(at, bytes)| Change::Insert(at, bytes)),
        (any::<usize>(), 1_usize..200).prop_map(|(at, length)| Change::Repeat(at, length)),
        (any::<usize>(), any::<u8>()).prop_map(|(at, byte)| Change::Replace(at, byte)),
    ]
}

fn apply(bytes: &mut Vec<u8>, change: &Change) {
    let place = |at: usize| at % (bytes.len() + 1);
    match change {
        Change::Delete(at, length) => {
            let at = place(*at);
            bytes.drain(at..(at + length).min(bytes.len()));
        }
        Change::Insert(at, new) => {
            let at = place(*at);
            bytes.splice(at..at, new.iter().copied());
        }
        Change::Repeat(at, length) => {
            let at = place(*at);
            let piece = bytes[at..(at + length).min(bytes.len())].to_vec();
            bytes.splice(at..at, piece);
        }
        Change::Replace(at, byte) => {
            let at = place(*at);
            if let Some(old) = bytes.get_mut(at) {
                *old = *byte;
            }
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn a_changed_text_is_read_or_refused(seed in 0_u64..50, changes in proptest::collection::vec(change(), 1..6)) {
        let mut bytes = write(&random::figure(seed)).into_bytes();
        for change in &changes {
            apply(&mut bytes, change);
        }
        let text = String::from_utf8_lossy(&bytes);
        match read(&text) {
            Ok(figure) => {
                let again = read(&write(&figure));
                prop_assert!(again.as_ref() == Ok(&figure), "{again:?}");
            }
            Err(error) => {
                prop_assert!(!error.faults.is_empty());
                for fault in &error.faults {
                    let line = text.split('\n').count();
                    prop_assert!(fault.place.line <= line && text.get(fault.place.span.clone()).is_some());
                }
                render(&text, &error);
            }
        }
    }
}

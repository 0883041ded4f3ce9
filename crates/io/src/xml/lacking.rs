//! What acts and is not read: each kind once, with the names of those that have it.

use super::Reader;
use solaris_model::{Finding, FindingKind};
use std::ops::Range;

/// The most names of a kind that are listed.
const NAMES: usize = 5;

/// What was met, by kinds, in the order of their first places.
#[derive(Default)]
pub(super) struct Lacking {
    kinds: Vec<Kind>,
}

struct Kind {
    subject: &'static str,
    message: &'static str,
    span: Range<usize>,
    names: Vec<String>,
    count: usize,
}

impl Lacking {
    pub(super) fn findings(&mut self) -> Vec<(Range<usize>, Finding)> {
        let finding = |Kind { subject, message, span, names, count }| {
            let more = if count > names.len() { ", …" } else { "" };
            let message = format!("{message} ({count}: {}{more})", names.join(", "));
            (span, Finding { kind: FindingKind::Missing, subject: subject.to_owned(), message, place: None })
        };
        std::mem::take(&mut self.kinds).into_iter().map(finding).collect()
    }
}

impl Reader<'_> {
    /// Something called `name` acts in a way that has no place in a figure; all of a `subject` become one finding.
    pub(crate) fn lacks(
        &mut self,
        subject: &'static str,
        message: &'static str,
        span: Range<usize>,
        name: &str,
    ) {
        let kinds = &mut self.lacking.kinds;
        let at = kinds.iter().position(|kind| kind.subject == subject).unwrap_or_else(|| {
            kinds.push(Kind { subject, message, span, names: Vec::new(), count: 0 });
            kinds.len() - 1
        });
        kinds[at].count += 1;
        if kinds[at].names.len() < NAMES {
            kinds[at].names.push(name.to_owned());
        }
    }
}

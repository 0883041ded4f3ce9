//! Suggestions of nearest names for messages, as far as looking for them takes no time.

use solaris_text::nearest;

/// How many names may be compared for the hints of one figure.
const NAMES: usize = 1_000_000;

/// Finds nearest names until it has compared enough of them: in a figure of a hundred thousand links that are all wrong,
/// the first ten faults have a hint.
#[derive(Debug, Default)]
pub(super) struct Hints {
    compared: usize,
}

impl Hints {
    /// The name in `names` that is nearest to `wanted`, if any is near and there is time to look.
    pub(super) fn nearest<'a>(
        &mut self,
        wanted: &str,
        names: impl Iterator<Item = &'a str>,
    ) -> Option<String> {
        if self.compared >= NAMES {
            return None;
        }
        let compared = &mut self.compared;
        nearest(wanted, names.inspect(|_| *compared += 1))
    }
}

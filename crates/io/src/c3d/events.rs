//! Events, from the parameters or the header.

use super::bytes::Bytes;
use super::layout::Layout;
use super::parameters::Parameters;
use crate::markers::Event;

/// The events of the file, on the clock of which the first frame read is zero.
pub(super) fn events(bytes: &Bytes<'_>, layout: &Layout, all: &Parameters<'_>) -> Vec<Event> {
    let mut found = of_parameters(all);
    if found.is_empty() {
        found = of_header(bytes);
    }
    // Files count from frame 1.
    let before = (layout.first - 1).max(0) as f64 / layout.rate;
    for event in &mut found {
        event.time -= before;
    }
    found.retain(|event| event.time.is_finite());
    found
}

/// Those of `EVENT:TIMES`, in minutes and seconds.
fn of_parameters(all: &Parameters<'_>) -> Vec<Event> {
    let times = all.continued("EVENT", "TIMES", Parameters::numbers);
    let labels = all.continued("EVENT", "LABELS", Parameters::texts);
    let contexts = all.continued("EVENT", "CONTEXTS", Parameters::texts);
    let used = all.count("EVENT", "USED").unwrap_or(0);
    let text = |list: &[String], at: usize| list.get(at).cloned().unwrap_or_default();
    let pairs = times.chunks_exact(2).take(used).enumerate();
    pairs
        .map(|(at, time)| Event {
            label: text(&labels, at),
            context: text(&contexts, at),
            time: 60.0 * time[0] + time[1],
        })
        .collect()
}

/// Those of the header: at most 18, with names of four letters.
fn of_header(bytes: &Bytes<'_>) -> Vec<Event> {
    const KEY: usize = 298;
    const COUNT: usize = 300;
    const TIMES: usize = 304;
    const LABELS: usize = 396;
    let word = |at| bytes.word("an event", at).unwrap_or(0);
    if word(KEY) != 12345 {
        return Vec::new();
    }
    let one = |at: usize| {
        let time = bytes.real("an event's time", TIMES + 4 * at).ok()?;
        let label = bytes.slice("an event's label", LABELS + 4 * at, 4).ok()?;
        let label: String = label.iter().map(|byte| char::from(*byte)).collect();
        let label = label.trim_matches(|c: char| c.is_whitespace() || c == '\0').to_owned();
        Some(Event { label, context: String::new(), time: f64::from(time) })
    };
    (0..usize::from(word(COUNT)).min(18)).filter_map(one).collect()
}

//! The analog channels.

use super::bytes::Bytes;
use super::layout::Layout;
use super::parameters::Parameters;
use super::read::Said;
use crate::markers::Channel;
use solaris_model::FindingKind;

/// Reads all channels.
///
/// ```text
/// value = (raw − OFFSET) · SCALE · GEN_SCALE
/// ```
pub(super) fn analog(
    bytes: &Bytes<'_>,
    layout: &Layout,
    all: &Parameters<'_>,
    said: &mut Said,
) -> Vec<Channel> {
    let (labels, units) = (
        all.continued("ANALOG", "LABELS", Parameters::texts),
        all.continued("ANALOG", "UNITS", Parameters::texts),
    );
    let is_unsigned =
        all.texts("ANALOG", "FORMAT").first().is_some_and(|text| text.eq_ignore_ascii_case("unsigned"));
    let general = all.number("ANALOG", "GEN_SCALE").unwrap_or(1.0);
    let scales = all.continued("ANALOG", "SCALE", Parameters::numbers);
    let numbers = if is_unsigned { Parameters::counts } else { Parameters::numbers };
    let mut offsets = all.continued("ANALOG", "OFFSET", numbers);
    if offsets.is_empty() {
        // Some programs write a name of their own.
        offsets = all.continued("ANALOG", "OFFSETS", numbers);
    }
    for (name, length, other) in [("SCALE", scales.len(), 1), ("OFFSET", offsets.len(), 0)] {
        if length < layout.channels {
            let message = format!("{length} for {} channels; the others have {other}", layout.channels);
            said.say(FindingKind::Suspect, &format!("ANALOG:{name}"), message);
        }
    }
    let raw = |frame, sample, channel| {
        let at = layout.sample(frame, sample, channel);
        if layout.is_real {
            return bytes.real("a sample", at).map_or(f64::NAN, f64::from);
        }
        let plain = |word: u16| if is_unsigned { f64::from(word) } else { f64::from(word as i16) };
        bytes.word("a sample", at).map_or(f64::NAN, plain)
    };
    let text = |list: &[String], at: usize| list.get(at).cloned().unwrap_or_default();
    (0..layout.channels)
        .map(|channel| {
            let scale = scales.get(channel).copied().unwrap_or(1.0) * general;
            let offset = offsets.get(channel).copied().unwrap_or(0.0);
            let frames =
                (0..layout.frames).flat_map(|frame| (0..layout.samples).map(move |sample| (frame, sample)));
            Channel {
                label: text(&labels, channel),
                unit: text(&units, channel),
                rate: layout.rate * layout.samples as f64,
                samples: frames
                    .map(|(frame, sample)| (raw(frame, sample, channel) - offset) * scale)
                    .collect(),
            }
        })
        .collect()
}

//! Where the numbers of each frame stand.

use super::bytes::Bytes;
use super::error::C3dError;
use super::header::{BLOCK, Header, field};
use super::parameters::Parameters;
use super::read::Said;
use solaris_model::FindingKind;

/// The greatest number that a word holds.
const MOST: f64 = 65535.0;

/// Where the numbers of each frame stand.
pub(super) struct Layout {
    /// Where the frames begin (bytes).
    pub(super) start: usize,
    pub(super) frames: usize,
    pub(super) points: usize,
    /// Analog channels.
    pub(super) channels: usize,
    /// Analog samples of a frame and channel.
    pub(super) samples: usize,
    /// Whether numbers are reals; words else.
    pub(super) is_real: bool,
    /// What a number of a point is (file's units), where they are words, and of a residual.
    pub(super) scale: f64,
    /// Frames a second (Hz).
    pub(super) rate: f64,
    pub(super) first: i64,
}

impl Layout {
    /// Bytes of a number.
    pub(super) fn size(&self) -> usize {
        if self.is_real { 4 } else { 2 }
    }

    /// Bytes of a frame.
    pub(super) fn frame(&self) -> usize {
        (4 * self.points + self.channels * self.samples) * self.size()
    }

    /// Where the point's, or a sample's, four or one number of a frame begin.
    pub(super) fn point(&self, frame: usize, point: usize) -> usize {
        self.start + frame * self.frame() + 4 * point * self.size()
    }

    /// Where a sample of a channel in a frame stands.
    pub(super) fn sample(&self, frame: usize, sample: usize, channel: usize) -> usize {
        self.point(frame, self.points) + (sample * self.channels + channel) * self.size()
    }
}

/// Finds where the numbers stand.
pub(super) fn layout(
    bytes: &Bytes<'_>,
    header: &Header,
    all: &Parameters<'_>,
    said: &mut Said,
) -> Result<Layout, C3dError> {
    let points = all.count("POINT", "USED").unwrap_or(usize::from(header.points));
    if points != usize::from(header.points) && header.points != 0 {
        let message = format!("{points}, and the header says {}; {points} are read", header.points);
        said.say(FindingKind::Suspect, "POINT:USED", message);
    }
    let scale = all.number("POINT", "SCALE").unwrap_or_else(|| f64::from(header.scale));
    if scale == 0.0 || !scale.is_finite() {
        let at = all.get("POINT", "SCALE").map_or(12, |parameter| parameter.offset);
        let advice = "it must be below zero for reals and above for integers; export the trial again";
        return Err(field("POINT:SCALE", &scale, at, advice));
    }
    let rate = all.number("POINT", "RATE").filter(|rate| *rate > 0.0).unwrap_or(f64::from(header.rate));
    if rate <= 0.0 || !rate.is_finite() {
        let at = all.get("POINT", "RATE").map_or(20, |parameter| parameter.offset);
        return Err(field("POINT:RATE", &rate, at, "it must be the frames a second, above zero; correct it"));
    }
    let (channels, samples) = analog(header, all, rate, said);
    let block = match header.data {
        0 => all.count("POINT", "DATA_START").unwrap_or(0),
        block => usize::from(block),
    };
    let start = block.wrapping_sub(1).saturating_mul(BLOCK);
    if block < 2 || start >= bytes.bytes.len() {
        let advice = "the frames begin after the parameters and within the file; it was cut off or its header is broken: \
                      export the trial again";
        return Err(field("the first block of the frames (POINT:DATA_START)", &block, 16, advice));
    }
    let mut layout = Layout {
        start,
        frames: 0,
        points,
        channels,
        samples,
        is_real: scale < 0.0,
        scale: scale.abs(),
        rate,
        first: i64::from(header.first),
    };
    frames(&mut layout, bytes, header, all, said)?;
    Ok(layout)
}

/// Channels, and samples of each in a frame.
fn analog(header: &Header, all: &Parameters<'_>, rate: f64, said: &mut Said) -> (usize, usize) {
    let total = usize::from(header.analog);
    let used = all.count("ANALOG", "USED");
    let by_rate = all.number("ANALOG", "RATE").map(|analog| (analog / rate).round().min(MOST));
    let mut samples = usize::from(header.samples);
    if samples == 0 {
        samples = by_rate.filter(|samples| *samples >= 1.0).map_or(1, |samples| samples as usize);
    }
    let channels = used.unwrap_or(total / samples);
    if channels * samples == total {
        return (channels, samples);
    }
    if total > 0 && channels > 0 && total.is_multiple_of(channels) {
        return (channels, total / channels);
    }
    let message = format!(
        "{channels} channels with {samples} samples a frame, and the header says {total} samples a frame; the header's are read"
    );
    said.say(FindingKind::Suspect, "ANALOG:USED", message);
    (total / samples, samples)
}

/// The number of frames and of the first.
fn frames(
    layout: &mut Layout,
    bytes: &Bytes<'_>,
    header: &Header,
    all: &Parameters<'_>,
    said: &mut Said,
) -> Result<(), C3dError> {
    let size = layout.frame();
    if size == 0 {
        let advice = "a recording needs points or channels; was the trial exported without them?";
        return Err(field("POINT:USED", &0, 2, advice));
    }
    let there = (bytes.bytes.len() - layout.start) / size;
    let long = |name| match all.counts("TRIAL", name)[..] {
        [low, high, ..] => Some(low.min(MOST) as i64 + 65536 * high.min(MOST) as i64),
        [only] => Some(only.min(MOST) as i64),
        [] => None,
    };
    let (first, last) = (i64::from(header.first), i64::from(header.last));
    let mut claims = Vec::new();
    if let (Some(first), Some(last)) = (long("ACTUAL_START_FIELD"), long("ACTUAL_END_FIELD"))
        && last >= first
    {
        layout.first = first;
        claims.push(("TRIAL:ACTUAL_END_FIELD", last - first + 1));
    }
    let one = |name| all.counts("POINT", name).first().map(|count| count.min(u32::MAX.into()) as i64);
    if let Some(count) = one("LONG_FRAMES").filter(|count| *count > 65535) {
        claims.push(("POINT:LONG_FRAMES", count));
    }
    if last >= first {
        claims.push(("the header", last - first + 1));
    }
    if let Some(count) = one("FRAMES").filter(|count| *count > 0) {
        claims.push(("POINT:FRAMES", count));
    }
    let Some(&(who, told)) = claims.first() else {
        let advice = "no first and last frame, and POINT:FRAMES is missing too; export the trial again";
        return Err(field("the header's last frame", &last, 8, advice));
    };
    let fits = |claim: &&(&str, i64)| usize::try_from(claim.1).is_ok_and(|count| count <= there);
    let (by, count) =
        claims.iter().find(fits).map_or(("the file's length", there), |claim| (claim.0, claim.1 as usize));
    if count as i64 != told {
        let message =
            format!("{who} says {told}, and the file holds {there} at most; the {count} by {by} are read");
        said.say(FindingKind::Suspect, "frames", message);
    }
    if count == 0 {
        let field = "the first frame".to_owned();
        let (offset, length) = (layout.start, bytes.bytes.len());
        return Err(C3dError::Cut { field, offset, end: offset.saturating_add(size), length });
    }
    layout.frames = count;
    Ok(())
}

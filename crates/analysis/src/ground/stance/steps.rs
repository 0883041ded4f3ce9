//! When a foot is down, from how its own points move.

use super::edges::{crossing, standing};
use super::track::{FootTrack, quantile};
use super::{Span, StanceOptions};

/// A foot that comes down counts as standing from when it is slower than this share of the greatest speed of the swing before.
const COMES: f64 = 0.13;
/// A foot that leaves counts as standing until it is faster than this share of the greatest speed of the swing after.
const LEAVES: f64 = 0.24;
/// Share of a foot's pace below which it may stand at all.
const SLOW: f64 = 0.12;
/// The slowest limit (m/s): less is noise.
const LEAST: f64 = 0.2;
/// Share of a foot's lift that its points may be above their lowest.
const LOW: f64 = 0.05;

/// Limits of what stands.
pub(super) struct Limits {
    /// How far (m) above its lowest height a point may be.
    pub(super) height: f64,
    /// How fast (m/s) it may be, for a foot to stand at all.
    pub(super) speed: f64,
    /// The speed (m/s) that was asked for.
    asked: Option<f64>,
    /// The greatest speed (m/s) of a swing that is not seen whole.
    pace: f64,
}

impl Limits {
    pub(super) fn of(track: &FootTrack, options: &StanceOptions) -> Self {
        let pace = track.pace();
        let height = options.height.unwrap_or_else(|| StanceOptions::HEIGHT.max(LOW * track.lift()));
        let speed = options.speed.unwrap_or_else(|| StanceOptions::SPEED.max(SLOW * pace));
        Self { height, speed, asked: options.speed, pace }
    }

    fn edge(&self, share: f64, swing: f64) -> f64 {
        self.asked.unwrap_or_else(|| (share * swing).max(LEAST))
    }
}

/// When a foot is down: spans of time (s).
///
/// First it is down while one of its points is low and slow. Then each edge is put where that point is as slow as a share of
/// the greatest speed of the swing beside it: a foot is still fast when it first touches, and already fast when it last does.
pub(super) fn steps(time: &[f64], track: &FootTrack, limits: &Limits, shortest: f64) -> Vec<Span> {
    if !track.stands {
        return Vec::new();
    }
    let decides: Vec<f64> =
        (0..time.len()).map(|row| track.decides(row, limits.height, limits.speed)).collect();
    let mut spans = standing(time, &decides, shortest);
    let (Some(&first), Some(&last)) = (time.first(), time.last()) else { return spans };
    let row = |t: f64| time.partition_point(|time| *time < t).min(time.len() - 1);
    let peak = |from: f64, to: f64| (row(from)..=row(to)).map(|row| track.fastest(row)).fold(0.0, f64::max);
    let whole: Vec<f64> = spans.windows(2).map(|pair| peak(pair[0].1, pair[1].0)).collect();
    let usual = if whole.is_empty() { limits.pace } else { quantile(whole.clone(), 0.5) };
    for i in 0..spans.len() {
        let (start, end) = spans[i];
        let middle = row(start.midpoint(end));
        let edge = |share: f64, swing: f64, ahead: bool| {
            let speed = limits.edge(share, swing);
            crossing(time, middle, row(if ahead { end } else { start }), ahead, |row| {
                track.decides(row, limits.height, speed)
            })
        };
        if start > first {
            let before = i.checked_sub(1).map_or_else(|| usual.max(peak(first, start)), |i| whole[i]);
            spans[i].0 = edge(COMES, before, false);
        }
        if end < last {
            let after = whole.get(i).copied().unwrap_or_else(|| usual.max(peak(end, last)));
            spans[i].1 = edge(LEAVES, after, true);
        }
    }
    spans
}

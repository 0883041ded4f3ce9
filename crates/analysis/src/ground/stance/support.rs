//! What the whole force says of stances: nobody stands while there is none, somebody does while it is large.

use super::Span;
use super::edges::{crossing, standing};
use super::steps::Limits;
use super::track::FootTrack;

/// Nobody stands where the normal force is less than this share of the weight.
const AIR: f64 = 0.1;
/// Somebody stands where it is more than this.
const BORNE: f64 = 0.5;
/// A shorter flight (s) is noise of the force.
const FLIGHT: f64 = 0.05;
/// Feet that come or leave within this time (s) do so together.
const TOGETHER: f64 = 0.15;
/// A low foot that is slower than this (m/s) is planted.
const PLANTED: f64 = 0.2;
/// At the edge of a flight a foot may be lifted by this much more than where it stands: it comes from above.
const LOW: f64 = 2.0;
/// How much more than the limits the foot may be off that is nearest to standing, as a share of them.
const NEAR: f64 = 1.0;
/// A time without a foot between two stances that is shorter than this (s) is none.
const GAP: f64 = 0.15;

/// The whole normal force over the weight, and when there is some.
pub(super) struct Support<'a> {
    time: &'a [f64],
    normal: Vec<f64>,
    /// When something is borne; the times between are flights.
    spans: Vec<Span>,
}

impl<'a> Support<'a> {
    /// `normal` is the whole normal force over the weight, one a frame.
    pub(super) fn new(time: &'a [f64], normal: Vec<f64>) -> Self {
        let decides: Vec<f64> = normal.iter().map(|normal| AIR - normal).collect();
        let spans = standing(time, &decides, FLIGHT);
        Self { time, normal, spans }
    }

    /// Whether somebody must stand in a frame.
    pub(super) fn borne(&self, row: usize) -> bool {
        self.normal[row] > BORNE
    }

    /// Whether nothing is ever borne: a figure that floats, of which the force says nothing.
    fn is_silent(&self) -> bool {
        !(0..self.normal.len()).any(|row| self.borne(row))
    }

    /// The stances of all feet, by foot, as the force allows and needs them.
    ///
    /// - No foot stands in flight, but one that is planted and does not move: then the motion's force is at fault.
    /// - Those that come first after a flight do when it ends, or when they are low, whichever is later; the same of those that
    ///   leave before a flight.
    /// - Where none stands between two stances for a moment, each lasts until its middle.
    /// - Where something is borne and no foot is down, those feet stand that are slow there, on whatever is under them; and if
    ///   no foot stands between two flights, the one that is nearest to standing does.
    pub(super) fn settle(
        &self,
        feet: &mut [Vec<Span>],
        tracks: &[FootTrack],
        limits: &[Limits],
        shortest: f64,
    ) {
        if self.is_silent() {
            return;
        }
        for ((spans, track), limits) in feet.iter_mut().zip(tracks).zip(limits) {
            *spans = self.within(spans, track, limits.height);
        }
        for &span in &self.spans {
            self.touch(span, feet, tracks, limits);
            close(span, feet);
            self.still(span, feet, tracks, limits, shortest);
            self.nearest(span, feet, tracks, limits);
        }
        for spans in feet {
            spans.sort_by(|a, b| a.0.total_cmp(&b.0));
            spans.dedup_by(|next, span| {
                let meets = next.0 - span.1 < shortest && !self.flies(span.1, next.0);
                if meets {
                    span.1 = span.1.max(next.1);
                }
                meets
            });
        }
    }

    /// Whether a flight lies between two times.
    fn flies(&self, from: f64, to: f64) -> bool {
        self.spans.windows(2).any(|pair| pair[0].1 >= from - 1e-9 && pair[1].0 <= to + 1e-9)
    }

    /// What is left of a foot's spans outside of flights in which it is not planted.
    fn within(&self, spans: &[Span], track: &FootTrack, height: f64) -> Vec<Span> {
        let planted = |row: usize| track.decides(row, height, PLANTED) < 0.0;
        // Times of support, those that only a planted foot parts taken together.
        let mut borne: Vec<Span> = Vec::new();
        for &(start, end) in &self.spans {
            match borne.last_mut() {
                Some(last) if (self.row(last.1)..self.row(start)).all(planted) => last.1 = end,
                _ => borne.push((start, end)),
            }
        }
        let cut = |&(from, to): &Span| {
            let left = borne.iter().map(|&(start, end)| (from.max(start), to.min(end)));
            // A motion of one frame has a stance of no length.
            left.filter(|(start, end)| end > start || (end >= start && from >= to)).collect::<Vec<_>>()
        };
        spans.iter().flat_map(cut).collect()
    }

    /// Lets feet come when a flight ends, and leave when one begins, as far as they are low.
    fn touch(&self, (start, end): Span, feet: &mut [Vec<Span>], tracks: &[FootTrack], limits: &[Limits]) {
        let (Some(&first), Some(&last)) = (self.time.first(), self.time.last()) else { return };
        let inside = |span: &Span| span.1 > start && span.0 < end;
        let all = || feet.iter().flatten().filter(|span| inside(span));
        let comes = all().map(|span| span.0).fold(f64::INFINITY, f64::min);
        let leaves = all().map(|span| span.1).fold(f64::NEG_INFINITY, f64::max);
        for (foot, own) in feet.iter_mut().enumerate() {
            let height = LOW * limits[foot].height;
            let low = |row: usize| tracks[foot].decides(row, height, f64::INFINITY);
            for span in own.iter_mut().filter(|span| inside(span)) {
                let [from, to] = [span.0, span.1].map(|t| self.row(t));
                let middle = self.row(span.0.midpoint(span.1));
                if start > first && span.0 - comes < TOGETHER {
                    span.0 = crossing(self.time, middle, from, false, low).max(start).min(span.0);
                }
                if end < last && leaves - span.1 < TOGETHER {
                    span.1 = crossing(self.time, middle, to, true, low).min(end).max(span.1);
                }
            }
        }
    }

    fn row(&self, t: f64) -> usize {
        self.time.partition_point(|time| *time < t).min(self.time.len() - 1)
    }

    /// Lets slow feet stand where something is borne and no foot is down.
    fn still(
        &self,
        span: Span,
        feet: &mut [Vec<Span>],
        tracks: &[FootTrack],
        limits: &[Limits],
        shortest: f64,
    ) {
        for (from, to) in bare(span, feet) {
            for (foot, own) in feet.iter_mut().enumerate() {
                let decides = |row: usize| {
                    let t = self.time[row];
                    let here = (from..=to).contains(&t) && self.borne(row);
                    if here {
                        tracks[foot].decides(row, f64::INFINITY, limits[foot].speed)
                    } else {
                        f64::INFINITY
                    }
                };
                let decides: Vec<f64> = (0..self.time.len()).map(decides).collect();
                let slow = standing(self.time, &decides, shortest);
                own.extend(slow.into_iter().filter(|slow| slow.1 - slow.0 >= shortest));
            }
        }
    }

    /// Lets the foot stand that is nearest to it where none does in a whole span.
    fn nearest(&self, span: Span, feet: &mut [Vec<Span>], tracks: &[FootTrack], limits: &[Limits]) {
        let rows = || (0..self.time.len()).filter(|row| (span.0..=span.1).contains(&self.time[*row]));
        if feet.iter().flatten().any(|own| own.1 > span.0 && own.0 < span.1)
            || !rows().any(|row| self.borne(row))
        {
            return;
        }
        let off = |foot: usize| {
            let least = rows().map(|row| tracks[foot].decides(row, limits[foot].height, limits[foot].speed));
            least.fold(f64::INFINITY, f64::min)
        };
        let foot =
            (0..feet.len()).filter(|foot| tracks[*foot].stands).min_by(|a, b| off(*a).total_cmp(&off(*b)));
        if let Some(foot) = foot.filter(|foot| off(*foot) < NEAR) {
            feet[foot].push(span);
        }
    }
}

/// Closes short times without a foot.
fn close(span: Span, feet: &mut [Vec<Span>]) {
    for (from, to) in bare(span, feet) {
        if from <= span.0 || to >= span.1 || to - from > GAP {
            continue;
        }
        let middle = from.midpoint(to);
        for own in feet.iter_mut().flatten() {
            if own.1.to_bits() == from.to_bits() {
                own.1 = middle;
            }
            if own.0.to_bits() == to.to_bits() {
                own.0 = middle;
            }
        }
    }
}

/// Times in a span in which no foot stands.
fn bare((start, end): Span, feet: &[Vec<Span>]) -> Vec<Span> {
    let mut taken: Vec<Span> =
        feet.iter().flatten().copied().filter(|span| span.1 > start && span.0 < end).collect();
    taken.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut out = Vec::new();
    let mut from = start;
    for span in taken {
        if span.0 > from {
            out.push((from, span.0));
        }
        from = from.max(span.1);
    }
    if from < end {
        out.push((from, end));
    }
    out
}

#[cfg(test)]
mod tests {
    use super::super::StanceOptions;
    use super::*;
    use approx::assert_relative_eq;

    /// A foot of which all points are on the ground and of one speed (m/s).
    fn on_ground(frames: usize, speed: f64) -> FootTrack {
        FootTrack { above: vec![[0.0; 3]; frames], speed: vec![[speed; 3]; frames], stands: true }
    }

    /// The weight is borne but for two frames, so that from 0.49 s to 0.61 s there is less than a tenth of it.
    #[test]
    fn a_planted_foot_stands_on_where_the_force_says_that_nobody_does() {
        let time: Vec<f64> = (0..=10).map(|row| f64::from(row) / 10.0).collect();
        let normal = (0..=10).map(|row| if row == 5 || row == 6 { 0.0 } else { 1.0 }).collect();
        let support = Support::new(&time, normal);
        let stands = |speed: f64| {
            let track = on_ground(time.len(), speed);
            let limits = [Limits::of(&track, &StanceOptions::default())];
            let mut feet = [vec![(0.0, 1.0)]];
            support.settle(&mut feet, &[track], &limits, 0.1);
            feet[0].clone()
        };
        for speed in [0.0, 0.19] {
            assert_eq!(stands(speed), [(0.0, 1.0)], "{speed} m/s");
        }
        let moving = stands(0.21);
        assert_eq!(moving.len(), 2, "{moving:?}");
        for (found, expected) in moving.iter().zip([(0.0, 0.49), (0.61, 1.0)]) {
            assert_relative_eq!(found.0, expected.0, epsilon = 1e-12);
            assert_relative_eq!(found.1, expected.1, epsilon = 1e-12);
        }
    }

    /// Where no foot stands in the whole time the nearest one does, also where one comes in the very instant in which that time ends, or has left
    /// in that in which it begins.
    #[test]
    fn who_comes_as_a_time_ends_has_not_stood_in_it() {
        let time: Vec<f64> = (0..=10).map(|row| f64::from(row) / 10.0).collect();
        let support = Support::new(&time, vec![1.0; time.len()]);
        let tracks = [on_ground(time.len(), 0.6), on_ground(time.len(), 0.7)];
        let limits = tracks.each_ref().map(|track| Limits::of(track, &StanceOptions::default()));
        let span = (0.25, 0.75);
        let stands = |other: Span| {
            let mut feet = [Vec::new(), vec![other]];
            support.nearest(span, &mut feet, &tracks, &limits);
            feet[0].clone()
        };
        for beside in [(0.75, 1.0), (0.0, 0.25)] {
            assert_eq!(stands(beside), [span], "{beside:?}");
        }
        for within in [(0.74, 1.0), (0.0, 0.26)] {
            assert_eq!(stands(within), [], "{within:?}");
        }
    }
}

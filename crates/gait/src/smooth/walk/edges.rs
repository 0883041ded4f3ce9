//! Kerbs and steps of ground of any shape, gone over as stairs are: a short step over each edge, level steps that are fitted between them.

use super::course::Step;
use super::terrain::{AFTER_STAIRS, BEFORE_DOWN, BEFORE_UP, EDGE, Foothold, LEAD, StepKind, Terrain};
use crate::body::LegGeometry;
use crate::error::RequestError;
use crate::smooth::stair_numbers::nosing;
use crate::smooth::stairs::STAIRS;
use solaris_model::Relief;

/// How wide an edge may be (m).
const WIDEST: f64 = 0.02;
/// Lower edges than this (m) are gone over as the ground's slope has it.
const LOWEST: f64 = 0.04;
/// Treads of edges that no other one is near to, in the order in which they are tried (m).
const ALONE: [f64; 4] = [0.32, 0.29, 0.35, 0.26];
/// How far before an edge the sole ends of somebody who stops there (m).
const STOPS_BEFORE: f64 = 0.1;
/// By how much the level steps between may be shorter and longer than they would be.
const FITTED: (f64, f64) = (0.72, 1.15);
/// What counts as even beside an edge, and as no edge (m).
const EVEN: f64 = 2e-3;
/// The steepest ground beside an edge (rad): pavements and roads fall to their gutters by as much.
const STEEPEST_BESIDE: f64 = 3.0 * std::f64::consts::PI / 180.0;
/// What numbers of a file may miss by rounding (m).
const ROUNDING: f64 = 1e-9;

/// An edge: where it is, how far the ground rises there, and the tread that it is gone over with (m).
#[derive(Clone, Copy, Debug)]
struct Edge {
    at: f64,
    rise: f64,
    tread: f64,
}

/// The edges of a relief ahead, if they can be gone over as stairs; those alone with a tread of that depth.
fn edges(relief: &Relief, alone: f64) -> Option<Vec<Edge>> {
    let mut found: Vec<(f64, f64, f64)> = Vec::new();
    let is_narrow = |from: f64, to: f64| to - from <= WIDEST + ROUNDING;
    for pair in relief.points().windows(2) {
        let ([from, below], [to, above]) = (pair[0], pair[1]);
        if to <= 0.0 || !is_narrow(from, to) || (above - below).abs() <= EVEN {
            continue;
        }
        match found.last_mut() {
            // Of several pieces.
            Some((first, end, rise)) if from - *end < ROUNDING && is_narrow(*first, to) => {
                (*end, *rise) = (to, *rise + above - below);
            }
            _ => found.push((from, to, above - below)),
        }
    }
    found.retain(|(_, _, rise)| rise.abs() >= LOWEST - ROUNDING);
    let ((_, highest), (narrowest, widest)) = STAIRS;
    if found.is_empty() || found.iter().any(|(_, _, rise)| rise.abs() > highest + ROUNDING) {
        return None;
    }
    // The upper end is where a tread's nosing is.
    let edge = |&(from, to, rise): &(f64, f64, f64)| Edge {
        at: if rise > 0.0 { to } else { from },
        rise,
        tread: alone,
    };
    let found: Vec<Edge> = found.iter().map(edge).collect();
    let stair = |(k, edge): (usize, &Edge)| {
        let beside = if edge.rise > 0.0 { k.checked_sub(1) } else { Some(k + 1) };
        let gap = beside.and_then(|k| found.get(k)).map(|other| (other.at - edge.at).abs());
        let tread = gap.filter(|gap| (narrowest - ROUNDING..=widest + ROUNDING).contains(gap));
        Edge { tread: tread.unwrap_or(alone), ..*edge }
    };
    Some(found.iter().enumerate().map(stair).collect())
}

/// Where the heels stand, and how each step is gone that leads there.
struct Places<'a> {
    levels: &'a [Step],
    at: Vec<f64>,
    /// The rise and tread of each step over an edge.
    over: Vec<Option<(f64, f64)>>,
}

impl<'a> Places<'a> {
    /// A step over each edge, and level ones before, between and after; `None` where they do not go over any.
    fn over(edges: &[Edge], sole: f64, levels: &'a [Step]) -> Option<Self> {
        let mut places = Self { levels, at: vec![0.0], over: Vec::new() };
        let mut ends_before = f64::INFINITY;
        for &Edge { at, rise, tread } in edges {
            let nosing = nosing(rise, tread, sole);
            let (before, lead) =
                if rise > 0.0 { (at - nosing - tread, BEFORE_UP) } else { (at - nosing, BEFORE_DOWN) };
            if places.fill(before, lead).is_none() {
                // Whoever does not come so far stops before it.
                ends_before = at - sole - STOPS_BEFORE;
                break;
            }
            places.push(before + tread, Some((rise, tread)));
        }
        // One level step at least comes after the last edge.
        if places.over.iter().all(Option::is_none) || places.over.len() >= levels.len() {
            return None;
        }
        places.finish(ends_before)?;
        Some(places)
    }

    /// Height and pitch of the prints: beside an edge what the sole stands on is even and leans by [`STEEPEST_BESIDE`] at most, elsewhere it is as everywhere.
    fn prints(&self, relief: &Relief, sole: f64) -> Option<Vec<(f64, f64)>> {
        let print = |(k, z): (usize, &f64)| {
            let into = k.checked_sub(1).and_then(|k| self.over[k]);
            let out = self.over.get(k).copied().flatten();
            if into.is_none() && out.is_none() {
                let foothold = Foothold::at(relief, *z, sole);
                return foothold.holds().then_some((foothold.height, foothold.tilt));
            }
            // Heels overhang on the way up, toes on the way down.
            let overhangs = |(rise, tread): (f64, f64)| nosing(rise, tread, sole);
            let from = into.filter(|(rise, _)| *rise > 0.0).map_or(0.0, overhangs);
            let to = out.filter(|(rise, _)| *rise < 0.0).map_or(sole, overhangs);
            let (from, to) = (z + from + EDGE, z + to - EDGE);
            let (begins, ends) = (relief.height(from), relief.height(to));
            let slope = (ends - begins) / (to - from);
            let line = |at: f64| begins + (at - from) * slope;
            let is_even = |[at, height]: &[f64; 2]| (height - line(*at)).abs() <= EVEN;
            let mut inside = relief.points().iter().filter(|point| (from..=to).contains(&point[0]));
            (slope.atan().abs() <= STEEPEST_BESIDE && inside.all(is_even)).then(|| (line(*z), slope.atan()))
        };
        self.at.iter().enumerate().map(print).collect()
    }

    fn last(&self) -> f64 {
        self.at[self.at.len() - 1]
    }

    fn push(&mut self, at: f64, over: Option<(f64, f64)>) {
        self.at.push(at);
        self.over.push(over);
    }

    /// Lengths of the next `count` level steps, which gain speed after an edge and lose it before the next one.
    fn lengths(&self, count: usize, before: [f64; LEAD]) -> Vec<f64> {
        let made = self.over.len();
        let after = self.over.iter().rev().take_while(|over| over.is_none()).count();
        let gains = |i: usize| match AFTER_STAIRS.get(after + i) {
            Some(factor) if after < made => *factor,
            _ => 1.0,
        };
        let loses = |i: usize| if count - i <= LEAD { before[LEAD - (count - i)] } else { 1.0 };
        (0..count).map(|i| self.levels[made + i].length * gains(i).min(loses(i))).collect()
    }

    /// Level steps of these lengths, each so many times as long.
    fn go(&mut self, lengths: &[f64], by: f64) {
        for length in lengths {
            self.push(self.last() + by * length, None);
        }
    }

    /// Goes on by level steps to `to`: as many as come nearest to what they would be. `None` where none fit, or where there are not so many left.
    fn fill(&mut self, to: f64, before: [f64; LEAD]) -> Option<()> {
        let distance = to - self.last();
        if distance.abs() < 1e-6 {
            return Some(());
        }
        let left = self.levels.len().saturating_sub(self.over.len());
        let fitted = (1..=left).map(|count| {
            let lengths = self.lengths(count, before);
            let by = distance / lengths.iter().sum::<f64>();
            (lengths, by)
        });
        let (lengths, by) = fitted
            .filter(|(_, by)| (FITTED.0..=FITTED.1).contains(by))
            .min_by(|(_, a), (_, b)| a.ln().abs().total_cmp(&b.ln().abs()))?;
        self.go(&lengths, by);
        Some(())
    }

    /// Makes the steps that are left, and comes no farther than `to`.
    fn finish(&mut self, to: f64) -> Option<()> {
        let lengths = self.lengths(self.levels.len() - self.over.len(), [1.0; LEAD]);
        let by = ((to - self.last()) / lengths.iter().sum::<f64>().max(1e-9)).min(1.0);
        self.go(&lengths, by);
        (by >= FITTED.0).then_some(())
    }
}

impl Terrain {
    /// Over a relief whose edges are gone over as stairs; `None` where it has none, or where feet find no place between them.
    pub(super) fn over_edges(
        relief: &Relief,
        leg: &LegGeometry,
        usual: f64,
        levels: &[Step],
    ) -> Option<Self> {
        ALONE.iter().find_map(|alone| Self::over(&edges(relief, *alone)?, relief, leg, usual, levels))
    }

    fn over(edges: &[Edge], relief: &Relief, leg: &LegGeometry, usual: f64, levels: &[Step]) -> Option<Self> {
        let places = Places::over(edges, leg.foot_length(), levels)?;
        let prints = places.prints(relief, leg.foot_length())?;
        let (heights, tilts): (Vec<f64>, Vec<f64>) = prints.into_iter().unzip();
        let count = levels.len();
        let (mut steps, mut kinds) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for (k, level) in levels.iter().enumerate() {
            let (ahead, rise) = (places.at[k + 1] - places.at[k], heights[k + 1] - heights[k]);
            kinds.push(match places.over[k] {
                Some((_, tread)) => StepKind::Stairs { rise, tread },
                None => StepKind::Slope(rise.atan2(ahead), ahead.min(usual)),
            });
            steps.push(Step { length: ahead, rise, tilt: tilts[k + 1], ..*level });
        }
        let points = relief.points().iter().map(|[z, y]| [*z, *y - heights[0]]).collect();
        let relief = Relief::new(points).map_err(RequestError::Relief).ok()?;
        Some(Self { relief, steps, kinds, standing: tilts[0] })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOLE: f64 = 0.26;

    /// Places of the heels, which steps go over an edge, and the prints.
    type Gone = (Vec<f64>, Vec<bool>, Vec<(f64, f64)>);

    fn places(points: &[[f64; 2]], steps: usize) -> Option<Gone> {
        let relief = Relief::new(points.to_vec()).expect("a relief");
        let levels = vec![Step::along_an_arc(0, 0.6, 0.0); steps];
        let places = Places::over(&edges(&relief, ALONE[0])?, SOLE, &levels)?;
        let prints = places.prints(&relief, SOLE)?;
        Some((places.at, places.over.iter().map(Option::is_some).collect(), prints))
    }

    #[test]
    fn one_short_step_goes_over_a_kerb() {
        let (at, over, prints) = places(&[[2.0, 0.0], [2.0, 0.15]], 8).expect("it is climbed");
        let k = over.iter().position(|over| *over).expect("a step over it");
        assert_eq!(over.iter().filter(|over| **over).count(), 1);
        // The heel overhangs by 2 cm, and the step is 0.32 m.
        assert!((at[k + 1] - 1.98).abs() < 1e-12 && (at[k + 1] - at[k] - 0.32).abs() < 1e-12);
        assert!(prints[..=k].iter().all(|print| *print == (0.0, 0.0)));
        assert!(prints[k + 1..].iter().all(|print| *print == (0.15, 0.0)) && at.len() == 9);
    }

    #[test]
    fn measured_ground_is_climbed_too() {
        // A kerb of 2 cm's width, in points 1 cm apart that are uneven by some hundredths of a millimetre.
        let noise = |i: u32| 1e-5 * f64::from(i * 7 % 5);
        let measured: Vec<[f64; 2]> = (0..600)
            .map(|i| [0.01 * f64::from(i), (0.075 * (f64::from(i) - 200.0)).clamp(0.0, 0.15) + noise(i)])
            .collect();
        let (at, over, _) = places(&measured, 8).expect("it is climbed");
        let k = over.iter().position(|over| *over).expect("a step over it");
        assert!((at[k + 1] - 2.0).abs() < 1e-6, "{at:?}");
    }

    #[test]
    fn edges_that_follow_each_other_are_stairs() {
        let stairs = [[2.0, 0.0], [2.0, -0.1], [2.3, -0.1], [2.3, -0.2], [2.58, -0.2], [2.58, -0.3]];
        let (at, over, _) = places(&stairs, 12).expect("they are climbed");
        let k = over.iter().position(|over| *over).expect("a step over the first");
        assert_eq!(over[k..k + 4], [true, true, true, false]);
        for (i, tread) in [0.30, 0.28, ALONE[0]].into_iter().enumerate() {
            assert!((at[k + i + 1] - at[k + i] - tread).abs() < 1e-12, "{at:?}");
        }
    }

    #[test]
    fn what_cannot_be_climbed_is_left() {
        // Too high, too low to be one, none; too few steps for the way, and for what comes after it.
        for points in [[[2.0, 0.0], [2.0, 0.3]], [[2.0, 0.0], [2.0, 0.03]], [[2.0, 0.0], [2.03, 0.1]]] {
            assert!(places(&points, 8).is_none(), "{points:?}");
        }
        // A bar under the sole.
        let bar = [[2.0, 0.0], [2.0, 0.15], [2.1, 0.15], [2.1, 0.18], [2.11, 0.18], [2.11, 0.15]];
        assert!(places(&bar, 8).is_none());
        // A slope in small pieces is a slope.
        let slope: Vec<[f64; 2]> =
            (0..=10).map(|i| [2.0 + 0.01 * f64::from(i), 0.015 * f64::from(i)]).collect();
        assert!(places(&slope, 8).is_none());
        for steps in 1..5 {
            assert!(places(&[[2.0, 0.0], [2.0, 0.15]], steps).is_none(), "{steps} steps");
        }
        // Whoever does not come to the second one stops before it.
        let two = [[1.5, 0.0], [1.5, 0.1], [6.0, 0.1], [6.0, 0.2]];
        let (at, over, _) = places(&two, 11).expect("the first is climbed");
        assert_eq!(over.iter().filter(|over| **over).count(), 1);
        assert!(at[11] + SOLE < 6.0 - 0.9 * STOPS_BEFORE, "{at:?}");
    }
}

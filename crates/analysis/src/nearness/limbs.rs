//! The nearest limbs of a motion, by name: which, when, how deep in each other and for how long.

use super::{Near, Nearness};
use solaris_model::Figure;
use std::collections::BTreeMap;

/// How near limbs come to each other in a motion. Distances are negative for the depth of an overlap.
///
/// With the feature `serde` its keys are `distance_m`, `at_s`, `links`, `pairs`, `left_out`, `overlaps` and `spells`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct NearestLimbs {
    /// The least distance (m).
    #[cfg_attr(feature = "serde", serde(rename = "distance_m"))]
    pub distance: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "at_s"))]
    pub time: f64,
    /// Between which two links.
    pub links: [String; 2],
    /// Pairs that were measured.
    pub pairs: usize,
    /// Pairs that were not, because they overlap with every joint at zero.
    pub left_out: Vec<[String; 2]>,
    /// Pairs that go into each other by more than [`LimbOverlap::TOLD`], the deepest first.
    pub overlaps: Vec<LimbOverlap>,
    /// Which pair was the nearest, one after the other.
    pub spells: Vec<NearSpell>,
}

/// Two limbs in each other; in frames in which another pair is deeper, that one alone counts.
///
/// With the feature `serde` its keys are `links`, `depth_m`, `at_s`, `from_s`, `to_s` and `lasts_s`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct LimbOverlap {
    /// Which two links.
    pub links: [String; 2],
    /// The greatest depth (m).
    #[cfg_attr(feature = "serde", serde(rename = "depth_m"))]
    pub depth: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "at_s"))]
    pub time: f64,
    /// When it is first deeper than [`Self::TOLD`] (s).
    #[cfg_attr(feature = "serde", serde(rename = "from_s"))]
    pub from: f64,
    /// When it is last so deep (s).
    #[cfg_attr(feature = "serde", serde(rename = "to_s"))]
    pub to: f64,
    /// For how long in all (s).
    #[cfg_attr(feature = "serde", serde(rename = "lasts_s"))]
    pub lasts: f64,
}

impl LimbOverlap {
    /// The depth from which on an overlap is told (m): more than what clothes and flesh give way.
    pub const TOLD: f64 = 0.01;
}

/// Frames on end in which the same pair is the nearest.
///
/// With the feature `serde` its keys are `links`, `from_s`, `to_s`, `distance_m` and `at_s`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct NearSpell {
    /// Which two links.
    pub links: [String; 2],
    /// From when (s).
    #[cfg_attr(feature = "serde", serde(rename = "from_s"))]
    pub from: f64,
    /// Until when (s).
    #[cfg_attr(feature = "serde", serde(rename = "to_s"))]
    pub to: f64,
    /// The least distance in that time (m).
    #[cfg_attr(feature = "serde", serde(rename = "distance_m"))]
    pub distance: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "at_s"))]
    pub time: f64,
}

impl Nearness {
    /// What was found, by the names of the figure's links; `time` (s) is the motion's.
    pub fn limbs(&self, figure: &Figure, time: &[f64]) -> NearestLimbs {
        let names = |pair: &[usize; 2]| pair.map(|link| figure.links()[link].name().to_owned());
        let frames: Vec<(f64, Near)> = time.iter().copied().zip(self.frames.iter().copied()).collect();
        NearestLimbs {
            distance: self.nearest.distance,
            time: self.nearest.time,
            links: self.nearest.links.clone(),
            pairs: self.pairs.len() + self.of_others,
            left_out: self.left_out.iter().map(names).collect(),
            overlaps: overlaps(&frames, &names),
            spells: frames
                .chunk_by(|a, b| a.1.links == b.1.links)
                .map(|frames| spell(frames, &names))
                .collect(),
        }
    }
}

/// Frames of one pair.
fn spell(frames: &[(f64, Near)], names: &dyn Fn(&[usize; 2]) -> [String; 2]) -> NearSpell {
    let (from, first) = frames[0];
    let nearest = |a: (f64, Near), b: &(f64, Near)| if b.1.distance < a.1.distance { *b } else { a };
    let (time, Near { distance, .. }) = frames.iter().fold(frames[0], nearest);
    NearSpell { links: names(&first.links), from, to: frames[frames.len() - 1].0, distance, time }
}

/// The overlaps that are told, each with how deep it is and when.
fn overlaps(frames: &[(f64, Near)], names: &dyn Fn(&[usize; 2]) -> [String; 2]) -> Vec<LimbOverlap> {
    let mut found: BTreeMap<[usize; 2], LimbOverlap> = BTreeMap::new();
    let deep = |(_, (_, near)): &(usize, &(f64, Near))| near.distance < -LimbOverlap::TOLD;
    for (i, &(time, near)) in frames.iter().enumerate().filter(deep) {
        // A frame lasts until the next one.
        let lasts = frames.get(i + 1).map_or(0.0, |(next, _)| next - time);
        let depth = -near.distance;
        let overlap = found.entry(near.links).or_insert_with(|| {
            let links = names(&near.links);
            LimbOverlap { links, depth, time, from: time, to: time, lasts: 0.0 }
        });
        if depth > overlap.depth {
            (overlap.depth, overlap.time) = (depth, time);
        }
        overlap.to = time;
        overlap.lasts += lasts;
    }
    let mut found: Vec<LimbOverlap> = found.into_values().collect();
    found.sort_by(|a, b| b.depth.total_cmp(&a.depth));
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_abs_diff_eq;

    #[test]
    fn overlaps_are_told_from_a_centimetre_on_the_deepest_first() {
        let frame =
            |i: usize, distance: f64, pair: usize| (i as f64 * 0.1, Near { distance, links: [pair, 7] });
        let frames = [
            frame(0, 0.02, 0),
            frame(1, -0.009, 0),
            frame(2, -0.02, 0),
            frame(3, -0.03, 0),
            frame(4, -0.05, 1),
            frame(5, 0.0, 1),
            frame(6, -0.011, 0),
            frame(7, 0.1, 0),
        ];
        let found = overlaps(&frames, &|[a, b]| [format!("a{a}"), format!("b{b}")]);
        let names: Vec<&str> = found.iter().map(|overlap| overlap.links[0].as_str()).collect();
        assert_eq!(names, ["a1", "a0"]);
        for (overlap, [depth, time, from, to, lasts]) in
            found.iter().zip([[0.05, 0.4, 0.4, 0.4, 0.1], [0.03, 0.3, 0.2, 0.6, 0.3]])
        {
            assert_abs_diff_eq!(overlap.depth, depth);
            for (found, expected) in
                [(overlap.time, time), (overlap.from, from), (overlap.to, to), (overlap.lasts, lasts)]
            {
                assert_abs_diff_eq!(found, expected, epsilon = 1e-12);
            }
        }
        assert!(overlaps(&[], &|_| [String::new(), String::new()]).is_empty());
    }
}

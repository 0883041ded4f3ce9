//! Distances and overlaps of a figure's limbs, as numbers and in words.

use crate::error::CliError;
use serde::Serialize;
use solaris::analysis::{Near, Nearness, nearness};
use solaris::model::{Figure, Motion};

/// Distances in m, negative for the depth of an overlap.
#[derive(Debug, Serialize)]
pub(crate) struct Limbs {
    pub(crate) distance_m: f64,
    pub(crate) at_s: f64,
    pub(crate) links: [String; 2],
    /// Pairs that were measured.
    pub(crate) pairs: usize,
    /// Pairs that were not, for they overlap with every joint at zero.
    pub(crate) left_out: Vec<[String; 2]>,
    /// Pairs that go into each other by more than a centimetre, the deepest first.
    pub(crate) overlaps: Vec<Overlap>,
    /// Which pair was the nearest, one after the other.
    pub(crate) spells: Vec<Spell>,
}

/// Two limbs in each other; in frames in which another pair is deeper, that one alone counts.
#[derive(Debug, Serialize)]
pub(crate) struct Overlap {
    pub(crate) links: [String; 2],
    pub(crate) depth_m: f64,
    pub(crate) at_s: f64,
    /// When it is first and last deeper than a centimetre, and for how long in all.
    pub(crate) from_s: f64,
    pub(crate) to_s: f64,
    pub(crate) lasts_s: f64,
}

/// The depth from which on an overlap is told (m): more than what clothes and flesh give way.
const TOLD: f64 = 0.01;

/// Frames on end in which the same pair is the nearest.
#[derive(Debug, Serialize)]
pub(crate) struct Spell {
    pub(crate) links: [String; 2],
    pub(crate) from_s: f64,
    pub(crate) to_s: f64,
    /// The least distance in that time.
    pub(crate) distance_m: f64,
    pub(crate) at_s: f64,
}

impl Limbs {
    /// None where a figure has nothing to measure.
    pub(crate) fn of(figure: &Figure, motion: &Motion) -> Result<Option<Self>, CliError> {
        let found = nearness(figure, motion).map_err(CliError::other)?;
        Ok(found.map(|found| Self::new(figure, motion.time(), found)))
    }

    fn new(figure: &Figure, time: &[f64], found: Nearness) -> Self {
        let names = |pair: &[usize; 2]| pair.map(|link| figure.links()[link].name().to_owned());
        let frames: Vec<(f64, Near)> = time.iter().copied().zip(found.frames).collect();
        let spell = |frames: &[(f64, Near)]| {
            let (from_s, first) = frames[0];
            let nearest = |a: (f64, Near), b: &(f64, Near)| if b.1.distance < a.1.distance { *b } else { a };
            let (at_s, Near { distance, .. }) = frames.iter().fold(frames[0], nearest);
            let to_s = frames[frames.len() - 1].0;
            Spell { links: names(&found.pairs[first.pair]), from_s, to_s, distance_m: distance, at_s }
        };
        Self {
            distance_m: found.nearest.distance,
            at_s: found.nearest.time,
            links: found.nearest.links,
            pairs: found.pairs.len(),
            left_out: found.left_out.iter().map(names).collect(),
            overlaps: overlaps(&frames, found.pairs.len(), &|pair| names(&found.pairs[pair])),
            spells: frames.chunk_by(|a, b| a.1.pair == b.1.pair).map(spell).collect(),
        }
    }

    /// Which limbs go into each other by more than a centimetre, how deep, when and how long, if any do.
    pub(crate) fn overlap_note(&self) -> Option<String> {
        note(&self.overlaps)
    }

    /// The least distance or the greatest depth, in mm.
    pub(crate) fn millimetres(&self) -> String {
        format!("{:.1}", 1e3 * self.distance_m.abs())
    }

    /// Which, and when.
    pub(crate) fn note(&self) -> String {
        let ([a, b], at) = (&self.links, self.at_s);
        let overlap = if self.distance_m < 0.0 { "overlap, " } else { "" };
        format!("{overlap}{a} and {b}, at {at:.3} s")
    }
}

/// The overlaps that are told, each with how deep it is and when.
fn overlaps(frames: &[(f64, Near)], pairs: usize, names: &dyn Fn(usize) -> [String; 2]) -> Vec<Overlap> {
    let mut found: Vec<Option<Overlap>> = (0..pairs).map(|_| None).collect();
    for (i, (time, near)) in frames.iter().enumerate().filter(|(_, (_, near))| near.distance < -TOLD) {
        // A frame lasts until the next one.
        let lasts = frames.get(i + 1).map_or(0.0, |(next, _)| next - time);
        let (depth, at_s) = (-near.distance, *time);
        let overlap = found[near.pair].get_or_insert_with(|| Overlap {
            links: names(near.pair),
            depth_m: depth,
            at_s,
            from_s: at_s,
            to_s: at_s,
            lasts_s: 0.0,
        });
        if depth > overlap.depth_m {
            (overlap.depth_m, overlap.at_s) = (depth, at_s);
        }
        overlap.to_s = at_s;
        overlap.lasts_s += lasts;
    }
    let mut found: Vec<Overlap> = found.into_iter().flatten().collect();
    found.sort_by(|a, b| b.depth_m.total_cmp(&a.depth_m));
    found
}

/// What there is to say of overlaps, in one sentence; nothing where there are none.
fn note(overlaps: &[Overlap]) -> Option<String> {
    let one = |overlap: &Overlap| {
        let ([a, b], depth) = (&overlap.links, 1e3 * overlap.depth_m);
        format!("{a} and {b} by {depth:.0} mm at {:.2} s, {:.2} s in all", overlap.at_s, overlap.lasts_s)
    };
    let all = overlaps.iter().map(one).collect::<Vec<_>>().join("; ");
    (!overlaps.is_empty())
        .then(|| format!("limbs go into each other by more than {:.0} mm: {all}", 1e3 * TOLD))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn overlaps_are_told_from_a_centimetre_on_the_deepest_first() {
        let frame = |i: usize, distance: f64, pair: usize| (i as f64 * 0.1, Near { distance, pair });
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
        let told = overlaps(&frames, 2, &|pair| [format!("a{pair}"), format!("b{pair}")]);
        assert_eq!(
            note(&told).as_deref(),
            Some(
                "limbs go into each other by more than 10 mm: a1 and b1 by 50 mm at 0.40 s, 0.10 s in all; a0 and b0 by 30 mm at \
                 0.30 s, 0.30 s in all"
            )
        );
        assert_eq!(note(&[]), None);
    }
}

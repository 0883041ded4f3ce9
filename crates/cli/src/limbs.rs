//! How near a figure's limbs came to each other, as numbers and in words.

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
    /// Which pair was the nearest, one after the other.
    pub(crate) spells: Vec<Spell>,
}

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
            spells: frames.chunk_by(|a, b| a.1.pair == b.1.pair).map(spell).collect(),
        }
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

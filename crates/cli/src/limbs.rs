//! How near a figure's limbs came to each other, as numbers and in words.

use crate::error::CliError;
use serde::Serialize;
use solaris::model::{Figure, Motion};
use solaris::modes::{Nearness, nearness};

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
    /// The least of every frame.
    pub(crate) frames: Frames,
}

/// A number for each frame.
#[derive(Debug, Serialize)]
pub(crate) struct Frames {
    pub(crate) distance_m: Vec<f64>,
    /// Which of `nearest`.
    pub(crate) pair: Vec<usize>,
    /// The pairs that are the nearest in some frame, in the order in which they become it.
    pub(crate) nearest: Vec<[String; 2]>,
}

impl Limbs {
    /// None where a figure has nothing to measure.
    pub(crate) fn of(figure: &Figure, motion: &Motion) -> Result<Option<Self>, CliError> {
        let found = nearness(figure, motion).map_err(CliError::other)?;
        Ok(found.map(|found| Self::new(figure, found)))
    }

    fn new(figure: &Figure, found: Nearness) -> Self {
        let names = |pair: &[usize; 2]| pair.map(|link| figure.links()[link].name().to_owned());
        let mut places = vec![None; found.pairs.len()];
        let mut nearest = Vec::new();
        let place = |near: &solaris::modes::Near| {
            *places[near.pair].get_or_insert_with(|| {
                nearest.push(names(&found.pairs[near.pair]));
                nearest.len() - 1
            })
        };
        let pair = found.frames.iter().map(place).collect();
        let distance_m = found.frames.iter().map(|near| near.distance).collect();
        Self {
            distance_m: found.nearest.distance,
            at_s: found.nearest.time,
            links: found.nearest.links,
            pairs: found.pairs.len(),
            left_out: found.left_out.iter().map(names).collect(),
            frames: Frames { distance_m, pair, nearest },
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

//! Distances and overlaps of a figure's limbs, in words.

use crate::error::CliError;
use solaris::analysis::{LimbOverlap, NearestLimbs, nearness_but};
use solaris::model::{Figure, Motion};

/// How near limbs come to each other but for pairs of links that something holds together; none where a figure has nothing to measure.
pub(crate) fn nearest(
    figure: &Figure,
    motion: &Motion,
    joined: &[[usize; 2]],
) -> Result<Option<NearestLimbs>, CliError> {
    let found = nearness_but(figure, motion, joined).map_err(CliError::other)?;
    Ok(found.map(|found| found.limbs(figure, motion.time())))
}

/// Which limbs go into each other by more than a centimetre, how deep, when and how long, if any do.
pub(crate) fn overlap_note(limbs: &NearestLimbs) -> Option<String> {
    let one = |overlap: &LimbOverlap| {
        let ([a, b], depth) = (&overlap.links, 1e3 * overlap.depth);
        format!("{a} and {b} by {depth:.0} mm at {:.2} s, {:.2} s in all", overlap.time, overlap.lasts)
    };
    let all = limbs.overlaps.iter().map(one).collect::<Vec<_>>().join("; ");
    let least = 1e3 * LimbOverlap::TOLD;
    (!all.is_empty()).then(|| format!("limbs go into each other by more than {least:.0} mm: {all}"))
}

/// The least distance or the greatest depth, in mm.
pub(crate) fn millimetres(limbs: &NearestLimbs) -> String {
    format!("{:.1}", 1e3 * limbs.distance.abs())
}

/// Which, and when.
pub(crate) fn note(limbs: &NearestLimbs) -> String {
    let ([a, b], at) = (&limbs.links, limbs.time);
    let overlap = if limbs.distance < 0.0 { "overlap, " } else { "" };
    format!("{overlap}{a} and {b}, at {at:.3} s")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn overlaps_are_told_in_one_sentence() {
        let overlap = |name: &str, depth: f64, time: f64, lasts: f64| LimbOverlap {
            links: ["a", "b"].map(|limb| format!("{limb}{name}")),
            depth,
            time,
            from: time,
            to: time,
            lasts,
        };
        let mut limbs = NearestLimbs {
            distance: -0.05,
            time: 0.4,
            links: ["a1", "b1"].map(str::to_owned),
            pairs: 2,
            left_out: Vec::new(),
            overlaps: vec![overlap("1", 0.05, 0.4, 0.1), overlap("0", 0.03, 0.3, 0.3)],
            spells: Vec::new(),
        };
        assert_eq!(
            overlap_note(&limbs).as_deref(),
            Some(
                "limbs go into each other by more than 10 mm: a1 and b1 by 50 mm at 0.40 s, 0.10 s in all; a0 and b0 by 30 mm at \
                 0.30 s, 0.30 s in all"
            )
        );
        limbs.overlaps.clear();
        assert_eq!(overlap_note(&limbs), None);
    }
}

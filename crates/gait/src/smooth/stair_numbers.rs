//! The numbers of a stride on stairs besides those of a style.

use crate::limbs::path::{Passing, SoleEnd};

/// How far a heel print overhangs the nosing of its tread on the way up (m), and the part of the foot's length by which its toes do on the
/// way down (people's: 17 ± 7 %).
pub(crate) const HEEL_OVERHANGS: f64 = 0.02;
pub(crate) const TOES_OVERHANG: f64 = 0.17;

/// What a stride on stairs has besides the style of level ground: the foot lands on its ball, and swings over the nosings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StairNumbers {
    /// Rise of a step, negative on the way down (m).
    pub rise: f64,
    /// Pitch of the foot as its ball lands (rad, toe down), and the rate that it comes down with, see `Landing::Ball`.
    pub landing_pitch: f64,
    /// See [`Self::landing_pitch`].
    pub landing_rate: f64,
    /// Centre of pressure (parts of the foot's length from the heel): at contact, on the flat foot, in mid-stance and when that is (u), and at
    /// toe-off.
    pub cop_contact: f64,
    /// See [`Self::cop_contact`].
    pub cop_flat: f64,
    /// See [`Self::cop_contact`].
    pub cop_middle: (f64, f64),
    /// See [`Self::cop_contact`].
    pub cop_end: f64,
    /// The two passings of a nosing: when (u), how far above it (m), and the foot's pitch (rad).
    pub passings: [(f64, f64, f64); 2],
}

impl StairNumbers {
    /// How a foot passes the nosings of stairs with this tread (m), seen from the print that it leaves.
    pub(crate) fn passings(&self, tread: f64, foot_length: f64) -> [Passing; 2] {
        std::array::from_fn(|i| {
            let (at, above, pitch) = self.passings[i];
            let (nosing, number) = if self.rise > 0.0 {
                (HEEL_OVERHANGS, i as f64 + 1.0)
            } else {
                ((1.0 - TOES_OVERHANG) * foot_length, i as f64)
            };
            Passing {
                at,
                end: self.end(),
                pitch,
                place: [number * self.rise + above, nosing + number * tread],
            }
        })
    }

    /// The end of the sole that passes the nosings.
    pub(crate) fn end(&self) -> SoleEnd {
        if self.rise > 0.0 { SoleEnd::Tip } else { SoleEnd::Heel }
    }

    /// For a check of all numbers at once.
    pub(super) fn sum(&self) -> f64 {
        let passings: f64 = self.passings.iter().map(|(at, above, pitch)| at + above + pitch).sum();
        self.rise
            + self.landing_pitch
            + self.landing_rate
            + self.cop_contact
            + self.cop_flat
            + self.cop_middle.0
            + self.cop_middle.1
            + self.cop_end
            + passings
    }
}

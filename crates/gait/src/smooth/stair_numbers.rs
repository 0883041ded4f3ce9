//! The numbers of a stride on stairs besides those of a style.

use crate::limbs::path::{Passing, SoleEnd};

/// How far a heel print overhangs the nosing of its tread on the way up at least, and how far its tip stays behind the next riser (m).
const HEEL_OVERHANGS: f64 = 0.02;
const BEFORE_RISER: f64 = 0.01;
/// The part of the foot's length by which its toes overhang on the way down (people's: 17 ± 7 %).
const TOES_OVERHANG: f64 = 0.17;

/// How far the nosing of a foot's tread is ahead of its heel (m): on the way up the heel overhangs, the more the longer the foot is for the
/// tread; on the way down the toes do.
pub(crate) fn nosing(rise: f64, tread: f64, foot_length: f64) -> f64 {
    if rise > 0.0 {
        HEEL_OVERHANGS.max(foot_length + BEFORE_RISER - tread)
    } else {
        (1.0 - TOES_OVERHANG) * foot_length
    }
}

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
            let number = if self.rise > 0.0 { i as f64 + 1.0 } else { i as f64 };
            Passing {
                at,
                end: self.end(),
                pitch,
                place: Some([
                    number * self.rise + above,
                    nosing(self.rise, tread, foot_length) + number * tread,
                ]),
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

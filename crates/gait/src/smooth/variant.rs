//! Other styles on ground that is not level, for where the usual one does not hold.

use super::style::Style;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// By how much a style differs from the usual one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct StyleVariant {
    /// In parts of a stride.
    double_support: f64,
    /// In parts of a stride.
    foot_flat: f64,
    /// In parts of a stride.
    heel_off: f64,
    /// In parts of the usual one.
    share_exponent: f64,
    /// In degrees.
    knee_contact: f64,
    /// In degrees by u.
    knee_toe_off_rate: f64,
    /// In degrees.
    toe_roll: f64,
    /// In degrees.
    landing_pitch: f64,
}

impl StyleVariant {
    pub(crate) const USUAL: Self = Self {
        double_support: 0.0,
        foot_flat: 0.0,
        heel_off: 0.0,
        share_exponent: 0.0,
        knee_contact: 0.0,
        knee_toe_off_rate: 0.0,
        toe_roll: 0.0,
        landing_pitch: 0.0,
    };
    /// Up stairs: a shorter double support, with a heel that stays on the tread for longer, or a foot that is flat later; or a load that goes over more
    /// evenly; or a heel that stays for much longer, on high stairs with deep treads. Of 300 random people of 1.3 to 2 m on all stairs that strides were tried on 40
    /// were refused in the usual style, and none with these.
    pub(crate) const UP_STAIRS: [Self; 4] = [
        Self { double_support: -0.05, heel_off: 0.03, ..Self::USUAL },
        Self { double_support: -0.05, foot_flat: 0.02, ..Self::USUAL },
        Self { share_exponent: -0.3, ..Self::USUAL },
        Self { heel_off: 0.06, ..Self::USUAL },
    ];
    /// Down them, where 75 of 340 were and 14 are, most of them below 1.4 m: a knee that lands more bent, bends more slowly as the foot leaves, over toes
    /// that roll.
    pub(crate) const DOWN_STAIRS: [Self; 3] = [
        Self { landing_pitch: 4.0, ..Self::YIELDING },
        Self { knee_contact: 10.0, knee_toe_off_rate: -200.0, ..Self::YIELDING },
        Self { landing_pitch: 4.0, knee_contact: 10.0, ..Self::YIELDING },
    ];
    const YIELDING: Self =
        Self { knee_contact: 5.0, knee_toe_off_rate: -100.0, toe_roll: 8.0, ..Self::USUAL };
    /// On slopes: a knee that bends faster as the foot leaves, over toes that roll or after a heel that stays for longer. Of 150 random people up 12 to 15° 36 were
    /// refused without them and without slower ends, and 22 with them; of 250 down 23 and 20.
    pub(crate) const ON_SLOPES: [Self; 2] = [
        Self { knee_toe_off_rate: 200.0, toe_roll: 8.0, ..Self::USUAL },
        Self { knee_toe_off_rate: 100.0, heel_off: 0.03, ..Self::USUAL },
    ];
}

impl Style {
    /// The same in another way.
    pub(crate) fn varied(mut self, by: &StyleVariant) -> Self {
        self.double_support += by.double_support;
        self.foot_flat += by.foot_flat;
        self.heel_off += by.heel_off;
        self.share_exponent *= 1.0 + by.share_exponent;
        self.knee_contact += by.knee_contact * DEGREE;
        self.knee_toe_off_rate += by.knee_toe_off_rate * DEGREE;
        self.toe_roll += by.toe_roll * DEGREE;
        if let Some(stairs) = &mut self.stairs {
            stairs.landing_pitch += by.landing_pitch * DEGREE;
        }
        self
    }
}

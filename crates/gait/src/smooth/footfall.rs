//! How feet meet the ground and leave it, where people's do otherwise than those of the recipe.

use solaris_profiles::step;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// How often the planned double support is held against what a plate sees of it.
const CORRECTIONS: usize = 4;
/// Halvings that find when the share has risen so far: to 1e-9 of a double support.
const HALVINGS: usize = 30;
/// Until when the centre of pressure is outermost (u), and from when on it goes inward: in parts of the stance.
const OUTWARD_UNTIL: f64 = 0.22;
const INWARD_FROM: f64 = 0.34;

/// How a foot meets the ground and leaves it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Footfall {
    /// The vertical force (N) from which on a foot counts as standing in the law of double support; none for 0, where it counts from
    /// touch-down to lift-off.
    pub threshold: f64,
    /// The part of the load share that rises and falls evenly over double support; the rest does so without a rate at its ends.
    pub even_share: f64,
    /// Where its centre of pressure is at contact, while it comes down and as it is flat: parts of its length from the heel.
    pub cop_landing: [f64; 3],
    /// When the centre of pressure is at the style's `cop_middle` (u); as the heel rises for `None`, since a rigid foot is pressed on its ball from
    /// then on. A heel rises by so little at first that the ball has some time.
    pub cop_middle_at: Option<f64>,
    /// How far outward of the foot's axis its centre of pressure is at contact, in mid-stance and at toe-off, in parts of its length.
    pub cop_outward: [f64; 3],
    /// Over how much pitch (rad) a foot comes to be flat, or begins to rise, where the leg's law would have it go through the ground;
    /// for 0 it stops at once.
    pub softness: f64,
    /// Whether a foot's pitch goes through its contact with a continuous second derivative. Its duration (u).
    pub soft_landing: Option<f64>,
    /// Until when its clearance is asked for in full, and over how long it comes to be no more: parts of the swing.
    pub clear_until: (f64, f64),
    /// When a heel rises at the latest (u): the leg of a flat foot is too short for later in fast walks' first steps.
    pub latest_heel_off: f64,
}

impl Footfall {
    /// Of the recipe that the golden walks were made with.
    pub const RECIPE: Self = Self {
        threshold: 0.0,
        even_share: 0.0,
        cop_landing: [0.0, 0.012, 0.035],
        cop_middle_at: None,
        cop_outward: [0.0; 3],
        softness: 0.0,
        soft_landing: None,
        clear_until: (0.80, 0.2),
        latest_heel_off: f64::MAX,
    };

    /// The recipe's, rounded off where a foot meets the ground and leaves it: no joint jerks there.
    pub const SMOOTH: Self = Self { softness: 0.4 * DEGREE, soft_landing: Some(0.03), ..Self::RECIPE };

    /// On ground that is not level, whose changes of the style were fitted with the recipe's footfall. A leg comes down there otherwise than in a steady stride, and a
    /// foot that was stopped at once pressed up to 18 mm beside itself for some milliseconds, in 16 of 284 random walks; with this softness one does so in 4 of as
    /// many, which the check finds.
    pub const ON_GROUND: Self = Self { softness: 2.0 * DEGREE, ..Self::RECIPE };

    /// Of people: plates see a foot from 20 N on; the pressure begins a little outside of the heel's middle, goes outward under the
    /// middle of the foot and inward to the great toe.
    pub const PEOPLE: Self = Self {
        threshold: 20.0,
        even_share: 0.7,
        cop_landing: [0.0, 0.02, 0.06],
        cop_middle_at: Some(0.30),
        cop_outward: [0.015, 0.07, -0.06],
        softness: 0.5 * DEGREE,
        soft_landing: Some(0.022),
        clear_until: (0.86, 0.2),
        latest_heel_off: 0.316,
    };

    /// How far outward of the foot's axis its centre of pressure is, in parts of the foot's length, `v` after contact.
    pub(crate) fn outward(&self, v: f64, toe_off: f64) -> f64 {
        let [contact, middle, end] = self.cop_outward;
        contact
            + (middle - contact) * step::quintic(v / OUTWARD_UNTIL).position
            + (end - middle) * step::quintic((v - INWARD_FROM) / (toe_off - INWARD_FROM)).position
    }

    /// Rise of the load share when the part `x` of double support is over: `(1 − λ) S3(x^se) + λ x`.
    pub(super) fn share_risen(&self, x: f64, exponent: f64) -> f64 {
        let x = x.clamp(0.0, 1.0);
        let rounded = step::cubic(x.powf(exponent)).position;
        rounded + self.even_share * (x - rounded)
    }

    /// The double support from touch-down to lift-off of which a plate sees `seen` (both parts of the stride), for a load share with this
    /// exponent and a vertical force (N) by the clock.
    ///
    /// A plate that takes a foot for lifted below `T` sees the leading foot from `x₀·d` on and the trailing one until `x₁·d`; with the
    /// load share's rise `s(x)`:
    ///
    /// ```text
    /// s(x₀) F_y(x₀ d) = T      (1 − s(x₁)) F_y(x₁ d) = T      seen = (x₁ − x₀)·d
    /// ```
    ///
    /// The force hardly changes over a correction of `d`, so that a few suffice.
    pub(super) fn planned_double_support(
        &self,
        seen: f64,
        exponent: f64,
        vertical: impl Fn(f64) -> f64,
    ) -> f64 {
        if self.threshold <= 0.0 {
            return seen;
        }
        let (mut planned, mut ends) = (seen, (0.0, 1.0));
        for _ in 0..CORRECTIONS {
            let part = |x: f64| {
                let force = vertical(x * planned);
                if force > 2.0 * self.threshold { self.threshold / force } else { 0.5 }
            };
            let seen_from = self.risen_to(part(ends.0), exponent);
            ends = (seen_from, self.risen_to(1.0 - part(ends.1), exponent));
            // Less would be two feet that a plate hardly sees at once: no walk of people's.
            planned = seen / (ends.1 - ends.0).max(0.5);
        }
        planned
    }

    /// The part of a double support after which the load share has risen to `share`.
    fn risen_to(&self, share: f64, exponent: f64) -> f64 {
        let (mut from, mut to) = (0.0, 1.0);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (from + to);
            if self.share_risen(middle, exponent) < share {
                from = middle;
            } else {
                to = middle;
            }
        }
        0.5 * (from + to)
    }

    pub(super) fn numbers(&self) -> impl Iterator<Item = (&'static str, f64)> {
        let [contact, middle, end] = self.cop_outward;
        let [first, then, flat] = self.cop_landing;
        [
            ("threshold", self.threshold),
            ("even_share", self.even_share),
            ("cop_landing", first + then + flat),
            ("cop_middle_at", self.cop_middle_at.unwrap_or_default()),
            ("cop_outward", contact + middle + end),
            ("softness", self.softness),
            ("soft_landing", self.soft_landing.unwrap_or_default()),
            ("clear_until", self.clear_until.0 + self.clear_until.1),
            ("latest_heel_off", self.latest_heel_off),
        ]
        .into_iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    #[test]
    fn a_plate_sees_the_double_support_that_is_asked() {
        let vertical = |u: f64| 700.0 * (1.0 + 0.2 * (12.0 * u).cos());
        for (even_share, exponent) in [(0.0, 0.74), (0.7, 1.0), (0.3, 0.6)] {
            let footfall = Footfall { even_share, ..Footfall::PEOPLE };
            let planned = footfall.planned_double_support(0.13, exponent, vertical);
            // Independently: counted on a fine clock.
            let count = 200_000;
            let seen = (0..count).filter(|&i| {
                let x = (f64::from(i) + 0.5) / f64::from(count);
                let share = footfall.share_risen(x, exponent);
                let force = vertical(x * planned);
                share * force > footfall.threshold && (1.0 - share) * force > footfall.threshold
            });
            let seen = seen.count() as f64 / f64::from(count) * planned;
            assert_relative_eq!(seen, 0.13, epsilon = 2e-5);
            assert!(planned > 0.13 && planned < 0.18);
        }
        assert_relative_eq!(Footfall::RECIPE.planned_double_support(0.13, 0.74, vertical), 0.13);
    }
}

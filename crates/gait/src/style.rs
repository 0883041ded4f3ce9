//! The numbers of a walking style: from a step frequency and a step length, for any figure.

use crate::error::GaitError;
use crate::leg::LegGeometry;

/// Step length of people over height and step frequency, `S / (H · sf)` (min): `S = 0.0037·H·sf`. The thesis's law has
/// 0.004.
pub const WALK_RATIO: f64 = 0.0037;

/// Middle and spread of S/leg over the speeds that the table was fitted to.
const SIGMA: (f64, f64) = (0.7586, 0.138);

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// Names the numbers of a style, once: as fields, and as rows of the table.
macro_rules! style_numbers {
    ($($(#[$doc:meta])* $name:ident: $unit:expr, [$c0:expr, $c1:expr, $c2:expr, $c3:expr];)*) => {
        /// The numbers of one walking style (rad, m, s; `u` is the time since left heel contact over the stride's time).
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct Style {
            /// Steps a minute.
            pub step_frequency: f64,
            /// Length of a step, from one heel print to the next one of the other foot (m); the thesis calls it stride.
            pub step_length: f64,
            /// One double support, as a fraction of the stride.
            pub double_support: f64,
            /// Duration of a stride, two steps (s).
            pub stride_time: f64,
            /// Outward turn of the feet.
            pub foot_yaw: f64,
            /// Least height of the swinging foot's lowest point in mid-swing (m).
            pub clearance: f64,
            /// Mean tilt of the pelvis, forward.
            pub anterior_tilt: f64,
            /// Least pitch of the standing shank when the hip is above its ankle (χ): the body is lowered to it.
            pub flexion: f64,
            $($(#[$doc])* pub $name: f64,)*
        }

        impl Style {
            fn tabulated(table: &StyleTable, basis: &[f64; 4], common: Common) -> Self {
                let q = |c: [f64; 4]| c.iter().zip(basis).map(|(c, b)| c * b).sum::<f64>();
                let [$($name,)*] = table.rows;
                Self {
                    step_frequency: common.step_frequency,
                    step_length: common.step_length,
                    double_support: common.double_support,
                    stride_time: 120.0 / common.step_frequency,
                    foot_yaw: 5.0 * DEGREE,
                    clearance: common.clearance,
                    anterior_tilt: 4.0 * DEGREE,
                    flexion: 0.0,
                    $($name: q($name) * $unit,)*
                }
            }

            /// The numbers of the table with their names.
            fn numbers(&self) -> impl Iterator<Item = (&'static str, f64)> {
                [$((stringify!($name), self.$name),)*].into_iter()
            }
        }

        impl StyleTable {
            /// Name and unit of each row: `DEGREE` or 1.0.
            pub const NUMBERS: [(&'static str, &'static str); NUMBERS] =
                [$((stringify!($name), stringify!($unit)),)*];
        }

        impl Default for StyleTable {
            /// What ships.
            fn default() -> Self {
                Self { rows: [$([$c0, $c1, $c2, $c3],)*] }
            }
        }

        const NUMBERS: usize = [$(stringify!($name),)*].len();
    };
}

/// The coefficients that styles are made of: each number is the sum of its row's over [`StyleTable::basis`].
#[derive(Clone, Debug, PartialEq)]
pub struct StyleTable {
    /// A row for each of [`StyleTable::NUMBERS`].
    pub rows: [[f64; 4]; NUMBERS],
}

impl StyleTable {
    /// What the coefficients are multiplied by for a leg, a height (m), a step frequency (1/min) and a step length (m):
    ///
    /// ```text
    /// 1, s, s², r      s = (S/leg − .7586)/.138 in [−1.6, 1.1]      r = S/(.0037·H·sf) − 1 in ±.15
    /// ```
    pub fn basis(leg: &LegGeometry, height: f64, step_frequency: f64, step_length: f64) -> [f64; 4] {
        let s = stretch(leg, step_length).clamp(-1.6, 1.1);
        let r = (step_length / (WALK_RATIO * height * step_frequency) - 1.0).clamp(-0.15, 0.15);
        [1.0, s, s * s, r]
    }
}

/// S/leg against the middle of the fitted speeds, in their spread.
fn stretch(leg: &LegGeometry, step_length: f64) -> f64 {
    (step_length / leg.length() - SIGMA.0) / SIGMA.1
}

struct Common {
    step_frequency: f64,
    step_length: f64,
    double_support: f64,
    clearance: f64,
}

// One offline least-squares fit over all speeds at once (docs/walking.md).
style_numbers! {
    /// Foot pitch at contact, toe up (θ).
    heel_strike_angle: DEGREE, [18.09, 2.71, 0.72, 0.03];
    /// First harmonic of the centre of mass' height over the leg's length.
    height1: 1.0, [0.01645, 0.00215, -0.00027, 0.00442];
    /// Its phase.
    height1_phase: 1.0, [0.0097, -0.0061, 0.0121, 0.0277];
    /// Second harmonic, cosine.
    height2_cos: 1.0, [-0.00120, 0.00044, 0.00039, 0.00012];
    /// Second harmonic, sine.
    height2_sin: 1.0, [0.00072, -0.00134, 0.00041, -0.00094];
    /// Third harmonic, cosine.
    height3_cos: 1.0, [-0.00015, -0.00018, -0.00002, -0.00001];
    /// Third harmonic, sine.
    height3_sin: 1.0, [0.00019, 0.00027, -0.00003, -0.00015];
    /// Amplitude of the pelvis' obliquity (δ).
    pelvic_obliquity: DEGREE, [4.29, 0.28, -0.09, 3.28];
    /// Its phase.
    obliquity_phase: 1.0, [0.0283, 0.0136, -0.0082, 0.0017];
    /// When the foot is flat.
    foot_flat: 1.0, [0.0844, -0.0123, -0.0033, 0.0098];
    /// Knee flexion at contact.
    knee_contact: DEGREE, [6.84, 1.16, 0.96, 0.94];
    /// Its rate, by u.
    knee_contact_rate: DEGREE, [122.1, 42.6, 16.0, -27.6];
    /// Its second derivative, by u.
    knee_contact_acc: DEGREE, [1906.0, 3611.0, 1363.0, 1829.0];
    /// Knee flexion in the push, at u = .46.
    knee_push: DEGREE, [11.75, -4.37, -1.57, -0.09];
    /// Knee flexion at toe-off.
    knee_toe_off: DEGREE, [40.25, -3.67, 1.03, -8.43];
    /// Its rate.
    knee_toe_off_rate: DEGREE, [359.0, 43.0, 21.2, -61.0];
    /// Its second derivative.
    knee_toe_off_acc: DEGREE, [-690.0, 102.0, 321.0, 752.0];
    /// Pitch of the toes at toe-off.
    toe_roll: DEGREE, [35.16, -0.95, -0.43, 22.36];
    /// Greatest knee flexion in swing.
    knee_peak: DEGREE, [64.33, -2.91, -2.28, 0.83];
    /// When it is reached.
    knee_peak_at: 1.0, [0.7504, -0.0003, 0.0036, 0.0014];
    /// Forward angle of the thigh at u = .84.
    thigh_swing: DEGREE, [28.68, 0.13, 0.94, 2.56];
    /// Dorsiflexion at u = .83.
    ankle_swing: DEGREE, [5.98, -1.62, -0.46, 1.06];
    /// Factor of the centre of pressure's way forward.
    cop_forward: 1.0, [1.1224, 0.1785, -0.0235, -0.0630];
    /// Centre of pressure when the heel rises, as a fraction of the foot's length.
    cop_heel_off: 1.0, [0.7480, 0.0050, -0.0028, -0.0119];
    /// Centre of pressure at u = .40.
    cop_40: 1.0, [0.7963, 0.0052, -0.0037, -0.0013];
    /// Centre of pressure at u = .50.
    cop_50: 1.0, [0.8002, 0.0289, 0.0174, -0.0025];
    /// When the heel rises.
    heel_off: 1.0, [0.3032, 0.0062, -0.0046, 0.0057];
    /// Forward lean of the thorax.
    thorax_lean: DEGREE, [-0.39, -0.79, 0.09, 0.82];
    /// Knee flexion at u = .945.
    knee_late_swing: DEGREE, [4.42, 0.68, 0.82, 0.22];
    /// Side bend of the thorax, sine.
    thorax_bend_sin: DEGREE, [5.41, 0.11, 0.07, -0.25];
    /// Side bend of the thorax, cosine.
    thorax_bend_cos: DEGREE, [-2.51, -0.41, 0.77, -0.59];
    /// Turn of the thorax.
    thorax_yaw: DEGREE, [5.76, 0.07, 0.13, -0.56];
    /// Amplitude of the shoulder's flexion.
    arm_swing: DEGREE, [21.82, 7.46, -1.27, -4.22];
    /// Exponent of the load share.
    share_exponent: 1.0, [0.7378, -0.0625, 0.0435, 0.0124];
    /// Distance of the heel prints' lines (for a height of 1.75 m).
    step_width: 1.0, [0.1120, 0.0050, 0.0, 0.0];
    /// Begin of the roll over the toes' tip, as a fraction of double support.
    tip_roll: 1.0, [0.4320, -0.0655, -0.0166, 0.2679];
    /// Turn of the pelvis at contact (τ).
    pelvic_rotation: DEGREE, [5.82, 1.38, -0.26, 0.30];
    /// Height of the point that the feet's forces point at, over the height of the centre of mass.
    pivot: 1.0, [1.4297, 0.0023, -0.0872, -0.0243];
    /// Lag of the arms.
    arm_lag: 1.0, [-0.0155, 0.0032, 0.0, 0.0018];
    /// Phase of the thorax' turn.
    thorax_yaw_phase: 1.0, [0.0072, 0.0615, 0.0221, -0.0130];
}

impl Style {
    /// The style of people at this step frequency (1/min) and step length (m), for a figure of this height (m).
    ///
    /// No check of ranges: see [`crate::walk`].
    pub fn of(leg: &LegGeometry, height: f64, step_frequency: f64, step_length: f64) -> Self {
        Self::from_table(&StyleTable::default(), leg, height, step_frequency, step_length)
    }

    /// The same, made of other coefficients than those that ship.
    pub fn from_table(
        table: &StyleTable,
        leg: &LegGeometry,
        height: f64,
        step_frequency: f64,
        step_length: f64,
    ) -> Self {
        let basis = StyleTable::basis(leg, height, step_frequency, step_length);
        let common = Common {
            step_frequency,
            step_length,
            double_support: (29.4 - 0.149 * step_frequency) / 100.0,
            clearance: 0.012 * height / crate::body::REFERENCE_HEIGHT,
        };
        let mut style = Self::tabulated(table, &basis, common);
        if stretch(leg, step_length) < -1.6 {
            style.height1 *= (step_length / leg.length() / (SIGMA.0 - 1.6 * SIGMA.1)).powi(2);
        }
        style.step_width *= height / 1.75;
        style
    }

    /// Refuses numbers that are none.
    pub(crate) fn check(&self) -> Result<(), GaitError> {
        let common = [
            ("step_frequency", self.step_frequency),
            ("step_length", self.step_length),
            ("double_support", self.double_support),
            ("stride_time", self.stride_time),
            ("foot_yaw", self.foot_yaw),
            ("clearance", self.clearance),
            ("anterior_tilt", self.anterior_tilt),
            ("flexion", self.flexion),
        ];
        match common.into_iter().chain(self.numbers()).find(|(_, value)| !value.is_finite()) {
            Some((name, value)) => Err(GaitError::StyleNotFinite { name, value }),
            None => Ok(()),
        }
    }

    /// Whether the step is shorter than any that the numbers were fitted to (0.538 of the leg), so that they are held at
    /// their ends.
    pub fn is_extrapolated(&self, leg: &LegGeometry) -> bool {
        self.step_length / leg.length() < SIGMA.0 - 1.6 * SIGMA.1
    }

    /// Toe-off of the left foot, in u.
    pub fn toe_off(&self) -> f64 {
        0.5 + self.double_support
    }

    /// Begin of the left foot's roll over the tip, in u.
    pub(crate) fn tip_roll_at(&self) -> f64 {
        0.5 + self.tip_roll * self.double_support
    }
}

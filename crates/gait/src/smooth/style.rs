//! The numbers of a walking style: from a step frequency and a step length, for any figure.

use super::footfall::Footfall;
use super::manner::Manner;
use super::stair_numbers::StairNumbers;
use crate::body::LegGeometry;
use crate::error::RequestError;
use crate::limbs::numbers::MOST_KNEE_TOE_OFF;
use crate::request::WALK_RATIO;
use crate::walking::G;
use std::f64::consts::TAU;

/// Middle and spread of S/leg over the speeds that the table was fitted to.
const SIGMA: (f64, f64) = (0.7586, 0.138);

/// Mass over squared height of a person of average build (kg/m²), whose weight a plate's threshold is held against.
const BUILD: f64 = 23.84;

const DEGREE: f64 = std::f64::consts::PI / 180.0;
/// Least flexion of a knee on a flat foot.
const LEAST_KNEE: f64 = 7.0 * DEGREE;

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
            #[doc(alias = "dual support")]
            pub double_support: f64,
            /// Duration of a stride, two steps (s).
            #[doc(alias = "gait cycle")]
            #[doc(alias = "cycle time")]
            pub stride_time: f64,
            /// Outward turn of the feet.
            #[doc(alias = "foot progression angle")]
            #[doc(alias = "toe-out")]
            pub foot_yaw: f64,
            /// Least height of the swinging foot's lowest point in mid-swing (m).
            pub clearance: f64,
            /// Mean tilt of the pelvis, forward.
            pub anterior_tilt: f64,
            /// Least pitch of the standing shank when the hip is above its ankle (χ): the body is lowered to it.
            pub flexion: f64,
            /// Rise of the ground along the way, see [`Style::on_slope`].
            pub slope: f64,
            /// Least knee flexion on a flat foot.
            pub least_knee: f64,
            /// How far the foot's pitch in the push is rounded off where it would stay at the ground.
            pub push_softness: f64,
            /// The greatest flexion that a knee which is too straight in the push is bent to at toe-off.
            pub toe_off_most: f64,
            /// What stairs ask for besides, see [`Style::on_stairs`].
            pub stairs: Option<StairNumbers>,
            /// Toes, head and arms.
            pub manner: Manner,
            /// How feet meet the ground and leave it.
            pub footfall: Footfall,
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
                    slope: 0.0,
                    stairs: None,
                    least_knee: LEAST_KNEE,
                    push_softness: 0.0,
                    toe_off_most: MOST_KNEE_TOE_OFF,
                    manner: common.manner,
                    footfall: table.footfall,
                    $($name: q($name) * $unit,)*
                }
            }

            /// The numbers between this style and another one; what has no numbers between is this one's.
            pub(crate) fn mixed(&self, other: &Self, part: f64) -> Self {
                let mix = |a: f64, b: f64| a + (b - a) * part;
                Self {
                    step_length: mix(self.step_length, other.step_length),
                    double_support: mix(self.double_support, other.double_support),
                    anterior_tilt: mix(self.anterior_tilt, other.anterior_tilt),
                    least_knee: mix(self.least_knee, other.least_knee),
                    clearance: mix(self.clearance, other.clearance),
                    slope: mix(self.slope, other.slope),
                    $($name: mix(self.$name, other.$name),)*
                    ..*self
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
            /// What ships, of a steady gait.
            fn default() -> Self {
                Self { rows: [$([$c0, $c1, $c2, $c3],)*], manner: None, footfall: Footfall::PEOPLE }
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
    /// Toes, head and arms; people's at the speed for `None`.
    pub manner: Option<Manner>,
    /// How feet meet the ground and leave it.
    pub footfall: Footfall,
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

/// The law of one double support by cadence (a part of the stride), which plates have seen at their threshold; the recipe takes it, with
/// a digit more, from touch-down to lift-off.
fn double_support(footfall: &Footfall, step_frequency: f64) -> f64 {
    let slope = if footfall.threshold > 0.0 { 0.15 } else { 0.149 };
    (29.4 - slope * step_frequency) / 100.0
}

struct Common {
    step_frequency: f64,
    step_length: f64,
    double_support: f64,
    clearance: f64,
    manner: Manner,
}

// One offline least-squares fit over all speeds at once (docs/walking.md).
style_numbers! {
    /// Foot pitch at contact, toe up (θ).
    heel_strike_angle: DEGREE, [21.54, 2.36, -0.19, 22.06];
    /// First harmonic of the centre of mass' height over the leg's length.
    height1: 1.0, [0.01743, -0.00034, -0.00011, 0.01330];
    /// Its phase.
    height1_phase: 1.0, [0.0281, -0.0232, 0.0032, 0.1228];
    /// Second harmonic, cosine.
    height2_cos: 1.0, [-0.00109, 0.00105, 0.00004, -0.00001];
    /// Second harmonic, sine.
    height2_sin: 1.0, [0.00185, 0.00085, -0.00032, -0.00672];
    /// Third harmonic, cosine.
    height3_cos: 1.0, [-0.00040, -0.00023, 0.00024, 0.00033];
    /// Third harmonic, sine.
    height3_sin: 1.0, [0.00001, 0.00029, 0.00003, -0.00023];
    /// Amplitude of the pelvis' obliquity (δ).
    pelvic_obliquity: DEGREE, [3.73, 0.73, 0.34, 2.04];
    /// Its phase.
    obliquity_phase: 1.0, [0.1283, -0.0072, -0.0188, -0.4580];
    /// When the foot is flat.
    foot_flat: 1.0, [0.0710, -0.0036, -0.0009, 0.0753];
    /// Knee flexion at contact.
    knee_contact: DEGREE, [6.66, 0.00, -1.32, -12.92];
    /// Its rate, by u.
    knee_contact_rate: DEGREE, [54.4, -33.2, -24.3, -379.0];
    /// Its second derivative, by u.
    knee_contact_acc: DEGREE, [4938.0, 2636.0, 3990.0, -860.0];
    /// Knee flexion in the push, at u = .46.
    knee_push: DEGREE, [8.31, 11.03, 7.08, 1.37];
    /// Knee flexion at toe-off.
    knee_toe_off: DEGREE, [41.92, -5.73, 1.40, 10.53];
    /// Its rate.
    knee_toe_off_rate: DEGREE, [334.4, -58.6, -26.0, -390.3];
    /// Its second derivative.
    knee_toe_off_acc: DEGREE, [-2501.0, 119.0, 108.0, 12489.0];
    /// Pitch of the toes at toe-off.
    toe_roll: DEGREE, [40.28, 3.51, -0.90, 4.55];
    /// Greatest knee flexion in swing.
    knee_peak: DEGREE, [59.95, -7.74, -1.66, 15.77];
    /// When it is reached.
    knee_peak_at: 1.0, [0.7978, 0.0121, 0.0008, 0.0645];
    /// Forward angle of the thigh at u = .84.
    thigh_swing: DEGREE, [27.76, -0.92, 1.62, 11.19];
    /// Dorsiflexion at u = .83.
    ankle_swing: DEGREE, [4.24, 0.16, -1.63, 2.16];
    /// Factor of the centre of pressure's way forward.
    cop_forward: 1.0, [0.6749, 0.3436, -0.0402, -1.0971];
    /// Centre of pressure when the heel rises, as a fraction of the foot's length.
    cop_heel_off: 1.0, [0.7881, 0.0481, 0.0077, 0.0154];
    /// Centre of pressure at u = .40.
    cop_40: 1.0, [0.7912, 0.0477, 0.0074, 0.0224];
    /// Centre of pressure at u = .50.
    cop_50: 1.0, [0.7935, 0.0475, 0.0081, 0.0244];
    /// When the heel rises.
    heel_off: 1.0, [0.3005, 0.0422, 0.0086, -0.1358];
    /// Forward lean of the thorax.
    thorax_lean: DEGREE, [-2.07, -1.46, 1.29, -0.43];
    /// Knee flexion at u = .945.
    knee_late_swing: DEGREE, [8.56, 4.72, 3.89, -12.00];
    /// Side bend of the thorax, sine.
    thorax_bend_sin: DEGREE, [-0.05, 0.00, 0.08, -1.36];
    /// Side bend of the thorax, cosine.
    thorax_bend_cos: DEGREE, [-3.79, -0.27, -0.11, -0.98];
    /// Turn of the thorax.
    thorax_yaw: DEGREE, [3.01, 0.02, -0.02, -0.05];
    /// Amplitude of the shoulder's flexion.
    arm_swing: DEGREE, [16.92, 4.69, -0.55, -21.34];
    /// Exponent of the load share.
    share_exponent: 1.0, [0.5400, -0.5200, 0.3200, -0.2019];
    /// Distance of the heel prints' lines (for a height of 1.75 m).
    step_width: 1.0, [0.0983, 0.0002, 0.0002, -0.0118];
    /// Begin of the roll over the toes' tip, as a fraction of double support.
    tip_roll: 1.0, [0.3412, -0.1890, -0.0295, 0.9465];
    /// Turn of the pelvis at contact (τ).
    pelvic_rotation: DEGREE, [6.64, 0.97, -0.75, 1.70];
    /// Height of the point that the feet's forces point at, over the height of the centre of mass.
    pivot: 1.0, [1.4253, -0.5878, 0.4237, 2.2761];
    /// Lag of the arms.
    arm_lag: 1.0, [-0.0709, 0.0463, -0.0342, 0.0175];
    /// Phase of the thorax' turn.
    thorax_yaw_phase: 1.0, [0.1173, 0.1092, 0.1865, -0.0492];
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
            double_support: double_support(&table.footfall, step_frequency),
            clearance: 0.012 * height / crate::body::REFERENCE_HEIGHT,
            manner: table.manner.unwrap_or_else(|| {
                // As fast as somebody of the reference height would be who walks alike.
                let speed = step_length * step_frequency / 60.0;
                Manner::of_people(speed / (height / crate::body::REFERENCE_HEIGHT).sqrt())
            }),
        };
        let mut style = Self::tabulated(table, &basis, common);
        if stretch(leg, step_length) < -1.6 {
            // Steps shorter than any that were fitted: the body rises as they are long squared.
            let shorter = step_length / leg.length() / (SIGMA.0 - 1.6 * SIGMA.1);
            for height in [
                &mut style.height1,
                &mut style.height2_cos,
                &mut style.height2_sin,
                &mut style.height3_cos,
                &mut style.height3_sin,
            ] {
                *height *= shorter * shorter;
            }
        }
        style.step_width *= height / 1.75;
        style.heel_off = style.heel_off.min(style.footfall.latest_heel_off);
        let vertical = |u: f64| BUILD * height * height * (G + style.height(leg.length(), u).1);
        style.double_support =
            style.footfall.planned_double_support(style.double_support, style.share_exponent, vertical);
        style
    }

    /// Refuses numbers that are none.
    pub(crate) fn check(&self) -> Result<(), RequestError> {
        let common = [
            ("step_frequency", self.step_frequency),
            ("step_length", self.step_length),
            ("double_support", self.double_support),
            ("stride_time", self.stride_time),
            ("foot_yaw", self.foot_yaw),
            ("clearance", self.clearance),
            ("anterior_tilt", self.anterior_tilt),
            ("flexion", self.flexion),
            ("slope", self.slope),
            ("least_knee", self.least_knee),
            ("push_softness", self.push_softness),
            ("toe_off_most", self.toe_off_most),
        ];
        match common
            .into_iter()
            .chain(self.numbers())
            .chain(self.manner.numbers())
            .chain(self.stairs.iter().map(|stairs| ("stairs", stairs.sum())))
            .chain(self.footfall.numbers())
            .find(|(_, value)| !value.is_finite())
        {
            Some((name, value)) => Err(RequestError::StyleNotFinite { name, value }),
            None => Ok(()),
        }
    }

    /// Whether the step is shorter than any that the numbers were fitted to (0.538 of the leg), so that they are held at
    /// their ends.
    pub fn is_extrapolated(&self, leg: &LegGeometry) -> bool {
        self.step_length / leg.length() < SIGMA.0 - 1.6 * SIGMA.1
    }

    /// Height harmonics of the centre of mass about its mean (m) and their second derivative in time (m/s²).
    ///
    /// ```text
    /// y(u) = −leg·[a₁ cos 4π(u − u₁) + a₂ cos 8πu + b₂ sin 8πu + a₃ cos 12πu + b₃ sin 12πu]
    /// ```
    pub(crate) fn height(&self, leg: f64, u: f64) -> (f64, f64) {
        let omega = TAU / self.stride_time;
        let phase = 2.0 * TAU * self.height1_phase;
        let terms = [
            (2.0, self.height1 * phase.cos(), self.height1 * phase.sin()),
            (4.0, self.height2_cos, self.height2_sin),
            (6.0, self.height3_cos, self.height3_sin),
        ];
        let (mut y, mut acceleration) = (0.0, 0.0);
        for (n, c, s) in terms {
            let (sin, cos) = (TAU * u * n).sin_cos();
            let q = leg * (c * cos + s * sin);
            y -= q;
            acceleration += (n * omega).powi(2) * q;
        }
        (y, acceleration)
    }

    /// Toe-off of the left foot, in u.
    pub fn toe_off(&self) -> f64 {
        0.5 + self.double_support
    }

    /// How much higher each print is than the one before (m).
    pub fn rise(&self) -> f64 {
        self.stairs.map_or(self.step_length * self.slope.tan(), |stairs| stairs.rise)
    }

    /// Begin of the left foot's roll over the tip, in u.
    pub(crate) fn tip_roll_at(&self) -> f64 {
        0.5 + self.tip_roll * self.double_support
    }
}

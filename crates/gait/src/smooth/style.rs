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

/// Least exponent of the load share: a smaller one would load a landing foot within 10 ms.
const LEAST_SHARE_EXPONENT: f64 = 0.3;

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
            /// Third harmonic of the pelvis' obliquity.
            pub list: PelvicList,
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
                    list: table.list,
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
                    list: PelvicList {
                        part: mix(self.list.part, other.list.part),
                        lag: mix(self.list.lag, other.list.lag),
                    },
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
                Self { rows: [$([$c0, $c1, $c2, $c3],)*], manner: None, footfall: Footfall::PEOPLE, list: PelvicList::PEOPLE }
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
    /// Third harmonic of the pelvis' obliquity.
    pub list: PelvicList,
}

/// Third harmonic of the pelvis' obliquity (its list to a side):
///
/// ```text
/// δ (sin 2π(u − φ) + part·sin 6π(u − φ − lag))
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PelvicList {
    /// Over the first harmonic.
    pub part: f64,
    /// How much later than the first it begins (u).
    pub lag: f64,
}

impl PelvicList {
    /// Of the recipe that the golden walks were made with.
    pub const RECIPE: Self = Self { part: 0.3, lag: 0.0 };
    /// Of people: the harmonics of their mean curves at three of five paces, Schwartz, Rozumalski and Trost 2008 (see [`crate::people::curves`]),
    /// come to 0.23 to 0.44 and 0.17 to 0.215.
    pub const PEOPLE: Self = Self { part: 0.35, lag: 0.19 };
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

impl StyleTable {
    /// Whether steps so long (m) are as long as those that tables were fitted to.
    pub(crate) fn covers(leg: &LegGeometry, step_length: f64) -> bool {
        step_length / leg.length() >= SIGMA.0 - 1.6 * SIGMA.1
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
    heel_strike_angle: DEGREE, [21.65, 1.48, -0.79, 27.12];
    /// First harmonic of the centre of mass' height over the leg's length.
    height1: 1.0, [0.01766, -0.00014, -0.00001, 0.00432];
    /// Its phase.
    height1_phase: 1.0, [0.0337, -0.0247, 0.0025, 0.0982];
    /// Second harmonic, cosine.
    height2_cos: 1.0, [-0.00079, 0.00100, -0.00025, -0.00098];
    /// Second harmonic, sine.
    height2_sin: 1.0, [0.00220, 0.00036, -0.00097, -0.00956];
    /// Third harmonic, cosine.
    height3_cos: 1.0, [-0.00047, -0.00022, 0.00023, 0.00096];
    /// Third harmonic, sine.
    height3_sin: 1.0, [0.00008, 0.00032, -0.00009, -0.00123];
    /// Amplitude of the pelvis' obliquity (δ).
    pelvic_obliquity: DEGREE, [2.98, 0.65, 0.47, 5.05];
    /// Its phase.
    obliquity_phase: 1.0, [-0.0569, 0.0012, -0.0164, -0.2046];
    /// When the foot is flat.
    foot_flat: 1.0, [0.0728, -0.0043, -0.0044, 0.1179];
    /// Knee flexion at contact.
    knee_contact: DEGREE, [5.11, -0.54, -0.97, -9.88];
    /// Its rate, by u.
    knee_contact_rate: DEGREE, [67.24, -13.25, -48.65, 84.47];
    /// Its second derivative, by u.
    knee_contact_acc: DEGREE, [6268.0, 443.0, 9.0, 28123.0];
    /// Knee flexion in the push, at u = .46.
    knee_push: DEGREE, [11.39, 8.30, 4.16, -17.85];
    /// Knee flexion at toe-off.
    knee_toe_off: DEGREE, [41.28, -7.85, 0.80, 13.90];
    /// Its rate.
    knee_toe_off_rate: DEGREE, [306.1, -73.1, -33.6, -150.7];
    /// Its second derivative.
    knee_toe_off_acc: DEGREE, [-2503.0, 942.0, 2.0, -1465.0];
    /// Pitch of the toes at toe-off.
    toe_roll: DEGREE, [39.09, 3.10, 1.19, 38.27];
    /// Greatest knee flexion in swing.
    knee_peak: DEGREE, [62.68, 0.52, 1.62, 33.34];
    /// When it is reached.
    knee_peak_at: 1.0, [0.7751, -0.0110, -0.0024, 0.0444];
    /// Forward angle of the thigh at u = .84.
    thigh_swing: DEGREE, [25.76, 0.67, 1.42, 28.17];
    /// Dorsiflexion at u = .83.
    ankle_swing: DEGREE, [5.96, 2.55, -2.55, 0.37];
    /// Factor of the centre of pressure's way forward.
    cop_forward: 1.0, [0.9446, 0.4703, 0.0336, 0.2199];
    /// Centre of pressure in mid-stance, at [`Footfall::cop_middle_at`] (u = .30) or when the heel rises, as a fraction of the foot's length.
    cop_middle: 1.0, [0.7434, 0.0513, 0.0334, 0.0685];
    /// Centre of pressure at u = .40.
    cop_40: 1.0, [0.7493, 0.0484, 0.0306, 0.0631];
    /// Centre of pressure at u = .50.
    cop_50: 1.0, [0.7882, 0.0168, 0.0219, 0.0523];
    /// When the heel rises.
    heel_off: 1.0, [0.3179, 0.0532, 0.0070, -0.0257];
    /// Forward lean of the thorax.
    thorax_lean: DEGREE, [-2.60, -1.70, 1.02, -4.39];
    /// Knee flexion at u = .945.
    knee_late_swing: DEGREE, [8.51, 2.15, 1.06, -2.68];
    /// Side bend of the thorax, sine.
    thorax_bend_sin: DEGREE, [1.02, 0.49, -0.63, -7.07];
    /// Side bend of the thorax, cosine.
    thorax_bend_cos: DEGREE, [-2.39, 0.66, -0.01, -0.72];
    /// Turn of the thorax.
    thorax_yaw: DEGREE, [3.02, 0.01, 0.01, 0.16];
    /// Amplitude of the shoulder's flexion.
    arm_swing: DEGREE, [16.96, 4.74, -0.63, -19.64];
    /// Exponent of the load share.
    share_exponent: 1.0, [0.3741, -0.2908, 0.1157, 0.3202];
    /// Distance of the heel prints' lines (for a height of 1.75 m).
    step_width: 1.0, [0.0989, -0.0013, -0.0007, 0.0053];
    /// Begin of the roll over the toes' tip, as a fraction of double support.
    tip_roll: 1.0, [0.3363, -0.2246, -0.0527, 0.9296];
    /// Turn of the pelvis at contact (τ).
    pelvic_rotation: DEGREE, [6.49, 1.12, -0.59, 1.49];
    /// Height of the point that the feet's forces point at, over the height of the centre of mass.
    pivot: 1.0, [1.4028, -0.3296, 0.3347, 1.2168];
    /// Lag of the arms.
    arm_lag: 1.0, [-0.0760, 0.0512, -0.0195, 0.3369];
    /// Phase of the thorax' turn.
    thorax_yaw_phase: 1.0, [0.0064, 0.0758, -0.0031, -0.0968];
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
        style.share_exponent = style.share_exponent.max(LEAST_SHARE_EXPONENT);
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
            .chain([("list", self.list.part + self.list.lag)])
            .find(|(_, value)| !value.is_finite())
        {
            Some((name, value)) => Err(RequestError::StyleNotFinite { name, value }),
            None => Ok(()),
        }
    }

    /// Whether the step is shorter than any that the numbers were fitted to (0.538 of the leg), so that they are held at
    /// their ends.
    pub fn is_extrapolated(&self, leg: &LegGeometry) -> bool {
        !StyleTable::covers(leg, self.step_length)
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

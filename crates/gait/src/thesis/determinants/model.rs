//! Both models behind one face: parameters as numbers, conditions, postures.

use super::cycle::{Cycle, KeyPhase};
use super::posture::KeyPosture;
use super::proportions::Proportions;
use super::table::GaitTable;
use super::timing::DoubleSupport;
use super::{five, three};
use crate::condition::{Condition, KeyParameter};
use crate::error::{GaitError, PostureError};

/// How many determinants of gait a walk has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[doc(alias = "determinants of gait")]
#[doc(alias = "saunders")]
pub enum Determinants {
    /// Pelvic tilt, flexion of the stance knee, compass gait: chapter 7.
    Three,
    /// Pelvic rotation and the plantar flexion of the foot that leaves besides: chapter 8.
    #[default]
    Five,
}

/// All that a set of parameters comes to.
#[derive(Clone, Debug, PartialEq)]
pub struct KeySolution {
    /// The parameters' values, in their units.
    pub values: Vec<f64>,
    /// The angles (rad), by symbol, with what they are.
    pub angles: Vec<(&'static str, &'static str, f64)>,
    /// The phases of the starting, the intermediate and the finishing cycle.
    pub cycles: [Vec<KeyPhase>; 3],
    /// The posture before the intermediate cycle's first phase.
    pub before: KeyPosture,
    /// What the thesis asks for besides, and nothing breaks without.
    pub remarks: Vec<Condition>,
    solved: Solved,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Solved {
    Three,
    Five(five::FiveAngles),
}

const CYCLES: [Cycle; 3] = [Cycle::Starting, Cycle::Intermediate, Cycle::Finishing];

impl Determinants {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Three, Self::Five];

    /// 3 or 5.
    pub fn count(self) -> usize {
        match self {
            Self::Three => 3,
            Self::Five => 5,
        }
    }

    fn word(self) -> &'static str {
        match self {
            Self::Three => "three",
            Self::Five => "five",
        }
    }

    /// The parameters; lengths' ranges are those of a body.
    pub fn parameters(self, p: &Proportions) -> Vec<KeyParameter> {
        match self {
            Self::Three => three::parameters_of(p),
            Self::Five => five::parameters_of(p).to_vec(),
        }
    }

    /// A choice of the parameters' values inside their bounds, in their units, for a step frequency (steps/min) and a step
    /// length.
    ///
    /// # Errors
    ///
    /// A step that no values fit.
    pub fn automatic(
        self,
        p: &Proportions,
        step_frequency: f64,
        step_length: f64,
    ) -> Result<Vec<f64>, GaitError> {
        Ok(match self {
            Self::Three => {
                let refuse = |why| PostureError::Infeasible { determinants: self.word(), why: Box::new(why) };
                three::ThreeParameters::automatic(p, step_length).map_err(refuse)?.values().to_vec()
            }
            Self::Five => five::FiveParameters::automatic(p, step_frequency, step_length)?.values().to_vec(),
        })
    }

    /// All that has to hold of values, as far as it has numbers.
    ///
    /// # Errors
    ///
    /// Another number of values than there are parameters.
    pub fn conditions(self, p: &Proportions, values: &[f64]) -> Result<Vec<Condition>, GaitError> {
        Ok(match self {
            Self::Three => three::ThreeParameters::from_values(self.sized(values)?).conditions(p),
            Self::Five => five::conditions(p, &five::FiveParameters::from_values(self.sized(values)?)),
        })
    }

    /// The postures of values, at a speed in the proportions' unit a second; the trunk of five determinants follows it, as the
    /// thesis's fits say for metres.
    ///
    /// # Errors
    ///
    /// Values out of their ranges, and [`PostureError::Infeasible`] with the nearest feasible ones.
    pub fn solve(self, p: &Proportions, values: &[f64], speed: f64) -> Result<KeySolution, GaitError> {
        match self {
            Self::Three => {
                let parameters = three::ThreeParameters::from_values(self.sized(values)?);
                let refuse = |why| PostureError::Infeasible { determinants: self.word(), why: Box::new(why) };
                let angles = parameters.solve(p).map_err(refuse)?;
                let arms = three::ArmCoefficients::default();
                Ok(KeySolution {
                    values: values.to_vec(),
                    angles: three_angles(&angles),
                    cycles: CYCLES.map(|cycle| three::phases(&angles, &arms, cycle)),
                    before: three::start(&angles, &arms, Cycle::Intermediate),
                    remarks: Vec::new(),
                    solved: Solved::Three,
                })
            }
            Self::Five => {
                let parameters = five::FiveParameters::from_values(self.sized(values)?);
                let angles = five::solve(p, &parameters)?;
                let upper = five::Upper::automatic(&angles, speed * p.unit);
                Ok(KeySolution {
                    values: values.to_vec(),
                    angles: five_angles(&angles),
                    cycles: CYCLES.map(|cycle| five::phases(&angles, &upper, cycle)),
                    before: five::posture_before(&angles, &upper, Cycle::Intermediate),
                    remarks: five::remarks(&angles),
                    solved: Solved::Five(angles),
                })
            }
        }
    }

    fn sized<const N: usize>(self, values: &[f64]) -> Result<[f64; N], GaitError> {
        let error = || {
            PostureError::ParameterCount { determinants: self.word(), found: values.len(), expected: N }
                .into()
        };
        values.try_into().map_err(|_| error())
    }
}

impl KeySolution {
    /// Parts of a step's time that each phase of each cycle takes.
    ///
    /// Three determinants have two phases, of which the first lasts the double support. Of five, only the second phase has both
    /// feet on the ground: it lasts the double support, and the rest is shared by the pelvis' way; without a law (`None`) all are.
    pub fn parts(
        &self,
        p: &Proportions,
        double_support: Option<DoubleSupport>,
        step_frequency: f64,
    ) -> [Vec<f64>; 3] {
        match &self.solved {
            Solved::Three => {
                let law = double_support.unwrap_or_default();
                CYCLES.map(|cycle| {
                    three::parts_of_step(cycle, law, three::Division::Uniform, step_frequency).to_vec()
                })
            }
            Solved::Five(angles) => {
                let timing = double_support.map_or(five::Timing::Travel, five::Timing::DoubleSupport);
                let parts = timing.parts(p, angles, step_frequency);
                [0, 1, 2]
                    .map(|cycle| self.cycles[cycle].iter().map(|phase| parts[phase.number - 1]).collect())
            }
        }
    }
}

fn three_angles(angles: &three::ThreeAngles) -> Vec<(&'static str, &'static str, f64)> {
    vec![
        ("α", "straight legs of a stride", angles.alpha),
        ("δ", "pelvic tilt", angles.tilt),
        ("χ", "stance shank at lift-off", angles.chi),
        ("ξ", "stance thigh at lift-off", angles.xi),
        ("θ₁", "thigh that lifts off first", angles.theta1),
        ("θ₃", "shank and foot that lift off first", angles.theta3),
        ("ω", "thigh that lifts off", angles.omega),
        ("φ", "shank and foot that lift off", angles.phi),
    ]
}

fn five_angles(angles: &five::FiveAngles) -> Vec<(&'static str, &'static str, f64)> {
    let q = &angles.parameters;
    vec![
        ("α", "straight leg at heel strike", angles.alpha),
        ("β", "straight rear leg at heel strike", angles.beta),
        ("δ", "pelvic tilt at heel strike", q.tilt),
        ("τ", "pelvic rotation before heel strike", q.rotation),
        ("ξ", "stance thigh at lift-off", angles.xi),
        ("φ", "thigh that lifts off", q.thigh_lift_off),
        ("ω", "shank and foot that lift off", angles.omega),
        ("μ", "stance thigh in passing", angles.mu),
        ("ψ", "stance shank in passing", angles.psi),
        ("κ", "swinging thigh in passing", q.thigh_swing),
        ("ε", "swinging shank in passing", angles.epsilon),
        ("θ", "straight rear leg in the stretch", q.heel_strike_angle),
        ("χ", "leading thigh in the stretch", angles.chi),
    ]
}

/// A table of the thesis by its number, `7.1` to `7.8` and `8.1` to `8.7`, computed anew.
pub fn table(number: &str) -> Option<GaitTable> {
    three::table(number).or_else(|| five::table(number))
}

/// The numbers of all tables.
pub const TABLES: [&str; 15] =
    ["7.1", "7.2", "7.3", "7.4", "7.5", "7.6", "7.7", "7.8", "8.1", "8.2", "8.3", "8.4", "8.5", "8.6", "8.7"];

//! From paces to styles: whose they are, how heavy a body is, in which manner it walks, and how its steps differ.

use super::lopsided;
use super::sheet_numbers::{self, stand_longer};
use crate::body::{Body, REFERENCE_HEIGHT};
use crate::error::RequestError;
use crate::request::pace::{Pace, StepLaw};
use crate::request::population::heaviness;
use crate::request::sheet::{CADENCE, STEP_LENGTH};
use crate::request::variability::Chance;
use crate::request::{CANE_LOAD, Population, StyleSheet, Variability, WalkRequest};
use crate::smooth::manner::Manner;
use crate::smooth::parameter::{PARAMETERS, Parameter};
use crate::smooth::style::{Style, StyleTable};
use crate::smooth::walk::Step;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// What a body of 35 kg/m² has more: step width (of the height), one double support (of the stride), upper arms outward (rad).
///
/// From memory, not looked up: Spyropoulos 1991 has steps of heavy men twice as wide, Browning and Kram 2007 a third wider at the
/// same speed, with 2 to 3 % of a stride more on both feet; the arms give way to a wider trunk.
const HEAVY: (f64, f64, f64) = (0.020, 0.008, 4.0 * DEGREE);
/// The most by which all of it makes one double support longer: what legs were tried to do at every step frequency.
const LONGEST: f64 = 0.016;

/// Standard deviations from step to step, at a scale of 1: length and time (parts), width (of the height), turn of the foot (rad),
/// arms, thorax and pelvis (parts), pitch at contact and knee in swing (rad), clearance (part). A step's time is between its own pace's and
/// the one's before, and so differs by less: 2 %.
const STEPS: Spread = Spread {
    length: 0.025,
    time: 0.027,
    width: 0.017 / 1.75,
    yaw: 1.5 * DEGREE,
    arms: 0.06,
    thorax: 0.06,
    pelvis: 0.04,
    pitch: 1.0 * DEGREE,
    knee: 1.2 * DEGREE,
    clearance: 0.15,
};
/// Standard deviations between left and right of length, time and arms: half of a difference is added here and taken there.
const SIDES: (f64, f64, f64) = (0.015, 0.01, 0.08);
/// The first and the last steps differ by so much of it: beginnings and ends are the most delicate.
const AT_ENDS: f64 = 0.5;
/// Least and greatest step width that chance may bring, over the height.
const WIDTHS: (f64, f64) = (0.02, 0.14);

/// The number of a sheet of one side that is its arm's.
const ARM_SWING: &str = "arm_swing";

struct Spread {
    length: f64,
    time: f64,
    width: f64,
    yaw: f64,
    arms: f64,
    thorax: f64,
    pelvis: f64,
    pitch: f64,
    knee: f64,
    clearance: f64,
}

/// When the hip has passed the foot that stands (u).
const PASSED: f64 = 0.29;

/// How a step is gone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Gone {
    pub(crate) pace: Pace,
    /// Whether in the style of a steady stride, or in that of steps that begin, end or turn, see [`StyleTable::unsteady`].
    pub(crate) steady: bool,
}

/// How the styles of a request are made.
#[derive(Clone, Debug)]
pub(crate) struct Styling<'a> {
    pub(crate) law: StepLaw,
    /// Whether steps of a steady gait have the style of one.
    pub(crate) has_steady: bool,
    /// Whether it goes backward.
    pub(crate) backward: bool,
    population: Population,
    sheet: StyleSheet,
    sides: [StyleSheet; 2],
    parameters: &'a [(&'static str, f64)],
    variability: Option<Variability>,
    /// What a cane bears at most, over the vertical force.
    pub(crate) cane_load: f64,
    /// Whether the body is heavier on one side.
    is_lopsided: bool,
}

impl<'a> Styling<'a> {
    /// Of a request, with a part of its manner and of its variability.
    pub(crate) fn of(request: &'a WalkRequest, body: &Body, part: f64) -> Self {
        let WalkRequest { sheet, sides, variability, .. } =
            if part < 1.0 { request.in_part(part) } else { request.clone() };
        Self {
            law: StepLaw::new(request.population, &sheet, body.height, body.mass).going(request.backward),
            has_steady: true,
            backward: request.backward,
            population: request.population,
            sheet,
            sides,
            parameters: &request.parameters,
            variability: variability.filter(|v| v.scale > 0.0),
            cane_load: request.cane_load.unwrap_or(CANE_LOAD),
            is_lopsided: lopsided::is_lopsided(body),
        }
    }

    /// Whether it is more than the style of adults at a pace: another population, a manner, or steps that differ.
    pub(crate) fn deviates(&self) -> bool {
        self.population != Population::Adult || !self.sheet.is_empty() || self.is_uneven() || self.is_lopsided
    }

    /// Whether steps differ.
    pub(crate) fn is_uneven(&self) -> bool {
        self.variability.is_some() || self.sides.iter().any(|sheet| !sheet.is_empty())
    }

    /// The style of a step.
    pub(crate) fn style(&self, body: &Body, gone: &Gone) -> Result<Style, RequestError> {
        let table = if gone.steady { StyleTable::default() } else { StyleTable::unsteady() };
        self.style_from(&table, body, &gone.pace)
    }

    /// The same, made of other coefficients than those that ship.
    pub(crate) fn style_from(
        &self,
        table: &StyleTable,
        body: &Body,
        pace: &Pace,
    ) -> Result<Style, RequestError> {
        let Pace { step_frequency, step_length } = *pace;
        let tempo = self.law.tempo;
        let mut style = Style::from_table(table, &body.leg, body.height, step_frequency / tempo, step_length);
        if tempo > 1.0 {
            // As an adult at the same Froude number, in less time.
            style.step_frequency = step_frequency;
            style.stride_time = 120.0 / step_frequency;
            let speed = step_length * step_frequency / 60.0;
            style.manner = Manner::of_people(speed / (body.height / REFERENCE_HEIGHT).sqrt());
        }
        let heavy = heaviness(body.height, body.mass);
        let longer = self.population.longer_double_support() + HEAVY.1 * heavy;
        stand_longer(&mut style, longer.min(LONGEST));
        style.step_width += HEAVY.0 * heavy * body.height;
        style.manner.arms_out += HEAVY.2 * heavy;
        sheet_numbers::apply(&self.sheet, &mut style)?;
        for (name, value) in self.parameters {
            let parameter = Parameter::named(name).ok_or_else(|| {
                let known = PARAMETERS.iter().map(|p| p.name).collect::<Vec<_>>().join(", ");
                RequestError::UnknownParameter { name: (*name).to_owned(), known }
            })?;
            parameter.set(&mut style, *value)?;
        }
        lopsided::balance(&mut style, body);
        if style.flexion > 0.0 {
            // The foot is flat until the hip has passed it.
            style.heel_off = style.heel_off.max(PASSED);
        }
        Ok(style)
    }

    /// What is different of a step of the left foot, or of the right one: the sheets of its own and of the other side, and its length and
    /// time over those of even steps; the mean of both sides' is 1.
    fn sided(&self, left: bool) -> ([&StyleSheet; 2], [f64; 2]) {
        let (own, other) = if left { (0, 1) } else { (1, 0) };
        let part = |name: &str, of: fn(f64) -> f64| {
            let [own, other] = [own, other].map(|side: usize| of(self.sides[side].get(name).factor));
            2.0 * other / (own + other)
        };
        let parts = [part(STEP_LENGTH, |factor| factor), part(CADENCE, f64::recip)];
        ([&self.sides[own], &self.sides[other]], parts)
    }

    /// The styles of steps of some paces, each of its own, and the steps in these styles, counted from `first` on; no more and no less
    /// way is walked. Styles are of the walk as it is planned, right foot first, and so `mirrored` where the left one begins.
    pub(crate) fn varied(
        &self,
        body: &Body,
        (steps, gone): (&[Step], &[Gone]),
        first: usize,
        mirrored: bool,
    ) -> Result<(Vec<Step>, Vec<Style>), RequestError> {
        if !self.is_uneven() {
            return Ok((steps.to_vec(), Vec::new()));
        }
        let Variability { scale, seed } = self.variability.unwrap_or(Variability { scale: 0.0, seed: 0 });
        let chance = Chance(seed);
        let side = |which: u64, spread: f64| 0.5 * scale * spread * chance.normal(u64::MAX, which);
        let (length_side, time_side) = (side(0, SIDES.0), side(1, SIDES.1));
        let arm_side = side(2, SIDES.2);
        let (mut varied, mut styles) = (Vec::new(), Vec::new());
        for (k, step) in steps.iter().enumerate() {
            let Gone { pace, steady } = gone[step.pace];
            let at_end = k == 0 || k + 2 >= steps.len();
            let scale = if at_end { AT_ENDS * scale } else { scale };
            // Odd steps are planned as right ones.
            let left = (k % 2 == 1) != mirrored;
            let sign = if left { 1.0 } else { -1.0 };
            let by = |which: u64, spread: f64| scale * spread * chance.normal(k as u64, which);
            // The step is taken while the other foot stands.
            let ([own, _], [long, slow]) = self.sided(left);
            let longer = (1.0 + by(0, STEPS.length) + sign * length_side) * long;
            let slower = 1.0 + by(1, STEPS.time);
            let other =
                Pace { step_frequency: pace.step_frequency / slower, step_length: pace.step_length * longer };
            let mut style = self.style(body, &Gone { pace: other, steady })?;
            sheet_numbers::apply(&own.without(&[STEP_LENGTH, CADENCE, ARM_SWING]), &mut style)?;
            // A width is the mean of what two prints have.
            let width = style.step_width + by(2, std::f64::consts::SQRT_2 * STEPS.width) * body.height;
            style.step_width = width.clamp(WIDTHS.0 * body.height, WIDTHS.1 * body.height);
            style.arm_swing *= 1.0 + by(4, STEPS.arms);
            let arms = [0, 1].map(|side| self.sides[side].get(ARM_SWING).factor.max(0.0));
            // A body that is lopsided is mirrored itself.
            let balanced = style.manner;
            style.manner.arm_sides = [(1.0 + arm_side) * arms[0], (1.0 - arm_side) * arms[1]];
            if mirrored {
                let Manner { side_lean, pelvis_list, .. } = balanced;
                style.manner = Manner { side_lean, pelvis_list, ..style.manner.mirrored() };
            }
            style.manner.arm_sides =
                std::array::from_fn(|side| style.manner.arm_sides[side] * balanced.arm_sides[side]);
            let thorax = 1.0 + by(5, STEPS.thorax);
            style.thorax_yaw *= thorax;
            style.thorax_bend_sin *= thorax;
            style.thorax_bend_cos *= thorax;
            let pelvis = 1.0 + by(6, STEPS.pelvis);
            style.pelvic_rotation *= pelvis;
            style.pelvic_obliquity *= pelvis;
            style.heel_strike_angle += by(7, STEPS.pitch);
            style.knee_peak += by(8, STEPS.knee);
            style.clearance *= 1.0 + by(9, STEPS.clearance);
            let yaw = if k + 1 == steps.len() { 0.0 } else { by(3, STEPS.yaw) };
            let yaw = if mirrored { -yaw } else { yaw };
            varied.push(Step {
                pace: first + k,
                length: step.length * longer,
                yaw,
                slower: slow - 1.0 + sign * time_side,
                ..*step
            });
            styles.push(style);
        }
        let sum = |steps: &[Step]| steps.iter().map(|step| step.length).sum::<f64>();
        let (asked, walked) = (sum(steps), sum(&varied));
        for step in &mut varied {
            step.length *= asked / walked;
        }
        Ok((varied, styles))
    }
}

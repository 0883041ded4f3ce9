//! One steady stride of a run in the numbers that people are measured by, and bands of these.

use super::bands::{BandCheck, BandReport};
use super::joints::JointSeries;
use super::series::Series;
use super::window::Window;
use super::{SAME_TIME, touch_downs};
use crate::body::FEET;
use crate::body::rotations;
use crate::error::{BodyError, GaitError, MeasureError};
use crate::request::pace::tidy;
use crate::request::run::at_speed;
use solaris_dynamics::{Tree, Workspace, forward_kinematics};
use solaris_model::{EventKind, Figure, Interval, Motion, SolePart};

/// The measures of a steady stride of a run, of the left leg from its contact on: times in ms, forces in body weights, angles in
/// degrees, moments in N m/kg about the distal segment's axes.
///
/// With the feature `serde` its keys are the fields' names with their units.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[doc(alias = "gait cycle")]
pub struct SteadyRun {
    /// Whether the foot lands on its ball: whether the motion says that its heel stands later than its ball does.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "std::ops::Not::not"))]
    pub on_forefoot: bool,
    /// Speed (m/s).
    #[cfg_attr(feature = "serde", serde(rename = "speed_m_s"))]
    pub speed: f64,
    /// Steps a minute.
    #[cfg_attr(feature = "serde", serde(rename = "cadence_per_min"))]
    pub cadence: f64,
    /// How long a foot is on the ground, and how long no foot is between two contacts (ms).
    #[doc(alias = "ground contact time")]
    #[cfg_attr(feature = "serde", serde(rename = "contact_ms"))]
    pub contact: f64,
    /// See `contact`.
    #[doc(alias = "aerial time")]
    #[cfg_attr(feature = "serde", serde(rename = "flight_ms"))]
    pub flight: f64,
    /// Greatest vertical force.
    #[doc(alias = "active peak")]
    #[cfg_attr(feature = "serde", serde(rename = "vertical_bw"))]
    pub vertical: f64,
    /// Greatest force backward (negative) and forward.
    #[cfg_attr(feature = "serde", serde(rename = "braking_bw"))]
    pub braking: f64,
    /// See `braking`.
    #[cfg_attr(feature = "serde", serde(rename = "pushing_bw"))]
    pub pushing: f64,
    /// Range of the force to the sides.
    #[cfg_attr(feature = "serde", serde(rename = "lateral_bw"))]
    pub lateral: f64,
    /// By how much the centre of mass rises and falls (cm).
    #[cfg_attr(feature = "serde", serde(rename = "com_rise_cm"))]
    pub com_vertical: f64,
    /// Knee flexion at contact, greatest in stance, least, greatest.
    #[cfg_attr(feature = "serde", serde(rename = "knee_contact_deg"))]
    pub knee_contact: f64,
    /// See `knee_contact`.
    #[cfg_attr(feature = "serde", serde(rename = "knee_stance_deg"))]
    pub knee_stance: f64,
    /// See `knee_contact`.
    #[cfg_attr(feature = "serde", serde(rename = "knee_least_deg"))]
    pub knee_least: f64,
    /// See `knee_contact`.
    #[cfg_attr(feature = "serde", serde(rename = "knee_swing_deg"))]
    pub knee_swing: f64,
    /// Hip flexion at contact, and its range.
    #[cfg_attr(feature = "serde", serde(rename = "hip_contact_deg"))]
    pub hip_contact: f64,
    /// See `hip_contact`.
    #[cfg_attr(feature = "serde", serde(rename = "hip_range_deg"))]
    pub hip_range: f64,
    /// Dorsiflexion at contact, greatest in stance, least.
    #[cfg_attr(feature = "serde", serde(rename = "ankle_contact_deg"))]
    pub ankle_contact: f64,
    /// See `ankle_contact`.
    #[cfg_attr(feature = "serde", serde(rename = "ankle_stance_deg"))]
    pub ankle_stance: f64,
    /// See `ankle_contact`.
    #[cfg_attr(feature = "serde", serde(rename = "ankle_least_deg"))]
    pub ankle_least: f64,
    /// Mean forward lean of the thorax.
    #[cfg_attr(feature = "serde", serde(rename = "thorax_lean_deg"))]
    pub thorax_lean: f64,
    /// Greatest moments: of the ankle, and in stance those that extend the knee and extend, flex and abduct the hip.
    #[cfg_attr(feature = "serde", serde(rename = "ankle_plantarflexor_n_m_per_kg"))]
    pub ankle_plantarflexor: f64,
    /// See `ankle_plantarflexor`.
    #[cfg_attr(feature = "serde", serde(rename = "knee_extensor_n_m_per_kg"))]
    pub knee_extensor: f64,
    /// See `ankle_plantarflexor`.
    #[cfg_attr(feature = "serde", serde(rename = "hip_extensor_n_m_per_kg"))]
    pub hip_extensor: f64,
    /// See `ankle_plantarflexor`.
    #[cfg_attr(feature = "serde", serde(rename = "hip_flexor_n_m_per_kg"))]
    pub hip_flexor: f64,
    /// See `ankle_plantarflexor`.
    #[cfg_attr(feature = "serde", serde(rename = "hip_abductor_n_m_per_kg"))]
    pub hip_abductor: f64,
}

/// Measures the first stride of a steady run, from a left contact to the next; the motion must have its forces.
///
/// # Errors
///
/// A motion without ground reactions or joint forces, or without a stride of the left foot.
pub fn measure_run(figure: &Figure, motion: &Motion) -> Result<SteadyRun, GaitError> {
    let joints = JointSeries::new(figure, motion)?;
    let series = Series::new(figure, motion)?;
    let missing =
        || MeasureError::NothingToMeasure { what: "stride of the left foot, from contact to contact" };
    let end_of_motion = motion.time()[motion.len() - 1];
    let mut lefts = touch_downs(motion).into_iter().filter(|(_, side)| *side == 0).map(|(time, _)| time);
    let start = lefts.next().ok_or_else(missing)?;
    // A stride that repeats itself has its last contact as its first one.
    let end = lefts.next().unwrap_or(end_of_motion);
    let lift = motion.events.iter().find(|event| {
        matches!(&event.kind, EventKind::LiftOff { link } if link == FEET[0])
            && event.time > start + SAME_TIME
    });
    let lift = lift.ok_or_else(missing)?.time;
    if lift >= end {
        return Err(missing().into());
    }
    let window = Window { time: series.time, span: (start, end) };
    let toe_off = (lift - start) / (end - start);
    let stance = (0.0, toe_off);
    // At the very instant of contact nothing presses on the foot yet.
    let loaded = (f64::EPSILON.sqrt(), toe_off);
    let left = &series.forces[0];
    let force = |axis: usize| move |i: usize| left[i][axis] / series.weight;
    let degrees = |values: &'_ [f64]| values.iter().map(|x| x.to_degrees()).collect::<Vec<f64>>();
    let (hip, knee, ankle) = (degrees(&joints.hip[0]), degrees(&series.knee[0]), degrees(&joints.ankle[0]));
    let thorax = thorax_lean(figure, motion)?;
    let moment = |joint: usize, axis: usize, sign: f64| {
        let moments = &joints.moments[0][joint];
        move |i: usize| sign * moments[i][axis]
    };
    let advance = window.at(end, &|i| series.com[i].z) - window.at(start, &|i| series.com[i].z);
    let stride = end - start;
    Ok(SteadyRun {
        on_forefoot: lands_on_ball(figure, motion, start),
        speed: advance / stride,
        cadence: 120.0 / stride,
        contact: 1e3 * (lift - start),
        flight: 1e3 * (0.5 * stride - (lift - start)),
        vertical: window.most(stance, &force(1)),
        braking: window.least(stance, &force(2)),
        pushing: window.most(stance, &force(2)),
        lateral: window.most(stance, &force(0)) - window.least(stance, &force(0)),
        com_vertical: 100.0 * window.range(&|i| series.com[i].y),
        knee_contact: window.at(start, &|i| knee[i]),
        knee_stance: window.most(stance, &|i| knee[i]),
        knee_least: window.least((0.0, 1.0), &|i| knee[i]),
        knee_swing: window.most((0.0, 1.0), &|i| knee[i]),
        hip_contact: window.at(start, &|i| hip[i]),
        hip_range: window.range(&|i| hip[i]),
        ankle_contact: window.at(start, &|i| ankle[i]),
        ankle_stance: window.most(stance, &|i| ankle[i]),
        ankle_least: window.least((0.0, 1.0), &|i| ankle[i]),
        thorax_lean: window.mean(&|i| thorax[i].to_degrees()),
        ankle_plantarflexor: window.most((0.0, 1.0), &moment(2, 0, 1.0)),
        knee_extensor: window.most(loaded, &moment(1, 0, -1.0)),
        hip_extensor: window.most(loaded, &moment(0, 0, 1.0)),
        hip_flexor: window.most(loaded, &moment(0, 0, -1.0)),
        hip_abductor: window.most(loaded, &moment(0, 2, 1.0)),
    })
}

/// Forward lean of the thorax in the world at every frame (rad).
fn thorax_lean(figure: &Figure, motion: &Motion) -> Result<Vec<f64>, GaitError> {
    let link = "thorax".to_owned();
    let missing = BodyError::MissingLinks { figure: figure.name().into(), links: vec![link.clone()] };
    let thorax = figure.link_index(&link).ok_or(missing)?;
    let tree = Tree::<f64>::new(figure, motion.info.gravity)?;
    let mut workspace = Workspace::new(&tree);
    let mut lean = Vec::with_capacity(motion.len());
    for i in 0..motion.len() {
        forward_kinematics(&tree, &mut workspace, motion.q(i))?;
        lean.push(rotations::euler(&workspace.pose(thorax).rotation)[2]);
    }
    Ok(lean)
}

/// A range that people's running lies in, linear in the speed.
#[derive(Clone, Copy, Debug)]
pub struct RunBand {
    /// What is measured.
    pub name: &'static str,
    /// Its unit.
    pub unit: &'static str,
    /// Its ends at 2.5, 3.5 and 4.5 m/s.
    pub lower: [f64; 3],
    /// See `lower`.
    pub upper: [f64; 3],
    value: fn(&SteadyRun) -> f64,
}

impl RunBand {
    /// A run's value.
    pub fn value(&self, run: &SteadyRun) -> f64 {
        (self.value)(run)
    }

    /// The range at a speed (m/s), linear between the three and beyond them, to four decimals.
    pub fn range(&self, speed: f64) -> (f64, f64) {
        (tidy(at_speed(self.lower, speed)), tidy(at_speed(self.upper, speed)))
    }
}

/// Bands of runners who land on their heels.
const OF_HEELS: [&str; 2] = ["knee at contact", "ankle at contact"];

/// Whether at a contact of the left foot (s) a point of the foot or its toes is planted, and its heel is not yet.
fn lands_on_ball(figure: &Figure, motion: &Motion, contact: f64) -> bool {
    let foot = figure.link_index(FEET[0]);
    let heel = foot.and_then(|foot| figure.links()[foot].sole_point(SolePart::Heel));
    let begins = |planted: &&Interval| (planted.start - contact).abs() < 1e-3;
    let of_left =
        |planted: &&Interval| Some(planted.link) == foot || figure.links()[planted.link].parent() == foot;
    let mut landing = motion.planted.iter().filter(of_left).filter(begins).peekable();
    landing.peek().is_some()
        && !landing.any(|planted| Some(planted.link) == foot && Some(&planted.point) == heel)
}

/// Holds a run against [`RUN_BANDS`]; on the forefoot without those of knee and ankle at contact, which are of heels.
pub fn run_bands(run: &SteadyRun) -> BandReport {
    let of_it = |band: &&RunBand| !(run.on_forefoot && OF_HEELS.contains(&band.name));
    let check = |band: &RunBand| BandCheck::new(band.name, band.unit, band.range(run.speed), band.value(run));
    BandReport::new("running", RUN_SOURCE, RUN_BANDS.iter().filter(of_it).map(check).collect())
}

const RUN_SOURCE: &str = "about two standard deviations about the means of 28 runners (Fukuchi 2017) for times and angles, else \
                          from memory, unchecked";

const fn band(
    name: &'static str,
    unit: &'static str,
    lower: [f64; 3],
    upper: [f64; 3],
    value: fn(&SteadyRun) -> f64,
) -> RunBand {
    RunBand { name, unit, lower, upper, value }
}

/// 22 bands of people's running, generous: about two standard deviations about the means of 28 runners (Fukuchi, Fukuchi & Duarte
/// 2017, `PeerJ` 5:e3298) for times and angles; forces, moments and lean are from memory, unchecked.
#[rustfmt::skip]
pub const RUN_BANDS: &[RunBand] = &[
    band("cadence", "steps/min", [150.0, 158.0, 165.0], [172.0, 184.0, 198.0], |r| r.cadence),
    band("contact", "ms", [245.0, 205.0, 180.0], [320.0, 270.0, 240.0], |r| r.contact),
    band("vertical force", "BW", [1.9, 2.15, 2.3], [2.5, 2.8, 3.0], |r| r.vertical),
    band("braking force", "BW", [-0.30, -0.42, -0.55], [-0.12, -0.20, -0.26], |r| r.braking),
    band("pushing force", "BW", [0.10, 0.17, 0.23], [0.27, 0.38, 0.48], |r| r.pushing),
    band("lateral force", "BW", [0.02, 0.03, 0.03], [0.15, 0.18, 0.20], |r| r.lateral),
    band("CoM rise", "cm", [6.0, 5.5, 5.0], [10.5, 10.5, 9.5], |r| r.com_vertical),
    band("knee at contact", "°", [5.0, 6.0, 7.0], [20.0, 21.0, 22.0], |r| r.knee_contact),
    band("knee in stance", "°", [35.0, 36.0, 37.0], [50.0, 51.0, 52.0], |r| r.knee_stance),
    band("least knee flexion", "°", [3.0, 3.0, 3.0], [25.0, 22.0, 20.0], |r| r.knee_least),
    band("knee in swing", "°", [75.0, 88.0, 98.0], [108.0, 122.0, 134.0], |r| r.knee_swing),
    band("hip at contact", "°", [18.0, 23.0, 27.0], [42.0, 48.0, 52.0], |r| r.hip_contact),
    band("hip range", "°", [40.0, 50.0, 58.0], [62.0, 74.0, 84.0], |r| r.hip_range),
    band("ankle at contact", "°", [-8.0, -8.0, -8.0], [12.0, 12.0, 12.0], |r| r.ankle_contact),
    band("ankle dorsiflexion", "°", [18.0, 18.0, 18.0], [33.0, 33.0, 33.0], |r| r.ankle_stance),
    band("ankle plantarflexion", "°", [-30.0, -34.0, -37.0], [-11.0, -15.0, -18.0], |r| r.ankle_least),
    band("thorax lean", "°", [2.0, 2.0, 3.0], [11.0, 12.0, 13.0], |r| r.thorax_lean),
    band("ankle plantarflexor moment", "N m/kg", [1.7, 2.0, 2.3], [3.1, 3.6, 3.9], |r| r.ankle_plantarflexor),
    band("knee extensor moment", "N m/kg", [1.6, 1.8, 2.0], [3.4, 3.9, 4.2], |r| r.knee_extensor),
    band("hip extensor moment", "N m/kg", [0.7, 1.0, 1.4], [2.2, 3.0, 3.8], |r| r.hip_extensor),
    band("hip flexor moment", "N m/kg", [0.4, 0.6, 0.9], [1.5, 2.2, 3.0], |r| r.hip_flexor),
    band("hip abductor moment", "N m/kg", [1.0, 1.2, 1.3], [2.6, 2.9, 3.1], |r| r.hip_abductor),
];

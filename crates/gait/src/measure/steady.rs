//! One steady stride, from left contact to left contact, in the numbers that gait laboratories report.

use super::SAME_TIME;
use super::joints::JointSeries;
use super::peaks::Stance;
use super::series::Series;
use super::window::{Window, middle_stride};
use solaris_model::{Event, EventKind, Motion};

/// Part of a stride's duration and way by which its halves may differ, and by which it may go sideways.
const UNEVEN: f64 = 0.02;
/// The vertical force (N) from which on a plate sees a foot.
const PLATE_THRESHOLD: f64 = 20.0;

/// The measures of a steady stride of the left leg. Forces in % of body weight, angles in degrees, excursions in cm,
/// moments in N m/kg about the distal segment's axes.
///
/// With the feature `serde` its keys are `span_s`, `step_length_m`, `speed_m_s`, `cadence_per_min`, `double_support_percent`,
/// `stance_percent`, `plate_double_support_percent`, `plate_stance_percent`, `walk_ratio_m_min` and, where it is, `backward`; what bands ask about is written with them ([`super::BandReport`]).
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs, reason = "the names are the measures; the bands list them with units")]
#[doc(alias = "gait cycle")]
#[doc(alias = "stride")]
pub struct SteadyStride {
    /// When it begins and ends (s).
    pub span: (f64, f64),
    /// Whether it goes backward: people's bands are of walking forward, and none is held against it.
    pub backward: bool,
    /// Step length (m), speed (m/s) and cadence (steps/min).
    pub step_length: f64,
    pub speed: f64,
    pub cadence: f64,
    /// One double support and the stance from touch-down to lift-off, in % of the stride.
    pub double_support: f64,
    pub stance: f64,
    /// The same as people's are measured, on plates that take a foot for lifted below 20 N.
    pub plate_double_support: f64,
    pub plate_stance: f64,
    pub mean_vertical: f64,
    pub first_peak: f64,
    pub valley: f64,
    pub second_peak: f64,
    pub braking: f64,
    pub pushing: f64,
    pub knee_contact: f64,
    pub knee_loading: f64,
    pub knee_swing: f64,
    pub hip_range: f64,
    pub ankle_least: f64,
    pub ankle_greatest: f64,
    pub pelvic_rotation: f64,
    pub pelvic_obliquity: f64,
    pub pelvic_tilt: f64,
    pub com_vertical: f64,
    pub com_lateral: f64,
    pub ankle_plantarflexor: f64,
    pub knee_extensor: f64,
    pub hip_extensor: f64,
    pub hip_flexor: f64,
    pub hip_abductor: f64,
}

impl SteadyStride {
    /// Step length over cadence (m·min); people's is about 0.0065 (Sekiya 1996).
    pub fn walk_ratio(&self) -> f64 {
        self.step_length / self.cadence
    }

    /// The stride from the middle-most left contact that has three steps before it and two after it, of those that go straight on
    /// along z at an even pace; eight steps have one.
    pub(super) fn find(
        motion: &Motion,
        series: &Series<'_>,
        joints: &JointSeries,
        contacts: &[(f64, usize)],
    ) -> Option<Self> {
        // Contacts 1 … n and the closing one: three steps on either side belong to starting and braking.
        let even = |i: usize| {
            // Two steps before it, one after it.
            let times: Vec<f64> =
                contacts[i - 2..=i + 3].windows(2).map(|pair| pair[1].0 - pair[0].0).collect();
            let alike = times.iter().all(|time| (time - times[2]).abs() < UNEVEN * times[2]);
            let [start, middle, end] = [0, 1, 2].map(|k| contacts[i + k].0);
            let window = Window { time: series.time, span: (start, end) };
            let advance = |from: f64, to: f64, axis: usize| {
                window.at(to, &|k| series.com[k][axis]) - window.at(from, &|k| series.com[k][axis])
            };
            let whole = series.sense * advance(start, end, 2);
            let halves = advance(middle, end, 2) - advance(start, middle, 2);
            alike && halves.abs() < UNEVEN * whole && advance(start, end, 0).abs() < UNEVEN * whole
        };
        let strides = (3..contacts.len().saturating_sub(5)).filter(|&i| contacts[i].1 == 0 && even(i));
        let begin = middle_stride(strides, contacts.len())?;
        Some(Self::of(motion, series, joints, (contacts[begin].0, contacts[begin + 2].0)))
    }

    pub(super) fn of(motion: &Motion, series: &Series<'_>, joints: &JointSeries, span: (f64, f64)) -> Self {
        let (start, end) = span;
        let stride = end - start;
        let window = Window { time: series.time, span };
        let lift = |name: &str| {
            let lift = motion.events.iter().find(
                |event| matches!(&event.kind, EventKind::LiftOff { link } if link == name && event.time >= start - SAME_TIME),
            );
            lift.map_or(f64::NAN, |event| (event.time - start) / stride)
        };
        let (double_support, toe_off) = (lift("right_foot"), lift("left_foot"));
        // When a foot begins to bear, or has ceased to.
        let meets =
            |event: &&Event| matches!(event.kind, EventKind::TouchDown { .. } | EventKind::LiftOff { .. });
        let turns: Vec<f64> = motion.events.iter().filter(meets).map(|event| event.time).collect();
        let percent = 100.0 / series.weight;
        let left = &series.forces[0];
        let vertical = |i: usize| percent * left[i].y;
        let along = |i: usize| series.sense * percent * left[i].z;
        let total = |i: usize| percent * (left[i].y + series.forces[1][i].y);
        let degrees = |values: &'_ [f64]| values.iter().map(|x| x.to_degrees()).collect::<Vec<f64>>();
        let (hip, knee, ankle) =
            (degrees(&joints.hip[0]), degrees(&series.knee[0]), degrees(&joints.ankle[0]));
        let range = |f: &dyn Fn(usize) -> f64| window.range(f);
        let pushed = Stance { window: Window { time: series.time, span }, toe_off };
        let pelvis = |axis: usize| range(&|i| joints.pelvis[axis][i].to_degrees());
        let moment = |joint: usize, axis: usize, sign: f64| {
            window.most((0.0, 1.0), &|i| sign * joints.moments[0][joint][i][axis])
        };
        let advance =
            series.sense * (window.at(end, &|i| series.com[i].z) - window.at(start, &|i| series.com[i].z));
        Self {
            span,
            backward: series.sense < 0.0,
            step_length: advance / 2.0,
            speed: advance / stride,
            cadence: 120.0 / stride,
            double_support: 100.0 * double_support,
            stance: 100.0 * toe_off,
            plate_double_support: 50.0
                * window.part_above(PLATE_THRESHOLD, &turns, &|i| left[i].y.min(series.forces[1][i].y)),
            plate_stance: 100.0 * window.part_above(PLATE_THRESHOLD, &turns, &|i| left[i].y),
            mean_vertical: window.mean(&total),
            first_peak: pushed.first_peak(&vertical),
            valley: pushed.valley(double_support, &vertical),
            second_peak: pushed.second_peak(&vertical),
            braking: pushed.braking(&along),
            pushing: pushed.pushing(&along),
            knee_contact: window.at(start, &|i| knee[i]),
            knee_loading: window.most((0.0, 0.28), &|i| knee[i]),
            knee_swing: window.most((0.0, 1.0), &|i| knee[i]),
            hip_range: range(&|i| hip[i]),
            ankle_least: window.least((0.0, 1.0), &|i| ankle[i]),
            ankle_greatest: window.most((0.0, 1.0), &|i| ankle[i]),
            pelvic_rotation: pelvis(2),
            pelvic_obliquity: pelvis(1),
            pelvic_tilt: pelvis(0),
            com_vertical: 100.0 * range(&|i| series.com[i].y),
            com_lateral: 100.0 * range(&|i| series.com[i].x),
            ankle_plantarflexor: moment(2, 0, 1.0),
            knee_extensor: moment(1, 0, -1.0),
            hip_extensor: moment(0, 0, 1.0),
            hip_flexor: moment(0, 0, -1.0),
            hip_abductor: moment(0, 2, 1.0),
        }
    }
}

#[cfg(feature = "serde")]
impl serde::Serialize for SteadyStride {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        use serde::ser::SerializeStruct;
        let mut stride = serializer.serialize_struct("SteadyStride", 9 + usize::from(self.backward))?;
        stride.serialize_field("span_s", &self.span)?;
        stride.serialize_field("step_length_m", &self.step_length)?;
        stride.serialize_field("speed_m_s", &self.speed)?;
        stride.serialize_field("cadence_per_min", &self.cadence)?;
        stride.serialize_field("double_support_percent", &self.double_support)?;
        stride.serialize_field("stance_percent", &self.stance)?;
        stride.serialize_field("plate_double_support_percent", &self.plate_double_support)?;
        stride.serialize_field("plate_stance_percent", &self.plate_stance)?;
        stride.serialize_field("walk_ratio_m_min", &self.walk_ratio())?;
        if self.backward {
            stride.serialize_field("backward", &true)?;
        }
        stride.end()
    }
}

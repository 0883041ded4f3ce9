//! Steps, and the one stride whose numbers are told.

use super::tracks::Tracks;
use super::{Metric, MetricsInput, NoValue};
use crate::measure::window::{Window, middle_stride};
use nalgebra::Vector3;
use solaris_analysis::ground::{Stance, Stances};

/// What goes less far than this in a stride (m) goes nowhere.
const NOWHERE: f64 = 0.01;

/// The stride that is told.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stride {
    /// Whose.
    pub(super) foot: usize,
    /// From touch-down to touch-down (s).
    pub(super) span: (f64, f64),
    /// When the foot leaves the ground, as a part of the stride.
    pub(super) toe_off: f64,
    /// How long another foot stands beside it at its beginning, as a part of the stride; of two feet.
    pub(super) double_support: Result<f64, NoValue>,
    /// How far the centre of mass goes over the ground (m), level.
    advance: Vector3<f64>,
}

impl Stride {
    fn duration(&self) -> f64 {
        self.span.1 - self.span.0
    }

    /// The way that it goes.
    pub(super) fn heading(&self) -> Result<Vector3<f64>, NoValue> {
        self.advance.try_normalize(NOWHERE).ok_or(NoValue::NoHeading)
    }
}

/// The steps of a motion.
pub(super) struct Steps {
    /// Touch-downs in the motion, not those before it.
    pub(super) touch_downs: usize,
    pub(super) stride: Result<Stride, NoValue>,
}

impl Steps {
    pub(super) fn of(given: &MetricsInput<'_>, tracks: &Tracks<'_>) -> Self {
        if given.soles().is_empty() {
            return Self { touch_downs: 0, stride: Err(NoValue::NoFeet) };
        }
        let Some(stances) = given.stances.filter(|stances| !stances.list.is_empty()) else {
            return Self { touch_downs: 0, stride: Err(NoValue::NoStance) };
        };
        let (begin, end) = tracks.span();
        let within = |stance: &&Stance| stance.start > begin && stance.start <= end;
        let mut landings: Vec<&Stance> = stances.list.iter().filter(within).collect();
        landings.sort_by(|a, b| a.start.total_cmp(&b.start));
        let stride = middle(&landings).map(|(from, to)| stride(given, tracks, stances, from, to));
        Self { touch_downs: landings.len(), stride: stride.ok_or(NoValue::NoStride) }
    }

    /// The rhythm of the steps.
    pub(super) fn metrics(&self, given: &MetricsInput<'_>) -> Vec<Metric> {
        let of =
            |value: &dyn Fn(&Stride) -> Result<f64, NoValue>| self.stride.and_then(|stride| value(&stride));
        let feet = given.soles().len();
        let two = |value: f64| if feet == 2 { Ok(value) } else { Err(NoValue::NotTwoFeet { feet }) };
        let count = if feet == 0 { Err(NoValue::NoFeet) } else { Ok(self.touch_downs as f64) };
        vec![
            Metric::new(("touch_downs", "touch-downs", ""), count, None),
            Metric::new(
                ("double_support_percent", "one double support", "% stride"),
                of(&|stride| Ok(100.0 * stride.double_support?)),
                None,
            ),
            Metric::new(
                ("stance_percent", "stance", "% stride"),
                of(&|stride| Ok(100.0 * stride.toe_off)),
                None,
            ),
            Metric::new(
                ("step_length_m", "step length", "m"),
                of(&|stride| two(stride.advance.norm() / 2.0)),
                None,
            ),
            Metric::new(
                ("step_frequency_per_min", "step frequency", "steps/min"),
                of(&|stride| two(120.0 / stride.duration())),
                None,
            ),
            Metric::new(
                ("speed_m_s", "speed", "m/s"),
                of(&|stride| Ok(stride.advance.norm() / stride.duration())),
                None,
            ),
        ]
    }

    /// How far the centre of mass goes up and down, and from side to side: in the stride, or else (bob) in the whole motion.
    pub(super) fn centre(&self, _: &MetricsInput<'_>, tracks: &Tracks<'_>) -> Vec<Metric> {
        let span = self.stride.map_or(tracks.span(), |stride| stride.span);
        let range = |axis: &Vector3<f64>| {
            let window = Window { time: tracks.time, span };
            100.0 * window.range(&|i| tracks.com[i].dot(axis))
        };
        let bob = if tracks.time.len() < 2 { Err(NoValue::TooFewSamples) } else { Ok(range(&tracks.up)) };
        let sway = self.stride.and_then(|stride| Ok(range(&tracks.up.cross(&stride.heading()?))));
        vec![
            Metric::new(("bob_cm", "bob of the centre of mass", "cm"), bob, None),
            Metric::new(("sway_cm", "sway of the centre of mass", "cm"), sway, None),
        ]
    }
}

/// The stride nearest to the middle of all touch-downs, of the first foot that has one.
fn middle<'a>(landings: &[&'a Stance]) -> Option<(&'a Stance, &'a Stance)> {
    let foot = landings
        .iter()
        .map(|stance| stance.foot)
        .filter(|foot| landings.iter().filter(|stance| stance.foot == *foot).count() > 1);
    let foot = foot.min()?;
    let next = |i: usize| landings[i + 1..].iter().find(|stance| stance.foot == foot);
    let begins = (0..landings.len()).filter(|&i| landings[i].foot == foot && next(i).is_some());
    let begin = middle_stride(begins, landings.len())?;
    Some((landings[begin], *next(begin)?))
}

fn stride(
    given: &MetricsInput<'_>,
    tracks: &Tracks<'_>,
    stances: &Stances,
    from: &Stance,
    to: &Stance,
) -> Stride {
    let span = (from.start, to.start);
    let (duration, feet) = (span.1 - span.0, given.soles().len());
    let window = Window { time: tracks.time, span };
    let com = |time: f64| Vector3::from([0, 1, 2].map(|k| window.at(time, &|i| tracks.com[i][k])));
    let beside = stances
        .list
        .iter()
        .find(|other| other.foot != from.foot && other.start <= from.start && other.end > from.start);
    let double_support = match beside {
        _ if feet != 2 => Err(NoValue::NotTwoFeet { feet }),
        Some(other) => Ok((other.end.min(span.1) - from.start) / duration),
        None => Ok(0.0),
    };
    Stride {
        foot: from.foot,
        span,
        toe_off: (from.end - from.start) / duration,
        double_support,
        advance: tracks.level(&(com(span.1) - com(span.0) - tracks.belt * duration)),
    }
}

//! One steady stride, planned in the numbers of a table and measured as a motion.

use nalgebra::Vector3;
use solaris_analysis::{Support, SupportLaw, balance_momentum, ground_reactions};
use solaris_dynamics::{Tree, Workspace, forward_kinematics};
use solaris_gait::people::{Beside, FACTS, Fact, Person, beside};
use solaris_gait::{
    FEET, LegGeometry, Resolution, SteadyStride, StridePlan, Style, StyleTable, TEXTBOOK_BANDS, WALK_RATIO,
    check_bands, free_moment, measure_stride,
};
use solaris_model::{Event, EventKind, Figure, Motion, MotionInfo, Trajectory};

/// Late swing, in which the toes pass over the ground: from so long after toe-off until when (u).
const LATE_SWING: (f64, f64) = (0.07, 0.93);

/// Mid-stance, in which the force to the side is looked at (u).
const LATERAL: (f64, f64) = (0.20, 0.42);

/// Height of a heel (m) from which on the foot is pressed on its ball, and how far behind that is round (m): somewhat less than where
/// [`solaris_gait::measure()`] finds the pressure outside of the sole.
const HEEL_RISEN: f64 = 0.8e-3;
const ROUND: f64 = 0.002;

/// Parts of a stride in which the vertical force has its first peak, and in which it is lower (u).
const FIRST_PEAK: (f64, f64) = (0.05, 0.21);
const MID_STANCE: (f64, f64) = (0.25, 0.36);

/// Who walks how.
#[derive(Clone, Debug)]
pub(crate) struct Case {
    pub(crate) figure: Figure,
    pub(crate) height: f64,
    pub(crate) leg: LegGeometry,
    /// Steps a minute.
    pub(crate) step_frequency: f64,
    /// Step length (m).
    pub(crate) step_length: f64,
}

impl Case {
    /// A person of this height (m) at this step frequency, with a step so many times people's.
    pub(crate) fn new(height: f64, step_frequency: f64, stretch: f64) -> Result<Self, String> {
        let step_length = WALK_RATIO * height * step_frequency * stretch;
        Self::of_person(height, 23.84 * height * height, step_frequency, step_length)
    }

    /// A person of this height (m) and mass (kg) with steps so long (m).
    pub(crate) fn of_person(
        height: f64,
        mass: f64,
        step_frequency: f64,
        step_length: f64,
    ) -> Result<Self, String> {
        let figure = solaris_model::human(height, mass).map_err(|error| error.to_string())?;
        let leg = LegGeometry::of(&figure).map_err(|error| error.to_string())?;
        Ok(Self { figure, height, leg, step_frequency, step_length })
    }

    pub(crate) fn style(&self, table: &StyleTable) -> Style {
        Style::from_table(table, &self.leg, self.height, self.step_frequency, self.step_length)
    }

    pub(crate) fn basis(&self) -> [f64; 4] {
        StyleTable::basis(&self.leg, self.height, self.step_frequency, self.step_length)
    }

    pub(crate) fn plan(&self, table: &StyleTable) -> Result<StridePlan, String> {
        StridePlan::new(&self.figure, &self.style(table), Resolution::default())
            .map_err(|error| error.to_string())
    }
}

/// A stride as a motion that goes on for ever; its laws are asked for at its nodes.
struct Endless(StridePlan);

impl Endless {
    fn clock(&self, t: f64) -> f64 {
        t / self.0.style().stride_time
    }
}

impl Trajectory for Endless {
    fn duration(&self) -> f64 {
        self.0.style().stride_time
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        self.0.configuration(self.clock(t), q);
    }

    fn resolution(&self) -> f64 {
        self.0.style().stride_time / self.0.node_count() as f64
    }
}

impl SupportLaw for Endless {
    fn support(&self, t: f64) -> Support {
        let (n, style) = (self.0.node_count(), self.0.style());
        let node = (self.clock(t) * n as f64).round() as usize;
        let mut feet = self.0.support(node % n);
        for foot in &mut feet {
            foot.cop.z += 2.0 * style.step_length * (node / n) as f64;
        }
        Support { feet, pivot: style.pivot, force: None }
    }
}

/// What a stride came to.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub(crate) steady: SteadyStride,
    /// Of the 21 bands of textbooks, and of all facts of people.
    pub(crate) bands: usize,
    pub(crate) facts: usize,
    /// By how much the foot lands with less pitch than the style's (°): whole walks land with the style's.
    pub(crate) pitch: f64,
    /// By how much the sole meets the ground before the knee's law expects it, which stops the foot at once (u).
    pub(crate) early: f64,
    /// Greatest free moment of a foot (N m).
    pub(crate) free_moment: f64,
    /// Least height of a sole's point late in swing, and of any point at all (m).
    pub(crate) clearance: f64,
    pub(crate) lowest: f64,
    /// Local maxima of the vertical force in one stance, and how far it goes up and down besides two peaks and a valley (%BW).
    pub(crate) humps: usize,
    pub(crate) detour: f64,
    /// How far the force in mid-stance comes up to its first peak, which is below zero where there are a peak and a valley (%BW).
    pub(crate) flank: f64,
    /// Least knee flexion (°).
    pub(crate) knee: f64,
    /// Friction of both feet, and of one that bears more than 5 % of the weight.
    pub(crate) friction: (f64, f64),
    /// Greatest distance of a sample of the whole fore-and-aft force from the cubic through its neighbours (%BW).
    pub(crate) notch: f64,
    /// Hip flexion, knee flexion, ankle dorsiflexion of the left leg at 0, 5, …, 95 % of the stride (°).
    pub(crate) curves: Vec<f64>,
    /// Vertical force of the left foot at 0, 2, … 98 % of the stride (%BW).
    pub(crate) vertical: Vec<f64>,
    /// Force of a foot towards the middle: least in mid-stance and greatest at all (%BW).
    pub(crate) inward: (f64, f64),
    /// Greatest extension of the toes while the foot stands (°).
    pub(crate) toes: f64,
    /// How far behind its ball the foot is pressed at most as its heel leaves the ground (m).
    pub(crate) behind_ball: f64,
    /// Curves of the left leg beside people's.
    pub(crate) beside: Vec<Beside>,
}

impl Found {
    pub(crate) fn of(case: &Case, table: &StyleTable) -> Result<Self, String> {
        let walk = Endless(case.plan(table)?);
        let (steady, motion) = measured(case, &walk).map_err(|error| error.to_string())?;
        let figure = &case.figure;
        let n = motion.len() - 1;
        let weight = figure.mass() * motion.info.gravity.norm();
        let force = |side: usize, i: usize| motion.contacts[side].samples[i % n].force;
        let total = |i: usize| force(0, i) + force(1, i);
        let ratio = |f: Vector3<f64>| f.x.hypot(f.z) / f.y;
        let foot_ratio = |i: usize| {
            let loaded = [force(0, i), force(1, i)].into_iter().filter(|f| f.y > 0.05 * weight);
            loaded.map(ratio).fold(0.0, f64::max)
        };
        let notch = |i: usize| {
            let z = |k: usize| total(i + n + k - 2).z;
            (z(2) - (4.0 * (z(1) + z(3)) - z(0) - z(4)) / 6.0).abs() * 100.0 / weight
        };
        let angle = |name: &str, i: usize| {
            let angle = figure.anatomical_angle(name).expect("a human's");
            (angle.sign * motion.q(i)[angle.coordinate]).to_degrees()
        };
        let curves = ["left_hip.flexion", "left_knee.flexion", "left_ankle.dorsiflexion"];
        let vertical: Vec<f64> = (0..n).map(|i| force(0, i).y * 100.0 / weight).collect();
        let stance = (walk.0.style().toe_off() * n as f64) as usize;
        let (humps, detour) = humps(&vertical[..=stance]);
        let heights = sole_heights(figure, &motion)?;
        let swinging = walk.0.style().toe_off() + LATE_SWING.0;
        let late = |i: &usize| (swinging..=LATE_SWING.1).contains(&(*i as f64 / n as f64));
        let least = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::INFINITY, f64::min);
        let most = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::NEG_INFINITY, f64::max);
        let inward = |i: usize| -force(0, i).x * 100.0 / weight;
        let middle = |i: &usize| (LATERAL.0..=LATERAL.1).contains(&(*i as f64 / n as f64));
        let toes = |i: usize| {
            let (foot, toes) = walk.0.foot_pitches(i as f64 / n as f64)[0];
            (foot - toes).to_degrees()
        };
        Ok(Self {
            bands: check_bands(TEXTBOOK_BANDS, &steady).iter().filter(|check| check.inside).count(),
            facts: facts(case, &steady),
            pitch: (walk.0.style().heel_strike_angle + walk.0.foot_pitches(0.0)[0].0).to_degrees(),
            early: early(&walk.0),
            free_moment: free_moment(&motion).value,
            clearance: least(&mut (0..n).filter(late).map(|i| heights[i])),
            lowest: least(&mut heights.iter().copied()),
            humps,
            detour,
            flank: flank(&vertical),
            knee: least(&mut (0..n).map(|i| angle("left_knee.flexion", i))),
            friction: (most(&mut (0..n).map(|i| ratio(total(i)))), most(&mut (0..n).map(foot_ratio))),
            notch: most(&mut (0..n).map(notch)),
            curves: curves
                .iter()
                .flat_map(|name| (0..20).map(move |k| (name, k)))
                .map(|(name, k)| angle(name, k * n / 20))
                .collect(),
            vertical: (0..50).map(|k| vertical[k * n / 50]).collect(),
            inward: (least(&mut (0..n).filter(middle).map(inward)), most(&mut (0..n).map(inward))),
            toes: most(&mut (0..=stance).map(toes)),
            behind_ball: most(&mut (0..n).map(|i| behind_ball(case, &walk.0, i))),
            beside: beside(figure, &motion, &steady),
            steady,
        })
    }
}

/// How many facts of people a stride shares.
pub(crate) fn facts(case: &Case, steady: &SteadyStride) -> usize {
    let person = Person { height: case.height, step_frequency: case.step_frequency };
    let held = |fact: &&Fact| {
        let (lower, upper) = fact.band(steady, &person);
        let slack = 1e-4 * lower.abs().max(upper.abs());
        (lower - slack..=upper + slack).contains(&fact.value(steady, &person))
    };
    FACTS.iter().filter(held).count()
}

fn measured(case: &Case, walk: &Endless) -> Result<(SteadyStride, Motion), Box<dyn std::error::Error>> {
    let (figure, style) = (&case.figure, walk.0.style());
    let rate = walk.0.node_count() as f64 / style.stride_time;
    let mut motion = Motion::sample(figure, walk, MotionInfo::on_earth(figure, rate))?;
    balance_momentum(figure, walk, &mut motion)?;
    let d = style.double_support;
    let events = [(0.0, true, 0), (d, false, 1), (0.5, true, 1), (0.5 + d, false, 0)];
    motion.events = events
        .iter()
        .map(|&(u, down, side)| {
            let link = FEET[side].to_owned();
            let kind = if down { EventKind::TouchDown { link } } else { EventKind::LiftOff { link } };
            Event { time: u * style.stride_time, kind }
        })
        .collect();
    ground_reactions(figure, &mut motion, FEET, walk)?;
    Ok((measure_stride(figure, &motion)?, motion))
}

/// How far behind its ball, but for what is round there, the left foot is pressed as its heel leaves the ground (m).
fn behind_ball(case: &Case, stride: &StridePlan, node: usize) -> f64 {
    let (foot, yaw) = (&case.leg, stride.style().foot_yaw);
    let u = node as f64 / stride.node_count() as f64;
    let [support, _] = stride.support(node);
    if u > stride.style().toe_off() || support.share <= 0.0 {
        return 0.0;
    }
    let ball = foot.foot_length() - foot.toe;
    let heel = ball * stride.foot_pitches(u)[0].0.sin();
    if heel > HEEL_RISEN { (ball - ROUND - support.cop.z / yaw.cos()).max(0.0) } else { 0.0 }
}

/// How long before the foot's time to be flat it is so. Where it comes to rest as its law has it, it is a little before.
fn early(stride: &StridePlan) -> f64 {
    const FLAT: f64 = -2e-5;
    const COUNT: u32 = 400;
    let flat = stride.style().foot_flat;
    let clock = |i: u32| flat * f64::from(i) / f64::from(COUNT);
    let pitch = |i: u32| stride.foot_pitches(clock(i))[0].0;
    (1..=COUNT).find(|&i| pitch(i) > FLAT).map_or(0.0, |i| {
        let (before, after) = (pitch(i - 1), pitch(i));
        flat - clock(i - 1) - (FLAT - before) / (after - before) * (clock(i) - clock(i - 1))
    })
}

/// Local maxima of a stance's vertical force, and the sum of all that it goes up and down besides from nothing to its first peak,
/// the valley, the second peak and back to nothing.
fn humps(vertical: &[f64]) -> (usize, f64) {
    let n = vertical.len();
    let maxima = (1..n - 1).filter(|&i| vertical[i] > vertical[i - 1] && vertical[i] >= vertical[i + 1]);
    let top = |from: usize, to: usize| {
        (from..to).max_by(|a, b| vertical[*a].total_cmp(&vertical[*b])).unwrap_or(from)
    };
    let (first, second) = (top(0, n * 2 / 5), top(n / 2, n));
    let valley =
        (first..=second).min_by(|a, b| vertical[*a].total_cmp(&vertical[*b])).map_or(0.0, |i| vertical[i]);
    let way: f64 = vertical.windows(2).map(|pair| (pair[1] - pair[0]).abs()).sum();
    let shortest = 2.0 * (vertical[first] + vertical[second] - valley) - vertical[0] - vertical[n - 1];
    (maxima.count(), way - shortest)
}

/// The greatest force in mid-stance against the first peak, of which a maximum at the end of its part would be none.
fn flank(vertical: &[f64]) -> f64 {
    let most = |(from, to): (f64, f64)| {
        let index = |u: f64| (u * vertical.len() as f64) as usize;
        vertical[index(from)..=index(to)].iter().fold(f64::NEG_INFINITY, |most, f| most.max(*f))
    };
    most(MID_STANCE) - most(FIRST_PEAK)
}

/// Height of the lowest point of the left foot's sole at every sample (m).
fn sole_heights(figure: &Figure, motion: &Motion) -> Result<Vec<f64>, String> {
    let foot = figure.link_index(FEET[0]);
    let links = figure.links().iter().enumerate();
    let points: Vec<(usize, Vector3<f64>)> = links
        .filter(|(index, link)| Some(*index) == foot || link.parent() == foot)
        .flat_map(|(index, link)| link.sole().iter().map(move |point| (index, point.position)))
        .collect();
    let tree = Tree::<f64>::new(figure, Vector3::zeros()).map_err(|error| error.to_string())?;
    let mut workspace = Workspace::new(&tree);
    (0..motion.len())
        .map(|i| {
            forward_kinematics(&tree, &mut workspace, motion.q(i)).map_err(|error| error.to_string())?;
            let height = |(link, point): &(usize, Vector3<f64>)| workspace.pose(*link).transform(point).y;
            Ok(points.iter().map(height).fold(f64::INFINITY, f64::min))
        })
        .collect()
}

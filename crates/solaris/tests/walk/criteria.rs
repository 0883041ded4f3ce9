//! What every walk must obey, judged on its samples.

use crate::body::{Moving, frames_at};
use crate::worst::Worst;
use solaris::gait::{FEET, WalkPlan};
use solaris::model::{Contact, Event, EventKind, Figure, Motion, SolePart, Trajectory, Vector3};

pub(crate) const SLIDE: &str = "planted point moves, m";
pub(crate) const SINK: &str = "sole below ground, m";
pub(crate) const PULL: &str = "pull, total, weights";
pub(crate) const FOOT_PULL: &str = "pull, loaded foot, weights";
pub(crate) const AIRBORNE: &str = "force on a foot in the air, N";
pub(crate) const FRICTION: &str = "friction, total";
pub(crate) const FOOT_FRICTION: &str = "friction, foot";
pub(crate) const MEAN: &str = "mean force off weight, weights";
pub(crate) const IMPULSE: &str = "impulse left, weight × time";
pub(crate) const REST: &str = "v at begin and end, m/s or rad/s";
pub(crate) const REST_A: &str = "a at begin and end, m/s² or rad/s²";
pub(crate) const FEET_APART: &str = "heels apart at begin and end, m";
pub(crate) const PRINTS: &str = "heel off its print, m";
pub(crate) const UNPLANTED: &str = "standing feet without planted point";
pub(crate) const PRINT_PLAN: &str = "prints off the lengths, m";
pub(crate) const FAR: &str = "heels off the last print at the end, m";
pub(crate) const NOT_FINITE: &str = "numbers that are not finite";

/// Weights below which the friction of a foot does not count.
const LIGHT: f64 = 0.05;

/// The motion's worst of all criteria.
pub(crate) fn judge(figure: &Figure, plan: &WalkPlan, motion: &Motion) -> Worst {
    let mut worst = Worst::default();
    let frames: Vec<Vec<Moving>> = (0..motion.len()).map(|i| frames_at(figure, motion, i)).collect();
    finite(motion, &mut worst);
    soles(figure, plan, motion, &frames, &mut worst);
    forces(figure, motion, &mut worst);
    ends(figure, plan, motion, &frames, &mut worst);
    prints(figure, plan, motion, &frames, &mut worst);
    worst
}

fn finite(motion: &Motion, worst: &mut Worst) {
    for (i, &time) in motion.time().iter().enumerate() {
        let tau = motion.tau(i).expect("forces of the joints");
        let contacts = motion.contacts.iter().flat_map(|track| {
            let Contact { force, moment, cop } = track.samples[i];
            [force, moment, cop].into_iter().flat_map(|v| [v.x, v.y, v.z])
        });
        let columns = motion.q(i).iter().chain(motion.v(i)).chain(motion.a(i)).chain(tau).copied();
        let bad = columns.chain(contacts).filter(|x| !x.is_finite()).count();
        worst.note(NOT_FINITE, bad as f64, 0.0, || seconds(time));
    }
}

/// Planted points stand where they were planted; nothing sinks; a foot that stands has a planted point.
fn soles(figure: &Figure, plan: &WalkPlan, motion: &Motion, frames: &[Vec<Moving>], worst: &mut Worst) {
    for interval in &motion.planted {
        let mut first = None;
        for (i, &time) in motion.time().iter().enumerate() {
            if time >= interval.start && time <= interval.end {
                let [place, ..] = frames[i][interval.link].point(&interval.point);
                let first = *first.get_or_insert(Vector3::new(place.x, 0.0, place.z));
                worst.note(SLIDE, (place - first).norm(), 1e-4, || seconds(time));
            }
        }
    }
    for (i, &time) in motion.time().iter().enumerate() {
        for (link, frame) in figure.links().iter().zip(&frames[i]) {
            for point in link.sole() {
                worst.note(SINK, -frame.point(&point.position)[0].y, 1e-3, || seconds(time));
            }
        }
        for foot in FEET {
            if stands(motion, foot, time) {
                let links = [figure.link_index(foot), figure.link_index(&foot.replace("foot", "toes"))];
                let planted = motion.planted.iter().any(|interval| {
                    // The last sample stands at or after the end of the plan, where its intervals end.
                    let time = time.min(plan.duration());
                    links.contains(&Some(interval.link)) && interval.start <= time && time <= interval.end
                });
                worst.note(UNPLANTED, if planted { 0.0 } else { 1.0 }, 0.0, || seconds(time));
            }
        }
    }
}

/// Whether a foot is on the ground by the events alone; near an event it is not said to be.
fn stands(motion: &Motion, foot: &str, time: f64) -> bool {
    let mut standing = true;
    for Event { time: at, kind } in &motion.events {
        let (on, link) = match kind {
            EventKind::TouchDown { link } => (true, link),
            EventKind::LiftOff { link } => (false, link),
            _ => continue,
        };
        if link == foot {
            if (time - at).abs() < 1e-9 {
                return false;
            }
            if *at < time {
                standing = on;
            }
        }
    }
    standing
}

/// Nothing pulls, nothing slips, on the whole the ground bears the weight.
fn forces(figure: &Figure, motion: &Motion, worst: &mut Worst) {
    let gravity = motion.info.gravity;
    let weight = figure.mass() * gravity.norm();
    let tracks = FEET.map(|foot| &motion.contact(foot).expect("a track for each foot").samples);
    let mut total = Vec::with_capacity(motion.len());
    for (i, &time) in motion.time().iter().enumerate() {
        let force = tracks[0][i].force + tracks[1][i].force;
        worst.note(PULL, -force.y / weight, -f64::MIN_POSITIVE, || seconds(time));
        worst.note(FRICTION, force.xz().norm() / force.y, 0.5, || seconds(time));
        for (foot, track) in FEET.iter().zip(tracks) {
            let force = track[i].force;
            if force != Vector3::zeros() {
                worst.note(FOOT_PULL, -force.y / weight, -f64::MIN_POSITIVE, || seconds(time));
            }
            if force.y > LIGHT * weight {
                worst.note(FOOT_FRICTION, force.xz().norm() / force.y, 0.6, || seconds(time));
            }
            if !touches(motion, foot, time) {
                worst.note(AIRBORNE, force.norm(), 0.0, || seconds(time));
            }
        }
        total.push(force);
    }
    let time = motion.time();
    let mut impulse = Vector3::zeros();
    for i in 1..motion.len() {
        let mean = (total[i] + total[i - 1]) / 2.0 + gravity * figure.mass();
        impulse += mean * (time[i] - time[i - 1]);
    }
    let whole = weight * time[time.len() - 1];
    worst.note(IMPULSE, impulse.amax() / whole, 1e-6, String::new);
    let contacts = touch_downs(motion);
    // Whole strides from the third contact, at most to the last but two.
    if contacts.len() >= 8 {
        let last = contacts.len() - 3;
        let (from, to) = (contacts[2], contacts[if last.is_multiple_of(2) { last } else { last - 1 }]);
        let vertical: Vec<f64> = total.iter().map(|force| force.y).collect();
        let mean = integral(time, &vertical, from, to) / (to - from);
        worst.note(MEAN, (mean / weight - 1.0).abs(), 0.01, || format!("{from:.2} s to {to:.2} s"));
    }
}

/// Whether a foot may be on the ground by the events; both sides of an event count.
fn touches(motion: &Motion, foot: &str, time: f64) -> bool {
    [-1e-6, 1e-6].iter().any(|shift| stands(motion, foot, time + shift))
}

fn touch_downs(motion: &Motion) -> Vec<f64> {
    let downs = motion.events.iter().filter(|event| matches!(event.kind, EventKind::TouchDown { .. }));
    downs.map(|event| event.time).collect()
}

/// Trapezoids between two times that need not be samples.
fn integral(time: &[f64], values: &[f64], from: f64, to: f64) -> f64 {
    let at = |i: usize, t: f64| {
        let part = (t - time[i]) / (time[i + 1] - time[i]);
        values[i] + part * (values[i + 1] - values[i])
    };
    (0..time.len() - 1)
        .filter(|i| time[i + 1] > from && time[*i] < to)
        .map(|i| {
            let (a, b) = (time[i].max(from), time[i + 1].min(to));
            f64::midpoint(at(i, a), at(i, b)) * (b - a)
        })
        .sum()
}

/// It begins and ends at rest, the heels side by side where they should be.
fn ends(figure: &Figure, plan: &WalkPlan, motion: &Motion, frames: &[Vec<Moving>], worst: &mut Worst) {
    let last = motion.len() - 1;
    let far = plan.prints()[plan.prints().len() - 1];
    for (sample, print) in [(0, 0.0), (last, far)] {
        let time = motion.time()[sample];
        for (j, name) in figure.layout().v_names().iter().enumerate() {
            let here = || format!("{name} {}", seconds(time));
            worst.note(REST, motion.v(sample)[j].abs(), 1e-9, here);
            worst.note(REST_A, motion.a(sample)[j].abs(), 1e-6, here);
        }
        let [left, right] = FEET.map(|foot| heel(figure, &frames[sample], foot));
        worst.note(FEET_APART, (left.z - right.z).abs(), 1e-6, || seconds(time));
        worst.note(FEET_APART, (left.x + right.x).abs(), 1e-6, || seconds(time));
        worst.note(FAR, (left.z - print).abs(), 1e-6, || seconds(time));
    }
}

/// Feet stand on the plan's prints, and these are a first, middle and two braking steps long. A fast walk begins and ends at 110
/// steps/min, gains 5 a step and loses 10, with steps that are shorter by as much.
fn prints(figure: &Figure, plan: &WalkPlan, motion: &Motion, frames: &[Vec<Moving>], worst: &mut Worst) {
    let (prints, n) = (plan.prints(), plan.steps());
    let fastest = (1..=n).map(|k| plan.style_of_step(k).step_frequency).fold(0.0, f64::max);
    let ratio = plan.style().step_length / plan.style().step_frequency;
    let mut z = 0.0;
    worst.note(PRINT_PLAN, (prints.len() as f64 - (n as f64 + 2.0)).abs(), 0.0, String::new);
    for (k, print) in prints.iter().enumerate().take(n + 1).skip(1) {
        let first = if k == 1 { 0.88 } else { 1.0 };
        let brake = if k + 1 == n { 0.80 } else { 1.0 };
        let factor = if k == n { 0.67 } else { f64::min(first, brake) };
        let (before, after) = ((k - 1) as f64, (n - k) as f64);
        z += factor * ratio * fastest.min(110.0 + 5.0 * before).min(110.0 + 10.0 * after);
        worst.note(PRINT_PLAN, (print - z).abs(), 1e-9, || format!("step {k}"));
    }
    worst.note(PRINT_PLAN, (prints[n + 1] - z).abs(), 1e-9, || "closing step".to_owned());
    for (side, foot) in FEET.iter().enumerate() {
        let link = figure.link_index(foot).expect("a foot");
        let point = figure.links()[link].sole_point(SolePart::Heel).expect("a heel");
        let heels = motion.planted.iter().filter(|i| i.link == link && i.point == *point);
        // The left foot stands on print 0 and takes the even steps, the right one 0 and the odd ones.
        let mut expected = vec![0];
        expected.extend((1..=n + 1).filter(|k| k % 2 == side));
        let heels: Vec<_> = heels.collect();
        worst.note(PRINTS, if heels.len() == expected.len() { 0.0 } else { f64::INFINITY }, 1e-4, || {
            format!("{} prints of {foot}, {} expected", heels.len(), expected.len())
        });
        for (interval, k) in heels.iter().zip(expected) {
            let half = 0.5 * plan.style_of_step(k.min(n)).step_width;
            let (x, z) = (if side == 0 { half } else { -half }, prints[k]);
            let on = |time: f64| interval.start <= time && time <= interval.end;
            let samples = (0..motion.len()).filter(|i| on(motion.time()[*i]));
            for i in samples {
                let place = heel(figure, &frames[i], foot);
                let off = (place - Vector3::new(x, 0.0, z)).norm();
                worst.note(PRINTS, off, 1e-4, || seconds(motion.time()[i]));
            }
        }
    }
}

fn heel(figure: &Figure, frames: &[Moving], foot: &str) -> Vector3<f64> {
    let link = figure.link_index(foot).expect("a foot");
    let heel = figure.links()[link].sole_point(SolePart::Heel).expect("a heel");
    frames[link].point(heel)[0]
}

pub(crate) fn seconds(time: f64) -> String {
    format!("{time:.3} s")
}

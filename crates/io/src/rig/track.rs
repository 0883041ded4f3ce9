//! The track of somebody who goes along the ground: where a game's capsule stands below them, without the sway of their steps.

use solaris_model::{Figure, Interval, Motion, Placement, UnitQuaternion, Vector3};
use std::collections::BTreeSet;
use std::f64::consts::TAU;

/// Over what time (s) a motion without strides is averaged; a loop up to so long (s) as a whole, which may be a stride itself.
const USUAL: f64 = 1.0;
const WHOLE: f64 = 3.0;
/// Times (s) and heights (m) that are one.
const ALIKE: f64 = 1e-6;
/// How near (m) links are at the end to where they are at the beginning of what repeats itself.
const SAME: f64 = 1e-4;
/// How fast (m/s) something moves about the pelvis of who does not stand.
const MOVES: f64 = 0.05;
/// The least horizontal part of the pelvis's forward axis that says a heading.
const LEVEL: f64 = 0.2;

/// Where one is at a sample: to the left, up and ahead (m), and the heading about the vertical (rad).
pub(super) type Place = [f64; 4];

/// The track below the pelvis in every sample of a `motion` of a person.
///
/// Its place is the mean of the pelvis's over one stride, centred at each sample, its heading that of the pelvis (while that points up or down, as before), its height that of the
/// lowest point of the soles while something is planted, so that it is that of the ground. Of a motion that says of nothing that it is planted the mean is over a second, and soles stand where
/// they come no lower; without soles the track is at height zero. Beyond an end at which one walks, the stride next to it goes on, so that the track is as even there, and where one clip goes on from another it
/// does not leap. Towards an end at which one stands the time of the mean becomes shorter: the track begins and ends there right below the pelvis.
pub(super) fn track(figure: &Figure, motion: &Motion) -> Vec<Place> {
    let below = below(figure, motion);
    let (n, time) = (below.len(), motion.time());
    if n < 2 {
        return below;
    }
    let (all, strides) = (time[n - 1] - time[0], strides(motion));
    let mut sorted = strides.clone();
    sorted.sort_by(f64::total_cmp);
    let [begins, ends] = [[0, 1], [n - 2, n - 1]].map(|samples| moves(figure, motion, samples));
    let repeats = (begins || ends) && is_loop(figure, motion);
    let usual = if repeats && all <= WHOLE { all } else { USUAL };
    let mut width = sorted.get(sorted.len() / 2).copied().unwrap_or(usual).min(all);
    let mut beyond = [strides.first().filter(|_| begins).copied(), strides.last().filter(|_| ends).copied()];
    if repeats {
        // What repeats itself goes on as a whole, and has a whole number of strides.
        width = all / (all / width).round();
        beyond = [Some(all); 2];
    }
    let (times, places) = gone_on(time, &below, beyond);
    let mean = Mean::of(&times, &places);
    let around = |time: f64| {
        let ends = (time - times[0]).min(times[times.len() - 1] - time);
        let half = (width / 2.0).min(ends);
        // Of next to no time it is the place itself.
        (half > 1e-9 * all).then(|| mean.between(time - half, time + half))
    };
    time.iter().zip(&below).map(|(time, below)| around(*time).unwrap_or(*below)).collect()
}

/// Right below the pelvis, on the ground.
fn below(figure: &Figure, motion: &Motion) -> Vec<Place> {
    let mut found: Vec<Place> = Vec::with_capacity(motion.len());
    let mut heights: Vec<Option<f64>> = Vec::with_capacity(motion.len());
    let stances = stances(motion.planted.iter());
    let mut heading = 0.0;
    let mut lows: Vec<Option<f64>> = Vec::with_capacity(motion.len());
    for (sample, time) in motion.time().iter().enumerate() {
        let places = figure.places(motion.q(sample));
        let ahead = places[0].rotation * Vector3::z();
        if ahead.x.hypot(ahead.z) > LEVEL {
            let now = ahead.x.atan2(ahead.z);
            heading = now + TAU * ((heading - now) / TAU).round();
        }
        let at = places[0].translation.vector;
        found.push([at.x, 0.0, at.z, heading]);
        let next = stances.partition_point(|(start, _)| start <= time);
        let stands = next > 0 && *time <= stances[next - 1].1;
        let low = lowest(figure, &places);
        heights.push(low.filter(|_| stands));
        lows.push(low);
    }
    if stances.is_empty() {
        // Where nothing says what stands: the soles do where they come no lower for a while. At an end what falls is not there yet.
        let is_least = |i: usize| {
            let is_end = i == 0 || i + 1 == lows.len();
            let about = lows[i.saturating_sub(1)..(i + 2).min(lows.len())].iter().flatten();
            let holds = |low: f64| {
                about.clone().all(|other| low <= other + ALIKE && (!is_end || low >= other - ALIKE))
            };
            lows[i].is_some_and(holds)
        };
        heights = (0..lows.len()).map(|i| lows[i].filter(|_| is_least(i))).collect();
    }
    for (place, height) in found.iter_mut().zip(between(&heights, motion.time())) {
        place[1] = height;
    }
    found
}

/// The height (m) of the lowest point of the soles, if there are any.
pub(super) fn lowest(figure: &Figure, places: &[Placement]) -> Option<f64> {
    let soles = figure.links().iter().zip(places).flat_map(|(link, place)| {
        link.sole().iter().map(move |point| (place.translation.vector + place.rotation * point.position).y)
    });
    soles.reduce(f64::min)
}

/// What is known at some of these times (s), and straight on between; before and after that as there, and zero where nothing is known.
fn between(known: &[Option<f64>], time: &[f64]) -> Vec<f64> {
    let told: Vec<(f64, f64)> = known.iter().zip(time).filter_map(|(x, time)| Some((*time, (*x)?))).collect();
    let at = |time: &f64| {
        let after = told.partition_point(|(t, _)| t <= time);
        match (after.checked_sub(1).map(|before| told[before]), told.get(after)) {
            (Some((from, a)), Some((to, b))) => a + (b - a) * (time - from) / (to - from),
            (Some((_, a)), None) => a,
            (None, Some((_, b))) => *b,
            (None, None) => 0.0,
        }
    };
    time.iter().map(at).collect()
}

/// From when until when (s) something is planted, in order: times that touch are one, as those of a foot's points that it rolls over.
fn stances<'a>(planted: impl Iterator<Item = &'a Interval>) -> Vec<(f64, f64)> {
    let mut all: Vec<(f64, f64)> = planted.map(|planted| (planted.start, planted.end)).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.dedup_by(|next, last| {
        let goes_on = next.0 <= last.1 + ALIKE;
        last.1 = if goes_on { last.1.max(next.1) } else { last.1 };
        goes_on
    });
    all
}

/// The times (s) from a foot's landings to its next ones, in the order of the first.
fn strides(motion: &Motion) -> Vec<f64> {
    let links: BTreeSet<usize> = motion.planted.iter().map(|planted| planted.link).collect();
    // What stands as the motion begins did not land then.
    let begin = motion.time()[0] + ALIKE;
    let of = |link: usize| {
        let mut stances = stances(motion.planted.iter().filter(move |planted| planted.link == link));
        stances.retain(|(start, _)| *start > begin);
        stances.windows(2).map(|two| (two[0].0, two[1].0 - two[0].0)).collect::<Vec<_>>()
    };
    let mut strides: Vec<(f64, f64)> = links.into_iter().flat_map(of).collect();
    strides.sort_by(|a, b| a.0.total_cmp(&b.0));
    strides.into_iter().map(|(_, stride)| stride).collect()
}

/// Where the links are as the pelvis sees them that goes along the ground (m).
fn posture(figure: &Figure, motion: &Motion, sample: usize) -> Vec<Vector3<f64>> {
    let places = figure.places(motion.q(sample));
    let ahead = places[0].rotation * Vector3::z();
    let level = Vector3::new(places[0].translation.x, 0.0, places[0].translation.z);
    let back = about_y(-ahead.x.atan2(ahead.z));
    places.iter().map(|place| back * (place.translation.vector - level)).collect()
}

/// How far (m) links are apart in two samples, as the pelvis sees them, at most.
fn apart(figure: &Figure, motion: &Motion, samples: [usize; 2]) -> f64 {
    let [a, b] = samples.map(|sample| posture(figure, motion, sample));
    a.iter().zip(&b).map(|(a, b)| (a - b).amax()).fold(0.0, f64::max)
}

/// Whether limbs move between two samples.
fn moves(figure: &Figure, motion: &Motion, [from, to]: [usize; 2]) -> bool {
    apart(figure, motion, [from, to]) > MOVES * (motion.time()[to] - motion.time()[from])
}

/// Whether it ends in the posture in which it begins.
fn is_loop(figure: &Figure, motion: &Motion) -> bool {
    apart(figure, motion, [0, motion.len() - 1]) < SAME
}

fn about_y(angle: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::from_scaled_axis(Vector3::y() * angle)
}

/// The places with the first so many seconds once more before the beginning, and the last so many once more after the end.
fn gone_on(time: &[f64], places: &[Place], [first, last]: [Option<f64>; 2]) -> (Vec<f64>, Vec<Place>) {
    let end = places.len() - 1;
    // What stands to the place `to` as this place does to that of `from`.
    let moved = |place: &Place, from: &Place, to: &Place| {
        let turn = to[3] - from[3];
        let way = about_y(turn) * Vector3::from_fn(|k, _| place[k] - from[k]);
        [to[0] + way.x, to[1] + way.y, to[2] + way.z, place[3] + turn]
    };
    let (mut times, mut found) = (Vec::new(), Vec::new());
    if let Some(seconds) = first {
        let from = at(time, places, time[0] + seconds);
        for i in (0..=end).take_while(|i| time[*i] < time[0] + seconds - ALIKE) {
            times.push(time[i] - seconds);
            found.push(moved(&places[i], &from, &places[0]));
        }
    }
    times.extend(time);
    found.extend(places);
    if let Some(seconds) = last {
        let from = at(time, places, time[end] - seconds);
        for i in (0..=end).filter(|i| time[*i] > time[end] - seconds + ALIKE) {
            times.push(time[i] + seconds);
            found.push(moved(&places[i], &from, &places[end]));
        }
    }
    (times, found)
}

/// The place at a time (s), straight on between samples.
fn at(time: &[f64], places: &[Place], when: f64) -> Place {
    let after = time.partition_point(|t| *t <= when).clamp(1, time.len() - 1);
    let part = ((when - time[after - 1]) / (time[after] - time[after - 1])).clamp(0.0, 1.0);
    std::array::from_fn(|k| places[after - 1][k] + part * (places[after][k] - places[after - 1][k]))
}

/// Means over any time of what goes straight on from sample to sample.
struct Mean<'a> {
    times: &'a [f64],
    places: &'a [Place],
    /// What it comes to from the beginning to each sample.
    sums: Vec<Place>,
}

impl<'a> Mean<'a> {
    fn of(times: &'a [f64], places: &'a [Place]) -> Self {
        let mut sums = vec![[0.0; 4]];
        for i in 1..times.len() {
            let width = times[i] - times[i - 1];
            let last = sums[i - 1];
            sums.push(std::array::from_fn(|k| {
                last[k] + width * f64::midpoint(places[i - 1][k], places[i][k])
            }));
        }
        Self { times, places, sums }
    }

    /// What it comes to from the beginning to a time.
    fn until(&self, time: f64) -> Place {
        let last = self.times.len() - 2;
        let i = self.times.partition_point(|t| *t <= time).saturating_sub(1).min(last);
        let (gone, width) = (time - self.times[i], self.times[i + 1] - self.times[i]);
        let (a, b) = (&self.places[i], &self.places[i + 1]);
        std::array::from_fn(|k| self.sums[i][k] + gone * (a[k] + 0.5 * (b[k] - a[k]) * gone / width))
    }

    fn between(&self, from: f64, to: f64) -> Place {
        let (a, b) = (self.until(from), self.until(to));
        std::array::from_fn(|k| (b[k] - a[k]) / (to - from))
    }
}

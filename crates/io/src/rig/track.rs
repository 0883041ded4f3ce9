//! The track of somebody who goes along the ground: where a game's capsule stands below them, without the sway of their steps.

use solaris_model::{Figure, Interval, Motion, Placement, UnitQuaternion, Vector3};
use std::collections::BTreeSet;
use std::f64::consts::TAU;

/// Over what time (s) a motion without steps is averaged.
const USUAL: f64 = 1.0;
/// How near (rad or m) the posture at the end is to that at the beginning of what repeats itself.
const ALIKE: f64 = 1e-6;
/// How fast (m/s) something moves about the pelvis in a loop of steps where it begins.
const MOVES: f64 = 0.05;
/// The least horizontal part of the pelvis's forward axis that says a heading.
const LEVEL: f64 = 0.2;

/// Where one is at a sample: to the left, up and ahead (m), and the heading about the vertical (rad).
pub(super) type Place = [f64; 4];

/// The track below the pelvis in every sample of a `motion` of a person.
///
/// Its place is the mean of the pelvis's over one stride, centred at each sample, its height that of the lowest point of the soles while something is planted, so that it is
/// that of the ground. Towards both ends the time of the mean becomes shorter, so that it begins and ends right below the pelvis; a motion that ends in the posture
/// in which it begins, as loops do, goes on before and after in place of that, and its track is as even as its pace.
pub(super) fn track(figure: &Figure, motion: &Motion) -> Vec<Place> {
    let below = below(figure, motion);
    let (n, time) = (below.len(), motion.time());
    if n < 2 {
        return below;
    }
    let all = time[n - 1] - time[0];
    let repeats = is_loop(figure, motion);
    let width = stride(motion).unwrap_or(USUAL).min(all);
    // What repeats itself has a whole number of them.
    let width = if repeats { all / (all / width).round() } else { width };
    // Once before, once after.
    let (times, places) = if repeats { thrice(time, &below) } else { (time.to_vec(), below.clone()) };
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
        heights.push(stands.then(|| lowest(figure, &places)).flatten());
    }
    for (place, height) in found.iter_mut().zip(between(&heights)) {
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

/// What is known, and straight on between; before and after that as there, and zero where nothing is known.
fn between(known: &[Option<f64>]) -> Vec<f64> {
    let told: Vec<(usize, f64)> = known.iter().enumerate().filter_map(|(i, x)| Some((i, (*x)?))).collect();
    let at = |i: usize| {
        let after = told.partition_point(|(k, _)| *k <= i);
        match (after.checked_sub(1).map(|before| told[before]), told.get(after)) {
            (Some((j, a)), Some((k, b))) => a + (b - a) * (i - j) as f64 / (k - j) as f64,
            (Some((_, a)), None) => a,
            (None, Some((_, b))) => *b,
            (None, None) => 0.0,
        }
    };
    (0..known.len()).map(at).collect()
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

/// The time (s) from a foot's landing to its next, the median of all.
fn stride(motion: &Motion) -> Option<f64> {
    let links: BTreeSet<usize> = motion.planted.iter().map(|planted| planted.link).collect();
    // What stands as the motion begins did not land then.
    let begin = motion.time()[0] + ALIKE;
    let of = |link: usize| {
        let mut stances = stances(motion.planted.iter().filter(move |planted| planted.link == link));
        stances.retain(|(start, _)| *start > begin);
        stances
    };
    let strides = |stances: Vec<(f64, f64)>| -> Vec<f64> {
        stances.windows(2).map(|two| two[1].0 - two[0].0).collect()
    };
    let mut times: Vec<f64> = links.into_iter().flat_map(|link| strides(of(link))).collect();
    times.sort_by(f64::total_cmp);
    times.get(times.len() / 2).copied()
}

/// Whether it ends in the posture in which it begins and moves there: from standing to standing is no loop.
fn is_loop(figure: &Figure, motion: &Motion) -> bool {
    let postures = [0, motion.len() - 1, 1].map(|sample| {
        let places = figure.places(motion.q(sample));
        let ahead = places[0].rotation * Vector3::z();
        let level = Vector3::new(places[0].translation.x, 0.0, places[0].translation.z);
        let back = about_y(-ahead.x.atan2(ahead.z));
        let seen = |place: &Placement| back * (place.translation.vector - level);
        places.iter().map(seen).collect::<Vec<_>>()
    });
    let off = |other: &[Vector3<f64>]| {
        postures[0].iter().zip(other).map(|(a, b)| (a - b).amax()).fold(0.0, f64::max)
    };
    let moved = MOVES * (motion.time()[1] - motion.time()[0]);
    off(&postures[1]) < ALIKE && off(&postures[2]) > moved
}

fn about_y(angle: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::from_scaled_axis(Vector3::y() * angle)
}

/// What repeats itself, once more before and once more after.
fn thrice(time: &[f64], places: &[Place]) -> (Vec<f64>, Vec<Place>) {
    let n = places.len();
    let (first, last) = (places[0], places[n - 1]);
    let all = time[n - 1] - time[0];
    // Where the place is that stands to `to` as this one does to `from`.
    let moved = |place: &Place, from: &Place, to: &Place| {
        let way = Vector3::new(place[0] - from[0], place[1] - from[1], place[2] - from[2]);
        let way = about_y(to[3] - from[3]) * way;
        [to[0] + way.x, to[1] + way.y, to[2] + way.z, place[3] + to[3] - from[3]]
    };
    let before = (0..n - 1).map(|i| (time[i] - all, moved(&places[i], &last, &first)));
    let own = (0..n).map(|i| (time[i], places[i]));
    let after = (1..n).map(|i| (time[i] + all, moved(&places[i], &first, &last)));
    before.chain(own).chain(after).unzip()
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

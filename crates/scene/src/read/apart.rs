//! Motions that keep links apart: the least that is needed is added to them, for as long as it is needed.

use super::SceneReader;
use super::reaches::share;
use nalgebra::Vector3;
use solaris_analysis::{Clearance, NearnessError};
use solaris_model::text::Fields;
use std::collections::BTreeMap;

/// How far apart links are kept (m) where nothing else is said.
pub(super) const APART: f64 = 5e-3;
/// The farthest that links are kept apart (m).
pub(super) const MOST_APART: f64 = 0.2;
/// How much farther (m) what is added takes them, so that there is an end of it.
const MORE: f64 = 5e-4;
/// In what time it comes and goes (s), and the shortest where there is not so much.
const COMES_IN: f64 = 0.3;
const SHORTEST: f64 = 0.2;
/// What is added in one round, at most (rad or m).
const STRIDE: f64 = 0.15;
/// What is deeper than this (m) in each other is first tried to be turned about its way, by so much (rad or m).
const DEEP: f64 = 0.02;
const TURNS: [f64; 8] = [0.4, -0.4, 0.8, -0.8, 1.2, -1.2, 1.8, -1.8];
/// How often something is added because of the same pair of links, how often without much of a gain, and for all of them together.
const MOST_OF_PAIR: usize = 24;
const MOST_IN_VAIN: usize = 4;
const MOST_ROUNDS: usize = 80;
/// Numbers of positions that all rounds look at, at most. What is longer than that allows, some minutes of a person, is left as it is.
const MOST_NUMBERS: usize = 16_000_000;

impl SceneReader<'_> {
    /// How far apart links are to be kept (m), a field `clearance`.
    pub(super) fn apart(&mut self, fields: &Fields<'_, '_>, usual: f64) -> Option<f64> {
        let Some(node) = fields.get("clearance") else { return Some(usual) };
        let apart = self.reader.number(node, "the clearance")?;
        if (0.0..=MOST_APART).contains(&apart) {
            return Some(apart);
        }
        let message = format!(
            "the clearance is {apart} m; it must be from 0, where nothing is kept apart, to {MOST_APART} m"
        );
        self.reader.fault(node.span.clone(), message);
        None
    }

    /// What there is to say of links that cannot be kept apart.
    pub(super) fn cuts(&self, cuts: &[Cuts]) -> Vec<String> {
        let name = |link: usize| self.figure().map_or("", |figure| figure.links()[link].name());
        let said = |Cuts { links: [a, b], distance, time }: &Cuts| {
            let (near, mm) = (
                if *distance < 0.0 { "go into each other by" } else { "come as near as" },
                1e3 * distance.abs(),
            );
            format!(
                "'{}' and '{}' {near} {mm:.1} mm, at {time:.2} s, and could not be kept apart",
                name(*a),
                name(*b)
            )
        };
        cuts.iter().map(said).collect()
    }
}

/// Something that is added for a time, all of it from `full` until `falls`, with the least jerk before and after.
#[derive(Clone, Debug)]
pub(super) struct Nudge {
    rises: f64,
    full: f64,
    falls: f64,
    gone: f64,
    /// To coordinates, in the order of who adds it (rad, m).
    pub(super) by: Vec<f64>,
    /// To the place of a point (m), where its way is free.
    pub(super) detour: Vector3<f64>,
}

impl Nudge {
    /// How much of it there is at a time (s), with its derivatives: 0 to 1.
    pub(super) fn at(&self, time: f64) -> [f64; 3] {
        if time < self.full {
            return Self::over(self.full - self.rises, time - self.rises);
        }
        if time <= self.falls {
            return [1.0, 0.0, 0.0];
        }
        let [gone, rate, change] = Self::over(self.gone - self.falls, time - self.falls);
        [1.0 - gone, -rate, -change]
    }

    /// A change from 0 to 1 that takes so long (s), after a time (s), with its derivatives.
    fn over(duration: f64, after: f64) -> [f64; 3] {
        let [done, rate, change] = share(after / duration);
        [done, rate / duration, change / (duration * duration)]
    }

    /// The same, but nothing of it before a time (s).
    #[must_use]
    pub(super) fn not_before(mut self, from: f64) -> Self {
        if self.rises < from {
            self.rises = from;
            self.full = self.full.max(from + SHORTEST);
            self.falls = self.falls.max(self.full);
            self.gone = self.gone.max(self.falls + COMES_IN);
        }
        self
    }

    /// A detour of a point within the time (s) that it is on its way; none where there is no time.
    pub(super) fn detour([from, until]: [f64; 2], along: Vector3<f64>, own: &Self) -> Option<Self> {
        let (rises, full) = (own.rises.max(from), own.full);
        let falls = own.falls.min(0.5 * (full + until));
        let gone = (falls + COMES_IN).min(until);
        (full - rises >= 0.5 * SHORTEST && gone - falls >= 0.5 * SHORTEST).then_some(Self {
            rises,
            full,
            falls,
            gone,
            by: Vec::new(),
            detour: along,
        })
    }
}

/// A motion at some times, to which nudges can be added.
pub(super) trait Nudged {
    /// The positions of the whole figure at each of the times, with what was added; kept until something is added or put back.
    fn positions(&mut self) -> Result<&[Vec<f64>], String>;

    /// How often all positions have been found by now.
    fn found(&self) -> usize;

    /// How far apart any links are to be at any time, at most (m).
    fn widest(&self) -> f64;

    /// How far apart a pair of links is to be at a time (m): nothing where the motion does not move it then.
    fn wanted(&self, frame: usize, dofs: &[usize]) -> f64;

    /// The positions without the motion, where that is over something else.
    fn otherwise(&self, frame: usize) -> Option<Vec<f64>>;

    /// Until when (s) what is added about a time is seen: what is too near then may stay.
    fn until(&self, frame: usize, dofs: &[usize]) -> f64;

    /// Adds a way that takes two links `by` (m) farther apart at a frame, where their distance changes by `slopes` with degrees of freedom,
    /// beside what is asked or, with `detour`, by another way to it; whether there is any.
    fn nudge(
        &mut self,
        frame: usize,
        slopes: &[(usize, f64)],
        by: f64,
        nudge: Nudge,
        detour: bool,
    ) -> Result<bool, String>;

    /// Adds a way of this size (rad, m) beside what is asked, of the limb that moves a pair; whether there is any.
    fn turn(&mut self, frame: usize, dofs: &[usize], by: f64, nudge: Nudge) -> Result<bool, String>;

    /// Whether points are where they would be without what was added, and nothing leaps.
    fn is_sound(&mut self) -> Result<bool, String>;

    /// All that was added, and in place of it what was added at another time.
    fn added(&self) -> Vec<Vec<Nudge>>;
    fn put_back(&mut self, added: Vec<Vec<Nudge>>);
}

/// A pair that could not be kept apart.
pub(super) struct Cuts {
    pub(super) links: [usize; 2],
    /// How far apart it is (m), negative for how deep in each other, and when (s).
    pub(super) distance: f64,
    pub(super) time: f64,
}

/// What has been tried for a pair: how often, the least that was missing and for how many rounds; and whether by a detour.
#[derive(Clone, Copy)]
struct Tried {
    count: usize,
    least: f64,
    since: usize,
    detour: bool,
    turned: bool,
}

impl Tried {
    const NOTHING: Self = Self { count: 0, least: f64::INFINITY, since: 0, detour: false, turned: false };
}

/// Keeps links apart in a motion, by as little as is needed; of what cannot be kept apart, what was best.
///
/// In each round the pair that misses most is taken farther apart where it does, along the slope of its distance as far as that is free,
///
/// ```text
/// δ = P·W·g·(d* − d)/(gᵀ·P·W·g)
/// ```
///
/// and what is added comes and goes within 0.3 s about the time in which the pair is too near. Of what is deep in each other the slopes tell
/// little: it is turned about its way first, as an elbow is about the line from the shoulder to the hand, as far as is best of some. Where
/// nothing is free, a point that is on its way takes another one. Links that would be nearer without the motion need not be farther apart with it.
pub(super) fn keep(
    clearance: &mut Clearance,
    times: &[f64],
    motion: &mut impl Nudged,
) -> Result<Vec<Cuts>, String> {
    let text = |error: NearnessError| error.to_string();
    let widest = motion.widest();
    if widest <= 0.0 || clearance.pairs().len() == 0 {
        return motion.positions().map(|_| Vec::new());
    }
    let numbers: usize = motion.positions()?.iter().map(Vec::len).sum();
    // What has been found and looked at, against what may be.
    let (mut looks, most) = (0, MOST_NUMBERS / numbers.max(1));
    if most < 2 {
        return Ok(Vec::new());
    }
    let mut given_up = Vec::new();
    let mut tried: BTreeMap<usize, Tried> = BTreeMap::new();
    let mut best = (f64::INFINITY, motion.added());
    for _ in 0..MOST_ROUNDS {
        let missing = Missing::of(clearance, motion, times.len())?;
        let cost = missing.cost();
        if cost < best.0 && motion.is_sound()? {
            best = (cost, motion.added());
        }
        looks += 1;
        let has_time = looks + motion.found() < most;
        let Some((frame, pair, by)) = missing.worst(&given_up).filter(|_| has_time) else { break };
        let known = tried.entry(pair).or_insert(Tried::NOTHING);
        known.count += 1;
        known.since += 1;
        if by < 0.8 * known.least {
            (known.least, known.since) = (by, 0);
        }
        let until = motion.until(frame, clearance.moved_by(pair));
        let nudge = missing.nudge(times, frame, pair, until);
        if by > DEEP && !known.turned {
            // Slopes tell little of what is deep in each other: the limb is turned about its way, as far as is best.
            known.turned = true;
            let added = motion.added();
            let mut least = (cost, None);
            for turn in TURNS {
                if looks + motion.found() >= most {
                    break;
                }
                if motion.turn(frame, clearance.moved_by(pair), turn, nudge.clone())? && motion.is_sound()? {
                    looks += 1;
                    let cost = Missing::of(clearance, motion, times.len())?.cost();
                    if cost < least.0 {
                        least = (cost, Some(motion.added()));
                    }
                }
                motion.put_back(added.clone());
            }
            if let Some(turned) = least.1 {
                motion.put_back(turned);
                continue;
            }
        }
        let slopes = clearance.slopes(&motion.positions()?[frame], pair).map_err(text)?;
        let goes_on = known.since <= MOST_IN_VAIN && known.count <= MOST_OF_PAIR;
        if goes_on && motion.nudge(frame, &slopes, by + MORE, nudge, known.detour)? {
            continue;
        }
        if known.detour {
            given_up.push(pair);
        } else {
            *known = Tried { detour: true, turned: true, ..Tried::NOTHING };
        }
    }
    if !tried.is_empty() {
        motion.put_back(best.1);
    }
    let mut cuts: BTreeMap<usize, Cuts> = BTreeMap::new();
    for (frame, time) in times.iter().enumerate() {
        for (pair, distance) in
            Missing::of_frame(clearance, motion, frame)?.into_iter().map(|one| (one.0, one.2))
        {
            let links = clearance.pairs().nth(pair).unwrap_or_default();
            let worst = cuts.entry(pair).or_insert(Cuts { links, distance: f64::INFINITY, time: 0.0 });
            if distance < worst.distance {
                (worst.distance, worst.time) = (distance, *time);
            }
        }
    }
    Ok(cuts.into_values().collect())
}

/// What is too near, by frame: which pair, and how much is missing (m).
struct Missing {
    frames: Vec<Vec<(usize, f64)>>,
}

impl Missing {
    /// What is too near in a motion of so many frames.
    fn of(clearance: &mut Clearance, motion: &mut impl Nudged, count: usize) -> Result<Self, String> {
        let mut frames = Vec::with_capacity(count);
        for frame in 0..count {
            let near = Self::of_frame(clearance, motion, frame)?;
            frames.push(near.into_iter().map(|(pair, by, _)| (pair, by)).collect());
        }
        Ok(Self { frames })
    }

    /// What is too near in a frame: which pair, how much is missing, and how far apart it is (m).
    fn of_frame(
        clearance: &mut Clearance,
        motion: &mut impl Nudged,
        frame: usize,
    ) -> Result<Vec<(usize, f64, f64)>, String> {
        let text = |error: NearnessError| error.to_string();
        let widest = motion.widest();
        let mut missing = Vec::new();
        for (pair, distance) in clearance.nearer(&motion.positions()?[frame], widest).map_err(text)? {
            let wanted = motion.wanted(frame, clearance.moved_by(pair));
            if distance < wanted {
                let otherwise = motion.otherwise(frame);
                let own = otherwise.map(|q| clearance.distance(&q, pair)).transpose().map_err(text)?;
                let wanted = own.map_or(wanted, |own| wanted.min(own));
                if distance < wanted {
                    missing.push((pair, wanted - distance, distance));
                }
            }
        }
        Ok(missing)
    }

    /// The squares of what is missing at most of each pair (m²).
    fn cost(&self) -> f64 {
        let mut most: BTreeMap<usize, f64> = BTreeMap::new();
        for (pair, by) in self.frames.iter().flatten() {
            let most = most.entry(*pair).or_default();
            *most = most.max(*by);
        }
        most.values().map(|most| most * most).sum()
    }

    fn worst(&self, but: &[usize]) -> Option<(usize, usize, f64)> {
        let frames = self.frames.iter().enumerate();
        let all = frames.flat_map(|(frame, pairs)| pairs.iter().map(move |(pair, by)| (frame, *pair, *by)));
        all.filter(|(_, pair, _)| !but.contains(pair)).max_by(|a, b| a.2.total_cmp(&b.2))
    }

    /// What is to be added about a frame, as long as the pair is too near.
    fn nudge(&self, times: &[f64], frame: usize, pair: usize, until: f64) -> Nudge {
        let is_near = |frame: &usize| self.frames[*frame].iter().any(|(other, ..)| *other == pair);
        let first = (0..=frame).rev().take_while(is_near).last().unwrap_or(frame);
        let last = (frame..times.len()).take_while(is_near).last().unwrap_or(frame);
        let (rises, full) = (times[first] - COMES_IN, times[first]);
        // What comes to rest so near stays where it is then.
        let stays = last + 1 >= times.len() || times[last] + COMES_IN > until;
        let falls = if stays { f64::INFINITY } else { times[last] };
        Nudge { rises, full, falls, gone: falls + COMES_IN, by: Vec::new(), detour: Vector3::zeros() }
    }
}

/// The way along slopes that has been freed of what it must not change, so that the distance grows by so much (m), and nothing of it is more
/// than a stride; none where nothing is left of it.
pub(super) fn way(slopes: &[f64], mut free: Vec<f64>, by: f64) -> Option<Vec<f64>> {
    let gain: f64 = slopes.iter().zip(&free).map(|(slope, way)| slope * way).sum();
    let square: f64 = slopes.iter().map(|slope| slope * slope).sum();
    if gain <= 1e-6 * square || square <= 0.0 {
        return None;
    }
    let longest = free.iter().fold(0.0_f64, |most, way| most.max(way.abs()));
    let scale = (by / gain).min(STRIDE / longest);
    for way in &mut free {
        *way *= scale;
    }
    Some(free)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_added_comes_and_goes_smoothly() {
        let nudge =
            Nudge { rises: 0.2, full: 0.5, falls: 0.9, gone: 1.2, by: Vec::new(), detour: Vector3::zeros() };
        let h = 1e-6;
        for k in 0..1400 {
            let time = 1e-3 * f64::from(k) + 3e-4;
            let [much, rate, change] = nudge.at(time);
            let [before, after] = [-h, h].map(|by| nudge.at(time + by));
            assert!((0.0..=1.0).contains(&much), "{time}");
            assert!(((after[0] - before[0]) / (2.0 * h) - rate).abs() < 1e-8, "{time}");
            assert!(((after[1] - before[1]) / (2.0 * h) - change).abs() < 1e-6, "{time}");
        }
        assert!(nudge.at(0.1)[0] <= 0.0 && nudge.at(0.7)[0] >= 1.0 && nudge.at(2.0)[0] <= 0.0);
        let stays = Nudge { falls: f64::INFINITY, gone: f64::INFINITY, ..nudge.clone() };
        assert!(stays.at(1e6)[0] >= 1.0);
        // A detour is over when the point is there.
        let detour = Nudge::detour([0.3, 0.8], Vector3::x(), &nudge).expect("time enough");
        assert!(detour.at(0.3)[0] <= 0.0 && detour.at(0.8)[0] <= 0.0 && detour.at(0.55)[0] >= 1.0);
        assert!(Nudge::detour([0.5, 0.8], Vector3::x(), &nudge).is_none());
    }

    #[test]
    fn a_way_takes_apart_by_as_much_as_is_asked() {
        let by = way(&[0.2, 0.0, -0.1], vec![0.2, 0.0, -0.1], 0.01).expect("a way");
        assert!((0.2 * by[0] - 0.1 * by[2] - 0.01).abs() < 1e-15);
        // No farther than a stride, and not along what is no way.
        let far = way(&[0.01, 0.0], vec![0.01, 0.0], 1.0).expect("a way");
        assert!((far[0] - STRIDE).abs() < 1e-15);
        assert!(way(&[0.2, 0.1], vec![0.0, 0.0], 0.01).is_none() && way(&[0.0], vec![1.0], 0.01).is_none());
    }
}

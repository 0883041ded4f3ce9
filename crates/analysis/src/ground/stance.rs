//! Stances: when which foot stands.

mod edges;
mod steps;
mod support;
mod track;

use crate::ground::{BalanceFrame, Footing, GroundError, GroundOption, PlacedFeet, Sole};
use edges::standing;
use nalgebra::Vector3;
use solaris_model::{ContactTrack, Interval};
use steps::{Limits, steps};
use support::Support;
use track::{FootTrack, Tracks};

/// From when to when (s).
type Span = (f64, f64);

/// A time during which a foot is on the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stance {
    /// Index in the soles.
    pub foot: usize,
    /// From when (s).
    pub start: f64,
    /// Until when (s).
    pub end: f64,
}

/// How the ground itself moves.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Belt {
    /// It does not.
    Still,
    /// With this velocity (m/s, world axes): a treadmill.
    Speed(Vector3<f64>),
    /// As the feet on it do: the median of the horizontal velocity of the lowest point of all soles over the frames in
    /// which it is down and more than half of the weight is borne. Less than [`Belt::LEAST`] is none, and less than
    /// [`Belt::LEAST_OF_TRAVEL`] of the speed of travel.
    #[default]
    Auto,
}

impl Belt {
    /// The slowest belt (m/s) that [`Belt::Auto`] tells from a ground that stands still.
    pub const LEAST: f64 = 0.1;

    /// What [`Belt::Auto`] finds is a belt only if it is at least this share of the speed at which the centre of mass travels over it: a
    /// treadmill is all of that speed, a foot that rolls over the ground is little.
    pub const LEAST_OF_TRAVEL: f64 = 0.25;
}

/// What counts as standing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StanceOptions {
    /// How far (m) above its own lowest height a point of the sole may be and still be down; `None` for
    /// [`StanceOptions::HEIGHT`], or a twentieth of the height that the foot is lifted to where that is more.
    pub height: Option<f64>,
    /// How fast (m/s) it may be against the ground and still be down, whether it comes or leaves; `None` for shares of its speed in
    /// the swing before and after, as [`find_stances`] says.
    pub speed: Option<f64>,
    /// Stances, and gaps between two of one foot, that are shorter than this (s) are none.
    pub shortest: f64,
    /// The ground's own motion.
    pub belt: Belt,
}

impl Default for StanceOptions {
    /// Limits that scale with the motion, 0.1 s; the ground's motion as the feet tell it.
    fn default() -> Self {
        Self { height: None, speed: None, shortest: 0.1, belt: Belt::Auto }
    }
}

impl StanceOptions {
    /// The least height (m) that a point of the sole may be lifted by and still be down.
    pub const HEIGHT: f64 = 0.02;

    /// The least speed (m/s) below which a foot may stand at all, however slow the motion is.
    pub const SPEED: f64 = 0.5;

    fn check(&self) -> Result<(), GroundError> {
        let positive = |value: f64| value.is_finite() && value > 0.0;
        let (some, more) = ("finite and more than zero", "finite and not less than zero");
        let asked = [(GroundOption::Height, self.height), (GroundOption::Speed, self.speed)];
        let asked = asked.into_iter().filter_map(|(option, value)| Some((option, value?)));
        let mut numbers: Vec<_> =
            asked.map(|(option, value)| (option, value, positive(value), some)).collect();
        numbers.extend([(
            GroundOption::Shortest,
            self.shortest,
            self.shortest.is_finite() && self.shortest >= 0.0,
            more,
        )]);
        if let Belt::Speed(velocity) = self.belt {
            let speed = velocity.norm();
            numbers.push((GroundOption::Belt, speed, speed.is_finite(), "finite"));
        }
        match numbers.into_iter().find(|(_, _, right, _)| !right) {
            Some((option, value, _, range)) => Err(GroundError::Option { option, value, range }),
            None => Ok(()),
        }
    }
}

/// When which foot stands, and what on.
#[derive(Clone, Debug, PartialEq)]
pub struct Stances {
    /// By foot, each foot's in the order of time and apart from each other.
    pub list: Vec<Stance>,
    /// Velocity of the ground (m/s, world axes).
    pub belt: Vector3<f64>,
    /// Height of the ground along up, the direction against gravity (m).
    pub level: f64,
    /// What each of them stands on, in the order of the list; none where all stand on the level ground.
    pub footings: Vec<Footing>,
    /// How they were found.
    pub method: &'static str,
}

impl Stances {
    /// Whether a foot (an index in the soles) stands at a time (s).
    pub fn stands(&self, foot: usize, time: f64) -> bool {
        self.list.iter().any(|stance| stance.foot == foot && (stance.start..=stance.end).contains(&time))
    }

    pub(crate) fn check(&self, feet: usize) -> Result<(), GroundError> {
        if !self.level.is_finite() {
            return Err(super::total::bad_level(self.level));
        }
        StanceOptions { belt: Belt::Speed(self.belt), ..StanceOptions::default() }.check()?;
        let is_plane = |footing: &Footing| {
            footing.point.iter().all(|x| x.is_finite()) && (footing.normal.norm() - 1.0).abs() < 1e-6
        };
        if let Some(stance) = self.footings.iter().position(|footing| !is_plane(footing)) {
            return Err(GroundError::NoPlane { stance });
        }
        let (found, expected) = (self.footings.len(), self.list.len());
        if found != 0 && found != expected {
            return Err(GroundError::Length { what: "what feet stand on", found, expected });
        }
        let bad =
            |s: &Stance| !(s.foot < feet && s.start.is_finite() && s.end.is_finite() && s.start <= s.end);
        match self.list.iter().position(bad) {
            None => Ok(()),
            Some(stance) => {
                let Stance { foot, start, end } = self.list[stance];
                Err(GroundError::Stance { stance, foot, feet, start, end })
            }
        }
    }
}

/// Finds when which foot stands, and on what, from how heel, ball and tip of each sole move, and from the whole force.
///
/// A point of a sole is down while it is less than a height above its own lowest one (the lowest but a twentieth of
/// the frames, since it is seldom known how high above the ground a point really is), and slower than a speed against
/// the ground ([`StanceOptions`]). A foot stands while one of its points is down; a foot that never comes within 5 cm of the lowest one, nor stands
/// alone, never stands. Where no speed is asked for it is, with `v` the greatest speed of the foot's points in the swing beside the edge,
///
/// ```text
/// touch-down: 0.13 v      lift-off: 0.24 v      at least 0.2 m/s
/// ```
///
/// An edge lies between two frames, where a straight line through what decides becomes zero. Gaps shorter
/// than `shortest` are closed, then stances shorter than that are dropped, but for those that the ends of the motion
/// cut off.
///
/// With the whole normal force over the weight: below 0.1 for 0.05 s nobody stands but a foot that is low and slower than 0.2 m/s; beside
/// such a flight a foot stands as soon, and as long, as there is force and it is less than twice the height up; above 0.5 somebody stands, if no foot is down
/// those that are slow, on whatever is under them. A motion in which nothing is ever borne has no such say.
///
/// `level` is the median of the lowest heights of the points of all feet that may stand. Where feet stand more than 5 cm apart in height the ground is not level:
/// each stands on the plane in which its sole lies while it moves least ([`Stances::footings`]), level aside, and level where that is tilted by less than 4°; such ground stands
/// still unless [`Belt::Speed`] says otherwise.
///
/// # Source
///
/// The shares of the swing's speed were chosen on half of 18 measured walks with force plates, filtered at 6 Hz, and hold on the others
/// (`docs/ground.md`). Foot velocity as the sign of gait events: O'Connor and others (2007), Gait & Posture 25:469.
///
/// # Errors
///
/// Options out of their range, and states that the kernel refuses.
#[doc(alias = "gait events")]
#[doc(alias = "foot contact")]
pub fn find_stances(feet: &PlacedFeet<'_>, options: &StanceOptions) -> Result<Stances, GroundError> {
    options.check()?;
    let prepared = feet.prepared();
    let total = feet.whole()?;
    let tracks = Tracks::of(feet);
    let normal = total.iter().map(|frame| frame.force.dot(&prepared.up) / prepared.weight).collect();
    let support = Support::new(prepared.time(), normal);
    let mut belt = match options.belt {
        Belt::Still => Vector3::zeros(),
        Belt::Speed(velocity) => velocity,
        Belt::Auto => {
            let height = options.height.unwrap_or(StanceOptions::HEIGHT);
            tracks.belt(height, |row| support.borne(row), &travel(total))
        }
    };
    let find = |of_feet: Vec<FootTrack>| -> Vec<Stance> {
        let limits: Vec<Limits> = of_feet.iter().map(|track| Limits::of(track, options)).collect();
        let each = of_feet.iter().zip(&limits);
        let mut spans: Vec<Vec<Span>> =
            each.map(|(track, limits)| steps(prepared.time(), track, limits, options.shortest)).collect();
        support.settle(&mut spans, &of_feet, &limits, options.shortest);
        let all = spans.iter().enumerate();
        let of_foot = |(foot, spans): (usize, &Vec<Span>)| {
            spans.iter().map(|&(start, end)| Stance { foot, start, end }).collect::<Vec<_>>()
        };
        all.flat_map(of_foot).collect()
    };
    let all = 0..feet.soles().len();
    let level = |belt: &Vector3<f64>| {
        let list = find(all.clone().map(|foot| tracks.foot(foot, belt)).collect());
        (feet.footings(&list, belt), list)
    };
    let (mut footings, mut list) = level(&belt);
    if !footings.is_empty() && options.belt == Belt::Auto && belt != Vector3::zeros() {
        // Stairs and slopes do not move; their lowest points said so little of it.
        belt = Vector3::zeros();
        (footings, list) = level(&belt);
    }
    if !footings.is_empty() {
        // Where the ground is not level heights are told from what each foot stands on, once that is known.
        list = find(all.map(|foot| tracks.foot_on(foot, &belt, &list)).collect());
        footings = feet.footings(&list, &belt);
    }
    let method = "heights and speeds of heel, ball and tip, and the whole force";
    Ok(Stances { list, belt, level: tracks.level(), footings, method })
}

/// How the centre of mass travels from the first frame to the last (m/s).
fn travel(total: &[BalanceFrame]) -> Vector3<f64> {
    match (total.first(), total.last()) {
        (Some(first), Some(last)) if last.time > first.time => {
            (last.com - first.com) / (last.time - first.time)
        }
        _ => Vector3::zeros(),
    }
}

/// Stances of a motion whose planted points are known: a foot stands while a point of one of its links is planted.
/// `level` is the height of the ground along up (m); the ground stands still.
pub fn stances_of_planted(soles: &[Sole], planted: &[Interval], level: f64) -> Stances {
    let mut list: Vec<Stance> = Vec::new();
    for (foot, sole) in soles.iter().enumerate() {
        let own =
            planted.iter().filter(|interval| interval.link == sole.foot || Some(interval.link) == sole.toes);
        let mut own: Vec<_> =
            own.map(|interval| Stance { foot, start: interval.start, end: interval.end }).collect();
        own.sort_by(|a, b| a.start.total_cmp(&b.start));
        for stance in own {
            match list.last_mut() {
                Some(last) if last.foot == foot && stance.start <= last.end => {
                    last.end = last.end.max(stance.end);
                }
                _ => list.push(stance),
            }
        }
    }
    Stances { list, belt: Vector3::zeros(), level, footings: Vec::new(), method: "planted points" }
}

/// Stances of a motion whose contacts are known: a foot stands while the ground presses on it with more than `least` (N).
/// An edge lies between two frames, where a straight line through the force passes `least`. `contacts` are by sole, each
/// with a sample a time (s); `up` is the direction against gravity, `belt` the velocity of the ground (m/s), `level` its
/// height along up (m).
pub fn stances_of_contacts(
    time: &[f64],
    contacts: &[ContactTrack],
    up: &Vector3<f64>,
    least: f64,
    (belt, level): (Vector3<f64>, f64),
) -> Stances {
    let mut list = Vec::new();
    for (foot, track) in contacts.iter().enumerate() {
        let decides: Vec<f64> = track.samples.iter().map(|contact| least - contact.force.dot(up)).collect();
        let spans = standing(time, &decides, 0.0);
        list.extend(spans.into_iter().map(|(start, end)| Stance { foot, start, end }));
    }
    Stances { list, belt, level, footings: Vec::new(), method: "the forces on them" }
}

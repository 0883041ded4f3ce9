//! Stances: when which foot stands.

mod edges;
mod track;

use crate::ground::{GroundError, GroundOption, PlacedFeet, Sole};
use edges::standing;
use nalgebra::Vector3;
use solaris_model::{ContactTrack, Interval};
use track::Tracks;

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
    /// which it is down. Less than [`Belt::LEAST`] is none.
    #[default]
    Auto,
}

impl Belt {
    /// The slowest belt (m/s) that [`Belt::Auto`] tells from a ground that stands still.
    pub const LEAST: f64 = 0.1;
}

/// What counts as standing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StanceOptions {
    /// How far (m) above its own lowest height a point of the sole may be and still be down.
    pub height: f64,
    /// How fast (m/s) it may be against the ground and still be down.
    pub speed: f64,
    /// Stances, and gaps between two of one foot, that are shorter than this (s) are none.
    pub shortest: f64,
    /// The ground's own motion.
    pub belt: Belt,
}

impl Default for StanceOptions {
    /// 2 cm, 0.5 m/s, 0.1 s; the ground's motion as the feet tell it.
    fn default() -> Self {
        Self { height: 0.02, speed: 0.5, shortest: 0.1, belt: Belt::Auto }
    }
}

impl StanceOptions {
    fn check(&self) -> Result<(), GroundError> {
        let positive = |value: f64| value.is_finite() && value > 0.0;
        let (some, more) = ("finite and more than zero", "finite and not less than zero");
        let mut numbers = vec![
            (GroundOption::Height, self.height, positive(self.height), some),
            (GroundOption::Speed, self.speed, positive(self.speed), some),
            (GroundOption::Shortest, self.shortest, self.shortest.is_finite() && self.shortest >= 0.0, more),
        ];
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

/// Finds when which foot stands, on level ground, from how heel, ball and tip of each sole move.
///
/// A point of a sole is down while it is less than `height` above its own lowest height (the lowest but a twentieth of
/// the frames, since it is seldom known how high above the ground a point really is), and slower than `speed` against
/// the ground. A foot stands while one of its points is down; a foot that never comes within 5 cm of the lowest one
/// never stands. An edge lies between two frames, where a straight line through what decides becomes zero. Gaps shorter
/// than `shortest` are closed, then stances shorter than that are dropped, but for those that the ends of the motion
/// cut off.
///
/// `level` is the median of the lowest heights of the points of all feet that may stand.
///
/// # Errors
///
/// Options out of their range.
#[doc(alias = "gait events")]
#[doc(alias = "foot contact")]
pub fn find_stances(feet: &PlacedFeet<'_>, options: &StanceOptions) -> Result<Stances, GroundError> {
    options.check()?;
    let tracks = Tracks::of(feet);
    let belt = match options.belt {
        Belt::Still => Vector3::zeros(),
        Belt::Speed(velocity) => velocity,
        Belt::Auto => tracks.belt(options.height),
    };
    let mut list = Vec::new();
    for foot in 0..feet.soles().len() {
        let height = tracks.decisive(foot, &belt, options);
        let spans = standing(feet.prepared().time(), &height, options.shortest);
        list.extend(spans.into_iter().map(|(start, end)| Stance { foot, start, end }));
    }
    Ok(Stances { list, belt, level: tracks.level(), method: "heights and speeds of heel, ball and tip" })
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
    Stances { list, belt: Vector3::zeros(), level, method: "planted points" }
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
    Stances { list, belt, level, method: "the forces on them" }
}

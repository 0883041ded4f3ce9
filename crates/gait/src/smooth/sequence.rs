//! A sequence of walks and standing still, one after the other.

use crate::body::Body;
use crate::body::missing;
use crate::error::{GaitError, RequestError};
use crate::request::WalkRequest;
use crate::smooth::walk::WalkPlan;
use crate::smooth::walker::walk_from;
use crate::walking::{Walking, sampled};
use nalgebra::Vector3;
use solaris_analysis::{ReactionError, Support, SupportLaw};
use solaris_model::{Contact, Event, Figure, Interval, Motion, Trajectory};

/// The longest that one may stand between walks (s).
pub const LONGEST_STAND: f64 = 3600.0;

/// One after the other in a [`WalkSequence`].
#[derive(Clone, Debug, PartialEq)]
#[doc(alias = "Stage")]
#[expect(clippy::large_enum_variant, reason = "of segments there are few, and nearly all are walks")]
pub enum WalkSegment {
    /// A walk from standing to standing.
    Walk(WalkRequest),
    /// So long (s) standing still, besides the moment for which every walk stands before and after.
    Stand(f64),
}

impl WalkSegment {
    /// See [`WalkRequest::helped_foot_first`].
    #[must_use]
    pub fn helped_foot_first(self, figure: &Figure) -> Self {
        match self {
            Self::Walk(request) => Self::Walk(request.helped_foot_first(figure)),
            Self::Stand(time) => Self::Stand(time),
        }
    }
}

/// Walks and standing still, one after the other: each walk begins where and as the one before has ended.
///
/// ```
/// use solaris_gait::{Extent, WalkSequence, WalkSegment, WalkRequest};
/// use solaris_model::Trajectory;
///
/// let ann = solaris_model::human(1.65, 58.0)?;
/// let walk = WalkRequest { extent: Extent::Distance(2.0), ..WalkRequest::default() };
/// let back = WalkRequest { step_frequency: Some(90.0), turn: -0.3, extent: Extent::Steps(4), ..WalkRequest::default() };
/// let sequence = WalkSequence::new(&ann, &[WalkSegment::Walk(walk), WalkSegment::Stand(1.5), WalkSegment::Walk(back)])?;
/// assert_eq!(sequence.walks().count(), 2);
/// assert!((sequence.destination().1 + 1.2).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "Journey")]
pub struct WalkSequence {
    fingerprint: u64,
    /// When each walk begins (s).
    walks: Vec<(f64, WalkPlan)>,
    duration: f64,
}

impl WalkSequence {
    /// Plans every walk.
    ///
    /// # Errors
    ///
    /// Those of [`crate::walk()`] with the number of the segment, a stand that is no time, and segments without a walk.
    pub fn new(figure: &Figure, segments: &[WalkSegment]) -> Result<Self, GaitError> {
        missing::check_for_walk(figure)?;
        let body = Body::of(figure)?;
        Self::with(&body, segments, |before, request| walk_from(figure, &body, before, request))
    }

    /// With every walk as it is planned, after the one before.
    pub(crate) fn with(
        body: &Body,
        segments: &[WalkSegment],
        planned: impl Fn(Option<&WalkPlan>, &WalkRequest) -> Result<WalkPlan, GaitError>,
    ) -> Result<Self, GaitError> {
        let (mut walks, mut duration) = (Vec::<(f64, WalkPlan)>::new(), 0.0);
        for (index, segment) in segments.iter().enumerate() {
            let of = |why| GaitError::InSegment { number: index + 1, why: Box::new(why) };
            match segment {
                WalkSegment::Stand(time) if (0.0..=LONGEST_STAND).contains(time) => duration += time,
                WalkSegment::Stand(time) => {
                    let (lower, upper) = (0.0, LONGEST_STAND);
                    let (parameter, unit, why) = ("stand", " s", String::new());
                    return Err(of(
                        RequestError::Range { parameter, value: *time, unit, lower, upper, why }.into()
                    ));
                }
                WalkSegment::Walk(request) => {
                    let before = walks.last().map(|(_, walk)| walk);
                    let mut plan = planned(before, request).map_err(of)?;
                    if let Some(before) = before {
                        let (place, heading) = before.destination();
                        plan = plan.moved(place, heading).map_err(|why| of(why.into()))?;
                    }
                    let lasts = plan.duration();
                    walks.push((duration, plan));
                    duration += lasts;
                }
            }
        }
        if walks.is_empty() {
            return Err(RequestError::NoWalk.into());
        }
        Ok(Self { fingerprint: body.fingerprint, walks, duration })
    }

    /// The walks in their order.
    pub fn walks(&self) -> impl Iterator<Item = &WalkPlan> {
        self.walks.iter().map(|(_, walk)| walk)
    }

    /// The first walk.
    pub fn first(&self) -> &WalkPlan {
        &self.walks[0].1
    }

    /// Where the last walk ends and which way it points there, to the left of z (m, rad).
    pub fn destination(&self) -> (Vector3<f64>, f64) {
        self.walks[self.walks.len() - 1].1.destination()
    }

    /// All of it sampled `rate` times a second, with its events and planted points.
    ///
    /// # Errors
    ///
    /// A rate that is none, and another figure than the sequence's.
    pub fn motion(&self, figure: &Figure, rate: f64) -> Result<Motion, ReactionError> {
        let mut motion = sampled(figure, self, self.fingerprint, rate)?;
        // Ground that is not level has one walk alone.
        motion.relief = self.first().relief().cloned();
        Ok(motion)
    }

    /// The walk that belongs to a time, and its own time: that of its rest before and after it.
    fn at(&self, t: f64) -> (&WalkPlan, f64) {
        let index = self.walks.partition_point(|(start, _)| *start <= t).saturating_sub(1);
        let (start, walk) = &self.walks[index];
        (walk, (t - start).clamp(0.0, walk.duration()))
    }
}

impl Trajectory for WalkSequence {
    fn duration(&self) -> f64 {
        self.duration
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        let (walk, time) = self.at(t);
        walk.configuration(time, q);
    }

    fn resolution(&self) -> f64 {
        self.walks().map(Trajectory::resolution).fold(f64::INFINITY, f64::min)
    }
}

impl SupportLaw for WalkSequence {
    fn support(&self, t: f64) -> Support {
        let (walk, time) = self.at(t);
        SupportLaw::support(walk, time)
    }

    fn beside(&self, t: f64) -> Option<(&str, Contact)> {
        let (walk, time) = self.at(t);
        walk.beside(time)
    }
}

impl Walking for WalkSequence {
    fn events(&self) -> Vec<Event> {
        let later = |(start, walk): &(f64, WalkPlan)| {
            let start = *start;
            walk.events().into_iter().map(move |event| Event { time: start + event.time, ..event })
        };
        self.walks.iter().flat_map(later).collect()
    }

    fn planted(&self, figure: &Figure) -> Vec<Interval> {
        let mut all = Vec::new();
        for (index, (start, walk)) in self.walks.iter().enumerate() {
            // What stands before and after a walk stands while nobody walks.
            let begin = if index == 0 { 0.0 } else { *start };
            let end = self.walks.get(index + 1).map_or(self.duration, |(next, _)| *next);
            for mut planted in walk.planted(figure) {
                let lasts = planted.end >= walk.duration();
                planted.start = if planted.start > 0.0 { start + planted.start } else { begin };
                planted.end = if lasts { end } else { start + planted.end };
                all.push(planted);
            }
        }
        all
    }
}

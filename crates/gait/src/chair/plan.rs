//! A planned rise, or sitting down.

use super::fit::Fit;
use super::forces::{Shared, totals};
use super::laws::Laws;
use super::sitter::Sitter;
use crate::body::roles::SEATED;
use crate::body::{Body, FEET, missing};
use crate::error::{GaitError, PlanError};
use crate::measure::{ChairMeasures, measure_chair};
use crate::request::{ChairMotion, ChairRequest};
use crate::walking::Stood;
use solaris_analysis::{ReactionReport, ground_reactions};
use solaris_dynamics::Tree;
use solaris_model::{ContactTrack, Event, EventKind, Figure, Motion, MotionInfo, Relief, Trajectory};

const DEGREE: f64 = std::f64::consts::PI / 180.0;

/// How long sitting and standing last before and after (s, at a height of 1.75 m).
const STILL: f64 = 0.4;
/// The part of the weight with which the seat is touched: it bears less before it is left, and more once it is met.
const TOUCHED: f64 = 0.02;
/// Samples a second at which a plan is looked at.
const LOOKED_AT: f64 = 60.0;

/// By how much slower rises are tried where one does not hold, and how often.
const SLOWER: (f64, i32) = (1.06, 12);

/// What must hold of a plan: by how much a joint may be beyond its range (rad), pressure beside a sole (m), friction at a foot or the seat, and by how much
/// the pelvis has risen when the seat is left (m, at a height of 1.75 m).
const BEYOND: f64 = 0.5 * DEGREE;
const BESIDE: f64 = 0.005;
const FRICTION: f64 = 0.5;
const LIFTED: f64 = 0.06;

/// Somebody who stands up from a seat, or sits down on it. The feet stand with their heels at z = 0, the seat is behind them.
#[derive(Clone, Debug)]
#[doc(alias = "sit-to-stand")]
#[doc(alias = "stand-to-sit")]
pub struct ChairPlan {
    sitter: Sitter,
    laws: Laws,
    motion: ChairMotion,
    /// Of one way, up or down, and of sitting or standing before and after it (s).
    one_way: f64,
    still: f64,
}

/// Plans how somebody stands up from a seat, or sits down on it.
///
/// # Errors
///
/// A figure that lacks what a walk needs, numbers out of range, and a seat from which the laws do not hold.
pub fn chair(figure: &Figure, request: &ChairRequest) -> Result<ChairPlan, GaitError> {
    missing::check(figure)?;
    let body = Body::of(figure)?;
    request.check()?;
    let (seat, one_way) = (request.seat_of(body.height)?, request.duration_of(body.height)?);
    let usual = ChairRequest::usual_duration(body.height);
    let sitter = Sitter::new(figure, body, seat)?;
    let tree = Tree::new(figure, MotionInfo::on_earth(figure, LOOKED_AT).gravity)?;
    let still = STILL * (sitter.body.height / 1.75).sqrt();
    let planned = |one_way: f64| -> Result<ChairPlan, GaitError> {
        let mut laws = Laws::new(sitter.seated(request.shank), sitter.standing);
        // A quick rise is found from a usual one.
        for duration in [Some(usual).filter(|usual| one_way < *usual), Some(one_way)].into_iter().flatten() {
            laws = Fit { figure, tree: &tree, sitter: &sitter, duration }.fitted(laws)?;
        }
        Ok(ChairPlan { sitter: sitter.clone(), laws, motion: ChairMotion::Rise, one_way, still })
    };
    let plan = planned(one_way)?;
    let Some(what) = plan.fault(figure)? else { return Ok(ChairPlan { motion: request.motion, ..plan }) };
    let holds =
        |slower: &f64| planned(*slower).and_then(|plan| plan.fault(figure)).is_ok_and(|what| what.is_none());
    let slower = (1..=SLOWER.1).map(|k| (one_way * SLOWER.0.powi(k) * 100.0).ceil() / 100.0);
    let nearest = match slower.filter(|slower| request.takes(*slower, sitter.body.height)).find(holds) {
        Some(slower) => format!("it holds in {slower:.2} s"),
        None => "it needs another seat, or other shanks".to_owned(),
    };
    let shank = request.shank.to_degrees();
    let what = format!(
        "from a seat of {seat:.3} m in {one_way:.2} s with shanks that lean forward by {shank:.0}°: {what}"
    );
    Err(PlanError::NoRise { what, nearest }.into())
}

impl ChairPlan {
    /// Height of the seat (m).
    pub fn seat(&self) -> f64 {
        self.sitter.seat
    }

    /// How long one way takes, up or down (s), without the moments of rest before and after it.
    pub fn one_way(&self) -> f64 {
        self.one_way
    }

    /// The standing height that the laws scale with (m): the figure's own, or what its legs suggest.
    pub fn stature(&self) -> f64 {
        self.sitter.body.height
    }

    /// Forward lean of the trunk at a time, more than in standing (rad).
    pub fn lean(&self, t: f64) -> f64 {
        self.laws.at(self.part(t)).lean
    }

    /// How far it has come from sitting, 0, to standing, 1, as a part of a rise's time.
    fn part(&self, t: f64) -> f64 {
        let t = t.clamp(0.0, self.duration());
        let once = self.one_way + self.still;
        let way = match self.motion {
            ChairMotion::Rise | ChairMotion::Sit => 0,
            ChairMotion::RiseAndSit(_) => (t / once) as usize,
        };
        let part = ((t - way as f64 * once - self.still) / self.one_way).clamp(0.0, 1.0);
        if self.motion == ChairMotion::Sit || way % 2 == 1 { 1.0 - part } else { part }
    }

    /// All of it sampled `rate` times a second, with the forces of the ground, of the seat on the pelvis, and of the joints. Events say when the seat is left and
    /// met, and the ground has the seat as a bench.
    ///
    /// # Errors
    ///
    /// A rate that is none, another figure than the plan's, and what the kernel refuses.
    pub fn loaded(&self, figure: &Figure, rate: f64) -> Result<(Motion, ReactionReport), GaitError> {
        let info =
            MotionInfo { fingerprint: self.sitter.body.fingerprint, ..MotionInfo::on_earth(figure, rate) };
        let mut motion = Motion::sample(figure, self, info)?;
        let totals = totals(&Tree::new(figure, motion.info.gravity)?, &motion)?;
        let part = |i: usize| self.part(motion.time()[i]);
        let shared = Shared::new(&self.sitter, &self.laws.seated, &totals, rate, part);
        motion.contacts = vec![ContactTrack { link: SEATED.to_owned(), samples: shared.seat.clone() }];
        motion.events = self.events(&motion);
        let last = motion.time()[motion.len() - 1];
        // Flat throughout.
        let stood =
            Stood { landed: 0.0, flat: 0.0, on_ball: false, heel_off: last, tip_roll: last, toe_off: last };
        motion.planted = [0, 1].into_iter().flat_map(|side| stood.planted(figure, side)).collect();
        motion.relief = Some(self.bench());
        let report = ground_reactions(figure, &mut motion, FEET, &shared)?;
        Ok((motion, report))
    }

    /// When the seat is left and met: between the frames between which it bears as much as a touch.
    fn events(&self, motion: &Motion) -> Vec<Event> {
        let touched = TOUCHED * self.sitter.body.mass * motion.info.gravity.norm();
        let bears: Vec<f64> = motion.contacts[0].samples.iter().map(|seat| seat.force.y - touched).collect();
        let crossing = |(pair, time): (&[f64], &[f64])| {
            let is_left = pair[0] > 0.0;
            (is_left != (pair[1] > 0.0)).then(|| {
                let link = SEATED.to_owned();
                Event {
                    time: time[0] + (time[1] - time[0]) * pair[0] / (pair[0] - pair[1]),
                    kind: if is_left { EventKind::LiftOff { link } } else { EventKind::TouchDown { link } },
                }
            })
        };
        bears.windows(2).zip(motion.time().windows(2)).filter_map(crossing).collect()
    }

    /// The ground, with the seat as a bench on it.
    fn bench(&self) -> Relief {
        let ([back, front], seat) = (self.sitter.edges(&self.laws.seated), self.sitter.seat);
        Relief::new(vec![[back, 0.0], [back, seat], [front, seat], [front, 0.0]])
            .expect("points in their order")
    }

    /// What would not hold.
    fn fault(&self, figure: &Figure) -> Result<Option<String>, GaitError> {
        let (motion, _) = self.loaded(figure, LOOKED_AT)?;
        let ChairMeasures { extremes, contact_friction: friction, lifted, .. } =
            measure_chair(figure, &motion)?;
        Ok(if let Some(beyond) = extremes.beyond_range.filter(|beyond| beyond.by > BEYOND) {
            Some(format!("{} would go {:.1}° beyond its range", beyond.joint, beyond.by.to_degrees()))
        } else if extremes.least_knee.value < 0.0 {
            Some(format!("a knee would be hyperextended by {:.1}°", -extremes.least_knee.value.to_degrees()))
        } else if extremes.cop_outside.value > BESIDE {
            Some(format!(
                "a foot would be pressed {:.0} mm beside its sole",
                1e3 * extremes.cop_outside.value
            ))
        } else if friction.value > FRICTION {
            Some(format!("friction would have to be {:.2}", friction.value))
        } else if lifted > self.sitter.scaled(LIFTED) {
            Some(format!("the pelvis would have risen by {:.0} mm before the seat is free", 1e3 * lifted))
        } else {
            None
        })
    }
}

impl Trajectory for ChairPlan {
    fn duration(&self) -> f64 {
        let ways = match self.motion {
            ChairMotion::Rise | ChairMotion::Sit => 1,
            ChairMotion::RiseAndSit(times) => 2 * times,
        };
        self.still + (self.one_way + self.still) * ways as f64
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        self.sitter.write(&self.laws.at(self.part(t)), q);
    }
}

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

/// What must hold of a plan: by how much a joint may be beyond its range (rad), pressure beside a sole (m), friction at a foot or the seat, and how high the
/// hips are when the seat is left (m at a height of 1.75 m).
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
    /// Of one rise, and of sitting or standing before and after it (s).
    rise: f64,
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
    let (seat, rise) = (request.seat_of(body.height)?, request.duration_of(body.height)?);
    let sitter = Sitter::new(figure, body, seat)?;
    let tree = Tree::new(figure, MotionInfo::on_earth(figure, LOOKED_AT).gravity)?;
    let still = STILL * (sitter.body.height / 1.75).sqrt();
    let mut laws = Laws::new(sitter.seated(request.shank), sitter.standing);
    // A quick rise is found from a usual one.
    let usual = ChairRequest::usual_duration(sitter.body.height);
    for duration in [Some(usual).filter(|usual| rise < *usual), Some(rise)].into_iter().flatten() {
        laws = Fit { figure, tree: &tree, sitter: &sitter, duration }.fitted(laws)?;
    }
    let plan = ChairPlan { sitter, laws, motion: ChairMotion::Rise, rise, still };
    plan.check(figure, request.shank)?;
    Ok(ChairPlan { motion: request.motion, ..plan })
}

impl ChairPlan {
    /// Height of the seat (m).
    pub fn seat(&self) -> f64 {
        self.sitter.seat
    }

    /// How long it takes to stand up, or to sit down (s), without the moments of rest.
    pub fn rise(&self) -> f64 {
        self.rise
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
        let once = self.rise + self.still;
        let way = match self.motion {
            ChairMotion::Rise | ChairMotion::Sit => 0,
            ChairMotion::RiseAndSit(_) => (t / once) as usize,
        };
        let part = ((t - way as f64 * once - self.still) / self.rise).clamp(0.0, 1.0);
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
        // Flat from before the begin till after the end.
        let [landed, left] = [-1.0, last + 1.0];
        let stood =
            Stood { landed, flat: landed, on_ball: false, heel_off: left, tip_roll: left, toe_off: left };
        motion.planted = [0, 1].into_iter().flat_map(|side| stood.planted(figure, side)).collect();
        for planted in &mut motion.planted {
            (planted.start, planted.end) = (0.0, last);
        }
        motion.relief = Some(self.bench());
        let report = ground_reactions(figure, &mut motion, FEET, &shared)?;
        Ok((motion, report))
    }

    /// When the seat is left and met, from what it bears.
    fn events(&self, motion: &Motion) -> Vec<Event> {
        let touched = TOUCHED * self.sitter.body.mass * motion.info.gravity.norm();
        let bears: Vec<bool> = motion.contacts[0].samples.iter().map(|seat| seat.force.y > touched).collect();
        let changes = bears.windows(2).zip(&motion.time()[1..]).filter(|(pair, _)| pair[0] != pair[1]);
        let link = || SEATED.to_owned();
        changes
            .map(|(pair, &time)| Event {
                time,
                kind: if pair[0] {
                    EventKind::LiftOff { link: link() }
                } else {
                    EventKind::TouchDown { link: link() }
                },
            })
            .collect()
    }

    /// The ground, with the seat as a bench on it.
    fn bench(&self) -> Relief {
        let ([back, front], seat) = (self.sitter.edges(&self.laws.seated), self.sitter.seat);
        Relief::new(vec![[back, 0.0], [back, seat], [front, seat], [front, 0.0]])
            .expect("points in their order")
    }

    /// Refuses what would not hold.
    fn check(&self, figure: &Figure, shank: f64) -> Result<(), GaitError> {
        let (motion, _) = self.loaded(figure, LOOKED_AT)?;
        let ChairMeasures { extremes, friction, lifted, .. } = measure_chair(figure, &motion)?;
        let most = self.sitter.scaled(LIFTED);
        let what = if let Some(beyond) = extremes.beyond_range.filter(|beyond| beyond.by > BEYOND) {
            format!("{} would go {:.1}° beyond its range", beyond.joint, beyond.by.to_degrees())
        } else if extremes.cop_outside.value > BESIDE {
            format!("a foot would be pressed {:.0} mm beside its sole", 1e3 * extremes.cop_outside.value)
        } else if friction.value > FRICTION {
            format!("friction would have to be {:.2}", friction.value)
        } else if lifted > most {
            format!("the hips would be {:.0} mm over the seat before the feet bear", 1e3 * lifted)
        } else {
            return Ok(());
        };
        let (seat, duration, shank) = (self.seat(), self.rise, shank.to_degrees());
        Err(PlanError::NoRise { seat, duration, shank, what }.into())
    }
}

impl Trajectory for ChairPlan {
    fn duration(&self) -> f64 {
        let ways = match self.motion {
            ChairMotion::Rise | ChairMotion::Sit => 1,
            ChairMotion::RiseAndSit(times) => 2 * times,
        };
        self.still + (self.rise + self.still) * ways as f64
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        self.sitter.write(&self.laws.at(self.part(t)), q);
    }
}

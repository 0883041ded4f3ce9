//! Whether plates belong to the feet of a motion.

mod fit;
mod guess;

pub use guess::soles_of_plates;

use super::MotionFinding;
use crate::ground::{FootReport, GroundError, PlacedFeet, Stance, Stances, balance};
use crate::loads::known_at;
use crate::prepared::PreparedMotion;
use fit::Placed;
use nalgebra::Vector3;
use solaris_dynamics::Wrench;
use solaris_model::{Contact, MeasuredForce};

/// How far what the plates bear on average may be from what figure and motion need, as a share of it. Shoes and clothes are some
/// 2 % of a person, plates are right to 1 %, and filtered accelerations average out to less.
pub const BORNE: f64 = 0.06;

/// How far (rad) the plates' mean force may point from up: over some steps its horizontal parts are a few per cent.
pub const OBLIQUE: f64 = 0.35;

/// How far (m) from its sole a centre of pressure may be. Errors of a calibrated laboratory are some mm to 2 cm, and 1 cm changes
/// joint moments by some 10 % already (`McCaw` and `DeVita` 1995, J. Biomech. 28:985–988).
pub const FAR: f64 = 0.1;

/// Share of a foot's loaded frames that may be farther than [`FAR`]: touch-down and lift-off, when little force acts.
pub const FAR_SHARE: f64 = 0.1;

/// How far (m) beside or above its force a foot must be to swing: one that strikes or leaves fast, or turns on its toes, is found
/// standing too late or lost too soon, but is at its force all the time.
pub const AWAY: f64 = 0.05;

/// Share of its impulse that a force may bear while its foot swings so. Of 21 measured runs and walks it is 0.01 at most, of 14 jumps,
/// squats and chairs 0.12, but for two jumps whose pressure is 10 cm beside the feet (0.3); of the runs and walks with their plates
/// exchanged 0.45 at least.
pub const AIRBORNE: f64 = 0.15;

/// Mean share of the weight that may be missing while a foot stands without a plate: a foot that only scuffs bears less.
pub const MISSING: f64 = 0.2;

/// A stance that an end of the motion cuts off and that is seen for less than this (s) says nothing of plates: accelerations are least
/// known there.
const CUT: f64 = 0.1;

/// Forces fit under each other's feet if that brings them at least so much nearer, as a share of their distance.
pub const SWAPPED: f64 = 0.5;

/// How the plates fit the motion, and what does not fit.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlateReport {
    /// What the plates bear over what figure and motion need, over the frames in which every standing foot is on a plate; `None`
    /// where there are too few of them.
    pub borne: Option<f64>,
    /// The number of those frames.
    pub complete: usize,
    /// Height of the ground along up (m): where the feet stand, or zero where no feet are known.
    pub level: f64,
    /// By force, in the order given.
    pub plates: Vec<PlateFit>,
    /// What does not fit.
    pub findings: Vec<MotionFinding>,
}

/// How one force fits the foot that it is given to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PlateFit {
    /// The sole's name, or the link's where it has none.
    pub foot: String,
    /// Frames in which it bears [`FootReport::LOADED`] of the weight.
    pub loaded: usize,
    /// Mean distance of its centre of pressure from the sole (m); `None` where it never bears or no sole is known of the link.
    pub mean_distance: Option<f64>,
    /// Greatest distance (m), and when (s).
    pub greatest_distance: Option<(f64, f64)>,
}

/// Holds measured forces against the motion that they are given to: their mean against the mass, their centres of pressure and
/// their times against the feet.
///
/// Forces act on links; those of several plates on one foot are taken together where a foot is concerned. Without `feet` (soles that
/// are placed, and when they stand) only the mean force is judged, and so are forces on links that have no sole.
///
/// # Errors
///
/// No gravity, no mass, and the first state that the kernel refuses.
#[doc(alias = "force plates")]
#[doc(alias = "grf")]
pub fn check_plates(
    prepared: &PreparedMotion<'_>,
    feet: Option<(&PlacedFeet<'_>, &Stances)>,
    measured: &[MeasuredForce],
) -> Result<PlateReport, GroundError> {
    let scene = Scene::of(prepared, feet, measured)?;
    let mut report = PlateReport { level: scene.level, ..PlateReport::default() };
    report.findings.extend(scene.direction());
    scene.weigh(&mut report);
    if let Some((feet, stances)) = feet {
        let placed: Vec<Placed> = (0..measured.len()).map(|i| Placed::of(&scene, feet, stances, i)).collect();
        report.plates = placed.iter().map(|placed| placed.fit(&scene, feet)).collect();
        for i in 0..placed.len() {
            report.findings.extend(fit::findings(&scene, feet, &placed, i));
        }
        report.findings.extend(scene.without_plate(feet, stances));
    }
    Ok(report)
}

/// What all checks ask.
struct Scene<'a> {
    prepared: &'a PreparedMotion<'a>,
    measured: &'a [MeasuredForce],
    /// By force, the sole that it acts on.
    soles: Vec<Option<usize>>,
    /// By force, by frame: where it is known.
    contacts: Vec<Vec<Option<Contact>>>,
    /// By frame, the vertical force that figure and motion need (N).
    needed: Vec<f64>,
    level: f64,
    /// By frame, by sole: whether it stands.
    stands: Vec<Vec<bool>>,
}

impl<'a> Scene<'a> {
    fn of(
        prepared: &'a PreparedMotion<'a>,
        feet: Option<(&PlacedFeet<'_>, &Stances)>,
        measured: &'a [MeasuredForce],
    ) -> Result<Self, GroundError> {
        let level = feet.map_or(0.0, |(_, stances)| stances.level);
        let total = balance(prepared, level)?;
        let sole_of = |record: &MeasuredForce| {
            let link = prepared.figure.link_index(record.links.first()?)?;
            let mut soles = feet?.0.soles().iter();
            soles.position(|sole| sole.foot == link || sole.toes == Some(link))
        };
        let time = prepared.time();
        let stands = |t: &f64| {
            let soles = feet.map_or(0, |(feet, _)| feet.soles().len());
            (0..soles).map(|sole| feet.is_some_and(|(_, stances)| stances.stands(sole, *t))).collect()
        };
        Ok(Self {
            soles: measured.iter().map(sole_of).collect(),
            contacts: measured
                .iter()
                .map(|record| time.iter().map(|t| known_at(record, *t)).collect())
                .collect(),
            needed: total.iter().map(|frame| frame.force.dot(&prepared.up)).collect(),
            stands: time.iter().map(stands).collect(),
            prepared,
            measured,
            level,
        })
    }

    /// What a force must bear to be judged (N).
    fn loaded(&self) -> f64 {
        FootReport::LOADED * self.prepared.weight
    }

    fn frames(&self) -> std::ops::Range<usize> {
        0..self.prepared.motion.len()
    }

    /// The vertical part of a force (N) in a frame; `None` where it is not known.
    fn normal(&self, force: usize, row: usize) -> Option<f64> {
        self.contacts[force][row].map(|contact| contact.force.dot(&self.prepared.up))
    }

    /// Where a force presses on the ground.
    fn pressure(&self, force: usize, row: usize) -> Option<Vector3<f64>> {
        let Contact { force, moment, .. } = self.contacts[force][row]?;
        Wrench { force, moment }.center_of_pressure(&self.prepared.up, self.level)
    }

    /// The vertical force of all plates (N) in a frame, where all are known.
    fn sum(&self, row: usize) -> Option<f64> {
        (0..self.measured.len()).map(|force| self.normal(force, row)).sum()
    }

    /// What all plates on a sole bear (N) in a frame.
    fn on_sole(&self, sole: usize, row: usize) -> f64 {
        let own = (0..self.measured.len()).filter(|force| self.soles[*force] == Some(sole));
        own.filter_map(|force| self.normal(force, row)).sum()
    }

    /// Whether the mean force points up.
    fn direction(&self) -> Option<MotionFinding> {
        let contacts = self.contacts.iter().flatten().flatten();
        let mean: Vector3<f64> = contacts.map(|contact| contact.force).sum();
        let along = mean.try_normalize(self.loaded())?;
        let angle = along.angle(&self.prepared.up);
        (angle > OBLIQUE).then(|| MotionFinding::Direction { angle, along: along.into() })
    }

    /// The mean force against what figure and motion need.
    fn weigh(&self, report: &mut PlateReport) {
        let complete = |row: &usize| {
            let Some(sum) = self.sum(*row) else { return false };
            let standing = self.stands[*row].iter().enumerate().filter(|(_, stands)| **stands);
            sum > self.loaded()
                && standing.into_iter().all(|(sole, _)| self.on_sole(sole, *row) > self.loaded())
        };
        // Without soles nobody knows who stands: all frames in which anything bears.
        let rows: Vec<usize> = self.frames().filter(complete).collect();
        report.complete = rows.len();
        let needed: f64 = rows.iter().map(|row| self.needed[*row]).sum();
        let borne: f64 = rows.iter().filter_map(|row| self.sum(*row)).sum();
        // A tenth of the motion says little; so does a fall.
        if rows.len() * 10 < self.prepared.motion.len() || needed <= 0.0 {
            self.weigh_all(report);
            return;
        }
        self.judge(borne / needed, report);
    }

    /// Where no frame is complete: plates that are far too weak for the figure bear nothing that counts.
    fn weigh_all(&self, report: &mut PlateReport) {
        let rows: Vec<usize> = self.frames().filter(|row| self.sum(*row).is_some()).collect();
        let greatest = rows.iter().filter_map(|row| self.sum(*row)).fold(0.0, f64::max);
        if !rows.is_empty() && greatest > 0.0 && greatest < 0.5 * self.prepared.weight {
            self.judge(greatest / self.prepared.weight, report);
            report.complete = 0;
        }
    }

    fn judge(&self, borne: f64, report: &mut PlateReport) {
        report.borne = Some(borne);
        if (borne - 1.0).abs() > BORNE {
            report.findings.push(MotionFinding::Mass { borne, mass: self.prepared.tree.mass() });
        }
    }

    /// Feet that stand with nothing under them while weight is missing.
    fn without_plate(&self, feet: &PlacedFeet<'_>, stances: &Stances) -> Vec<MotionFinding> {
        let time = self.prepared.time();
        let missing = |sole: usize, span: (f64, f64)| {
            let within = |row: &usize| (span.0..=span.1).contains(&time[*row]);
            let rows: Vec<usize> =
                self.frames().filter(within).filter(|row| self.sum(*row).is_some()).collect();
            let mean = |of: &dyn Fn(usize) -> f64| {
                rows.iter().map(|row| of(*row)).sum::<f64>() / rows.len().max(1) as f64
            };
            let own = mean(&|row| self.on_sole(sole, row));
            let rest =
                mean(&|row| self.needed[row] - self.sum(row).unwrap_or_default()) / self.prepared.weight;
            (own < self.loaded() && rest > MISSING).then_some(rest)
        };
        let ends = time.first().zip(time.last());
        let is_scrap = |stance: &Stance| {
            let is_cut = ends.is_some_and(|(first, last)| stance.start <= *first || stance.end >= *last);
            is_cut && stance.end - stance.start < CUT
        };
        let mut found = Vec::new();
        for (sole, of) in feet.soles().iter().enumerate() {
            let own = stances.list.iter().filter(|stance| stance.foot == sole && !is_scrap(stance));
            let spans: Vec<((f64, f64), f64)> = own
                .map(|stance| (stance.start, stance.end))
                .filter_map(|span| Some((span, missing(sole, span)?)))
                .collect();
            if let Some((span, _)) = spans.first() {
                found.push(MotionFinding::NoPlate {
                    foot: of.name.clone(),
                    span: *span,
                    times: spans.len(),
                    missing: spans.iter().map(|(_, missing)| missing).sum::<f64>() / spans.len() as f64,
                    has_plate: self.soles.contains(&Some(sole)),
                });
            }
        }
        found
    }
}

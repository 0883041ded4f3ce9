//! The report on the ground's forces, as numbers.

use super::against::Beside;
use super::moved::Moved;
use super::predicted::Predicted;
use super::soles::From;
use crate::given::{Given, GivenReport};
use crate::plausible::Plausibility;
use crate::words::short;
use serde::Serialize;
use solaris::analysis::ground::{FootReport, Split, Worst};

/// The ground and what it does to the feet.
#[derive(Serialize)]
pub(crate) struct GroundReport {
    pub(super) soles_from: String,
    pub(super) level_m: f64,
    pub(super) belt_m_s: [f64; 3],
    pub(super) belt_from: &'static str,
    pub(super) stances_from: &'static str,
    pub(super) split: &'static str,
    #[serde(skip)]
    pub(super) assumption: &'static str,
    /// What was changed of the motion; absent where that was not asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) consistent: Option<Moved>,
    pub(super) weight_n: f64,
    pub(super) feet: Vec<Foot>,
    /// Frames in which several feet stand, but not between two single supports.
    pub(super) irregular_frames: usize,
    pub(super) unsupported: Unsupported,
    /// The forces of the feet that have a plate, together, beside these.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) beside_plates: Option<Beside>,
    /// Whether those forces fit the motion.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) plausibility: Option<Plausibility>,
    /// What a person should look at.
    pub(super) warnings: Vec<String>,
}

/// One foot.
#[derive(Serialize)]
pub(super) struct Foot {
    pub(super) name: String,
    pub(super) link: String,
    pub(super) toes: Option<String>,
    pub(super) width_m: Option<f64>,
    pub(super) stances_s: Vec<[f64; 2]>,
    pub(super) frames: usize,
    pub(super) greatest_n: f64,
    pub(super) greatest_of_weight: f64,
    /// Absent where it never stands; `share` of frames in which the ground would pull.
    pub(super) least_n: Option<Extreme>,
    /// Absent where it never bears enough; `share` of frames above 0.6.
    pub(super) friction: Option<Extreme>,
    /// Absent where it is not judged; `share` of frames outside.
    pub(super) cop_outside_m: Option<Extreme>,
    /// Where it has a plate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) beside_plate: Option<Beside>,
}

/// The worst of a quantity, and the share of the foot's frames that are at fault.
#[derive(Clone, Copy, Serialize)]
pub(super) struct Extreme {
    pub(super) worst: f64,
    pub(super) at_s: f64,
    pub(super) share: f64,
}

impl std::convert::From<Worst> for Extreme {
    fn from(worst: Worst) -> Self {
        Self { worst: worst.value, at_s: worst.time, share: worst.share }
    }
}

/// Frames in which no foot stands.
#[derive(Serialize)]
pub(super) struct Unsupported {
    pub(super) frames: usize,
    pub(super) force_rms_n: f64,
    pub(super) force_greatest_n: f64,
    pub(super) at_s: f64,
}

impl GroundReport {
    pub(crate) fn new(ground: Predicted, given: &Given) -> Self {
        let (stances, found) = (&ground.forces.stances, &ground.forces.report);
        let name = |link: usize| given.body.figure.links()[link].name().to_owned();
        let foot = |(i, (sole, foot)): (usize, (&solaris::analysis::ground::Sole, &FootReport))| {
            let own = stances.list.iter().filter(|stance| stance.foot == i);
            Foot {
                name: sole.name.clone(),
                link: name(sole.foot),
                toes: sole.toes.map(name),
                width_m: sole.width,
                stances_s: own.map(|stance| [stance.start, stance.end]).collect(),
                frames: foot.frames,
                greatest_n: foot.greatest,
                greatest_of_weight: foot.greatest / found.weight,
                least_n: foot.least.map(Extreme::from),
                friction: foot.friction.map(Extreme::from),
                cop_outside_m: foot.outside.map(Extreme::from),
                beside_plate: None,
            }
        };
        let mut report = Self {
            soles_from: ground.from.describe(),
            level_m: stances.level,
            belt_m_s: stances.belt.into(),
            belt_from: ground.belt_from,
            stances_from: stances.method,
            split: found.split.name(),
            assumption: match found.split {
                Split::Transition => "smooth curves fitted to people who walk",
                Split::Pivot => "forces point at one point above the centre of mass",
                Split::Effort => "least moments in the joints",
                _ => "",
            },
            consistent: ground.moved,
            weight_n: found.weight,
            feet: ground.soles.iter().zip(&found.feet).enumerate().map(foot).collect(),
            irregular_frames: found.irregular,
            unsupported: Unsupported {
                frames: found.unsupported.frames,
                force_rms_n: found.unsupported.force_rms,
                force_greatest_n: found.unsupported.force,
                at_s: found.unsupported.time,
            },
            beside_plates: None,
            plausibility: None,
            warnings: Vec::new(),
        };
        report.warnings = report.doubts(&ground.from, GivenReport::new(given).root_is_free);
        report
    }

    /// Takes in how far the forces are from those of plates: by foot, and of all feet with a plate together.
    pub(super) fn hold_against(
        &mut self,
        feet: Vec<Option<Beside>>,
        whole: Option<Beside>,
        plausible: Plausibility,
    ) {
        for (foot, beside) in self.feet.iter_mut().zip(feet) {
            foot.beside_plate = beside;
        }
        self.beside_plates = whole;
        self.warnings.extend(plausible.messages().map(str::to_owned));
        self.plausibility = Some(plausible);
    }

    /// What looks wrong, in words.
    fn doubts(&self, soles: &From, root_is_free: bool) -> Vec<String> {
        let mut doubts = self.consistent.as_ref().map(Moved::doubts).unwrap_or_default();
        if !root_is_free {
            doubts.push(
                "the world holds the figure's root, and what it does there is counted as the ground's"
                    .to_owned(),
            );
        }
        if matches!(soles, From::Guess) {
            doubts.push(
                "the soles are a guess by the names of the bodies; --soles says where they are".to_owned(),
            );
        }
        for foot in &self.feet {
            let name = &foot.name;
            if foot.frames == 0 {
                doubts.push(format!("{name} never stands: is its sole where it should be?"));
            }
            if let Some(least) = foot.least_n.filter(|least| least.worst < -PULL * self.weight_n) {
                let (pull, at) = (short(-least.worst), short(least.at_s));
                doubts.push(format!("the ground would have to pull on {name}: {pull} N at {at} s"));
            }
            if let Some(ratio) = foot.friction.filter(|ratio| ratio.share > 0.0) {
                let (ratio, at) = (short(ratio.worst), short(ratio.at_s));
                doubts.push(format!("{name} would slip: it needs a friction of {ratio} at {at} s"));
            }
            if let Some(outside) = foot.cop_outside_m.filter(|outside| outside.worst > OUTSIDE) {
                let (by, at) = (short(outside.worst * 1000.0), short(outside.at_s));
                doubts.push(format!(
                    "the centre of pressure of {name} is {by} mm outside of its sole at {at} s"
                ));
            }
        }
        if self.unsupported.force_rms_n > AIR * self.weight_n {
            let (frames, share) =
                (self.unsupported.frames, self.unsupported.force_rms_n / self.weight_n * 100.0);
            doubts.push(format!(
                "no foot stands in {frames} frames, and {share:.0} % of the weight is left in the air there: \
                 see --stance-height, --stance-speed"
            ));
        }
        if self.irregular_frames > 0 {
            let frames = self.irregular_frames;
            doubts.push(format!(
                "in {frames} frames several feet stand, not between two single supports: their shares are a guess"
            ));
        }
        doubts
    }
}

/// How much of the weight the ground may pull, or push where no foot stands, and how far (m) outside of a sole it may press
/// before it is worth a warning.
const PULL: f64 = 0.01;
const AIR: f64 = 0.1;
const OUTSIDE: f64 = 0.01;

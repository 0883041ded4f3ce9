//! The report on the ground's forces, as numbers.

use super::against::Beside;
use super::moved::Moved;
use super::predicted::Predicted;
use super::soles::From;
use crate::given::Given;
use crate::plausible::Plausibility;
use crate::words::short;
use serde::Serialize;
use solaris::analysis::ground::{Elsewhere, ElsewhereKind, FootReport, Split, Unsupported};

/// The ground and what it does to the feet.
#[derive(Serialize)]
pub(crate) struct GroundReport {
    pub(super) soles_from: String,
    pub(super) level_m: f64,
    /// The lowest and the highest that feet stand, where the ground is not level.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) feet_stand_m: Option<[f64; 2]>,
    pub(super) belt_m_s: [f64; 3],
    pub(super) belt_from: &'static str,
    pub(super) stances_from: &'static str,
    pub(super) split: Split,
    /// What was changed of the motion; absent where that was not asked for.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) consistent: Option<Moved>,
    pub(super) weight_n: f64,
    pub(super) feet: Vec<Foot>,
    /// Frames in which several feet stand, but not between two single supports.
    pub(super) irregular_frames: usize,
    pub(super) unsupported: Unsupported,
    /// When something else than feet on the ground carries.
    pub(super) elsewhere: Vec<Elsewhere>,
    /// The forces of the feet that have a plate, together, beside these.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) beside_plates: Option<Beside>,
    /// Whether those forces fit the motion.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) plausibility: Option<Plausibility>,
    /// What a person should look at.
    pub(crate) warnings: Vec<String>,
}

/// One foot.
#[derive(Serialize)]
pub(super) struct Foot {
    #[serde(flatten)]
    pub(super) found: FootReport,
    /// Where it has a plate.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) beside_plate: Option<Beside>,
}

impl GroundReport {
    pub(crate) fn new(ground: Predicted, given: &Given) -> Self {
        let Predicted { from, belt_from, moved, forces, .. } = ground;
        let (stances, found) = (forces.stances, forces.report);
        let mut report = Self {
            soles_from: from.describe(),
            level_m: stances.level,
            feet_stand_m: stances.heights(&-given.body.gravity.normalize()).map(|(low, high)| [low, high]),
            belt_m_s: stances.belt.into(),
            belt_from,
            stances_from: stances.method,
            split: found.split,
            consistent: moved,
            weight_n: found.weight,
            feet: found.feet.into_iter().map(|found| Foot { found, beside_plate: None }).collect(),
            irregular_frames: found.irregular,
            unsupported: found.unsupported,
            elsewhere: found.elsewhere,
            beside_plates: None,
            plausibility: None,
            warnings: Vec::new(),
        };
        report.warnings = report.doubts(&from, given.body.figure.root_is_free());
        report
    }

    /// Whether plates fit the motion, where there are some.
    pub(super) fn plausibility(&self) -> Option<&Plausibility> {
        self.plausibility.as_ref()
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
        for Foot { found: foot, .. } in &self.feet {
            let name = &foot.name;
            if foot.frames == 0 {
                doubts.push(format!("{name} never stands: is its sole where it should be?"));
            }
            if let Some(least) = foot.least.filter(|least| least.value < -PULL * self.weight_n) {
                let (pull, at) = (short(-least.value), short(least.time));
                doubts.push(format!("the ground would have to pull on {name}: {pull} N at {at} s"));
            }
            if let Some(ratio) = foot.friction.filter(|ratio| ratio.share > 0.0) {
                let (ratio, at) = (short(ratio.value), short(ratio.time));
                doubts.push(format!("{name} would slip: it needs a friction of {ratio} at {at} s"));
            }
            if let Some(outside) = foot.outside.filter(|outside| outside.value > OUTSIDE) {
                let (by, at) = (short(outside.value * 1000.0), short(outside.time));
                doubts.push(format!(
                    "the centre of pressure of {name} is {by} mm outside of its sole at {at} s"
                ));
            }
        }
        if self.unsupported.force_rms > AIR * self.weight_n {
            let (frames, share) =
                (self.unsupported.frames, self.unsupported.force_rms / self.weight_n * 100.0);
            doubts.push(format!(
                "no foot stands in {frames} frames, and {share:.0} % of the weight is left in the air there: \
                 see --stance-height, --stance-speed"
            ));
        }
        // Of feet that stand on stairs the ground's own row tells.
        let is_told = |kind| kind == ElsewhereKind::Raised && self.feet_stand_m.is_some();
        let untold = self.elsewhere.iter().filter(|elsewhere| !is_told(elsewhere.kind));
        doubts.extend(untold.map(|elsewhere| self.carried(elsewhere)));
        if self.irregular_frames > 0 {
            let frames = self.irregular_frames;
            doubts.push(format!(
                "in {frames} frames several feet stand, not between two single supports: their shares are a guess"
            ));
        }
        doubts
    }
}

impl GroundReport {
    /// What carries besides feet on the ground, in words.
    fn carried(&self, elsewhere: &Elsewhere) -> String {
        let Elsewhere { kind, foot, start, end, time, distance, place, share } = *elsewhere;
        let [x, y, z] = <[f64; 3]>::from(place).map(|x| short((x * 1e3).round() / 1e3));
        let (when, at) = (format!("from {} to {} s", short(start), short(end)), short(time));
        let percent = |share: f64| format!("{:.0} %", share * 100.0);
        match kind {
            ElsewhereKind::Beside => {
                let out = short((distance * 1e3).round());
                let share = share.map_or_else(String::new, |share| {
                    format!(", {} of what is borne if it presses below the hips", percent(share))
                });
                format!(
                    "{when} something else carries (a seat, a handrail?): at {at} s the pressure lies {out} mm outside of the \
                     soles, at ({x}, {y}, {z}) m{share}; the forces under the feet are too great by that"
                )
            }
            ElsewhereKind::Raised => {
                let (high, name) =
                    (short((distance * 1e3).round() / 1e3), foot.map(|foot| &self.feet[foot].found.name));
                let name = name.map_or("a foot", String::as_str);
                format!("{when} {name} stands {high} m above the ground: on a box, a step?")
            }
            _ => format!(
                "{when} no foot stands and something else carries: all that is borne, at {at} s at ({x}, {y}, {z}) m; or a foot \
                 stands that is not seen: see --stances"
            ),
        }
    }
}

/// How much of the weight the ground may pull, or push where no foot stands, and how far (m) outside of a sole it may press
/// before it is worth a warning.
const PULL: f64 = 0.01;
const AIR: f64 = 0.1;
const OUTSIDE: f64 = 0.01;

//! Checks of predicted ground forces: friction, pull, centre of pressure, frames without support.

use crate::ground::outline::outside;
use crate::ground::{BalanceFrame, GroundError, PlacedFeet, Stances};
use solaris_model::{Contact, GroundAxes};

/// The worst of a quantity over time.
///
/// With the feature `serde` its keys are `worst`, `at_s` and `share`; whoever holds it names its unit.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Worst {
    /// The worst value.
    #[cfg_attr(feature = "serde", serde(rename = "worst"))]
    pub value: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "at_s"))]
    pub time: f64,
    /// Share of the foot's standing frames that are at fault.
    pub share: f64,
}

/// What is to be said of one foot's forces.
///
/// With the feature `serde` its keys are `name`, `link`, `toes`, `width_m`, `stances_s`, `frames`, `greatest_n`,
/// `greatest_of_weight`, `least_n`, `friction` and `cop_outside_m`.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FootReport {
    /// The sole's name.
    pub name: String,
    /// The foot's link.
    pub link: String,
    /// The toes' link, where the sole has one.
    pub toes: Option<String>,
    /// The sole's breadth (m), where it has one.
    #[cfg_attr(feature = "serde", serde(rename = "width_m"))]
    pub width: Option<f64>,
    /// From when until when it stands (s).
    #[cfg_attr(feature = "serde", serde(rename = "stances_s"))]
    pub stances: Vec<[f64; 2]>,
    /// Frames in which it stands.
    pub frames: usize,
    /// Greatest normal force (N).
    #[cfg_attr(feature = "serde", serde(rename = "greatest_n"))]
    pub greatest: f64,
    /// The same as a share of the figure's weight.
    pub greatest_of_weight: f64,
    /// Least normal force (N); `share` of frames in which the ground would have to pull. `None` where the foot never
    /// stands.
    #[cfg_attr(feature = "serde", serde(rename = "least_n"))]
    pub least: Option<Worst>,
    /// Greatest tangential over normal force, while the foot bears [`FootReport::LOADED`] of the weight; `share` of
    /// frames above [`FootReport::FRICTION`]. `None` where it never bears so much.
    pub friction: Option<Worst>,
    /// How far (m) the centre of pressure is outside of the sole's outline at worst, while the foot bears so much;
    /// `share` of frames outside. `None` where it never does, and where the sole has no breadth.
    #[cfg_attr(feature = "serde", serde(rename = "cop_outside_m"))]
    pub outside: Option<Worst>,
}

impl FootReport {
    /// Share of the weight that a foot must bear for friction and centre of pressure to be judged: of nearly nothing
    /// both mean nothing.
    pub const LOADED: f64 = 0.05;

    /// The friction ratio that is too much: dry soles on dry floors have about so much.
    pub const FRICTION: f64 = 0.6;
}

/// Frames in which no foot stands: nothing but gravity should act there, and the whole wrench be zero.
///
/// With the feature `serde` its keys are `frames`, `force_rms_n`, `force_greatest_n` and `at_s`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Unsupported {
    /// How many.
    pub frames: usize,
    /// Root of the mean square of the force (N) that is left unexplained.
    #[cfg_attr(feature = "serde", serde(rename = "force_rms_n"))]
    pub force_rms: f64,
    /// Greatest force (N).
    #[cfg_attr(feature = "serde", serde(rename = "force_greatest_n"))]
    pub force: f64,
    /// When (s).
    #[cfg_attr(feature = "serde", serde(rename = "at_s"))]
    pub time: f64,
}

/// Judges the contacts of each foot (by sole, one a frame), and the frames in which none stands.
///
/// # Errors
///
/// Stances that are none, contacts or a total of other frames.
#[doc(alias = "check")]
pub fn judge(
    feet: &PlacedFeet<'_>,
    stances: &Stances,
    total: &[BalanceFrame],
    contacts: &[Vec<Contact>],
) -> Result<(Vec<FootReport>, Unsupported), GroundError> {
    let (prepared, soles) = (feet.prepared(), feet.soles());
    stances.check(soles.len())?;
    let rows = prepared.motion.len();
    let lengths = contacts.iter().map(Vec::len).chain([total.len()]);
    let wrong = lengths.map(|found| (found, rows)).chain([(contacts.len(), soles.len())]);
    if let Some((found, expected)) = wrong.into_iter().find(|(found, expected)| found != expected) {
        return Err(GroundError::Length { what: "the ground's force", found, expected });
    }
    let ground = GroundAxes::new(&prepared.up);
    let link = |index: usize| prepared.figure.links()[index].name().to_owned();
    let reports = soles.iter().enumerate().map(|(foot, sole)| {
        let standing: Vec<usize> =
            (0..rows).filter(|row| stances.stands(foot, prepared.time()[*row])).collect();
        let by_frame = stances.by_frame(foot, prepared.time());
        let normal = |row: usize| contacts[foot][row].force.dot(&prepared.up);
        let loaded = |row: &usize| normal(*row) > FootReport::LOADED * prepared.weight;
        let friction = |row: usize| {
            let force = contacts[foot][row].force;
            let ground = stances.of(by_frame[row], &prepared.up).normal;
            let pressed = force.dot(&ground);
            (force - ground * pressed).norm() / pressed
        };
        let beyond = |row: usize| {
            let outline = feet.outline(row, foot, stances.level);
            let corners = outline.iter().map(|corner| ground.flat(corner));
            (!outline.is_empty()).then(|| outside(&corners, &ground.flat(&contacts[foot][row].cop)))
        };
        let count = standing.len();
        let worst = |values: &mut dyn Iterator<Item = (usize, f64)>, bad: &dyn Fn(f64) -> bool| {
            let mut worst: Option<Worst> = None;
            let mut at_fault = 0;
            for (row, value) in values {
                at_fault += usize::from(bad(value));
                if worst.is_none_or(|worst| value > worst.value) {
                    worst = Some(Worst { value, time: prepared.time()[row], share: 0.0 });
                }
            }
            worst.map(|worst| Worst { share: at_fault as f64 / count as f64, ..worst })
        };
        let bearing: Vec<usize> = standing.iter().copied().filter(loaded).collect();
        let mut friction = bearing.iter().map(|row| (*row, friction(*row)));
        let mut outside = bearing.iter().filter_map(|row| beyond(*row).map(|value| (*row, value)));
        let least = worst(&mut standing.iter().map(|row| (*row, -normal(*row))), &|pull| pull > 0.0);
        let own = stances.list.iter().filter(|stance| stance.foot == foot);
        let greatest = standing.iter().map(|row| normal(*row)).fold(0.0, f64::max);
        FootReport {
            name: sole.name.clone(),
            link: link(sole.foot),
            toes: sole.toes.map(link),
            width: sole.width,
            stances: own.map(|stance| [stance.start, stance.end]).collect(),
            frames: count,
            greatest,
            greatest_of_weight: greatest / prepared.weight,
            least: least.map(|least| Worst { value: -least.value, ..least }),
            friction: worst(&mut friction, &|ratio| ratio > FootReport::FRICTION),
            outside: worst(&mut outside, &|distance| distance > 0.0),
        }
    });
    Ok((reports.collect(), unsupported(soles.len(), stances, total)))
}

fn unsupported(feet: usize, stances: &Stances, total: &[BalanceFrame]) -> Unsupported {
    let mut out = Unsupported::default();
    let mut squares = 0.0;
    for frame in total.iter().filter(|frame| !(0..feet).any(|foot| stances.stands(foot, frame.time))) {
        let force = frame.force.norm();
        out.frames += 1;
        squares += force * force;
        if force > out.force {
            (out.force, out.time) = (force, frame.time);
        }
    }
    out.force_rms = (squares / out.frames.max(1) as f64).sqrt();
    out
}

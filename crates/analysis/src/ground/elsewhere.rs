//! What carries besides feet on the ground: a seat, a handrail, a box.

use crate::ground::legs::hips;
use crate::ground::outline::{around, nearest, outside};
use crate::ground::{BalanceFrame, GroundError, PlacedFeet, Stances};
use nalgebra::Vector3;
use solaris_dynamics::{Workspace, forward_kinematics};
use solaris_model::GroundAxes;

/// How something else than feet on the ground shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
#[non_exhaustive]
pub enum ElsewhereKind {
    /// The whole wrench presses far outside of all soles that stand: a seat, a handrail, a stick.
    Beside,
    /// Something is borne and no foot stands.
    NoFoot,
    /// A foot stands above the ground: on a box, a step, a stair.
    Raised,
}

/// A time in which something else than feet on the ground carries.
///
/// With the feature `serde` its keys are `kind`, `foot`, `from_s`, `to_s`, `at_s`, `distance_m`, `place_m` and `share`.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Elsewhere {
    /// How it shows.
    pub kind: ElsewhereKind,
    /// Index of the sole that is raised.
    pub foot: Option<usize>,
    /// From when (s).
    #[cfg_attr(feature = "serde", serde(rename = "from_s"))]
    pub start: f64,
    /// Until when (s).
    #[cfg_attr(feature = "serde", serde(rename = "to_s"))]
    pub end: f64,
    /// When it is at its worst (s): where it presses furthest outside, or bears most. What follows is of then.
    #[cfg_attr(feature = "serde", serde(rename = "at_s"))]
    pub time: f64,
    /// How far (m) the whole wrench presses outside of the soles, or how high the raised foot stands; zero where no foot stands.
    #[cfg_attr(feature = "serde", serde(rename = "distance_m"))]
    pub distance: f64,
    /// Where the whole wrench presses on the ground (m, world).
    #[cfg_attr(feature = "serde", serde(rename = "place_m", serialize_with = "numbers"))]
    pub place: Vector3<f64>,
    /// What it must bear, as a share of the whole normal force. Beside soles: if it presses below the hips, and the feet at the edge of their
    /// outline that is nearest; `None` where the hips are not out there. All of it where no foot stands.
    pub share: Option<f64>,
}

/// A place as its three numbers.
#[cfg(feature = "serde")]
fn numbers<S: serde::Serializer>(place: &Vector3<f64>, serializer: S) -> Result<S::Ok, S::Error> {
    serde::Serialize::serialize(&<[f64; 3]>::from(*place), serializer)
}

impl Elsewhere {
    /// How far (m) outside of all soles the whole wrench must press.
    pub const OUTSIDE: f64 = 0.1;
    /// How high (m) above the ground a foot must stand.
    pub const RAISED: f64 = 0.08;
    /// The least share of the weight that is borne.
    pub const LEAST: f64 = 0.3;
    /// How long (s) it must last.
    pub const SHORTEST: f64 = 0.15;
}

/// Finds when something else than feet on the ground carries.
///
/// `total` is the whole wrench, one a frame, with its centre of pressure on the ground. Soles without a breadth have the usual one here.
///
/// # Errors
///
/// Stances that are none, a total of other frames, and states that the kernel refuses.
pub fn find_elsewhere(
    feet: &PlacedFeet<'_>,
    stances: &Stances,
    total: &[BalanceFrame],
) -> Result<Vec<Elsewhere>, GroundError> {
    stances.check(feet.soles().len())?;
    let prepared = feet.prepared();
    let (found, expected) = (total.len(), prepared.motion.len());
    if found != expected {
        return Err(GroundError::Length { what: "the whole wrench", found, expected });
    }
    let ground = GroundAxes::new(&prepared.up);
    let bears = |frame: &BalanceFrame| frame.force.dot(&prepared.up) / prepared.weight;
    let outline = |row: usize| {
        let standing = (0..feet.soles().len()).filter(|foot| stances.stands(*foot, total[row].time));
        let corners = standing.flat_map(|foot| feet.usual_outline(row, foot, stances.level));
        around(corners, &ground, stances.level)
    };
    // Of each frame, how it shows and how far.
    let shows = |row: usize| {
        let frame = &total[row];
        let cop = frame.cop.filter(|_| bears(frame) > Elsewhere::LEAST)?;
        let corners = outline(row);
        if corners.is_empty() {
            return Some((ElsewhereKind::NoFoot, bears(frame)));
        }
        let flat = corners.iter().map(|corner| ground.flat(corner));
        let distance = outside(&flat, &ground.flat(&cop));
        (distance > Elsewhere::OUTSIDE).then_some((ElsewhereKind::Beside, distance))
    };
    let rows: Vec<_> = (0..expected).map(|row| (row, shows(row))).collect();
    let mut out = Vec::new();
    for run in rows.chunk_by(|(_, a), (_, b)| a.map(|(kind, _)| kind) == b.map(|(kind, _)| kind)) {
        let worst = run.iter().filter_map(|&(row, shows)| shows.map(|(kind, by)| (row, kind, by)));
        let Some((row, kind, by)) = worst.max_by(|a, b| a.2.total_cmp(&b.2)) else { continue };
        let [start, end] = [run[0].0, run[run.len() - 1].0].map(|row| total[row].time);
        if end - start < Elsewhere::SHORTEST {
            continue;
        }
        let (frame, is_beside) = (&total[row], kind == ElsewhereKind::Beside);
        let place = frame.cop.unwrap_or_default();
        let share = if is_beside {
            let flat: Vec<_> = outline(row).iter().map(|corner| ground.flat(corner)).collect();
            let edge = nearest(&flat.iter().copied(), &ground.flat(&place));
            let reach = ground.flat(&below_hips(feet, row)?) - edge;
            let way = ground.flat(&place) - edge;
            Some(way.norm_squared() / reach.dot(&way))
                .filter(|share| *share > 0.0)
                .map(|share| share.min(1.0))
        } else {
            Some(1.0)
        };
        let distance = if is_beside { by } else { 0.0 };
        out.push(Elsewhere { kind, foot: None, start, end, time: frame.time, distance, place, share });
    }
    out.extend(raised(feet, stances, total));
    out.sort_by(|a, b| a.start.total_cmp(&b.start));
    Ok(out)
}

/// Stances above the ground.
fn raised(feet: &PlacedFeet<'_>, stances: &Stances, total: &[BalanceFrame]) -> Vec<Elsewhere> {
    let up = feet.prepared().up;
    let of = |stance: &crate::ground::Stance| {
        let middle = stance.start.midpoint(stance.end);
        let row = total.partition_point(|frame| frame.time < middle).min(total.len().checked_sub(1)?);
        let heights = feet.frame(row)[stance.foot].points.map(|point| point.dot(&up) - stances.level);
        let distance = heights.into_iter().fold(f64::INFINITY, f64::min);
        let frame = &total[row];
        (distance > Elsewhere::RAISED).then(|| Elsewhere {
            kind: ElsewhereKind::Raised,
            foot: Some(stance.foot),
            start: stance.start,
            end: stance.end,
            time: frame.time,
            distance,
            place: frame.cop.unwrap_or_default(),
            share: None,
        })
    };
    stances.list.iter().filter_map(of).collect()
}

/// The middle between the hips in a frame (m, world).
fn below_hips(feet: &PlacedFeet<'_>, row: usize) -> Result<Vector3<f64>, GroundError> {
    let prepared = feet.prepared();
    let mut workspace = Workspace::new(&prepared.tree);
    forward_kinematics(&prepared.tree, &mut workspace, prepared.q(row))
        .map_err(|source| GroundError::State { time: prepared.time()[row], source })?;
    let hips = hips(prepared.figure, feet.soles());
    let sum: Vector3<f64> = hips.iter().map(|hip| workspace.pose(*hip).translation).sum();
    Ok(sum / hips.len().max(1) as f64)
}

//! The curves beside the picture: angles and moments of the joints, forces of the ground.

use crate::bands::Bands;
use crate::draw::Side;
use crate::error::{ViewError, finite};
use crate::members::Members;
use crate::pack::{Packed, ranged};
use crate::world::World;
use crate::{PageCurve, PageOptions};
use serde::Serialize;
use solaris_model::{AnatomicalAngle, AxisKind, ContactTrack, Figure, Motion};
use std::collections::{BTreeMap, HashMap, HashSet};

/// Values over the frames, of one side of the body.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Line {
    side: Side,
    values: Packed,
    /// Half widths of the band around it.
    #[serde(skip_serializing_if = "Option::is_none")]
    spread: Option<Packed>,
}

impl Line {
    fn new(side: Side, values: &[f64]) -> Self {
        Self { side, values: ranged(values), spread: None }
    }
}

/// Curves that share an axis.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Plot {
    unit: String,
    lines: Vec<Line>,
}

/// What one joint does, on both sides where there are two.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct JointCurves {
    label: String,
    position: Plot,
    #[serde(skip_serializing_if = "Option::is_none")]
    effort: Option<Plot>,
    #[serde(skip_serializing_if = "Option::is_none")]
    power: Option<Plot>,
}

/// One component of the ground's forces.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct ForceCurves {
    label: String,
    #[serde(flatten)]
    plot: Plot,
}

/// These come first, in this order.
const FIRST: [&str; 6] =
    ["hip.flexion", "knee.flexion", "ankle.dorsiflexion", "hip_flexion", "knee_angle", "ankle_angle"];

/// A coordinate that is plotted.
#[derive(Clone)]
struct Coordinate {
    side: Side,
    name: String,
    /// Index in `q`, in `v`, and in `tau` where a moment is shown.
    q: usize,
    v: usize,
    tau: Option<usize>,
    sign: f64,
    turns: bool,
    /// The figure that it belongs to, and its mass (kg).
    member: usize,
    mass: f64,
    /// Whether it is an anatomical angle.
    is_angle: bool,
}

/// The anatomical angles; of a figure without any, all one-axis degrees of freedom.
fn coordinates(figure: &Figure, members: &Members) -> Vec<Coordinate> {
    let layout = figure.layout();
    let mut all = Vec::new();
    for ((i, link), joint) in figure.links().iter().enumerate().zip(layout.joints()) {
        let member = members.of_link(i);
        // The forces at a root that nothing holds are no joint's: they are what is left over.
        let floating = members.is_root(link) && link.joint().kind().is_floating();
        // What follows another has nothing of its own to show.
        let own = |k: &usize| joint.nq == joint.nv && !figure.follows(joint.v + k);
        for (k, dof) in link.joint().kind().axes().iter().enumerate().filter(|(k, _)| own(k)) {
            let (v, q) = (joint.v + k, joint.q + k);
            let (side, name) = Side::split(&layout.v_names()[v]);
            let (tau, turns) = ((!floating).then_some(v), dof.axis.kind == AxisKind::Rotation);
            let mass = members.mass(member);
            all.push(Coordinate { side, name, q, v, tau, sign: 1.0, turns, member, mass, is_angle: false });
        }
    }
    let find = |angle: &AnatomicalAngle| {
        let found = all.iter().find(|coordinate| coordinate.v == angle.dof)?;
        let (side, name) = Side::split(&angle.name);
        Some(Coordinate { side, name, sign: angle.sign, is_angle: true, ..found.clone() })
    };
    let angles: Vec<Coordinate> = figure.anatomical_angles().iter().filter_map(find).collect();
    let with_angles: HashSet<usize> = angles.iter().map(|angle| angle.member).collect();
    all.retain(|coordinate| !with_angles.contains(&coordinate.member));
    angles.into_iter().chain(all).collect()
}

/// Angles in degrees (slides in m) and moments in N m/kg (forces in N/kg), left and right of a name together, with the bands
/// of the options.
///
/// # Errors
///
/// A moment that is not finite, bands that do not fit to the motion.
pub(crate) fn joints(
    figure: &Figure,
    motion: &Motion,
    chosen: &[usize],
    options: &PageOptions,
) -> Result<Vec<JointCurves>, ViewError> {
    let angle_bands = Bands::checked(options.angle_bands.as_deref(), "angle", figure, motion)?;
    let moment_bands = Bands::checked(options.moment_bands.as_deref(), "moment", figure, motion)?;
    let members = Members::of(figure);
    let coordinates = coordinates(figure, &members);
    // Left and right of a name together, in the order in which names come.
    let mut places: HashMap<&str, usize> = HashMap::new();
    let mut named: Vec<(&str, Vec<&Coordinate>)> = Vec::new();
    for coordinate in &coordinates {
        let place = *places.entry(&coordinate.name).or_insert(named.len());
        if place == named.len() {
            named.push((&coordinate.name, Vec::new()));
        }
        named[place].1.push(coordinate);
    }
    // A person's pelvis stands where the anatomical angles have it; any other root comes last.
    named.sort_by_key(|(name, of)| {
        let own = name.split_once('.').filter(|_| members.are_several()).map_or(*name, |(_, own)| own);
        let first = FIRST.iter().position(|first| own.starts_with(first)).map(|place| place % 3);
        let is_residual = of.iter().any(|c| c.tau.is_none() && !c.is_angle);
        first.unwrap_or(if is_residual { 4 } else { 3 })
    });
    let mut curves = Vec::new();
    for (name, members) in named {
        let turns = members[0].turns;
        let unit = if turns { "°" } else { "m" };
        let lines = members.iter().map(|c| {
            let factor = c.sign * if c.turns { 1_f64.to_degrees() } else { 1.0 };
            let values: Vec<f64> = chosen.iter().map(|&sample| factor * motion.q(sample)[c.q]).collect();
            Line { spread: angle_bands.around(c.v, chosen, factor), ..Line::new(c.side, &values) }
        });
        let position = Plot { unit: unit.to_owned(), lines: lines.collect() };
        let effort = effort(&members, figure, motion, chosen, &moment_bands)?;
        let [effort, power] = match effort {
            Some([effort, power]) => {
                let unit = if turns { "N m/kg" } else { "N/kg" };
                [(unit, effort), ("W/kg", power)]
                    .map(|(unit, lines)| Some(Plot { unit: unit.to_owned(), lines }))
            }
            None => [None, None],
        };
        curves.push(JointCurves { label: words(name), position, effort, power });
    }
    Ok(curves)
}

/// Moments of these coordinates and their powers; `None` where the motion or the coordinate has none.
fn effort(
    members: &[&Coordinate],
    figure: &Figure,
    motion: &Motion,
    chosen: &[usize],
    bands: &Bands<'_>,
) -> Result<Option<[Vec<Line>; 2]>, ViewError> {
    let (mut lines, mut powers) = (Vec::new(), Vec::new());
    for coordinate in members {
        let mass = coordinate.mass;
        let Some(index) = coordinate.tau.filter(|_| mass > 0.0) else { return Ok(None) };
        let mut values = Vec::with_capacity(chosen.len());
        let mut power = Vec::with_capacity(chosen.len());
        for &sample in chosen {
            let Some(tau) = motion.tau(sample) else { return Ok(None) };
            let name = || format!("tau of '{}'", figure.layout().v_names()[index]);
            finite(name, motion.time()[sample], &[tau[index]])?;
            values.push(coordinate.sign * tau[index] / mass);
            power.push(tau[index] * motion.v(sample)[index] / mass);
        }
        let spread = bands.around(index, chosen, 1.0 / mass);
        lines.push(Line { spread, ..Line::new(coordinate.side, &values) });
        powers.push(Line::new(coordinate.side, &power));
    }
    Ok(Some([lines, powers]))
}

/// `hip.flexion` → `Hip flexion`.
fn words(name: &str) -> String {
    let mut text = name.replace(['.', '_'], " ");
    if let Some(first) = text.get(..1) {
        text = first.to_uppercase() + &text[1..];
    }
    text
}

/// Of how many figures forces are shown one by one: every plot is drawn at every frame.
const MOST: usize = 4;

/// Forces of each side, all its contacts together: upwards, forwards and to the left, in % of the body's weight, or in N
/// where there is no weight; of a few figures one by one, of more all together in N. Empty without contacts.
pub(crate) fn forces(
    figure: &Figure,
    motion: &Motion,
    chosen: &[usize],
    world: &World,
    members: &Members,
) -> Vec<ForceCurves> {
    let mut of: BTreeMap<usize, Vec<&ContactTrack>> = BTreeMap::new();
    for track in &motion.contacts {
        let owner = figure.link_index(&track.link).map_or(0, |link| members.of_link(link));
        of.entry(owner).or_default().push(track);
    }
    if of.len() > MOST {
        return force_curves(
            ", all together",
            &motion.contacts.iter().collect::<Vec<_>>(),
            chosen,
            world,
            None,
        );
    }
    let of_one = |(member, tracks): (usize, Vec<&ContactTrack>)| {
        let weight = members.weight(member, motion.info.gravity.norm());
        let whose = if members.are_several() { format!(", {}", members.name(member)) } else { String::new() };
        force_curves(&whose, &tracks, chosen, world, weight)
    };
    of.into_iter().flat_map(of_one).collect()
}

/// The same of some contacts; `whose` ends their labels.
fn force_curves(
    whose: &str,
    tracks: &[&ContactTrack],
    chosen: &[usize],
    world: &World,
    weight: Option<f64>,
) -> Vec<ForceCurves> {
    let sided: Vec<(Side, &ContactTrack)> =
        tracks.iter().map(|track| (Side::split(&track.link).0, *track)).collect();
    let mut sides: Vec<Side> = sided.iter().map(|(side, _)| *side).collect();
    sides.sort_unstable();
    sides.dedup();
    let (unit, factor) = weight.map_or(("N", 1.0), |weight| ("% BW", 100.0 / weight));
    let curve = |(label, component): (&str, usize)| {
        let line = |&side: &Side| {
            let of = sided.iter().filter(|(own, _)| *own == side);
            let at = |sample: usize| {
                let force = |track: &ContactTrack| world.vector(&track.samples[sample].force)[component];
                factor * of.clone().map(|(_, track)| force(track)).sum::<f64>()
            };
            Line::new(side, &chosen.iter().map(|&sample| at(sample)).collect::<Vec<_>>())
        };
        let plot = Plot { unit: unit.to_owned(), lines: sides.iter().map(line).collect() };
        ForceCurves { label: format!("{label}{whose}"), plot }
    };
    [("Vertical force", 1), ("Force forwards", 2), ("Force to the left", 0)].map(curve).to_vec()
}

/// Curves of the caller's.
///
/// # Errors
///
/// A curve of another length than the motion, a number that is not finite.
pub(crate) fn others(
    motion: &Motion,
    chosen: &[usize],
    curves: &[PageCurve],
) -> Result<Vec<ForceCurves>, ViewError> {
    let one = |PageCurve { label, unit, values }: &PageCurve| {
        let (found, expected) = (values.len(), motion.len());
        if found != expected {
            return Err(ViewError::CurveLength { label: label.clone(), found, expected });
        }
        let mut shown = Vec::with_capacity(chosen.len());
        for &sample in chosen {
            finite(|| label.clone(), motion.time()[sample], &values[sample..=sample])?;
            shown.push(values[sample]);
        }
        let lines = vec![Line::new(Side::Middle, &shown)];
        Ok(ForceCurves { label: label.clone(), plot: Plot { unit: unit.clone(), lines } })
    };
    curves.iter().map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use solaris_model::{Contact, FigureBuilder, Joint, LinkSpec, MotionInfo, Placement, Vector3, human};

    /// A person with the left knee bent by 0.5 rad, and a moment of 73 N m at every dof.
    fn bent_knee() -> (Figure, Motion) {
        let figure = human(1.75, 73.0).expect("a person");
        let (nq, knee) = (figure.layout().nq(), figure.layout().dof_index("left_knee.rx").expect("a knee"));
        let info = MotionInfo {
            fingerprint: figure.fingerprint(),
            gravity: Vector3::new(0.0, -9.81, 0.0),
            ground: None,
            rate: 60.0,
        };
        let mut q = vec![0.0; nq];
        q[knee] = 0.5;
        let mut motion =
            Motion::new(&figure, info, vec![0.0], [q, vec![0.0; nq], vec![0.0; nq]]).expect("finite");
        motion.set_tau(vec![73.0; nq]).expect("one sample");
        (figure, motion)
    }

    #[test]
    fn hip_knee_and_ankle_come_first() {
        let (figure, motion) = bent_knee();
        let curves = joints(&figure, &motion, &[0], &PageOptions::default()).expect("finite");
        let labels: Vec<&str> = curves.iter().take(4).map(|curve| curve.label.as_str()).collect();
        assert_eq!(labels, ["Hip flexion", "Knee flexion", "Ankle dorsiflexion", "Pelvis tilt"]);
    }

    #[test]
    fn angles_are_in_degrees_and_moments_per_mass_with_the_anatomical_sign() {
        let (figure, motion) = bent_knee();
        let curves = joints(&figure, &motion, &[0], &PageOptions::default()).expect("finite");
        let knee = &curves[1];
        assert_eq!((knee.position.unit.as_str(), knee.position.lines[0].side), ("°", Side::Left));
        assert!((knee.position.lines[0].values.unpack()[0] - 28.647_889_756_5).abs() < 1e-9);
        assert!(knee.position.lines[1].values.unpack()[0].abs() < 1e-12);
        let hip = curves[0].effort.as_ref().expect("moments");
        // Flexion of the hip is negative about x.
        assert!((hip.lines[1].values.unpack()[0] + 1.0).abs() < 1e-12);
    }

    #[test]
    fn a_floating_root_shows_no_moment() {
        let (figure, motion) = bent_knee();
        let curves = joints(&figure, &motion, &[0], &PageOptions::default()).expect("finite");
        let tilt = curves.iter().find(|curve| curve.label == "Pelvis tilt").expect("a pelvis");
        assert_eq!((tilt.position.lines.len(), tilt.effort.as_ref()), (1, None));
    }

    #[test]
    fn each_of_several_bears_its_own_weight() {
        let [ann, bob] = [50.0, 100.0].map(|mass| {
            let body = LinkSpec::root("body", Joint::free("root")).mass(mass / 2.0);
            let arm = Joint::new("left_arm").rx();
            let arm = LinkSpec::child("left_arm", "body", arm).mass(mass / 2.0);
            FigureBuilder::new("it").link(body).link(arm).build().expect("a figure")
        });
        let at = Placement::identity();
        let figure = Figure::together(&[("ann", &ann, at), ("bob", &bob, at)]).expect("two figures");
        let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
        let mut q = vec![0.0; nq];
        figure.neutral(&mut q).expect("its length");
        let gravity = Vector3::new(0.0, -10.0, 0.0);
        let info = MotionInfo { fingerprint: figure.fingerprint(), gravity, ground: None, rate: 60.0 };
        let mut motion =
            Motion::new(&figure, info, vec![0.0], [q, vec![0.0; nv], vec![0.0; nv]]).expect("finite");
        motion.set_tau(vec![100.0; nv]).expect("one sample");
        // Each stands on its body with its weight, and bob leans on an arm as well.
        motion.contacts = [("ann.body", 500.0), ("bob.body", 1000.0), ("bob.left_arm", 250.0)]
            .map(|(link, up)| {
                let force = Vector3::new(0.0, up, 0.0);
                ContactTrack { link: link.to_owned(), samples: vec![Contact { force, ..Contact::default() }] }
            })
            .to_vec();
        let world = World::new(&gravity, None);
        let members = Members::of(&figure);
        let forces = forces(&figure, &motion, &[0], &world, &members);
        let labels: Vec<&str> = forces.iter().map(|curve| curve.label.as_str()).collect();
        assert_eq!((labels.len(), labels[0], labels[3]), (6, "Vertical force, ann", "Vertical force, bob"));
        let share = |curve: usize, line: usize| {
            let line = &forces[curve].plot.lines[line];
            (line.side, line.values.unpack()[0].round())
        };
        assert_eq!(forces[0].plot.unit, "% BW");
        assert_eq!(
            [share(0, 0), share(3, 0), share(3, 1)].map(|(side, share)| (side == Side::Left, share)),
            [(false, 100.0), (true, 25.0), (false, 100.0)]
        );
        assert_eq!(members.greatest_weight(&figure, &motion), Some(1000.0));
        motion.contacts.truncate(1);
        assert_eq!(members.greatest_weight(&figure, &motion), Some(500.0));
        // Moments are per mass of whose they are, too.
        let curves = joints(&figure, &motion, &[0], &PageOptions::default()).expect("finite");
        let arms: Vec<f64> = curves
            .iter()
            .filter_map(|curve| Some(curve.effort.as_ref()?.lines[0].values.unpack()[0]))
            .collect();
        assert_eq!(arms, [2.0, 1.0]);
    }

    #[test]
    fn many_bear_all_together_in_newtons() {
        let body = LinkSpec::root("body", Joint::free("root")).mass(50.0);
        let one = FigureBuilder::new("it").link(body).build().expect("a figure");
        let names: Vec<String> = (0..=MOST).map(|i| format!("p{i}")).collect();
        let all: Vec<_> = names.iter().map(|name| (name.as_str(), &one, Placement::identity())).collect();
        let figure = Figure::together(&all).expect("figures");
        let mut q = vec![0.0; figure.layout().nq()];
        figure.neutral(&mut q).expect("its length");
        let zeros = vec![0.0; figure.layout().nv()];
        let info = MotionInfo::on_earth(&figure, 60.0);
        let mut motion = Motion::new(&figure, info, vec![0.0], [q, zeros.clone(), zeros]).expect("finite");
        let force = Vector3::new(0.0, 500.0, 0.0);
        let track = |name: &String| ContactTrack {
            link: format!("{name}.body"),
            samples: vec![Contact { force, ..Contact::default() }],
        };
        motion.contacts = names.iter().map(track).collect();
        let world = World::new(&motion.info.gravity, None);
        let forces = forces(&figure, &motion, &[0], &world, &Members::of(&figure));
        let (up, unit) = (&forces[0].plot.lines[0].values.unpack(), forces[0].plot.unit.as_str());
        assert_eq!((forces.len(), unit), (3, "N"));
        assert!((up[0] - 500.0 * names.len() as f64).abs() < 1e-9);
    }

    #[test]
    fn a_band_is_in_degrees_and_per_mass_whatever_the_sign() {
        let (figure, motion) = bent_knee();
        let layout = figure.layout();
        let [hip, knee] =
            ["left_hip.rx", "left_knee.rx"].map(|name| layout.dof_index(name).expect("a degree of freedom"));
        let mut bands = vec![0.0; layout.nv()];
        (bands[hip], bands[knee]) = (0.1, 0.02);
        let moments = bands.iter().map(|band| 73.0 * band).collect();
        let options =
            PageOptions { angle_bands: Some(bands), moment_bands: Some(moments), ..PageOptions::default() };
        let curves = joints(&figure, &motion, &[0], &options).expect("bands that fit");
        let around =
            |plot: &Plot, line: usize| plot.lines[line].spread.as_ref().map(|spread| spread.unpack()[0]);
        // Flexion of the hip is negative about x.
        for (curve, expected) in curves.iter().zip([0.1, 0.02]) {
            let (angle, moment) = (&curve.position, curve.effort.as_ref().expect("moments"));
            assert!((around(angle, 0).expect("a band") - expected * 57.295_779_513_1).abs() < 1e-9);
            assert!((around(moment, 0).expect("a band") - expected).abs() < 1e-9);
            assert_eq!(
                (around(angle, 1), around(moment, 1)),
                (None, None),
                "nothing is known of the right leg"
            );
            assert_eq!(around(curve.power.as_ref().expect("powers"), 0), None);
        }
    }

    #[test]
    fn bands_that_do_not_fit_are_refused() {
        let (figure, motion) = bent_knee();
        let nv = figure.layout().nv();
        let refused =
            |options: &PageOptions| joints(&figure, &motion, &[0], options).expect_err("refused").to_string();
        let angles = |bands| PageOptions { angle_bands: Some(bands), ..PageOptions::default() };
        let short = refused(&angles(vec![0.0; nv - 2]));
        let expected =
            format!("the angle bands are {} numbers, the motion asks for {nv}; give {nv} for each", nv - 2);
        assert!(short.starts_with(&expected), "{short}");
        let moments = PageOptions { moment_bands: Some(Vec::new()), ..PageOptions::default() };
        assert!(refused(&moments).starts_with("the moment bands are 0 numbers, the motion asks for"));
        for value in [-0.1, f64::NAN, f64::INFINITY] {
            let mut bands = vec![0.0; nv];
            bands[figure.layout().dof_index("left_knee.rx").expect("a knee")] = value;
            let expected =
                format!("the angle band of 'left_knee.rx' at 0 s is {value} to each side; it must be");
            let wild = refused(&angles(bands));
            assert!(wild.starts_with(&expected), "{wild}");
        }
    }
}

//! A figure and its motion from a glTF file.

use super::bones::Bones;
use super::curves::{self, Animation};
use super::document::{At, Document};
use super::fault::GlbError;
use super::nodes::{Local, Nodes, World};
use crate::bvh::Unit;
use crate::clip::bones::{Said, lengths, names};
use crate::clip::{Clip, ReadOptions, Up, masses};
use crate::upright::upright;
use solaris_model::rig::{Bone, Segment, bones};
use solaris_model::{
    Figure, FigureBuilder, FindingKind, Isometry3, Joint, Known, LinkSpec, Matrix3, Motion, MotionInfo,
    Placement, UnitQuaternion, Vector3,
};

/// Gravity (m/s²): down, y is up.
const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.806_65, 0.0);
/// How far (of the skeleton's size) places may be from a constant that they are rounded from.
const STILL: f64 = 1e-5;
/// Frames a second where keys are fewer.
const LEAST_RATE: f64 = 24.0;
const RATE: f64 = 30.0;
/// How far (relative) the time between keys may be from that of a whole number of frames a second.
const WHOLE: f64 = 3e-4;
/// The most frames of an animation with few keys: ten minutes; one with more may have four a key.
const LONG: f64 = 18_000.0;
/// The most frames times bones.
const MOST: f64 = 4e6;

/// Reads a `.glb`, or a `.gltf` that holds its bytes itself: a figure of its bones, and the motion that an animation is.
///
/// Bones are the joints of skins, what moves between them, and what is above them down from the one that is above all; without a skin the
/// nodes that an animation turns or moves. Of several trees the one with most bones is read. Each bone is a link of the node's
/// name, at the node's place and along its axes; **with all joints at zero the figure stands as the file's nodes do**. Joints turn as balls; one
/// whose place in its parent changes is free, and so is the root. What stands above the root, such as a scale of 0.01, is counted in: lengths are
/// metres. Masses are found as for BVH ([`crate::bvh::read`]).
///
/// The motion is that of the animation `options.clip`, or the first: curves that are linear, steps or cubic, sampled at the rate of their
/// keys (24 frames/s or more; 30 where keys are fewer), from its first key to its last. A file without an animation stands in one frame.
///
/// # Errors
///
/// Whatever is not glTF 2.0, with its place in the JSON: lengths that go past the file, indices of nothing, nodes that are no tree, numbers
/// that are not finite, times that do not rise, bytes in other files; no bones; a clip that is not there; options that cannot be.
///
/// # Source
///
/// Khronos, glTF 2.0 specification (2021).
pub fn read(bytes: &[u8], options: &ReadOptions) -> Result<Clip, GlbError> {
    masses::check(options)?;
    let mut said = Said { text: "", findings: Vec::new() };
    let document = Document::read(bytes)?;
    let nodes = Nodes::of(&document)?;
    let animation = chosen(&document, &nodes, options.clip.as_deref(), &mut said)?;
    let found = Bones::of(&document, &nodes, animation.as_ref())?;
    if !found.others.is_empty() {
        let message = format!(
            "of {} skeletons in the file the largest is read; the others are below {}",
            found.others.len() + 1,
            some(&found.others)
        );
        said.say(FindingKind::Note, "nodes", message, None);
    }
    let unit = options.unit.unwrap_or(Unit::Metres);
    let raw: Vec<_> = found.nodes.iter().map(|i| (nodes.nodes[*i].name.as_str(), None)).collect();
    let names = names("node", &raw, &mut said);
    let segments = bones(&names.iter().map(String::as_str).collect::<Vec<_>>());
    let segments = if masses::is_person(&segments) { segments } else { vec![None; segments.len()] };
    let times = times(animation.as_ref(), options.skip, found.nodes.len())?;
    let shape = Shape::of(&nodes, &found, animation.as_ref(), &times, unit);
    if !shape.is_even {
        let message =
            "some nodes are scaled by axis and turned below that: their places are taken as they are at rest";
        said.say(FindingKind::Suspect, "scales", message.to_owned(), None);
    }
    let z_up = options.up.unwrap_or_else(|| up(&shape.rest, &segments, &mut said)) == Up::Z;
    let turned = if z_up { upright(&-Vector3::z()) } else { UnitQuaternion::identity() };
    let joints: Vec<_> = (0..names.len())
        .map(|i| (found.parents[i], shape.places[i].translation.vector, shape.tips[i]))
        .collect();
    let lengths = lengths(&joints, &segments);
    if let Some(height) = masses::stature(&lengths).filter(|height| !(0.5..2.6).contains(height)) {
        let message = format!(
            "by its legs it is a person of {height:.2} m, taking 1 unit for {unit}; give the unit of its lengths"
        );
        said.say(FindingKind::Suspect, "unit of lengths", message, None);
    }
    let weights = masses::weights(&lengths, &names, options, &mut said)?;
    let mut builder = FigureBuilder::new(names[0].clone()).gravity(GRAVITY);
    for (i, weight) in weights.into_iter().enumerate() {
        let mut placement = shape.places[i];
        let name = names[i].clone();
        let mut link = match found.parents[i] {
            None => {
                placement.rotation = turned * placement.rotation;
                LinkSpec::root(name.clone(), Joint::free(name).placed(placement))
            }
            Some(parent) => {
                let joint =
                    if shape.slides[i] { Joint::free(name.clone()) } else { Joint::ball(name.clone()) };
                LinkSpec::child(name, names[parent].clone(), joint.placed(placement))
            }
        };
        link = link.mass(weight.mass).inertia(weight.inertia).com(weight.com);
        if let Some(solid) = weight.shape {
            link = link.shape(solid);
        }
        if let Some(tip) = shape.tips[i] {
            link = link.tip(tip);
        }
        builder = builder.link(link);
    }
    let figure = builder.build()?;
    let motion = motion(&figure, &nodes, &found, animation.as_ref(), &times, &shape, unit)?;
    Ok(Clip { figure, motion, findings: said.findings, unit })
}

/// The names of a file's animations, in their order; one without a name has `animation` and its number.
///
/// # Errors
///
/// What is not glTF 2.0.
pub fn animations(bytes: &[u8]) -> Result<Vec<String>, GlbError> {
    Ok(named(&Document::read(bytes)?.list("animations")?))
}

/// The animation that is asked for, or the first.
fn chosen(
    document: &Document,
    nodes: &Nodes,
    asked: Option<&str>,
    said: &mut Said,
) -> Result<Option<Animation>, GlbError> {
    let list = document.list("animations")?;
    let names = named(&list);
    let index = match asked {
        None => 0,
        Some(asked) => names.iter().position(|name| name == asked).ok_or_else(|| GlbError::NoClip {
            name: asked.to_owned(),
            names: (!names.is_empty()).then(|| some(&names)),
        })?,
    };
    if names.is_empty() {
        said.say(
            FindingKind::Note,
            "animations",
            "the file has none: it is one frame, its rest pose".to_owned(),
            None,
        );
        return Ok(None);
    }
    if asked.is_none() && names.len() > 1 {
        let message = format!("'{}' is read, the first of {}: {}", names[0], names.len(), some(&names));
        said.say(FindingKind::Note, "animations", message, None);
    }
    Animation::of(document, nodes, index).map(Some)
}

fn named(animations: &[At]) -> Vec<String> {
    animations.iter().enumerate().map(|(i, at)| curves::name(at, i)).collect()
}

/// Names in quotes, the first twelve.
fn some(names: &[String]) -> String {
    const SHOWN: usize = 12;
    let quoted: Vec<String> = names.iter().take(SHOWN).map(|name| format!("'{name}'")).collect();
    let more = names.len().saturating_sub(SHOWN);
    if more > 0 { format!("{} and {more} more", quoted.join(", ")) } else { quoted.join(", ") }
}

/// The frames of a clip.
struct Times {
    /// The first frame in the animation's own time (s).
    start: f64,
    rate: f64,
    count: usize,
}

impl Times {
    fn at(&self, frame: usize) -> f64 {
        self.start + frame as f64 / self.rate
    }
}

fn times(animation: Option<&Animation>, skip: usize, bones: usize) -> Result<Times, GlbError> {
    let curves = || animation.into_iter().flat_map(Animation::curves);
    let first = curves().map(|curve| curve.times()[0]).fold(f64::INFINITY, f64::min);
    let last = curves().map(|curve| curve.times()[curve.times().len() - 1]).fold(f64::NEG_INFINITY, f64::max);
    let dense = curves().max_by_key(|curve| curve.times().len()).map_or(&[][..], |curve| curve.times());
    let mut steps: Vec<f64> = dense.windows(2).map(|pair| pair[1] - pair[0]).collect();
    steps.sort_by(f64::total_cmp);
    let keys = steps.get(steps.len() / 2).map_or(RATE, |step| 1.0 / step);
    let whole = if (keys / keys.round() - 1.0).abs() < WHOLE { keys.round() } else { keys };
    let own = animation.and_then(|animation| animation.rate).filter(|rate| (1.0..=1e5).contains(rate));
    let rate = own.unwrap_or(if (LEAST_RATE..=1e5).contains(&whole) { whole } else { RATE });
    if !(first.is_finite() && last.is_finite()) {
        return Ok(Times { start: 0.0, rate, count: 1 });
    }
    // A last key that a float puts a little before its frame is that frame.
    let frames = ((last - first) * rate + 0.01).floor() + 1.0;
    if frames * bones as f64 > MOST || frames > LONG.max(4.0 * dense.len() as f64) {
        return Err(GlbError::Long { duration: last - first, rate, frames, bones });
    }
    let count = frames as usize;
    if skip > 0 && skip >= count {
        return Err(crate::bvh::BvhError::Skip { skip, frames: count }.into());
    }
    Ok(Times { start: first + skip as f64 / rate, rate, count: count - skip })
}

/// The bones in metres.
struct Shape {
    /// Where each is in its parent at rest; the root at the origin.
    places: Vec<Placement>,
    /// What makes metres in the parent's own axes of a translation in the file.
    scales: Vec<Matrix3<f64>>,
    /// Whether its place in its parent changes.
    slides: Vec<bool>,
    /// Where a last bone ends, if the file has a node there.
    tips: Vec<Option<Vector3<f64>>>,
    /// Places in the world at rest (m).
    rest: Vec<Vector3<f64>>,
    /// Whether no scale of an axis of its own stands above a bone.
    is_even: bool,
}

impl Shape {
    fn of(nodes: &Nodes, bones: &Bones, animation: Option<&Animation>, times: &Times, unit: Unit) -> Self {
        let metre = 1.0 / unit.per_metre();
        let count = bones.nodes.len();
        let worlds = nodes.rest();
        let metres =
            |world: &World| world.rotation.inverse().to_rotation_matrix().matrix() * world.matrix * metre;
        let above =
            |i: usize| bones.parents[i].map_or_else(World::identity, |parent| worlds[bones.nodes[parent]]);
        let scales: Vec<_> = (0..count).map(|i| metres(&above(i))).collect();
        let rest: Vec<Vector3<f64>> = bones.nodes.iter().map(|i| worlds[*i].origin * metre).collect();
        let size =
            (0..count).filter_map(|i| Some((rest[i] - rest[bones.parents[i]?]).norm())).fold(0.0, f64::max);
        let (mut places, mut slides) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for (i, node) in bones.nodes.iter().enumerate() {
            let local = nodes.nodes[*node].local;
            let curve = animation
                .and_then(|animation| animation.translations[*node].as_ref())
                .filter(|_| bones.parents[i].is_some());
            let at = |frame: usize| {
                animation
                    .map_or(local, |animation| animation.local(*node, &local, times.at(frame)))
                    .translation
            };
            let first = curve.map_or(local.translation, |_| at(0));
            let off = |frame: usize| (scales[i] * (at(frame) - first)).norm() > STILL * size;
            let moves = curve.is_some() && (1..times.count).any(off);
            slides.push(moves);
            places.push(match bones.parents[i] {
                None => Isometry3::from_parts(Vector3::zeros().into(), worlds[*node].rotation),
                Some(_) => Isometry3::from_parts(
                    (scales[i] * if moves { local.translation } else { first }).into(),
                    local.rotation,
                ),
            });
        }
        let mut tips = vec![None; count];
        let mut goes_on = vec![false; count];
        bones.parents.iter().flatten().for_each(|parent| goes_on[*parent] = true);
        let mut child = vec![None; nodes.nodes.len()];
        for i in nodes.order.iter().rev() {
            if let Some(parent) = nodes.nodes[*i].parent {
                child[parent] = Some(*i);
            }
        }
        for (i, node) in bones.nodes.iter().enumerate() {
            if let Some(end) = child[*node].filter(|_| !goes_on[i]) {
                let tip = metres(&worlds[*node]) * nodes.nodes[end].local.translation;
                tips[i] = Some(tip).filter(|tip| tip.norm() > STILL * size);
            }
        }
        let even = |m: &Matrix3<f64>| (m - Matrix3::identity() * (m.trace() / 3.0)).amax() <= 1e-3 * m.amax();
        let is_even = scales.iter().all(even);
        Self { places, scales, slides, tips, rest, is_even }
    }
}

/// z where a person's head is above the feet along it; y where that cannot be told.
fn up(rest: &[Vector3<f64>], segments: &[Option<Bone>], said: &mut Said) -> Up {
    let middle = |segment: Segment| {
        let of: Vec<&Vector3<f64>> = rest
            .iter()
            .zip(segments)
            .filter(|(_, bone)| bone.is_some_and(|bone| bone.segment == segment))
            .map(|(at, _)| at)
            .collect();
        (!of.is_empty()).then(|| of.iter().copied().sum::<Vector3<f64>>() / of.len() as f64)
    };
    let Some((head, feet)) = middle(Segment::Head).zip(middle(Segment::Foot)) else { return Up::Y };
    let way = head - feet;
    if way.z <= way.y.abs().max(way.x.abs()) {
        return Up::Y;
    }
    let message =
        "z points up in this file, as its head is above its feet along z; its y, z, x are x, y, z here";
    said.say(FindingKind::Note, "axes", message.to_owned(), None);
    Up::Z
}

#[allow(clippy::too_many_arguments, reason = "all that was found of the file")]
fn motion(
    figure: &Figure,
    nodes: &Nodes,
    bones: &Bones,
    animation: Option<&Animation>,
    times: &Times,
    shape: &Shape,
    unit: Unit,
) -> Result<Motion, GlbError> {
    let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
    let metre = 1.0 / unit.per_metre();
    let mut q = Vec::with_capacity(times.count * nq);
    let local = |node: usize, time: f64| -> Local {
        let rest = &nodes.nodes[node].local;
        animation.map_or(*rest, |animation| animation.local(node, rest, time))
    };
    // What is above the root, from the outside inwards.
    let mut above = Vec::new();
    let mut at = Some(bones.nodes[0]);
    while let Some(node) = at {
        above.push(node);
        at = nodes.nodes[node].parent;
    }
    above.reverse();
    for frame in 0..times.count {
        let time = times.at(frame);
        for (i, node) in bones.nodes.iter().enumerate() {
            let back = shape.places[i].rotation.inverse();
            let (place, turn) = if bones.parents[i].is_none() {
                let world =
                    above.iter().fold(World::identity(), |world, node| world.then(&local(*node, time)));
                (Some(back * (world.origin * metre)), back * world.rotation)
            } else {
                let now = local(*node, time);
                let moved = shape.scales[i] * now.translation - shape.places[i].translation.vector;
                (shape.slides[i].then(|| back * moved), back * now.rotation)
            };
            q.extend(place.iter().flat_map(|place| place.iter()));
            // Of a turn's two quaternions the one near to that before.
            let mut turn = *turn.quaternion();
            let first = q.len();
            if frame > 0 {
                let before = &q[first - nq..first - nq + 4];
                if turn.coords.iter().zip(before).map(|(a, b)| a * b).sum::<f64>() < 0.0 {
                    turn = -turn;
                }
            }
            let length = turn.norm();
            q.extend(turn.coords.iter().map(|x| x / length));
        }
    }
    if let Some(at) = q.iter().position(|x| !x.is_finite()) {
        return Err(GlbError::NotFinite { place: "the animation".to_owned(), row: at / nq, value: q[at] });
    }
    let time: Vec<f64> = (0..times.count).map(|frame| frame as f64 / times.rate).collect();
    let mut info = MotionInfo::recorded(figure, GRAVITY, &time);
    info.rate = times.rate;
    let zeros = || vec![0.0; times.count * nv];
    Ok(Motion::recorded(figure, info, time, [q, zeros(), zeros()], Known::none(nv))?)
}

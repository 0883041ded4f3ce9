//! Everything that a page is told, as one object.

use crate::PageOptions;
use crate::body::{self, Body, OneBody};
use crate::curves::{self, ForceCurves, JointCurves};
use crate::draw::{self, Drawn, Side};
use crate::error::{ViewError, finite};
use crate::frames::{Frames, chosen};
use crate::members::Members;
use crate::pack::{Packed, floats, ranged, stepped};
use crate::skin::{self, Skin};
use crate::world::World;
use glam::{DQuat, DVec3};
use serde::Serialize;
use solaris_model::{ContactTrack, Figure, Link, Motion};

/// The floor, or where one would be.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Floor {
    /// m, relative to the origin.
    height: f64,
    solid: bool,
    /// Where it is not level: places along z and heights (m), relative to the origin.
    #[serde(skip_serializing_if = "Option::is_none")]
    relief: Option<Vec<[f64; 2]>>,
}

/// What the camera has in view.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Framed {
    /// Half of the edges of the box that it frames (m).
    half: [f64; 3],
    /// Middle of that box: m, three a frame, relative to the origin.
    aim: Packed,
}

/// A link on which the ground acts.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Foot {
    link: String,
    side: Side,
    /// Of the figure whose it is (N), where there are several.
    #[serde(skip_serializing_if = "Option::is_none")]
    weight: Option<f64>,
    /// N, three a frame.
    force: Packed,
    /// m, three a frame, relative to the origin.
    cop: Packed,
}

/// The object that stands in the page as JSON; see the crate's documentation.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Data {
    version: u32,
    pub(crate) figure: String,
    /// N, of the heaviest that touches something where there are several; none without mass or gravity.
    weight: Option<f64>,
    /// Where everything begins (m): whole metres, near the first frame, so that 32-bit floats do for a figure far away.
    origin: [f64; 3],
    /// Greatest edge of what the camera frames (m).
    size: f64,
    camera: Framed,
    ground: Floor,
    links: Vec<Drawn>,
    skins: Vec<Skin>,
    /// What is drawn of a person in place of the links' shapes.
    #[serde(skip_serializing_if = "Option::is_none")]
    body: Option<Body>,
    /// The same of several people.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    bodies: Vec<OneBody>,
    /// s.
    time: Packed,
    root: Packed,
    positions: Packed,
    turns: Packed,
    com: Option<Packed>,
    feet: Vec<Foot>,
    joints: Vec<JointCurves>,
    /// What the bands around the joints' curves are.
    #[serde(skip_serializing_if = "String::is_empty")]
    bands: String,
    forces: Vec<ForceCurves>,
    /// Whether anything has a side.
    #[serde(skip)]
    pub(crate) sided: bool,
}

/// Of the layout of [`Data`].
const VERSION: u32 = 2;
/// A step of a quaternion's component.
const TURN_STEP: f64 = 1.0 / 32_767.0;

impl Data {
    /// As it stands in the page.
    pub(crate) fn to_json(&self) -> String {
        serde_json::to_string(self).expect("plain data of finite numbers and text is always JSON")
    }
}

/// Gathers the data, and refuses what cannot be shown.
pub(crate) fn collect(figure: &Figure, motion: &Motion, options: &PageOptions) -> Result<Data, ViewError> {
    let bodies = body::bodies(&options.people);
    Ok(Data { body: body::body(figure), bodies, ..collect_bare(figure, motion, options)? })
}

/// The same without the skin of a person.
pub(crate) fn collect_bare(
    figure: &Figure,
    motion: &Motion,
    options: &PageOptions,
) -> Result<Data, ViewError> {
    motion.check_figure(figure)?;
    if motion.is_empty() {
        return Err(ViewError::Empty { figure: figure.name().to_owned() });
    }
    check_contacts(figure, motion)?;
    let world = World::new(&motion.info.gravity, options.forward.as_ref());
    let samples = chosen(motion);
    let mut links = draw::links(figure);
    draw::add_lines(&mut links, figure, &options.lines)?;
    let frames = Frames::new(figure, motion, &samples, &world, &links)?;
    let camera = frames.camera(motion.relief.is_some());
    // Adding zero turns -0 into 0.
    let origin = camera.aim[0].trunc() + DVec3::ZERO;
    let (members, gravity) = (Members::of(figure), motion.info.gravity.norm());
    let weight_of = |track: &ContactTrack| {
        let link = figure.link_index(&track.link).filter(|_| members.are_several())?;
        members.weight(members.of_link(link), gravity)
    };
    let turns: Vec<f64> = frames.turns.iter().flat_map(DQuat::to_array).collect();
    let mut forces = curves::forces(figure, motion, &samples, &world, &members);
    forces.extend(curves::others(motion, &samples, &options.curves)?);
    Ok(Data {
        version: VERSION,
        figure: figure.name().to_owned(),
        weight: members.greatest_weight(figure, motion),
        origin: origin.into(),
        size: camera.size(),
        camera: Framed { half: camera.half.into(), aim: floats(from(&camera.aim, origin)) },
        ground: Floor {
            height: motion.info.ground.map_or(frames.lowest(), |ground| ground.height) - origin.y,
            solid: motion.info.ground.is_some(),
            relief: motion.relief.as_ref().filter(|_| world.is_identity()).map(|relief| {
                relief.points().iter().map(|[z, height]| [z - origin.z, height - origin.y]).collect()
            }),
        },
        sided: links.iter().any(Drawn::is_sided),
        links,
        skins: skin::skins(figure),
        body: None,
        bodies: Vec::new(),
        time: floats(samples.iter().map(|&sample| motion.time()[sample])),
        root: floats(from(&frames.root, origin)),
        positions: ranged(&components(&frames.positions)),
        turns: stepped(&turns, TURN_STEP, 0.0),
        com: frames.com.as_ref().map(|com| ranged(&components(com))),
        feet: motion
            .contacts
            .iter()
            .map(|track| Foot { weight: weight_of(track), ..foot(track, &samples, &world, origin) })
            .collect(),
        joints: curves::joints(figure, motion, &samples, options)?,
        bands: options.bands.clone(),
        forces,
    })
}

fn components(vectors: &[DVec3]) -> Vec<f64> {
    vectors.iter().flat_map(DVec3::to_array).collect()
}

fn from(points: &[DVec3], origin: DVec3) -> impl Iterator<Item = f64> {
    points.iter().flat_map(move |point| (*point - origin).to_array())
}

fn foot(track: &ContactTrack, samples: &[usize], world: &World, origin: DVec3) -> Foot {
    let force: Vec<DVec3> =
        samples.iter().map(|&sample| world.vector(&track.samples[sample].force)).collect();
    let cop: Vec<DVec3> = samples.iter().map(|&sample| world.vector(&track.samples[sample].cop)).collect();
    let (side, _) = Side::split(&track.link);
    Foot {
        link: track.link.clone(),
        side,
        weight: None,
        force: ranged(&components(&force)),
        cop: floats(from(&cop, origin)),
    }
}

pub(crate) fn check_contacts(figure: &Figure, motion: &Motion) -> Result<(), ViewError> {
    for track in &motion.contacts {
        let link = || track.link.clone();
        if figure.link_index(&track.link).is_none() {
            let known = figure.links().iter().map(Link::name).collect::<Vec<_>>().join(", ");
            return Err(ViewError::UnknownLink { link: link(), figure: figure.name().to_owned(), known });
        }
        if track.samples.len() != motion.len() {
            let (found, expected) = (track.samples.len(), motion.len());
            return Err(ViewError::ContactLength { link: link(), found, expected });
        }
        for (contact, &time) in track.samples.iter().zip(motion.time()) {
            finite(|| format!("the force on '{}'", track.link), time, contact.force.as_slice())?;
            finite(|| format!("the centre of pressure of '{}'", track.link), time, contact.cop.as_slice())?;
        }
    }
    Ok(())
}

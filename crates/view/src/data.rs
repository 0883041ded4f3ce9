//! Everything that a page is told, as one object.

use crate::curves::{self, ForceCurves, JointCurves};
use crate::draw::{self, Drawn, Side, Skin};
use crate::error::{ViewError, finite};
use crate::frames::{Frames, chosen};
use crate::pack::{Packed, floats, ranged, stepped};
use crate::world::World;
use glam::{DQuat, DVec3};
use serde::Serialize;
use solaris_model::{ContactTrack, Figure, Link, Motion};

/// The floor, or where one would be.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Floor {
    height: f64,
    solid: bool,
}

/// A link on which the ground acts.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Foot {
    link: String,
    side: Side,
    /// N, three a frame.
    force: Packed,
    /// m, three a frame, not relative to the root.
    cop: Packed,
}

/// The object that stands in the page as JSON; see the crate's documentation.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct Data {
    version: u32,
    pub(crate) figure: String,
    /// N; none without mass or gravity.
    weight: Option<f64>,
    /// Height of the figure (m), for the camera.
    size: f64,
    /// Height of its middle in the first frame (m).
    middle: f64,
    ground: Floor,
    links: Vec<Drawn>,
    skins: Vec<Skin>,
    /// s.
    time: Packed,
    root: Packed,
    positions: Packed,
    turns: Packed,
    com: Option<Packed>,
    feet: Vec<Foot>,
    joints: Vec<JointCurves>,
    forces: Vec<ForceCurves>,
    /// Whether anything has a side.
    #[serde(skip)]
    pub(crate) sided: bool,
}

/// Of the layout of [`Data`].
const VERSION: u32 = 1;
/// A step of a quaternion's component.
const TURN_STEP: f64 = 1.0 / 32_767.0;
/// Figures smaller than this are seen from as far as one of this size (m).
const LEAST_SIZE: f64 = 0.05;

/// Gathers the data, and refuses what cannot be shown.
pub(crate) fn collect(figure: &Figure, motion: &Motion) -> Result<Data, ViewError> {
    motion.check_figure(figure)?;
    if motion.is_empty() {
        return Err(ViewError::Empty { figure: figure.name().to_owned() });
    }
    check_contacts(figure, motion)?;
    let world = World::new(&motion.info.gravity);
    let samples = chosen(motion);
    let frames = Frames::new(figure, motion, &samples, &world)?;
    let weight = Some(figure.mass() * motion.info.gravity.norm()).filter(|weight| *weight > 0.0);
    let links = draw::links(figure);
    let (low, high) = frames.first_heights;
    let turns: Vec<f64> = frames.turns.iter().flat_map(DQuat::to_array).collect();
    Ok(Data {
        version: VERSION,
        figure: figure.name().to_owned(),
        weight,
        size: (high - low).max(frames.extent()).max(LEAST_SIZE),
        middle: f64::midpoint(low, high),
        ground: motion.info.ground.map_or(Floor { height: frames.heights.0, solid: false }, |ground| Floor {
            height: ground.height,
            solid: true,
        }),
        sided: links.iter().any(Drawn::is_sided),
        links,
        skins: draw::skins(figure),
        time: floats(samples.iter().map(|&sample| motion.time()[sample])),
        root: floats(components(&frames.root)),
        positions: ranged(&components(&frames.positions)),
        turns: stepped(&turns, TURN_STEP, 0.0),
        com: frames.com.as_ref().map(|com| ranged(&components(com))),
        feet: motion.contacts.iter().map(|track| foot(track, &samples, &world)).collect(),
        joints: curves::joints(figure, motion, &samples)?,
        forces: curves::forces(motion, &samples, &world, weight),
    })
}

fn components(vectors: &[DVec3]) -> Vec<f64> {
    vectors.iter().flat_map(DVec3::to_array).collect()
}

fn foot(track: &ContactTrack, samples: &[usize], world: &World) -> Foot {
    let force: Vec<DVec3> =
        samples.iter().map(|&sample| world.vector(&track.samples[sample].force)).collect();
    let cop: Vec<DVec3> = samples.iter().map(|&sample| world.vector(&track.samples[sample].cop)).collect();
    let (side, _) = Side::split(&track.link);
    Foot { link: track.link.clone(), side, force: ranged(&components(&force)), cop: floats(components(&cop)) }
}

fn check_contacts(figure: &Figure, motion: &Motion) -> Result<(), ViewError> {
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

//! Binary glTF 2.0 (`.glb`): bodies with their animations, as game engines, browsers and 3D programs open them.
//!
//! Lengths are in metres, y is up and z forward (x left), glTF's own axes; a world with another "up" is turned as for BVH.
//!
//! - Each link is a node of its name, at its joint. Its rotation is animated, its translation where the joint slides.
//! - A figure that has a skin ([`solaris_skin::skin()`]) gets one mesh, bound to the nodes, with a small palette as its texture: clothes are
//!   repainted there.
//! - A [`Clip`] is an animation that moves one or several figures. It begins at 0 s. Keys are the motion's samples, and one more at each
//!   touch-down and lift-off between two of them, found from positions, velocities and accelerations on both sides, so that feet stand still from the
//!   instant on at which they do. Between keys glTF turns evenly. Rotations never change sign from key to key.
//! - A loop keeps its last key, which is its first one again: a player wraps where the last key is, and so shows it once.
//! - Rate and events of a clip stand in its `extras`.
//! - On request ([`Options::vrm`]) a file of one person on VRM's bones says so, by the extension `VRMC_vrm` (VRM 1.0).
//! - On request ([`Options::forces`]) there are nodes more: an arrow for each contact, 1 m for the body's weight, and a ball at the centre of
//!   mass.
//!
//! # Source
//!
//! Khronos, glTF 2.0 specification (2021).

mod accessor;
mod append;
mod body;
mod bones;
mod character;
mod container;
mod curves;
mod document;
mod extra;
mod fault;
pub(crate) mod keys;
mod nodes;
mod pack;
mod palette;
mod read;
mod skeleton;
mod vrm;

use crate::error::{ClipProblem, IoError};
pub use character::Character;
pub use fault::GlbError;
use pack::Pack;
pub use read::{animations, read};
use serde_json::{Value, json};
use skeleton::Skeleton;
pub(crate) use skeleton::local;
use solaris_model::{EventKind, Figure, Motion};
pub use solaris_skin::Detail;
use solaris_skin::Skin;
use std::io::Write;

/// A figure of a file.
#[derive(Clone, Copy, Debug)]
pub struct Actor<'a> {
    /// What it is called in the file.
    pub name: &'a str,
    /// Who it is.
    pub figure: &'a Figure,
    /// Its skin, where it has one that is not found from the figure, such as [`crate::rig::Rigged::skin`].
    pub skin: Option<&'a Skin>,
}

/// An animation of a file.
#[derive(Clone, Debug)]
pub struct Clip<'a> {
    /// What it is called in the file.
    pub name: &'a str,
    /// Whom it moves, by their places among the actors, and how.
    pub motions: Vec<(usize, &'a Motion)>,
}

/// What a file holds beside nodes and their animation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Options {
    /// How fine skins are; no skin at all where there is none.
    pub skin: Option<Detail>,
    /// Whether contacts have arrows and centres of mass balls.
    pub forces: bool,
    /// Whether the file says which node is which bone of a person, by VRM 1.0: for one actor whose links have VRM's names, as
    /// [`crate::rig::Rig::Vrm`] gives them. At rest its lowest point is at y = 0 then. The model's name is the actor's, its author
    /// Solaris, and the licence grants what it grants by default.
    pub vrm: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { skin: Some(Detail::Fine), forces: false, vrm: false }
    }
}

/// Writes `actors` and the `clips` that move them to `out`.
///
/// # Errors
///
/// A clip of an actor that is not there, of one twice or without frames; a motion of another figure; a number that is not finite;
/// [`IoError::Vrm`]; a file of more than 4 GB; and the writer's own errors.
///
/// ```
/// use solaris_io::glb::{self, Actor, Clip, Options};
/// use solaris_model::{Motion, MotionInfo, human};
///
/// let ann = human(1.65, 58.0)?;
/// let (q, v) = (vec![0.0; ann.layout().nq()], vec![0.0; ann.layout().nv()]);
/// let stands = Motion::new(&ann, MotionInfo::on_earth(&ann, 30.0), vec![0.0], [q, v.clone(), v])?;
/// let mut bytes = Vec::new();
/// let clip = Clip { name: "stands", motions: vec![(0, &stands)] };
/// glb::write(&[Actor { name: "Ann", figure: &ann, skin: None }], &[clip], Options::default(), &mut bytes)?;
/// assert!(bytes.starts_with(b"glTF"));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn write(
    actors: &[Actor],
    clips: &[Clip],
    options: Options,
    out: &mut impl Write,
) -> Result<(), IoError> {
    for clip in clips {
        check(clip, actors)?;
    }
    if options.vrm {
        vrm::check(actors)?;
    }
    let mut file = File::default();
    let mut skeletons = Vec::new();
    for (i, actor) in actors.iter().enumerate() {
        let first =
            clips.iter().flat_map(|clip| &clip.motions).find(|(who, _)| *who == i).map(|(_, motion)| *motion);
        let skeleton = Skeleton::new(&mut file, actor, first, options.vrm);
        if options.vrm {
            file.vrm = Some(vrm::extension(actor, &skeleton));
        }
        if let Some(detail) = options.skin {
            body::add(&mut file, actor, &skeleton, detail);
        }
        skeletons.push(skeleton);
    }
    for clip in clips {
        let mut animation = Animation::default();
        for (who, motion) in &clip.motions {
            let keys = keys::told_apart(keys::times(motion), motion.time()[0]);
            let figure = actors[*who].figure;
            skeletons[*who].animate(&mut file, &mut animation, figure, motion, &keys)?;
            if options.forces {
                extra::add(&mut file, &mut animation, actors[*who].name, figure, motion)?;
            }
        }
        // An animation without a channel is none.
        if !animation.channels.is_empty() {
            file.animations.push(json!({
                "name": clip.name,
                "channels": animation.channels,
                "samplers": animation.samplers,
                "extras": extras(clip),
            }));
        }
    }
    container::write(file, out)
}

fn check(clip: &Clip, actors: &[Actor]) -> Result<(), IoError> {
    let refuse = |problem| Err(IoError::Clip { clip: clip.name.to_owned(), problem });
    for (i, (actor, motion)) in clip.motions.iter().enumerate() {
        let Some(of) = actors.get(*actor) else {
            return refuse(ClipProblem::NoActor { actor: *actor, count: actors.len() });
        };
        if clip.motions[..i].iter().any(|(before, _)| before == actor) {
            return refuse(ClipProblem::Twice { actor: *actor });
        }
        if motion.is_empty() {
            return refuse(ClipProblem::Empty);
        }
        motion.check_figure(of.figure)?;
        let gravity = motion.info.gravity;
        if !gravity.iter().all(|g| g.is_finite()) {
            return Err(IoError::BvhUp { gravity });
        }
    }
    Ok(())
}

/// What a clip says of itself: its rate (1/s) and its contacts' events.
fn extras(clip: &Clip) -> Value {
    let of = |motion: &Motion| {
        let start = motion.time()[0];
        let event = |event: &solaris_model::Event| {
            let (kind, link) = match &event.kind {
                EventKind::TouchDown { link } => ("touch-down", link),
                EventKind::LiftOff { link } => ("lift-off", link),
                _ => return None,
            };
            Some(json!({ "time": event.time - start, "kind": kind, "link": link }))
        };
        motion.events.iter().filter_map(event).collect::<Vec<_>>()
    };
    match &clip.motions[..] {
        [(_, motion)] => json!({ "rate": motion.info.rate, "events": of(motion) }),
        [(_, motion), ..] => json!({ "rate": motion.info.rate }),
        [] => json!({}),
    }
}

/// The parts of a file, as they come together.
#[derive(Default)]
struct File {
    pack: Pack,
    /// Nodes that stand in the scene themselves.
    scene: Vec<usize>,
    nodes: Vec<Value>,
    meshes: Vec<Value>,
    skins: Vec<Value>,
    animations: Vec<Value>,
    materials: Vec<Value>,
    /// Whether a material takes the palette.
    palette: Option<usize>,
    /// Meshes of the extra nodes: arrow and ball.
    extra: Option<[usize; 2]>,
    /// What VRM adds.
    vrm: Option<Value>,
}

impl File {
    fn node(&mut self, node: Value) -> usize {
        self.nodes.push(node);
        self.nodes.len() - 1
    }

    /// The material with the palette, once for all.
    fn palette(&mut self) -> usize {
        *self.palette.get_or_insert_with(|| {
            self.materials.push(json!({
                "name": "palette",
                "pbrMetallicRoughness":
                    { "baseColorTexture": { "index": 0 }, "metallicFactor": 0.0, "roughnessFactor": 0.75 },
            }));
            self.materials.len() - 1
        })
    }
}

/// An animation, as it comes together.
#[derive(Default)]
struct Animation {
    channels: Vec<Value>,
    samplers: Vec<Value>,
}

impl Animation {
    /// Moves `path` of a node through the values of one accessor at the times of another.
    fn channel(&mut self, node: usize, path: &str, input: usize, output: usize) {
        self.channels
            .push(json!({ "sampler": self.samplers.len(), "target": { "node": node, "path": path } }));
        self.samplers.push(json!({ "input": input, "output": output, "interpolation": "LINEAR" }));
    }
}

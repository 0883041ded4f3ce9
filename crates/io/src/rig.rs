//! A person and a motion on the bones of an animator's rig: its names, its rest pose.
//!
//! The figure that comes of it has the same joints at the same places, whose links are called as the rig's bones are and whose frames
//! are turned so that **with all joints at zero it stands in the rig's rest pose**, every bone along the world's axes: x left, y up, z forward.
//! So retargeting by names from a T pose (or the A pose of Unreal) finds what it looks for. Joints turn by quaternions.
//!
//! | rig | names | rest |
//! |---|---|---|
//! | `Mixamo` | `mixamorig:LeftUpLeg` | T |
//! | `Vrm` | `leftUpperLeg` (VRM 1.0; [`crate::glb::Options::vrm`] writes its extension) | T |
//! | `Unreal` | `thigh_l` | A, arms 45° down |
//! | `Unity` | `LeftUpperLeg` (`HumanBodyBones`) | T |
//! | `Smpl` | `left_hip` | T |
//! | `Cmu` | `LeftUpLeg` (as the conversion of cgspeed has it) | T |
//!
//! A person here has two links between pelvis and neck, rigs three to five bones. The others are there, too: bones that never turn in
//! the one that they go on from, on the way to the next joint, and what hangs on that one hangs on the last of them.
//!
//! | rig | bones that never turn |
//! |---|---|
//! | `Mixamo` | `Spine2` in the thorax; the ends `HeadTop_End`, `LeftToe_End` |
//! | `Vrm`, `Unity` | `upperChest` in the thorax |
//! | `Unreal` | `spine_02` in the abdomen, `spine_04` and `spine_05` in the thorax, `neck_02` in the neck |
//! | `Smpl` | `spine2` in the abdomen; `left_hand` beyond the wrist |
//! | `Cmu` | `Spine` in the abdomen, `Neck1` in the neck |
//!
//! Fingers are missing. Local axes are the world's at rest, as VRM has it, not each program's own.

use crate::error::IoError;
use solaris_model::{
    Figure, FigureBuilder, Inertia, Isometry3, Joint, Known, LinkSpec, Motion, Placement, Shape,
    UnitQuaternion, Vector3,
};
use solaris_skin::{Detail, Skin, skin};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

/// A convention of names and rest pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs, reason = "their names say whose they are; the module's table has the rest")]
pub enum Rig {
    Mixamo,
    Vrm,
    Unreal,
    Unity,
    Smpl,
    Cmu,
}

/// Names of bones by the names of a human's links, a rig a column.
const NAMES: &str = include_str!("rig/names.csv");
/// Bones that rigs have beyond our links, from below up: each goes on from a link, at a share of the way to the joint of another
/// one or to its own tip.
const BETWEEN: &str = include_str!("rig/between.csv");

/// A bone that never turns.
struct Between {
    bone: &'static str,
    link: &'static str,
    toward: &'static str,
    share: f64,
}

impl Rig {
    /// All of them.
    pub const ALL: [Self; 6] = [Self::Mixamo, Self::Vrm, Self::Unreal, Self::Unity, Self::Smpl, Self::Cmu];

    /// What it is called: `mixamo`.
    pub fn name(self) -> &'static str {
        let heading = NAMES.lines().next().unwrap_or_default();
        heading.split(',').nth(1 + self as usize).unwrap_or_default()
    }

    /// What it calls a human's link.
    pub fn bone(self, link: &str) -> Option<&'static str> {
        let row = NAMES.lines().skip(1).find(|row| row.split(',').next() == Some(link))?;
        row.split(',').nth(1 + self as usize)
    }

    /// The bones that it has beyond a human's links.
    fn between(self) -> impl Iterator<Item = Between> {
        BETWEEN.lines().skip(1).filter_map(move |row| {
            let mut cells = row.split(',');
            let mut cell = || cells.next();
            let (rig, bone, link, toward, share) = (cell()?, cell()?, cell()?, cell()?, cell()?);
            (rig == self.name()).then_some(Between { bone, link, toward, share: share.parse().ok()? })
        })
    }

    /// How far arms are raised to the side at rest (rad).
    fn raised(self) -> f64 {
        if self == Self::Unreal { FRAC_PI_4 } else { FRAC_PI_2 }
    }
}

/// A figure on a rig's bones.
#[derive(Clone, Debug)]
pub struct Rigged {
    /// The figure: the person's links in their order, and the rig's other bones between them.
    pub figure: Figure,
    /// For each link of the person, the bone that it is, an index of a link of [`Rigged::figure`].
    pub bones: Vec<usize>,
    /// For each link, the turn from the new frame to the old one.
    turns: Vec<UnitQuaternion<f64>>,
}

impl Rigged {
    /// A person on the bones of `rig`.
    ///
    /// # Errors
    ///
    /// [`IoError::NotOfRigs`] names the first link that no human has.
    ///
    /// ```
    /// use solaris_io::rig::{Rig, Rigged};
    /// let ann = solaris_model::human(1.65, 58.0)?;
    /// let on = Rigged::new(&ann, Rig::Mixamo)?;
    /// let arm = on.figure.link("mixamorig:LeftForeArm").unwrap();
    /// // In a T pose the forearm goes on to the left.
    /// assert!((arm.joint().placement().translation.x - 0.267).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(figure: &Figure, rig: Rig) -> Result<Self, IoError> {
        let mut turns: Vec<UnitQuaternion<f64>> = Vec::new();
        let mut names = Vec::new();
        // The bone that goes on from each link, and where it is in the link's.
        let mut ends: Vec<(&str, Vector3<f64>)> = Vec::new();
        let mut builder = FigureBuilder::new(figure.name());
        for link in figure.links() {
            let name = rig.bone(link.name()).filter(|_| link.joint().placement().rotation.angle() < 1e-9);
            let Some(name) = name else {
                return Err(IoError::NotOfRigs { rig: rig.name(), link: link.name().to_owned() });
            };
            // What hangs on an arm that is raised is raised with it, and then stands along the world's axes.
            let raised = match link.name() {
                "left_upper_arm" => rig.raised(),
                "right_upper_arm" => -rig.raised(),
                _ => 0.0,
            };
            let rest = UnitQuaternion::from_scaled_axis(Vector3::z() * raised);
            let above = link.parent().map_or_else(UnitQuaternion::identity, |parent| turns[parent]);
            // With R the rest pose's rotation in the world, a bone's frame is the link's turned by R⁻¹.
            let turn = rest.inverse() * above;
            let at = above.inverse() * link.joint().placement().translation.vector;
            let spec = match link.parent() {
                None => LinkSpec::root(name, Joint::free("root").at(at)),
                Some(parent) => {
                    let (bone, end) = ends[parent];
                    LinkSpec::child(name, bone, Joint::ball(link.joint().name()).at(at - end))
                }
            };
            builder = builder.link(dressed(spec, link, &turn));
            let mut end = (name, Vector3::zeros());
            for between in rig.between().filter(|between| between.link == link.name()) {
                let Some(way) = way(figure, link, between.toward) else { continue };
                let at = turn.inverse() * way * between.share;
                let fixed = Joint::new(between.bone).at(at - end.1);
                builder = builder.link(LinkSpec::child(between.bone, end.0, fixed));
                end = (between.bone, at);
            }
            turns.push(turn);
            names.push(name);
            ends.push(end);
        }
        if let Some(stature) = figure.stature() {
            builder = builder.stature(stature);
        }
        let figure = builder.build()?;
        let bones = names.iter().filter_map(|name| figure.link_index(name)).collect();
        Ok(Self { figure, bones, turns })
    }

    /// A motion of the figure as it was, on the bones: the same places at the same times, with its contacts and events.
    ///
    /// # Errors
    ///
    /// A motion of another figure.
    pub fn motion(&self, figure: &Figure, motion: &Motion) -> Result<Motion, IoError> {
        motion.check_figure(figure)?;
        let (nq, nv) = (self.figure.layout().nq(), self.figure.layout().nv());
        let mut q = Vec::with_capacity(nq * motion.len());
        for sample in 0..motion.len() {
            let row = motion.q(sample);
            for ((i, link), at) in figure.links().iter().enumerate().zip(figure.layout().joints()) {
                let moved = link.joint().moved(&row[at.q..]);
                let above = link.parent().map_or_else(UnitQuaternion::identity, |parent| self.turns[parent]);
                if link.parent().is_none() {
                    q.extend(moved.translation.vector.iter());
                }
                let mut turn = above.inverse() * moved.rotation * self.turns[i];
                turn.renormalize();
                q.extend(turn.coords.iter());
            }
        }
        let info =
            solaris_model::MotionInfo { fingerprint: self.figure.fingerprint(), ..motion.info.clone() };
        let still = vec![0.0; nv * motion.len()];
        let columns = [q, still.clone(), still];
        let mut found =
            Motion::recorded(&self.figure, info, motion.time().to_vec(), columns, Known::none(nv))?;
        found.events.clone_from(&motion.events);
        found.planted = motion
            .planted
            .iter()
            .map(|planted| {
                let point = self.turns[planted.link].inverse() * planted.point;
                solaris_model::Interval { point, link: self.bones[planted.link], ..planted.clone() }
            })
            .collect();
        found.contacts.clone_from(&motion.contacts);
        for track in &mut found.contacts {
            if let Some(link) = figure.link_index(&track.link) {
                self.figure.links()[self.bones[link]].name().clone_into(&mut track.link);
            }
        }
        found.relief.clone_from(&motion.relief);
        Ok(found)
    }

    /// The skin of the figure as it was, bound to the bones in their rest pose, so that programs which take a skin's pose for the
    /// rest pose find it. About the shoulders it bends a little otherwise than before, for it was made with arms lower.
    pub fn skin(&self, figure: &Figure, detail: Detail) -> Skin {
        let mut skin = skin(figure, detail);
        let mut bind: Vec<Placement> = Vec::with_capacity(self.figure.links().len());
        for (i, link) in self.figure.links().iter().enumerate() {
            bind.push(match (self.bones.iter().position(|bone| *bone == i), link.parent()) {
                (Some(own), _) => skin.bind[own] * self.turns[own],
                (None, Some(parent)) => bind[parent] * link.joint().placement(),
                (None, None) => Placement::identity(),
            });
        }
        skin.bind = bind;
        for influence in skin.influences.iter_mut().flatten() {
            influence.link = self.bones[usize::from(influence.link)] as u16;
        }
        let mut q = vec![0.0; self.figure.layout().nq()];
        // The length is the figure's own.
        let _ = self.figure.neutral(&mut q);
        skin.rebound(&self.figure.places(&q))
    }
}

/// The way in a link's frame (m) from its joint to that of the link called `toward`, or to its own tip.
fn way(figure: &Figure, link: &solaris_model::Link, toward: &str) -> Option<Vector3<f64>> {
    if toward == "tip" {
        return link.tip().copied();
    }
    let next = &figure.links()[figure.link_index(toward)?];
    Some(next.joint().placement().translation.vector)
}

/// A link's own things in the new frame.
fn dressed(mut spec: LinkSpec, link: &solaris_model::Link, turn: &UnitQuaternion<f64>) -> LinkSpec {
    let back = turn.inverse();
    let matrix = back.to_rotation_matrix();
    let frame = Isometry3::from_parts(Vector3::zeros().into(), back);
    spec = spec.mass(link.mass()).com(back * link.com());
    spec = spec.inertia(Inertia::Tensor(matrix * link.inertia() * matrix.transpose()));
    if let Some(shape) = link.shape() {
        let placement: Placement = frame * shape.placement;
        spec = spec.shape(Shape { placement, ..*shape });
    }
    if let Some(tip) = link.tip() {
        spec = spec.tip(back * tip);
    }
    link.sole().iter().fold(spec, |spec, point| spec.sole(point.part, back * point.position))
}

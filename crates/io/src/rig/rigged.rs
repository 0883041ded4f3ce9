//! The figure on a rig's bones, its motions and its skin.

use super::RigMap;
use super::track::{self, track};
use super::twist::Limb;
use crate::error::IoError;
use solaris_model::{
    Figure, FigureBuilder, Inertia, Isometry3, Joint, Known, LinkSpec, Motion, Placement, Shape, Unit,
    UnitQuaternion, Vector3,
};
use solaris_retarget::Roll;
use solaris_skin::{Detail, Influence, Part, Skin, parts, skin};
use std::collections::HashSet;

/// A figure on a rig's bones.
#[derive(Clone, Debug)]
pub struct Rigged {
    /// The figure: the person's links in their order, and the rig's other bones between them and, of a rig that has a root on the ground, before them.
    pub figure: Figure,
    /// For each link of the person, the bone that it is, an index of a link of [`Rigged::figure`].
    pub bones: Vec<usize>,
    /// For each link, the turn from the new frame to the old one.
    turns: Vec<UnitQuaternion<f64>>,
    /// For each part of the skin the bone that it is, if it is one.
    parts: Vec<Option<usize>>,
    /// Limbs with bones of twist.
    limbs: Vec<Limb>,
    /// How high (m) the pelvis is above the bone on which it hangs, if it hangs on one.
    height: f64,
}

impl Rigged {
    /// A person on the bones of `rig`: a [`Rig`](super::Rig), or a [`RigMap`] of one's own.
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
    pub fn new(figure: &Figure, rig: impl Into<RigMap>) -> Result<Self, IoError> {
        let rig: RigMap = rig.into();
        let mut turns: Vec<UnitQuaternion<f64>> = Vec::new();
        // The rest pose's rotation of each link in the world, and its bone's frame there.
        let (mut rests, mut frames): (Vec<UnitQuaternion<f64>>, Vec<UnitQuaternion<f64>>) =
            Default::default();
        let mut names = Vec::new();
        // The bone that goes on from each link, and where it is in the link's.
        let mut ends: Vec<(&str, Vector3<f64>)> = Vec::new();
        let mut builder = FigureBuilder::new(figure.name());
        let parts = parts(figure);
        let mut made = HashSet::new();
        let root = rig.root();
        // At rest the soles are on the ground.
        let height = if root.is_some() { height(figure) } else { 0.0 };
        if let Some(root) = root {
            builder = builder.link(LinkSpec::root(root, Joint::new("track").tx().ty().tz().ry()));
        }
        for (index, link) in figure.links().iter().enumerate() {
            let name = rig.bone(link.name()).filter(|_| link.joint().placement().rotation.angle() < 1e-9);
            let Some(name) = name else {
                return Err(IoError::NotOfRigs { rig: rig.name(), link: link.name().to_owned() });
            };
            // What hangs on an arm that is raised is raised with it, and then stands along the world's axes.
            let raised = match link.name() {
                "left_upper_arm" => rig.rest().raised(),
                "right_upper_arm" => -rig.rest().raised(),
                _ => 0.0,
            };
            let above = |all: &[UnitQuaternion<f64>]| {
                link.parent().map_or_else(UnitQuaternion::identity, |parent| all[parent])
            };
            let rest = above(&rests) * UnitQuaternion::from_scaled_axis(Vector3::z() * raised);
            let axes = rig.axes(link.name());
            let frame = axes.map_or_else(UnitQuaternion::identity, |axes| {
                axes.frame(way(figure, link, axes.toward).map(|way| rest * way))
            });
            // With R the rest pose's rotation in the world and A the bone's there, the bone's frame is the link's turned by R⁻¹A.
            let turn = rest.inverse() * frame;
            let at = above(&turns).inverse() * link.joint().placement().translation.vector;
            let turned = above(&frames).inverse() * frame;
            let place = |at: Vector3<f64>| Placement::from_parts(at.into(), turned);
            let spec = match link.parent() {
                None => {
                    let joint = Joint::free("root");
                    match root {
                        None => LinkSpec::root(name, joint.placed(place(at))),
                        Some(root) => LinkSpec::child(name, root, joint.placed(place(Vector3::y() * height))),
                    }
                }
                Some(parent) => {
                    let (mut bone, end) = ends[parent];
                    if let Some(hook) = rig.hook(link.name()) {
                        builder = builder.link(LinkSpec::child(hook, bone, Joint::new(hook)));
                        bone = hook;
                    }
                    LinkSpec::child(name, bone, Joint::ball(link.joint().name()).placed(place(at - end)))
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
            for twist in rig.twists().filter(|twist| twist.link == link.name()) {
                let Some(way) = way(figure, link, twist.toward) else { continue };
                let ball = Joint::ball(twist.bone).at(turn.inverse() * way * twist.share);
                builder = builder.link(LinkSpec::child(twist.bone, name, ball));
            }
            for (i, part) in parts.iter().enumerate().filter(|(_, part)| part.link == index) {
                // One bone may be several parts: CMU's four fingers are one, from the first one's knuckle on.
                let Some(bone) = rig.part(&part.name).filter(|bone| made.insert(*bone)) else { continue };
                let of = |part: usize| {
                    let axes = rig.axes(finger(&parts[part].name)?)?;
                    Some(axes.frame(onward(&parts, part).map(|way| rest * way)))
                };
                // Where they are in the link's bone.
                let place = |i: usize| {
                    let turned = of(i).map_or_else(UnitQuaternion::identity, |own| frame.inverse() * own);
                    Placement::from_parts((turn.inverse() * parts[i].at).into(), turned)
                };
                let above = part.parent.and_then(|above| Some((rig.part(&parts[above].name)?, place(above))));
                // Thumbs hang on the hand itself, fingers on what goes on from it.
                let root = if part.name.contains("thumb") { (name, Vector3::zeros()) } else { end };
                let (parent, from) = above.unwrap_or((root.0, Placement::new(root.1, Vector3::zeros())));
                let fixed = Joint::new(bone).placed(from.inverse() * place(i));
                builder = builder.link(LinkSpec::child(bone, parent, fixed));
            }
            turns.push(turn);
            rests.push(rest);
            frames.push(frame);
            names.push(name);
            ends.push(end);
        }
        if let Some(stature) = figure.stature() {
            builder = builder.stature(stature);
        }
        let on = builder.build()?;
        let bones: Vec<usize> = names.iter().filter_map(|name| on.link_index(name)).collect();
        let parts = parts.iter().map(|part| on.link_index(rig.part(&part.name)?)).collect();
        let limbs = (0..bones.len()).filter_map(|link| limb(figure, &rig, &on, link, &bones)).collect();
        Ok(Self { figure: on, bones, turns, parts, limbs, height })
    }

    /// A motion of the figure as it was, on the bones: the same places at the same times, with its contacts and events.
    ///
    /// # Errors
    ///
    /// A motion of another figure.
    pub fn motion(&self, figure: &Figure, motion: &Motion) -> Result<Motion, IoError> {
        motion.check_figure(figure)?;
        let (nq, nv) = (self.figure.layout().nq(), self.figure.layout().nv());
        let mut q = vec![0.0; nq * motion.len()];
        let mut turned = vec![UnitQuaternion::identity(); figure.links().len()];
        let mut rolls = vec![[Roll::default(); 2]; self.limbs.len()];
        let joints = self.figure.layout().joints();
        let has_track = self.bones.first().is_some_and(|pelvis| *pelvis > 0);
        let track = if has_track { track(figure, motion) } else { Vec::new() };
        let back: Vec<UnitQuaternion<f64>> = self
            .bones
            .iter()
            .map(|bone| self.figure.links()[*bone].joint().placement().rotation.inverse())
            .collect();
        for (sample, bones) in q.chunks_exact_mut(nq).enumerate() {
            let row = motion.q(sample);
            for ((i, link), at) in figure.links().iter().enumerate().zip(figure.layout().joints()) {
                let moved = link.joint().moved(&row[at.q..]);
                let above = link.parent().map_or_else(UnitQuaternion::identity, |parent| self.turns[parent]);
                let mut turn = above.inverse() * moved.rotation * self.turns[i];
                let mut first = joints[self.bones[i]].q;
                if link.parent().is_none() {
                    let mut place = moved.translation.vector;
                    if let Some(&[x, y, z, heading]) = track.get(sample) {
                        bones[..4].copy_from_slice(&[x, y, z, heading]);
                        let ahead = UnitQuaternion::from_scaled_axis(Vector3::y() * -heading);
                        let at = link.joint().placement().translation.vector;
                        place = ahead * (place + at - Vector3::new(x, y, z)) - Vector3::y() * self.height;
                        turn = ahead * turn;
                    }
                    bones[first..first + 3].copy_from_slice((back[i] * place).as_slice());
                    first += 3;
                }
                turn = back[i] * turn;
                turn.renormalize();
                turned[i] = turn;
                bones[first..first + 4].copy_from_slice(turn.coords.as_slice());
            }
            let time = motion.time();
            let dt = sample.checked_sub(1).map_or(0.0, |before| time[sample] - time[before]);
            for (limb, rolls) in self.limbs.iter().zip(&mut rolls) {
                for (bone, turn) in limb.turns(&turned, rolls, dt) {
                    let first = joints[bone].q;
                    bones[first..first + 4].copy_from_slice(turn.coords.as_slice());
                }
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

    /// The skin of the figure as it was, its fingers and eyes on the rig's bones for them, bound to the bones in their rest pose, so that programs which take a skin's pose for the
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
        // Parts that are bones here take their vertices; the others' stay with their links.
        for (vertex, with) in std::mem::take(&mut skin.fine) {
            let own = |i: Influence| {
                let link = usize::from(i.link);
                let bone = match link.checked_sub(self.bones.len()) {
                    None => self.bones[link],
                    Some(part) => self.parts[part].unwrap_or(self.bones[skin.parts[part].link]),
                };
                Influence { link: bone as u16, ..i }
            };
            skin.influences[vertex as usize] = greatest(with.into_iter().map(own));
        }
        skin.parts.clear();
        let mut skin = skin.rebound(&at_rest(&self.figure));
        self.share_twists(&mut skin);
        skin
    }

    /// Gives bones of twist what they have of a skin that is bound at rest.
    fn share_twists(&self, skin: &mut Skin) {
        if self.limbs.is_empty() {
            return;
        }
        for (point, influences) in skin.points.iter().zip(&mut skin.influences) {
            let shared = influences.iter().flat_map(|i| {
                match self.limbs.iter().find(|limb| limb.bone == usize::from(i.link)) {
                    Some(limb) => {
                        let bind = &skin.bind[limb.bone];
                        let from_joint = bind.rotation.inverse() * (point - bind.translation.vector);
                        limb.shared(&from_joint, i.share)
                    }
                    None => [*i, Influence::default()],
                }
            });
            *influences = greatest(shared);
        }
    }
}

/// The four greatest of some influences, those of one bone as one, together as much as all.
fn greatest(influences: impl Iterator<Item = Influence>) -> [Influence; 4] {
    let mut merged: Vec<Influence> = Vec::with_capacity(8);
    let mut all = 0.0;
    for i in influences.filter(|i| i.share > 0.0) {
        all += i.share;
        match merged.iter_mut().find(|other| other.link == i.link) {
            Some(other) => other.share += i.share,
            None => merged.push(i),
        }
    }
    merged.sort_by(|a, b| b.share.total_cmp(&a.share));
    merged.resize(4, Influence::default());
    let four = [merged[0], merged[1], merged[2], merged[3]];
    let kept: f32 = four.iter().map(|i| i.share).sum();
    let factor = if kept > 0.0 && kept < all { all / kept } else { 1.0 };
    four.map(|i| Influence { share: i.share * factor, ..i })
}

/// How high (m) above the ground the pelvis is where somebody stands at rest.
fn height(figure: &Figure) -> f64 {
    let places = at_rest(figure);
    track::lowest(figure, &places).map_or(0.0, |lowest| places[0].translation.y - lowest)
}

/// Where all links are in the rest pose.
fn at_rest(figure: &Figure) -> Vec<Placement> {
    let mut q = vec![0.0; figure.layout().nq()];
    // The length is the figure's own.
    let _ = figure.neutral(&mut q);
    figure.places(&q)
}

/// A person's link as a limb, if the rig has bones of twist in it.
fn limb(figure: &Figure, rig: &RigMap, on: &Figure, link: usize, bones: &[usize]) -> Option<Limb> {
    let name = figure.links()[link].name();
    let toward = rig.twists().find(|twist| twist.link == name)?.toward;
    let next = figure.link_index(toward)?;
    let twists = rig.twists().filter(|twist| twist.link == name);
    let twists = twists.filter_map(|twist| Some((on.link_index(twist.bone)?, twist.share))).collect();
    let place = on.links()[bones[next]].joint().placement();
    // What has no length turns about nothing.
    let (axis, length) = Unit::try_new_and_get(place.translation.vector, 1e-9)?;
    let next_axis = place.rotation.inverse() * axis;
    let is_last = ["hand", "foot"].iter().any(|end| toward.ends_with(end));
    Some(Limb { link, next, bone: bones[link], axis, next_axis, length, twists, is_last })
}

/// What [`RigMap::axes`] calls the bones of this part of the skin, if it is one of a finger.
fn finger(part: &str) -> Option<&'static str> {
    let is_eye = part.ends_with("eye");
    let sides = [("left_", "left_finger"), ("right_", "right_finger")];
    sides.into_iter().find(|(side, _)| part.starts_with(side) && !is_eye).map(|(_, name)| name)
}

/// The way in the link's frame (m) from a part's joint to the next part's; of the last one the way to it.
fn onward(parts: &[Part], part: usize) -> Option<Vector3<f64>> {
    let next = parts.iter().find(|next| next.parent == Some(part));
    match next {
        Some(next) => Some(next.at - parts[part].at),
        None => Some(parts[part].at - parts[parts[part].parent?].at),
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

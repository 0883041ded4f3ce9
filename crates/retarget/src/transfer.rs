//! The transfer: each bone of the target turns from its rest pose as the source's did from its own.

use crate::align::alignments;
use crate::error::RetargetError;
use crate::feet::{Sole, leg};
use crate::heading::heading;
use crate::planted::runs;
use crate::replant::{Footing, replant, stance_count};
use crate::roles::Roles;
use crate::skeleton::Skeleton;
use crate::take::Take;
use crate::twist::Twist;
use solaris_model::{Placement, UnitQuaternion, Vector3};
use std::ops::Range;

/// What was done about the feet.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Replanted {
    /// Leg of the target over that of the source: how much farther its hips go.
    pub scale: f64,
    /// How many times a foot stands.
    pub stances: usize,
    /// Whether legs and feet are alike but for their size, so that nothing was to be planted anew.
    pub is_alike: bool,
    /// How fast the ground goes by on the target, where the clip is one in place (m/s); else zero.
    pub belt: f64,
    /// How far a point that stands is from its mean place on the target, at the most, seen from that ground (m).
    pub slide: f64,
    /// The same in the source (m).
    pub slid: f64,
    /// By how much legs were turned at the hip so that feet stand, at the most (rad).
    pub hip: f64,
    /// By how much at the knee, at the most (rad).
    pub knee: f64,
    /// By how much the pelvis was lowered so that legs reach, at the most (m).
    pub lowered: f64,
}

/// A motion on another skeleton.
#[derive(Clone, Debug)]
pub struct Moved {
    /// Times of the frames (s).
    pub time: Vec<f64>,
    /// Bones that turn, each with the rotation of its frame in that of its parent, frame by frame.
    pub turns: Vec<(usize, Vec<UnitQuaternion<f64>>)>,
    /// The bone that carries all others, and where it is in the world (m), frame by frame.
    pub root: (usize, Vec<Vector3<f64>>),
    /// What was done about the feet.
    pub replanted: Replanted,
}

impl Moved {
    /// Leaves out all frames but these.
    fn keep(&mut self, frames: Range<usize>) {
        self.time = self.time[frames.clone()].to_vec();
        for (_, turns) in &mut self.turns {
            *turns = turns[frames.clone()].to_vec();
        }
        self.root.1 = self.root.1[frames].to_vec();
    }
}

/// Puts a motion onto a skeleton.
///
/// Both stand in their rest poses, in frames x left, y up, z forward that their hips and feet show. A bone with rotation `R` of
/// the source, `R₀` at rest, turns the target's bone, `S₀` at rest, to
///
/// ```text
/// S = R·R₀⁻¹ · A·S₀
/// ```
///
/// where `A` makes the rest poses alike: it lets arms, thighs and shanks point as the source's do, so that of a T pose the arms do not hang 45° off in
/// an A pose, and turns feet about the vertical alone, so that soles stay flat. Local axes and their roll do not matter. Where trunk or neck have other
/// numbers of bones, the turn of n bones, evenly one after the other, is shared out among m. Twist bones between two joints of a limb share out how it turns
/// about its own axis, by how far along they are. What else has no role stays in its parent as it is at rest.
///
/// The middle of the hips goes as far as the source's, times the legs' ratio, and is as much lower than on straight legs. Where legs
/// or feet are not alike, feet are planted anew: while a point of a sole (heel, ball or tip) stands in the source, it stands on the target, the foot
/// rolling over them in turn; the foot keeps its rotation, and knee and hip bring the ankle to its place. In between the difference goes over
/// smoothly. Where legs would not reach, the pelvis is lowered. What ends in the posture in which it begins does so on the target, too, and so does what
/// ends a frame before it. Who walks in place has ground that goes by: where the feet hardly ever stand, but do on ground of one velocity, they stand on that,
/// times the legs' ratio.
///
/// # Errors
///
/// A target that does not stand in its rest pose.
pub fn retarget(given: &Take, onto: &Skeleton, roles: &Roles) -> Result<Moved, RetargetError> {
    let rounds = given.rounds();
    let take = rounds.as_ref().map_or(given, |(rounds, _)| rounds);
    let turn = heading(onto, roles)?;
    let rest: Vec<Placement> = onto.bones.iter().map(|bone| turn * bone.rest).collect();
    let from: Vec<Placement> = take.skeleton.bones.iter().map(|bone| take.heading * bone.rest).collect();
    let aligned = alignments((&take.roles, &from), (roles, &rest));
    let drives = drives(&take.roles, roles);
    let mover = mover(onto, roles, &drives);
    let scale = leg(onto, roles) / leg(&take.skeleton, &take.roles);
    let body = Body { skeleton: onto, roles, rest: &rest, mover, carried: onto.below(mover) };
    let soles = Sole::both(onto, roles, &turn);
    let footing = Footing::of(take, &soles, scale);
    let mut driven: Vec<Vec<Option<UnitQuaternion<f64>>>> = Vec::with_capacity(take.len());
    let mut hips = Vec::with_capacity(take.len());
    for places in &take.frames {
        let delta = |bone: usize| places[bone].rotation * from[bone].rotation.inverse();
        let mut turns = vec![None; onto.bones.len()];
        for (bone, drive) in &drives {
            let align = aligned[*bone].unwrap_or_else(UnitQuaternion::identity);
            turns[*bone] = Some(drive.turn(delta) * align * rest[*bone].rotation);
        }
        if mover != roles.pelvis {
            turns[mover] = Some(delta(take.roles.pelvis) * rest[mover].rotation);
        }
        driven.push(turns);
        hips.push(footing.place(&middle(&take.roles, places)));
    }
    let replanted = replant(take, &body, &soles, &footing, &mut driven, &mut hips);
    let mut twists = driven.first().map_or(Vec::new(), |driven| Twist::all(onto, roles, &rest, driven));
    if !twists.is_empty() {
        let mut before = take.time[0];
        for ((turns, hips), time) in driven.iter_mut().zip(&hips).zip(&take.time) {
            let places = body.places(turns, hips);
            for (bone, turn) in twists.iter_mut().map(|twist| twist.turn(&rest, &places, time - before)) {
                turns[bone] = Some(turn);
            }
            before = *time;
        }
    }
    let mut moved = moved(take, &body, &turn, &driven, &hips, replanted);
    if let Some((rounds, round)) = &rounds {
        let middle = *round..round + given.len();
        moved.keep(middle.clone());
        moved.time.clone_from(&given.time);
        moved.replanted.stances = stance_count(&rounds.stands[middle]);
    }
    if let Some(belt) = &given.belt {
        let back = |way: Vector3<f64>| turn.inverse() * (way * scale);
        for (time, place) in moved.time.iter().zip(&mut moved.root.1) {
            *place += back(belt.way(*time));
        }
        moved.replanted.belt = scale * belt.velocity.norm();
    }
    Ok(moved)
}

/// The target as its bones are turned.
pub(crate) struct Body<'a> {
    pub(crate) skeleton: &'a Skeleton,
    pub(crate) roles: &'a Roles,
    /// Places at rest in the frame of the heading.
    pub(crate) rest: &'a [Placement],
    /// The bone that carries all that have roles.
    pub(crate) mover: usize,
    /// Whether it carries a bone, or is it.
    pub(crate) carried: Vec<bool>,
}

impl Body<'_> {
    /// Where all bones are with these turned so and the middle of the hips at a place (m): what is not turned keeps its place in its parent.
    pub(crate) fn places(
        &self,
        turns: &[Option<UnitQuaternion<f64>>],
        hips: &Vector3<f64>,
    ) -> Vec<Placement> {
        let mut places: Vec<Placement> = Vec::with_capacity(turns.len());
        for (i, (bone, turn)) in self.skeleton.bones.iter().zip(turns).enumerate() {
            let mut place = match bone.parent {
                Some(parent) => places[parent] * (self.rest[parent].inverse() * self.rest[i]),
                None => self.rest[i],
            };
            if let Some(turn) = turn {
                place.rotation = *turn;
            }
            places.push(place);
        }
        let shift = hips - middle(self.roles, &places);
        for i in 0..places.len() {
            if self.carried[i] {
                places[i].translation.vector += shift;
            }
        }
        places
    }
}

/// The middle between the hips (m).
pub(crate) fn middle(roles: &Roles, places: &[Placement]) -> Vector3<f64> {
    let [left, right] = roles.sides.map(|limbs| places[limbs.thigh].translation.vector);
    (left + right) / 2.0
}

/// What turns a bone: the turns of the source's bones one after the other, and how far on along them.
struct Drive {
    knots: Vec<usize>,
    on: f64,
}

impl Drive {
    fn turn(&self, delta: impl Fn(usize) -> UnitQuaternion<f64>) -> UnitQuaternion<f64> {
        let at = self.on.clamp(0.0, 1.0) * (self.knots.len() - 1) as f64;
        let (knot, part) = (at.floor() as usize, at.fract());
        let from = delta(self.knots[knot]);
        // Whole numbers are bones themselves, to the bit.
        if part < 1e-9 {
            return from;
        }
        let to = delta(self.knots[knot + 1]);
        if part > 1.0 - 1e-9 { to } else { from.try_slerp(&to, part, 1e-12).unwrap_or(from) }
    }
}

/// What turns each bone of the target that has a role that the source has, too.
fn drives(from: &Roles, onto: &Roles) -> Vec<(usize, Drive)> {
    let one = |bone: usize| Drive { knots: vec![bone], on: 0.0 };
    let mut drives = vec![(onto.pelvis, one(from.pelvis))];
    let chain = |bones: &[usize], first: usize, knots: &[usize], drives: &mut Vec<(usize, Drive)>| {
        let knots: Vec<usize> = std::iter::once(first).chain(knots.iter().copied()).collect();
        for (i, bone) in bones.iter().enumerate() {
            drives.push((*bone, Drive { knots: knots.clone(), on: (i + 1) as f64 / bones.len() as f64 }));
        }
    };
    chain(&onto.trunk, from.pelvis, &from.trunk, &mut drives);
    let chest = from.trunk.last().copied().unwrap_or(from.pelvis);
    match from.head {
        // A neck that the source lacks goes half with its head.
        Some(head) if from.neck.is_empty() => {
            for (i, bone) in onto.neck.iter().enumerate() {
                let on = (i + 1) as f64 / (onto.neck.len() + 1) as f64;
                drives.push((*bone, Drive { knots: vec![chest, head], on }));
            }
        }
        _ => chain(&onto.neck, chest, &from.neck, &mut drives),
    }
    if let Some(head) = onto.head {
        drives.push((head, one(from.head.or(from.neck.last().copied()).unwrap_or(chest))));
    }
    for (source, target) in from.sides.iter().zip(&onto.sides) {
        let pairs = [
            (target.clavicle, source.clavicle),
            (target.upper_arm, source.upper_arm),
            (target.forearm, source.forearm),
            (target.hand, source.hand),
            (Some(target.thigh), Some(source.thigh)),
            (Some(target.shank), Some(source.shank)),
            (Some(target.foot), Some(source.foot)),
            (target.toes, source.toes),
        ];
        drives.extend(pairs.into_iter().filter_map(|(bone, by)| Some((bone?, one(by?)))));
    }
    drives
}

/// The lowest bone above all that turn.
fn mover(skeleton: &Skeleton, roles: &Roles, drives: &[(usize, Drive)]) -> usize {
    let common = drives.iter().try_fold(roles.pelvis, |above, (bone, _)| skeleton.common(above, *bone));
    common.unwrap_or(roles.pelvis)
}

/// The rotations in the parents' frames and the way through the world.
fn moved(
    take: &Take,
    body: &Body,
    turn: &UnitQuaternion<f64>,
    driven: &[Vec<Option<UnitQuaternion<f64>>>],
    hips: &[Vector3<f64>],
    mut replanted: Replanted,
) -> Moved {
    let soles = Sole::both(body.skeleton, body.roles, turn);
    let bones: Vec<usize> = (0..body.rest.len()).filter(|i| driven[0][*i].is_some()).collect();
    let mut turns: Vec<(usize, Vec<UnitQuaternion<f64>>)> =
        bones.iter().map(|bone| (*bone, Vec::with_capacity(hips.len()))).collect();
    let mut root = Vec::with_capacity(hips.len());
    let mut points = Vec::with_capacity(hips.len());
    for (driven, hips) in driven.iter().zip(hips) {
        let places = body.places(driven, hips);
        for (bone, turns) in &mut turns {
            // The heading's turn stands before both and falls out, but for a bone with nothing above.
            let above = body.skeleton.bones[*bone].parent.map_or(*turn, |parent| places[parent].rotation);
            let mut local = above.inverse() * places[*bone].rotation;
            local.renormalize();
            let flips = turns
                .last()
                .is_some_and(|before: &UnitQuaternion<f64>| before.coords.dot(&local.coords) < 0.0);
            turns.push(if flips { UnitQuaternion::new_unchecked(-local.into_inner()) } else { local });
        }
        root.push(turn.inverse() * places[body.mover].translation.vector);
        points.push(soles.each_ref().map(|sole| sole.at(&places)));
    }
    replanted.slide = slide(take, &points);
    let source = |places: &Vec<Placement>| take.soles.each_ref().map(|sole| sole.at(places));
    replanted.slid = slide(take, &take.frames.iter().map(source).collect::<Vec<_>>());
    Moved { time: take.time.clone(), turns, root: (body.mover, root), replanted }
}

/// How far points are from their mean places while they stand, at the most (m).
fn slide(take: &Take, points: &[[[Vector3<f64>; 3]; 2]]) -> f64 {
    let mut slide = 0.0;
    for (side, i) in (0..6).map(|k| (k / 3, k % 3)) {
        for run in runs(points.len(), |frame| take.stands[frame][side][i]) {
            let of = run.clone().map(|frame| points[frame][side][i]);
            let mean = of.clone().sum::<Vector3<f64>>() / run.len() as f64;
            slide = of.map(|point| (point - mean).norm()).fold(slide, f64::max);
        }
    }
    slide
}

//! Feet that stand where the source's stood, on legs of other lengths.

use crate::feet::{Sole, leg};
use crate::legs::{Bent, bend};
use crate::planted::{Stands, runs};
use crate::roles::Limbs;
use crate::take::Take;
use crate::transfer::{Body, Replanted, middle};
use solaris_model::{Placement, UnitQuaternion, Vector3};
use std::ops::Range;

/// Lengths of legs and feet (of the leg) that differ by less are alike: digits of files.
const ALIKE: f64 = 1e-4;
/// Points that move less from frame to frame (m) stand equally still.
const STILLEST: f64 = 1e-5;
/// How long a leg may be stretched, of its length: a knee that is quite straight snaps.
const STRETCH: f64 = 0.9995;
/// Over which time on both sides the pelvis comes down for a leg that does not reach (s).
const EASE: f64 = 0.12;

/// How places of the source become places of the target.
pub(crate) struct Footing {
    scale: f64,
    /// The floor of the source's motion (m), and the target's at rest.
    floors: [f64; 2],
    /// Heights of the ankles over the floor at rest (m).
    ankles: [f64; 2],
}

impl Footing {
    pub(crate) fn of(take: &Take, soles: &[Sole; 2], scale: f64) -> Self {
        let mean = |soles: &[Sole; 2]| f64::midpoint(soles[0].ankle, soles[1].ankle);
        Self { scale, floors: [floor(take), soles[0].ground], ankles: [mean(&take.soles), mean(soles)] }
    }

    /// Where a place of the leg is: as much lower than where it is in somebody who stands on straight legs, times the legs' ratio.
    pub(crate) fn place(&self, place: &Vector3<f64>) -> Vector3<f64> {
        let [from, onto] = [0, 1].map(|i| self.floors[i] + self.ankles[i]);
        Vector3::new(self.scale * place.x, onto + self.scale * (place.y - from), self.scale * place.z)
    }

    /// The height of the ground that is at `height` in the source.
    fn ground(&self, height: f64) -> f64 {
        self.floors[1] + self.scale * (height - self.floors[0])
    }
}

/// Where the lowest point of the soles stands; where none stands, is.
fn floor(take: &Take) -> f64 {
    let points: Vec<_> =
        take.frames.iter().map(|places| take.soles.each_ref().map(|sole| sole.at(places))).collect();
    let mut floor = f64::INFINITY;
    for side in 0..2 {
        for i in 0..3 {
            for run in runs(points.len(), |frame| take.stands[frame][side][i]) {
                let heights = run.clone().map(|frame| points[frame][side][i].y);
                floor = floor.min(heights.sum::<f64>() / run.len() as f64);
            }
        }
    }
    if floor.is_finite() {
        return floor;
    }
    points.iter().flatten().flatten().map(|point| point.y).fold(f64::INFINITY, f64::min)
}

/// Turns the legs of the target and lowers its hips so that what stands in the source stands.
pub(crate) fn replant(
    take: &Take,
    body: &Body,
    soles: &[Sole; 2],
    footing: &Footing,
    driven: &mut [Vec<Option<UnitQuaternion<f64>>>],
    hips: &mut [Vector3<f64>],
) -> Replanted {
    let stances = [0, 1].map(|side| stances(take, side));
    let count = stance_count(&take.stands);
    let is_alike = alike(take, body, soles, footing.scale);
    let mut done = Replanted { scale: footing.scale, stances: count, is_alike, ..Replanted::default() };
    if is_alike || count == 0 {
        return done;
    }
    let mut frames: Vec<Vec<Placement>> =
        driven.iter().zip(hips.iter()).map(|(turns, hips)| body.places(turns, hips)).collect();
    let ankles = [0, 1].map(|side| wanted(take, soles, footing, side, &stances[side], &frames));
    // All of it goes up or down by so much that legs are on the whole as straight as they were, whatever the soles are like.
    let up = Vector3::y() * rise(take, soles, &ankles, &frames);
    for hips in hips.iter_mut() {
        *hips += up;
    }
    for place in frames.iter_mut().flatten() {
        place.translation.vector += up;
    }
    let reach = STRETCH * leg(body.skeleton, body.roles);
    let lower = |frame: usize| {
        let of = |side: usize| {
            let hip = frames[frame][body.roles.sides[side].thigh].translation.vector;
            let stands = take.stands[frame][side].contains(&true);
            if stands { needed(&(ankles[side][frame] - hip), reach) } else { 0.0 }
        };
        of(0).max(of(1))
    };
    let lower = eased(&take.time, &(0..frames.len()).map(lower).collect::<Vec<_>>());
    for frame in 0..frames.len() {
        let down = Vector3::y() * lower[frame];
        done.lowered = done.lowered.max(lower[frame]);
        hips[frame] -= down;
        for (side, limbs) in body.roles.sides.iter().enumerate() {
            let ankle = ankles[side][frame] + down;
            let Bent { knee, hip } = bent(body, limbs, &frames[frame], &ankle);
            (done.knee, done.hip) = (done.knee.max(knee.angle()), done.hip.max(hip.angle()));
            let turns = &mut driven[frame];
            turns[limbs.thigh] = turns[limbs.thigh].map(|turn| hip * turn);
            turns[limbs.shank] = turns[limbs.shank].map(|turn| hip * knee * turn);
        }
    }
    done
}

/// How much higher ankles have to be than they would be, on the mean of all that stand (m).
fn rise(take: &Take, soles: &[Sole; 2], ankles: &[Vec<Vector3<f64>>; 2], frames: &[Vec<Placement>]) -> f64 {
    let stands = (0..2).flat_map(|side| (0..frames.len()).map(move |frame| (side, frame)));
    let stands = stands.filter(|(side, frame)| take.stands[*frame][*side].contains(&true));
    let higher = |(side, frame): (usize, usize)| {
        ankles[side][frame].y - frames[frame][soles[side].foot].translation.vector.y
    };
    let (sum, count) = stands.map(higher).fold((0.0, 0.0), |(sum, count), more| (sum + more, count + 1.0));
    sum / f64::max(count, 1.0)
}

/// How the leg is bent so that its ankle, in the frame in which the hips are where they were, is at a place (m).
fn bent(body: &Body, limbs: &Limbs, places: &[Placement], ankle: &Vector3<f64>) -> Bent {
    let at = |bone: usize| places[bone].translation.vector;
    let (thigh, shank) = (at(limbs.shank) - at(limbs.thigh), at(limbs.foot) - at(limbs.shank));
    // The knee's axis points left at rest, and goes with the thigh from there; at rest it stands square on the leg.
    let rest = |bone: usize| body.rest[bone].translation.vector;
    let along = rest(limbs.shank) - rest(limbs.thigh);
    let left = Vector3::x() - along * (along.x / along.norm_squared());
    let axis = places[limbs.thigh].rotation * (body.rest[limbs.thigh].rotation.inverse() * left);
    bend(&thigh, &shank, &axis.normalize(), &(ankle - at(limbs.thigh)))
}

/// How many times a foot stands.
pub(crate) fn stance_count(stands: &[[Stands; 2]]) -> usize {
    [0, 1].map(|side| runs(stands.len(), |frame| stands[frame][side].contains(&true)).count()).iter().sum()
}

/// The stretches of frames in which a foot stands on any point.
fn stances(take: &Take, side: usize) -> Vec<Range<usize>> {
    runs(take.len(), |frame| take.stands[frame][side].contains(&true)).collect()
}

/// Whether legs and feet are those of the source, times the ratio.
fn alike(take: &Take, body: &Body, soles: &[Sole; 2], scale: f64) -> bool {
    let from: Vec<Placement> = take.skeleton.bones.iter().map(|bone| take.heading * bone.rest).collect();
    // By joints alone: of soles one may know the surface, the other not.
    let has_toes = take.roles.sides.iter().chain(&body.roles.sides).all(|limbs| limbs.toes.is_some());
    let lengths = |limbs: &Limbs, places: &[Placement], hips: &Vector3<f64>, sole: &Sole| {
        let at = |bone: usize| places[bone].translation.vector;
        let ball = limbs.toes.filter(|_| has_toes).map_or((places[sole.toes] * sole.points[1]).coords, at);
        let hip = at(limbs.thigh) - hips;
        let foot = ball - at(limbs.foot);
        let (thigh, shank) =
            ((at(limbs.shank) - at(limbs.thigh)).norm(), (at(limbs.foot) - at(limbs.shank)).norm());
        [hip.x, hip.y, hip.z, thigh, shank, foot.z, foot.y]
    };
    let tolerance = ALIKE * leg(body.skeleton, body.roles);
    (0..2).all(|side| {
        let own = lengths(&body.roles.sides[side], body.rest, &middle(body.roles, body.rest), &soles[side]);
        let other = lengths(&take.roles.sides[side], &from, &middle(&take.roles, &from), &take.soles[side]);
        own.iter().zip(other).all(|(own, other)| (own - scale * other).abs() < tolerance)
    })
}

/// Where an ankle has to be (m) so that what stands in the source stands: during a stance the foot rolls over the points that stand, each at its
/// place; before and after, and in between, what that differs by from where the ankle would be goes over smoothly.
fn wanted(
    take: &Take,
    soles: &[Sole; 2],
    footing: &Footing,
    side: usize,
    stances: &[Range<usize>],
    frames: &[Vec<Placement>],
) -> Vec<Vector3<f64>> {
    let sole = &soles[side];
    let ankle = |frame: usize| frames[frame][sole.foot].translation.vector;
    // Heel, ball and tip as seen from the ankle, which no leg changes.
    let offset = |frame: usize| sole.at(&frames[frame]).map(|point| point - ankle(frame));
    let mut off: Vec<Vector3<f64>> = vec![Vector3::zeros(); frames.len()];
    for stance in stances {
        let mut path = vec![ankle(stance.start)];
        for frame in stance.start + 1..stance.end {
            let (before, now) = (offset(frame - 1), offset(frame));
            let stand = [take.stands[frame - 1][side], take.stands[frame][side]];
            let both = (0..3).any(|i| stand[0][i] && stand[1][i]);
            let source = [frame - 1, frame].map(|frame| take.soles[side].at(&take.frames[frame]));
            // Of points that stand, those that stand stillest count: the foot rolls over one and comes down on the next.
            let (mut by, mut sum) = (Vector3::zeros(), 0.0);
            for i in (0..3).filter(|i| stand[1][*i] && (stand[0][*i] || !both)) {
                let way = (source[1][i] - source[0][i]).norm_squared() + STILLEST * STILLEST;
                by += (before[i] - now[i]) / way;
                sum += 1.0 / way;
            }
            path.push(path[path.len() - 1] + by / sum);
        }
        let count = path.len() as f64;
        let mut shift =
            stance.clone().zip(&path).map(|(frame, at)| ankle(frame) - at).sum::<Vector3<f64>>() / count;
        // Heights of what stands, there and here.
        let (mut there, mut here, mut points) = (0.0, 0.0, 0.0);
        for (frame, at) in stance.clone().zip(&path) {
            let source = take.soles[side].at(&take.frames[frame]);
            for (i, from) in offset(frame).iter().enumerate().filter(|(i, _)| take.stands[frame][side][*i]) {
                (there, here, points) = (there + source[i].y, here + at.y + from.y, points + 1.0);
            }
        }
        shift.y = footing.ground(there / points) - here / points;
        for (frame, at) in stance.clone().zip(path) {
            off[frame] = at + shift - ankle(frame);
        }
    }
    between(&take.time, stances, &mut off);
    // Nothing goes below the floor that was not below it in the source.
    let lowest = |points: [Vector3<f64>; 3]| points.iter().map(|point| point.y).fold(f64::INFINITY, f64::min);
    let lift = |frame: usize| {
        let there = footing.ground(lowest(take.soles[side].at(&take.frames[frame]))).min(footing.floors[1]);
        let here = lowest(sole.at(&frames[frame])) + off[frame].y;
        Vector3::y() * (there - here).max(0.0)
    };
    (0..frames.len()).map(|frame| ankle(frame) + off[frame] + lift(frame)).collect()
}

/// Fills what lies outside of the stances: constant before the first and after the last, in between from one to the other with rates of
/// nothing at both ends.
fn between(time: &[f64], stances: &[Range<usize>], off: &mut [Vector3<f64>]) {
    let (Some(first), Some(last)) = (stances.first(), stances.last()) else { return };
    let (head, tail) = (off[first.start], off[last.end - 1]);
    off[..first.start].fill(head);
    off[last.end..].fill(tail);
    for pair in stances.windows(2) {
        let (from, to) = (pair[0].end - 1, pair[1].start);
        for frame in from + 1..to {
            let s = (time[frame] - time[from]) / (time[to] - time[from]);
            off[frame] = off[from].lerp(&off[to], s * s * (3.0 - 2.0 * s));
        }
    }
}

/// How much lower a hip must be so that a leg of length `reach` comes to an ankle that is at `way` from it (m).
fn needed(way: &Vector3<f64>, reach: f64) -> f64 {
    let across = way.x.hypot(way.z);
    let high = (reach * reach - across * across).max(0.0).sqrt();
    (-way.y - high).max(0.0)
}

/// A curve that is nowhere below `values` and has no corners: their greatest in a window, then the mean of that in the window.
fn eased(time: &[f64], values: &[f64]) -> Vec<f64> {
    if values.iter().all(|value| *value <= 0.0) {
        return values.to_vec();
    }
    let windows = |values: &[f64], of: fn(&[f64]) -> f64| {
        let (mut from, mut to) = (0, 0);
        let mut found = Vec::with_capacity(values.len());
        for now in time {
            while now - time[from] > EASE {
                from += 1;
            }
            while to < time.len() && time[to] - now <= EASE {
                to += 1;
            }
            found.push(of(&values[from..to]));
        }
        found
    };
    let greatest = windows(values, |of| of.iter().copied().fold(0.0, f64::max));
    windows(&greatest, |of| of.iter().sum::<f64>() / of.len() as f64)
}

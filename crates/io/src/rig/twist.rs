//! Bones that share out how a limb turns about its own axis, and their part of its skin.

use solaris_model::{Unit, UnitQuaternion, Vector3};
use solaris_retarget::Roll;
use solaris_skin::Influence;

/// A limb with its bones of twist.
#[derive(Clone, Debug)]
pub(super) struct Limb {
    /// The person's link, and the next one along the limb.
    pub(super) link: usize,
    pub(super) next: usize,
    /// The bone that the link is.
    pub(super) bone: usize,
    /// The direction from its joint to the next in the bone's frame, and how far that is (m).
    pub(super) axis: Unit<Vector3<f64>>,
    /// The same direction at rest, in the next one's frame.
    pub(super) next_axis: Unit<Vector3<f64>>,
    pub(super) length: f64,
    /// The bones of twist from the joint on, each with how far along it is, from 0 to 1.
    pub(super) twists: Vec<(usize, f64)>,
    /// Whether the next one's turn about the limb's axis is the limb's as well: a hand's, a foot's, and not what an elbow or a knee gives.
    pub(super) is_last: bool,
}

impl Limb {
    /// The turns of its bones of twist in its own bone, `dt` (s) after the frame before, where `turns` says how person's links are turned from their
    /// rest in what they hang on:
    ///
    /// ```text
    /// Rot(a, s·τₙ − (1 − s)·τ)
    /// ```
    ///
    /// with τ and τₙ the turns of limb and next one about the limb's axis `a`, s how far along: see [`Roll`].
    pub(super) fn turns(
        &self,
        turns: &[UnitQuaternion<f64>],
        rolls: &mut [Roll; 2],
        dt: f64,
    ) -> impl Iterator<Item = (usize, UnitQuaternion<f64>)> + '_ {
        let own = rolls[0].follow(&self.axis, &turns[self.link], dt);
        let next = if self.is_last { rolls[1].follow(&self.next_axis, &turns[self.next], dt) } else { 0.0 };
        let turn =
            move |share: f64| UnitQuaternion::from_axis_angle(&self.axis, share * next - (1.0 - share) * own);
        self.twists.iter().map(move |(bone, share)| (*bone, turn(*share)))
    }

    /// Shares out what a vertex has of the limb, which is at `from_joint` (m) in its bone's frame: among the two bones of twist that it is between, before the
    /// first to that one, and beyond the last to that one, or of what ends at an elbow or a knee more and more to the limb's own bone.
    pub(super) fn shared(&self, from_joint: &Vector3<f64>, share: f32) -> [Influence; 2] {
        let along = from_joint.dot(&self.axis) / self.length;
        let own = (!self.is_last).then_some((self.bone, 1.0));
        let stops = || self.twists.iter().copied().chain(own);
        let before = stops().take_while(|(_, at)| *at <= along).last();
        let after = stops().find(|(_, at)| *at > along);
        let of = |bone: usize, part: f64| Influence { link: bone as u16, share: share * part as f32 };
        match (before, after) {
            (Some((a, from)), Some((b, to))) => {
                let part = (along - from) / (to - from);
                [of(a, 1.0 - part), of(b, part)]
            }
            (Some((bone, _)), None) | (None, Some((bone, _))) => [of(bone, 1.0), Influence::default()],
            (None, None) => [of(self.bone, 1.0), Influence::default()],
        }
    }
}

//! Ground reactions of a motion that is wholly prescribed.
//!
//! The whole wrench of the ground is the root's residual: what inverse dynamics finds at the root is what must come from
//! outside. In single support it belongs to the foot that stands; in double support it is shared by the pivot split. What the ground does to
//! other links is known where the motion has contacts of them, and the feet have the rest.
//! With the feet's wrenches applied, the root's forces vanish and the joints' forces are those of the motion on its feet.

use crate::carrier::Carrier;
use crate::error::ReactionError;
use crate::peak::Peak;
use crate::prepared::{PreparedMotion, each};
use crate::split::{FootSupport, split_at_pivot};
use nalgebra::Vector3;
use solaris_dynamics::{Workspace, Wrench, inverse_dynamics_with};
use solaris_model::{AxisKind, Contact, ContactTrack, Figure, JointKind, Motion};

/// What a planner knows of the feet at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Support {
    /// Share and nominal centre of pressure of the two feet.
    pub feet: [FootSupport; 2],
    /// Height of the point that the feet's forces point at, over the height of the centre of mass.
    pub pivot: f64,
    /// The total force on the feet that was prescribed (N), if one was; the report says how far the motion's is from it.
    pub force: Option<Vector3<f64>>,
}

/// Gives the support at any time of a motion.
pub trait SupportLaw: Sync {
    /// At time `t` (s).
    fn support(&self, t: f64) -> Support;
    /// What the ground does to a link that is no foot, such as a cane, by its name; none at any time where there is no such link.
    fn beside(&self, t: f64) -> Option<(&str, Contact)> {
        let _ = t;
        None
    }
}

/// What was found, besides the contacts and forces in the motion.
///
/// With the feature `serde` its keys are `double_support_split`, `root_residual_n`, `root_residual_n_m`, `from_prescribed_n` and
/// `cop_from_prescribed_m`.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ReactionReport {
    /// Name of the rule that shares the load in double support.
    #[cfg_attr(feature = "serde", serde(rename = "double_support_split"))]
    pub split: &'static str,
    /// Greatest force (N) that is left at the root's degrees of freedom; rounding.
    #[cfg_attr(feature = "serde", serde(rename = "root_residual_n"))]
    pub root_force: f64,
    /// Greatest moment (N m) that is left there; rounding.
    #[cfg_attr(feature = "serde", serde(rename = "root_residual_n_m"))]
    pub root_moment: f64,
    /// Greatest difference of the total force from the prescribed one (N).
    #[cfg_attr(feature = "serde", serde(rename = "from_prescribed_n"))]
    pub from_prescribed: Option<Peak>,
    /// Greatest difference of the total centre of pressure from the nominal one (m).
    #[cfg_attr(feature = "serde", serde(rename = "cop_from_prescribed_m"))]
    pub cop_from_nominal: Peak,
}

impl ReactionReport {
    /// Of each number the worse one of two, such as those of two who walk in one motion.
    #[must_use]
    pub fn worst(&self, other: &Self) -> Self {
        let prescribed = self.from_prescribed.into_iter().chain(other.from_prescribed);
        Self {
            split: self.split,
            root_force: self.root_force.max(other.root_force),
            root_moment: self.root_moment.max(other.root_moment),
            from_prescribed: prescribed.reduce(Peak::max),
            cop_from_nominal: self.cop_from_nominal.max(other.cop_from_nominal),
        }
    }
}

/// A foot: the links that carry its wrench.
pub(crate) struct Foot {
    name: String,
    pub(crate) carrier: Carrier,
}

impl Foot {
    pub(crate) fn find(figure: &Figure, name: &str) -> Result<Self, ReactionError> {
        let link = find(figure, name)?;
        if figure.links()[link].sole().is_empty() {
            return Err(ReactionError::NoSole { link: name.to_owned() });
        }
        let links = figure.links().iter().enumerate();
        let toes = links.filter(|(_, child)| child.parent() == Some(link));
        let carrier = toes.map(|(toes, _)| toes).find_map(|toes| Carrier::of_two(figure, link, toes));
        Ok(Self { name: name.to_owned(), carrier: carrier.unwrap_or(Carrier::of_one(link)) })
    }
}

fn find(figure: &Figure, name: &str) -> Result<usize, ReactionError> {
    let missing = || ReactionError::MissingLink { figure: figure.name().to_owned(), link: name.to_owned() };
    figure.link_index(name).ok_or_else(missing)
}

/// Finds the ground's wrench on two feet and the joints' forces, and writes both to the motion, as [`ground_reactions_under`] does where nothing else acts.
///
/// # Errors
///
/// As there.
#[doc(alias = "grf")]
#[doc(alias = "ground reaction forces")]
pub fn ground_reactions(
    figure: &Figure,
    motion: &mut Motion,
    feet: [&str; 2],
    law: &impl SupportLaw,
) -> Result<ReactionReport, ReactionError> {
    ground_reactions_under(figure, motion, feet, law, &[])
}

/// Finds the ground's wrench on two feet and the joints' forces, and writes both to the motion.
///
/// `acting` is what acts on links besides, frame by frame: pushes and springs, each with its link and about the world's origin (N, N m); frames beyond its end have nothing. Contacts of other links that the motion has act as well, and what the law knows of besides, which is written to it; the feet have what is left of the
/// whole wrench.
///
/// The contacts carry the feet's names, whichever link of the foot the wrench acts on: the toes, once the centre of
/// pressure has passed the ball. Frames are independent of each other and solved on all cores where the feature
/// `parallel` is on; the results do not depend on it.
///
/// # Errors
///
/// A motion of another figure, links that are no feet, and a motion that needs a ground that pulls.
pub fn ground_reactions_under(
    figure: &Figure,
    motion: &mut Motion,
    feet: [&str; 2],
    law: &impl SupportLaw,
    acting: &[Vec<(usize, Wrench<f64>)>],
) -> Result<ReactionReport, ReactionError> {
    reactions_under(figure, motion, feet, law, acting)
}

/// The same, compiled once for all laws.
fn reactions_under(
    figure: &Figure,
    motion: &mut Motion,
    feet: [&str; 2],
    law: &dyn SupportLaw,
    acting: &[Vec<(usize, Wrench<f64>)>],
) -> Result<ReactionReport, ReactionError> {
    let prepared = PreparedMotion::new(figure, motion)?;
    if prepared.up.norm_squared() == 0.0 {
        return Err(ReactionError::NoGravity);
    }
    if feet[0] == feet[1] {
        return Err(ReactionError::OneFootTwice { link: feet[0].to_owned() });
    }
    let feet = [Foot::find(figure, feet[0])?, Foot::find(figure, feet[1])?];
    let beside = match law.beside(0.0) {
        Some((name, _)) => Some((find(figure, name)?, name.to_owned())),
        None => None,
    };
    let mut others = others(figure, motion, &feet);
    others.retain(|(link, _)| beside.as_ref().is_none_or(|(beside, _)| beside != link));
    let link = beside.as_ref().map(|(link, _)| *link);
    let scene = Scene { prepared: &prepared, feet: &feet, others: &others, beside: link, acting, law };
    let frames = each(
        0..motion.len(),
        || Workspace::new(&prepared.tree),
        |workspace, row| scene.frame(workspace, row),
    )?;

    let root = figure.layout().joints()[0];
    let mut report = ReactionReport {
        split: "pivot",
        root_force: 0.0,
        root_moment: 0.0,
        from_prescribed: None,
        cop_from_nominal: Peak::default(),
    };
    let mut tau = Vec::with_capacity(motion.len() * figure.layout().nv());
    let mut tracks =
        feet.map(|foot| ContactTrack { link: foot.name, samples: Vec::with_capacity(motion.len()) });
    let mut beside = beside.map(|(_, link)| ContactTrack { link, samples: Vec::with_capacity(motion.len()) });
    let slides = slides(figure.links()[0].joint().kind());
    for (frame, &time) in frames.into_iter().zip(motion.time()) {
        for (residual, slide) in frame.tau[root.v..root.v + root.nv].iter().zip(&slides) {
            let greatest = if *slide { &mut report.root_force } else { &mut report.root_moment };
            *greatest = greatest.max(residual.abs());
        }
        if let Some(difference) = frame.from_prescribed
            && report.from_prescribed.is_none_or(|worst| difference > worst.value)
        {
            report.from_prescribed = Some(Peak { value: difference, time });
        }
        report.cop_from_nominal = report.cop_from_nominal.max(Peak { value: frame.cop_from_nominal, time });
        tau.extend(frame.tau);
        for (track, contact) in tracks.iter_mut().zip(frame.contacts) {
            track.samples.push(contact);
        }
        if let Some(track) = &mut beside {
            track.samples.push(frame.beside);
        }
    }
    motion.set_tau(tau)?;
    let new = || beside.iter().chain(&tracks);
    motion.contacts.retain(|track| new().all(|new| new.link != track.link));
    motion.contacts.extend(beside.clone().into_iter().chain(tracks));
    Ok(report)
}

/// The ground's forces in one frame, and the joints'.
struct Frame {
    tau: Vec<f64>,
    contacts: [Contact; 2],
    beside: Contact,
    from_prescribed: Option<f64>,
    cop_from_nominal: f64,
}

/// The contacts of links that are no feet.
fn others<'m>(figure: &Figure, motion: &'m Motion, feet: &[Foot; 2]) -> Vec<(usize, &'m ContactTrack)> {
    let own = motion.contacts.iter().filter(|track| feet.iter().all(|foot| foot.name != track.link));
    own.filter_map(|track| Some((figure.link_index(&track.link)?, track))).collect()
}

/// What all frames share.
struct Scene<'a> {
    prepared: &'a PreparedMotion<'a>,
    feet: &'a [Foot; 2],
    /// Links with contacts that are known.
    others: &'a [(usize, &'a ContactTrack)],
    /// The link that the law knows of besides.
    beside: Option<usize>,
    /// What acts on links besides, frame by frame.
    acting: &'a [Vec<(usize, Wrench<f64>)>],
    law: &'a dyn SupportLaw,
}

impl Scene<'_> {
    fn frame(&self, workspace: &mut Workspace<f64>, row: usize) -> Result<Frame, ReactionError> {
        let PreparedMotion { tree, up, .. } = self.prepared;
        let (q, v, a) = (self.prepared.q(row), self.prepared.v(row), self.prepared.a(row));
        let time = self.prepared.time()[row];
        let mut tau = vec![0.0; tree.nv()];
        let support = self.law.support(time);
        let nominal: Vector3<f64> = support.feet.iter().map(|foot| foot.cop * foot.share).sum();
        let (mut contacts, mut from_prescribed, mut cop_from_nominal) = ([Contact::default(); 2], None, 0.0);
        let known = self.others.iter().filter_map(|(link, track)| {
            let Contact { force, moment, .. } = *track.samples.get(row)?;
            Some((*link, Wrench { force, moment }))
        });
        let known = known.chain(self.acting.get(row).into_iter().flatten().copied());
        let beside = self.law.beside(time).map(|(_, contact)| contact).unwrap_or_default();
        let wrench = Wrench { force: beside.force, moment: beside.moment };
        let known = known.chain(self.beside.map(|link| (link, wrench)));
        let react = |workspace: &Workspace<f64>, com: &Vector3<f64>| {
            let mut total = workspace.base_wrench();
            let mut all: Vec<(usize, Wrench<f64>)> = known.collect();
            for (_, Wrench { force, moment }) in &all {
                total.force -= force;
                total.moment -= moment;
            }
            contacts = split_at_pivot(&total, com, up, support.pivot, &support.feet)
                .ok_or_else(|| ReactionError::Pulls { time, normal: total.force.dot(up) })?;
            let centre = total.center_of_pressure(up, nominal.dot(up)).unwrap_or(nominal);
            from_prescribed = support.force.map(|force| (total.force - force).norm());
            cop_from_nominal = (centre - nominal).norm();
            let wrench = |side: usize| {
                let contact: Contact = contacts[side];
                let link = self.feet[side].carrier.link(workspace, &contact.cop);
                (link, Wrench { force: contact.force, moment: contact.moment })
            };
            all.extend([wrench(0), wrench(1)]);
            Ok::<_, ReactionError>(all)
        };
        inverse_dynamics_with(tree, workspace, q, v, a, react, &mut tau)?;
        Ok(Frame { tau, contacts, beside, from_prescribed, cop_from_nominal })
    }
}

/// Which degrees of freedom of a joint slide: their forces are in N, the others' in N m.
pub(crate) fn slides(joint: &JointKind) -> Vec<bool> {
    match joint {
        JointKind::Free { .. } => (0..6).map(|k| k < 3).collect(),
        _ => (0..joint.nv())
            .map(|k| joint.axes().get(k).is_some_and(|dof| dof.axis.kind == AxisKind::Translation))
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::slides;
    use solaris_model::Joint;

    #[test]
    fn forces_are_those_of_dofs_that_slide() {
        let of = |joint: Joint| slides(joint.kind());
        assert_eq!(of(Joint::free("root")), [true, true, true, false, false, false]);
        assert_eq!(of(Joint::ball("hip")), [false; 3]);
        assert_eq!(of(Joint::new("root").rx().ty().rz().tx()), [false, true, false, true]);
    }
}

//! Ground reactions with the foot that stands as the root, as the thesis computes a walk.

use crate::error::ReactionError;
use crate::reaction::Foot;
use nalgebra::Vector3;
use solaris_dynamics::{RootView, Tree, Workspace, Wrench, forward_kinematics, inverse_dynamics};
use solaris_model::{Contact, Event, EventKind, Figure, Motion, RootAt};

/// A foot that bears less than this share of the load gives the root to the other.
const LEAST_SHARE: f64 = 1.0 / 3.0;

/// What became of the forces when they were computed from the feet.
///
/// With the feature `serde` its keys are `links` (each with the time from which on it was the root), `force_differs_n` and
/// `torque_differs_n_m`.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct RootReport {
    /// Which link was the root from when (s) on.
    #[cfg_attr(feature = "serde", serde(rename = "links"))]
    pub roots: Vec<(String, f64)>,
    /// Greatest difference of the root foot's force (N) from what it was.
    #[cfg_attr(feature = "serde", serde(rename = "force_differs_n"))]
    pub reaction_force: f64,
    /// Greatest difference of its moment about the world's origin (N m).
    #[cfg_attr(feature = "serde", serde(skip))]
    pub reaction_moment: f64,
    /// Greatest difference of a joint's force (N m or N) from what it was.
    #[cfg_attr(feature = "serde", serde(rename = "torque_differs_n_m"))]
    pub torque: f64,
    /// Greatest of what was compared: force (N), moment (N m), joint force.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub scale: (f64, f64, f64),
}

/// Computes the forces of a motion anew, from the foot that stands outwards: the link of that foot that carries the ground's
/// force is the root, with the ground under it, and what the ground does to it is what inverse dynamics finds there.
///
/// The motion has been through [`crate::ground_reactions`]: while both feet stand, the other foot keeps the wrench that it got
/// there. The root passes to the other foot when that bears more than two thirds of the load, and from a foot to its toes when
/// the centre of pressure passes the ball. Joint forces, the root foot's contact and an event for each change of root are
/// written to the motion; no choice of root changes a force by more than rounding, and the report says by how much it did.
///
/// # Errors
///
/// A motion of another figure or without forces and contacts of these feet, links that are no feet or cannot be the root.
#[doc(alias = "reroot")]
pub fn reactions_from_feet(
    figure: &Figure,
    motion: &mut Motion,
    feet: [&str; 2],
) -> Result<RootReport, ReactionError> {
    motion.check_figure(figure)?;
    let gravity = motion.info.gravity;
    let up = -gravity.try_normalize(1e-9).ok_or(ReactionError::NoGravity)?;
    let level = motion.info.ground.map_or(0.0, |ground| ground.height);
    let carriers = [Foot::find(figure, feet[0])?.carrier, Foot::find(figure, feet[1])?.carrier];
    let tracks = feet.map(|foot| motion.contacts.iter().position(|track| track.link == foot));
    let [Some(left), Some(right)] = tracks else {
        return Err(ReactionError::NoContacts { link: feet[usize::from(tracks[0].is_some())].to_owned() });
    };
    // What the world does to other links acts as it is.
    let no_feet = motion.contacts.iter().filter(|track| !feet.contains(&track.link.as_str()));
    let others: Vec<(usize, Vec<Contact>)> =
        no_feet.filter_map(|track| Some((figure.link_index(&track.link)?, track.samples.clone()))).collect();
    let tree = Tree::<f64>::new(figure, gravity)?;
    let mut workspace = Workspace::new(&tree);
    let mut views: Vec<View> = Vec::new();
    let mut report = RootReport::default();
    let (mut tau, mut on) = (Vec::with_capacity(motion.len() * tree.nv()), 0);
    let mut new = [left, right].map(|track| motion.contacts[track].samples.clone());
    for row in 0..motion.len() {
        let contacts = [left, right].map(|track| motion.contacts[track].samples[row]);
        let load = contacts.map(|contact| contact.force.dot(&up));
        if load[on] < LEAST_SHARE * (load[0] + load[1]) {
            on = 1 - on;
        }
        forward_kinematics(&tree, &mut workspace, motion.q(row))?;
        let links = [0, 1].map(|side| carriers[side].link(&workspace, &contacts[side].cop));
        if views.iter().all(|view| view.link != links[on]) {
            views.push(View::new(figure, links[on], gravity)?);
        }
        // There is one now.
        let Some(view) = views.iter_mut().find(|view| view.link == links[on]) else { continue };
        let name = figure.links()[links[on]].name();
        if report.roots.last().is_none_or(|(last, _)| last != name) {
            report.roots.push((name.to_owned(), motion.time()[row]));
        }
        let wrench = |contact: &Contact| Wrench { force: contact.force, moment: contact.moment };
        let mut acting = vec![(links[1 - on], wrench(&contacts[1 - on]))];
        acting.extend(others.iter().map(|(link, samples)| (*link, wrench(&samples[row]))));
        let first = tau.len();
        tau.resize(first + tree.nv(), 0.0);
        let base = view.solve((motion.q(row), motion.v(row), motion.a(row)), acting, &mut tau[first..])?;
        // Ground that is not level is no plane; its point stays where it was, as the wrench does but for rounding.
        let plane = motion.relief.is_none().then(|| base.center_of_pressure(&up, level)).flatten();
        let cop = plane.unwrap_or(contacts[on].cop);
        new[on][row] = Contact { force: base.force, moment: base.moment, cop };
        report.compare(&contacts[on], &base, motion.tau(row), &tau[first..]);
    }
    motion.set_tau(tau)?;
    for (track, samples) in [left, right].into_iter().zip(new) {
        motion.contacts[track].samples = samples;
    }
    // The first root is no change.
    motion.events.extend(
        report
            .roots
            .iter()
            .skip(1)
            .map(|(link, time)| Event { time: *time, kind: EventKind::RootChange { link: link.clone() } }),
    );
    motion.events.sort_by(|a, b| a.time.total_cmp(&b.time));
    Ok(report)
}

impl RootReport {
    fn compare(&mut self, was: &Contact, is: &Wrench<f64>, tau_was: Option<&[f64]>, tau_is: &[f64]) {
        let greatest = |value: &mut f64, other: f64| *value = value.max(other);
        greatest(&mut self.reaction_force, (is.force - was.force).norm());
        greatest(&mut self.reaction_moment, (is.moment - was.moment).norm());
        greatest(&mut self.scale.0, was.force.norm());
        greatest(&mut self.scale.1, was.moment.norm());
        for (was, is) in tau_was.into_iter().flatten().zip(tau_is) {
            greatest(&mut self.torque, (is - was).abs());
            greatest(&mut self.scale.2, was.abs());
        }
    }
}

/// The figure from one of its links.
struct View {
    link: usize,
    map: RootView<f64>,
    tree: Tree<f64>,
    workspace: Workspace<f64>,
    q: Vec<f64>,
    v: Vec<f64>,
    a: Vec<f64>,
    tau: Vec<f64>,
}

impl View {
    fn new(figure: &Figure, link: usize, gravity: Vector3<f64>) -> Result<Self, ReactionError> {
        let map = RootView::new(figure, link, RootAt::Joint)
            .map_err(|source| ReactionError::Root { link: figure.links()[link].name().to_owned(), source })?;
        let tree = Tree::new(map.figure(), gravity)?;
        let (workspace, nq, nv) = (Workspace::new(&tree), tree.nq(), tree.nv());
        let [v, a, tau] = [(); 3].map(|()| vec![0.0; nv]);
        Ok(Self { link, map, tree, workspace, q: vec![0.0; nq], v, a, tau })
    }

    /// The forces of the joints (of the declared figure) in a state, with wrenches on other links; what the world does to the
    /// root.
    fn solve(
        &mut self,
        (q, v, a): (&[f64], &[f64], &[f64]),
        mut acting: Vec<(usize, Wrench<f64>)>,
        tau: &mut [f64],
    ) -> Result<Wrench<f64>, ReactionError> {
        self.map.to_view(q, v, a, &mut self.q, &mut self.v, &mut self.a)?;
        for (link, _) in &mut acting {
            *link = self.map.rerooted().links()[*link].link;
        }
        let Self { tree, workspace, .. } = self;
        inverse_dynamics(tree, workspace, &self.q, &self.v, &self.a, &acting, &mut self.tau)?;
        self.map.joint_forces_from_view(&self.tau, q, tau)?;
        Ok(self.workspace.base_wrench())
    }
}

//! The reduced figure: what is left when what nothing depends on is left out.

use super::Role;
use super::colliding::Colliding;
use super::loops::Loops;
use crate::collision::Collisions;
use crate::contact::{ContactPoint, Surface, count};
use crate::element::{Anchor, LimitLaw, Loop, PointSpring};
use crate::failure::SetupError;
use crate::simulation::Simulation;
use nalgebra::Vector3;
use solaris_dynamics::DynamicsError;
use solaris_model::{Figure, FuseError, LinkPlace, Placement};

/// What a phase is made from.
#[derive(Clone)]
pub(super) struct Source {
    /// The full figure, no degree of freedom following another.
    pub(super) figure: Figure,
    pub(super) gravity: Vector3<f64>,
    pub(super) springs: Vec<PointSpring>,
    /// By degree of freedom.
    pub(super) limits: Vec<LimitLaw>,
    pub(super) surface: Option<Surface>,
    pub(super) collisions: Option<Collisions>,
    /// Those that are closed, each with its index in the simulation.
    pub(super) closed: Vec<(usize, Loop)>,
    /// Link and point (m) of each push.
    pub(super) pushes: Vec<(usize, Vector3<f64>)>,
    /// Each degree of freedom that follows another, and that one.
    followers: Vec<(usize, usize)>,
}

/// What is left of the figure.
#[derive(Clone)]
pub(super) struct Reduction {
    pub(super) figure: Figure,
    /// With the links of the small figure.
    pub(super) springs: Vec<PointSpring>,
    /// By degree of freedom of the small figure.
    pub(super) limits: Vec<LimitLaw>,
    /// With the links of the small figure; none where none of these can touch it.
    pub(super) surface: Option<Surface>,
    /// For each of its contact points, the index in the full figure's.
    pub(super) kept_touches: Vec<usize>,
    /// With the links of the small figure; none where nothing that is moved can touch another link.
    pub(super) colliding: Option<Colliding>,
    /// With the links of the small figure.
    pub(super) loops: Loops,
    /// With the links of the small figure.
    pub(super) pushes: Vec<(usize, Vector3<f64>)>,
    /// For each of these, the index among all.
    pub(super) kept_pushes: Vec<usize>,
    /// For each entry of the small figure's `q`, its index in the full one's.
    pub(super) kept_q: Vec<usize>,
    /// For each entry of the small figure's `v`, its index in the full one's.
    pub(super) kept_v: Vec<usize>,
    /// The full figure's degrees of freedom that were fused.
    pub(super) fused: Vec<usize>,
    /// The full figure's links that were dropped.
    pub(super) dropped: Vec<usize>,
}

impl Source {
    /// That of `simulation`.
    pub(super) fn of(simulation: &Simulation) -> Self {
        let followers = simulation.figure.followers().iter().map(|follower| (follower.dof, follower.leader));
        Self {
            figure: simulation.figure.untied(),
            gravity: simulation.gravity,
            springs: simulation.springs.clone(),
            limits: simulation.limits.clone(),
            surface: simulation.surface.clone(),
            collisions: simulation.collisions.clone(),
            closed: simulation.closed().map(|(index, closed)| (index, *closed)).collect(),
            pushes: simulation.pushes.iter().map(|push| (push.link, push.point)).collect(),
            followers: followers.collect(),
        }
    }

    /// The roles that can be computed with: those of followers are their leaders'.
    pub(super) fn roles(&self, roles: &[Role]) -> Result<Vec<Role>, SetupError> {
        let mut roles = roles.to_vec();
        let layout = self.figure.layout();
        if roles.len() != layout.nv() {
            let (expected, found) = (layout.nv(), roles.len());
            return Err(DynamicsError::Length { what: "roles", expected, found }.into());
        }
        for &(dof, leader) in &self.followers {
            if roles[leader] == Role::Dynamic || roles[dof] == Role::Dynamic {
                let [dof, leader] = [dof, leader].map(|dof| layout.v_names()[dof].clone());
                return Err(DynamicsError::Follower { dof, leader }.into());
            }
            roles[dof] = roles[leader];
        }
        for (link, at) in self.figure.links().iter().zip(layout.joints()) {
            let held = roles[at.v..at.v + at.nv].iter().filter(|role| **role != Role::Dynamic).count();
            if link.joint().kind().quaternion().is_some() && held > 0 && held < at.nv {
                let joint = link.joint().name().to_owned();
                return Err(FuseError::PartOfJoint { joint, count: held, all: at.nv }.into());
            }
        }
        Ok(roles)
    }

    /// What is left for these roles, where everything that stands still does so at `q`; nothing where nothing is to be
    /// computed. The forces on the degrees of freedom `held` are to be right as well. What stands still is fused if `fuse` says
    /// so, and else has a motion of its own, none.
    pub(super) fn reduce(
        &self,
        roles: &[Role],
        held: &[usize],
        q: &[f64],
        leave_out: bool,
        fuse: bool,
    ) -> Result<Option<Reduction>, SetupError> {
        if !leave_out {
            return Ok(Some(self.whole()));
        }
        let computed: Vec<bool> =
            (0..roles.len()).map(|dof| roles[dof] == Role::Dynamic || held.contains(&dof)).collect();
        if !computed.contains(&true) {
            return Ok(None);
        }
        let moved = self.moved(&computed);
        let needed = self.needed(&moved);
        let dropped: Vec<usize> = (0..needed.len()).filter(|link| !needed[*link]).collect();
        // The root carries what is computed, so that it never is among them.
        let Ok(pruned) = self.figure.prune(&dropped) else { return Ok(Some(self.whole())) };
        let still = |dof: usize| fuse && roles[dof] == Role::Still && !computed[dof];
        let at_rest = (0..pruned.kept_v().len()).filter(|k| still(pruned.kept_v()[*k]));
        let small_q: Vec<f64> = pruned.kept_q().iter().map(|index| q[*index]).collect();
        let fused = pruned.figure().fuse_at(&at_rest.collect::<Vec<_>>(), &small_q)?;
        let full = |kept: &[usize], of: &[usize]| kept.iter().map(|k| of[*k]).collect::<Vec<_>>();
        let kept_v = full(fused.kept_v(), pruned.kept_v());
        let place = |link: usize| pruned.links()[link].map(|link| fused.links()[link]);
        let colliding = Colliding::of(self, &moved, place);
        let loops = Loops::of(self, &moved, place);
        let springs = self.springs.iter().filter(|spring| is_moved(&spring.between, &moved));
        let surface = self.surface.as_ref().and_then(|surface| under(surface, &moved, place));
        let (surface, kept_touches) = surface.unzip();
        let pushed = |(i, (link, point)): (usize, &(usize, Vector3<f64>))| {
            let LinkPlace { link, placement } = place(*link).filter(|_| moved[*link])?;
            Some(((link, placement.transform_point(&(*point).into()).coords), i))
        };
        let (pushes, kept_pushes) = self.pushes.iter().enumerate().filter_map(pushed).unzip();
        Ok(Some(Reduction {
            figure: fused.figure().clone(),
            springs: springs.filter_map(|spring| placed(spring, place)).collect(),
            limits: kept_v.iter().map(|dof| self.limits[*dof]).collect(),
            surface,
            pushes,
            kept_pushes,
            kept_touches: kept_touches.unwrap_or_default(),
            colliding,
            loops,
            kept_q: full(fused.kept_q(), pruned.kept_q()),
            fused: pruned.kept_v().iter().copied().filter(|dof| still(*dof)).collect(),
            kept_v,
            dropped,
        }))
    }

    /// Everything.
    fn whole(&self) -> Reduction {
        let moved = vec![true; self.figure.links().len()];
        let place = |link| Some(LinkPlace { link, placement: Placement::identity() });
        Reduction {
            figure: self.figure.clone(),
            springs: self.springs.clone(),
            limits: self.limits.clone(),
            surface: self.surface.clone(),
            pushes: self.pushes.clone(),
            kept_pushes: (0..self.pushes.len()).collect(),
            kept_touches: (0..count(self.surface.as_ref())).collect(),
            colliding: Colliding::of(self, &moved, place),
            loops: Loops::of(self, &moved, place),
            kept_q: (0..self.figure.layout().nq()).collect(),
            kept_v: (0..self.figure.layout().nv()).collect(),
            fused: Vec::new(),
            dropped: Vec::new(),
        }
    }

    /// The links whose motion depends on what is computed: those with such a degree of freedom, and all that they carry.
    fn moved(&self, computed: &[bool]) -> Vec<bool> {
        let mut moved: Vec<bool> = Vec::with_capacity(self.figure.links().len());
        for (link, at) in self.figure.links().iter().zip(self.figure.layout().joints()) {
            let by_parent = link.parent().is_some_and(|parent| moved[parent]);
            moved.push(by_parent || computed[at.v..at.v + at.nv].contains(&true));
        }
        moved
    }

    /// The links that what is computed depends on: those that are moved, touching the ground or not, those at the other ends of springs and loops on these or that these
    /// can touch, and all that carries them.
    fn needed(&self, moved: &[bool]) -> Vec<bool> {
        let mut needed = moved.to_vec();
        let springs = self.springs.iter().map(|spring| &spring.between);
        let joined = springs.chain(self.closed.iter().map(|(_, closed)| &closed.between));
        for between in joined.filter(|between| is_moved(between, moved)) {
            for link in between.iter().filter_map(|anchor| anchor.link) {
                needed[link] = true;
            }
        }
        let pairs = self.collisions.iter().flat_map(|collisions| &collisions.pairs);
        for &[a, b] in pairs.filter(|pair| pair.iter().any(|link| moved[*link])) {
            (needed[a], needed[b]) = (true, true);
        }
        // Parents come before their children.
        for (i, link) in self.figure.links().iter().enumerate().rev() {
            if let (true, Some(parent)) = (needed[i], link.parent()) {
                needed[parent] = true;
            }
        }
        needed
    }
}

/// Whether one of two points is on something that is moved.
fn is_moved(between: &[Anchor; 2], moved: &[bool]) -> bool {
    between.iter().any(|anchor| anchor.link.is_some_and(|link| moved[link]))
}

/// The spring with the links that carry its ends; none where both ends are on one link.
fn placed(spring: &PointSpring, place: impl Fn(usize) -> Option<LinkPlace>) -> Option<PointSpring> {
    let anchor = |Anchor { link, point }: Anchor| {
        let Some(LinkPlace { link, placement }) = link.and_then(&place) else {
            return Anchor { link: None, point };
        };
        Anchor { link: Some(link), point: placement.transform_point(&point.into()).coords }
    };
    let between = spring.between.map(anchor);
    (between[0].link != between[1].link).then_some(PointSpring { between, ..*spring })
}

/// The ground under what is moved, with the links that carry the contact points, and which these are; none where nothing of it can
/// touch the ground.
fn under(
    surface: &Surface,
    moved: &[bool],
    place: impl Fn(usize) -> Option<LinkPlace>,
) -> Option<(Surface, Vec<usize>)> {
    let touch = |(i, touch): (usize, &ContactPoint)| {
        let LinkPlace { link, placement } = place(touch.link).filter(|_| moved[touch.link])?;
        Some((
            ContactPoint { link, center: placement.transform_point(&touch.center.into()).coords, ..*touch },
            i,
        ))
    };
    let (contact_points, kept): (Vec<ContactPoint>, Vec<usize>) =
        surface.contact_points.iter().enumerate().filter_map(touch).unzip();
    (!contact_points.is_empty()).then_some((Surface { plane: surface.plane, contact_points }, kept))
}

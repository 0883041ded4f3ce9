//! The constants of a figure, in the form in which the recursions read them.

pub(crate) mod dof;
pub(crate) mod mass_distribution;

use crate::error::DynamicsError;
use crate::scalar::Scalar;
use crate::tree::dof::{Dof, triple};
use crate::tree::mass_distribution::{MassDistribution, constant, mass_distribution, vector};
use nalgebra::{Matrix3, Vector3};
use solaris_model::{Axis, EulerOrder, Figure, JointKind, Link};

/// A figure under a gravity, compiled for the recursions: constant, shared between any number of [`crate::Workspace`]s.
///
/// Links and degrees of freedom keep the order of the figure.
#[doc(alias = "Model")]
#[doc(alias = "mjModel")]
#[doc(alias = "MultibodyPlant")]
#[doc(alias = "multibody")]
#[derive(Clone, Debug)]
pub struct Tree<T> {
    pub(crate) bodies: Vec<Body<T>>,
    pub(crate) dofs: Vec<Dof<T>>,
    /// Of each degree of freedom the one before it on its path to the root.
    pub(crate) before: Vec<Option<usize>>,
    /// The degrees of freedom that slide.
    pub(crate) slides: Vec<usize>,
    /// The degrees of freedom whose axis is none of the coordinate axes, by slot.
    pub(crate) skews: Vec<usize>,
    /// The ball and free joints, by slot.
    pub(crate) spheres: Vec<Sphere>,
    /// Armature of the degrees of freedom that have one.
    pub(crate) armature: Vec<(usize, T)>,
    pub(crate) gravity: Vector3<T>,
    /// The first degree of freedom that follows another, and that one.
    pub(crate) follower: Option<(usize, usize)>,
    pub(crate) mass: T,
    pub(crate) mass_inverse: T,
    nq: usize,
    q_names: Vec<String>,
    v_names: Vec<String>,
    link_names: Vec<String>,
}

/// One link with the joint that moves it.
#[derive(Clone, Debug)]
pub(crate) struct Body<T> {
    pub(crate) parent: Option<usize>,
    /// The joint's degrees of freedom are `first..end`.
    pub(crate) first: usize,
    pub(crate) end: usize,
    /// Those from here on are the three turns of `triple`.
    pub(crate) single_end: usize,
    pub(crate) triple: Option<EulerOrder>,
    /// The place in [`Tree::spheres`] of a ball or free joint.
    pub(crate) sphere: Option<usize>,
    /// Whether its link can turn in every way without turning anything else: the last three degrees of freedom are those of
    /// a ball, or three turns about different axes, and have no armature.
    pub(crate) turns_freely: bool,
    /// Whether no degree of freedom slides: then every axis goes through the link's origin.
    pub(crate) only_turns: bool,
    /// First coordinate in `q`.
    pub(crate) q: usize,
    /// Where the joint's frame stands in the parent's frame (m).
    pub(crate) offset: Vector3<T>,
    /// How it is turned there, if it is.
    pub(crate) turned: Option<Matrix3<T>>,
    /// What the link weighs; `None` for a link without mass.
    pub(crate) mass_distribution: Option<MassDistribution<T>>,
}

/// A ball or free joint: first the link is placed as its coordinates say, then its degrees of freedom stand along the
/// link's axes, none of which has moved.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sphere {
    /// First of its quaternion's four entries in `q`.
    pub(crate) quaternion: usize,
    /// First of its position's three entries in `q`, for a free joint.
    pub(crate) position: Option<usize>,
}

impl<T: Scalar> Tree<T> {
    /// Compiles `figure` under the acceleration of `gravity` (m/s², world axes).
    ///
    /// # Errors
    ///
    /// [`DynamicsError::Constant`] where gravity is not finite or a constant of the figure is beyond the range of `T`;
    /// [`DynamicsError::Joint`] for a kind of joint that the recursions do not know.
    pub fn new(figure: &Figure, gravity: Vector3<f64>) -> Result<Self, DynamicsError> {
        let layout = figure.layout();
        let names = |names: &[String]| names.to_vec();
        let mut tree = Self {
            bodies: Vec::with_capacity(figure.links().len()),
            dofs: Vec::with_capacity(layout.nv()),
            before: Vec::with_capacity(layout.nv()),
            slides: Vec::new(),
            skews: Vec::new(),
            spheres: Vec::new(),
            armature: Vec::new(),
            gravity: vector("gravity", "", &gravity)?,
            follower: figure.followers().first().map(|f| (f.dof, f.leader)),
            mass: constant("the mass of figure ", figure.name(), figure.mass())?,
            mass_inverse: T::from_f64(if figure.mass() > 0.0 { figure.mass().recip() } else { 0.0 }),
            nq: layout.nq(),
            q_names: names(layout.q_names()),
            v_names: names(layout.v_names()),
            link_names: figure.links().iter().map(|link| link.name().to_owned()).collect(),
        };
        for (link, joint) in figure.links().iter().zip(layout.joints()) {
            let sphere = tree.push_dofs(link, joint.q)?;
            let placement = link.joint().placement();
            let mut rotation = placement.rotation;
            rotation.renormalize();
            let rotation = rotation.to_rotation_matrix();
            let (first, end) = (joint.v, joint.v + joint.nv);
            let triple = triple(&tree.dofs[first..end]).filter(|_| sphere.is_none());
            let single_end = match (sphere, triple) {
                (Some(_), _) => first,
                (None, Some(_)) => end - 3,
                (None, None) => end,
            };
            let mut before = link.parent().and_then(|parent| tree.last_before(parent));
            for k in first..end {
                tree.before.push(before);
                before = Some(k);
            }
            tree.bodies.push(Body {
                parent: link.parent(),
                first,
                end,
                single_end,
                triple,
                sphere,
                turns_freely: (triple.is_some() || sphere.is_some())
                    && tree.dofs[end - 3..end].iter().all(|dof| dof.armature.is_zero()),
                only_turns: tree.dofs[first..end].iter().all(|dof| dof.kind.turns()),
                q: joint.q,
                offset: vector("the origin of joint ", link.joint().name(), &placement.translation.vector)?,
                turned: (*rotation.matrix() != Matrix3::identity())
                    .then(|| rotation.matrix().map(T::from_f64)),
                mass_distribution: mass_distribution(link)?,
            });
        }
        Ok(tree)
    }

    /// Adds the degrees of freedom of a joint whose coordinates begin at `q`; the slot of a ball or free joint.
    fn push_dofs(&mut self, link: &Link, q: usize) -> Result<Option<usize>, DynamicsError> {
        let (kind, first) = (link.joint().kind(), self.dofs.len());
        let position = match kind {
            JointKind::Axes(axes) => {
                for (index, dof) in axes.iter().enumerate() {
                    self.push_dof(&dof.axis, q + index);
                }
                for k in (first..self.dofs.len().saturating_sub(1)).rev() {
                    self.dofs[k].has_lever |= self.dofs[k + 1].has_lever;
                }
                return self.arm(link, first).map(|()| None);
            }
            JointKind::Ball { .. } => None,
            JointKind::Free { .. } => Some(q),
            _ => return Err(DynamicsError::Joint { joint: link.joint().name().to_owned() }),
        };
        // The entry after the last coordinate is that of a degree of freedom that has not moved.
        let (unmoved, axes) = (self.nq, [0, 1, 2].map(|i| Vector3::ith(i, 1.0)));
        let slides = position.iter().flat_map(|_| axes.map(Axis::translation));
        for axis in slides.chain(axes.map(Axis::rotation)) {
            self.push_dof(&axis, unmoved);
        }
        self.spheres.push(Sphere { quaternion: position.map_or(q, |q| q + 3), position });
        self.arm(link, first).map(|()| Some(self.spheres.len() - 1))
    }

    /// Gives the degrees of freedom from `first` on the armature of the joint.
    fn arm(&mut self, link: &Link, first: usize) -> Result<(), DynamicsError> {
        for (index, dof) in self.dofs[first..].iter_mut().enumerate() {
            let armature = link.joint().kind().armature(index);
            if armature > 0.0 {
                dof.armature = constant("the armature of joint ", link.joint().name(), armature)?;
                self.armature.push((first + index, dof.armature));
            }
        }
        Ok(())
    }

    fn push_dof(&mut self, axis: &Axis, q: usize) {
        let (k, dof) = (self.dofs.len(), Dof::new(axis, q, self.skews.len()));
        self.skews.extend(dof.kind.is_skew().then_some(k));
        self.slides.extend((!dof.kind.turns() && q < self.nq).then_some(k));
        self.dofs.push(dof);
    }

    /// The last degree of freedom between the world and a link.
    fn last_before(&self, link: usize) -> Option<usize> {
        let mut next = Some(link);
        while let Some(body) = next.map(|link| &self.bodies[link]) {
            if body.end > body.first {
                return Some(body.end - 1);
            }
            next = body.parent;
        }
        None
    }

    /// The ball or free joint that degree of freedom `k` belongs to, and which of that joint's it is.
    pub(crate) fn sphere_of(&self, k: usize) -> Option<(&Sphere, usize)> {
        let body = &self.bodies[self.bodies.partition_point(|body| body.end <= k)];
        body.sphere.map(|slot| (&self.spheres[slot], k - body.first))
    }

    /// Length of `q`.
    #[doc(alias = "dimension of configuration")]
    pub fn nq(&self) -> usize {
        self.nq
    }

    /// Length of `v`, `a` and `tau`.
    #[doc(alias = "degrees of freedom")]
    #[doc(alias = "dof")]
    #[doc(alias = "DoF")]
    pub fn nv(&self) -> usize {
        self.dofs.len()
    }

    /// Number of links; link 0 is the root.
    pub fn link_count(&self) -> usize {
        self.bodies.len()
    }

    /// Acceleration of gravity (m/s², world axes).
    pub fn gravity(&self) -> &Vector3<T> {
        &self.gravity
    }

    /// Total mass (kg).
    pub fn mass(&self) -> T {
        self.mass
    }

    /// Refuses to accelerate what is not free: the recursions know nothing of followers.
    pub(crate) fn check_free(&self) -> Result<(), DynamicsError> {
        self.follower.map_or(Ok(()), |(dof, leader)| {
            Err(DynamicsError::Follower { dof: self.v_name(dof), leader: self.v_name(leader) })
        })
    }

    /// Name of an entry of `q`.
    pub(crate) fn q_name(&self, index: usize) -> String {
        self.q_names[index].clone()
    }

    /// Name of an entry of `v`, `a` and `tau`.
    pub(crate) fn v_name(&self, index: usize) -> String {
        self.v_names[index].clone()
    }

    /// Name of a link.
    pub(crate) fn link_name(&self, index: usize) -> String {
        self.link_names[index].clone()
    }
}

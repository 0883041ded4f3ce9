//! Dynamics of figures with locked degrees of freedom, and wrenches and poses handed between a figure and its fused one.

use crate::error::DynamicsError;
use crate::inverse::inverse_dynamics;
use crate::scalar::Scalar;
use crate::spatial::direction::{apply, cross};
use crate::spatial::{Pose, Twist, Wrench};
use crate::tree::Tree;
use crate::workspace::{Workspace, check, check_length};
use solaris_model::{Fused, LinkPlace};

/// All forces of the full figure from a state of the fused one: what holds the fused degrees of freedom still is found only
/// here, when it is asked for.
///
/// Scratch memory; each thread needs one of its own. No call allocates.
///
/// # Examples
///
/// A forearm that is held level at the elbow, 1.5 kg at 0.2 m:
///
/// ```
/// use solaris_dynamics::{FusedForces, Tree};
/// use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
///
/// let down = |x: f64| Vector3::new(0.0, -x, 0.0);
/// let arm = FigureBuilder::new("arm")
///     .link(LinkSpec::root("upper arm", Joint::new("shoulder").rx()).mass(2.0).com(down(0.15)))
///     .link(LinkSpec::child("forearm", "upper arm", Joint::new("elbow").at(down(0.3)).rx()).mass(1.5).com(down(0.2)))
///     .build()?;
/// let fused = arm.fuse_named(&[("elbow", -std::f64::consts::FRAC_PI_2)])?;
/// let tree = Tree::<f64>::new(&arm, Vector3::new(0.0, -9.81, 0.0))?;
/// let mut forces = FusedForces::new(&fused, &tree)?;
/// let mut tau = [0.0; 2];
/// forces.solve(&tree, &[0.0], &[0.0], &[0.0], &[], &mut tau)?;
/// assert!((tau[1] + 1.5 * 9.81 * 0.2).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "reduced model")]
#[doc(alias = "locked joint")]
#[derive(Clone, Debug)]
pub struct FusedForces<T> {
    workspace: Workspace<T>,
    kept_q: Vec<usize>,
    kept_v: Vec<usize>,
    /// Of the full figure; the fused entries never change.
    q: Vec<T>,
    v: Vec<T>,
    a: Vec<T>,
}

impl<T: Scalar> FusedForces<T> {
    /// Scratch memory for `fused`, where `full` is the tree of the figure that was fused.
    ///
    /// # Errors
    ///
    /// [`DynamicsError`] where `full` is the tree of a figure of other sizes, or a fused value beyond the range of `T`.
    pub fn new(fused: &Fused, full: &Tree<T>) -> Result<Self, DynamicsError> {
        check_length("the fused figure's full q", fused.full_nq(), full.nq())?;
        check_length("the fused figure's full v", fused.full_nv(), full.nv())?;
        let q: Vec<T> = fused.rest().iter().map(|x| T::from_f64(*x)).collect();
        check("q", &q, full.nq(), |k| full.q_name(k))?;
        Ok(Self {
            workspace: Workspace::new(full),
            kept_q: fused.kept_q().to_vec(),
            kept_v: fused.kept_v().to_vec(),
            q,
            v: vec![T::zero(); full.nv()],
            a: vec![T::zero(); full.nv()],
        })
    }

    /// The forces `tau` (length `nv` of the full figure) at the small figure's `q`, `v`, `a`, by [`inverse_dynamics`] of the
    /// full figure; `external` names its links.
    ///
    /// # Errors
    ///
    /// As for [`inverse_dynamics`].
    pub fn solve(
        &mut self,
        full: &Tree<T>,
        q: &[T],
        v: &[T],
        a: &[T],
        external: &[(usize, Wrench<T>)],
        tau: &mut [T],
    ) -> Result<(), DynamicsError> {
        check_length("the small figure's q", q.len(), self.kept_q.len())?;
        check_length("the small figure's v", v.len(), self.kept_v.len())?;
        check_length("the small figure's a", a.len(), self.kept_v.len())?;
        for (entry, &index) in q.iter().zip(&self.kept_q) {
            self.q[index] = *entry;
        }
        for ((rate, change), &index) in v.iter().zip(a).zip(&self.kept_v) {
            (self.v[index], self.a[index]) = (*rate, *change);
        }
        inverse_dynamics(full, &mut self.workspace, &self.q, &self.v, &self.a, external, tau)
    }

    /// The full figure's workspace, with what [`solve`](Self::solve) left there.
    pub fn workspace(&self) -> &Workspace<T> {
        &self.workspace
    }
}

/// Lets wrenches act on the links of another figure: that of a [`Fused`], or one that was re-rooted, whose `links` say where
/// each link is found there. In world axes about the world's origin their numbers stay.
///
/// # Errors
///
/// [`DynamicsError::NoSuchLink`]; `external` then is partly rewritten.
///
/// # Examples
///
/// ```
/// use solaris_dynamics::{Wrench, relink};
/// use solaris_model::{Vector3, human};
///
/// let ann = human(1.65, 58.0)?;
/// let fused = ann.fuse_named(&[("left_toes.rz", 0.0), ("left_toes.ry", 0.0), ("left_toes.rx", 0.0)])?;
/// let toes = ann.link_index("left_toes").expect("a link of the human");
/// let push = Wrench { force: Vector3::new(0.0, 300.0, 0.0), moment: Vector3::zeros() };
/// let mut external = [(toes, push)];
/// relink(&mut external, fused.links())?;
/// assert_eq!(fused.figure().links()[external[0].0].name(), "left_foot");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "reduced model")]
pub fn relink<T>(external: &mut [(usize, Wrench<T>)], links: &[LinkPlace]) -> Result<(), DynamicsError> {
    for (index, (link, _)) in external.iter_mut().enumerate() {
        let Some(place) = links.get(*link) else {
            return Err(DynamicsError::NoSuchLink { index, link: *link, last: links.len() - 1 });
        };
        *link = place.link;
    }
    Ok(())
}

impl<T: Scalar> Workspace<T> {
    /// The pose of a link of another figure that a link of this one carries, as [`Fused::links`] and
    /// [`solaris_model::Rerooted::links`] tell; since the last operation that is said to place the links.
    ///
    /// # Panics
    ///
    /// Where the tree has no such link.
    pub fn pose_of(&self, place: &LinkPlace) -> Pose<T> {
        let (pose, at) = (&self.poses[place.link], &place.placement);
        let turn = at.rotation.to_rotation_matrix().matrix().map(T::from_f64);
        Pose {
            rotation: pose.rotation * turn,
            translation: pose.translation + apply(&pose.rotation, &at.translation.vector.map(T::from_f64)),
        }
    }

    /// The velocity of such a link, its own origin being the point; since the last operation that is said to find the links'
    /// velocities.
    ///
    /// # Panics
    ///
    /// Where the tree has no such link.
    pub fn velocity_of(&self, place: &LinkPlace) -> Twist<T> {
        let (pose, twist) = (&self.poses[place.link], &self.twists[place.link]);
        let arm = apply(&pose.rotation, &place.placement.translation.vector.map(T::from_f64));
        Twist { linear: twist.linear + cross(&twist.angular, &arm), angular: twist.angular }
    }
}

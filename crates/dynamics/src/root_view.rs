//! The root view: the same figure and the same motion, computed from another link outwards.

mod declared_root;
mod error;
mod forces;
mod path;
mod reverse;

pub use error::RootViewError;

use crate::error::DynamicsError;
use crate::scalar::Scalar;
use crate::workspace::{check, check_length, check_quaternion, check_result};
use declared_root::DeclaredRoot;
use path::Path;
use reverse::JointMap;
use solaris_model::{Figure, Rerooted, RootAt, StateLayout};

/// A figure seen from another link: a view for computing, with the maps of states and forces both ways.
///
/// The [`figure`](Self::figure) of the view hangs on the chosen link by a free joint (see [`Rerooted`]); compile it into
/// a [`crate::Tree`] like any other. Columns of motions stay those of the declared figure: bring a state here, compute,
/// and bring forces back. With the same external wrenches, what no choice of root can change comes out the same:
/// energies, momentum, poses, velocities and accelerations of links, and what the world has to do to the figure
/// ([`crate::Workspace::base_wrench`]).
///
/// - Inner joints keep their coordinates and rates. Where a joint is turned round, its axes come in the opposite order; a
///   ball joint with the rotation `R` has the conjugate quaternion and `−R·v`, `−R·a`, `−R·tau`.
/// - The free joint of the new root gets the pose, velocity and acceleration of its link, which a recursion from the
///   declared root along the path finds.
/// - Wrenches in world axes keep their numbers, see [`relink`](crate::relink).
///
/// # What the root carries
///
/// Inverse dynamics lets what is left over, the base wrench, act on the root link. So do the forces of the joints depend on
/// the root, unless nothing is left over: then all joints have the same forces from every root. There are two ways home:
///
/// - [`joint_forces_from_view`](Self::joint_forces_from_view) lets the wrench act where it does, on the new root. With the
///   stance foot as root and the ground under it, these are the forces of the joints. The declared figure has the same when
///   the wrench is among the external ones there.
/// - [`forces_from_view`](Self::forces_from_view) gives what the inverse dynamics of the declared figure gives, where the
///   declared root's joint carries the wrench.
///
/// A state of the view is one of the declared figure only where the declared root's joint can follow: a free joint, or
/// three slides along different coordinate axes and then three turns about different coordinate axes.
///
/// No map allocates.
#[doc(alias = "floating base")]
#[doc(alias = "stance foot")]
#[doc(alias = "reroot")]
#[derive(Clone, Debug)]
pub struct RootView<T> {
    rerooted: Rerooted,
    declared: StateLayout,
    /// From the world to the new root's frame, in the declared figure.
    to_root: Path<T>,
    /// From the world to the declared root's frame, in the view.
    to_declared: Path<T>,
    root_armature: Vec<T>,
    joints: Vec<JointMap>,
    declared_root: DeclaredRoot,
}

impl<T: Scalar> RootView<T> {
    /// The view of `figure` from the link of index `link`, by its joint, its tip or another of its points.
    ///
    /// # Errors
    ///
    /// [`RootViewError`] where the figure cannot hang on that link, or a constant is beyond the range of `T`.
    ///
    /// # Examples
    ///
    /// ```
    /// use solaris_dynamics::RootView;
    /// use solaris_model::{RootAt, human};
    ///
    /// let ann = human(1.65, 58.0)?;
    /// let foot = ann.link_index("left_foot").expect("a link of the human");
    /// let view = RootView::<f64>::new(&ann, foot, RootAt::Joint)?;
    /// let (q, rest) = (vec![0.0; 66], vec![0.0; 66]);
    /// let (mut q_view, mut v_view, mut a_view) = (vec![0.0; 67], vec![0.0; 66], vec![0.0; 66]);
    /// view.to_view(&q, &rest, &rest, &mut q_view, &mut v_view, &mut a_view)?;
    /// // The ankle's height below the pelvis: hip, knee and ankle hang below each other.
    /// assert!((q_view[1] + (0.076 + 0.422 + 0.434) * 1.65 / 1.741).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(figure: &Figure, link: usize, at: RootAt) -> Result<Self, RootViewError> {
        let rerooted = figure.reroot(link, at)?;
        let (root, declared_root) = (rerooted.links()[link], rerooted.links()[0]);
        let joint = figure.links()[0].joint().kind();
        Ok(Self {
            to_root: Path::new(figure, link, &root.placement.inverse())?,
            to_declared: Path::new(rerooted.figure(), declared_root.link, &declared_root.placement)?,
            root_armature: (0..joint.nv()).map(|k| T::from_f64(joint.armature(k))).collect(),
            joints: joint_maps(figure, &rerooted),
            declared: figure.layout().clone(),
            declared_root: DeclaredRoot::new(figure),
            rerooted,
        })
    }

    /// The figure of the view.
    pub fn figure(&self) -> &Figure {
        self.rerooted.figure()
    }

    /// The view's structure: where links and joints of the declared figure are found in it.
    pub fn rerooted(&self) -> &Rerooted {
        &self.rerooted
    }

    /// Takes a state of the declared figure into the view: `q` (rad, m) has length `nq` of its figure; `v`, `a` length `nv`.
    ///
    /// # Errors
    ///
    /// [`DynamicsError`] for a slice of the wrong length, an entry that is not finite, and a result beyond the precision.
    pub fn to_view(
        &self,
        q: &[T],
        v: &[T],
        a: &[T],
        q_view: &mut [T],
        v_view: &mut [T],
        a_view: &mut [T],
    ) -> Result<(), DynamicsError> {
        let (declared, view) = (&self.declared, self.view());
        check_state(declared, q, v, a)?;
        check_lengths(view, q_view, v_view, a_view)?;
        self.to_root.run(q, v, a).write_free(q_view, v_view, a_view);
        for map in &self.joints {
            let way = map.forth();
            map.positions(way, q, q_view);
            map.rates(way, q, v, v_view);
            map.rates(way, q, a, a_view);
        }
        check_results(q_view, v_view, a_view)
    }

    /// Takes a configuration of the declared figure into the view.
    ///
    /// # Errors
    ///
    /// As for [`to_view`](Self::to_view).
    pub fn positions_to_view(&self, q: &[T], q_view: &mut [T]) -> Result<(), DynamicsError> {
        check_positions(&self.declared, q)?;
        check_length("q_view", q_view.len(), self.view().nq())?;
        let root = self.to_root.run(q, &[], &[]);
        q_view[..3].copy_from_slice(root.translation.as_slice());
        q_view[3..7].copy_from_slice(&root.quaternion);
        self.joints.iter().for_each(|map| map.positions(map.forth(), q, q_view));
        check_result("a position of the view", q_view)
    }

    fn view(&self) -> &StateLayout {
        self.rerooted.figure().layout()
    }
}

impl RootView<f64> {
    /// Takes a state of the view to the declared figure.
    ///
    /// Of all the coordinates of the declared root's joint that mean the same, `q` gets the nearest to those that it holds
    /// when this is called: hand in the configuration of the frame before, or zeros.
    ///
    /// # Errors
    ///
    /// [`RootViewError::Root`] where the declared root's joint cannot take every motion, [`RootViewError::Lock`] at its gimbal
    /// lock; otherwise as for [`to_view`](Self::to_view).
    pub fn from_view(
        &self,
        q_view: &[f64],
        v_view: &[f64],
        a_view: &[f64],
        q: &mut [f64],
        v: &mut [f64],
        a: &mut [f64],
    ) -> Result<(), RootViewError> {
        let (declared, view) = (&self.declared, self.view());
        check_state(view, q_view, v_view, a_view)?;
        check_lengths(declared, q, v, a)?;
        let root = self.to_declared.run(q_view, v_view, a_view);
        self.declared_root.solve(&root, q, v, a)?;
        for map in &self.joints {
            let way = map.back();
            map.positions(way, q_view, q);
            map.rates(way, q_view, v_view, v);
            map.rates(way, q_view, a_view, a);
        }
        Ok(check_results(q, v, a)?)
    }
}

fn joint_maps(figure: &Figure, rerooted: &Rerooted) -> Vec<JointMap> {
    let (declared, view) = (figure.layout().joints(), rerooted.figure().layout().joints());
    let maps = rerooted.joints().iter().enumerate().filter_map(|(link, joint)| {
        joint.map(|joint| JointMap {
            declared: declared[link],
            view: view[joint.link],
            reversed: joint.reversed,
            quaternion: figure.links()[link].joint().kind().quaternion(),
        })
    });
    maps.collect()
}

fn check_state<T: Scalar>(layout: &StateLayout, q: &[T], v: &[T], a: &[T]) -> Result<(), DynamicsError> {
    check_positions(layout, q)?;
    check("v", v, layout.nv(), |k| layout.v_names()[k].clone())?;
    check("a", a, layout.nv(), |k| layout.v_names()[k].clone())
}

fn check_positions<T: Scalar>(layout: &StateLayout, q: &[T]) -> Result<(), DynamicsError> {
    check("q", q, layout.nq(), |k| layout.q_names()[k].clone())?;
    // A joint with more positions than velocities ends with a quaternion.
    for joint in layout.joints().iter().filter(|joint| joint.nq != joint.nv) {
        let from = joint.q + joint.nq - 4;
        check_quaternion(&[0, 1, 2, 3].map(|i| q[from + i]), || layout.q_names()[from].clone())?;
    }
    Ok(())
}

fn check_lengths<T>(layout: &StateLayout, q: &[T], v: &[T], a: &[T]) -> Result<(), DynamicsError> {
    check_length("the resulting q", q.len(), layout.nq())?;
    check_length("the resulting v", v.len(), layout.nv())?;
    check_length("the resulting a", a.len(), layout.nv())
}

fn check_results<T: Scalar>(q: &[T], v: &[T], a: &[T]) -> Result<(), DynamicsError> {
    check_result("a position seen from another root", q)?;
    check_result("a velocity seen from another root", v)?;
    check_result("an acceleration seen from another root", a)
}

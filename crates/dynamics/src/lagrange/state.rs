//! Scratch memory of the Lagrangian recursions, and what a call puts there before they run.

use super::constants::{Lagrangian, Link, LinkBase};
use super::equations::{Balance, Coordinate, Motion};
use super::products::{Placement, Products, product};
use crate::error::DynamicsError;
use crate::kinematics::is_finite;
use crate::scalar::Scalar;
use crate::spatial::direction::cross;
use crate::spatial::{Pose, Wrench};
use crate::workspace::{Workspace, check, check_length};
use nalgebra::{Matrix4, Vector3};

/// Scratch memory for one [`Lagrangian`]: allocated once, then no call allocates. Each thread needs one of its own.
#[derive(Clone, Debug)]
pub struct LagrangianWorkspace<T> {
    /// Keeps what each coordinate has done, and where ball and free joints stand.
    kernel: Workspace<T>,
    /// By ball or free joint, its base.
    bases: Vec<Matrix4<T>>,
    pub(super) coordinates: Vec<Coordinate<T>>,
    pub(super) motions: Vec<Motion<T>>,
    pub(super) balances: Vec<Option<Balance<T>>>,
    /// What acts on each rationalised link from outside, about the world's origin.
    wrenches: Vec<Option<Wrench<T>>>,
}

impl<T: Scalar> LagrangianWorkspace<T> {
    /// Scratch memory for `lagrangian`.
    pub fn new<P: Products>(lagrangian: &Lagrangian<T, P>) -> Self {
        let (links, zero, still) = (lagrangian.nv(), T::zero(), Matrix4::zeros());
        let coordinate = Coordinate { sine: zero, cosine: zero, s: zero, rate: zero, acceleration: zero };
        let motion =
            Motion { transform: still, w: still, rate: still, acceleration: still, by_coordinate: still };
        Self {
            kernel: Workspace::new(&lagrangian.tree),
            bases: vec![still; lagrangian.tree.spheres.len()],
            coordinates: vec![coordinate; links],
            motions: vec![motion; links],
            balances: vec![None; links],
            wrenches: vec![None; links],
        }
    }

    /// Checks the state, and takes it in.
    pub(super) fn take_in<P: Products>(
        &mut self,
        lagrangian: &Lagrangian<T, P>,
        q: &[T],
        v: &[T],
        a: &[T],
        external: &[(usize, Wrench<T>)],
    ) -> Result<(), DynamicsError> {
        let tree = &lagrangian.tree;
        self.kernel.set_positions(tree, q)?;
        check("v", v, tree.nv(), |index| tree.v_name(index))?;
        check("a", a, tree.nv(), |index| tree.v_name(index))?;
        self.take_wrenches(lagrangian, external)?;
        for (k, link) in lagrangian.links.iter().enumerate() {
            self.coordinates[k] = coordinate(link, &self.kernel, v[k], a[k]);
            if let LinkBase::Moved { slot, before, after } = &link.base {
                let placed = product::<P, Placement, T>(before, &homogeneous(&self.kernel.spheres[*slot]));
                self.bases[*slot] = product::<P, Placement, T>(&placed, after);
            }
        }
        for body in &tree.bodies {
            if body.sphere.is_some() {
                let range = body.first..body.end;
                chart(&mut self.coordinates[range.clone()], &v[range.clone()], &a[range]);
            }
        }
        Ok(())
    }

    /// Sums what acts on each rationalised link; what acts on a link that nothing moves, moves nothing.
    fn take_wrenches<P: Products>(
        &mut self,
        lagrangian: &Lagrangian<T, P>,
        external: &[(usize, Wrench<T>)],
    ) -> Result<(), DynamicsError> {
        self.wrenches.fill(None);
        let last = lagrangian.tree.link_count() - 1;
        for (index, &(link, wrench)) in external.iter().enumerate() {
            if link > last {
                return Err(DynamicsError::NoSuchLink { index, link, last });
            }
            if !(is_finite(&wrench.force) && is_finite(&wrench.moment)) {
                let (Wrench { force: f, moment: m }, link) = (wrench, lagrangian.tree.link_name(link));
                let wrench = format!("force {:?}, moment {:?}", [f.x, f.y, f.z], [m.x, m.y, m.z]);
                return Err(DynamicsError::WrenchNotFinite { index, link, wrench });
            }
            if let Some(carrier) = lagrangian.carriers[link] {
                let sum = &mut self.wrenches[carrier];
                *sum = Some(sum.map_or(wrench, |sum| Wrench {
                    force: sum.force + wrench.force,
                    moment: sum.moment + wrench.moment,
                }));
            }
        }
        Ok(())
    }

    /// The base of a rationalised link, if there is one.
    #[inline]
    pub(super) fn base<'a>(&'a self, link: &'a Link<T>) -> Option<&'a Matrix4<T>> {
        match &link.base {
            LinkBase::None => None,
            LinkBase::Constant(base) => Some(base),
            LinkBase::Moved { slot, .. } => Some(&self.bases[*slot]),
        }
    }

    /// The own terms of (4.10) and (4.11) of rationalised link `k`, with what acts on it from outside.
    #[inline]
    pub(super) fn own<P: Products>(&self, k: usize, link: &Link<T>) -> Option<Balance<T>> {
        let motion = &self.motions[k];
        let inertial = link.inertia.as_ref().map(|inertia| Balance::own::<P>(inertia, motion));
        let Some(Wrench { force, moment }) = &self.wrenches[k] else { return inertial };
        let origin = Vector3::new(motion.w.m14, motion.w.m24, motion.w.m34);
        let at_origin = moment - cross(&origin, force);
        Some(Balance::external(motion, force, &at_origin).plus::<P>(inertial))
    }
}

/// Checks the result's length, runs `recursion`, adds what the armature takes and checks what came out.
pub(super) fn finish<T: Scalar, P: Products>(
    lagrangian: &Lagrangian<T, P>,
    a: &[T],
    tau: &mut [T],
    recursion: impl FnOnce(&mut [T]),
) -> Result<(), DynamicsError> {
    let tree = &lagrangian.tree;
    check_length("tau", tau.len(), tree.nv())?;
    recursion(tau);
    for &(k, armature) in &tree.armature {
        tau[k] += armature * a[k];
    }
    crate::inverse::check_forces(tree, tau)
}

/// θ⁰ + θ, or s⁰ + s, with the rates of the coordinate.
#[inline]
fn coordinate<T: Scalar>(link: &Link<T>, kernel: &Workspace<T>, rate: T, acceleration: T) -> Coordinate<T> {
    let (zero, one) = (T::zero(), T::one());
    let turned = link.coordinate.filter(|_| !link.slides).map(|index| kernel.moved[index]);
    let (sine, cosine) = match (link.theta, turned) {
        (None, None) => (zero, one),
        (None, Some(angle)) | (Some(angle), None) => angle,
        // By the sum of angles, so that right angles stay exact.
        (Some((s0, c0)), Some((s, c))) => (s0 * c + c0 * s, c0 * c - s0 * s),
    };
    let slid = link.coordinate.filter(|_| link.slides).map(|index| kernel.moved[index].0);
    Coordinate { sine, cosine, s: slid.map_or(link.s, |slid| link.s + slid), rate, acceleration }
}

/// The second derivatives of the coordinates of a ball or free joint, whose angles θ about x, then y, then z, and
/// distances x before them, are zero now. With ω = w and ẋ = u, the link's velocities along its own axes,
///
/// ```text
/// ω = J(θ)·θ̇   θ̈ = ẇ − J̇·w   J̇·w = (w_y·w_z, −w_x·w_z, w_x·w_y)
/// ẋ = R(θ)·u    ẍ = u̇ + w × u
/// ```
///
/// At zero J and R are 1, so that rates and forces are those of the joint.
fn chart<T: Scalar>(coordinates: &mut [Coordinate<T>], v: &[T], a: &[T]) {
    let turns = v.len() - 3;
    let w = Vector3::new(v[turns], v[turns + 1], v[turns + 2]);
    let change = [w.y * w.z, -(w.x * w.z), w.x * w.y];
    for (i, change) in change.into_iter().enumerate() {
        coordinates[turns + i].acceleration = a[turns + i] - change;
    }
    if turns == 3 {
        let carried = cross(&w, &Vector3::new(v[0], v[1], v[2]));
        for i in 0..3 {
            coordinates[i].acceleration = a[i] + carried[i];
        }
    }
}

fn homogeneous<T: Scalar>(pose: &Pose<T>) -> Matrix4<T> {
    let mut matrix = pose.rotation.to_homogeneous();
    matrix.fixed_view_mut::<3, 1>(0, 3).copy_from(&pose.translation);
    matrix
}

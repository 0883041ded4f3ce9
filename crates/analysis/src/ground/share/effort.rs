//! The split with the least moments at the joints.

use super::sharing::{Parts, Sharing};
use crate::ground::GroundError;
use crate::reaction::slides;
use crate::split::FootSupport;
use nalgebra::{Cholesky, DMatrix, DVector, Matrix3, Matrix6, Vector3, Vector6};
use solaris_dynamics::{
    DynamicsError, Frame, JacobianAxes, Workspace, Wrench, forward_kinematics, inverse_dynamics, jacobian,
};

/// What a foot that comes or leaves weighs beside the joints.
const WEIGHT: f64 = 0.05;

/// A share below this is none: its foot would get less of the wrench than that.
const LEAST: f64 = 1e-9;

pub(super) fn share(sharing: &Sharing<'_>) -> Result<Vec<Parts>, GroundError> {
    let frames = sharing.prepared.frames(|workspace, row| {
        let Some(feet) = sharing.supports(row) else { return Ok(sharing.nothing()) };
        match Sharing::only(&feet) {
            Some(foot) => Ok(sharing.whole(row, foot)),
            None => Effort { sharing, row, feet: &feet }.least(workspace),
        }
    })?;
    Ok(frames)
}

/// One frame with several feet.
pub(super) struct Effort<'a> {
    pub(super) sharing: &'a Sharing<'a>,
    pub(super) row: usize,
    pub(super) feet: &'a [FootSupport],
}

impl Effort<'_> {
    /// With `u` the wrenches about the nominal centres, forces over `m g` and moments over `m g h`, and the foot with
    /// the greatest share bearing what the others `i` leave, `uₙ = U − Σ Xᵢ uᵢ`:
    ///
    /// ```text
    /// τ = c − Σ Bᵢ uᵢ      c = τ₀ − Jₙᵀ U      Bᵢ = Jᵢᵀ − Jₙᵀ Xᵢ
    /// (BᵀB + ρ + Xᵀ ρₙ X) u = Bᵀ c + Xᵀ ρₙ U
    /// ```
    fn least(&self, workspace: &mut Workspace<f64>) -> Result<Parts, DynamicsError> {
        let sharing = self.sharing;
        let (weight, length) = (sharing.prepared.weight, sharing.height(self.row).max(1e-3));
        let share = |foot: usize| self.feet[foot].share;
        let mut acting: Vec<usize> = (0..self.feet.len()).filter(|foot| share(*foot) > LEAST).collect();
        acting.sort_by(|a, b| share(*b).total_cmp(&share(*a)));
        let mut parts = sharing.nothing();
        let Some((&last, others)) = acting.split_first() else { return Ok(parts) };

        let total = sharing.total[self.row].wrench();
        let about = total.moment - self.feet[last].cop.cross(&total.force);
        let whole = stack(&(total.force / weight), &(about / (weight * length)));
        let free = self.moments(workspace, weight, length)?;
        // Where the levers' points are in their links.
        forward_kinematics(&sharing.prepared.tree, workspace, sharing.prepared.q(self.row))?;
        let own = self.levers(workspace, last, length)?;
        let (c, own_cost) = (free - &own * whole, self.cost(last, length));
        let unknowns = 6 * others.len();
        let mut b = DMatrix::zeros(c.len(), unknowns);
        let mut x = DMatrix::zeros(6, unknowns);
        let mut normal = DMatrix::zeros(unknowns, unknowns);
        for (k, &foot) in others.iter().enumerate() {
            let arm = (self.feet[foot].cop - self.feet[last].cop) / length;
            let carry = carried(&arm);
            b.columns_mut(6 * k, 6).copy_from(&(self.levers(workspace, foot, length)? - &own * carry));
            x.columns_mut(6 * k, 6).copy_from(&carry);
            normal
                .view_mut((6 * k, 6 * k), (6, 6))
                .copy_from(&Matrix6::from_diagonal(&self.cost(foot, length)));
        }
        let weighed = x.transpose() * Matrix6::from_diagonal(&own_cost);
        normal += b.transpose() * &b + &weighed * &x;
        let right = b.transpose() * &c + &weighed * whole;
        // Positive definite: every foot but the one with the greatest share has a cost of its own.
        let Some(solved) = Cholesky::new(normal) else {
            return Err(DynamicsError::Overflow {
                what: "the split by effort".to_owned(),
                value: "inf".to_owned(),
            });
        };
        let u = solved.solve(&right);
        parts[last] = total;
        for (k, &foot) in others.iter().enumerate() {
            let at = |i: usize| Vector3::new(u[6 * k + i], u[6 * k + i + 1], u[6 * k + i + 2]);
            let force = at(0) * weight;
            let moment = self.feet[foot].cop.cross(&force) + at(3) * (weight * length);
            parts[last].force -= force;
            parts[last].moment -= moment;
            parts[foot] = Wrench { force, moment };
        }
        Ok(parts)
    }

    /// `w (1/sᵢ − 1)` of the three forces, and of the three moments over half the length of the sole.
    fn cost(&self, foot: usize, length: f64) -> Vector6<f64> {
        let cost = WEIGHT * (1.0 / self.feet[foot].share - 1.0).max(0.0);
        let half = self.sharing.length_of_sole(self.row, foot) / 2.0;
        let lever = if half > 1e-3 * length { length / half } else { 1e3 };
        stack(&Vector3::repeat(cost), &Vector3::repeat(cost * lever * lever))
    }

    /// The scaled forces of the degrees of freedom that count, without the ground.
    pub(super) fn moments(
        &self,
        workspace: &mut Workspace<f64>,
        weight: f64,
        length: f64,
    ) -> Result<DVector<f64>, DynamicsError> {
        let prepared = self.sharing.prepared;
        let mut tau = vec![0.0; prepared.tree.nv()];
        let q = prepared.q(self.row);
        inverse_dynamics(
            &prepared.tree,
            workspace,
            q,
            prepared.v(self.row),
            prepared.a(self.row),
            &[],
            &mut tau,
        )?;
        prepared.figure.fold_forces(q, &mut tau);
        self.scale(&mut tau, length);
        Ok(DVector::from_vec(tau) / (weight * length))
    }

    /// `Jᵀ` of a foot (`nv` × 6): the scaled forces of the degrees of freedom that a scaled wrench about its nominal
    /// centre of pressure takes the place of.
    pub(super) fn levers(
        &self,
        workspace: &mut Workspace<f64>,
        foot: usize,
        length: f64,
    ) -> Result<Levers, DynamicsError> {
        let prepared = self.sharing.prepared;
        let q = prepared.q(self.row);
        let link = self.sharing.soles[foot].foot;
        let point = workspace.pose(link).inverse().transform(&self.feet[foot].cop);
        let mut rows = DMatrix::zeros(6, prepared.tree.nv());
        jacobian(&prepared.tree, workspace, q, &Frame::at(link, point), JacobianAxes::World, &mut rows)?;
        let mut out = Levers::zeros(prepared.tree.nv());
        let mut tau = vec![0.0; prepared.tree.nv()];
        for k in 0..6 {
            let unit = if k < 3 { 1.0 / length } else { 1.0 };
            for (tau, entry) in tau.iter_mut().zip(rows.row(k).iter()) {
                *tau = entry * unit;
            }
            prepared.figure.fold_forces(q, &mut tau);
            self.scale(&mut tau, length);
            for (i, tau) in tau.iter().enumerate() {
                out[(i, k)] = *tau;
            }
        }
        Ok(out)
    }

    /// Forgets the root's and the toes' degrees of freedom; a sliding one counts by its force times `length` (m).
    fn scale(&self, tau: &mut [f64], length: f64) {
        let prepared = self.sharing.prepared;
        for (index, (link, at)) in
            prepared.figure.links().iter().zip(prepared.figure.layout().joints()).enumerate()
        {
            let left_out = index == 0 || self.sharing.soles.iter().any(|sole| sole.toes == Some(index));
            for (tau, slides) in tau[at.v..at.v + at.nv].iter_mut().zip(slides(link.joint().kind())) {
                *tau *= if left_out {
                    0.0
                } else if slides {
                    length
                } else {
                    1.0
                };
            }
        }
    }
}

/// `nv` × 6.
pub(super) type Levers = nalgebra::OMatrix<f64, nalgebra::Dyn, nalgebra::U6>;

/// What a wrench about one point is about another, `arm` behind it.
fn carried(arm: &Vector3<f64>) -> Matrix6<f64> {
    let mut out = Matrix6::identity();
    out.fixed_view_mut::<3, 3>(3, 0)
        .copy_from(&Matrix3::new(0.0, -arm.z, arm.y, arm.z, 0.0, -arm.x, -arm.y, arm.x, 0.0));
    out
}

pub(super) fn stack(first: &Vector3<f64>, second: &Vector3<f64>) -> Vector6<f64> {
    Vector6::new(first.x, first.y, first.z, second.x, second.y, second.z)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::ground::{PlacedFeet, Stance, Stances, balance, soles};
    use crate::prepared::PreparedMotion;
    use solaris_model::{Motion, MotionInfo};

    /// What the joints that count have to bear, `Σ (τ/(m g h))²`, by inverse dynamics with the feet loaded.
    pub(in crate::ground::share) fn at_joints(sharing: &Sharing<'_>, row: usize, parts: &Parts) -> f64 {
        let prepared = sharing.prepared;
        let scale = prepared.weight * sharing.height(row);
        let loads = sharing.soles.iter().zip(parts);
        let loads = loads.map(|(sole, part)| (sole.foot, Wrench { force: part.force, moment: part.moment }));
        let mut tau = vec![0.0; prepared.tree.nv()];
        let (q, v, a) = (prepared.q(row), prepared.v(row), prepared.a(row));
        let mut workspace = Workspace::new(&prepared.tree);
        inverse_dynamics(&prepared.tree, &mut workspace, q, v, a, &loads.collect::<Vec<_>>(), &mut tau)
            .expect("finite");
        let joints = prepared.figure.layout().joints().iter().enumerate().skip(1);
        let counts = joints.filter(|(index, _)| sharing.soles.iter().all(|sole| sole.toes != Some(*index)));
        counts.flat_map(|(_, at)| &tau[at.v..at.v + at.nv]).map(|tau| (tau / scale).powi(2)).sum()
    }

    /// The functional as the documentation writes it.
    fn functional(sharing: &Sharing<'_>, row: usize, parts: &Parts) -> f64 {
        let (weight, feet) = (sharing.prepared.weight, sharing.supports(row).expect("feet that stand"));
        let mut sum = at_joints(sharing, row, parts);
        for (foot, part) in parts.iter().enumerate() {
            let (force, half) = (part.force / weight, sharing.length_of_sole(row, foot) / 2.0);
            let moment = (part.moment - feet[foot].cop.cross(&part.force)) / (weight * half);
            sum += 0.05 * (1.0 / feet[foot].share - 1.0) * (force.norm_squared() + moment.norm_squared());
        }
        sum
    }

    /// A person on two feet, somehow bent and on the move, in a single frame.
    pub(in crate::ground::share) fn on_two_feet(ask: impl FnOnce(&Sharing<'_>)) {
        let figure = solaris_model::human(1.75, 73.0).expect("a person");
        let gravity = Vector3::new(0.0, -9.81, 0.0);
        let mut q: Vec<f64> = (0..figure.layout().nq()).map(|i| 0.1 * (i as f64).sin()).collect();
        (q[0], q[1], q[2]) = (0.05, 0.9, 0.08);
        let v = vec![0.1; figure.layout().nv()];
        let info = MotionInfo::recorded(&figure, gravity, &[0.0]);
        let motion = Motion::new(&figure, info, vec![0.0], [q, v.clone(), v]).expect("a motion");
        let prepared = PreparedMotion::new(&figure, &motion).expect("ready");
        let list = [0, 1].map(|foot| Stance { foot, start: -1.0, end: 1.0 }).to_vec();
        let stances =
            Stances { list, belt: Vector3::zeros(), level: 0.0, footings: Vec::new(), method: "told" };
        let total = balance(&prepared, 0.0).expect("a total");
        let feet = PlacedFeet::new(&prepared, soles(&figure)).expect("placed");
        ask(&Sharing::new(&feet, &stances, &total));
    }

    #[test]
    fn other_wrenches_with_the_same_sum_cost_more() {
        on_two_feet(|sharing| {
            let shares = sharing.supports(0).expect("feet").iter().map(|foot| foot.share).collect::<Vec<_>>();
            assert!(shares.iter().all(|share| (0.05..0.95).contains(share)), "{shares:?}");
            let best = super::share(sharing).expect("parts").remove(0);
            let least = functional(sharing, 0, &best);
            for k in 0..6 {
                let step = if k < 3 { 1.0 } else { 0.1 };
                let cost = |sign: f64| {
                    let mut other = best.clone();
                    for (part, sign) in other.iter_mut().zip([sign, -sign]) {
                        if k < 3 { part.force[k] += sign * step } else { part.moment[k - 3] += sign * step }
                    }
                    functional(sharing, 0, &other)
                };
                let (up, down) = (cost(1.0) - least, cost(-1.0) - least);
                // A parabola with its least value here rises alike to both sides.
                assert!(up > 0.0 && (up - down).abs() < 1e-6 * up, "{k}: {up:e} {down:e}");
            }
        });
    }
}

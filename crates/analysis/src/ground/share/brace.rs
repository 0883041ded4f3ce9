//! What two feet that stand push against each other.
//!
//! Of the force along the line between two feet the laws of motion give the sum. People who stand push each foot outwards, about
//! along the line from the hip to the foot, and less as they squat: then it would cost the joints more. So the pair `±f` that is added to the
//! pivot split is, over one time in which two feet stand that is no double support of walking,
//!
//! ```text
//! f = w (fₑ + c)      w = 4 s_a s_b      c = Σ w (f_h − fₑ)/Σ w
//! ```
//!
//! where `fₑ` leaves the least moments at the joints in each frame, and `f_h` lets the forces point at the hips as nearly as may be:
//! with `L_i = Fₙᵢ (H_i − P_i)·e/((H_i − P_i)·n)` along the line `e`, `f_h = s_b (L_a − F_a·e) − s_a (L_b − F_b·e)`. The level
//! is the hips', the change is the joints'. It moves no centre of pressure and leaves the whole wrench as it is, since both press on the line.

use super::effort::{Effort, stack};
use super::pivot;
use super::sharing::{Parts, Sharing};
use crate::ground::GroundError;
use crate::split::FootSupport;
use nalgebra::{DVector, Vector3};
use solaris_dynamics::{DynamicsError, Workspace, forward_kinematics};

/// Nearer feet (m) have no line between them.
const APART: f64 = 0.05;

/// The greatest tangential over normal force along the line between the feet; people who squat have up to 0.25.
const LEAN: f64 = 0.3;

/// The pivot split, and what two feet push against each other.
pub(super) fn share(sharing: &Sharing<'_>) -> Result<Vec<Parts>, GroundError> {
    let mut found = sharing.prepared.frames(|workspace, row| {
        let feet = sharing.supports(row);
        let parts = pivot::share(sharing, row, feet.as_deref());
        let push = match feet {
            Some(feet) => Push::of(sharing, row, &feet, &parts, workspace)?,
            None => None,
        };
        Ok((parts, push))
    })?;
    for run in found.chunk_by_mut(|(_, a), (_, b)| a.as_ref().map(Push::pair) == b.as_ref().map(Push::pair)) {
        let pushes = || run.iter().filter_map(|(_, push)| push.as_ref());
        let weight: f64 = pushes().map(|push| push.weight).sum();
        let level = pushes().map(|push| push.weight * (push.by_hips - push.by_joints)).sum::<f64>() / weight;
        for (parts, push) in run {
            if let Some(push) = push {
                push.add(parts, level);
            }
        }
    }
    Ok(found.into_iter().map(|(parts, _)| parts).collect())
}

/// What two feet push against each other in a frame.
struct Push {
    feet: [usize; 2],
    /// Where they press (m).
    at: [Vector3<f64>; 2],
    /// From the first to the second, of length 1.
    along: Vector3<f64>,
    weight: f64,
    /// What they bear (N).
    normal: [f64; 2],
    /// Force on the first foot along the line (N).
    by_hips: f64,
    by_joints: f64,
}

impl Push {
    /// `None` but for two feet that are apart, bear something each, and do not walk.
    fn of(
        sharing: &Sharing<'_>,
        row: usize,
        feet: &[FootSupport],
        parts: &Parts,
        workspace: &mut Workspace<f64>,
    ) -> Result<Option<Self>, DynamicsError> {
        if sharing.is_regular(sharing.prepared.time()[row]) {
            return Ok(None);
        }
        let mut standing = (0..feet.len()).filter(|foot| feet[*foot].share > LEAST);
        let (Some(a), Some(b), None) = (standing.next(), standing.next(), standing.next()) else {
            return Ok(None);
        };
        let [at, to] = [feet[a].cop, feet[b].cop];
        let Some(along) = (to - at).try_normalize(APART) else { return Ok(None) };
        let (prepared, up) = (sharing.prepared, &sharing.prepared.up);
        forward_kinematics(&prepared.tree, workspace, prepared.q(row))?;
        // L_i − F_i·e of a foot.
        let lean = |foot: usize| {
            let leg = workspace.pose(sharing.hips[foot]).translation - feet[foot].cop;
            let (height, force) = (leg.dot(up), parts[foot].force);
            if height > 0.0 { force.dot(up) * leg.dot(&along) / height - force.dot(&along) } else { 0.0 }
        };
        let by_hips = feet[b].share * lean(a) - feet[a].share * lean(b);
        let effort = Effort { sharing, row, feet };
        let by_joints = least(&effort, [(a, 1.0), (b, -1.0)], &along, parts, workspace)?;
        let weight = 4.0 * feet[a].share * feet[b].share;
        let normal = [a, b].map(|foot| parts[foot].force.dot(up));
        Ok(Some(Self { normal, feet: [a, b], at: [at, to], along, weight, by_hips, by_joints }))
    }

    fn pair(&self) -> [usize; 2] {
        self.feet
    }

    /// A push (N) that lets neither foot lean by more than [`LEAN`], if it does not do so without it.
    fn within(&self, parts: &Parts, push: f64) -> f64 {
        let [a, b] = self.feet.map(|foot| parts[foot].force);
        let [most_a, most_b] = self.normal.map(|normal| LEAN * normal.max(0.0));
        let low = (-most_a - a.dot(&self.along)).max(b.dot(&self.along) - most_b);
        let high = (most_a - a.dot(&self.along)).min(b.dot(&self.along) + most_b);
        push.clamp(low.min(0.0), high.max(0.0))
    }

    fn add(&self, parts: &mut Parts, level: f64) {
        let force = self.along * self.within(parts, self.weight * (self.by_joints + level));
        for ((foot, at), sign) in self.feet.into_iter().zip(self.at).zip([1.0, -1.0]) {
            parts[foot].force += force * sign;
            parts[foot].moment += at.cross(&force) * sign;
        }
    }
}

/// A share below this is none.
const LEAST: f64 = 1e-9;

/// The pair of forces (N) along a line with which the moments at the joints are least: with those of the parts, `τ`, and what a unit of the
/// pair takes away, `g`, it is `g·τ/|g|²`.
fn least(
    effort: &Effort<'_>,
    pair: [(usize, f64); 2],
    along: &Vector3<f64>,
    parts: &Parts,
    workspace: &mut Workspace<f64>,
) -> Result<f64, DynamicsError> {
    let sharing = effort.sharing;
    let (weight, length) = (sharing.prepared.weight, sharing.height(effort.row).max(1e-3));
    let mut tau = effort.moments(workspace, weight, length)?;
    forward_kinematics(&sharing.prepared.tree, workspace, sharing.prepared.q(effort.row))?;
    let mut taken = DVector::zeros(tau.len());
    for (foot, sign) in pair {
        let levers = effort.levers(workspace, foot, length)?;
        let part = &parts[foot];
        let moment = part.moment - effort.feet[foot].cop.cross(&part.force);
        tau -= &levers * stack(&(part.force / weight), &(moment / (weight * length)));
        taken += &levers * stack(&(along * (sign / weight)), &Vector3::zeros());
    }
    let force = taken.dot(&tau) / taken.norm_squared();
    Ok(if force.is_finite() { force } else { 0.0 })
}

#[cfg(test)]
mod tests {
    use super::super::effort::tests::{at_joints, on_two_feet};
    use super::*;

    /// Also where each foot has a moment of its own about its centre of pressure.
    #[test]
    fn another_push_costs_the_joints_more() {
        on_two_feet(|sharing| {
            let feet = sharing.supports(0).expect("feet that stand");
            let mut parts = pivot::share(sharing, 0, Some(&feet));
            for (part, sign) in parts.iter_mut().zip([1.0, -1.0]) {
                part.moment += Vector3::new(20.0, -10.0, 30.0) * sign;
            }
            let along = (feet[1].cop - feet[0].cop).normalize();
            let effort = Effort { sharing, row: 0, feet: &feet };
            let mut workspace = Workspace::new(&sharing.prepared.tree);
            let pair = [(0, 1.0), (1, -1.0)];
            let best = least(&effort, pair, &along, &parts, &mut workspace).expect("a push");
            let cost = |push: f64| {
                let mut parts = parts.clone();
                for (foot, sign) in pair {
                    let force = along * (sign * push);
                    parts[foot].force += force;
                    parts[foot].moment += feet[foot].cop.cross(&force);
                }
                at_joints(sharing, 0, &parts)
            };
            let [here, up, down] = [best, best + 10.0, best - 10.0].map(cost);
            // A parabola with its least value here rises alike to both sides.
            let rises = up > here && (up - down).abs() < 1e-6 * (up - here);
            assert!(rises && best.abs() > 1.0, "{best} N: {:e} {:e}", up - here, down - here);
        });
    }
}

//! Positions, velocities, accelerations and forces of degrees of freedom that follow others.

use crate::figure::Figure;
use crate::follower::Follower;
use crate::joint::JointKind;

impl Figure {
    /// The degrees of freedom that follow others, in the order of the figure.
    pub fn followers(&self) -> &[Follower] {
        &self.followers
    }

    /// Whether the degree of freedom `dof` follows another.
    pub fn follows(&self, dof: usize) -> bool {
        self.followers.iter().any(|follower| follower.dof == dof)
    }

    /// The same figure in which no degree of freedom follows another: those that did are free.
    #[must_use]
    pub fn untied(&self) -> Self {
        let mut free = self.clone();
        for link in &mut free.links {
            if let JointKind::Axes(dofs) = &mut link.joint.kind {
                for dof in dofs {
                    dof.follows = None;
                }
            }
        }
        free.followers.clear();
        free
    }

    /// Puts every follower where its leader puts it, in position, velocity and acceleration.
    ///
    /// ```text
    /// y = f(x)      ẏ = f′·ẋ      ÿ = f′·ẍ + f″·ẋ²
    /// ```
    ///
    /// `q` has length `nq`, `v` and `a` have length `nv`; only the entries of followers change.
    ///
    /// # Panics
    ///
    /// Where a slice is shorter than that.
    pub fn follow(&self, q: &mut [f64], v: &mut [f64], a: &mut [f64]) {
        for f in &self.followers {
            let [value, first, second] = f.curve.at(q[f.leader_coordinate]);
            let rate = v[f.leader];
            q[f.coordinate] = value;
            v[f.dof] = first * rate;
            a[f.dof] = first * a[f.leader] + second * rate * rate;
        }
    }

    /// Gives the forces of followers to their leaders, at the configuration `q` (length `nq`): what the leader's coordinate
    /// feels of all that moves with it.
    ///
    /// ```text
    /// τ_x ← τ_x + Σ f′·τ_y        τ_y ← 0
    /// ```
    ///
    /// Virtual work asks for just this, so the result is exact for any motion that obeys [`follow`](Self::follow).
    ///
    /// # Panics
    ///
    /// Where `q` is shorter than `nq` or `tau` than `nv`.
    pub fn fold_forces(&self, q: &[f64], tau: &mut [f64]) {
        for f in &self.followers {
            let force = std::mem::take(&mut tau[f.dof]);
            tau[f.leader] += f.curve.at(q[f.leader_coordinate])[1] * force;
        }
    }
}

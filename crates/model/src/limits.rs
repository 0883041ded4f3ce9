//! The check of positions against the limits of the degrees of freedom.

use crate::figure::Figure;
use crate::joint::AxisKind;

/// An angle (rad) that is rather one in degrees: two turns.
pub(crate) const MANY_TURNS: f64 = 4.0 * std::f64::consts::PI;

/// The excess of a motion beyond the range of a degree of freedom.
#[doc(alias = "joint limits")]
#[doc(alias = "range of motion")]
#[doc(alias = "rom")]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LimitExcess {
    /// Its index in `v`.
    pub dof: usize,
    /// Its position where it is farthest outside (rad or m).
    pub position: f64,
    /// By how much it is outside there (rad or m), above zero.
    pub by: f64,
    /// Index of that row.
    pub row: usize,
}

impl Figure {
    /// The degrees of freedom, as indices in `v`, whose positions `q` (`nq` a row) turn farther than two turns: rather
    /// degrees than radians.
    pub fn many_turns(&self, q: &[f64]) -> Vec<usize> {
        let mut found = Vec::new();
        for (link, at) in self.links().iter().zip(self.layout().joints()) {
            for (i, dof) in link.joint().kind().axes().iter().enumerate() {
                let mut column = q.iter().skip(at.q + i).step_by(self.layout().nq());
                let turns = dof.axis.kind == AxisKind::Rotation && column.any(|x| x.abs() > MANY_TURNS);
                found.extend(turns.then_some(at.v + i));
            }
        }
        found
    }

    /// The degrees of freedom that the positions `q` (`nq` a row) take out of their limits, each where it is farthest
    /// outside.
    ///
    /// ```
    /// use solaris_model::{FigureBuilder, Joint, LinkSpec};
    /// let joint = Joint::new("elbow").rx().limited(-2.5, 0.0);
    /// let arm = FigureBuilder::new("arm").link(LinkSpec::root("forearm", joint).mass(1.0)).build()?;
    /// let found = arm.limit_excess(&[-1.0, 0.25, 0.125]);
    /// assert_eq!((found[0].by, found[0].row), (0.25, 1));
    /// assert!(arm.limit_excess(&[-2.5, 0.0]).is_empty());
    /// # Ok::<(), solaris_model::FigureError>(())
    /// ```
    #[doc(alias = "joint limits")]
    #[doc(alias = "range of motion")]
    #[doc(alias = "rom")]
    pub fn limit_excess(&self, q: &[f64]) -> Vec<LimitExcess> {
        let mut found = Vec::new();
        for (link, at) in self.links().iter().zip(self.layout().joints()) {
            for (i, dof) in link.joint().kind().axes().iter().enumerate() {
                let Some(limits) = dof.limits else { continue };
                let column = q.iter().skip(at.q + i).step_by(self.layout().nq()).enumerate();
                let outside = column.map(|(row, &position)| {
                    let by = (limits.lower - position).max(position - limits.upper);
                    LimitExcess { dof: at.v + i, position, by, row }
                });
                found.extend(outside.max_by(|a, b| a.by.total_cmp(&b.by)).filter(|worst| worst.by > 0.0));
            }
        }
        found
    }
}

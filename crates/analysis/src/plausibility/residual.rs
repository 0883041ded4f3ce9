//! Residuals beside published thresholds.

use crate::ground::GroundError;
use crate::inverse::InverseReport;
use crate::loads::known_at;
use crate::prepared::PreparedMotion;
use nalgebra::Vector3;
use solaris_dynamics::{Workspace, center_of_mass};
use solaris_model::{AxisKind, JointKind, MeasuredForce};

/// Share of the greatest external force that residual forces should stay below: Hicks, Uchida, Seth, Rajagopal and Delp (2015),
/// *Is my model good enough?*, J. Biomech. Eng. 137:020905.
pub const RESIDUAL_FORCE: f64 = 0.05;

/// Share of the greatest external force times the height of the centre of mass that residual moments should stay below; there too.
pub const RESIDUAL_MOMENT: f64 = 0.01;

/// So many times the thresholds of force and moment, motion and forces are not of one trial; below, nothing is known to be wrong.
const ANOTHER: [f64; 2] = [5.0, 10.0];

/// The residuals of a motion with measured forces, and what is published as acceptable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ResidualCheck {
    /// Greatest residual force (N).
    pub force: f64,
    /// What it should stay below (N).
    pub force_threshold: f64,
    /// Greatest residual moment (N m).
    pub moment: f64,
    /// What it should stay below (N m).
    pub moment_threshold: f64,
    /// Greatest sum of the measured forces (N).
    pub greatest_external: f64,
    /// Mean height of the centre of mass above the ground (m).
    pub com_height: f64,
}

impl ResidualCheck {
    /// Whether both are below.
    pub fn is_met(&self) -> bool {
        self.force <= self.force_threshold && self.moment <= self.moment_threshold
    }

    /// What residuals of this size come from, as a rule.
    pub fn cause(&self) -> &'static str {
        let over = [self.force / self.force_threshold, self.moment / self.moment_threshold];
        if self.is_met() {
            "as good as published"
        } else if over.iter().zip(ANOTHER).all(|(over, another)| *over <= another) {
            "usual before residuals are reduced (skin that moves, masses of tables, a filter too wide)"
        } else {
            "motion and plates do not fit (another trial, another time, a plate that is missing)"
        }
    }
}

/// Residuals beside the published thresholds; `level` is the ground's height (m, along up). `None` without measured forces.
///
/// The residual is what is left along the root's own degrees of freedom: a figure in a plane holds the rest. Frames within
/// `unsettled` seconds of either end, which are a filter's ([`crate::Differentiated::unsettled`]), do not count.
///
/// # Errors
///
/// The first state that the kernel refuses.
#[doc(alias = "residual reduction")]
pub fn check_residual(
    prepared: &PreparedMotion<'_>,
    found: &InverseReport,
    measured: &[MeasuredForce],
    level: f64,
    unsettled: f64,
) -> Result<Option<ResidualCheck>, GroundError> {
    let time = prepared.time();
    let whole = |t: f64| measured.iter().filter_map(|record| known_at(record, t)).map(|c| c.force).sum();
    let sizes = time.iter().map(|t| Vector3::norm(&whole(*t)));
    let greatest_external = sizes.fold(0.0, f64::max);
    if greatest_external <= 0.0 {
        return Ok(None);
    }
    let mut workspace = Workspace::new(&prepared.tree);
    let mut heights = 0.0;
    for (row, &time) in time.iter().enumerate() {
        let com = center_of_mass(&prepared.tree, &mut workspace, prepared.q(row))
            .map_err(|source| GroundError::State { time, source })?;
        heights += com.dot(&prepared.up) - level;
    }
    let com_height = heights / time.len().max(1) as f64;
    let (force, moment) = greatest(prepared, found, unsettled);
    Ok(Some(ResidualCheck {
        force,
        force_threshold: RESIDUAL_FORCE * greatest_external,
        moment,
        moment_threshold: RESIDUAL_MOMENT * com_height.abs() * greatest_external,
        greatest_external,
        com_height,
    }))
}

/// Greatest residual force (N) and moment (N m).
fn greatest(prepared: &PreparedMotion<'_>, found: &InverseReport, unsettled: f64) -> (f64, f64) {
    let root = prepared.figure.links()[0].joint().kind();
    let (time, nv) = (prepared.time(), prepared.tree.nv().max(1));
    let slides: Vec<bool> = match root {
        JointKind::Axes(dofs) => dofs.iter().map(|dof| dof.axis.kind == AxisKind::Translation).collect(),
        kind => (0..kind.nv()).map(|i| kind.nv() == 6 && i < 3).collect(),
    };
    let [Some(first), Some(last)] = [time.first(), time.last()] else { return (0.0, 0.0) };
    let settled = first + unsettled..=last - unsettled;
    let settled = |t: &f64| settled.is_empty() || settled.contains(t);
    let size = |row: &[f64], slide: bool| {
        let own = row.iter().zip(&slides).filter(|(_, slides)| **slides == slide);
        own.map(|(tau, _)| tau * tau).sum::<f64>().sqrt()
    };
    let rows = time.iter().zip(found.tau.chunks_exact(nv)).filter(|(t, _)| settled(t));
    rows.fold((0.0, 0.0), |(force, moment): (f64, f64), (_, row)| {
        (force.max(size(row, true)), moment.max(size(row, false)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Up to five times the threshold of force and ten times that of moment.
    #[test]
    fn the_cause_is_told_by_how_many_times_the_thresholds_are_passed() {
        for (force, moment, said) in [
            (1.0, 1.0, "as good"),
            (1.5, 0.5, "usual"),
            (0.5, 1.5, "usual"),
            (5.0, 10.0, "usual"),
            (5.5, 0.5, "do not fit"),
            (0.5, 10.5, "do not fit"),
            (0.5, 40.0, "do not fit"),
            (40.0, 0.5, "do not fit"),
        ] {
            let check = ResidualCheck {
                force: force * 32.0,
                force_threshold: 32.0,
                moment: moment * 4.0,
                moment_threshold: 4.0,
                greatest_external: 640.0,
                com_height: 0.625,
            };
            assert!(check.cause().contains(said), "{force}, {moment}: {}", check.cause());
        }
    }
}

//! The summary of inverse dynamics, for people.

use super::report::{Load, Report};
use crate::words::{row, short};
use std::io::{Result, Write};

impl Report {
    pub(super) fn write(&self, out: &mut dyn Write) -> Result<()> {
        self.given.write(out)?;
        self.write_forces(out)?;
        self.given.write_doubts(out)?;
        if let Some(ground) = &self.ground {
            ground.write(out)?;
        }
        if let Some(plausible) = &self.plausibility {
            plausible.write(out)?;
        }
        let width = self.joints.iter().map(|joint| joint.dof.chars().count()).max().unwrap_or(0).max(18);
        writeln!(out, "\n  {:<width$}{:>12}{:>12}", "joint forces", "rms", "greatest")?;
        for joint in self.joints.iter().filter(|joint| !joint.root) {
            joint.write(out, width)?;
        }
        if self.given.root_is_free {
            self.write_residual(out, width)?;
        }
        Ok(())
    }

    /// What pushes from outside.
    fn write_forces(&self, out: &mut dyn Write) -> Result<()> {
        row(out, "forces", &self.external_forces)?;
        self.force_notes.iter().try_for_each(|note| row(out, "", note))?;
        if !self.unused_forces.is_empty() {
            let names: Vec<String> = self.unused_forces.iter().map(|prefix| format!("'{prefix}'")).collect();
            let names = names.join(", ");
            row(out, "", &format!("not used: the forces of {names}; --external and --plate apply them"))?;
        }
        if !self.passive {
            row(out, "passive", "armature, damping, springs and friction left out")?;
        }
        Ok(())
    }

    fn write_residual(&self, out: &mut dyn Write, width: usize) -> Result<()> {
        writeln!(out, "\n  {:<width$}{:>12}{:>12}", "residual at the root", "rms", "greatest")?;
        for joint in self.joints.iter().filter(|joint| joint.root) {
            joint.write(out, width)?;
        }
        // A joint of fewer degrees of freedom holds the rest.
        if let (6, Some(r)) = (self.joints.iter().filter(|joint| joint.root).count(), &self.residual) {
            let size = |name: &str, rms, greatest, at_s, unit| Load {
                dof: name.to_owned(),
                unit,
                rms,
                greatest,
                at_s,
                root: true,
            };
            size("whole force", r.force_rms_n, r.force_greatest_n, r.force_at_s, "N").write(out, width)?;
            size("whole moment", r.moment_rms_nm, r.moment_greatest_nm, r.moment_at_s, "N m")
                .write(out, width)?;
        }
        let what = match self.ground {
            None => {
                "measured\n  forces disagree by; without measured forces, they are all that the ground does."
            }
            Some(_) => {
                "the ground\n  disagree by: rounding while a foot stands, and all that is left where none does."
            }
        };
        writeln!(
            out,
            "\n  Nothing holds the root: these forces would have to come out of the air. They are what motion, masses and {what}"
        )?;
        self.plausibility.as_ref().map_or(Ok(()), |plausible| plausible.write_residual(out))
    }
}

impl Load {
    fn write(&self, out: &mut dyn Write, width: usize) -> Result<()> {
        let [rms, greatest] = [self.rms, self.greatest].map(short);
        writeln!(
            out,
            "  {:<width$}{rms:>12}{greatest:>12} {:<4} at {} s",
            self.dof,
            self.unit,
            short(self.at_s)
        )
    }
}

//! The summary of inverse dynamics, for people.

use super::report::Report;
use crate::ground::GroundReport;
use crate::plausible::Plausibility;
use crate::shown::{given_rows, warning_rows};
use crate::words::{row, short};
use solaris::analysis::DofLoad;
use solaris::view::TableRow;
use std::io::{Result, Write};

impl Report {
    pub(super) fn write(&self, out: &mut dyn Write) -> Result<()> {
        self.given.write(out)?;
        self.write_forces(out)?;
        self.given.write_doubts(out)?;
        self.cycles.iter().try_for_each(|cycles| cycles.write(out))?;
        if let Some(ground) = &self.ground {
            ground.write(out)?;
        }
        if let Some(plausible) = &self.plausibility {
            plausible.write(out)?;
        }
        let width = self.joints.iter().map(|joint| joint.dof.chars().count()).max().unwrap_or(0).max(18);
        let bands = if self.bands.is_some() { format!("{:>12}", "band") } else { String::new() };
        writeln!(out, "\n  {:<width$}{:>12}{:>12}{bands}", "joint forces", "rms", "greatest")?;
        for joint in self.joints.iter().filter(|joint| !joint.is_residual) {
            write_load(joint, self.band(joint), out, width)?;
        }
        if self.given.root_is_free {
            self.write_residual(out, width)?;
        }
        Ok(())
    }

    /// What a page says of it all.
    pub(super) fn page_rows(&self) -> Vec<TableRow> {
        let mut rows = given_rows(&self.given);
        rows.extend(self.ground.iter().flat_map(|ground| warning_rows(&ground.warnings)));
        rows.extend(self.plausibility.iter().flat_map(Plausibility::page_rows));
        rows.push(TableRow::new("Forces from outside", "", "", self.external_forces.as_str()));
        rows.extend(self.bands.iter().map(|bands| TableRow::new("Bands", "", "", bands.words())));
        rows.extend(self.unused_words().map(|unused| TableRow::new("", "", "", unused)));
        rows.extend(self.cycles.iter().map(|cycles| TableRow::new("Strides", "", "", cycles.words())));
        rows.extend(self.ground.iter().flat_map(GroundReport::page_rows));
        if let Some(r) = &self.residual {
            let left = |what: &str, unit: &str, greatest: f64, rms: f64, at: f64| {
                let note = format!("greatest, at {} s; rms {}", short(at), short(rms));
                TableRow::new(what, short(greatest), whole(unit), note)
            };
            rows.push(left("Residual force", "N", r.force, r.force_rms, r.force_time));
            rows.push(left("Residual moment", "N m", r.moment, r.moment_rms, r.moment_time));
        }
        rows.extend(self.joints.iter().filter(|joint| !joint.is_residual).map(|joint| {
            let band = self.band(joint).map_or_else(String::new, |band| format!("; band ±{}", short(band)));
            let note = format!("at {} s; rms {}{band}", short(joint.time), short(joint.rms));
            TableRow::new(joint.dof.as_str(), short(joint.greatest), whole(joint.unit), note)
        }));
        rows
    }

    /// Half the width of the band of a degree of freedom's force, where it is known.
    fn band(&self, joint: &DofLoad) -> Option<f64> {
        self.bands.as_ref()?.half_width(&joint.dof)
    }

    /// What pushes from outside.
    fn write_forces(&self, out: &mut dyn Write) -> Result<()> {
        row(out, "forces", &self.external_forces)?;
        self.force_notes.iter().try_for_each(|note| row(out, "", note))?;
        if let Some(unused) = self.unused_words() {
            row(out, "", &unused)?;
        }
        if let (Some(medium), true) = (&self.medium, self.passive) {
            row(out, "medium", medium)?;
        }
        if let Some(bands) = &self.bands {
            bands.write(out)?;
        }
        if !self.passive {
            row(out, "passive", "armature, damping, springs, friction and fluids left out")?;
        }
        Ok(())
    }

    fn write_residual(&self, out: &mut dyn Write, width: usize) -> Result<()> {
        writeln!(out, "\n  {:<width$}{:>12}{:>12}", "residual at the root", "rms", "greatest")?;
        for joint in self.joints.iter().filter(|joint| joint.is_residual) {
            write_load(joint, None, out, width)?;
        }
        // A joint of fewer degrees of freedom holds the rest.
        if let (6, Some(r)) = (self.joints.iter().filter(|joint| joint.is_residual).count(), &self.residual) {
            let size = |name: &str, rms, greatest, time, unit| DofLoad {
                dof: name.to_owned(),
                unit,
                rms,
                greatest,
                time,
                is_residual: true,
            };
            write_load(&size("whole force", r.force_rms, r.force, r.force_time, "N"), None, out, width)?;
            write_load(
                &size("whole moment", r.moment_rms, r.moment, r.moment_time, "N m"),
                None,
                out,
                width,
            )?;
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

/// A unit that stays in one line.
fn whole(unit: &str) -> String {
    unit.replace(' ', "\u{a0}")
}

/// A row of the table; with the half width of its band where that is known.
fn write_load(load: &DofLoad, band: Option<f64>, out: &mut dyn Write, width: usize) -> Result<()> {
    let [rms, greatest] = [load.rms, load.greatest].map(short);
    let band = band.map_or_else(String::new, |band| format!("{:>12}", format!("±{}", short(band))));
    let DofLoad { dof, unit, time, .. } = load;
    writeln!(out, "  {dof:<width$}{rms:>12}{greatest:>12}{band} {unit:<4} at {} s", short(*time))
}

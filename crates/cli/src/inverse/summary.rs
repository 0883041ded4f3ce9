//! What inverse dynamics came to, for people.

use super::report::{FilterReport, Load, Report};
use crate::words::some;
use std::io::{Result, Write};

impl Report {
    pub(super) fn write(&self, out: &mut dyn Write) -> Result<()> {
        self.write_given(out)?;
        let width = self.joints.iter().map(|joint| joint.dof.chars().count()).max().unwrap_or(0).max(18);
        writeln!(out, "\n  {:<width$}{:>12}{:>12}", "joint forces", "rms", "greatest")?;
        for joint in self.joints.iter().filter(|joint| !joint.root) {
            joint.write(out, width)?;
        }
        if self.root_is_free {
            self.write_residual(out, width)?;
        }
        Ok(())
    }

    /// What went in, and how it was taken.
    fn write_given(&self, out: &mut dyn Write) -> Result<()> {
        let Self { figure, format, dofs, mass_kg, .. } = self;
        let dofs = counted(*dofs, "degree of freedom", "degrees of freedom");
        writeln!(out, "{format} '{figure}': {dofs}, {} kg\n", short(*mass_kg))?;
        let mut row = |what: &str, value: String| writeln!(out, "  {what:<18}{value}");
        let rows = counted(self.rows, "row", "rows");
        let times = match (self.has_times, self.rows) {
            (false, _) => " without times".to_owned(),
            (true, 1) => format!(" at {} s", short(self.from_s)),
            (true, _) => format!(", {} to {} s", short(self.from_s), short(self.to_s)),
        };
        row("motion", format!("{rows}{times}; {}", self.units))?;
        let [x, y, z] = self.gravity_m_s2;
        row("gravity", format!("({x}, {y}, {z}) m/s², {}", self.gravity_from))?;
        let which = if self.filter.is_some() { "filtered " } else { "" };
        for (count, of) in [(self.from_positions, "positions"), (self.from_velocities, "velocities")] {
            let dofs = counted(count, "dof", "dofs");
            let how = match self.rows {
                _ if count == 0 => continue,
                1 => "zero, since a single row has none".to_owned(),
                2 => format!("of the straight line through the {which}{of}"),
                _ => format!("of the natural quintic spline through the {which}{of}"),
            };
            row("derivatives", format!("{dofs}: {how}"))?;
        }
        if self.from_positions + self.from_velocities == 0 {
            row("derivatives", "as recorded".to_owned())?;
        }
        match &self.filter {
            Some(_) if self.from_positions + self.from_velocities == 0 => {
                row(
                    "filter",
                    "not used: what is recorded with its derivatives is taken as it is".to_owned(),
                )?;
            }
            Some(FilterReport { cutoff_hz, order, spoiled_s }) => {
                row(
                    "filter",
                    format!("zero-phase Butterworth, {cutoff_hz} Hz, order {order} there and back"),
                )?;
                row(
                    "",
                    format!(
                        "the first and the last {} s are the filter's, not the motion's",
                        short(*spoiled_s)
                    ),
                )?;
            }
            None => {}
        }
        row("forces", self.external_forces.clone())?;
        if !self.unused_forces.is_empty() {
            let names: Vec<String> = self.unused_forces.iter().map(|prefix| format!("'{prefix}'")).collect();
            row(
                "",
                format!("not used: the forces of {}; --external and --plate apply them", names.join(", ")),
            )?;
        }
        if !self.many_turns.is_empty() {
            row("suspect", format!("{}: more than two turns; are these degrees?", some(&self.many_turns)))?;
        }
        if !self.passive {
            row("passive", "armature, damping, springs and friction left out".to_owned())?;
        }
        for (i, excess) in self.outside_limits.iter().enumerate() {
            let (by, unit) = if excess.turns { (excess.by.to_degrees(), "°") } else { (excess.by, " m") };
            let what = if i == 0 { "outside limits" } else { "" };
            row(what, format!("{} by {}{unit} at {} s", excess.dof, short(by), short(excess.at_s)))?;
        }
        if !self.ignored_columns.is_empty() {
            row("columns not used", some(&self.ignored_columns))?;
        }
        if self.not_read > 0 {
            let kinds = counted(self.not_read, "kind", "kinds");
            row("not read", format!("{kinds} of things in the model; solaris check lists them"))?;
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
        writeln!(
            out,
            "\n  Nothing holds the root: these forces would have to come out of the air. They are what motion, masses and \
             measured\n  forces disagree by; without measured forces, they are all that the ground does."
        )
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

/// A number with as many digits as a person reads.
fn short(value: f64) -> String {
    let size = value.abs();
    if size >= 1e6 || (size > 0.0 && size < 1e-3) {
        return format!("{value:.2e}");
    }
    let digits = if size >= 100.0 {
        1
    } else if size >= 10.0 {
        2
    } else {
        3
    };
    let text = format!("{value:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// A count with its noun.
fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

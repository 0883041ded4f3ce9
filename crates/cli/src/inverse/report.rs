//! What inverse dynamics came to, as text and as JSON.

use super::tables::slides;
use crate::convert::some;
use crate::input::Body;
use serde::Serialize;
use solaris::io::Table;
use solaris::io::record::Recorded;
use solaris::model::FindingKind;
use solaris::modes::{Completed, Filter, InverseReport};
use std::io::{Result, Write};

/// What the command line said of how to do it.
pub(super) struct Asked {
    pub(super) filter: Option<Filter>,
    pub(super) passive: bool,
    /// Whether gravity was given there.
    pub(super) gravity: bool,
    /// The forces from outside.
    pub(super) external: String,
    /// Prefixes of columns of forces that push nothing.
    pub(super) unused: Vec<String>,
}

/// The summary.
#[derive(Serialize)]
pub(super) struct Report {
    figure: String,
    format: &'static str,
    dofs: usize,
    mass_kg: f64,
    rows: usize,
    from_s: f64,
    to_s: f64,
    /// What the motion's angles are in, and who says so.
    units: &'static str,
    has_times: bool,
    gravity_m_s2: [f64; 3],
    gravity_from: &'static str,
    /// Degrees of freedom whose velocities and accelerations were found from the positions.
    from_positions: usize,
    /// Degrees of freedom whose accelerations were found from the recorded velocities.
    from_velocities: usize,
    filter: Option<FilterReport>,
    external_forces: String,
    unused_forces: Vec<String>,
    many_turns: Vec<String>,
    passive: bool,
    outside_limits: Vec<Excess>,
    ignored_columns: Vec<String>,
    /// Elements of the figure's file that were not read.
    not_read: usize,
    joints: Vec<Load>,
    /// Absent where the figure stands fixed in the world, which then bears what is left over.
    residual: Option<Residual>,
    /// Whether nothing holds the root in the world, so that the forces of its joint are errors.
    root_is_free: bool,
}

#[derive(Serialize)]
struct FilterReport {
    cutoff_hz: f64,
    order: usize,
    spoiled_s: f64,
}

#[derive(Serialize)]
struct Excess {
    dof: String,
    by: f64,
    at_s: f64,
    #[serde(skip)]
    turns: bool,
}

#[derive(Serialize)]
struct Load {
    dof: String,
    unit: &'static str,
    rms: f64,
    greatest: f64,
    at_s: f64,
    /// Whether it belongs to the root's joint.
    root: bool,
}

#[derive(Serialize)]
struct Residual {
    force_rms_n: f64,
    force_greatest_n: f64,
    force_at_s: f64,
    moment_rms_nm: f64,
    moment_greatest_nm: f64,
    moment_at_s: f64,
}

impl Report {
    pub(super) fn new(
        body: &Body,
        asked: &Asked,
        table: &Table,
        recorded: &Recorded,
        (motion, forces): (&Completed, &InverseReport),
    ) -> Self {
        let figure = &body.figure;
        let (names, slides) = (figure.layout().v_names(), slides(figure));
        let root = figure.layout().joints()[0];
        let load = |(dof, load): (usize, &solaris::modes::DofLoad)| Load {
            dof: names[dof].clone(),
            unit: if slides[dof] { "N" } else { "N m" },
            rms: load.rms,
            greatest: load.greatest,
            at_s: load.time,
            root: dof < root.nv,
        };
        let excess = figure.limit_excess(&motion.q).into_iter().map(|found| Excess {
            dof: names[found.dof].clone(),
            by: found.by,
            at_s: motion.time[found.row],
            turns: !slides[found.dof],
        });
        let derived = |from_velocity: bool| {
            let dofs = motion.differentiated.iter().enumerate();
            dofs.filter(|(dof, here)| **here && recorded.record.known_v[*dof] == from_velocity).count()
        };
        let free = forces.dofs.iter().enumerate().filter(|(dof, _)| !figure.follows(*dof));
        let r = &forces.residual;
        Self {
            figure: figure.name().to_owned(),
            format: body.language.name(),
            dofs: figure.layout().nv(),
            mass_kg: figure.mass(),
            rows: motion.time.len(),
            from_s: motion.time.first().copied().unwrap_or_default(),
            to_s: motion.time.last().copied().unwrap_or_default(),
            units: match table.in_degrees {
                Some(true) => "angles in degrees, as its header says",
                Some(false) => "angles in rad, as its header says",
                None if table.header_line > 1 => "angles in rad, though its header does not say",
                None => "angles in rad",
            },
            has_times: table.column("time").is_some(),
            gravity_m_s2: body.gravity.into(),
            gravity_from: match (asked.gravity, body.gravity_is_given) {
                (true, _) => "as asked",
                (false, true) => "the file's",
                (false, false) => "standard, down in this format",
            },
            from_positions: derived(false),
            from_velocities: derived(true),
            filter: asked.filter.map(|filter| FilterReport {
                cutoff_hz: filter.cutoff,
                order: filter.order,
                spoiled_s: motion.spoiled,
            }),
            external_forces: asked.external.clone(),
            unused_forces: asked.unused.clone(),
            many_turns: figure.many_turns(&motion.q).into_iter().map(|dof| names[dof].clone()).collect(),
            passive: asked.passive,
            outside_limits: excess.collect(),
            ignored_columns: recorded.ignored.clone(),
            not_read: body.findings.iter().filter(|f| f.kind == FindingKind::Unsupported).count(),
            joints: free.map(load).collect(),
            residual: (root.nv > 0).then_some(Residual {
                force_rms_n: r.force_rms,
                force_greatest_n: r.force,
                force_at_s: r.force_time,
                moment_rms_nm: r.moment_rms,
                moment_greatest_nm: r.moment,
                moment_at_s: r.moment_time,
            }),
            root_is_free: root.nv > 0,
        }
    }

    pub(super) fn write_json(&self, out: &mut dyn Write) -> Result<()> {
        serde_json::to_writer_pretty(&mut *out, self).map_err(std::io::Error::from)?;
        writeln!(out)
    }

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
        let spline = match self.rows {
            1 => "zero, as at rest: a single row has none",
            2 => "the straight line through two rows",
            _ => "the natural quintic spline",
        };
        for (count, of) in [(self.from_positions, "positions"), (self.from_velocities, "velocities")] {
            if count > 0 {
                let dofs = counted(count, "dof", "dofs");
                row("derivatives", format!("of {dofs}: {spline}, through the {which}{of}"))?;
            }
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

//! What inverse dynamics came to, as text and as JSON.

use super::tables::slides;
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
    angles_in_degrees: bool,
    gravity_m_s2: [f64; 3],
    gravity_from: &'static str,
    /// Degrees of freedom whose velocities or accelerations were found by differentiating.
    differentiated: usize,
    filter: Option<FilterReport>,
    external_forces: String,
    passive: bool,
    outside_limits: Vec<Excess>,
    ignored_columns: Vec<String>,
    /// Elements of the figure's file that were not read.
    not_read: usize,
    joints: Vec<Load>,
    residual: Residual,
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
            angles_in_degrees: table.in_degrees == Some(true),
            gravity_m_s2: body.gravity.into(),
            gravity_from: match (asked.gravity, body.gravity_is_given) {
                (true, _) => "as asked",
                (false, true) => "the file's",
                (false, false) => "standard, down in this format",
            },
            differentiated: motion.differentiated.iter().filter(|here| **here).count(),
            filter: asked.filter.map(|filter| FilterReport {
                cutoff_hz: filter.cutoff,
                order: filter.order,
                spoiled_s: motion.spoiled,
            }),
            external_forces: asked.external.clone(),
            passive: asked.passive,
            outside_limits: excess.collect(),
            ignored_columns: recorded.ignored.clone(),
            not_read: body.findings.iter().filter(|f| f.kind == FindingKind::Unsupported).count(),
            joints: free.map(load).collect(),
            residual: Residual {
                force_rms_n: r.force_rms,
                force_greatest_n: r.force,
                force_at_s: r.force_time,
                moment_rms_nm: r.moment_rms,
                moment_greatest_nm: r.moment,
                moment_at_s: r.moment_time,
            },
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
        writeln!(out, "{format} '{figure}': {dofs} degrees of freedom, {} kg\n", short(*mass_kg))?;
        let mut row = |what: &str, value: String| writeln!(out, "  {what:<18}{value}");
        let units = if self.angles_in_degrees { "; angles in degrees" } else { "" };
        row(
            "motion",
            format!("{} rows, {} to {} s{units}", self.rows, short(self.from_s), short(self.to_s)),
        )?;
        let [x, y, z] = self.gravity_m_s2;
        row("gravity", format!("({x}, {y}, {z}) m/s², {}", self.gravity_from))?;
        let how = match (self.differentiated, &self.filter) {
            (0, _) => "as recorded".to_owned(),
            (count, None) => format!("of {count} dofs by the natural quintic spline through the positions"),
            (count, Some(_)) => {
                format!("of {count} dofs by the natural quintic spline through the filtered positions")
            }
        };
        row("derivatives", how)?;
        if let Some(FilterReport { cutoff_hz, order, spoiled_s }) = &self.filter {
            row("filter", format!("zero-phase Butterworth, {cutoff_hz} Hz, order {order} there and back"))?;
            row(
                "",
                format!("the first and the last {} s are the filter's, not the motion's", short(*spoiled_s)),
            )?;
        }
        row("forces", self.external_forces.clone())?;
        if !self.passive {
            row("passive", "armature, damping, springs and friction left out".to_owned())?;
        }
        for (i, excess) in self.outside_limits.iter().enumerate() {
            let (by, unit) = if excess.turns { (excess.by.to_degrees(), "°") } else { (excess.by, " m") };
            let what = if i == 0 { "outside limits" } else { "" };
            row(what, format!("{} by {}{unit} at {} s", excess.dof, short(by), short(excess.at_s)))?;
        }
        if !self.ignored_columns.is_empty() {
            row("columns not used", self.ignored_columns.join(", "))?;
        }
        if self.not_read > 0 {
            row(
                "not read",
                format!("{} kinds of things in the model; solaris check lists them", self.not_read),
            )?;
        }
        Ok(())
    }

    fn write_residual(&self, out: &mut dyn Write, width: usize) -> Result<()> {
        writeln!(out, "\n  {:<width$}{:>12}{:>12}", "residual at the root", "rms", "greatest")?;
        for joint in self.joints.iter().filter(|joint| joint.root) {
            joint.write(out, width)?;
        }
        // A joint of fewer degrees of freedom holds the rest.
        if self.joints.iter().filter(|joint| joint.root).count() == 6 {
            let r = &self.residual;
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

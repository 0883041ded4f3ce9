//! The joint moments of a measured walk beside those that OpenSim finds: the table and the picture of docs/bodies.md.

use crate::table::{Cell, Table, number};
use crate::workspace;
use solaris_analysis::{Filter, InverseOptions, Loads, PreparedMotion, differentiate, inverse_motion};
use solaris_io::{Table as Numbers, opensim, record, sto};
use solaris_view::chart::{Axis, Key, Panel, Picture};
use std::fs;
use std::path::Path;

/// The measured walk, where it is at hand; it is not part of the project.
const DATA: &str = "../shared/data/subject01_walk";
/// Of the record, what the filter does not spoil (s).
const SPAN: (f64, f64) = (0.1, 2.4);

/// One degree of freedom over time, ours and theirs.
pub(super) struct Curve {
    name: String,
    unit: &'static str,
    times: Vec<f64>,
    ours: Vec<f64>,
    theirs: Vec<f64>,
}

impl Curve {
    fn rms(&self) -> f64 {
        let squares = self.ours.iter().zip(&self.theirs).map(|(a, b)| (a - b).powi(2));
        (squares.sum::<f64>() / self.ours.len() as f64).sqrt()
    }

    fn greatest(&self) -> f64 {
        self.theirs.iter().fold(0.0, |greatest, x| x.abs().max(greatest))
    }
}

/// Both results, or nothing where the data are not at hand.
pub(super) fn measure() -> Result<Option<Vec<Curve>>, String> {
    let folder = workspace::root().join(DATA);
    if !folder.is_dir() {
        eprintln!("report: moments beside OpenSim's: skipped, there is no {DATA}");
        return Ok(None);
    }
    eprintln!("report: moments beside OpenSim's");
    curves(&folder).map(Some)
}

fn curves(folder: &Path) -> Result<Vec<Curve>, String> {
    let text = |name: &str| fs::read_to_string(folder.join(name)).map_err(|error| format!("{name}: {error}"));
    let table = |name: &str| sto::read(&text(name)?).map_err(|error| format!("{name}: {error}"));
    let subject =
        opensim::read(&text("gait10dof18musc_subject01.osim")?).map_err(|error| error.to_string())?;
    let figure = &subject.figure;
    let recorded = record::read(figure, subject.gravity, &table("subject01_walk_ik_planar10.mot")?)
        .map_err(|error| error.to_string())?;
    let plates = table("subject01_walk_grf.mot")?;
    let carrier = |body: &str| {
        let has =
            |link: &&solaris_model::Link| link.name() == body || link.frames().iter().any(|f| f.name == body);
        figure.links().iter().find(has).map(|link| link.name().to_owned()).ok_or(format!("no body '{body}'"))
    };
    let loads = [("calcn_r", ""), ("calcn_l", "1_")].map(|(body, prefix)| {
        record::forces(&plates, &[carrier(body)?], prefix).map_err(|error| error.to_string())
    });
    let loads = loads.into_iter().collect::<Result<Vec<_>, String>>()?;
    let filter = Filter { cutoff: 6.0, order: 3 };
    let motion =
        differentiate(figure, &recorded.motion, Some(filter)).map_err(|error| error.to_string())?.motion;
    let loads = Loads::at_times(figure, &loads, motion.time()).map_err(|error| error.to_string())?;
    let prepared = PreparedMotion::new(figure, &motion).map_err(|error| error.to_string())?;
    let options = InverseOptions { passive: true, progress: None };
    let ours = inverse_motion(&prepared, &loads, options).map_err(|error| error.to_string())?;
    let theirs = table("opensim46_id_planar10.sto")?;
    let layout = figure.layout();
    let free = (0..layout.nv()).filter(|&dof| !figure.follows(dof));
    free.map(|dof| curve(&layout.v_names()[dof], dof, layout.nv(), motion.time(), &ours.tau, &theirs))
        .collect()
}

fn curve(
    name: &str,
    dof: usize,
    nv: usize,
    time: &[f64],
    tau: &[f64],
    theirs: &Numbers,
) -> Result<Curve, String> {
    let column = |ending: &str| theirs.column(&format!("{name}_{ending}"));
    let (column, unit) = match (column("moment"), column("force")) {
        (Some(column), _) => (column, "N m"),
        (None, Some(column)) => (column, "N"),
        (None, None) => return Err(format!("OpenSim's result has no column of '{name}'")),
    };
    let rows = (0..time.len()).filter(|&row| (SPAN.0..=SPAN.1).contains(&time[row]));
    let mut curve = Curve { name: name.to_owned(), unit, times: vec![], ours: vec![], theirs: vec![] };
    for row in rows {
        curve.times.push(time[row]);
        curve.ours.push(tau[row * nv + dof]);
        curve.theirs.push(theirs.row(row)[column]);
    }
    Ok(curve)
}

/// Difference of each degree of freedom beside its size.
pub(super) fn table(curves: &[Curve]) -> Table {
    let row = |curve: &Curve| {
        let greatest = format!("{:.1}", curve.greatest());
        vec![
            Cell::text(curve.name.as_str()),
            Cell::text(curve.unit),
            Cell::text(greatest),
            Cell::text(number(curve.rms())),
        ]
    };
    Table {
        header: vec!["degree of freedom", "unit", "greatest in OpenSim", "rms of the difference"],
        rows: curves.iter().map(row).collect(),
    }
}

/// Height of a panel, and of what is over and below it (px).
const PANEL: (f64, f64, f64) = (105.0, 40.0, 18.0);

/// A panel for each degree of freedom: OpenSim's a broad band, ours a line on it.
pub(super) fn draw(curves: &[Curve]) -> String {
    let mut picture = Picture::new("Joint moments beside OpenSim's");
    picture.legend(&[Key::stroke("broad s1", "OpenSim 4.6"), Key::stroke("line s0", "Solaris")]);
    picture.remark("over time (s), with the root mean square of the difference", 1);
    let time = Axis::linear(SPAN.0, SPAN.1, 5.0);
    for row in curves.chunks(2) {
        picture.take(PANEL.1);
        let up = |curve: &Curve| Axis::around(curve.theirs.iter().copied().chain([0.0]), 4.0).padded(0.06);
        let axes = [&row[0], &row[row.len() - 1]].map(|curve| (time.clone(), up(curve)));
        let panels = Panel::row(&mut picture, PANEL.0, axes.into());
        picture.take(PANEL.2);
        for (panel, curve) in panels.iter().zip(row) {
            picture.text("bold", (panel.left, panel.top - 23.0), &format!("{} ({})", curve.name, curve.unit));
            picture.text(
                "soft",
                (panel.left, panel.top - 7.0),
                &format!("differs by {}", number(curve.rms())),
            );
            panel.grid(&mut picture);
            panel.numbers(&mut picture);
            panel.curve(&mut picture, "broad s1", &curve.times, &curve.theirs);
            panel.curve(&mut picture, "line s0", &curve.times, &curve.ours);
        }
    }
    picture.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With the measured data at hand; `UPDATE_PICTURES=1` draws it anew.
    #[test]
    fn the_plot_of_the_page_is_what_is_drawn() {
        let Some(curves) = measure().expect("a result") else { return };
        let (kept, drawn) = (workspace::root().join("docs/moments.svg"), draw(&curves));
        if std::env::var_os("UPDATE_PICTURES").is_some() {
            fs::write(&kept, &drawn).expect("written");
        }
        assert!(fs::read_to_string(kept).unwrap_or_default() == drawn, "UPDATE_PICTURES=1 draws it anew");
    }
}

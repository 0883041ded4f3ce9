//! The joint moments of a measured walk beside those that OpenSim finds: the table and the picture of docs/bodies.md.

use crate::table::{Cell, Table, number};
use crate::workspace;
use solaris_analysis::{Filter, InverseOptions, Loads, PreparedMotion, differentiate, inverse_motion};
use solaris_io::{Table as Numbers, opensim, record, sto};
use std::fmt::Write;
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

/// Size of a panel, and what is around it (pixels).
const PANEL: (f64, f64) = (330.0, 120.0);
const LEFT: f64 = 52.0;
const TOP: f64 = 58.0;
const GAP: (f64, f64) = (60.0, 40.0);

/// A panel for each degree of freedom: OpenSim's a broad band, ours a line on it.
pub(super) fn draw(curves: &[Curve]) -> String {
    let rows = curves.len().div_ceil(2);
    let (width, height) = (LEFT + 2.0 * PANEL.0 + GAP.0 + 20.0, TOP + rows as f64 * (PANEL.1 + GAP.1) + 20.0);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         font-family=\"sans-serif\" font-size=\"11\" fill=\"#222\">\n<title>Joint moments beside OpenSim's</title>\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n\
         <path d=\"M{LEFT} 20h30\" stroke=\"#f0b27a\" stroke-width=\"6\"/><text x=\"{}\" y=\"24\">OpenSim 4.6</text>\n\
         <path d=\"M{} 20h30\" stroke=\"#0072b2\" stroke-width=\"1.5\"/><text x=\"{}\" y=\"24\">Solaris</text>\n",
        LEFT + 38.0,
        LEFT + 150.0,
        LEFT + 188.0
    );
    for (i, curve) in curves.iter().enumerate() {
        let (column, row) = ((i % 2) as f64, (i / 2) as f64);
        let corner = (LEFT + column * (PANEL.0 + GAP.0), TOP + row * (PANEL.1 + GAP.1));
        let _ = writeln!(svg, "<g transform=\"translate({} {})\">", corner.0, corner.1);
        panel(&mut svg, curve);
        svg.push_str("</g>\n");
    }
    svg.push_str("</svg>\n");
    svg
}

fn panel(svg: &mut String, curve: &Curve) {
    let (low, high) =
        curve.theirs.iter().fold((0.0_f64, 0.0_f64), |(low, high), x| (low.min(*x), high.max(*x)));
    let margin = 0.06 * (high - low).max(1e-9);
    let (low, high) = (low - margin, high + margin);
    let place = |time: f64, value: f64| {
        let x = PANEL.0 * (time - SPAN.0) / (SPAN.1 - SPAN.0);
        (x, PANEL.1 * (high - value) / (high - low))
    };
    let path = |values: &[f64]| {
        let mut path = String::new();
        for (k, (time, value)) in curve.times.iter().zip(values).enumerate() {
            let (x, y) = place(*time, *value);
            let _ = write!(path, "{}{x:.1} {y:.1}", if k == 0 { 'M' } else { 'L' });
        }
        path
    };
    let zero = place(SPAN.0, 0.0).1;
    let [low_label, high_label] = [low + margin, high - margin].map(|value| format!("{value:.0}"));
    let _ = writeln!(
        svg,
        "<text y=\"-8\" font-weight=\"bold\">{} ({})</text>\
         <text x=\"{}\" y=\"-8\" text-anchor=\"end\">rms of the difference {}</text>\n\
         <path d=\"M0 {zero:.1}H{}\" stroke=\"#ccc\"/>\n\
         <rect width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#888\"/>\n\
         <path d=\"{}\" fill=\"none\" stroke=\"#f0b27a\" stroke-width=\"6\" stroke-linejoin=\"round\"/>\n\
         <path d=\"{}\" fill=\"none\" stroke=\"#0072b2\" stroke-width=\"1.5\"/>",
        curve.name,
        curve.unit,
        PANEL.0,
        number(curve.rms()),
        PANEL.0,
        PANEL.0,
        PANEL.1,
        path(&curve.theirs),
        path(&curve.ours),
    );
    for (value, label) in [(low + margin, low_label), (high - margin, high_label)] {
        let y = place(SPAN.0, value).1 + 4.0;
        let _ = writeln!(svg, "<text x=\"-6\" y=\"{y:.1}\" text-anchor=\"end\">{label}</text>");
    }
    for time in [0.5, 1.0, 1.5, 2.0] {
        let (x, _) = place(time, 0.0);
        let _ = writeln!(
            svg,
            "<path d=\"M{x:.1} {0}v4\" stroke=\"#888\"/><text x=\"{x:.1}\" y=\"{1}\" text-anchor=\"middle\">{time} s</text>",
            PANEL.1,
            PANEL.1 + 16.0
        );
    }
}

//! Curves over time, in panels one below the other.

use crate::html::escape;
use crate::profile::axis::Axis;
use crate::profile::text::cut;
use std::fmt::Write as _;

/// Width of the picture, and size of a panel (px).
const WIDTH: f64 = 720.0;
pub(crate) const PANEL: (f64, f64) = (560.0, 220.0);
pub(crate) const LEFT: f64 = 64.0;
pub(crate) const TOP: f64 = 44.0;
/// What is below a panel (px).
pub(crate) const BELOW: f64 = 46.0;
/// The most points of a line: more than there are pixels do not show.
const MOST_POINTS: usize = 1200;
/// Colours that people with any kind of colour vision tell apart (M. Okabe, K. Ito).
pub(crate) const COLORS: [&str; 6] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];

/// One curve.
pub(crate) struct Curve<'a> {
    pub(crate) name: &'a str,
    /// When (s), rising.
    pub(crate) time: &'a [f64],
    pub(crate) values: Vec<f64>,
    pub(crate) color: &'static str,
    /// Whether it is drawn thin and dashed.
    pub(crate) thin: bool,
}

/// The beginning of a picture of so many panels.
pub(crate) fn begin(title: &str, panels: usize) -> String {
    let height = TOP + (panels as f64) * (PANEL.1 + BELOW);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" width=\"{WIDTH}\" height=\"{height}\" \
         font-family=\"Helvetica,Arial,sans-serif\" font-size=\"11\" fill=\"#222\">\n<title>{0}</title>\n\
         <rect width=\"{WIDTH}\" height=\"{height}\" fill=\"#fff\"/>\n\
         <text x=\"16\" y=\"24\" font-size=\"15\" font-weight=\"bold\">{0}</text>\n",
        escape(&cut(title, 15.0, WIDTH - 32.0))
    )
}

/// A panel of curves, at least one, with dotted lines at the times `marks`; `name` is what its values are.
pub(crate) fn panel(svg: &mut String, name: &str, curves: &[Curve<'_>], marks: &[f64]) {
    let least = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::INFINITY, f64::min);
    let most = |values: &mut dyn Iterator<Item = f64>| values.fold(f64::NEG_INFINITY, f64::max);
    let times = || curves.iter().flat_map(|curve| [curve.time.first(), curve.time.last()]).flatten().copied();
    let values = || curves.iter().flat_map(|curve| curve.values.iter().copied());
    let time = Axis::new(least(&mut times()), most(&mut times()), 8.0);
    let value = Axis::new(least(&mut values()), most(&mut values()), 5.0).padded(0.06);
    let x = |t: f64| PANEL.0 * time.share(t);
    let y = |v: f64| PANEL.1 * (1.0 - value.share(v));
    for (tick, label) in time.ticks() {
        let at = x(tick);
        let _ = writeln!(
            svg,
            "<path d=\"M{at:.1} 0V{}\" stroke=\"#e2e2e2\"/><text x=\"{at:.1}\" y=\"{}\" text-anchor=\"middle\">{label}</text>",
            PANEL.1,
            PANEL.1 + 15.0
        );
    }
    for (tick, label) in value.ticks() {
        let at = y(tick);
        let _ = writeln!(
            svg,
            "<path d=\"M0 {at:.1}H{}\" stroke=\"#e2e2e2\"/><text x=\"-6\" y=\"{:.1}\" text-anchor=\"end\">{label}</text>",
            PANEL.0,
            at + 4.0
        );
    }
    for mark in marks {
        let at = x(*mark);
        let _ =
            writeln!(svg, "<path d=\"M{at:.1} 0V{}\" stroke=\"#999\" stroke-dasharray=\"2 3\"/>", PANEL.1);
    }
    let _ = writeln!(
        svg,
        "<rect width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#999\"/>\
         <text transform=\"translate(-46 {}) rotate(-90)\" text-anchor=\"middle\">{name}</text>\
         <text x=\"{}\" y=\"{}\" text-anchor=\"middle\">time (s)</text>",
        PANEL.0,
        PANEL.1,
        0.5 * PANEL.1,
        0.5 * PANEL.0,
        PANEL.1 + 31.0
    );
    for (index, curve) in curves.iter().enumerate() {
        line(svg, curve, index, &x, &y);
    }
}

fn line(svg: &mut String, curve: &Curve<'_>, index: usize, x: &dyn Fn(f64) -> f64, y: &dyn Fn(f64) -> f64) {
    let count = curve.time.len();
    let stride = count.div_ceil(MOST_POINTS).max(1);
    let rows =
        (0..count).step_by(stride).chain((count % stride != 1 % stride).then_some(count.saturating_sub(1)));
    let mut path = String::new();
    for row in rows {
        let (x, y) = (x(curve.time[row]), y(curve.values[row]));
        let _ = write!(path, "{}{x:.1} {y:.1}", if path.is_empty() { 'M' } else { 'L' });
    }
    let (color, at) = (curve.color, 14.0 + 16.0 * index as f64);
    let (width, key, dash) =
        if curve.thin { ("1.2", "1.5", " stroke-dasharray=\"5 3\"") } else { ("1.8", "3", "") };
    let _ = writeln!(
        svg,
        "<path d=\"{path}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"{width}\" stroke-linejoin=\"round\"{dash}/>\
         <path d=\"M{0} {1}h14\" stroke=\"{color}\" stroke-width=\"{key}\"{dash}/><text x=\"{2}\" y=\"{at}\">{3}</text>",
        PANEL.0 + 8.0,
        at - 4.0,
        PANEL.0 + 26.0,
        escape(&cut(curve.name, 11.0, WIDTH - LEFT - PANEL.0 - 30.0))
    );
}

//! The picture of error against time.

use super::cases::ORDINARY;
use super::page::{CALLS, Measured, duration};
use std::fmt::Write;
use std::ops::RangeInclusive;

/// Size of a panel, and what is around it (pixels).
const PANEL: (f64, f64) = (360.0, 230.0);
const LEFT: f64 = 74.0;
const TOP: f64 = 74.0;
const GAP: (f64, f64) = (62.0, 44.0);
const BOTTOM: f64 = 56.0;

/// Colours that people with any kind of colour vision tell apart (M. Okabe, K. Ito).
const COLORS: [&str; CALLS.len()] = ["#d55e00", "#cc79a7", "#0072b2", "#009e73"];

/// A point: time (ns) and error.
type Point = (f64, f64);

/// A panel for each of [`ORDINARY`]; each call is a line from double (filled) to single precision (hollow).
pub(super) fn draw(measured: &Measured) -> String {
    let points = |case: usize, call: usize| -> [Point; 2] {
        let (times, errors) = (measured.speeds[case].times[call], measured.error(case, call));
        [0, 1].map(|width| (times[width], errors[width]))
    };
    let all = (0..ORDINARY.len()).flat_map(|case| (0..CALLS.len()).flat_map(move |call| points(case, call)));
    let (times, errors): (Vec<f64>, Vec<f64>) = all.unzip();
    let axes = Axes { times: decades(&times), errors: decades(&errors) };
    let (width, height) = (LEFT + 2.0 * PANEL.0 + GAP.0 + 30.0, TOP + 2.0 * PANEL.1 + GAP.1 + BOTTOM);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         font-family=\"sans-serif\" font-size=\"12\" fill=\"#222\">\n<title>Error against time of a call</title>\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n"
    );
    legend(&mut svg);
    for (case, name) in ORDINARY.iter().map(|case| case.name).enumerate() {
        let corner =
            (LEFT + (case % 2) as f64 * (PANEL.0 + GAP.0), TOP + (case / 2) as f64 * (PANEL.1 + GAP.1));
        let _ = writeln!(svg, "<g transform=\"translate({} {})\">", corner.0, corner.1);
        axes.draw(&mut svg, name, case % 2 == 0, case / 2 == 1);
        for call in 0..CALLS.len() {
            line(&mut svg, call, points(case, call).map(|point| axes.place(point)));
        }
        svg.push_str("</g>\n");
    }
    let (middle, below) = (LEFT + PANEL.0 + GAP.0 / 2.0, height - 12.0);
    text(&mut svg, (middle, below), "text-anchor=\"middle\"", "time of a call");
    let across = TOP + PANEL.1 + GAP.1 / 2.0;
    text(
        &mut svg,
        (18.0, across),
        &format!("text-anchor=\"middle\" transform=\"rotate(-90 18 {across})\""),
        "error",
    );
    svg.push_str("</svg>\n");
    svg
}

/// The powers of ten that enclose `values`.
fn decades(values: &[f64]) -> RangeInclusive<i32> {
    let (least, most) = values.iter().fold((f64::MAX, f64::MIN_POSITIVE), |(a, b), x| (x.min(a), x.max(b)));
    least.log10().floor() as i32..=most.log10().ceil() as i32
}

/// Logarithmic axes, by their decades.
struct Axes {
    times: RangeInclusive<i32>,
    errors: RangeInclusive<i32>,
}

impl Axes {
    /// Where a point is drawn in a panel.
    fn place(&self, (time, error): Point) -> (f64, f64) {
        let share = |range: &RangeInclusive<i32>, x: f64| {
            (x.log10() - f64::from(*range.start())) / f64::from(range.end() - range.start())
        };
        (PANEL.0 * share(&self.times, time), PANEL.1 * (1.0 - share(&self.errors, error)))
    }

    fn draw(&self, svg: &mut String, name: &str, is_left: bool, is_lowest: bool) {
        let _ = writeln!(svg, "<path fill=\"none\" stroke=\"#e3e3e3\" d=\"{}\"/>", self.grid());
        let _ = writeln!(
            svg,
            "<rect width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#888\"/>",
            PANEL.0, PANEL.1
        );
        text(svg, (0.0, -8.0), "font-weight=\"bold\"", name);
        let corner = (10.0_f64.powi(*self.times.start()), 10.0_f64.powi(*self.errors.start()));
        for decade in self.times.clone().filter(|_| is_lowest) {
            let time = 10.0_f64.powi(decade);
            let label = duration(time).replace(".00", "").replace(".0", "");
            text(svg, (self.place((time, corner.1)).0, PANEL.1 + 18.0), "text-anchor=\"middle\"", &label);
        }
        for decade in self.errors.clone().filter(|decade| is_left && decade % 2 == 0) {
            let y = self.place((corner.0, 10.0_f64.powi(decade))).1;
            text(svg, (-8.0, y + 4.0), "text-anchor=\"end\"", &format!("1e\u{2212}{}", -decade));
        }
    }

    /// A line at every decade.
    fn grid(&self) -> String {
        let corner = (10.0_f64.powi(*self.times.start()), 10.0_f64.powi(*self.errors.start()));
        let upright = self.times.clone().map(|decade| {
            let x = self.place((10.0_f64.powi(decade), corner.1)).0;
            format!("M{x:.1} 0V{} ", PANEL.1)
        });
        let level = self.errors.clone().map(|decade| {
            let y = self.place((corner.0, 10.0_f64.powi(decade))).1;
            format!("M0 {y:.1}H{} ", PANEL.0)
        });
        upright.chain(level).collect()
    }
}

fn legend(svg: &mut String) {
    for (call, name) in CALLS.iter().enumerate() {
        let x = LEFT + 150.0 * call as f64;
        marker(svg, call, (x + 6.0, 20.0), true);
        text(svg, (x + 18.0, 24.0), "", name);
    }
    let x = LEFT + 150.0 * CALLS.len() as f64;
    text(svg, (x, 24.0), "", "filled f64, hollow f32");
}

/// From double to single precision.
fn line(svg: &mut String, call: usize, [double, single]: [(f64, f64); 2]) {
    let ((x, y), (u, v)) = (double, single);
    let color = COLORS[call];
    let _ = writeln!(
        svg,
        "<path d=\"M{x:.1} {y:.1}L{u:.1} {v:.1}\" stroke=\"{color}\" stroke-opacity=\"0.5\" stroke-width=\"1.5\"/>"
    );
    marker(svg, call, double, true);
    marker(svg, call, single, false);
}

/// Square, triangle, circle, diamond.
fn marker(svg: &mut String, call: usize, (x, y): (f64, f64), is_filled: bool) {
    let color = COLORS[call];
    let fill = if is_filled { color } else { "#fff" };
    let shape = match call {
        0 => "M-4.5 -4.5H4.5V4.5H-4.5Z",
        1 => "M0 -5.5L5.5 4.5H-5.5Z",
        2 => "M-5 0A5 5 0 1 0 5 0A5 5 0 1 0 -5 0Z",
        _ => "M0 -6L6 0L0 6L-6 0Z",
    };
    let _ = writeln!(
        svg,
        "<path transform=\"translate({x:.1} {y:.1})\" d=\"{shape}\" fill=\"{fill}\" stroke=\"{color}\" stroke-width=\"1.5\"/>"
    );
}

pub(super) fn text(svg: &mut String, (x, y): (f64, f64), attributes: &str, text: &str) {
    let _ = writeln!(svg, "<text x=\"{x:.1}\" y=\"{y:.1}\" {attributes}>{text}</text>");
}

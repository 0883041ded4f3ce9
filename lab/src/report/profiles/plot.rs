//! The picture of error against time.

use super::accuracy::Accuracy;
use super::cases::{HARD, KINDS, Kind};
use super::page::Measured;
use crate::report::plot::text;
use std::fmt::Write;

/// Size of a panel, and what is around it (pixels).
const PANEL: (f64, f64) = (400.0, 390.0);
const LEFT: f64 = 74.0;
const TOP: f64 = 66.0;
const GAP: f64 = 70.0;
const BOTTOM: f64 = 132.0;

/// Space for the numbers of the curves above and below what is drawn, and a row of them.
const MARGIN: f64 = 74.0;
const ROW: f64 = 13.0;

/// Colours of the printed and the library's forms that people with any kind of colour vision tell apart (M. Okabe, K. Ito).
const COLORS: [&str; 2] = ["#d55e00", "#0072b2"];
const FORMS: [&str; 2] = ["printed", "library"];

/// Times that stand at the axis (ns).
const TICKS: [f64; 10] = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0];

/// The decades of errors of either precision; what is more than all is drawn at the upper end.
const DECADES: [(i32, i32); 2] = [(-18, 0), (-9, 0)];

/// A curve in one form: time of an evaluation (ns), error in the ordinary case and the worst error in the hard ones.
struct Line {
    time: f64,
    ordinary: f64,
    worst: f64,
}

/// A panel for f64 and one for f32.
pub(super) fn draw(measured: &Measured) -> String {
    let (width, height) = (LEFT + 2.0 * PANEL.0 + GAP + 24.0, TOP + PANEL.1 + BOTTOM);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         font-family=\"sans-serif\" font-size=\"12\" fill=\"#222\">\n<title>Error of a position against time of an evaluation</title>\n\
         <rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n"
    );
    for (form, name) in FORMS.iter().enumerate() {
        let x = LEFT + 100.0 * form as f64;
        marker(&mut svg, form, (x + 6.0, 20.0), false);
        text(&mut svg, (x + 18.0, 24.0), "", name);
    }
    let explained = "circle: ordinary case, bar: worst of the hard cases";
    text(&mut svg, (LEFT + 210.0, 24.0), "", explained);
    let times = (0..2).flat_map(|precision| (0..2).flat_map(move |form| lines(measured, form, precision)));
    let (least, most) =
        times.fold((f64::MAX, 0.0_f64), |(least, most), line| (line.time.min(least), line.time.max(most)));
    let first = TICKS.iter().rposition(|tick| *tick < least).unwrap_or(0);
    let last = TICKS.iter().position(|tick| *tick > most).unwrap_or(TICKS.len() - 1);
    for (precision, name) in ["f64", "f32"].into_iter().enumerate() {
        let axes = Axes { ticks: &TICKS[first..=last], decades: DECADES[precision] };
        let _ =
            writeln!(svg, "<g transform=\"translate({} {TOP})\">", LEFT + precision as f64 * (PANEL.0 + GAP));
        axes.draw(&mut svg, name);
        for form in 0..2 {
            axes.curves(&mut svg, form, &lines(measured, form, precision));
        }
        svg.push_str("</g>\n");
    }
    names(&mut svg);
    let (middle, across) = (LEFT + PANEL.0 + GAP / 2.0, TOP + PANEL.1 / 2.0);
    text(&mut svg, (middle, TOP + PANEL.1 + 40.0), "text-anchor=\"middle\"", "time of an evaluation");
    text(
        &mut svg,
        (18.0, across),
        &format!("text-anchor=\"middle\" transform=\"rotate(-90 18 {across})\""),
        "error of the position",
    );
    svg.push_str("</svg>\n");
    svg
}

/// Every curve in a form and precision.
fn lines(measured: &Measured, form: usize, precision: usize) -> Vec<Line> {
    let error = |accuracy: &Accuracy| [accuracy.printed, accuracy.stable][form][precision];
    let line = |(i, kind): (usize, &Kind)| {
        let of_kind = HARD.iter().zip(&measured.hard).filter(|(case, _)| case.kind().name == kind.name);
        let ordinary = error(&measured.ordinary[i]).unwrap_or(0.0);
        let worst = of_kind.filter_map(|(_, accuracy)| error(accuracy)).fold(ordinary, f64::max);
        Line { time: measured.speeds[i].evaluation[form][precision], ordinary, worst }
    };
    KINDS.iter().enumerate().map(line).collect()
}

/// Logarithmic axes.
struct Axes {
    ticks: &'static [f64],
    decades: (i32, i32),
}

impl Axes {
    fn across(&self, time: f64) -> f64 {
        let (first, last) = (self.ticks[0].log10(), self.ticks[self.ticks.len() - 1].log10());
        PANEL.0 * (time.log10() - first) / (last - first)
    }

    /// Errors beyond the decades are at their ends.
    fn up(&self, error: f64) -> f64 {
        let (low, high) = (f64::from(self.decades.0), f64::from(self.decades.1));
        let decade = if error.is_finite() { error.log10().clamp(low, high) } else { high };
        MARGIN + (PANEL.1 - 2.0 * MARGIN) * (high - decade) / (high - low)
    }

    fn draw(&self, svg: &mut String, name: &str) {
        let upright = self.ticks.iter().map(|tick| format!("M{:.1} 0V{} ", self.across(*tick), PANEL.1));
        let levels: Vec<(i32, f64)> = (self.decades.0..=self.decades.1)
            .filter(|decade| decade % 3 == 0)
            .map(|decade| (decade, self.up(10.0_f64.powi(decade))))
            .collect();
        let level = levels.iter().map(|(_, y)| format!("M0 {y:.1}H{} ", PANEL.0));
        let grid: String = upright.chain(level).collect();
        let _ = writeln!(svg, "<path fill=\"none\" stroke=\"#e3e3e3\" d=\"{grid}\"/>");
        let _ = writeln!(
            svg,
            "<rect width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"#888\"/>",
            PANEL.0, PANEL.1
        );
        text(svg, (0.0, -8.0), "font-weight=\"bold\"", name);
        for tick in self.ticks {
            let x = self.across(*tick);
            text(svg, (x, PANEL.1 + 18.0), "text-anchor=\"middle\"", &format!("{tick} ns"));
        }
        for (decade, y) in levels {
            let label = if decade == 0 { "all lost".to_owned() } else { format!("1e\u{2212}{}", -decade) };
            text(svg, (-8.0, y + 4.0), "text-anchor=\"end\"", &label);
        }
    }

    /// The curves of a form, their numbers above (printed) or below (library), in rows where they are close.
    fn curves(&self, svg: &mut String, form: usize, lines: &[Line]) {
        let color = COLORS[form];
        let mut by_time: Vec<(usize, &Line)> = lines.iter().enumerate().collect();
        by_time.sort_by(|(_, a), (_, b)| a.time.total_cmp(&b.time));
        let mut ends = [f64::MIN; 5];
        for (kind, line) in by_time {
            let x = self.across(line.time);
            let (low, high) = (self.up(line.ordinary), self.up(line.worst));
            let _ = writeln!(
                svg,
                "<path d=\"M{x:.1} {low:.1}V{high:.1}M{:.1} {high:.1}h9\" stroke=\"{color}\" stroke-opacity=\"0.7\" \
                 stroke-width=\"1.6\" fill=\"none\"/>",
                x - 4.5
            );
            marker(svg, form, (x, low), true);
            let row = ends.iter().position(|end| x - end > 13.0).unwrap_or(ends.len() - 1);
            ends[row] = x;
            let offset = ROW * row as f64;
            let y = if form == 0 { MARGIN - 8.0 - offset } else { PANEL.1 - MARGIN + 16.0 + offset };
            let style = format!("text-anchor=\"middle\" font-size=\"11\" fill=\"{color}\"");
            text(svg, (x, y), &style, &(kind + 1).to_string());
        }
    }
}

/// Which number is which curve, below the panels.
fn names(svg: &mut String) {
    for (i, kind) in KINDS.iter().enumerate() {
        let (column, row) = (i / 3, i % 3);
        let at = (LEFT + 225.0 * column as f64, TOP + PANEL.1 + 72.0 + 20.0 * row as f64);
        text(svg, at, "", &format!("{} {}", i + 1, kind.name));
    }
}

/// A circle: hollow for what is printed, filled for the library.
fn marker(svg: &mut String, form: usize, (x, y): (f64, f64), is_small: bool) {
    let color = COLORS[form];
    let fill = if form == 0 { "#fff" } else { color };
    let radius = if is_small { 3.6 } else { 4.5 };
    let _ = writeln!(
        svg,
        "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\" fill=\"{fill}\" stroke=\"{color}\" stroke-width=\"1.5\"/>"
    );
}

//! The picture of error against time.

use super::accuracy::Accuracy;
use super::cases::{HARD, KINDS, Kind};
use super::page::Measured;
use solaris_view::chart::{Axis, Key, Labels, MARGIN, Panel, Picture, Rect, WIDTH};

/// Height of a panel, and of the rows of numbers above and below its curves (px).
const PANEL: f64 = 330.0;
const ROWS: f64 = 60.0;
const ROW: f64 = 14.0;

/// The printed forms and the library's: hollow and filled.
const FORMS: [(&str, &str); 2] = [("hollow s1", "printed"), ("f0", "library")];

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
    panels(&[0, 1].map(|precision| [0, 1].map(|form| lines(measured, form, precision))))
}

/// Panels of the precisions with lines by form.
fn panels(precisions: &[[Vec<Line>; 2]; 2]) -> String {
    let mut picture = Picture::new("Error of a position against time of an evaluation");
    picture.legend(&FORMS.map(|(class, name)| Key::area(class, name)));
    picture.remark("circle: ordinary case, bar: worst of the hard cases; at 1 all is lost", 2);
    let all = || precisions.iter().flatten().flatten();
    let times = Axis::decimal(all().map(|line| line.time));
    for (precision, name) in ["f64", "f32"].into_iter().enumerate() {
        picture.heading(&format!("{name}: error"));
        let (low, high) = DECADES[precision];
        let share = ROWS / (PANEL - 2.0 * ROWS);
        let errors = Axis::logarithmic([10f64.powi(low), 10f64.powi(high)], (low, high), 6).padded(share);
        let panel = Panel::below(&mut picture, PANEL, times.clone(), errors);
        panel.grid(&mut picture);
        for (form, lines) in precisions[precision].iter().enumerate() {
            curves(&mut picture, &panel, form, lines);
        }
        panel.foot(&mut picture, "time of an evaluation (ns)");
    }
    names(&mut picture);
    picture.finish()
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

/// The curves of a form, their numbers above (printed) or below (library), in rows where they are close.
fn curves(picture: &mut Picture, panel: &Panel, form: usize, lines: &[Line]) {
    let (top, bottom) = (panel.top + ROWS, panel.bottom() - ROWS);
    let up = |error: f64| if error.is_finite() { panel.y(error).clamp(top, bottom) } else { top };
    // A number may reach over the side that its curve is at.
    let beside = Rect { left: panel.left - 10.0, right: panel.right() + 10.0, ..panel.rect() };
    let mut labels = Labels::within(beside);
    let mut by_time: Vec<(usize, &Line)> = lines.iter().enumerate().collect();
    by_time.sort_by(|(_, a), (_, b)| a.time.total_cmp(&b.time));
    for (kind, line) in by_time {
        let (x, low, high) = (panel.x(line.time), up(line.ordinary), up(line.worst));
        let class = ["line s1", "line s0"][form];
        picture.line(class, &[(x, low), (x, high)]);
        picture.line(class, &[(x - 4.5, high), (x + 4.5, high)]);
        picture.circle(FORMS[form].0, (x, low), 4.0);
        let rows = (0..4).map(|row| {
            let away = 10.0 + ROW * f64::from(row);
            Rect::about((x, if form == 0 { top - away } else { bottom + away }), (8.0, 0.5 * ROW))
        });
        if let Some(place) = labels.place(rows) {
            picture.text(["middle t1", "middle t0"][form], (x, place.bottom - 2.5), &(kind + 1).to_string());
        }
    }
}

/// Which number is which curve, below the panels.
fn names(picture: &mut Picture) {
    let names: Vec<String> =
        KINDS.iter().enumerate().map(|(i, kind)| format!("{} {}", i + 1, kind.name)).collect();
    for pair in names.chunks(2) {
        let y = picture.take(18.0) + 13.0;
        for (column, name) in pair.iter().enumerate() {
            picture.text("", (MARGIN + 0.5 * WIDTH * column as f64, y), name);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_curve_has_its_number_in_both_forms() {
        let line = |i: usize| Line { time: 20.0 + i as f64, ordinary: 1e-16, worst: f64::INFINITY };
        let lines = || (0..KINDS.len()).map(line).collect::<Vec<Line>>();
        let svg = panels(&[[lines(), lines()], [lines(), lines()]]);
        for kind in 1..=KINDS.len() {
            for class in ["middle t0", "middle t1"] {
                let number =
                    svg.lines().filter(|line| line.contains(class) && line.contains(&format!(">{kind}<")));
                assert_eq!(number.count(), 2, "{kind} {class}");
            }
        }
        assert!(!svg.contains("NaN") && !svg.contains("inf"));
    }
}

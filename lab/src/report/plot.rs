//! The picture of error against time.

use super::cases::ORDINARY;
use super::page::{CALLS, Measured};
use solaris_view::chart::{Axis, Key, Mark, Panel, Picture, Point};

/// Height of a panel, and of what is over it (px).
const PANEL: (f64, f64) = (190.0, 26.0);

/// A panel for each of [`ORDINARY`]; each call is a line from double (filled) to single precision (hollow).
pub(super) fn draw(measured: &Measured) -> String {
    let points = |case: usize, call: usize| -> [Point; 2] {
        let (times, errors) = (measured.speeds[case].times[call], measured.error(case, call));
        [0, 1].map(|width| (times[width], errors[width]))
    };
    let cases: Vec<Vec<[Point; 2]>> =
        (0..ORDINARY.len()).map(|case| (0..CALLS.len()).map(|call| points(case, call)).collect()).collect();
    panels(&ORDINARY.map(|case| case.name), &cases)
}

/// A panel for each case, with a line for each call from one point (filled) to another (hollow): time (ns), error.
fn panels(names: &[&str], cases: &[Vec<[Point; 2]>]) -> String {
    let mut picture = Picture::new("Error against time of a call");
    let keys = CALLS.iter().enumerate().map(|(call, name)| Key::mark(Mark::Filled, call, *name));
    picture.legend(&keys.collect::<Vec<Key>>());
    picture.remark("error, over the time of a call (ns); filled in f64, hollow in f32", 1);
    let points = || cases.iter().flatten().flatten();
    let times = Axis::logarithmic(points().map(|point| point.0), (-3, 12), 6);
    let errors = Axis::logarithmic(points().map(|point| point.1), (-18, 1), 6);
    for (row, names) in names.chunks(2).enumerate() {
        picture.take(PANEL.1);
        let axes = vec![(times.clone(), errors.clone()); 2];
        let panels = Panel::row(&mut picture, PANEL.0, axes);
        picture.take(18.0);
        for (column, (panel, name)) in panels.iter().zip(names).enumerate() {
            panel.heading(&mut picture, name, "");
            panel.grid(&mut picture);
            panel.numbers(&mut picture);
            for (call, ends) in cases[2 * row + column].iter().enumerate() {
                let ends = ends.map(|(time, error)| (panel.x(time), panel.y(error)));
                picture.line(&format!("thin s{call}"), &ends);
                picture.mark(Mark::Filled, call, ends[0]);
                picture.mark(Mark::Hollow, call, ends[1]);
            }
        }
    }
    picture.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The slower and the less exact of two points is farther right and farther up.
    #[test]
    fn points_are_where_their_numbers_say() {
        let lines = vec![[(100.0, 1e-16), (1000.0, 1e-7)]; CALLS.len()];
        let svg = panels(&["one", "two", "three", "four"], &vec![lines; 4]);
        assert_eq!(svg.matches("class=\"mark f0\"").count(), 5, "four panels and the legend");
        assert_eq!(svg.matches("class=\"hollow s0\"").count(), 4);
        let ends: Vec<f64> = svg
            .lines()
            .find(|line| line.contains("class=\"thin s0\""))
            .and_then(|line| line.split("d=\"M").nth(1)?.split('"').next())
            .expect("a line")
            .split(['L', ' '])
            .map(|number| number.parse().expect(number))
            .collect();
        assert!(ends[2] > ends[0] + 20.0 && ends[3] < ends[1] - 20.0, "{ends:?}");
    }
}

//! The picture: a panel for each scene, error against time.

use super::Measured;
use super::points::{Point, Series};
use solaris_view::chart::{Axis, Key, Mark, Panel, Picture};

/// Height of a panel, and of what is over it (px).
const PANEL: (f64, f64) = (200.0, 26.0);

/// What is drawn, by colour and shape: ours filled, MuJoCo's hollow. MuJoCo's other integrators of order one lie on its Euler.
const DRAWN: [(&str, &str); 6] = [
    ("Runge-Kutta 4", "ours: Runge-Kutta 4"),
    ("MuJoCo: RK4", "MuJoCo: RK4"),
    ("adaptive", "ours: adaptive"),
    ("MuJoCo: implicit", "MuJoCo: implicit"),
    ("MuJoCo: Euler", "MuJoCo: Euler"),
    ("tolerance of the run", "ours: tolerance of the run"),
];

/// Errors from here on say nothing, and none is drawn below the least.
const MOST: f64 = 1.0;
const LEAST: f64 = 1e-13;

pub(super) fn draw(measured: &[Measured]) -> String {
    let mut picture = Picture::new("Beside MuJoCo: error against time");
    // Ours first.
    let [ours, theirs] = [false, true].map(|theirs| {
        let of = move |(_, (name, _)): &(usize, &(&str, &str))| name.starts_with("MuJoCo") == theirs;
        DRAWN.iter().enumerate().filter(of).map(|(index, (name, shown))| Key::mark(mark(name), index, *shown))
    });
    picture.legend(&ours.collect::<Vec<Key>>());
    picture.legend(&theirs.collect::<Vec<Key>>());
    picture.remark("greatest error of a position at the end (rad or m), over the time of the run (s); filled: ours, hollow: MuJoCo's", 2);
    for row in measured.chunks(2) {
        picture.take(PANEL.1);
        let axes = row.iter().map(|measured| {
            let points =
                || measured.series.iter().filter(|series| index(series.name).is_some()).flat_map(usable);
            let seconds = Axis::logarithmic(points().map(|point| point.seconds), (-6, 1), 7);
            (seconds, Axis::logarithmic(points().map(|point| point.error[0].max(LEAST)), (-13, 0), 7))
        });
        let axes = axes.collect();
        let panels = Panel::row(&mut picture, PANEL.0, axes);
        picture.take(18.0);
        for (panel, measured) in panels.iter().zip(row) {
            panel.heading(&mut picture, measured.scene.name, "");
            panel.grid(&mut picture);
            panel.numbers(&mut picture);
            for (index, (name, _)) in DRAWN.iter().enumerate() {
                let Some(series) = measured.series.iter().find(|series| series.name == *name) else {
                    continue;
                };
                let places: Vec<(f64, f64)> = usable(series)
                    .map(|point| (panel.x(point.seconds), panel.y(point.error[0].max(LEAST))))
                    .collect();
                picture.line(&format!("line s{index}"), &places);
                for (point, at) in usable(series).zip(&places) {
                    let told = format!("{name}, {}: {:.1e}", point.setting, point.error[0]);
                    picture.told(&told, |picture| picture.mark(mark(name), index, *at));
                }
            }
        }
    }
    picture.finish()
}

fn index(name: &str) -> Option<usize> {
    DRAWN.iter().position(|drawn| drawn.0 == name)
}

fn mark(name: &str) -> Mark {
    if name.starts_with("MuJoCo") { Mark::Hollow } else { Mark::Filled }
}

/// The settings with an error that says something, to the first that is at rounding.
fn usable(series: &Series) -> impl Iterator<Item = &Point> {
    let last = series.points.iter().position(|point| point.error[0] <= LEAST).unwrap_or(usize::MAX);
    series.points.iter().take(last.saturating_add(1)).filter(|point| point.error[0] <= MOST)
}

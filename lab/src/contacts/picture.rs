//! The picture: a panel for each scene, error against the time of a run, a line for each model of contact.

use super::{MODELS, Series};
use solaris_view::chart::{Axis, Key, Mark, Panel, Picture};

/// Height of a panel, and of what is over it (px).
const PANEL: (f64, f64) = (180.0, 26.0);
/// Errors from here on say nothing, and none is drawn below the least.
const MOST: f64 = 10.0;
const LEAST: f64 = 1e-10;

pub(super) fn draw(series: &[Series]) -> String {
    let mut picture = Picture::new("Contact: error against time");
    let keys = MODELS.iter().enumerate().map(|(index, model)| Key::mark(mark(index), index, model.name));
    picture.legend(&keys.collect::<Vec<Key>>());
    picture.remark(
        "how far off a place is at the end (m; of the ball that bounces its energy, as a share), over the time of the run (s); \
         steps of 1e-2 to 1e-4 s",
        2,
    );
    let mut scenes: Vec<&str> = Vec::new();
    for of in series {
        if scenes.last() != Some(&of.scene) {
            scenes.push(of.scene);
        }
    }
    for row in scenes.chunks(2) {
        picture.take(PANEL.1);
        let axes = row.iter().map(|scene| {
            let points = || series.iter().filter(|of| of.scene == *scene).flat_map(places);
            let seconds = Axis::logarithmic(points().map(|point| point.0), (-6, 2), 7);
            (seconds, Axis::logarithmic(points().map(|point| point.1), (-10, 1), 6))
        });
        let axes = axes.collect();
        let panels = Panel::row(&mut picture, PANEL.0, axes);
        picture.take(18.0);
        for (panel, scene) in panels.iter().zip(row) {
            panel.heading(&mut picture, scene, "");
            panel.grid(&mut picture);
            panel.numbers(&mut picture);
            for of in series.iter().filter(|of| of.scene == *scene) {
                let at: Vec<(f64, f64)> = places(of).map(|(x, y, _)| (panel.x(x), panel.y(y))).collect();
                picture.line(&format!("line s{}", of.model), &at);
                for ((_, error, step), at) in places(of).zip(&at) {
                    let told = format!("{}, {step:.0e} s: {error:.1e}", MODELS[of.model].name);
                    picture.told(&told, |picture| picture.mark(mark(of.model), of.model, *at));
                }
            }
        }
    }
    picture.finish()
}

/// Ours are filled.
fn mark(model: usize) -> Mark {
    if MODELS[model].is_ours() { Mark::Filled } else { Mark::Hollow }
}

/// Time (s), error and step (s) of what can be drawn.
fn places(series: &Series) -> impl Iterator<Item = (f64, f64, f64)> {
    let found = series.points.iter().filter_map(|point| {
        point.found.as_ref().ok().map(|found| (found[0], found[1].max(LEAST), point.step))
    });
    found.filter(|(_, error, _)| *error <= MOST)
}

//! A page that shows one curve and its answers.

use super::{Labels, ORDER, answers, number, picture, unit};
use crate::html::{escape, fill, guard, table};
use serde::Serialize;
use solaris_profiles::Answers;

const TEMPLATE: &str = include_str!("../../assets/profile.html");
const STYLE: &str = include_str!("../../assets/profile.css");
const SCRIPT: &str = include_str!("../../assets/profile.js");

/// Samples under the crosshair, and digits of their numbers.
const SAMPLES: usize = 480;
const DIGITS: usize = 6;

/// What the crosshair needs.
#[derive(Serialize)]
struct Data {
    /// Left and right end of the panels, top of the first and bottom of the last (px).
    frame: [f64; 4],
    /// Names and units of the four.
    names: [(String, String); 4],
    /// Time, the four, and their heights in the picture (px).
    samples: Vec<[Option<f64>; 9]>,
}

/// The page: the picture, a table of the answers, and a crosshair that reads the values under the pointer. A whole HTML
/// file as text, which needs nothing else and says the same without scripts. The same input gives the same text.
pub fn page(curve: &dyn Answers, labels: &Labels) -> String {
    let (picture, panels) = picture(curve, labels);
    let duration = curve.duration();
    let samples = (0..=SAMPLES).map(|i| {
        let t = duration * i as f64 / SAMPLES as f64;
        let sample = curve.at(t);
        let mut row = [rounded(t, DIGITS); 9];
        for (order, (_, quantity)) in ORDER.iter().enumerate() {
            let value = quantity.of(&sample);
            row[1 + order] = rounded(value, DIGITS);
            row[5 + order] = rounded(panels[order].y(value), 5);
        }
        row
    });
    let data = Data {
        frame: [panels[0].left, panels[0].right(), panels[0].top, panels[3].bottom()],
        names: std::array::from_fn(|order| (ORDER[order].0.to_owned(), unit(&labels.unit, order))),
        samples: samples.collect(),
    };
    let json = serde_json::to_string(&data).expect("numbers and text are always JSON");
    fill(
        TEMPLATE,
        &[
            ("title", &escape(&labels.title)),
            ("style", STYLE),
            ("picture", &picture.on_page("solaris-profile").finish()),
            ("table", &table(&answers(curve, labels))),
            ("data", &guard(&json)),
            ("script", SCRIPT),
        ],
    )
}

/// A number with so many digits; nothing where it is not finite.
fn rounded(x: f64, digits: usize) -> Option<f64> {
    number(x, digits).parse().ok().filter(|x: &f64| x.is_finite())
}

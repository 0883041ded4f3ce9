//! The figure of `fixtures/reference/smooth/golden.json`, and readers of its numbers.

use serde_json::Value;
use solaris_gait::{Footfall, Manner, PelvicList, StyleTable};
use solaris_model::{Figure, Vector3};

/// The golden numbers of the walk.
pub(crate) fn golden() -> Value {
    read(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/reference/smooth/golden.json"))
}

/// The golden numbers of the run, of the same figure.
pub(crate) fn running_golden() -> Value {
    read(concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/reference/running/golden.json"))
}

pub(crate) fn read(path: &str) -> Value {
    serde_json::from_str(&std::fs::read_to_string(path).expect("the fixture is there")).expect("it is JSON")
}

pub(crate) fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

pub(crate) fn vector(value: &Value) -> Vector3<f64> {
    Vector3::new(number(&value[0]), number(&value[1]), number(&value[2]))
}

/// The coefficients of the recipe that the golden numbers were planned with: its names of our rows, in our order.
pub(crate) fn recipe_table(golden: &Value) -> StyleTable {
    #[rustfmt::skip]
    const NAMES: [&str; StyleTable::NUMBERS.len()] = [
        "theta", "a1", "u1", "a2", "b2", "a3", "b3", "delta", "obu", "uff", "kc", "kc1", "kc2", "kp", "kto", "kto1", "kto2",
        "toe", "kpk", "upk", "aw", "dwp", "cf", "cho", "c40", "c50", "uho", "lean", "kw2", "tb", "tbc", "ttr", "arm", "se",
        "w", "utk", "tau", "vpp", "armlag", "ttu",
    ];
    let mut table = StyleTable {
        manner: Some(Manner::RECIPE),
        footfall: Footfall::RECIPE,
        list: PelvicList::RECIPE,
        ..StyleTable::default()
    };
    for (row, name) in table.rows.iter_mut().zip(NAMES) {
        *row = std::array::from_fn(|k| number(&golden["style_table"][name][k]));
    }
    table
}

/// `thigh_l` is `left_thigh` here.
pub(crate) fn link_name(golden: &str) -> String {
    let name = golden.replace("upperarm", "upper_arm");
    match name.rsplit_once('_') {
        Some((stem, "l")) => format!("left_{stem}"),
        Some((stem, "r")) => format!("right_{stem}"),
        _ => name,
    }
}

/// The figure that the golden numbers belong to, unrounded.
///
/// The file prints it with seven decimals. Where a leg is nearly straight its knee magnifies a length's rounding by more
/// than a hundred, to 3e-3°: so the figure stands beside it in full (`figure.ron`: the human of 1.75 m and 73 kg as it was
/// when the numbers were made, head and shoulders too high), and is held against the printed numbers first.
pub(crate) fn golden_figure(golden: &Value) -> Figure {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../fixtures/reference/smooth/figure.ron");
    let text = std::fs::read_to_string(path).expect("the fixture is there");
    let figure = solaris_model::text::read(&text).expect("a figure");
    for segment in golden["figure"]["segments"].as_array().expect("segments") {
        let link = figure.link(&link_name(segment["name"].as_str().expect("a name"))).expect("a link");
        let near = |a: Vector3<f64>, b: Vector3<f64>, e: f64| {
            assert!((a - b).amax() <= e, "{}: {a} is not {b}", link.name());
        };
        near(link.joint().placement().translation.vector, vector(&segment["offset"]), 5.1e-8);
        near(*link.com(), vector(&segment["com"]), 5.1e-8);
        near(link.inertia().diagonal(), vector(&segment["inertia_diag"]), 5.1e-9);
        assert!((link.mass() - number(&segment["mass"])).abs() <= 5.1e-7);
    }
    figure
}

/// The largest difference met so far, and where.
#[derive(Default)]
pub(crate) struct Worst(pub(crate) f64, pub(crate) String);

impl Worst {
    pub(crate) fn note(&mut self, difference: f64, place: impl FnOnce() -> String) {
        assert!(difference.is_finite(), "not a number at {}", place());
        if difference > self.0 {
            *self = Self(difference, place());
        }
    }
}

/// Largest differences of lengths (m), angles (degrees), shares and forces (N).
#[derive(Default)]
pub(crate) struct Differences {
    pub(crate) length: Worst,
    pub(crate) angle: Worst,
    pub(crate) share: Worst,
    pub(crate) force: Worst,
}

impl Differences {
    /// Compares the angles `q` of all segments, and the pitches of foot and toes (rad), with the golden sample `i`.
    pub(crate) fn note_angles(
        &mut self,
        figure: &Figure,
        golden: &Value,
        i: usize,
        q: &[f64],
        pitches: [(f64, f64); 2],
    ) {
        self.note_joints(figure, golden, i, q);
        for (name, pitches) in ["left", "right"].into_iter().zip(pitches) {
            self.note_pitches(golden, i, name, pitches);
        }
    }

    /// The angles `q` of all segments.
    pub(crate) fn note_joints(&mut self, figure: &Figure, golden: &Value, i: usize, q: &[f64]) {
        for (key, values) in golden["angles"].as_object().expect("angles") {
            let (segment, axis) = key.rsplit_once('_').expect("an axis");
            let link = figure.link_index(&link_name(segment)).expect("a link");
            let layout = figure.layout().joints()[link];
            let axis = ["z", "y", "x"].iter().position(|a| *a == axis).expect("an axis");
            let found = q[layout.q + layout.nq - 3 + axis].to_degrees();
            self.angle.note((found - number(&values[i])).abs(), || format!("{key}, sample {i}"));
        }
    }

    /// The pitches of a side's foot and toes (rad).
    pub(crate) fn note_pitches(&mut self, golden: &Value, i: usize, side: &str, (foot, toes): (f64, f64)) {
        for (what, found) in [("foot", foot), ("toes", toes)] {
            let wanted = number(&golden[format!("{what}_pitch_{side}")][i]);
            self.angle
                .note((found.to_degrees() - wanted).abs(), || format!("{what} pitch {side}, sample {i}"));
        }
    }

    pub(crate) fn assert_below(&self, [length, angle, force, share]: [f64; 4]) {
        for (what, worst, limit) in [
            ("length (m)", &self.length, length),
            ("angle (degrees)", &self.angle, angle),
            ("share", &self.share, share),
            ("force (N)", &self.force, force),
        ] {
            println!("  {what}: {:.2e} at {}", worst.0, worst.1);
            assert!(worst.0 <= limit, "{what} is off by {} at {}; the limit is {limit}", worst.0, worst.1);
        }
    }
}

//! Plates of four types that all say the same.

use super::writer::{Signal, Value};
use solaris_model::{Matrix3, Vector3};

/// The force (N), the centre of pressure (m) and the free moment (N·m) along each plate's axes.
pub(crate) const FORCE: Vector3<f64> = Vector3::new(10.0, -20.0, -500.0);
pub(crate) const CENTRE: Vector3<f64> = Vector3::new(0.05, -0.1, 0.0);
pub(crate) const FREE: Vector3<f64> = Vector3::new(0.0, 0.0, 3.0);
/// The sensors' origin (mm); of type 3 half the sensors' distances.
const ORIGIN: Vector3<f64> = Vector3::new(1.0, 2.0, -40.0);
const SENSORS: Vector3<f64> = Vector3::new(120.0, 200.0, -50.0);

/// The axes of all plates: z down, as AMTI's.
#[rustfmt::skip]
pub(crate) fn axes() -> Matrix3<f64> {
    Matrix3::new(
        0.0, 1.0,  0.0,
        1.0, 0.0,  0.0,
        0.0, 0.0, -1.0,
    )
}

/// The middle of the surface of plate `at` (m).
pub(crate) fn middle(at: usize) -> Vector3<f64> {
    Vector3::new(0.3 + 0.6 * at as f64, 0.25, 0.0)
}

/// The channels (N, N·mm, mm) of a plate of a type under the load.
fn channels(kind: usize) -> Vec<f64> {
    let mm = CENTRE * 1e3;
    let surface = mm.cross(&FORCE) + FREE * 1e3;
    let sensor = surface - FORCE.cross(&ORIGIN);
    match kind {
        1 => vec![FORCE.x, FORCE.y, FORCE.z, mm.x, mm.y, FREE.z * 1e3],
        2 => vec![FORCE.x, FORCE.y, FORCE.z, sensor.x, sensor.y, sensor.z],
        3 => {
            let (a, b) = (SENSORS.x, SENSORS.y);
            let raw = surface - FORCE.cross(&Vector3::new(0.0, 0.0, SENSORS.z));
            let z = |x: f64, y: f64| FORCE.z / 4.0 + x * raw.x / (4.0 * b) + y * raw.y / (4.0 * a);
            let turn = raw.z / b;
            let (fx12, fx34) = (0.5 * (FORCE.x - turn), 0.5 * (FORCE.x + turn));
            let (fy14, fy23) = (FORCE.y / 2.0, FORCE.y / 2.0);
            vec![fx12, fx34, fy14, fy23, z(1.0, -1.0), z(1.0, 1.0), z(-1.0, 1.0), z(-1.0, -1.0)]
        }
        _ => {
            // The matrix below, backwards.
            let fy = FORCE.y / 4.0;
            vec![
                (FORCE.x - 0.5 * fy) / 2.0,
                fy,
                FORCE.z / 5.0,
                sensor.x / 10.0,
                sensor.y / 10.0,
                sensor.z / 10.0,
            ]
        }
    }
}

/// The calibration of type 4, column by column.
fn calibration() -> Vec<f64> {
    let mut matrix = [0.0; 36];
    for (at, value) in [2.0, 4.0, 5.0, 10.0, 10.0, 10.0].into_iter().enumerate() {
        matrix[7 * at] = value;
    }
    // Row 0, column 1: a sideways force that shows up along x.
    matrix[6] = 0.5;
    matrix.to_vec()
}

/// Four plates, of types 1 to 4, with the load in the samples that `is_loaded` and nothing in the others.
pub(crate) fn four(samples: usize, is_loaded: impl Fn(usize) -> bool) -> (Vec<Signal>, Vec<Parameter>) {
    let (mut signals, mut numbers): (Vec<Signal>, Vec<i32>) = (Vec::new(), Vec::new());
    for kind in 1..=4 {
        let values = channels(kind);
        for place in 0..8 {
            let Some(value) = values.get(place) else {
                numbers.push(0);
                continue;
            };
            let is_moment = kind != 3 && place >= 3 && !(kind == 1 && place < 5);
            signals.push(Signal {
                label: format!("P{kind}C{place}"),
                unit: if is_moment { "Nmm" } else { "N" }.to_owned(),
                scale: if is_moment { 2.0 } else { 0.05 },
                offset: -7,
                samples: (0..samples).map(|at| if is_loaded(at) { *value } else { 0.0 }).collect(),
            });
            numbers.push(signals.len() as i32);
        }
    }
    let corner =
        |at: usize, x: f64, y: f64| ((middle(at) + axes() * Vector3::new(x, y, 0.0)) * 1e3).data.0[0];
    let corners = |at: usize| {
        [(0.2, 0.3), (-0.2, 0.3), (-0.2, -0.3), (0.2, -0.3)].map(|(x, y)| corner(at, x, y)).concat()
    };
    let origins = [ORIGIN, ORIGIN, SENSORS, -ORIGIN].iter().flat_map(|o| o.iter().copied()).collect();
    let matrices = (0..4).flat_map(|_| calibration()).collect();
    let parameters = vec![
        ("FORCE_PLATFORM", "USED", Value::Words(vec![], vec![4])),
        ("FORCE_PLATFORM", "TYPE", Value::Words(vec![4], vec![1, 2, 3, 4])),
        ("FORCE_PLATFORM", "CORNERS", Value::Reals(vec![3, 4, 4], (0..4).flat_map(corners).collect())),
        ("FORCE_PLATFORM", "ORIGIN", Value::Reals(vec![3, 4], origins)),
        ("FORCE_PLATFORM", "CHANNEL", Value::Words(vec![8, 4], numbers)),
        ("FORCE_PLATFORM", "CAL_MATRIX", Value::Reals(vec![6, 6, 4], matrices)),
        ("FORCE_PLATFORM", "ZERO", Value::Words(vec![2], vec![1, 1])),
    ];
    (signals, parameters)
}

/// Group, name and value.
pub(crate) type Parameter = (&'static str, &'static str, Value);

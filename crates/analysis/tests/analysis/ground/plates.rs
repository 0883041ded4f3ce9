//! Feet on force plates, against who stands where.

use solaris_analysis::PreparedMotion;
use solaris_analysis::ground::{PlacedFeet, PlateRecord, feet_on_plates, soles};
use solaris_model::{Contact, Motion, MotionInfo, Vector3, human};

/// A plate at 500 Hz that carries 400 N at `cop` in these times (s).
fn plate(name: &str, cop: Vector3<f64>, spans: &[(f64, f64)]) -> PlateRecord {
    let time: Vec<f64> = (0..500).map(|i| f64::from(i) / 500.0).collect();
    let sample = |t: &f64| {
        if !spans.iter().any(|(from, to)| (*from..*to).contains(t)) {
            return Contact::default();
        }
        let force = Vector3::new(0.0, 400.0, 0.0);
        Contact { force, moment: cop.cross(&force), cop }
    };
    PlateRecord { name: name.to_owned(), samples: time.iter().map(sample).collect(), time }
}

#[test]
fn loads_belong_to_the_foot_above_them() {
    let figure = human(1.75, 73.0).expect("a person");
    let (nv, frames) = (figure.layout().nv(), 101);
    let still = vec![0.0; frames * nv];
    let time = (0..frames).map(|i| i as f64 / 100.0).collect();
    let motion = Motion::new(
        &figure,
        MotionInfo::on_earth(&figure, 100.0),
        time,
        [still.clone(), still.clone(), still],
    );
    let motion = motion.expect("a motion");
    let prepared = PreparedMotion::new(&figure, &motion).expect("ready");
    let feet = PlacedFeet::new(&prepared, soles(&figure)).expect("placed");
    // Half way from heel to tip of each foot, 2 cm to the side, on the floor.
    let under = |foot: usize| {
        let [heel, _, tip] = feet.frame(0)[foot].points;
        let middle = (heel + tip) * 0.5;
        Vector3::new(middle.x + 0.02, 0.0, middle.z)
    };
    let plates = [
        plate("first", under(1), &[(0.1, 0.3), (0.32, 0.5), (0.9, 0.91)]),
        plate("second", under(0), &[(0.2, 0.8)]),
        plate("far", under(0) + Vector3::new(0.0, 0.0, 0.8), &[(0.0, 1.0)]),
    ];
    let (forces, loads) = feet_on_plates(&feet, &plates);
    let found: Vec<_> = loads.iter().map(|load| (load.plate, load.foot)).collect();
    // A break of 20 ms is none, and 10 ms are no load.
    assert_eq!(found, [(0, Some(1)), (1, Some(0)), (2, None)]);
    assert!((loads[0].span.0 - 0.1).abs() < 3e-3 && (loads[0].span.1 - 0.5).abs() < 3e-3);
    assert!((loads[0].distance - 0.02).abs() < 1e-3 && loads[2].distance > 0.5);
    assert_eq!(forces.len(), 2);
    let names: Vec<&str> = forces.iter().map(|force| force.links[0].as_str()).collect();
    let foot = |i: usize| figure.links()[feet.soles()[i].foot].name();
    assert_eq!(names, [foot(1), foot(0)]);
    assert_eq!(forces[0].samples[100], plates[0].samples[100]);
    assert!(forces[0].samples[452].force.norm() < 1e-12, "noise is nobody's");
}

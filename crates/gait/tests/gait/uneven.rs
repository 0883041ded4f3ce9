//! The ground's forces of walks on stairs and slopes, found from the motion alone, beside those by which it was planned.

use super::terrain::request;
use nalgebra::Vector3;
use solaris_analysis::ground::{
    ConsistencyOptions, GroundError, GroundOptions, PlacedFeet, Split, consistent_shift, ground_forces, soles,
};
use solaris_analysis::{PreparedMotion, ground_reactions};
use solaris_gait::{FEET, Stairs, WalkGround, walk};
use solaris_model::{Figure, Human, Motion, Relief, human};

/// A motion with its planned forces.
fn walked(figure: &Figure, ground: WalkGround, step_frequency: f64) -> Motion {
    let plan = walk(figure, &request(ground, step_frequency)).expect("a walk");
    let mut motion = plan.motion(figure, 120.0).expect("a motion");
    ground_reactions(figure, &mut motion, FEET, &plan).expect("forces");
    motion
}

/// Root mean squares of what the feet's vertical forces (of the weight) and centres of pressure (m, where a foot bears a fifth of the weight) are off.
fn off(figure: &Figure, motion: &Motion, split: Split) -> [f64; 2] {
    let prepared = PreparedMotion::new(figure, motion).expect("ready");
    let feet = PlacedFeet::new(&prepared, soles(figure)).expect("placed");
    let found = ground_forces(&feet, &GroundOptions { split, ..GroundOptions::default() }).expect("forces");
    let weight = figure.mass() * 9.80665;
    let (mut forces, mut places) = (Vec::new(), Vec::new());
    for (theirs, ours) in motion.contacts.iter().zip(&found.contacts) {
        assert_eq!(theirs.link, ours.link);
        for (a, b) in theirs.samples.iter().zip(&ours.samples) {
            forces.push(((a.force.y - b.force.y) / weight).powi(2));
            if a.force.y.min(b.force.y) > 0.2 * weight {
                places.push((a.cop - b.cop).norm_squared());
            }
        }
    }
    [forces, places].map(|squares| (squares.iter().sum::<f64>() / squares.len() as f64).sqrt())
}

fn stairs(rise: f64) -> WalkGround {
    WalkGround::Stairs(Stairs { count: 5, rise, tread: 0.29 })
}

#[test]
fn forces_on_stairs_and_slopes_are_as_right_as_on_a_floor() {
    let slope = |degrees: f64| WalkGround::Slope(degrees.to_radians());
    let kerb = WalkGround::Relief(Relief::new(vec![[2.0, 0.0], [2.0, 0.1]]).expect("a kerb"));
    for figure in [human(1.75, 73.0), human(1.9, 85.0)] {
        let figure = figure.expect("a person");
        for (name, ground, pace, limits) in [
            ("a floor", WalkGround::Level, 100.0, [0.045, 0.02]),
            ("up a slope", slope(8.0), 100.0, [0.045, 0.02]),
            ("down a slope", slope(-10.0), 100.0, [0.06, 0.025]),
            ("up stairs", stairs(0.17), 88.0, [0.065, 0.025]),
            ("down stairs", stairs(-0.17), 95.0, [0.055, 0.025]),
            ("over a kerb", kerb.clone(), 98.0, [0.06, 0.025]),
        ] {
            let motion = walked(&figure, ground, pace);
            let [force, place] = off(&figure, &motion, Split::Pivot);
            println!("{name}: {:.1} % of the weight, {:.1} mm", 100.0 * force, 1e3 * place);
            assert!(force < limits[0] && place < limits[1], "{name}: {force}, {place} m");
        }
    }
}

#[test]
fn every_split_adds_up_on_stairs() {
    let figure = human(1.75, 73.0).expect("a person");
    let motion = walked(&figure, stairs(0.17), 88.0);
    let prepared = PreparedMotion::new(&figure, &motion).expect("ready");
    let feet = PlacedFeet::new(&prepared, soles(&figure)).expect("placed");
    for split in Split::ALL {
        let options = GroundOptions { split, ..GroundOptions::default() };
        let found = ground_forces(&feet, &options).expect("forces");
        let heights = found.stances.heights(&Vector3::y()).expect("not level");
        assert!((heights.0).abs() < 5e-3 && (heights.1 - 0.85).abs() < 5e-3, "{heights:?}");
        for (row, whole) in found.total.iter().enumerate() {
            let of_feet = found.contacts.iter().map(|track| track.samples[row]);
            let sum: (Vector3<f64>, Vector3<f64>) = of_feet
                .fold((Vector3::zeros(), Vector3::zeros()), |(force, moment), contact| {
                    (force + contact.force, moment + contact.moment)
                });
            let off = (sum.0 - whole.force).norm() + (sum.1 - whole.moment).norm();
            assert!(off < 1e-8 * 715.0, "{}: {off} in frame {row}", split.name());
        }
        // The pressure is on the treads: of a foot that bears, at the height of its own one.
        for track in &found.contacts {
            for contact in track.samples.iter().filter(|contact| contact.force.y > 100.0) {
                let tread = (contact.cop.y / 0.17).round() * 0.17;
                assert!((contact.cop.y - tread).abs() < 5e-3, "{}: {}", split.name(), contact.cop.y);
            }
        }
    }
    let refused = consistent_shift(
        &feet,
        &ground_forces(&feet, &GroundOptions::default()).expect("forces").stances,
        &ConsistencyOptions::default(),
    );
    let Err(GroundError::NotLevel { apart }) = refused else { panic!("{refused:?}") };
    assert!((apart - 0.85).abs() < 1e-2);
}

/// On level ground nothing is told of it, however tall or wide somebody is, and where both feet stand.
#[test]
fn level_ground_stays_level() {
    for (height, mass) in [(1.1, 19.0), (1.75, 73.0), (2.0, 120.0)] {
        let figure = Human::new(height, mass).build().expect("a person");
        let motion = walked(&figure, WalkGround::Level, 105.0);
        let prepared = PreparedMotion::new(&figure, &motion).expect("ready");
        let feet = PlacedFeet::new(&prepared, soles(&figure)).expect("placed");
        let found = ground_forces(&feet, &GroundOptions::default()).expect("forces");
        assert!(found.stances.footings.is_empty() && found.stances.heights(&Vector3::y()).is_none());
    }
}

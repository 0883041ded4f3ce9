//! The ground's forces of walks on stairs and slopes, found from the motion alone, beside those by which it was planned.

use super::terrain::request;
use nalgebra::Vector3;
use solaris_analysis::ground::{
    ConsistencyOptions, GroundError, GroundOptions, PlacedFeet, Split, Stance, StanceOptions,
    consistent_shift, find_stances, ground_forces, soles,
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

/// The part of a motion between two times (s).
fn part(figure: &Figure, motion: &Motion, [from, to]: [f64; 2]) -> Motion {
    let rows: Vec<usize> =
        (0..motion.len()).filter(|row| (from..=to).contains(&motion.time()[*row])).collect();
    let column = |of: &dyn Fn(usize) -> Vec<f64>| rows.iter().flat_map(|row| of(*row)).collect::<Vec<f64>>();
    let columns = [
        column(&|row| motion.q(row).to_vec()),
        column(&|row| motion.v(row).to_vec()),
        column(&|row| motion.a(row).to_vec()),
    ];
    let time = rows.iter().map(|row| motion.time()[*row]).collect();
    let mut part = Motion::new(figure, motion.info.clone(), time, columns).expect("a motion");
    part.contacts.clone_from(&motion.contacts);
    for track in &mut part.contacts {
        track.samples = rows.iter().map(|row| track.samples[*row]).collect();
    }
    part
}

/// Root mean squares of what the feet's vertical forces (of the weight) and centres of pressure (m, where a foot bears a fifth of the weight) are off.
fn off(figure: &Figure, motion: &Motion, split: Split) -> [f64; 2] {
    let prepared = PreparedMotion::new(figure, motion).expect("ready");
    let feet = PlacedFeet::new(&prepared, soles(figure)).expect("placed");
    let found = ground_forces(&feet, &GroundOptions { split, ..GroundOptions::default() }).expect("forces");
    assert_eq!(found.stances.belt, Vector3::zeros());
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
            // Any three seconds on the way, in which the feet stand on no common level at first or at last.
            for from in [1.5, 2.0, 2.5, 3.0, 3.3] {
                let cut = part(&figure, &motion, [from, from + 3.0]);
                let [force, place] = off(&figure, &cut, Split::Pivot);
                println!("  from {from} s: {:.1} % of the weight, {:.1} mm", 100.0 * force, 1e3 * place);
                assert!(force < 0.12 && place < 0.04, "{name} from {from} s: {force}, {place} m");
            }
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

/// A lunge on a floor: one foot on its toes with the heel up, which is no slope.
#[test]
fn a_heel_that_is_up_is_no_ground() {
    let figure = human(1.75, 73.0).expect("a person");
    for pitch in [0.4, 0.6, 0.8] {
        let mut q = vec![0.0; figure.layout().nq()];
        let dof = |name: &str| figure.layout().q_names().iter().position(|dof| dof == name).expect("a dof");
        // The left foot tips over its toes, which stay flat; its leg is bent until both feet are on the ground.
        q[dof("left_toes.rx")] = -pitch;
        let lowest = |q: &[f64], side: &str| {
            let places = figure.places(q);
            let sole = |link: &str| {
                let link = figure.link_index(&format!("{side}_{link}")).expect("a link");
                figure.links()[link].sole().iter().map(move |point| (link, point.position))
            };
            let points = sole("foot").chain(sole("toes"));
            points
                .map(|(link, at)| (places[link] * nalgebra::Point3::from(at)).y)
                .fold(f64::INFINITY, f64::min)
        };
        let (mut low, mut high) = (0.0, 1.5);
        for _ in 0..60 {
            let bent = f64::midpoint(low, high);
            (q[dof("left_hip.rx")], q[dof("left_knee.rx")], q[dof("left_ankle.rx")]) =
                (-bent, 2.0 * bent, pitch - bent);
            if lowest(&q, "left") < lowest(&q, "right") { low = bent } else { high = bent }
        }
        assert!((lowest(&q, "left") - lowest(&q, "right")).abs() < 1e-6);
        let frames = 61_usize;
        let time: Vec<f64> = (0..frames).map(|i| i as f64 / 60.0).collect();
        let still = vec![0.0; figure.layout().nv() * frames];
        let motion = Motion::new(
            &figure,
            solaris_model::MotionInfo::on_earth(&figure, 60.0),
            time,
            [q.repeat(frames), still.clone(), still],
        )
        .expect("a motion");
        let prepared = PreparedMotion::new(&figure, &motion).expect("ready");
        let feet = PlacedFeet::new(&prepared, soles(&figure)).expect("placed");
        let found = ground_forces(&feet, &GroundOptions::default()).expect("forces");
        assert_eq!(found.stances.list.len(), 2, "{pitch}");
        assert!(found.stances.footings.is_empty(), "{pitch}: {:?}", found.stances.footings);
    }
}

/// Stances that are told of more than the motion shows.
#[test]
fn stances_beyond_the_motion_change_nothing() {
    let figure = human(1.75, 73.0).expect("a person");
    let motion = walked(&figure, stairs(0.17), 88.0);
    let cut = part(&figure, &motion, [3.0, 6.0]);
    let prepared = PreparedMotion::new(&figure, &cut).expect("ready");
    let feet = PlacedFeet::new(&prepared, soles(&figure)).expect("placed");
    let mut stances = find_stances(&feet, &StanceOptions::default()).expect("stances");
    let heights = stances.heights(&Vector3::y()).expect("stairs");
    stances.list.push(Stance { foot: 0, start: 9.0, end: 9.5 });
    stances.footings = feet.footings(&stances.list, &stances.belt);
    assert_eq!(stances.heights(&Vector3::y()), Some(heights));
    let told = GroundOptions { stances: Some(stances.clone()), ..GroundOptions::default() };
    assert_eq!(ground_forces(&feet, &told).expect("forces").contacts[0].samples.len(), cut.len());
    stances.footings[1].normal = Vector3::zeros();
    let told = GroundOptions { stances: Some(stances), ..GroundOptions::default() };
    let refused = ground_forces(&feet, &told);
    assert!(matches!(refused, Err(GroundError::NoPlane { stance: 1 })), "{refused:?}");
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

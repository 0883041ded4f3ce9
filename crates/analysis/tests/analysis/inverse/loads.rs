//! Measured forces at the times of a motion.

use crate::inverse::support::{GRAVITY, build, forces, pendulum, push};
use crate::states::{States, inverse_motion};
use solaris_analysis::{InverseOptions, Loads};
use solaris_model::{Contact, Figure, Joint, LinkSpec, MeasuredForce, SolePart, Vector3};

/// A bob of no weight on a slide along y and one along z: forces are read off directly.
fn probe() -> Figure {
    build([LinkSpec::root("probe", Joint::new("at").tx().ty().tz()).mass(1.0)])
}

/// What the slides of [`probe`] need at these times, without gravity: the force, turned around.
fn felt(record: MeasuredForce, time: &[f64]) -> Vec<[f64; 3]> {
    let numbers = vec![0.0; 3 * time.len()];
    let motion = States {
        time: time.to_vec(),
        q: numbers.clone(),
        v: numbers.clone(),
        a: numbers,
        ..States::default()
    };
    let report = inverse_motion(&probe(), Vector3::zeros(), &motion, &[record], InverseOptions::default());
    report.expect("in range").tau.chunks_exact(3).map(|tau| [-tau[0], -tau[1], -tau[2]]).collect()
}

#[test]
fn samples_are_used_as_they_are_and_between_them_forces_run_straight() {
    let rows = [(0.0, [1.0, 0.0, 2.0]), (0.1, [3.0, 8.0, 0.0]), (0.3, [-1.0, 0.0, 0.0])];
    let record = forces(&["probe"], &rows.map(|(t, f)| (t, push(f, [0.0; 3]))));
    let found = felt(record, &[-0.1, 0.0, 0.05, 0.1 + 0.9e-9, 0.2, 0.3, 0.35]);
    let expected = [
        [1.0, 0.0, 2.0],
        [1.0, 0.0, 2.0],
        [2.0, 4.0, 1.0],
        [3.0, 8.0, 0.0],
        [1.0, 4.0, 0.0],
        rows[2].1,
        rows[2].1,
    ];
    for (found, expected) in found.iter().zip(expected) {
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?} {expected:?}");
    }
}

/// Linear between wrenches: the moment that is felt half-way is the mean, though the point in between is not.
#[test]
fn moments_run_straight_as_well() {
    let rows =
        [(0.0, push([0.0, 0.0, 0.0], [9.0, 9.0, 9.0])), (1.0, push([0.0, 10.0, 0.0], [0.0, 0.0, 0.4]))];
    let record = forces(&["bob"], &rows);
    let motion = States { time: vec![0.25], q: vec![0.0], v: vec![0.0], a: vec![0.0], ..States::default() };
    let report = inverse_motion(&pendulum(), GRAVITY, &motion, &[record], InverseOptions::default())
        .expect("in range");
    // (0, 0, 0.4) × (0, 10, 0) = (−4, 0, 0)
    assert!((report.tau[0] - 1.0).abs() < 1e-14, "{}", report.tau[0]);
}

fn foot() -> Figure {
    let (ball, tip) = (Vector3::new(0.0, -0.05, 0.02), Vector3::new(0.0, -0.05, 0.1));
    build([
        LinkSpec::root("shin", Joint::new("ankle").rx()).mass(1.0),
        LinkSpec::child("toes", "shin", Joint::new("ball").at(Vector3::new(0.0, 0.0, 0.1)).rx())
            .mass(0.1)
            .sole(SolePart::Ball, ball)
            .sole(SolePart::ToeTip, tip),
    ])
}

/// The toes feel what acts before the ball, and nothing of what acts behind it.
#[test]
fn the_toes_take_over_at_the_ball() {
    let figure = foot();
    let toes_feel = |z: f64| {
        let record = forces(&["shin", "toes"], &[(0.0, push([0.0, 100.0, 0.0], [0.0, -0.05, z]))]);
        let motion = States {
            time: vec![0.0],
            q: vec![0.0; 2],
            v: vec![0.0; 2],
            a: vec![0.0; 2],
            ..States::default()
        };
        let tau = inverse_motion(&figure, Vector3::zeros(), &motion, &[record], InverseOptions::default())
            .expect("one row")
            .tau;
        assert!((tau[0] - 100.0 * z).abs() < 1e-12, "the ankle feels both");
        tau[1]
    };
    assert!((toes_feel(0.121) - 100.0 * 0.021).abs() < 1e-12);
    assert_eq!(toes_feel(0.119).to_bits() << 1, 0);
}

#[test]
fn what_does_not_fit_is_refused() {
    let rows = [(0.0, Contact::default()), (0.1, Contact::default()), (0.2, Contact::default())];
    let record = |links: &[&str]| forces(links, &rows);
    let error = |record: MeasuredForce, time: &[f64]| match Loads::at_times(&foot(), &[record], time) {
        Ok(_) => "ACCEPTED".to_owned(),
        Err(error) => error.to_string(),
    };
    assert_eq!(
        error(record(&["toe"]), &[0.0]),
        "figure 'test' has no link 'toe' for a force to act on (is 'toes' meant?)"
    );
    assert_eq!(
        error(record(&[]), &[0.0]),
        "a force acts on 0 links; name one, or two: the foot and its toes"
    );
    assert_eq!(
        error(record(&["toes", "shin"]), &[0.0]),
        "link 'shin' has no ball and toe tip in its sole, so it is not known from where on it carries the force on 'toes'; \
         name one link"
    );
    assert_eq!(
        error(record(&["shin"]), &[-0.05, 0.1, 0.31]),
        "the motion lasts from -0.05 s to 0.31 s, the force on 'shin' is known from 0 s to 0.2 s; cut the motion, or give \
         the forces for all of it"
    );
    assert_eq!(error(record(&["shin"]), &[-0.05, 0.29]), "ACCEPTED");
    let one = MeasuredForce { time: vec![0.0], samples: vec![Contact::default()], ..record(&["shin"]) };
    assert_eq!(error(one.clone(), &[0.0]), "ACCEPTED");
    assert!(error(one, &[0.001]).starts_with("the motion lasts"));
    let mut broken = record(&["shin"]);
    broken.samples[1].force.x = f64::NAN;
    assert_eq!(
        error(broken, &[0.0]),
        "the force on 'shin': sample 1 at 0.1 s holds a number that is not finite"
    );
    let mut broken = record(&["shin"]);
    broken.time[2] = 0.1;
    assert_eq!(
        error(broken, &[0.0]),
        "the force on 'shin': sample 2 at 0.1 s does not come after the one before it"
    );
    let mut broken = record(&["shin"]);
    broken.time.pop();
    assert_eq!(
        error(broken, &[0.0]),
        "the force on 'shin' has 3 samples at 2 times; it must have one a time, at least one"
    );
}

//! From positions to velocities and accelerations.

use crate::inverse::support::{body, build, equally, pendulum, positions};
use crate::states::{Record, States, complete};
use solaris_analysis::{DifferentiateError, Filter};
use solaris_model::{Curve, Figure, Joint, LinkSpec, UnitQuaternion, Vector3};

const SIX_HERTZ: Option<Filter> = Some(Filter { cutoff: 6.0, order: 2 });

/// A free root and a ball joint that both move as [`top`] does.
fn tumbler() -> Figure {
    build([
        body(LinkSpec::root("body", Joint::free("root"))),
        body(LinkSpec::child("arm", "body", Joint::ball("shoulder"))),
    ])
}

/// A body that turns about a fixed axis and about its own, thrown: orientation, then ω, ω̇, v and v̇ along its axes.
fn top(t: f64) -> (Vector3<f64>, UnitQuaternion<f64>, [Vector3<f64>; 4]) {
    let (axis, precession, spin) = (Vector3::new(0.36, 0.48, 0.8), 2.0, 5.0);
    let (throw, gravity) = (Vector3::new(0.5, 4.0, 1.0), Vector3::new(0.0, -9.80665, 0.0));
    let own = UnitQuaternion::new(Vector3::z() * (spin * t));
    let turn = UnitQuaternion::new(axis * (precession * t)) * own;
    let tilted = own.inverse() * axis * precession;
    let omega = tilted + Vector3::z() * spin;
    let alpha = -(Vector3::z() * spin).cross(&tilted);
    let v = turn.inverse() * (throw + gravity * t);
    let a = turn.inverse() * gravity - omega.cross(&v);
    (throw * t + gravity * (t * t / 2.0), turn, [omega, alpha, v, a])
}

fn tumbling(figure: &Figure, sign: impl Fn(f64) -> f64) -> Record {
    positions(figure, equally(241, 120.0), |t| {
        let (place, turn, _) = top(t);
        let turn = turn.coords * sign(t);
        [place.as_slice(), turn.as_slice(), turn.as_slice()].concat()
    })
}

/// Greatest differences in velocity and acceleration between rows.
fn differences(motion: &States, rows: std::ops::Range<usize>) -> [f64; 2] {
    let mut worst = [0.0_f64; 2];
    for row in rows {
        let (_, _, [omega, alpha, v, a]) = top(motion.time[row]);
        for (i, expected) in [[v, omega, omega], [a, alpha, alpha]].into_iter().enumerate() {
            let found = [&motion.v, &motion.a][i][row * 9..][..9].chunks_exact(3);
            for (found, expected) in found.zip(expected) {
                worst[i] = worst[i].max((Vector3::from_row_slice(found) - expected).norm());
            }
        }
    }
    worst
}

#[test]
fn a_tumbling_body_has_the_velocities_of_its_closed_form() {
    let figure = tumbler();
    // Signs of quaternions mean nothing.
    let flipping = tumbling(&figure, |t| if (37.0 * t).sin() > 0.3 { -1.0 } else { 1.0 });
    let motion = complete(&figure, &flipping, None).expect("slow enough");
    let [velocity, acceleration] = differences(&motion, 30..211);
    assert!(velocity < 1e-8 && acceleration < 1e-5, "{velocity:e} {acceleration:e}");
    assert_eq!((motion.q, motion.unsettled), (flipping.q, 0.0));
    // A length that wavers, as that of printed quaternions, is no motion.
    let wavering = tumbling(&figure, |t| 1.0 + 5e-4 * (90.0 * t).sin());
    let motion = complete(&figure, &wavering, None).expect("slow enough");
    let [velocity, acceleration] = differences(&motion, 30..211);
    assert!(velocity < 1e-8 && acceleration < 1e-5, "{velocity:e} {acceleration:e}");
}

#[test]
fn what_is_given_stays_to_the_bit() {
    let figure = tumbler();
    let mut record = tumbling(&figure, |_| 1.0);
    record.v = (0..241 * 9).map(|i| (f64::from(i) * 0.01).sin()).collect();
    record.a = (0..241 * 9).map(|i| f64::from(i * i % 17)).collect();
    record.known_v.fill(true);
    record.known_a.fill(true);
    record.time = (0..241).map(|i| f64::from((i * 7) % 241)).collect();
    let motion = complete(&figure, &record, SIX_HERTZ).expect("nothing to do");
    assert_eq!((&motion.q, &motion.v, &motion.a), (&record.q, &record.v, &record.a));
    assert_eq!((motion.time, motion.unsettled, motion.found), (record.time, 0.0, vec![false; 9]));
}

#[test]
fn accelerations_come_from_given_velocities() {
    let figure = tumbler();
    let mut record = tumbling(&figure, |_| 1.0);
    for row in 0..241 {
        let (_, _, [omega, _, v, _]) = top(record.time[row]);
        record.v[row * 9..][..9]
            .copy_from_slice(&[v.as_slice(), omega.as_slice(), omega.as_slice()].concat());
    }
    record.known_v.fill(true);
    let motion = complete(&figure, &record, None).expect("slow enough");
    assert_eq!(motion.v, record.v);
    let [velocity, acceleration] = differences(&motion, 30..211);
    assert!(velocity < 1e-12 && acceleration < 1e-6, "{velocity:e} {acceleration:e}");
    assert_eq!(motion.found, [true; 9]);
    // Accelerations that are known stay, and velocities are found.
    record.known_v.fill(false);
    record.known_a.fill(true);
    record.a.fill(7.0);
    let motion = complete(&figure, &record, None).expect("slow enough");
    assert!(motion.a.iter().all(|a| a.to_bits() == 7.0_f64.to_bits()));
    assert!(differences(&motion, 30..211)[0] < 1e-8);
}

/// Two dofs: a slow wave with a tremor of 25 Hz. The filter takes the tremor and leaves the wave; a dof that is known is
/// not touched.
#[test]
fn a_filter_takes_the_tremor_from_what_is_derived() {
    let figure = build([LinkSpec::root("hand", Joint::new("wrist").rx().ry()).mass(1.0)]);
    let tremor = |t: f64| (2.0 * t).sin() + 0.01 * (157.0 * t).sin();
    let mut record = positions(&figure, equally(301, 100.0), |t| vec![tremor(t), tremor(t)]);
    record.known_v[1] = true;
    record.known_a[1] = true;
    let motion = complete(&figure, &record, SIX_HERTZ).expect("long enough");
    for row in 50..251 {
        let t = motion.time[row];
        assert!((motion.q[2 * row] - (2.0 * t).sin()).abs() < 2e-4);
        assert!((motion.v[2 * row] - 2.0 * (2.0 * t).cos()).abs() < 5e-3);
        assert_eq!(motion.q[2 * row + 1].to_bits(), tremor(t).to_bits());
        assert_eq!(motion.v[2 * row + 1].to_bits(), 0);
    }
    assert!((0.1..0.25).contains(&motion.unsettled), "{}", motion.unsettled);
    assert_eq!(motion.found, [true, false]);
}

#[test]
fn filtered_quaternions_have_unit_length_and_turn_a_little_slower() {
    let figure = tumbler();
    let motion = complete(&figure, &tumbling(&figure, |t| if t > 1.0 { -1.0 } else { 1.0 }), SIX_HERTZ)
        .expect("slow enough");
    for row in motion.q.chunks_exact(11) {
        let length: f64 = row[3..7].iter().map(|x| x * x).sum();
        assert!((length - 1.0).abs() < 1e-14);
    }
    // Half the turn's 1.2 Hz against 6 Hz: (0.2)⁴ of the amplitude at most.
    let [velocity, acceleration] = differences(&motion, 60..180);
    assert!(velocity < 0.05 && acceleration < 0.5, "{velocity:e} {acceleration:e}");
}

#[test]
fn followers_are_where_their_leaders_put_them() {
    let slide =
        Joint::new("knee").ty().named("slide").following("angle", Curve::Polynomial(vec![0.1, 0.5, -0.3]));
    let figure = build([LinkSpec::root("shank", slide.rx().named("angle")).mass(1.0)]);
    let record = positions(&figure, equally(60, 60.0), |t| vec![99.0, (3.0 * t).sin()]);
    let motion = complete(&figure, &record, SIX_HERTZ).expect("long enough");
    for row in 0..60 {
        let [q, v, a] =
            [&motion.q, &motion.v, &motion.a].map(|column| [column[2 * row], column[2 * row + 1]]);
        let slope = 0.5 - 0.6 * q[1];
        assert!((q[0] - 0.1 - 0.5 * q[1] + 0.3 * q[1] * q[1]).abs() < 1e-15);
        assert!((v[0] - slope * v[1]).abs() < 1e-14);
        assert!((a[0] - slope * a[1] + 0.6 * v[1] * v[1]).abs() < 1e-13);
    }
}

#[test]
fn what_cannot_be_completed_is_refused() {
    let figure = pendulum();
    let record = |time: Vec<f64>| positions(&figure, time, |t| vec![t]);
    let error = |record: &Record, filter| match complete(&figure, record, filter) {
        Ok(_) => "ACCEPTED".to_owned(),
        Err(error) => error.to_string(),
    };
    assert_eq!(error(&record(vec![0.0]), None), "ACCEPTED");
    assert_eq!(
        error(&record(vec![0.0, 0.1, 0.1]), None),
        "sample 2 is at 0.1 s; times must be finite and rise"
    );
    assert_eq!(
        error(&record(equally(9, 60.0)), SIX_HERTZ),
        "the motion cannot be filtered: 9 samples are too few for a filter of order 2; it needs 10: leave the filter out"
    );
    assert_eq!(
        error(&record(equally(90, 10.0)), SIX_HERTZ),
        "the motion cannot be filtered: cut-off 6 Hz: it must be more than zero and less than half of the 10 samples/s, 5 Hz"
    );
    let unequal: Vec<f64> = (0..50).map(|i| f64::from(i * i)).collect();
    assert!(error(&record(unequal), SIX_HERTZ).contains("resample the record"));
    let mut short = record(equally(20, 60.0));
    short.q.pop();
    assert_eq!(error(&short, None), "q has 19 numbers; 20 samples of 1 make 20");
    // 25 rad/s at 8 samples a second: 179° a sample.
    let figure = build([body(LinkSpec::root("ball", Joint::ball("j")))]);
    let fast = positions(&figure, equally(20, 8.0), |t| {
        UnitQuaternion::new(Vector3::x() * (25.0 * t)).coords.as_slice().to_vec()
    });
    let error = complete(&figure, &fast, None).expect_err("too fast");
    assert!(
        matches!(error.downcast_ref(), Some(DifferentiateError::TurnsTooFar { time, degrees, .. }) if (*time - 0.125).abs() < 1e-9 && (degrees - 179.05).abs() < 0.1),
        "{error}"
    );
}

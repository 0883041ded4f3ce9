//! Walks of five determinants close: put together root by root, feet neither slide nor float, and cycles repeat.

use solaris_gait::determinants::five::{
    Family, FiveAngles, FiveParameters, PARAMETERS, Timing, Upper, close, conditions, parameters_of, phases,
    posture_before, solve,
};
use solaris_gait::determinants::{Cycle, DoubleSupport, Joints, KeyPosture, Proportions, Root};
use solaris_gait::{GaitError, PostureError, RequestError};
use solaris_model::human;

fn person(height: f64) -> Proportions {
    Proportions::of(&human(height, 22.0 * height * height).expect("a person")).expect("legs")
}

/// The joints of the stance and of the swing leg, rooted at a point of one of their feet.
fn placed(p: &Proportions, posture: &KeyPosture, leg: usize, root: Root, at: [f64; 2]) -> [Joints; 2] {
    let hip = posture.legs[leg].hip_over(p, root, at);
    let offset = posture.swing_hip(p);
    let stance = if leg == 0 { hip } else { [hip[0] - offset[0], hip[1] - offset[1]] };
    posture.joints(p, stance)
}

struct Residual(f64);

impl Residual {
    fn same(&mut self, a: f64, b: f64) {
        let difference = (a - b).abs();
        self.0 = if difference.is_nan() { f64::INFINITY } else { self.0.max(difference) };
    }

    fn joints(&mut self, a: &[Joints; 2], b: &[Joints; 2]) {
        for (a, b) in a.iter().zip(b) {
            let pairs =
                [(a.hip, b.hip), (a.knee, b.knee), (a.ankle, b.ankle), (a.heel, b.heel), (a.ball, b.ball)];
            for (a, b) in pairs.into_iter().chain([(a.tip, b.tip)]) {
                self.same(a[0], b[0]);
                self.same(a[1], b[1]);
            }
        }
    }
}

/// The greatest residual (m) of a starting cycle and so many others, each rooted where the one before put the foot.
fn residual(p: &Proportions, angles: &FiveAngles, cycles: usize) -> f64 {
    let q = &angles.parameters;
    let upper = Upper::automatic(angles, 1.2);
    let mut residual = Residual(0.0);
    let s = p.ball_height;
    // The starting cycle's stance foot is at 0; its swing foot, which began there too, is put down one step ahead.
    let start = phases(angles, &upper, Cycle::Starting);
    assert_eq!([start[0].number, start[1].number], [3, 4]);
    let mut before = placed(p, &start[1].end, 0, start[1].root.point, [p.ball_ahead, s]);
    // The rear foot's heel print.
    let mut print = -p.heel_behind;
    for _ in 0..cycles {
        let ball = [print + p.heel_behind + p.ball_ahead, s];
        let all = phases(angles, &upper, Cycle::Intermediate);
        // The legs have exchanged their parts: same pelvis, same joints.
        let began = placed(p, &posture_before(angles, &upper, Cycle::Intermediate), 1, Root::Ball, ball);
        residual.joints(&began, &[before[1], before[0]]);
        residual.same(began[0].heel[1], q.landing_height);
        residual.same(began[0].ball[1] - s, q.landing_height);
        residual.same(began[1].tip[1], 0.0);

        let strike = placed(p, &all[0].end, 1, all[0].root.point, ball);
        residual.same(strike[0].heel[0], print + q.step_length);
        residual.same(strike[0].heel[1], 0.0);
        residual.same(strike[1].tip[0], ball[0] + p.toe);
        residual.same(strike[1].tip[1], 0.0);

        let heel = [print + q.step_length, 0.0];
        residual.joints(&placed(p, &all[0].end, 0, all[1].root.point, heel), &strike);
        let lift_off = placed(p, &all[1].end, 0, all[1].root.point, heel);
        residual.same(lift_off[1].tip[0], ball[0] + p.toe);
        residual.same(lift_off[1].tip[1], 0.0);
        residual.same(lift_off[0].ball[1], s);
        residual.same(lift_off[0].tip[1], 0.0);

        let sole = [heel[0] + p.heel_behind, 0.0];
        residual.joints(&placed(p, &all[1].end, 0, all[2].root.point, sole), &lift_off);
        let passing = placed(p, &all[2].end, 0, all[2].root.point, sole);
        residual.same(passing[0].hip[0], passing[0].ankle[0]);
        let foot = &passing[1];
        let lowest = foot.heel[1].min(foot.tip[1]).min(foot.ball[1] - s);
        residual.same(lowest, q.clearance);

        let ahead = [sole[0] + p.ball_ahead, s];
        residual.joints(&placed(p, &all[2].end, 0, all[3].root.point, ahead), &passing);
        before = placed(p, &all[3].end, 0, all[3].root.point, ahead);
        residual.same(before[1].heel[1], q.landing_height);
        residual.same(before[0].tip[0], ahead[0] + p.toe);
        print += q.step_length;
    }
    // The finishing cycle ends upright over the foot that came down last.
    let end = phases(angles, &upper, Cycle::Finishing);
    assert_eq!(end.iter().map(|phase| phase.number).collect::<Vec<_>>(), [1, 2, 3]);
    let rest = placed(p, &end[2].end, 0, end[2].root.point, [print, 0.0]);
    residual.same(rest[0].hip[1], p.leg() + p.ankle_height);
    residual.same(rest[1].heel[0], rest[0].heel[0]);
    residual.0
}

#[test]
fn presets_close_over_many_cycles() {
    for family in Family::ALL {
        for frequency in [80.0, 95.0, 110.0, 120.0, 130.0] {
            for height in [1.75, 1.0] {
                let p = Proportions::drillis_contini(height);
                let q = FiveParameters::preset(family, height, frequency).expect("a preset");
                let angles = solve(&p, &q).expect("closes");
                assert!(residual(&p, &angles, 3) < 2e-15, "{family:?} {frequency}");
                // A position 100 steps away has fewer decimals.
                assert!(residual(&p, &angles, 100) < 1e-12, "{family:?} {frequency}");
            }
        }
    }
}

#[test]
fn families_close_between_their_sets_too() {
    let p = Proportions::drillis_contini(1.75);
    for family in Family::ALL {
        for tenth in 800..=1300 {
            let frequency = f64::from(tenth) / 10.0;
            let q = FiveParameters::preset(family, 1.75, frequency).expect("a preset");
            assert!(close(&p, &q).is_ok(), "{family:?} {frequency}");
        }
    }
    for frequency in [79.9, 130.1, f64::NAN] {
        assert!(FiveParameters::preset(Family::Stiff, 1.75, frequency).is_err());
    }
}

#[test]
fn real_feet_close_over_many_cycles() {
    for height in [1.2, 1.75, 2.0] {
        let p = person(height);
        for part in [0.2, 0.3, 0.4, 0.5, 0.58] {
            let q = FiveParameters::automatic(&p, 110.0, part * height).expect("automatic");
            let angles = solve(&p, &q).expect("closes");
            assert!(residual(&p, &angles, 3) < 3e-15, "{height} {part}");
            assert!(residual(&p, &angles, 100) < 1e-12, "{height} {part}");
        }
    }
}

/// Numbers from 0 to 1 that are the same on every machine.
struct Lcg(u64);

impl Lcg {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, (lower, upper): (f64, f64)) -> f64 {
        lower + (upper - lower) * self.next()
    }
}

/// Parameters that walk now and then, and any at all.
const WALKING: [(f64, f64); 8] =
    [(0.3, 1.0), (5.0, 25.0), (0.0, 6.0), (-15.0, 35.0), (5.0, 40.0), (0.0, 10.0), (0.0, 0.04), (0.0, 0.04)];

#[test]
fn random_parameters_close_or_are_refused_with_values_that_do() {
    let mut random = Lcg(5);
    let (mut closed, mut refused, mut mended) = (0, 0, 0);
    for i in 0..60_000 {
        let height = random.between((1.2, 2.0));
        let p =
            if i % 2 == 0 { Proportions::drillis_contini(height) } else { person_like(&mut random, height) };
        let ranges = parameters_of(&p);
        let values: [f64; 8] =
            std::array::from_fn(|k| random.between(if i % 3 == 0 { ranges[k].range } else { WALKING[k] }));
        let q = FiveParameters::from_values(values);
        match close(&p, &q) {
            Ok(angles) => {
                closed += 1;
                obeys(&p, &angles);
            }
            Err(fails) => {
                refused += 1;
                assert!(!fails.is_empty() && fails.iter().all(|condition| !condition.holds()));
                if refused % 100 == 0 {
                    let Err(GaitError::Posture(PostureError::Infeasible { why, .. })) = solve(&p, &q) else {
                        panic!("{values:?}")
                    };
                    assert_eq!(why.fails, fails);
                    for (k, nearest) in why.nearest.iter().enumerate() {
                        let Some(value) = nearest.feasible else { continue };
                        mended += 1;
                        let mut values = values;
                        values[k] = value;
                        let mended = solve(&p, &FiveParameters::from_values(values));
                        assert!(mended.is_ok(), "{} {value}: {mended:?}", nearest.parameter.name);
                    }
                }
            }
        }
    }
    assert!(closed > 500 && refused > 20_000 && mended > 100, "{closed} {refused} {mended}");
}

/// A person's proportions, each off by up to a tenth; the soles of heel, ball and tip stay in one plane.
fn person_like(random: &mut Lcg, height: f64) -> Proportions {
    let p = Proportions {
        thigh: 0.2424,
        shank: 0.2493,
        ankle_height: 0.0448,
        heel_behind: 0.0287,
        ball_ahead: 0.0804,
        ball_below: 0.0345,
        ball_height: 0.0103,
        toe: 0.0402,
        hips: 0.0976,
        height: 1.0,
        unit: 1.0,
    };
    let mut off = |length: f64| length * random.between((0.9, 1.1)) * height;
    let (ankle_height, ball_below) = (off(p.ankle_height), off(p.ball_below).min(0.04 * height));
    Proportions {
        thigh: off(p.thigh),
        shank: off(p.shank),
        ankle_height,
        heel_behind: off(p.heel_behind),
        ball_ahead: off(p.ball_ahead),
        ball_below,
        ball_height: ankle_height - ball_below,
        toe: off(p.toe),
        hips: off(p.hips),
        height,
        unit: 1.0,
    }
}

fn obeys(p: &Proportions, angles: &FiveAngles) {
    let q = &angles.parameters;
    assert!(angles.alpha > angles.chi && angles.chi >= 0.0);
    assert!(angles.beta > q.heel_strike_angle);
    assert!(angles.xi > angles.alpha && angles.omega > q.thigh_lift_off);
    assert!(conditions(p, q).iter().all(solaris_gait::determinants::Condition::holds));
    let off = residual(p, angles, 2);
    // Near the ends of their domains, arc cosines lose half of the digits.
    assert!(off < 1e-9, "{off}: {q:?}");
    for timing in [Timing::Quarters, Timing::Travel, Timing::DoubleSupport(DoubleSupport::Thesis)] {
        let parts = timing.parts(p, angles, 110.0);
        assert!(parts.iter().all(|part| *part > 0.0) && (parts.iter().sum::<f64>() - 1.0).abs() < 1e-12);
    }
}

#[test]
fn what_is_no_number_is_refused_by_name() {
    let p = Proportions::drillis_contini(1.75);
    let good = FiveParameters::preset(Family::default(), 1.75, 110.0).expect("a preset").values();
    for (i, parameter) in PARAMETERS.iter().enumerate() {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -90.0, 1000.0] {
            let mut values = good;
            values[i] = bad;
            let q = FiveParameters::from_values(values);
            let error = solve(&p, &q).expect_err("refused");
            let named = matches!(&error, GaitError::Request(RequestError::Range { parameter: name, .. }) if *name == parameter.name);
            assert!(named, "{error}");
            // Without the ranges too, nothing panics; what is no number fails.
            assert!(bad.is_finite() || close(&p, &q).is_err());
        }
    }
    for bad in [f64::NAN, f64::INFINITY, -1.0, 0.0] {
        let bodies = [
            Proportions { thigh: bad, ..p },
            Proportions { shank: bad, ..p },
            Proportions { ball_ahead: bad, ..p },
            Proportions { height: bad, ..p },
        ];
        for body in bodies {
            let error = solve(&body, &FiveParameters::from_values(good)).expect_err("refused");
            assert!(matches!(error, GaitError::Request(RequestError::Range { .. })), "{error}");
            assert!(FiveParameters::automatic(&body, 110.0, 0.77).is_err());
        }
    }
    let heel = Proportions { heel_behind: -0.1, ..p };
    assert!(matches!(
        solve(&heel, &FiveParameters::from_values(good)),
        Err(GaitError::Request(RequestError::Range { parameter: "ankle to heel", .. }))
    ));
}

//! What is feasible obeys all conditions, what is not says what is nearest: over many pseudo-random parameters.

use solaris_gait::determinants::three::{self, ThreeParameters, chi_range, lift_off_ranges, tilt_range};
use solaris_gait::determinants::{Condition, Infeasible, Proportions};
use solaris_model::human;

/// Knuth's linear congruential generator: the same numbers everywhere.
struct Random(u64);

impl Random {
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }
}

fn bodies() -> [Proportions; 4] {
    let person = human(1.75, 73.0).expect("a person");
    [
        Proportions::FIT,
        Proportions::drillis_contini(1.75),
        Proportions::of(&person).expect("proportions"),
        // A shank longer than the thigh.
        Proportions { thigh: 0.42, shank: 0.5, ..Proportions::drillis_contini(1.75) },
    ]
}

fn holds(parameters: &ThreeParameters, p: &Proportions) -> bool {
    parameters.conditions(p).iter().all(Condition::holds)
}

/// Replaces one value by the nearest feasible one and asks again.
fn nearest_is_feasible(refusal: &Infeasible, parameters: &ThreeParameters, p: &Proportions) -> usize {
    assert!(!refusal.fails.is_empty());
    assert!(refusal.fails.iter().all(|condition| !condition.holds()));
    let mut found = 0;
    for (i, nearest) in refusal.nearest.iter().enumerate() {
        if let Some(value) = nearest.feasible {
            let mut values = parameters.values();
            values[i] = value;
            assert!(holds(&ThreeParameters::from_values(values), p), "{refusal}");
            found += 1;
        }
    }
    found
}

#[test]
fn random_parameters_are_feasible_or_refused_with_what_is_nearest() {
    let mut random = Random(7);
    let (mut feasible, mut refused, mut helped) = (0, 0, 0);
    for p in bodies() {
        for i in 0..6000 {
            let anywhere = ThreeParameters {
                step_length: random.between(-0.05, 2.1) * p.leg(),
                tilt: random.between(-0.02, 0.3),
                flexion: random.between(-0.02, 1.2),
                start_lift_off: random.between(-0.1, 1.7),
                lift_off: random.between(-0.1, 1.7),
            };
            // Every other one is within 5 % of what is feasible.
            let chosen = ThreeParameters::automatic(&p, anywhere.step_length).ok().filter(|_| i % 2 == 0);
            let parameters = chosen.map_or(anywhere, |chosen| {
                let near = chosen.values().map(|value| value * random.between(0.95, 1.05));
                ThreeParameters::from_values(near)
            });
            if holds(&parameters, &p) {
                feasible += 1;
                let angles = parameters.solve(&p).expect("its conditions hold");
                let rising = [0.0, angles.theta1, angles.alpha, angles.omega, angles.phi];
                assert!(rising.is_sorted() && angles.chi < angles.alpha, "{angles:?}");
                assert!(angles.xi.is_finite() && angles.beta > 0.0 && angles.theta3 < 1.571);
                let range = chi_range(&p, parameters.step_length, parameters.tilt).expect("a range");
                assert!((range[0]..range[1]).contains(&parameters.flexion), "{parameters:?}");
            } else if i % 15 == 0 {
                // Nearest values take some thousand trials each.
                refused += 1;
                let refusal = parameters.solve(&p).expect_err("a condition fails");
                helped += usize::from(nearest_is_feasible(&refusal, &parameters, &p) > 0);
            }
        }
    }
    assert!(feasible > 3000 && refused > 1000 && helped > 200, "{feasible} {refused} {helped}");
}

#[test]
fn whatever_lies_inside_the_ranges_is_feasible() {
    let mut random = Random(11);
    let mut tried = 0;
    for p in bodies() {
        for _ in 0..20_000 {
            let step_length = random.between(0.01, 1.99) * p.leg();
            let Some([least, most]) = tilt_range(&p, step_length) else { continue };
            let inside = |random: &mut Random, [low, high]: [f64; 2]| {
                low + (high - low) * random.between(0.001, 0.999)
            };
            let tilt = inside(&mut random, [least, most]);
            let chi = chi_range(&p, step_length, tilt).expect("a flexion at any tilt of the range");
            let flexion = inside(&mut random, chi);
            let ranges = lift_off_ranges(&p, step_length, tilt, flexion).expect("ranges inside");
            let [start_lift_off, lift_off] =
                [ranges.theta3, ranges.phi].map(|range| inside(&mut random, range));
            let parameters = ThreeParameters { step_length, tilt, flexion, start_lift_off, lift_off };
            let angles = parameters.solve(&p).unwrap_or_else(|why| panic!("{parameters:?}: {why}"));
            assert!((ranges.theta1[0]..ranges.theta1[1]).contains(&angles.theta1));
            assert!((ranges.omega[0]..ranges.omega[1]).contains(&angles.omega));
            tried += 1;
            // Just outside: the flexion is infeasible whatever the rest.
            assert!(lift_off_ranges(&p, step_length, tilt, chi[1] + 1e-6).is_none());
            assert!(chi[0] <= 0.0 || lift_off_ranges(&p, step_length, tilt, chi[0] - 1e-6).is_none());
        }
    }
    assert!(tried > 60_000, "{tried}");
}

#[test]
fn an_automatic_choice_is_there_wherever_anything_is() {
    let mut random = Random(13);
    let mut refused = 0;
    for p in bodies() {
        for i in 0..=2000 {
            let step_length = p.leg() * 2.1 * f64::from(i) / 2000.0;
            match ThreeParameters::automatic(&p, step_length) {
                Ok(chosen) => {
                    assert!((chosen.step_length - step_length).abs() <= 0.0);
                    assert!(chosen.solve(&p).is_ok(), "{chosen:?}");
                }
                Err(refusal) => {
                    refused += 1;
                    assert!(!refusal.fails.is_empty(), "{step_length}");
                    if let Some(value) = refusal.nearest[0].feasible {
                        assert!(ThreeParameters::automatic(&p, value).is_ok());
                    }
                    // No tilt helps.
                    for _ in 0..50 {
                        assert_eq!(chi_range(&p, step_length, random.between(0.0, 1.57)), None);
                    }
                }
            }
        }
    }
    assert!(refused > 100);
}

#[test]
fn the_automatic_choice_does_not_jump() {
    for p in bodies() {
        let steps = (20..1800).map(|i| ThreeParameters::automatic(&p, p.leg() * f64::from(i) / 1000.0));
        let values: Vec<[f64; 5]> = steps.map_while(Result::ok).map(|chosen| chosen.values()).collect();
        assert!(values.len() > 1500, "{}", values.len());
        for pair in values.windows(2) {
            for (a, b) in pair[0].iter().zip(&pair[1]) {
                assert!((a - b).abs() < 1.5, "{pair:?}");
            }
        }
    }
}

#[test]
fn short_and_long_and_odd_numbers_are_refused() {
    let p = Proportions::FIT;
    let good = ThreeParameters::automatic(&p, 0.9).expect("feasible").values();
    for i in 0..5 {
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, 1e300] {
            let mut values = good;
            values[i] = bad;
            let refusal = ThreeParameters::from_values(values).solve(&p).expect_err("odd");
            assert!(!refusal.fails.is_empty());
            assert!(!refusal.to_string().is_empty());
        }
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, 0.0, 2.0, 1e300] {
        let refusal = ThreeParameters::automatic(&p, bad).expect_err("odd");
        assert!(!refusal.fails.is_empty(), "{bad}");
        assert_eq!(chi_range(&p, bad, 0.1), None);
        assert_eq!(tilt_range(&p, bad), None);
    }
    for bad in [f64::NAN, f64::INFINITY, -1.0] {
        assert_eq!(chi_range(&p, 0.9, bad), None);
        assert_eq!(lift_off_ranges(&p, 0.9, 0.1, bad), None);
    }
    for bad in [f64::NAN, f64::INFINITY, -1.0] {
        for p in [
            Proportions { thigh: bad, ..p },
            Proportions { shank: bad, ..p },
            Proportions { ball_ahead: bad, ..p },
            Proportions { hips: bad, ..p },
            Proportions { ankle_height: bad, ..p },
        ] {
            assert!(ThreeParameters::from_values(good).solve(&p).is_err(), "{p:?}");
            let refusal = ThreeParameters::automatic(&p, 0.9).expect_err("odd lengths");
            assert!(!refusal.fails.is_empty(), "{p:?}");
        }
    }
}

#[test]
fn a_refusal_names_the_constraint_and_the_way_out() {
    let p = Proportions::drillis_contini(1.75);
    let parameters = ThreeParameters {
        flexion: 30.0_f64.to_radians(),
        ..ThreeParameters::automatic(&p, 0.735).expect("feasible")
    };
    insta::assert_snapshot!(parameters.solve(&p).expect_err("χ > α"));
    insta::assert_snapshot!(ThreeParameters::automatic(&p, 1.9).expect_err("longer than the legs"));
    // What is chosen for a common step.
    let values = ThreeParameters::automatic(&p, 0.735).expect("feasible").values();
    let named = three::PARAMETERS.iter().zip(values);
    let lines: Vec<String> = named.map(|(it, value)| format!("{} {value:.3}{}", it.name, it.unit)).collect();
    insta::assert_snapshot!(lines.join("\n"));
}

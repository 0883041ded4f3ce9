//! What five determinants choose by themselves: parameters, arms, trunk, sway; and their tables.

#![allow(clippy::float_cmp, reason = "what is copied or exchanged stays the same")]

use solaris_gait::determinants::five::{
    AUTOMATIC_STEP, ArmCoefficients, Family, FiveParameters, PelvicSway, Timing, TrunkAmplitudes, Upper,
    arm_remarks, close, conditions, phases, posture_before, remarks, solve, sway_amplitude, table,
    thesis_speed,
};
use solaris_gait::determinants::{Condition, Cycle, DoubleSupport, Proportions};
use solaris_gait::{GaitError, PostureError, RequestError};
use solaris_model::human;

fn people() -> Vec<Proportions> {
    let heights = (0..=16).map(|k| 1.2 + 0.05 * f64::from(k));
    heights
        .flat_map(|height| {
            let figure = human(height, 22.0 * height * height).expect("a person");
            [Proportions::of(&figure).expect("legs"), Proportions::drillis_contini(height)]
        })
        .collect()
}

/// The least room of a name's conditions (°).
fn room(list: &[Condition], name: &str) -> f64 {
    list.iter().filter(|c| c.name == name).map(Condition::room).fold(f64::INFINITY, f64::min)
}

#[test]
fn people_of_all_sizes_walk_by_themselves_at_all_usual_steps() {
    let mut least = [f64::INFINITY; 5];
    let mut knees = (f64::INFINITY, 0.0_f64);
    for p in people() {
        for frequency in (60..=130).step_by(5).map(f64::from) {
            for ratio in [0.0037, 0.004] {
                for percent in [88.0, 94.0, 100.0, 106.0, 112.0] {
                    let step = percent / 100.0 * ratio * p.height * frequency;
                    let q = FiveParameters::automatic(&p, frequency, step).expect("automatic");
                    let angles = solve(&p, &q).expect("closes");
                    let all = conditions(&p, &q);
                    for (least, name) in least.iter_mut().zip(["(i)", "(ii′)", "(iii)", "(v)", "lift-off"])
                    {
                        *least = least.min(room(&all, name));
                    }
                    let knee = (angles.omega - q.thigh_lift_off).to_degrees();
                    knees = (knees.0.min(knee), knees.1.max(knee));
                    assert!((angles.psi.to_degrees() - 6.3).abs() < 1e-6);
                    assert!(q.landing_height > 0.003 * p.height && angles.epsilon > 0.0);
                }
            }
        }
    }
    // In degrees: (i), (ii′), (iii), (v), and ω and ξ inside of 0° to 90°.
    for (least, wanted) in least.iter().zip([0.36, 3.7, 0.63, 44.0, 1.8]) {
        assert!(*least > wanted, "{least} {wanted}");
    }
    assert!(knees.0 > 44.0 && knees.1 < 62.0, "{knees:?}");
}

#[test]
fn all_step_lengths_that_are_said_to_close_do() {
    for p in [&people()[22], &people()[23]] {
        for k in 0..=420 {
            let step = (AUTOMATIC_STEP.0 + 0.001 * f64::from(k)) * p.height;
            let q = FiveParameters::automatic(p, 100.0, step).expect("automatic");
            let angles = close(p, &q).expect("closes");
            // Shorter steps leave the thigh that lifts off in front, where no arms go with it.
            let arms = ArmCoefficients::automatic(&angles);
            assert_eq!(arms.is_some(), q.thigh_lift_off > 0.0, "{step}");
            assert!(step < 0.304 * p.height || arms.is_some(), "{step}");
        }
    }
}

/// A person's proportions, each a tenth longer or shorter: all 256 combinations of eight lengths.
#[test]
fn unusual_people_walk_by_themselves_too() {
    let person = people()[22];
    for bits in 0_u32..256 {
        let off = |k: u32| if bits >> k & 1 == 0 { 0.9 } else { 1.1 };
        let p = Proportions {
            thigh: off(0) * person.thigh,
            shank: off(1) * person.shank,
            ankle_height: off(2) * person.ankle_height,
            ball_below: off(2) * person.ball_below,
            ball_height: off(2) * person.ball_height,
            heel_behind: off(3) * person.heel_behind,
            ball_ahead: off(4) * person.ball_ahead,
            toe: off(5) * person.toe,
            hips: off(6) * person.hips,
            height: off(7) * person.height,
            unit: person.unit,
        };
        // By the leg's length, for a height that does not go with it.
        for part in [0.44, 0.6, 0.8, 1.0] {
            let step = part * (p.leg() + p.ankle_height);
            if (AUTOMATIC_STEP.0 * p.height..=AUTOMATIC_STEP.1 * p.height).contains(&step) {
                let q = FiveParameters::automatic(&p, 110.0, step);
                assert!(q.is_ok(), "{part} {bits:b} {q:?}");
            }
        }
    }
}

#[test]
fn the_automatic_choice_is_near_the_recommended_family() {
    let p = Proportions::drillis_contini(1.75);
    for frequency in [80.0, 95.0, 110.0, 120.0, 130.0] {
        let found = FiveParameters::automatic(&p, frequency, 0.007 * frequency).expect("automatic").values();
        let preset = FiveParameters::preset(Family::Retracting, 1.75, frequency).expect("a preset").values();
        for i in 1..6 {
            // Degrees.
            assert!((found[i] - preset[i]).abs() < 2.1, "{frequency}: {found:?} {preset:?}");
        }
    }
}

#[test]
fn what_the_automatic_choice_refuses() {
    let p = Proportions::drillis_contini(1.75);
    let one = |p: &Proportions, frequency: f64, step: f64| {
        FiveParameters::automatic(p, frequency, step).expect_err("refused").to_string()
    };
    let texts = [
        one(&p, 110.0, 0.2),
        one(&p, 110.0, 1.2),
        one(&p, 110.0, f64::NAN),
        one(&p, 0.0, 0.7),
        one(&p, f64::INFINITY, 0.7),
        one(&Proportions { height: f64::NAN, ..p }, 110.0, 0.7),
        one(&Proportions { hips: -0.2, ..p }, 110.0, 0.7),
        // Short legs under a tall figure: the same step is long for them.
        one(&Proportions { thigh: 0.25, shank: 0.25, ..p }, 110.0, 1.0),
        one(&Proportions { hips: 0.9, ..p }, 110.0, 0.4),
    ];
    insta::assert_snapshot!(texts.join("\n"));
}

#[test]
fn arms_keep_their_conditions_or_have_none() {
    let p = Proportions::drillis_contini(1.75);
    for family in Family::ALL {
        for frequency in (80..=130).map(f64::from) {
            let q = FiveParameters::preset(family, 1.75, frequency).expect("a preset");
            let Ok(angles) = close(&p, &q) else { continue };
            let solvable =
                q.thigh_lift_off > 0.0 && angles.alpha * angles.chi < angles.beta * q.heel_strike_angle;
            let arms = ArmCoefficients::automatic(&angles);
            assert_eq!(arms.is_some(), solvable, "{family:?} {frequency}");
            if let Some(arms) = arms {
                assert!(arms.k.iter().all(|k| (0.0..=1.0).contains(k)));
                assert!(arm_remarks(&angles, &arms).iter().all(Condition::holds));
            }
            let nearest = ArmCoefficients::nearest(&angles);
            assert!(nearest.k.iter().all(|k| (0.0..=1.0).contains(k)));
            assert!(nearest.k[1] < nearest.k[0]);
            let holds = remarks(&angles).iter().map(Condition::holds).collect::<Vec<_>>();
            match family {
                Family::Retracting => assert_eq!(holds, [false, false]),
                Family::Advancing => assert!(!holds[0]),
                // (vi) fails by a little between the sets.
                Family::Stiff => {
                    assert!(
                        holds[0] && (holds[1] || ![80.0, 95.0, 110.0, 120.0, 130.0].contains(&frequency))
                    );
                }
            }
        }
    }
}

#[test]
fn the_upper_body_repeats_with_the_legs_exchanged() {
    let p = Proportions::drillis_contini(1.75);
    let q = FiveParameters::automatic(&p, 110.0, 0.77).expect("automatic");
    let angles = solve(&p, &q).expect("closes");
    let upper = Upper::automatic(&angles, thesis_speed(1.75, 110.0));
    let first = posture_before(&angles, &upper, Cycle::Intermediate);
    let all = phases(&angles, &upper, Cycle::Intermediate);
    let targets = upper.arms.targets(&angles);
    let shoulders: Vec<_> = all.iter().map(|phase| phase.end.arms.map(|arm| arm.shoulder)).collect();
    // α₁ is targets[0].
    assert_eq!(shoulders[0], [-targets[0], targets[1]]);
    assert_eq!(shoulders[3], [targets[9], -targets[11]]);
    assert_eq!(first.arms, [all[3].end.arms[1], all[3].end.arms[0]]);
    // Table 8.7's parts of ν and γ, differences and all.
    let (nu, gamma) = (upper.trunk.pelvis_bend, upper.trunk.torso_bend);
    let mut before = first;
    let parts = [(0.4, 1.2), (1.2, 0.4), (0.0, 0.4), (-0.4, 0.0)];
    for (phase, (n, g)) in all.iter().zip(parts) {
        let (was, is) = (before.trunk, phase.end.trunk);
        assert!((is.pelvis_bend - was.pelvis_bend - n * nu).abs() < 1e-15);
        assert!((is.torso_bend - was.torso_bend - g * gamma).abs() < 1e-15);
        before = phase.end;
    }
    let leans: Vec<_> = all.iter().map(|phase| phase.end.trunk.lean).collect();
    assert_eq!(leans, [3.0, 0.0, -3.0, 0.0].map(f64::to_radians));
}

#[test]
fn the_trunk_moves_by_the_thesiss_fits_and_never_less_than_nothing() {
    // V = 141.2 cm/s at 110 steps/min: −0.00012·V² + 0.068·V − 2.8 = 4.408 cm, −0.00005·V² + 0.035·V − 1.0 = 2.944°.
    let trunk = TrunkAmplitudes::at_speed(thesis_speed(1.75, 110.0));
    assert!((trunk.rise - 0.044_079_7).abs() < 1e-9, "{}", trunk.rise);
    assert!((trunk.pelvis_bend.to_degrees() - 2.944_432).abs() < 1e-4, "{}", trunk.pelvis_bend.to_degrees());
    for speed in [0.0, 0.2, 10.0] {
        let trunk = TrunkAmplitudes::at_speed(speed);
        assert!(trunk.rise == 0.0 && trunk.pelvis_bend == 0.0);
    }
}

#[test]
fn a_rise_decides_kappa_for_real_feet_too_or_is_refused() {
    let mut found = 0;
    for p in people() {
        for part in [0.38, 0.44, 0.48] {
            let step = part * p.height;
            let q = FiveParameters::automatic(&p, 110.0, step).expect("automatic");
            let trunk = TrunkAmplitudes::at_speed(step * 110.0 / 60.0);
            match q.with_trunk_rise(&p, &trunk) {
                Ok(risen) => {
                    let angles = solve(&p, &risen).expect("closes");
                    // κ is not looked at.
                    let other = FiveParameters { thigh_swing: f64::NAN, ..q };
                    assert_eq!(other.with_trunk_rise(&p, &trunk), Ok(risen));
                    // A greater rise straightens the standing leg.
                    let more = TrunkAmplitudes { rise: trunk.rise + 1e-4 * p.height, ..trunk };
                    if let Ok(more) = q.with_trunk_rise(&p, &more) {
                        assert!(solve(&p, &more).expect("closes").psi < angles.psi);
                    }
                    found += 1;
                }
                Err(GaitError::Posture(PostureError::Infeasible { why, .. })) => {
                    assert!(!why.fails.is_empty() && why.nearest.len() == 7);
                }
                Err(other) => panic!("{other}"),
            }
        }
        let q = FiveParameters::automatic(&p, 110.0, 0.44 * p.height).expect("automatic");
        let trunk = TrunkAmplitudes { rise: f64::NAN, ..TrunkAmplitudes::at_speed(1.0) };
        assert!(matches!(
            q.with_trunk_rise(&p, &trunk),
            Err(GaitError::Request(RequestError::Range { parameter: "trunk rise", .. }))
        ));
    }
    assert!(found > 50, "{found}");
}

/// Total sway in mm over the step frequency, for three widths and gains: an independent program's table.
#[test]
fn the_pelvis_sways_less_at_quicker_steps() {
    let table = [
        (0.12, 1.0, [54.0, 43.0, 35.0, 30.0, 27.0]),
        (0.12, 1.3, [70.0, 56.0, 45.0, 40.0, 35.0]),
        (0.15, 1.0, [68.0, 54.0, 44.0, 38.0, 34.0]),
    ];
    for (width, gain, wanted) in table {
        for (frequency, wanted) in [80.0, 95.0, 110.0, 120.0, 130.0].into_iter().zip(wanted) {
            let amplitude = sway_amplitude(60.0 / frequency, width, gain, 0.95, 9.81).expect("numbers");
            assert!((2000.0 * amplitude - wanted).abs() < 0.51, "{width} {gain} {frequency}: {amplitude}");
        }
    }
    let sway = PelvicSway { amplitude: 0.02, step_time: 0.5, middle: 0.2 };
    assert_eq!(sway.at(0.2), 0.0);
    assert!((sway.at(0.45) - 0.02).abs() < 1e-15);
    // The next step begins where this one ends, to the other side.
    assert!((sway.at(0.5) + sway.at(0.0)).abs() < 1e-15);
    assert!(sway_amplitude(f64::NAN, 0.12, 1.3, 0.95, 9.81).is_err());
    assert!(sway_amplitude(0.5, 0.12, 1.3, -0.95, 9.81).is_err());
}

#[test]
fn a_step_is_shared_by_its_phases() {
    let p = Proportions::drillis_contini(1.75);
    let q = FiveParameters::preset(Family::Retracting, 1.75, 110.0).expect("a preset");
    let angles = solve(&p, &q).expect("closes");
    assert_eq!(Timing::Quarters.parts(&p, &angles, 110.0), [0.25; 4]);
    let law = DoubleSupport::Thesis;
    let parts = Timing::DoubleSupport(law).parts(&p, &angles, 110.0);
    assert_eq!(parts[1], law.part_of_step(110.0));
    let travel = Timing::default().parts(&p, &angles, 110.0);
    // What remains keeps its proportions.
    assert!((parts[0] / parts[3] - travel[0] / travel[3]).abs() < 1e-14);
    assert!((parts.iter().sum::<f64>() - 1.0).abs() < 1e-15);
    assert_eq!(travel.map(|part| (100.0 * part).round()), [27.0, 10.0, 25.0, 38.0]);
}

#[test]
fn the_thesiss_tables_stand_beside_what_is_right() {
    let texts =
        ["8.1", "8.2", "8.3", "8.4", "8.5", "8.6", "8.7"].map(|number| table(number).expect(number).text());
    insta::assert_snapshot!(texts.join("\n"));
    assert!(table("8.8").is_none() && table("7.7").is_none());
}

//! The postures of three determinants close: on the ground, from cycle to cycle, with the rotations of the tables.

use solaris_gait::determinants::three::{self, ArmCoefficients, ThreeAngles, ThreeParameters, table};
use solaris_gait::determinants::{Cycle, KeyPosture, Proportions, Root};
use solaris_model::human;

const CYCLES: [Cycle; 3] = [Cycle::Starting, Cycle::Intermediate, Cycle::Finishing];

fn bodies() -> [(&'static str, Proportions); 3] {
    let person = human(1.75, 73.0).expect("a person");
    [
        ("fit", Proportions::FIT),
        ("thesis's foot", Proportions::drillis_contini(1.75)),
        ("real feet", Proportions::of(&person).expect("proportions")),
    ]
}

/// Steps of 10 to 95 % of the longest that is feasible at all.
fn cases() -> Vec<(String, Proportions, ThreeParameters, ThreeAngles)> {
    let mut cases = Vec::new();
    for (name, p) in bodies() {
        for part in [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.85] {
            let parameters = ThreeParameters::automatic(&p, part * 2.0 * p.leg()).expect("feasible");
            let angles = parameters.solve(&p).expect("feasible");
            cases.push((format!("{name}, {part}"), p, parameters, angles));
        }
    }
    cases
}

/// What is the same but for rounding, in rad and in lengths of a leg of about 1: some thousand roundings of 2e-16.
const ROUNDING: f64 = 1e-12;

#[track_caller]
fn near(a: f64, b: f64, what: &str) {
    assert!((a - b).abs() < ROUNDING, "{what}: {a} and {b}");
}

fn same_posture(a: &KeyPosture, b: &KeyPosture, what: &str) {
    for (a, b) in a.legs.iter().zip(&b.legs) {
        for (a, b) in [(a.thigh, b.thigh), (a.shank, b.shank), (a.foot, b.foot), (a.toes, b.toes)] {
            near(a, b, what);
        }
    }
    for (a, b) in a.arms.iter().zip(&b.arms) {
        near(a.shoulder, b.shoulder, what);
        near(a.elbow, b.elbow, what);
    }
    near(a.pelvis.tilt, b.pelvis.tilt, what);
    near(a.pelvis.rotation, b.pelvis.rotation, what);
}

#[test]
fn each_cycle_ends_as_the_next_starts_with_the_legs_exchanged() {
    let arms = ArmCoefficients::default();
    for (what, _, _, angles) in cases() {
        for (cycle, next) in [
            (Cycle::Starting, Cycle::Intermediate),
            (Cycle::Intermediate, Cycle::Intermediate),
            (Cycle::Intermediate, Cycle::Finishing),
        ] {
            let end = three::phases(&angles, &arms, cycle)[1].end;
            same_posture(&end.exchanged(), &three::start(&angles, &arms, next), &what);
        }
        let end = three::phases(&angles, &arms, Cycle::Finishing)[1].end;
        same_posture(&end, &three::start(&angles, &arms, Cycle::Starting), &what);
    }
}

#[test]
fn feet_are_on_the_ground_and_a_step_apart() {
    for (what, p, parameters, angles) in cases() {
        for cycle in CYCLES {
            let phases = three::phases(&angles, &ArmCoefficients::default(), cycle);
            assert_eq!(phases.len(), 2);
            for phase in &phases {
                assert_eq!((phase.root.swing, phase.root.point), (false, Root::Sole));
                let end = phase.end;
                let hip = end.legs[0].hip_over(&p, Root::Sole, [0.0, 0.0]);
                let [stance, swing] = end.joints(&p, hip);
                near(stance.ankle[1], p.ankle_height, &what);
                near(stance.heel[1], 0.0, &what);
                near(end.legs[0].foot, 0.0, &what);
                if phase.number == 1 {
                    // The hip is above the ankle; the ball and the toes of the other foot lie on the ground, its heel is up.
                    near(hip[0], 0.0, &what);
                    near(swing.ball[1], p.ball_height, &what);
                    near(swing.tip[1], 0.0, &what);
                    near(swing.tip[0] - swing.ball[0], p.toe, &what);
                    near(end.legs[1].foot, end.legs[1].shank, &what);
                    near(end.pelvis.tilt, parameters.tilt, &what);
                    assert!(swing.heel[1] > 0.0 && end.legs[1].knee() > 0.0, "{what}");
                } else {
                    near(swing.ankle[1], p.ankle_height, &what);
                    near(swing.heel[1], 0.0, &what);
                    let step = if cycle == Cycle::Finishing { 0.0 } else { parameters.step_length };
                    near(swing.ankle[0] - stance.ankle[0], step, &what);
                }
            }
        }
    }
}

/// The value of a formula of the tables, in rad.
fn value(formula: &str, angles: &ThreeAngles, nine: &[f64; 9]) -> f64 {
    let symbol = |name: &str| match name {
        "" | "0" => 0.0,
        "90°" => 90.0_f64.to_radians(),
        "α" => angles.alpha,
        "β" => angles.beta,
        "δ" => angles.tilt,
        "χ" => angles.chi,
        "ξ" => angles.xi,
        "θ₁" => angles.theta1,
        "θ₃" => angles.theta3,
        "ω" => angles.omega,
        "φ" => angles.phi,
        arm => {
            let digit = arm.strip_prefix('α').and_then(|rest| "₁₂₃₄₅₆₇₈₉".find(rest)).expect("a symbol");
            nine[digit / '₁'.len_utf8()]
        }
    };
    let terms = formula.replace(' ', "").replace('−', "+−");
    terms
        .split('+')
        .map(|term| term.strip_prefix('−').map_or_else(|| symbol(term), |rest| -symbol(rest)))
        .sum()
}

#[test]
fn the_rotations_of_the_tables_lead_from_posture_to_posture() {
    let arms = ArmCoefficients::new(0.4, 0.5, 0.6).expect("coefficients");
    for (what, _, _, angles) in cases() {
        // (7.22), written out once more.
        let [a1, a2, a3] = [0.4 * angles.theta1, 0.4 * angles.theta3, 0.4 * angles.chi];
        let [a4, a5] = [a1 + 0.5 * angles.alpha, a3 + 0.5 * angles.alpha];
        let [a6, a7] = [a5 - 0.6 * angles.omega, 0.6 * angles.phi];
        let nine = [a1, a2, a3, a4, a5, a6, a7, a5 - 0.6 * angles.alpha, (a2 - 0.6 * angles.chi).max(0.0)];
        let arm_rows = table("7.6").expect("7.6").rows;
        for (i, (cycle, number)) in CYCLES.into_iter().zip(["7.1", "7.2", "7.3"]).enumerate() {
            let rows = table(number).expect("a table").rows;
            let mut before = three::start(&angles, &arms, cycle);
            for (j, phase) in three::phases(&angles, &arms, cycle).iter().enumerate() {
                // Rotations up the stance leg and down the swing leg, backward positive below a joint.
                let chain = |posture: &KeyPosture| {
                    let [stance, swing] = posture.legs;
                    [
                        posture.pelvis.tilt,
                        stance.shank - stance.foot,
                        stance.thigh - stance.shank,
                        -stance.thigh,
                        swing.thigh,
                        swing.shank - swing.thigh,
                        swing.foot - swing.shank,
                    ]
                };
                let (from, to) = (chain(&before), chain(&phase.end));
                for (k, cell) in rows[j][1..].iter().enumerate() {
                    let expected = value(&cell.computed, &angles, &nine);
                    let what = format!("{what}: table {number}, phase {}, column {k}", j + 1);
                    near(to[k] - from[k], expected, &what);
                }
                for side in 0..2 {
                    let row = &arm_rows[4 * i + 2 * j + side];
                    let (from, to) = (before.arms[side], phase.end.arms[side]);
                    let what = format!("{what}: table 7.6, {}", row[0].computed);
                    near(from.shoulder - to.shoulder, value(&row[3].computed, &angles, &nine), &what);
                    let elbow = value(&row[4].computed, &angles, &nine);
                    near((to.elbow - from.elbow).abs(), elbow.abs(), &what);
                }
                before = phase.end;
            }
        }
    }
}

//! Five determinants against numbers that another program computed.
//!
//! The reference's sets with the printed yaw schedule are left out: the model has the corrected schedule only.

use serde_json::Value;
use solaris_gait::determinants::five::{
    ArmCoefficients, FiveAngles, FiveParameters, NECK, PARAMETERS, Timing, TrunkAmplitudes, Upper, close,
    pelvis_travel, phases, posture_before, solve, thesis_speed,
};
use solaris_gait::determinants::{Cycle, KeyPosture, LegAngles, Proportions, Root};
use solaris_gait::{GaitError, PostureError};

fn reference() -> Value {
    serde_json::from_str(include_str!("../../../../fixtures/reference/gait5.json")).expect("the reference")
}

fn number(value: &Value, key: &str) -> f64 {
    value[key].as_f64().unwrap_or_else(|| panic!("no number '{key}'"))
}

fn golden() -> Vec<Value> {
    reference()["golden"].as_array().expect("sets").clone()
}

fn body(set: &Value) -> Proportions {
    let body = &set["body"];
    Proportions {
        thigh: number(body, "L1"),
        shank: number(body, "L2"),
        ball_ahead: number(body, "L3"),
        toe: number(body, "L4"),
        hips: number(body, "L"),
        height: number(body, "H"),
        unit: 1.0,
        ..Proportions::FIT
    }
}

fn parameters(user: &Value) -> FiveParameters {
    let keys = ["S", "theta_deg", "delta_deg", "phi_deg", "kappa_deg", "tau_deg", "d", "p"];
    FiveParameters::from_values(keys.map(|key| number(user, key)))
}

/// In the order of the reference's keys.
const ANGLES: [&str; 8] = ["alpha", "beta", "chi", "omega", "xi", "eps", "psi", "mu"];

fn degrees(a: &FiveAngles) -> [f64; 8] {
    [a.alpha, a.beta, a.chi, a.omega, a.xi, a.epsilon, a.psi, a.mu].map(f64::to_degrees)
}

#[track_caller]
fn near(found: f64, wanted: f64, tolerance: f64, what: &str) {
    assert!((found - wanted).abs() <= tolerance, "{what}: {found}, not {wanted}");
}

/// The reference has nine decimals.
const DIGITS: f64 = 1e-9;

#[test]
fn all_sets_have_the_references_angles() {
    let sets = golden();
    assert_eq!(sets.len(), 15);
    for set in &sets {
        for (proportions, wanted) in [
            (body(set), &set["angles_deg"]),
            (Proportions { hips: 0.1 * number(set, "H"), ..body(set) }, &set["pelvis_0.1H"]["angles_deg"]),
        ] {
            let name = format!("{}{}", set["family"], set["step_frequency"]);
            let all = close(&proportions, &parameters(&set["user"])).expect("closes");
            for (key, found) in ANGLES.iter().zip(degrees(&all)) {
                near(found, number(wanted, key), DIGITS, &format!("{name} {key}"));
            }
        }
        assert!(solve(&body(set), &parameters(&set["user"])).is_ok());
    }
}

#[test]
fn all_sets_have_the_references_margins() {
    for set in golden() {
        let (p, q) = (body(&set), parameters(&set["user"]));
        let mut found = solaris_gait::determinants::five::conditions(&p, &q);
        found.extend(solaris_gait::determinants::five::remarks(&close(&p, &q).expect("closes")));
        let wanted = &set["constraints_deg"];
        for (name, key) in [
            ("(i)", "i a-chi"),
            ("(ii′)", "ii' be-th"),
            ("(iii)", "iii xi-a"),
            ("(iv)", "iv phi-be"),
            ("(v)", "v om-phi"),
            ("(vi)", "vi chi-ka"),
        ] {
            let condition = found.iter().find(|condition| condition.name == name).expect("there");
            // Six decimals there.
            near(condition.room(), number(wanted, key), 5.1e-7, name);
        }
    }
}

#[test]
fn what_cannot_be_is_refused_with_the_references_reasons() {
    let reference = reference();
    let set = &golden()[2];
    assert_eq!((set["family"].as_str(), set["step_frequency"].as_f64()), (Some("G"), Some(110.0)));
    let cases = reference["infeasible"].as_array().expect("cases");
    assert_eq!(cases.len(), 12);
    let mut texts = Vec::new();
    for case in cases {
        let mut user = set["user"].clone();
        for (key, value) in case["changes"].as_object().expect("changes") {
            let angle = ["theta", "delta", "phi", "kappa", "tau"].contains(&key.as_str());
            user[if angle { format!("{key}_deg") } else { key.clone() }] = value.clone();
        }
        let Err(GaitError::Posture(PostureError::Infeasible { determinants: "five", why })) =
            solve(&body(set), &parameters(&user))
        else {
            panic!("{case} closes");
        };
        for nearest in &why.nearest {
            if let Some(value) = nearest.feasible {
                let mut values = parameters(&user).values();
                let i = PARAMETERS.iter().position(|p| p.name == nearest.parameter.name).expect("known");
                values[i] = value;
                assert!(solve(&body(set), &FiveParameters::from_values(values)).is_ok());
            }
        }
        texts.push(format!("{}\n  reference: {}\n  {why}", case["name"], case["reason"]));
    }
    insta::assert_snapshot!(texts.join("\n"));
}

/// A posture's joints where the stance foot's ankle, or its heel print, is at 0.
fn joints(p: &Proportions, posture: &KeyPosture, phase: usize, step: f64) -> [[[f64; 2]; 5]; 2] {
    // Rooted as the phase is that ends there.
    let (leg, root, at) = match phase {
        0 | 1 => (1, Root::Ball, [p.ball_ahead - step, 0.0]),
        2 => (0, Root::Heel, [0.0; 2]),
        3 => (0, Root::Sole, [0.0; 2]),
        _ => (0, Root::Ball, [p.ball_ahead, 0.0]),
    };
    let hip = posture.legs[leg].hip_over(p, root, at);
    let offset = posture.swing_hip(p);
    let stance = if leg == 0 { hip } else { [hip[0] - offset[0], hip[1] - offset[1]] };
    posture.joints(p, stance).map(|j| [j.hip, j.knee, j.ankle, j.ball, j.tip])
}

#[test]
fn postures_and_joints_are_the_references() {
    for set in golden() {
        let (p, q) = (body(&set), parameters(&set["user"]));
        let angles = close(&p, &q).expect("closes");
        let upper = Upper::automatic(&angles, 1.0);
        let mut all = vec![posture_before(&angles, &upper, Cycle::Intermediate)];
        all.extend(phases(&angles, &upper, Cycle::Intermediate).iter().map(|phase| phase.end));
        for (k, posture) in all.iter().enumerate() {
            let wanted = &set["postures"][k];
            let legs = [&wanted["st_pitch_deg"], &wanted["sw_pitch_deg"]];
            for (leg, wanted) in posture.legs.iter().zip(legs) {
                let LegAngles { thigh, shank, foot, toes } = leg;
                for (i, found) in [thigh, shank, foot, toes].into_iter().enumerate() {
                    // There, forward is positive.
                    near(-found.to_degrees(), wanted[i].as_f64().expect("pitch"), DIGITS, posture.name);
                }
            }
            near(posture.pelvis.rotation.to_degrees(), number(wanted, "yaw_deg"), DIGITS, "rotation");
            near(posture.pelvis.tilt.to_degrees(), number(wanted, "tilt_deg"), DIGITS, "tilt");
            let points = &set["points_xz_m_hip_knee_ankle_ball_tip"][k];
            for (found, key) in joints(&p, posture, k, q.step_length).iter().zip(["st", "sw"]) {
                for (i, point) in found.iter().enumerate() {
                    for (axis, found) in point.iter().enumerate() {
                        let wanted = points[key][i][axis].as_f64().expect("a coordinate");
                        near(*found, wanted, DIGITS, &format!("phase {k} {key} {i}"));
                    }
                }
            }
        }
    }
}

#[test]
fn the_pelvis_goes_as_far_as_in_the_reference() {
    for set in golden() {
        let (p, q) = (body(&set), parameters(&set["user"]));
        let angles = close(&p, &q).expect("closes");
        let travel = pelvis_travel(&p, &angles);
        near(travel.iter().sum(), q.step_length, 1e-14, "a step");
        for (i, part) in Timing::Travel.parts(&p, &angles, 110.0).iter().enumerate() {
            near(*part, set["pelvis_travel_fraction"][i].as_f64().expect("a part"), 1e-12, "travel");
        }
    }
}

#[test]
fn arms_have_the_references_coefficients() {
    let mut solvable = 0;
    for set in golden() {
        let angles = close(&body(&set), &parameters(&set["user"])).expect("closes");
        let found = ArmCoefficients::automatic(&angles);
        let wanted = set["arm_k"].as_array();
        assert_eq!(found.is_some(), wanted.is_some(), "{}{}", set["family"], set["step_frequency"]);
        if let (Some(found), Some(wanted)) = (found, wanted) {
            solvable += 1;
            for (k, wanted) in found.k.iter().zip(wanted) {
                near(*k, wanted.as_f64().expect("k"), 5.1e-7, "k");
            }
        }
    }
    assert_eq!(solvable, 13);
}

#[test]
fn the_trunks_rise_decides_kappa_and_psi() {
    let mut driven = 0;
    for set in golden() {
        let wanted = &set["vd_driven"];
        let Some(wanted_angles) = wanted["angles_deg"].as_object() else { continue };
        driven += 1;
        let (p, q) = (body(&set), parameters(&set["user"]));
        let trunk = TrunkAmplitudes::at_speed(thesis_speed(p.height, number(&set, "step_frequency")));
        near(100.0 * trunk.rise, number(wanted, "Vd_cm"), 1e-12, "Vd");
        let risen = q.with_trunk_rise(&p, &trunk).expect("a κ");
        let angles = solve(&p, &risen).expect("closes");
        let wanted_kappa = wanted_angles["kappa"].as_f64().expect("κ");
        near(risen.thigh_swing.to_degrees(), wanted_kappa, DIGITS, "κ");
        for (key, found) in ANGLES.iter().zip(degrees(&angles)) {
            near(found, wanted_angles[*key].as_f64().expect("an angle"), DIGITS, key);
        }
        // The neck, by forward kinematics.
        let neck = |n: f64, g: f64, z: f64| {
            let bend = n * trunk.pelvis_bend;
            let upper = bend + g * trunk.torso_bend;
            p.height * (z * trunk.lean).cos() * (NECK[0] * bend.cos() + NECK[1] * upper.cos())
        };
        let strike = p.leg() * angles.alpha.cos() - 0.5 * p.hips * q.tilt.sin() + neck(0.2, 0.2, 1.0);
        let passing = p.thigh * angles.mu.cos() + p.shank * angles.psi.cos() + neck(-1.0, 1.0, -1.0);
        near(passing - strike, trunk.rise, 1e-14, "the rise");
    }
    assert_eq!(driven, 5);
}

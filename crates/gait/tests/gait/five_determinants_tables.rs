//! The corrected tables are what the postures do: each entry is evaluated, and compared with the joints' turns.

use solaris_gait::determinants::five::{
    Family, FiveAngles, FiveParameters, Upper, phases, posture_before, solve, table,
};
use solaris_gait::determinants::{Cycle, KeyPhase, KeyPosture, LegAngles, Proportions};

/// A set's angles by their letters, and the upper body's.
fn letters(angles: &FiveAngles, upper: &Upper) -> Vec<(String, f64)> {
    let q = &angles.parameters;
    let mut all: Vec<(String, f64)> = [
        ("α", angles.alpha),
        ("β", angles.beta),
        ("χ", angles.chi),
        ("ω", angles.omega),
        ("ξ", angles.xi),
        ("ψ", angles.psi),
        ("μ", angles.mu),
        ("θ", q.heel_strike_angle),
        ("δ", q.tilt),
        ("φ", q.thigh_lift_off),
        ("κ", q.thigh_swing),
        ("τ", q.rotation),
        ("ν", upper.trunk.pelvis_bend),
        ("γ", upper.trunk.torso_bend),
        ("ζ", upper.trunk.lean),
    ]
    .map(|(letter, value)| (letter.to_owned(), value))
    .into();
    for (i, target) in upper.arms.targets(angles).iter().enumerate() {
        let digits: String = (i + 1)
            .to_string()
            .bytes()
            .map(|digit| char::from_u32(u32::from(digit - b'0') + 0x2080).expect("a subscript"))
            .collect();
        all.push((format!("α{digits}"), *target));
    }
    all
}

/// The value of a sum such as `κ+φ` or `−3δ/5`.
fn value(entry: &str, letters: &[(String, f64)]) -> f64 {
    if entry == "0" {
        return 0.0;
    }
    let spaced = entry.replace('−', " −").replace('+', " +");
    spaced
        .split_whitespace()
        .map(|term| {
            let sign = if term.starts_with('−') { -1.0 } else { 1.0 };
            let term = term.trim_start_matches(['−', '+']);
            let (product, divisor) = term.split_once('/').unwrap_or((term, "1"));
            let letter = product.trim_start_matches(|c: char| c.is_ascii_digit());
            let factor = product.strip_suffix(letter).filter(|f| !f.is_empty()).unwrap_or("1");
            let number = |text: &str| text.parse::<f64>().unwrap_or_else(|_| panic!("{entry}"));
            let found = letters.iter().find(|(name, _)| name == letter).unwrap_or_else(|| panic!("{entry}"));
            sign * number(factor) * found.1 / number(divisor)
        })
        .sum()
}

/// Turns of a leg's hip, knee, ankle and toes, forward being positive, from its root upwards or from the hip downwards.
fn turns(before: &LegAngles, after: &LegAngles, from_foot: bool) -> [f64; 4] {
    let forward = |leg: &LegAngles| [leg.thigh, leg.shank, leg.foot, leg.toes].map(|pitch| -pitch);
    let (was, is) = (forward(before), forward(after));
    let by: [f64; 4] = std::array::from_fn(|i| is[i] - was[i]);
    let downwards = [by[0], by[1] - by[0], by[2] - by[1], by[3] - by[2]];
    if from_foot { downwards.map(|turn| -turn) } else { downwards }
}

fn check(number: &str, cycle: Cycle, row: impl Fn(&KeyPosture, &KeyPhase) -> Vec<Vec<f64>>, head: usize) {
    let p = Proportions::drillis_contini(1.75);
    let q = FiveParameters::preset(Family::Retracting, 1.75, 110.0).expect("a preset");
    let angles = solve(&p, &q).expect("closes");
    let upper = Upper::automatic(&angles, 1.4);
    let letters = letters(&angles, &upper);
    let mut before = posture_before(&angles, &upper, cycle);
    let name = format!("{cycle:?}").to_lowercase();
    let table = table(number).expect("a table");
    // Tables of the upper body hold all cycles.
    let mut rows = table.rows.iter().filter(|row| head == 2 && row.len() == 12 || row[0].computed == name);
    for phase in phases(&angles, &upper, cycle) {
        for wanted in row(&before, &phase) {
            let cells = &rows.next().expect("a row")[head..];
            assert_eq!(cells.len(), wanted.len());
            for (cell, wanted) in cells.iter().zip(wanted) {
                let found = value(&cell.computed, &letters);
                assert!(
                    (found - wanted).abs() < 1e-12,
                    "{number}, {}: {} is {found}, not {wanted}",
                    phase.number,
                    cell.computed
                );
            }
        }
        before = phase.end;
    }
    assert!(rows.next().is_none());
}

#[test]
fn joints_turn_as_in_tables_8_1_to_8_3() {
    let row = |before: &KeyPosture, phase: &KeyPhase| {
        let after = &phase.end;
        let mut entries =
            vec![after.pelvis.tilt - before.pelvis.tilt, after.pelvis.rotation - before.pelvis.rotation];
        for leg in 0..2 {
            let from_foot = phase.root.swing == (leg == 1);
            let mut turns = turns(&before.legs[leg], &after.legs[leg], from_foot);
            // A foot that turns about its heel takes its toes along; its turn stands at the ankle.
            if phase.number == 2 && from_foot {
                turns[2] -= after.legs[leg].foot - before.legs[leg].foot;
            }
            entries.extend(turns);
        }
        vec![entries]
    };
    check("8.1", Cycle::Intermediate, row, 2);
    check("8.2", Cycle::Starting, row, 2);
    check("8.3", Cycle::Finishing, row, 2);
}

#[test]
fn arms_and_trunk_turn_as_in_tables_8_6_and_8_7() {
    let arms = |before: &KeyPosture, phase: &KeyPhase| {
        let turn = |arm: usize| {
            let (was, is) = (before.arms[arm], phase.end.arms[arm]);
            vec![is.shoulder - was.shoulder, is.elbow - was.elbow]
        };
        vec![turn(0), turn(1)]
    };
    let trunk = |before: &KeyPosture, phase: &KeyPhase| {
        let (was, is) = (before.trunk, phase.end.trunk);
        // ν is positive towards the swing leg.
        vec![vec![was.pelvis_bend - is.pelvis_bend, is.torso_bend - was.torso_bend, is.lean - was.lean]]
    };
    for cycle in [Cycle::Starting, Cycle::Intermediate, Cycle::Finishing] {
        check("8.6", cycle, arms, 3);
        check("8.7", cycle, trunk, 2);
    }
}

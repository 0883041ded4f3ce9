//! Walks beside people.

use solaris_gait::determinants::Determinants;
use solaris_gait::people::{Compared, FACTS, compare, curve_table, table};
use solaris_gait::{TEXTBOOK_BANDS, check_bands};
use solaris_model::human;

#[test]
fn a_walk_at_95_is_like_people_in_at_least_eight_of_ten_facts() {
    let figure = human(1.75, 73.0).expect("a person");
    let compared = Compared::of(&figure, Determinants::Five, 95.0);
    let (inside, of) = compared.inside().expect("it can be walked");
    // Double support by cadence leaves the textbook's range, and Kirtley's stance, below 109 steps/min: no walk has all three.
    assert!(of == FACTS.len() && inside >= 22, "{inside} of {of}");
    // The law of the step length is the walker's own; double support is what a plate sees.
    for name in ["step length over height and cadence", "one double support, by cadence"] {
        let fact = FACTS.iter().find(|fact| fact.name == name).expect(name);
        assert!(compared.holds(fact).expect("a value").1, "{name}");
    }
}

/// Steady strides beside textbooks' ranges, for three people: what double support by cadence excludes is not among what they keep below 110
/// steps/min.
#[test]
fn steady_strides_keep_textbooks_ranges() {
    for (height, least) in [
        (1.55, [(80.0, 18), (95.0, 19), (110.0, 20), (115.0, 19)]),
        (1.75, [(80.0, 20), (95.0, 20), (110.0, 21), (115.0, 20)]),
        (1.90, [(80.0, 19), (95.0, 19), (110.0, 19), (115.0, 17)]),
    ] {
        let figure = human(height, 23.84 * height * height).expect("a person");
        for (step_frequency, least) in least {
            let compared = Compared::of(&figure, Determinants::Five, step_frequency);
            let stride = compared.stride.expect("it can be walked");
            let checks = check_bands(TEXTBOOK_BANDS, &stride);
            let outside: Vec<_> =
                checks.iter().filter(|check| !check.inside).map(|check| (check.name, check.value)).collect();
            let inside = checks.len() - outside.len();
            assert!(
                inside >= least,
                "{height} m, {step_frequency}/min: {inside} of {}, not {outside:?}",
                TEXTBOOK_BANDS.len()
            );
        }
    }
}

/// A person's own pace beside the curves of people at it: angles and forces of the ground, which do not grow with the leg. The knee's and the
/// hip's bend as theirs, by the sign and the phase.
#[test]
fn curves_of_a_stride_are_those_of_people() {
    let figure = human(1.75, 73.0).expect("a person");
    let compared = Compared::of(&figure, Determinants::Five, 110.0);
    assert_eq!(compared.curves.len(), 15);
    for beside in compared.curves.iter().filter(|beside| ["°", "%BW"].contains(&beside.people.unit)) {
        let (name, inside) = (beside.people.name, beside.within(2.0));
        assert!(inside > 0.7, "{name}: {inside} of the stride");
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let (ours, theirs) = (mean(&beside.values), mean(&beside.people.mean));
        let product =
            |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - ours) * (b - theirs)).sum::<f64>();
        let alike = product(&beside.values, &beside.people.mean);
        assert!(alike > 0.0, "{name} goes the other way: {alike}");
    }
    let table = curve_table(&[compared]);
    assert_eq!(table.rows.len(), 15);
}

#[test]
fn a_refused_walk_is_a_column_of_dashes_with_its_reason() {
    let figure = human(1.75, 73.0).expect("a person");
    let compared = compare(&figure, Determinants::Five, &[140.0]);
    let table = table(Determinants::Five, &compared);
    assert!(table.rows[..FACTS.len()].iter().all(|row| row[4].computed == "–"));
    assert!(table.notes.iter().any(|note| note.starts_with("140 steps/min is refused: step frequency 140")));
}

/// Where the data are at hand: 30 people on a treadmill at six speeds each.
#[test]
fn thirty_people_take_shorter_steps_on_a_treadmill() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/data/spatiotemporal/h2a_treadmill.csv");
    let Ok(text) = std::fs::read_to_string(path) else {
        #[expect(clippy::print_stderr, reason = "a test that is skipped says so")]
        {
            eprintln!("skipped: the data are not at hand");
        }
        return;
    };
    let mut lines = text.lines();
    let heads: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let column = |name: &str| heads.iter().position(|head| *head == name).expect(name);
    let (height, length, cadence) = (column("Height"), column("StepLength"), column("Cadence"));
    let ratios: Vec<f64> = lines
        .filter_map(|line| {
            let fields: Vec<f64> = line.split(',').map(|field| field.parse().unwrap_or(f64::NAN)).collect();
            let ratio = fields[length] / (fields[height] * fields[cadence]);
            ratio.is_finite().then_some(ratio)
        })
        .collect();
    let mean = ratios.iter().sum::<f64>() / ratios.len() as f64;
    assert!(ratios.len() > 150 && (mean - 0.0031).abs() < 1e-4, "{mean} of {}", ratios.len());
    assert!(solaris_gait::WALK_RATIO > mean);
}

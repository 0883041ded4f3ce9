//! Walks beside people.

use solaris_gait::determinants::Determinants;
use solaris_gait::people::{Compared, FACTS, table};
use solaris_model::human;

#[test]
fn a_walk_at_95_is_like_people_in_at_least_eight_of_ten_facts() {
    let figure = human(1.75, 73.0).expect("a person");
    let compared = Compared::of(&figure, Determinants::Five, 95.0);
    let (inside, of) = compared.inside().expect("it can be walked");
    assert!(of == FACTS.len() && inside >= 22, "{inside} of {of}");
    // The laws of step length and double support are the walker's own, the latter as a plate sees it: Kirtley's stance and textbooks'
    // double support exclude it below 107 steps/min.
    for name in ["step length over height and cadence", "one double support, by cadence"] {
        let fact = FACTS.iter().find(|fact| fact.name == name).expect(name);
        assert!(compared.holds(fact).expect("a value").1, "{name}");
    }
}

#[test]
fn a_refused_walk_is_a_column_of_dashes_with_its_reason() {
    let figure = human(1.75, 73.0).expect("a person");
    let table = table(&figure, Determinants::Five, &[140.0]);
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

//! What a refusal says would do does, typed as it is printed.

use super::solaris;
use std::path::Path;

/// Parameters of key postures with their ranges: of three determinants, of five.
const THREE: [(&str, f64, f64); 4] =
    [("tilt", 0.0, 20.0), ("flexion", 0.0, 90.0), ("lift-off", 0.0, 90.0), ("clearance", 0.0, 0.2)];
const FIVE: [(&str, f64, f64); 6] = [
    ("heel-strike-angle", 0.0, 60.0),
    ("rotation", 0.0, 30.0),
    ("tilt", 0.0, 20.0),
    ("thigh-lift-off", -30.0, 80.0),
    ("thigh-swing", 0.0, 80.0),
    ("landing-height", 0.0, 0.2),
];

/// Numbers from 0 to 1, the same in every run.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn among(&mut self, lower: f64, upper: f64) -> f64 {
        lower + (upper - lower) * self.next()
    }
}

/// An option and its value, as they are typed.
type Typed = (String, String);

/// Options of a request that most often nothing fits.
fn request(numbers: &mut Numbers) -> Vec<Typed> {
    let three = numbers.next() < 0.4;
    let mut options = vec![
        ("determinants".to_owned(), if three { "3" } else { "5" }.to_owned()),
        ("step-frequency".to_owned(), format!("{:.0}", numbers.among(60.0, 140.0))),
    ];
    let known: &[(&str, f64, f64)] = if three { &THREE } else { &FIVE };
    for (name, lower, upper) in known {
        if numbers.next() < 0.4 {
            options.push(((*name).to_owned(), format!("{:.3}", numbers.among(*lower, *upper))));
        }
    }
    options
}

fn line(command: &[&str], options: &[Typed]) -> Vec<String> {
    let typed = options.iter().map(|(name, value)| format!("--{name}={value}"));
    command.iter().map(|word| (*word).to_owned()).chain(typed).collect()
}

/// Standard error, and whether it was accepted.
fn run(line: &[String]) -> (bool, String) {
    let words: Vec<&str> = line.iter().map(String::as_str).collect();
    let output = solaris(Path::new("."), &words);
    (output.status.success(), String::from_utf8_lossy(&output.stderr).into_owned())
}

/// The hints of a refusal: parameters and values as they are printed, without the unit.
fn hints(said: &str) -> Vec<Typed> {
    let Some((_, all)) = said.split_once("one of these alone would do: ") else { return Vec::new() };
    let one = |hint: &str| {
        let mut words = hint.split_whitespace();
        let name = words.next().expect("a parameter").to_owned();
        (name, words.next().expect("a value").trim_end_matches('°').to_owned())
    };
    all.lines().next().unwrap_or_default().split(", ").map(one).collect()
}

/// Every hint of so many refused requests is typed in place of what was refused.
fn check(command: &[&str], requests: usize, least: usize) {
    let (mut numbers, mut refused, mut typed) = (Numbers(7), 0, 0);
    while refused < requests {
        let options = request(&mut numbers);
        let asked = line(command, &options);
        let (accepted, said) = run(&asked);
        if accepted || !said.contains("cannot walk like this") {
            continue;
        }
        refused += 1;
        for (name, value) in hints(&said) {
            let mut changed: Vec<Typed> =
                options.iter().filter(|(known, _)| *known != name).cloned().collect();
            changed.push((name, value));
            let again = line(command, &changed);
            let (accepted, why) = run(&again);
            assert!(accepted, "{asked:?}\n{said}\n{again:?}\n{why}");
            typed += 1;
        }
    }
    assert!(typed >= least, "{typed} hints");
}

#[test]
fn what_would_do_alone_does_for_postures() {
    check(&["gait", "explain"], 60, 40);
}

#[test]
fn what_would_do_alone_does_for_walks() {
    check(&["walk", "--style=thesis", "--steps=1", "--rate=10"], 8, 4);
}

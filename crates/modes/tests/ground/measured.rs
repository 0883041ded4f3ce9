//! The ground's forces of a subject's walk on a treadmill, against force plates; skipped where the data is not at hand.

use crate::pinned::{Pinned, file, say};
use solaris_io::{record, sto};
use solaris_model::{ForceRecord, Vector3};
use solaris_modes::ground::{GroundForces, GroundOptions, Sole, Split, ground_forces};

/// What is judged (s): the filter spoils the ends.
const WINDOW: (f64, f64) = (0.45, 1.55);

/// Heel, ball and tip, 55 mm below the heel bone's origin, where the plates see the centre of pressure.
fn soles(pinned: &Pinned) -> Vec<Sole> {
    let sole = |side: &str, out: f64| {
        let link = |body: &str| {
            let name = pinned.carrier(&format!("{body}_{side}"));
            pinned.figure.link_index(&name).expect("a body")
        };
        Sole {
            name: side.to_owned(),
            foot: link("calcn"),
            toes: Some(link("toes")),
            heel: Vector3::new(-0.02, -0.055, 0.01 * out),
            ball: Vector3::new(0.18, -0.055, 0.02 * out),
            tip: Vector3::new(0.08, -0.053, 0.01 * out),
            width: Some(0.1),
        }
    };
    vec![sole("r", 1.0), sole("l", -1.0)]
}

struct Subject {
    pinned: Pinned,
    /// Right and left, at the times of the motion.
    plates: Vec<ForceRecord>,
    /// When each plate bears more than 20 N (s).
    pressed: Vec<Vec<(f64, f64)>>,
}

impl Subject {
    fn read() -> Option<Self> {
        let pinned = Pinned::read("gait2354_pinned.json")?;
        let grf = sto::read(&file("subject01_walk_grf.mot")?).expect("a table");
        let pressed = ["", "1_"].map(|prefix| {
            let plate = record::forces(&grf, &["plate".to_owned()], prefix).expect("its columns");
            let mut spans: Vec<(f64, f64)> = Vec::new();
            for (i, t) in plate.time.iter().enumerate() {
                let down = |i: usize| plate.samples[i].force.y > 20.0;
                if down(i) && (i == 0 || !down(i - 1)) {
                    spans.push((*t, *t));
                }
                if let Some(last) = spans.last_mut().filter(|_| down(i)) {
                    last.1 = *t;
                }
            }
            spans
        });
        let plates = pinned.wrenches();
        Some(Self { pinned, plates, pressed: pressed.to_vec() })
    }

    fn predict(&self, split: Split) -> GroundForces {
        let options = GroundOptions { split, ..GroundOptions::default() };
        let (figure, states) = (&self.pinned.figure, self.pinned.motion());
        ground_forces(figure, self.pinned.gravity(), &states, &soles(&self.pinned), &options).expect("forces")
    }

    fn rows(&self) -> impl Iterator<Item = usize> {
        let time = &self.plates[0].time;
        (0..time.len()).filter(|row| (WINDOW.0..=WINDOW.1).contains(&time[*row]))
    }

    fn weight(&self) -> f64 {
        self.pinned.figure.mass() * self.pinned.gravity().norm()
    }
}

/// Root of the mean square of the difference, and correlation.
fn compare(ours: &[f64], theirs: &[f64]) -> (f64, f64) {
    let n = ours.len() as f64;
    let mean = |x: &[f64]| x.iter().sum::<f64>() / n;
    let (a, b) = (mean(ours), mean(theirs));
    let pairs = || ours.iter().zip(theirs);
    let rms = (pairs().map(|(x, y)| (x - y).powi(2)).sum::<f64>() / n).sqrt();
    let cross: f64 = pairs().map(|(x, y)| (x - a) * (y - b)).sum();
    let squares = |x: &[f64], mean: f64| x.iter().map(|x| (x - mean).powi(2)).sum::<f64>();
    (rms, cross / (squares(ours, a) * squares(theirs, b)).sqrt())
}

#[test]
fn the_total_is_that_of_the_plates() {
    let Some(subject) = Subject::read() else { return };
    let ground = subject.predict(Split::default());
    let limits = [("fore-aft", 0, 2.8), ("vertical", 1, 3.9), ("lateral", 2, 2.9)];
    for (name, axis, limit) in limits {
        let ours: Vec<f64> = subject.rows().map(|row| ground.total[row].force[axis]).collect();
        let theirs =
            subject.rows().map(|row| subject.plates.iter().map(|plate| plate.samples[row].force[axis]).sum());
        let (rms, r) = compare(&ours, &theirs.collect::<Vec<f64>>());
        let percent = 100.0 * rms / subject.weight();
        say(&format!("total, {name}: rms {percent:.2} % of the weight, r {r:.3}"));
        assert!(percent <= limit, "{name}: {percent}");
        assert!(axis != 1 || r >= 0.95, "{name}: r {r}");
    }
}

#[test]
fn stances_are_those_of_the_plates() {
    let Some(subject) = Subject::read() else { return };
    let ground = subject.predict(Split::default());
    say(&format!("belt {:.3?} m/s, level {:.4} m", ground.stances.belt, ground.stances.level));
    for foot in 0..2 {
        for stance in ground.stances.list.iter().filter(|stance| stance.foot == foot) {
            say(&format!(
                "{foot}: {:.3} to {:.3}; plates {:.3?}",
                stance.start, stance.end, subject.pressed[foot]
            ));
        }
    }
}

#[test]
fn each_foot_beside_its_plate() {
    let Some(subject) = Subject::read() else { return };
    for split in Split::ALL {
        let ground = subject.predict(split);
        let mut line = format!("{:<10}", split.name());
        for foot in 0..2 {
            for axis in 0..3 {
                let ours: Vec<f64> =
                    subject.rows().map(|row| ground.contacts[foot].samples[row].force[axis]).collect();
                let theirs: Vec<f64> =
                    subject.rows().map(|row| subject.plates[foot].samples[row].force[axis]).collect();
                let (rms, r) = compare(&ours, &theirs);
                line += &format!("  {:5.2} ({r:.3})", 100.0 * rms / subject.weight());
            }
            // Centre of pressure while both bear a tenth of the weight.
            let tenth = 0.1 * subject.weight();
            let mut squares = (0.0, 0.0, 0);
            for row in subject.rows() {
                let (a, b) = (&ground.contacts[foot].samples[row], &subject.plates[foot].samples[row]);
                if a.force.y > tenth && b.force.y > tenth {
                    let x = b.moment.z / b.force.y;
                    let z = -b.moment.x / b.force.y;
                    squares =
                        (squares.0 + (a.cop.x - x).powi(2), squares.1 + (a.cop.z - z).powi(2), squares.2 + 1);
                }
            }
            let n = f64::from(squares.2);
            line += &format!(
                "  cop {:.1} {:.1} mm |",
                1e3 * (squares.0 / n).sqrt(),
                1e3 * (squares.1 / n).sqrt()
            );
        }
        say(&line);
        say(&format!("   irregular {} {:?}", ground.report.irregular, ground.report.feet));
    }
}

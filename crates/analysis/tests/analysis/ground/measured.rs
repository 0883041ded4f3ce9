//! The ground's forces of a subject's walk on a treadmill, against force plates; skipped where the data is not at hand.

use crate::pinned::{Pinned, file, say};
use crate::states::ground_forces;
use solaris_analysis::ground::{GroundForces, GroundOptions, Sole, Split};
use solaris_io::{record, sto};
use solaris_model::{Contact, MeasuredForce, Vector3};
use std::fmt::Write as _;

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
    plates: Vec<MeasuredForce>,
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
    let (belt, level) = (ground.stances.belt, ground.stances.level);
    say(&format!("belt {belt:.3?} m/s, level {level:.4} m"));
    // The subject's flat feet move backwards at 1.135 m/s.
    assert!((belt + Vector3::x() * 1.135).norm() < 0.02, "{belt}");
    let (first, last) = (ground.total[0].time, ground.total[ground.total.len() - 1].time);
    let mut edges = 0;
    for stance in &ground.stances.list {
        let pressed = &subject.pressed[stance.foot];
        let overlaps = |span: &&(f64, f64)| span.0 < stance.end && span.1 > stance.start;
        let span = pressed.iter().find(overlaps).expect("a plate that is pressed");
        for (ours, theirs) in [(stance.start, span.0), (stance.end, span.1)] {
            if ours > first && ours < last {
                edges += 1;
                say(&format!("foot {}: {:.0} ms late", stance.foot, 1e3 * (ours - theirs)));
                assert!((ours - theirs).abs() < 0.015, "{ours} {theirs}");
            }
        }
    }
    assert_eq!((ground.stances.list.len(), edges), (3, 4));
}

/// What the splits make of two double supports: root of the mean square of the difference, in % of the weight, and
/// correlation; and of the centre of pressure while foot and plate bear a tenth of the weight (mm).
#[test]
fn each_foot_is_beside_its_plate() {
    let Some(subject) = Subject::read() else { return };
    // Greatest rms of fore-aft, vertical and lateral force, and least correlation of the vertical.
    let limits = [
        (Split::Transition, [2.6, 11.5, 3.7], 0.97),
        (Split::Pivot, [2.4, 3.1, 2.5], 0.995),
        (Split::Effort, [2.4, 4.0, 2.1], 0.995),
    ];
    for (split, limit, correlation) in limits {
        let ground = subject.predict(split);
        for (foot, plate) in subject.plates.iter().enumerate() {
            let contacts = &ground.contacts[foot].samples;
            let mut line = format!("{:<10} {}:", split.name(), ground.contacts[foot].link);
            for axis in 0..3 {
                let ours: Vec<f64> = subject.rows().map(|row| contacts[row].force[axis]).collect();
                let theirs: Vec<f64> = subject.rows().map(|row| plate.samples[row].force[axis]).collect();
                let (rms, r) = compare(&ours, &theirs);
                let percent = 100.0 * rms / subject.weight();
                let _ = write!(line, "  {percent:5.2} % ({r:.3})");
                assert!(percent < limit[axis] && (axis != 1 || r > correlation), "{line}");
            }
            let tenth = 0.1 * subject.weight();
            let bears = |row: &usize| contacts[*row].force.y > tenth && plate.samples[*row].force.y > tenth;
            // About the height of the plates' origin; the ground's few centimetres do not matter.
            let off = |row: usize| {
                let Contact { force, moment, .. } = plate.samples[row];
                contacts[row].cop - Vector3::new(moment.z, 0.0, -moment.x) / force.y
            };
            let off: Vec<Vector3<f64>> = subject.rows().filter(bears).map(off).collect();
            let rms =
                |axis: usize| (off.iter().map(|v| v[axis] * v[axis]).sum::<f64>() / off.len() as f64).sqrt();
            say(&format!("{line}  centre of pressure {:.0} {:.0} mm", 1e3 * rms(0), 1e3 * rms(2)));
            let report = &ground.report.feet[foot];
            say(&format!("    {:.3?} {:.3?}", report.friction, report.outside));
        }
    }
}

//! People's curves over a stride, at five paces: means and standard deviations.
//!
//! Schwartz, Rozumalski and Trost 2008 (*J. Biomech.* 41:1639, electronic addendum), up to 82 children and young people who walk on level ground, every
//! second of the samples that they give. Their hips and their tilt are told against the plane of the iliac spines, which leans by some 12° when people stand, and
//! ours against a pelvis that is upright then: the mean tilt of each pace is taken off both. Moments are internal, about the axis that the angle
//! is told about and with its sign; they and powers are per kilogram, so that somebody with longer legs has greater ones.

/// Samples of a curve: from one strike of the foot to its next, every 4 % of the stride.
pub const PHASES: usize = 26;

/// A pace, and how fast it is without a unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pace {
    /// What it is called.
    pub name: &'static str,
    /// Mean of its strides: speed over √(g l), of the leg's length l.
    pub speed: f64,
}

/// The five of them, the slowest first.
pub const PACES: [Pace; 5] = [
    Pace { name: "very slow", speed: 0.172 },
    Pace { name: "slow", speed: 0.290 },
    Pace { name: "free", speed: 0.429 },
    Pace { name: "fast", speed: 0.560 },
    Pace { name: "very fast", speed: 0.694 },
];

/// The pace that is nearest to a speed without a unit; to one that is no number the slowest.
pub fn nearest_pace(speed: f64) -> &'static Pace {
    let [first, others @ ..] = &PACES;
    let nearer = |best: &'static Pace, other: &'static Pace| {
        if (other.speed - speed).abs() < (best.speed - speed).abs() { other } else { best }
    };
    others.iter().fold(first, nearer)
}

/// What people do over a stride of one pace.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curve {
    /// What it is, as pages call it: `Knee flexion`, `Knee flexion: moment`, `Vertical force`.
    pub name: &'static str,
    /// ° for angles, %BW for forces, N m/kg for moments, W/kg for powers.
    pub unit: &'static str,
    /// People's mean.
    pub mean: [f64; PHASES],
    /// Their standard deviation.
    pub deviation: [f64; PHASES],
}

/// All curves of a pace.
pub fn curves(pace: &Pace) -> Vec<Curve> {
    let rows = || ROWS.lines().skip(1).map(Row::of).filter(|row| row.pace == pace.name);
    let means = rows().step_by(2).zip(rows().skip(1).step_by(2));
    means
        .map(|(mean, spread)| Curve {
            name: mean.name,
            unit: mean.unit,
            mean: mean.values,
            deviation: spread.values,
        })
        .collect()
}

/// A curve's mean, and below it its deviation, of one pace after the other.
const ROWS: &str = include_str!("curves.csv");

struct Row {
    name: &'static str,
    unit: &'static str,
    pace: &'static str,
    values: [f64; PHASES],
}

impl Row {
    fn of(line: &'static str) -> Self {
        let mut fields = line.split(',');
        let mut next = || fields.next().unwrap_or_default();
        let [name, unit, pace, _] = [next(), next(), next(), next()];
        let values = std::array::from_fn(|_| next().parse().unwrap_or(f64::NAN));
        Self { name, unit, pace, values }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_pace_has_every_curve_whole() {
        let names: Vec<&str> = curves(&PACES[0]).iter().map(|curve| curve.name).collect();
        assert_eq!(names.len(), 15);
        assert_eq!(ROWS.lines().count(), 1 + 2 * PACES.len() * names.len());
        for line in ROWS.lines() {
            assert_eq!(line.split(',').count(), 4 + PHASES, "{line}");
        }
        for pace in &PACES {
            let curves = curves(pace);
            assert_eq!(curves.iter().map(|curve| curve.name).collect::<Vec<_>>(), names);
            for curve in curves {
                assert!(curve.mean.iter().all(|value| value.is_finite()), "{pace:?} {curve:?}");
                assert!(
                    curve.deviation.iter().all(|value| (0.0..100.0).contains(value)),
                    "{pace:?} {curve:?}"
                );
            }
        }
        let rows: Vec<Vec<&str>> =
            ROWS.lines().skip(1).map(|line| line.split(',').take(4).collect()).collect();
        for pair in rows.chunks_exact(2) {
            assert_eq!((&pair[0][..3], pair[0][3], pair[1][3]), (&pair[1][..3], "mean", "deviation"));
        }
    }

    /// The mean vertical force over a stride is half the weight: two feet bear it, and the body neither rises nor sinks. A law that nothing in the
    /// table was made for.
    #[test]
    fn people_bear_their_weight() {
        for pace in &PACES {
            let force =
                curves(pace).into_iter().find(|curve| curve.name == "Vertical force").expect("a force");
            let mean = force.mean.windows(2).map(|pair| f64::midpoint(pair[0], pair[1])).sum::<f64>()
                / (PHASES - 1) as f64;
            assert!((mean - 50.0).abs() < 1.5, "{}: {mean} %", pace.name);
        }
    }

    #[test]
    fn a_stride_ends_as_it_begins() {
        for pace in &PACES {
            for curve in curves(pace) {
                let range = |values: &[f64]| {
                    values.iter().fold(f64::MIN, |a, b| a.max(*b))
                        - values.iter().fold(f64::MAX, |a, b| a.min(*b))
                };
                let gap = (curve.mean[0] - curve.mean[PHASES - 1]).abs();
                assert!(gap < 0.12 * range(&curve.mean), "{} {}: {gap}", pace.name, curve.name);
            }
        }
    }

    #[test]
    fn the_nearest_pace_is_found() {
        for pace in &PACES {
            assert_eq!(nearest_pace(pace.speed), pace);
        }
        for (speed, name) in
            [(-1.0, "very slow"), (0.0, "very slow"), (0.35, "slow"), (0.37, "free"), (9.0, "very fast")]
        {
            assert_eq!(nearest_pace(speed).name, name);
        }
        assert_eq!(nearest_pace(f64::NAN).name, "very slow");
    }
}

//! What is refused, by name.

use crate::consistency::support::{GRAVITY, balance, rectangle};
use crate::states::{States, shift_root};
use nalgebra::Vector3;
use solaris_analysis::ground::{
    BalanceFrame, Consistency, ConsistencyError, ConsistencyOptions, ShiftError, consistent,
};
use solaris_model::{FigureBuilder, Joint, LinkSpec};

type Outlines = Vec<Vec<Vector3<f64>>>;

fn stood() -> (Vec<BalanceFrame>, Outlines) {
    let frame = balance(2.0, Vector3::new(0.0, 1.0, 0.0), Vector3::new(3.0, 0.0, 0.0), Vector3::zeros());
    (vec![frame; 5], vec![rectangle(Vector3::zeros(), [0.1, 0.05], 0.0); 5])
}

fn refused(change: impl FnOnce(&mut Vec<BalanceFrame>, &mut Outlines)) -> ConsistencyError {
    let (mut frames, mut outlines) = stood();
    change(&mut frames, &mut outlines);
    consistent(100.0, 2.0, &GRAVITY, 0.0, &frames, &outlines, &ConsistencyOptions::default())
        .expect_err("refused")
}

#[test]
fn frames_and_outlines() {
    assert_eq!(refused(|frames, _| frames.truncate(2)), ConsistencyError::TooShort { frames: 2 });
    assert_eq!(
        refused(|_, outlines| outlines.truncate(4)),
        ConsistencyError::Length { frames: 5, outlines: 4 }
    );
    let what = "the force";
    assert_eq!(refused(|f, _| f[1].force.x = f64::NAN), ConsistencyError::NotFinite { frame: 1, what });
    let what = "the moment";
    assert_eq!(refused(|f, _| f[2].moment.z = f64::INFINITY), ConsistencyError::NotFinite { frame: 2, what });
    let what = "the centre of mass";
    assert_eq!(refused(|f, _| f[4].com.y = f64::NAN), ConsistencyError::NotFinite { frame: 4, what });
    let what = "the outline";
    assert_eq!(refused(|_, o| o[3][1].x = f64::NAN), ConsistencyError::NotFinite { frame: 3, what });
    let what = "the centre of pressure";
    assert_eq!(refused(|f, _| f[3].moment.z = 1e308), ConsistencyError::NotFinite { frame: 3, what });
    assert_eq!(refused(|_, o| o[3].reverse()), ConsistencyError::Outline { frame: 3 });
    assert_eq!(refused(|_, o| o[3].truncate(2)), ConsistencyError::Outline { frame: 3 });
    let narrow = rectangle(Vector3::zeros(), [0.1, 0.004], 0.0);
    assert_eq!(refused(|_, o| o[2] = narrow), ConsistencyError::Narrow { frame: 2, margin: 0.005 });
    assert_eq!(refused(|f, _| f[2].com.y = -0.5), ConsistencyError::Low { frame: 2, height: -0.5 });
}

#[test]
fn numbers() {
    let (frames, outlines) = stood();
    let options = ConsistencyOptions::default();
    let text = |rate, mass, gravity: Vector3<f64>, level, options| {
        consistent(rate, mass, &gravity, level, &frames, &outlines, &options)
            .expect_err("refused")
            .to_string()
    };
    let zero = Vector3::zeros();
    assert_eq!(text(0.0, 2.0, GRAVITY, 0.0, options), "rate is 0; it must be finite and above 0");
    assert_eq!(text(f64::NAN, 2.0, GRAVITY, 0.0, options), "rate is NaN; it must be finite and above 0");
    assert_eq!(text(100.0, -2.0, GRAVITY, 0.0, options), "mass is -2; it must be finite and above 0");
    assert_eq!(text(100.0, 2.0, zero, 0.0, options), "gravity is 0; it must be finite and above 0");
    assert_eq!(text(100.0, 2.0, GRAVITY, f64::NAN, options), "the level is NaN; it must be finite");
    let bad = [
        ConsistencyOptions { limit: 0.0, ..options },
        ConsistencyOptions { limit: f64::NAN, ..options },
        ConsistencyOptions { margin: -0.1, ..options },
        ConsistencyOptions { least_force: 0.0, ..options },
        ConsistencyOptions { least_force: 1.1, ..options },
        ConsistencyOptions { smoothing: 0.0, ..options },
        ConsistencyOptions { tolerance: f64::INFINITY, ..options },
    ];
    for options in bad {
        let error = consistent(100.0, 2.0, &GRAVITY, 0.0, &frames, &outlines, &options).expect_err("refused");
        assert!(matches!(error, ConsistencyError::Number { .. }), "{error}");
    }
}

#[test]
fn extreme_numbers_end_without_nan() {
    let (frames, outlines) = stood();
    for (rate, mass) in
        [(1e-200, 2.0), (1e200, 2.0), (1e-3, 2.0), (1e7, 2.0), (100.0, 1e-300), (100.0, 1e300)]
    {
        let result =
            consistent(rate, mass, &GRAVITY, 0.0, &frames, &outlines, &ConsistencyOptions::default());
        if let Ok(found) = result {
            let all = found.shift.iter().chain(&found.velocity).chain(&found.acceleration);
            assert!(all.flat_map(|v| v.iter()).all(|x| x.is_finite()), "{rate} {mass}");
        }
    }
}

#[test]
fn roots_that_cannot_be_shifted() {
    let (frames, outlines) = stood();
    let found = consistent(100.0, 2.0, &GRAVITY, 0.0, &frames, &outlines, &ConsistencyOptions::default())
        .expect("solved");
    let shift = |joint: Joint, found: &Consistency| {
        let figure =
            FigureBuilder::new("f").link(LinkSpec::root("body", joint).mass(1.0)).build().expect("valid");
        let (nq, nv) = (figure.layout().nq(), figure.layout().nv());
        let (q, v, a) = (vec![0.0; 5 * nq], vec![0.0; 5 * nv], vec![0.0; 5 * nv]);
        let mut states = States { time: (0..5).map(f64::from).collect(), q, v, a, ..Default::default() };
        shift_root(&figure, &mut states, found).map_err(|error| error.to_string())
    };
    assert_eq!(shift(Joint::new("root").tx().ty().tz(), &found), Ok(()));
    for joint in
        [Joint::new("root").rx(), Joint::new("root").tx().ty(), Joint::new("root").rx().tx().ty().tz()]
    {
        assert_eq!(shift(joint, &found), Err(ShiftError::NoSlides { joint: "root".to_owned() }.to_string()));
    }
    let mut short = found.clone();
    short.velocity.pop();
    let error = shift(Joint::new("root").tx().ty().tz(), &short).expect_err("refused");
    assert_eq!(error, "the shift's velocity has 4 frames, the motion 5");
    let mut broken = found;
    broken.acceleration[3].z = f64::NAN;
    let error = shift(Joint::new("root").tx().ty().tz(), &broken).expect_err("refused");
    assert_eq!(error, "a of 'root.tx' at 3 s is NaN; it must be a finite number");
}

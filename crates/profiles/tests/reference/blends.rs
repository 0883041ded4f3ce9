//! Fades and blended pairs.

use crate::harness::{check, check_column, check_derivatives, check_stationary, list, number, numbers, unit};
use serde_json::Value;
use solaris_profiles::blend::{Blend, Fade, FadeKind, Leaving};
use solaris_profiles::displacement::{Power, Trigonometric, TrigonometricVelocities};
use solaris_profiles::{Answers, Clip, Curve, Dual, Elementary};

/// The fade of a case, which is of the thesis's stiffness: the length of its window.
fn fade(case: &Value) -> Fade {
    let kind = match case["kind"].as_str().expect("a kind") {
        "linear" => FadeKind::Linear,
        "exp" => FadeKind::Exponential { stiffness: 0.0 },
        "sinh" => FadeKind::Sinh { stiffness: 0.0 },
        "trig" => FadeKind::Trigonometric { stiffness: 0.0 },
        "smooth5" => FadeKind::Smooth,
        other => panic!("no such fade: {other}"),
    };
    Fade::thesis(kind, number(&case["t0"]), number(&case["t1"])).expect("a fade")
}

fn check_alpha<F: Elementary>(case: &Value) {
    let fade = fade(case);
    let jets: Vec<[F; 4]> = numbers(&case["t"]).into_iter().map(|time| fade.alpha(time)).collect();
    for (order, name) in ["alpha", "alpha1", "alpha2"].into_iter().enumerate() {
        let found: Vec<f64> = jets.iter().map(|jet| jet[order].value()).collect();
        let id = format!("{} {} in {}: {name}", case["kind"], case["t0"], std::any::type_name::<F>());
        check_column(&id, &found, &numbers(&case[name]), &[], unit::<F>());
    }
}

#[test]
fn shares_and_their_derivatives() {
    let tables = list("blends");
    assert_eq!(tables.len(), 30);
    for table in tables {
        check_alpha::<f64>(table);
        check_alpha::<f32>(table);
    }
}

#[test]
fn derivatives_of_shares_are_those_of_dual_numbers() {
    for table in list("blends") {
        let (fade, times) = (fade(table), numbers(&table["t"]));
        let jets: Vec<[Dual<1>; 4]> =
            times.iter().map(|&time| fade.alpha_at(Dual::variable(time, 0))).collect();
        for order in 0..3 {
            // Of a stiffness near zero, what rises by a rate is a small part of what is differentiated.
            let rate = 1.0 / (fade.end() - fade.start());
            let size = |jet: &[Dual<1>; 4]| jet[order].partial(0).abs() + rate * jet[order].value().abs();
            let largest = jets.iter().map(size).fold(0.0, f64::max);
            for jet in &jets {
                let (found, wanted) = (jet[order + 1].value(), jet[order].partial(0));
                let error = (found - wanted).abs();
                assert!(error <= 1e-13 * largest, "{fade:?}, order {order}: {found}, not {wanted}");
            }
        }
    }
}

/// Its two motions, each a curve of its own kind.
fn pair<F: Elementary>(case: &Value) -> [Box<dyn Curve<F>>; 2] {
    let f = F::from_f64;
    let first: Box<dyn Curve<F>> = match case["pair"].as_str().expect("a pair") {
        "disp_trig(2,0,5) -> disp_pow(2,0,5,n=3)" => {
            Box::new(Trigonometric::new(f(2.0), f(0.0), f(5.0)).expect("a curve"))
        }
        "disp_trig_vel(2,0,5,-1,2) -> disp_pow(2,0,5,n=3)" => {
            let (start, end) = ((f(0.0), f(-1.0)), (f(5.0), f(2.0)));
            Box::new(TrigonometricVelocities::new(f(2.0), start, end).expect("a curve"))
        }
        other => panic!("no such pair: {other}"),
    };
    [first, Box::new(Power::new(f(2.0), f(0.0), f(5.0), f(3.0)).expect("a curve"))]
}

fn blend<F: Elementary>(case: &Value) -> Blend<Box<dyn Curve<F>>, F> {
    let [first, second] = pair::<F>(case).map(Clip::new);
    Blend::between(first, second, fade(case), Leaving::Allow).expect("a blend")
}

fn answers(case: &Value) -> Blend<Box<dyn Answers>> {
    let second: Box<dyn Answers> = Box::new(Power::new(2.0, 0.0, 5.0, 3.0).expect("a curve"));
    let first: Box<dyn Answers> = if case["pair"].as_str().expect("a pair").starts_with("disp_trig(") {
        Box::new(Trigonometric::new(2.0, 0.0, 5.0).expect("a curve"))
    } else {
        Box::new(TrigonometricVelocities::new(2.0, (0.0, -1.0), (5.0, 2.0)).expect("a curve"))
    };
    Blend::between(Clip::new(first), Clip::new(second), fade(case), Leaving::Allow).expect("a blend")
}

#[test]
fn blended_pairs() {
    let pairs = list("blended");
    assert_eq!(pairs.len(), 10);
    for case in pairs {
        check(case, &blend::<f64>(case));
        check(case, &blend::<f32>(case));
        check_derivatives(case, &blend::<Dual<1>>(case));
    }
}

#[test]
fn stationary_points_of_blended_pairs() {
    for case in list("blended") {
        check_stationary(case, &answers(case));
    }
}

//! The settings that are tried, and their names.

use crate::settings::{Method, Rule};

/// Every method from coarse to fine: the fixed rules at steps from 1/30 s to 1e-5 s, the methods that choose their steps
/// at tolerances from 1e-3 to 1e-11, and the automatic choice for three tolerances.
pub fn ladder() -> Vec<Method> {
    let fixed = |rule: Rule| {
        let steps: &[f64] = &[1.0 / 30.0, 1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5];
        steps.iter().map(move |step| Method::Fixed { rule, step: *step })
    };
    let tolerances = [1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11];
    let automatic = [1e-3, 1e-6, 1e-9].map(|tolerance| Method::Automatic { tolerance });
    Rule::ALL
        .into_iter()
        .flat_map(fixed)
        .chain(tolerances.map(|tolerance| Method::Adaptive { tolerance }))
        .chain(tolerances.map(|tolerance| Method::Stiff { tolerance }))
        .chain(automatic)
        .collect()
}

/// The methods as they are run at so many frames a second (1/s): no fixed step is longer than a frame, and none comes
/// twice.
pub(super) fn fitted(methods: &[Method], rate: f64) -> Vec<Method> {
    let fit = |method: &Method| match *method {
        Method::Fixed { rule, step } => Method::Fixed { rule, step: step.min(rate.recip()) },
        other => other,
    };
    let mut fitted: Vec<Method> = methods.iter().map(fit).collect();
    fitted.dedup();
    fitted
}

/// What a method is called.
pub fn method_name(method: Method) -> String {
    match method {
        Method::Usual => "usual".to_owned(),
        Method::Automatic { .. } => "automatic".to_owned(),
        Method::Fixed { rule, .. } => rule.to_string(),
        Method::Impulses { .. } => "impulses".to_owned(),
        Method::Adaptive { .. } => "adaptive".to_owned(),
        Method::Stiff { .. } => "stiff".to_owned(),
    }
}

/// The step or tolerance of a method: `1e-3 s`, `1e-6`.
pub fn setting(method: Method) -> String {
    match method {
        Method::Fixed { step, .. } | Method::Impulses { step } => format!("{} s", short(step)),
        Method::Automatic { tolerance } | Method::Adaptive { tolerance } | Method::Stiff { tolerance } => {
            short(tolerance)
        }
        Method::Usual => "its own".to_owned(),
    }
}

/// One digit where it has no more, else two.
fn short(x: f64) -> String {
    let one = format!("{x:.0e}");
    let is_exact = one.parse::<f64>().is_ok_and(|read| (read - x).abs() <= 1e-9 * x.abs());
    if is_exact { one } else { format!("{x:.1e}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_are_short() {
        let rule = Rule::RungeKutta4;
        let texts = [1e-3, 3e-4, 1.0 / 30.0, 2.5e-4].map(|step| setting(Method::Fixed { rule, step }));
        assert_eq!(texts, ["1e-3 s", "3e-4 s", "3.3e-2 s", "2.5e-4 s"]);
        assert_eq!(setting(Method::Stiff { tolerance: 1e-9 }), "1e-9");
        assert_eq!(method_name(Method::Fixed { rule, step: 1.0 }), "Runge-Kutta 4");
    }

    #[test]
    fn no_step_is_longer_than_a_frame() {
        let rule = Rule::RungeKutta4;
        let methods = [0.1, 0.03, 1e-3].map(|step| Method::Fixed { rule, step });
        let expected = [0.01, 1e-3].map(|step| Method::Fixed { rule, step });
        assert_eq!(fitted(&methods, 100.0), expected);
        assert_eq!(fitted(&ladder(), 10.0), ladder());
    }

    #[test]
    fn each_method_goes_from_coarse_to_fine() {
        let size = |method: &Method| match *method {
            Method::Fixed { step, .. } | Method::Impulses { step } => step,
            Method::Usual => 1.0,
            Method::Automatic { tolerance }
            | Method::Adaptive { tolerance }
            | Method::Stiff { tolerance } => tolerance,
        };
        for pair in ladder().windows(2) {
            let same = method_name(pair[0]) == method_name(pair[1]);
            assert!(!same || size(&pair[0]) > size(&pair[1]), "{pair:?}");
        }
    }
}

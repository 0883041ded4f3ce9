//! What a stretch is refused for, and where it then ends.

use crate::steppers::problems::{Equations, Jacobian, Motion, Rate, fixed, run};
use solaris_model::{FigureBuilder, Inertia, Joint, LinkSpec, Vector3};
use solaris_modes::time::{RateError, Stepping, TimeError, advance};
use solaris_modes::{Counts, Method, Rule, Settings, Simulation};

fn system(rate: Rate) -> Equations<Rate, Jacobian> {
    Equations { len: 1, rate, jacobian: |_, _, jacobian| jacobian.fill(0.0) }
}

#[test]
fn a_rate_that_is_no_number_ends_the_stretch_at_the_last_good_state() {
    let mut broken = system(|t, _, rate| {
        rate[0] = if t < 0.5 { 1.0 } else { f64::NAN };
        Ok(())
    });
    let mut y = [0.0];
    let error = run(&mut broken, fixed(Rule::RungeKutta4, 0.1), 1.0, &mut y).expect_err("no rate");
    assert!(
        matches!(error, TimeError::Rate { source: RateError::NotFinite { index: 0, .. }, .. }),
        "{error}"
    );
    assert!(error.to_string().contains("entry 0 of the rate is NaN"), "{error}");
    approx::assert_abs_diff_eq!(y[0], 0.4, epsilon = 1e-12);
}

#[test]
fn a_state_that_overflows_is_refused() {
    let mut exploding = system(|_, _, rate| {
        rate[0] = 1e308;
        Ok(())
    });
    let mut y = [1e308];
    let error = run(&mut exploding, fixed(Rule::ExplicitEuler, 1.0), 1.0, &mut y).expect_err("too large");
    assert!(matches!(error, TimeError::Rate { source: RateError::NotFinite { .. }, .. }), "{error}");
    approx::assert_abs_diff_eq!(y[0], 1e308);
    let error =
        run(&mut exploding, fixed(Rule::ExplicitEuler, 1.0), 1.0, &mut [f64::NAN]).expect_err("no state");
    assert!(matches!(error, TimeError::Rate { .. }), "{error}");
}

#[test]
fn an_event_function_that_is_no_number_is_refused() {
    let mut broken = Motion::new(|_, _, _| 0.0).event(|t, _, _| if t < 0.5 { 1.0 } else { f64::NAN });
    let error = run(&mut broken, fixed(Rule::RungeKutta4, 0.1), 1.0, &mut [0.0, 0.0]).expect_err("no value");
    assert!(
        matches!(error, TimeError::Rate { source: RateError::EventNotFinite { index: 0, .. }, .. }),
        "{error}"
    );
}

#[test]
fn rules_for_positions_and_velocities_need_them() {
    for rule in [Rule::SemiImplicitEuler, Rule::ConstantAcceleration] {
        let mut decay = system(|_, y, rate| {
            rate[0] = -y[0];
            Ok(())
        });
        let error = run(&mut decay, fixed(rule, 0.1), 1.0, &mut [1.0]).expect_err("no positions");
        assert_eq!(error, TimeError::NoPositions { rule });
    }
}

#[test]
fn no_more_is_evaluated_than_was_allowed() {
    let mut oscillator = Motion::new(|_, q, _| -q);
    let (mut y, mut counts) = ([1.0, 0.0], Counts { evaluations: 5, ..Counts::default() });
    let stepping = fixed(Rule::RungeKutta4, 0.1);
    let mut nobody = |_: &mut _, _, _: &[f64]| Ok(());
    let error = advance(&mut oscillator, stepping, (0.0, 1.0), &mut y, &[], &mut nobody, 15, &mut counts)
        .expect_err("spent");
    assert!(matches!(error, TimeError::Evaluations { evaluations: 15, .. }), "{error}");
    // Two whole steps were taken.
    assert_eq!((counts.evaluations, counts.steps), (15, 2));
    approx::assert_abs_diff_eq!(y[0], 0.2_f64.cos(), epsilon = 1e-6);
}

#[test]
fn steps_tolerances_and_times_that_are_none_are_refused() {
    let mut oscillator = Motion::new(|_, q, _| -q);
    for stepping in [
        fixed(Rule::RungeKutta4, 0.0),
        fixed(Rule::RungeKutta4, f64::NAN),
        Stepping::Adaptive { tolerance: -1.0 },
    ] {
        let error = run(&mut oscillator, stepping, 1.0, &mut [1.0, 0.0]).expect_err("no step");
        assert!(matches!(error, TimeError::Range { .. }), "{error}");
    }
    let error = run(&mut oscillator, fixed(Rule::RungeKutta4, 0.1), f64::INFINITY, &mut [1.0, 0.0])
        .expect_err("no end");
    assert!(error.to_string().contains("the end of the stretch is inf"), "{error}");
}

#[test]
fn a_stretch_of_no_length_is_at_its_end() {
    let (stopped, counts) =
        run(&mut Motion::new(|_, q, _| -q), fixed(Rule::RungeKutta4, 0.1), 0.0, &mut [1.0, 0.0])
            .expect("runs");
    assert!(stopped.events.is_empty());
    assert_eq!(counts, Counts::default());
}

#[test]
#[cfg(not(feature = "stiff"))]
fn methods_that_are_not_built_in_say_so() {
    let mut oscillator = Motion::new(|_, q, _| -q);
    let stepping = Stepping::Stiff { tolerance: 1e-6 };
    let error = run(&mut oscillator, stepping, 1.0, &mut [1.0, 0.0]).expect_err("not built in");
    assert!(error.to_string().contains("is not built in"), "{error}");
}

#[test]
fn a_frame_that_cannot_be_shown_ends_the_stretch() {
    let (mut y, mut counts) = ([1.0, 0.0], Counts::default());
    let mut refuse = |_: &mut _, _, _: &[f64]| Err(RateError::NotFinite { index: 1, value: f64::NAN });
    let mut oscillator = Motion::new(|_, q, _| -q);
    let stepping = fixed(Rule::RungeKutta4, 0.1);
    let error =
        advance(&mut oscillator, stepping, (0.0, 1.0), &mut y, &[0.5], &mut refuse, u64::MAX, &mut counts)
            .expect_err("refused");
    assert!(matches!(error, TimeError::Rate { time, .. } if (time - 0.5).abs() < 1e-15), "{error}");
}

/// A body on three rotations that tumbles over lock between two steps: the energy tells, and the advice names the joint.
#[test]
fn energy_that_is_lost_beside_gimbal_lock_names_the_joint() {
    let root = Joint::new("root").rx().ry().rz();
    let link = LinkSpec::root("body", root).mass(1.0).inertia(Inertia::diagonal(0.1, 0.2, 0.3));
    let figure = FigureBuilder::new("tumbling").link(link).build().expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::zeros());
    simulation.set_start(&[0.0, 1.3, 0.0], &[1.0, 4.0, 1.0]).expect("valid");
    let method = Method::Impulses { step: 1e-2 };
    let settings = Settings { method, estimate: false, ..Settings::new(1.0, 50.0) };
    let error = simulation.run(&settings).expect_err("lost").to_string();
    assert!(error.contains("give 'root', which is ") && error.contains("a ball joint"), "{error}");
}

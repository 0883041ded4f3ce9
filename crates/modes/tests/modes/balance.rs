//! What a report remarks on the balance of energies.

use solaris_model::{FigureBuilder, Joint, LinkSpec, Vector3};
use solaris_modes::{Method, Remark, Rule, Settings, Simulation};

/// Euler's rule gives a pendulum energy in each step: with 1 ms some per cent in three seconds, which the report remarks on; with 1 µs
/// it does not.
#[test]
fn energy_that_does_not_balance_is_remarked_on() {
    let bob = LinkSpec::root("bob", Joint::new("pivot").rx()).mass(2.0).com(Vector3::new(0.0, -0.5, 0.0));
    let figure = FigureBuilder::new("pendulum").link(bob).build().expect("valid");
    let mut simulation = Simulation::new(&figure, Vector3::new(0.0, -9.81, 0.0));
    simulation.set_start(&[1.0], &[0.0]).expect("valid");
    let remarks = |step| {
        let method = Method::Fixed { rule: Rule::ExplicitEuler, step };
        let settings = Settings { method, estimate: false, ..Settings::new(1.0, 100.0) };
        simulation.run(&settings).expect("runs").report
    };
    let report = remarks(1e-3);
    let [Remark::Energy { share }] = &report.remarks[..] else { panic!("{:?}", report.remarks) };
    assert!((share - report.energy.imbalance / report.energy.scale).abs() < 1e-12 && *share > 1e-3);
    assert!(report.remarks[0].to_string().contains("of the energy at play came from nowhere or is gone"));
    assert!(remarks(1e-6).remarks.is_empty());
}

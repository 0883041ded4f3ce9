//! Studies: what they are measured against, what they say, how they end.

use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec, Vector3};
use solaris_modes::study::{Study, StudyOptions, study};
use solaris_modes::{Drive, Method, Observer, Rule, RunPass, Settings, Simulation};

const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.81, 0.0);

/// Rods of 1 m with a point mass of 1 kg at the end, one on the other.
fn pendulum(rods: usize) -> Figure {
    let bob = Vector3::new(0.0, -1.0, 0.0);
    let name = |i: usize| format!("rod{i}");
    let links = (0..rods).map(|i| {
        let joint = Joint::new(format!("pivot{i}"));
        let link = if i == 0 {
            LinkSpec::root(name(0), joint.rx())
        } else {
            LinkSpec::child(name(i), name(i - 1), joint.at(bob).rx())
        };
        link.mass(1.0).com(bob).tip(bob)
    });
    links.fold(FigureBuilder::new("pendulum"), FigureBuilder::link).build().expect("a figure")
}

fn released(figure: &Figure, angles: &[f64]) -> Simulation {
    let mut simulation = Simulation::new(figure, GRAVITY);
    simulation.set_start(angles, &vec![0.0; angles.len()]).expect("a state");
    simulation
}

fn fixed(rule: Rule, step: f64) -> Method {
    Method::Fixed { rule, step }
}

fn options(methods: &[Method]) -> StudyOptions<'static> {
    StudyOptions { methods: methods.to_vec(), ..StudyOptions::default() }
}

fn position(study: &Study, row: usize) -> f64 {
    study.rows[row].result.as_ref().expect("a result").position
}

fn silent(simulation: &Simulation, duration: f64, options: &StudyOptions<'_>) -> Study {
    let settings = Settings::new(duration, 100.0);
    study(simulation, &settings, options, &mut (), &mut |_| {}).expect("a study")
}

#[test]
fn errors_fall_with_the_order_of_the_rule() {
    let rules = Rule::ALL.map(|rule| [1e-3, 5e-4].map(|step| fixed(rule, step)));
    let study = silent(&released(&pendulum(1), &[1.0]), 2.0, &options(rules.as_flattened()));
    for (i, rule) in Rule::ALL.into_iter().enumerate() {
        let order = (position(&study, 2 * i) / position(&study, 2 * i + 1)).log2();
        assert!((order - f64::from(rule.order())).abs() < 0.1, "{rule}: {order}");
    }
    assert!(study.reference.uncertainty.position < 1e-11, "{:?}", study.reference);
    assert!(study.is_complete && !study.sensitivity.is_chaotic);
    // Without a clock nothing is said of time, and evaluations decide.
    assert!(study.rows.iter().all(|row| row.seconds.is_none()));
    assert_eq!(study.cheapest(1e-6).expect("one").method, fixed(Rule::RungeKutta4, 1e-3));
    assert_eq!(study.cheapest(1e-16), None);
}

/// Small swings, ω² = g: the closed form is off by the third power of the angle, and the study says so of every method.
#[test]
fn a_closed_form_is_believed() {
    let small = 1e-3;
    let rate = 9.81_f64.sqrt();
    let swing = move |t: f64, q: &mut [f64], v: &mut [f64]| {
        q[0] = small * (rate * t).cos();
        v[0] = -small * rate * (rate * t).sin();
    };
    let options = StudyOptions { solution: Some(&swing), ..options(&[fixed(Rule::RungeKutta4, 1e-3)]) };
    let study = silent(&released(&pendulum(1), &[small]), 2.0, &options);
    // A swing of angle θ takes θ²/16 longer: at 2 s that is θ³·ω·t/16.
    let late = small.powi(3) * rate * 2.0 / 16.0;
    let found = position(&study, 0);
    assert!(found > 0.5 * late && found < 1.1 * late, "{found:e}, {late:e}");
    assert!(study.reference.uncertainty.position.abs() <= 0.0 && study.reference.beside.is_empty());
}

#[test]
fn trouble_is_the_result_of_a_row() {
    let mut simulation = released(&pendulum(1), &[1.0]);
    simulation.drive("pivot0.rx", [Drive::Free]).expect("a drive");
    let mut settings = Settings::new(2.0, 100.0);
    settings.guard.evaluations = 50_000;
    let methods = [fixed(Rule::RungeKutta4, 1e-2), fixed(Rule::ExplicitEuler, 1e-5)];
    let study = study(&simulation, &settings, &options(&methods), &mut (), &mut |_| {}).expect("a study");
    assert!(study.rows[0].result.is_ok());
    let trouble = study.rows[1].result.as_ref().expect_err("too many evaluations");
    assert!(trouble.contains("50000"), "{trouble}");
    assert_eq!(study.rows[1].evaluations(2.0), Some(200_000));
}

/// Three rods from high up: last digits decide within seconds, and single frames are what can be compared.
#[test]
fn chaos_is_said_and_not_measured() {
    let methods = [1e-2, 1e-3].map(|step| fixed(Rule::RungeKutta4, step));
    let options = StudyOptions { evaluations: 400_000, wanted: 1e-9, ..options(&methods) };
    let study = silent(&released(&pendulum(3), &[2.5, 1.0, -1.5]), 12.0, &options);
    let sensitivity = study.sensitivity;
    assert!(sensitivity.is_chaotic && sensitivity.comparable_until < 11.0, "{sensitivity:?}");
    assert!(sensitivity.comparable_until > 0.5, "{sensitivity:?}");
    assert!(sensitivity.growth.expect("dynamics move it") > 1e4, "{sensitivity:?}");
    let agreements = [0, 1].map(|row| study.rows[row].agreement.expect("single frames"));
    assert_eq!(agreements[0].frames, 8);
    // A frame is one step of the first and ten of the second.
    assert!(agreements[1].position < 1e-3 * agreements[0].position, "{agreements:?}");
}

#[test]
fn what_is_well_behaved_is_compared_to_its_end() {
    let study = silent(&released(&pendulum(1), &[1.0]), 2.0, &options(&[fixed(Rule::RungeKutta4, 1e-2)]));
    assert!(study.sensitivity.growth.expect("it moves") < 10.0);
    assert!((study.sensitivity.comparable_until - 2.0).abs() < 1e-12);
    assert_eq!(study.rows[0].agreement, None);
}

/// Two bodies that fall and turn, joined by a hinge: nothing but gravity acts from outside.
#[test]
fn momentum_is_what_gravity_makes_of_it() {
    let offset = Vector3::new(0.0, 0.3, 0.0);
    let body = |link: LinkSpec| {
        link.mass(2.0).com(Vector3::new(0.05, 0.2, 0.0)).inertia(Inertia::diagonal(0.03, 0.01, 0.03))
    };
    let figure = FigureBuilder::new("thrown")
        .link(body(LinkSpec::root("a", Joint::free("root"))))
        .link(body(LinkSpec::child("b", "a", Joint::new("hinge").at(offset).rx())))
        .build()
        .expect("a figure");
    let mut simulation = Simulation::new(&figure, GRAVITY);
    let mut q = simulation.state().0.to_vec();
    q[7] = 0.4;
    simulation.set_start(&q, &[1.0, 3.0, 0.5, 0.3, -0.2, 2.0, -1.0]).expect("a state");
    let methods = [fixed(Rule::RungeKutta4, 1e-3), fixed(Rule::ExplicitEuler, 1e-3)];
    let study = silent(&simulation, 1.0, &options(&methods));
    let drift =
        |row: usize| study.rows[row].result.as_ref().expect("a result").momentum.expect("nothing else acts");
    assert!(drift(0).linear < 1e-8 && drift(0).angular < 1e-8, "{:?}", drift(0));
    assert!(drift(1).angular > 1e-3, "{:?}", drift(1));

    // One that hangs has somebody outside.
    let study = silent(&released(&pendulum(1), &[1.0]), 0.1, &options(&[fixed(Rule::RungeKutta4, 1e-2)]));
    assert_eq!(study.rows[0].result.as_ref().expect("a result").momentum, None);
}

#[test]
fn leaving_out_saves_and_changes_nothing() {
    let mut simulation = released(&pendulum(3), &[0.0, 0.0, 1.0]);
    simulation.drive("pivot0.rx", [Drive::Frozen]).expect("a drive");
    simulation.drive("pivot1.rx", [Drive::Frozen]).expect("a drive");
    let study = silent(&simulation, 1.0, &options(&[fixed(Rule::RungeKutta4, 1e-3)]));
    let savings = study.savings.expect("measured");
    assert!(savings.operations.1 < 0.6 * savings.operations.0, "{savings:?}");
    assert!(savings.difference < 1e-11, "{savings:?}");
}

/// A clock that goes on by a second with every look, and somebody who stops after so many rows.
struct Clock {
    now: std::cell::Cell<f64>,
    stop: std::rc::Rc<std::cell::Cell<bool>>,
    progress: Vec<f64>,
}

impl Observer for Clock {
    fn now(&self) -> Option<f64> {
        self.now.set(self.now.get() + 1.0);
        Some(self.now.get())
    }

    fn progress(&mut self, share: f64) {
        self.progress.push(share);
    }

    fn is_cancelled(&self) -> bool {
        self.stop.get()
    }
}

#[test]
fn who_stops_keeps_what_there_is() {
    let stop = std::rc::Rc::new(std::cell::Cell::new(false));
    let mut clock = Clock { now: std::cell::Cell::new(0.0), stop: stop.clone(), progress: Vec::new() };
    let methods = [1e-2, 3e-3, 1e-3].map(|step| fixed(Rule::RungeKutta4, step));
    let settings = Settings::new(1.0, 100.0);
    let mut seen = Vec::new();
    let study =
        study(&released(&pendulum(1), &[1.0]), &settings, &options(&methods), &mut clock, &mut |study| {
            seen.push(study.rows.len());
            stop.set(study.rows.len() == 2);
        });
    let study = study.expect("what there is");
    assert_eq!((seen, study.rows.len(), study.is_complete), (vec![1, 2], 2, false));
    assert!(study.rows.iter().all(|row| row.seconds.is_some()) && study.savings.is_none());
    assert!(clock.progress.windows(2).all(|pair| pair[0] <= pair[1]), "{:?}", clock.progress);
    assert!(clock.progress.last().is_some_and(|last| *last < 0.8), "{:?}", clock.progress);
}

/// Keeps what it is told.
#[derive(Default)]
struct Told {
    shares: Vec<f64>,
    passes: Vec<(usize, String, f64)>,
}

impl Observer for Told {
    fn progress(&mut self, share: f64) {
        self.shares.push(share);
    }

    fn pass(&mut self, pass: &RunPass<'_>) {
        assert!((0.0..=pass.duration).contains(&pass.time), "{pass:?}");
        self.passes.push((pass.number, pass.method.to_owned(), pass.time));
    }
}

#[test]
fn every_run_tells_which_pass_it_is_in_and_how_far() {
    let simulation = released(&pendulum(2), &[1.0, 0.5]);
    for method in [Method::Automatic { tolerance: 1e-6 }, fixed(Rule::RungeKutta4, 1e-3)] {
        let mut told = Told::default();
        let settings = Settings { method, ..Settings::new(1.0, 100.0) };
        let run = simulation.run_observed(&settings, &mut told).expect("runs");
        let (first, last) = (&told.passes[0], &told.passes[told.passes.len() - 1]);
        assert!(first.0 == 1 && last.2 > 0.98, "{method:?}: {last:?}");
        let goes_on = told.passes.windows(2).all(|pair| match (pair[0].0, pair[1].0) {
            (before, now) if before == now => pair[0].2 < pair[1].2,
            (before, now) => now == before + 1 && pair[1].2 < 0.1,
        });
        assert!(goes_on && last.0 >= 2, "{:?}", told.passes);
        assert!(
            told.passes.iter().any(|(_, method, _)| *method == run.report.method),
            "{}",
            run.report.method
        );
        // Of the whole nobody knows the share where nobody knows how many passes there will be.
        let is_automatic = matches!(method, Method::Automatic { .. });
        assert_eq!(told.shares.is_empty(), is_automatic);
    }
}

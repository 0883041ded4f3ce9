//! Sampling a curve: derivatives against the closed form, rest, rates.

use solaris_model::{
    Contact, Figure, FigureBuilder, Joint, LinkSpec, Motion, MotionError, MotionInfo, Trajectory, Vector3,
    human,
};

/// A figure of two sliding dofs.
fn slider() -> Figure {
    let joint = Joint::new("slide").tx().ty();
    FigureBuilder::new("slider").link(LinkSpec::root("block", joint).mass(1.0)).build().expect("valid")
}

fn info(figure: &Figure, rate: f64) -> MotionInfo {
    let gravity = Vector3::new(0.0, -9.80665, 0.0);
    MotionInfo { fingerprint: figure.fingerprint(), gravity, ground: None, rate }
}

struct Curve<F>(f64, F);

impl<F: Fn(f64) -> [f64; 2]> Trajectory for Curve<F> {
    fn duration(&self) -> f64 {
        self.0
    }

    fn configuration(&self, t: f64, q: &mut [f64]) {
        q.copy_from_slice(&(self.1)(t));
    }
}

#[test]
fn derivatives_of_a_sine_are_right_at_every_rate() {
    let figure = slider();
    let omega: f64 = 5.0;
    let curve = Curve(2.0, |t: f64| [(omega * t).sin(), (omega * t).cos()]);
    for rate in [1.0, 7.0, 30.0, 100.0, 120.0, 121.0, 1000.0] {
        let motion = Motion::sample(&figure, &curve, info(&figure, rate)).expect("finite");
        // The step is the shortest multiple or fraction of a frame of at least 1/120 s; truncation ω⁷h⁶/140 and ω⁸h⁶/560,
        // rounding of x and of ωt by ε, divided by h and h².
        let h =
            if rate < 120.0 { 1.0 / (rate * (120.0 / rate).floor()) } else { (rate / 120.0).ceil() / rate };
        let first = omega.powi(7) * h.powi(6) / 140.0 + (8.0 + 4.0 * omega) * f64::EPSILON / h;
        let second = omega.powi(8) * h.powi(6) / 560.0 + (16.0 + 16.0 * omega) * f64::EPSILON / (h * h);
        assert_eq!(motion.len(), 1 + (2.0 * rate) as usize, "{rate}/s");
        for i in 0..motion.len() {
            let (s, c) = (omega * motion.time()[i]).sin_cos();
            let near = |ours: f64, exact: f64, bound: f64, what: &str| {
                assert!(
                    (ours - exact).abs() <= bound,
                    "{what} at {rate}/s, frame {i}: {ours} against {exact}"
                );
            };
            near(motion.q(i)[0], s, 1e-14, "q");
            near(motion.v(i)[0], omega * c, first, "v of sin");
            near(motion.v(i)[1], -omega * s, first, "v of cos");
            near(motion.a(i)[0], -omega * omega * s, second, "a of sin");
            near(motion.a(i)[1], -omega * omega * c, second, "a of cos");
        }
    }
}

#[test]
fn a_polynomial_of_sixth_degree_has_no_truncation() {
    let figure = slider();
    let curve = Curve(1.0, |t: f64| [t.powi(6), 1.0 - t + t * t]);
    let motion = Motion::sample(&figure, &curve, info(&figure, 50.0)).expect("finite");
    for (i, t) in motion.time().iter().enumerate() {
        assert!((motion.v(i)[0] - 6.0 * t.powi(5)).abs() < 1e-12);
        assert!((motion.a(i)[0] - 30.0 * t.powi(4)).abs() < 1e-10);
        assert!((motion.v(i)[1] - (2.0 * t - 1.0)).abs() < 1e-12);
        assert!((motion.a(i)[1] - 2.0).abs() < 1e-10);
    }
}

struct Rest;
impl Trajectory for Rest {
    fn duration(&self) -> f64 {
        0.5
    }

    fn configuration(&self, _: f64, q: &mut [f64]) {
        q.iter_mut().enumerate().for_each(|(i, q)| *q = 0.1 + 1.0 / (3.0 + i as f64));
    }
}

#[test]
fn rest_is_exactly_rest() {
    let figure = human(1.75, 73.0).expect("an ordinary human");
    for rate in [1.0, 24.0, 60.0, 777.0] {
        let motion = Motion::sample(&figure, &Rest, info(&figure, rate)).expect("finite");
        for i in 0..motion.len() {
            assert!(motion.v(i).iter().chain(motion.a(i)).all(|x| *x == 0.0), "{rate}/s, frame {i}");
        }
    }
}

#[test]
fn samples_stand_at_whole_frames_and_reach_the_end() {
    let figure = slider();
    for (duration, rate, samples) in
        [(0.0, 30.0, 1), (1.0, 30.0, 31), (0.1, 30.0, 4), (0.11, 30.0, 5), (0.7, 10.0, 8), (-1.0, 30.0, 1)]
    {
        let curve = Curve(duration, |t: f64| [t, t]);
        let motion = Motion::sample(&figure, &curve, info(&figure, rate)).expect("finite");
        assert_eq!(motion.len(), samples, "{duration} s at {rate}/s");
        for (i, t) in motion.time().iter().enumerate() {
            assert!((t - i as f64 / rate).abs() < 1e-15);
        }
    }
}

#[test]
fn a_rate_that_is_none_is_refused() {
    let figure = slider();
    let curve = Curve(1.0, |t: f64| [t, t]);
    let answers = [0.0, -30.0, f64::NAN, f64::INFINITY, 100_001.0]
        .map(|rate| Motion::sample(&figure, &curve, info(&figure, rate)).expect_err("no rate").to_string());
    insta::assert_snapshot!(answers.join("\n"), @"
    rate 0 frames/s: it must be more than zero and at most 100000
    rate -30 frames/s: it must be more than zero and at most 100000
    rate NaN frames/s: it must be more than zero and at most 100000
    rate inf frames/s: it must be more than zero and at most 100000
    rate 100001 frames/s: it must be more than zero and at most 100000
    ");
}

#[test]
fn a_curve_that_breaks_is_refused_where_it_breaks() {
    let figure = slider();
    let curve = Curve(1.0, |t: f64| [t, if t < 0.5 { t } else { f64::NAN }]);
    let error = Motion::sample(&figure, &curve, info(&figure, 10.0)).expect_err("a NaN");
    insta::assert_snapshot!(error, @"q of 'slide.ty' at 0.5 s is NaN; it must be a finite number");
}

#[test]
fn columns_of_the_wrong_length_and_other_figures_are_refused() {
    let figure = slider();
    let new = |columns| Motion::new(&figure, info(&figure, 10.0), vec![0.0, 0.1], columns);
    let error = new([vec![0.0; 4], vec![0.0; 3], vec![0.0; 4]]).expect_err("too short");
    insta::assert_snapshot!(error, @"v has 3 numbers; 2 samples of 2 make 4");
    let mut motion = new([vec![0.0; 4], vec![0.0; 4], vec![0.0; 4]]).expect("the right lengths");
    assert!(motion.tau(1).is_none());
    assert!(matches!(motion.set_tau(vec![0.0; 5]), Err(MotionError::Length { found: 5, .. })));
    motion.set_tau(vec![1.0, 2.0, 3.0, 4.0]).expect("the right length");
    assert_eq!(motion.tau(1), Some(&[3.0, 4.0][..]));
    motion.check_figure(&figure).expect("its own figure");
    let other = human(1.75, 73.0).expect("an ordinary human");
    assert!(matches!(motion.check_figure(&other), Err(MotionError::OtherFigure { .. })));
    assert_eq!(Contact::default().force, Vector3::zeros());
}

#[test]
fn a_duration_that_never_ends_is_refused() {
    let figure = slider();
    let answers = [f64::INFINITY, f64::NAN, 1e9].map(|duration| {
        let curve = Curve(duration, |t: f64| [t, t]);
        Motion::sample(&figure, &curve, info(&figure, 120.0)).expect_err("no duration").to_string()
    });
    insta::assert_snapshot!(answers.join("\n"));
}

#[test]
fn times_and_forces_that_are_no_numbers_are_refused() {
    let figure = slider();
    let new =
        |time| Motion::new(&figure, info(&figure, 10.0), time, [vec![0.0; 4], vec![0.0; 4], vec![0.0; 4]]);
    for time in [vec![0.0, f64::NAN], vec![0.1, 0.1], vec![0.2, 0.1]] {
        assert!(matches!(new(time).expect_err("no times"), MotionError::Time { sample: 1, .. }));
    }
    let mut motion = new(vec![0.0, 0.1]).expect("valid");
    let error = motion.set_tau(vec![0.0, 0.0, f64::NAN, 0.0]).expect_err("a NaN");
    insta::assert_snapshot!(error, @"tau of 'dof 0' at 0.1 s is NaN; it must be a finite number");
}

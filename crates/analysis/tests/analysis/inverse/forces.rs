//! Joint forces of whole motions.

use crate::inverse::support::{GRAVITY, body, build, equally, forces, pendulum, positions, push};
use crate::states::{States, complete, inverse_motion};
use solaris_analysis::{FootSupport, InverseOptions, Support, SupportLaw, ground_reactions};
use solaris_model::{
    Contact, Figure, Joint, LinkSpec, MeasuredForce, Motion, MotionInfo, UnitQuaternion, Vector3, human,
};

/// `τ = m·l²·q̈ + m·g·l·sin q`, for a swing that the spline knows only from its samples.
#[test]
fn a_pendulum_needs_what_its_equation_says() {
    let figure = pendulum();
    let record = positions(&figure, equally(200, 200.0), |t| vec![0.8 * (5.0 * t).sin()]);
    let motion = complete(&figure, &record, None).expect("a record");
    let report = inverse_motion(&figure, GRAVITY, &motion, &[], InverseOptions::default()).expect("finite");
    for row in 30..170 {
        let q = 0.8 * (5.0 * motion.time[row]).sin();
        let expected = 2.0 * 0.25 * -25.0 * q + 2.0 * 9.80665 * 0.5 * q.sin();
        assert!((report.tau[row] - expected).abs() < 1e-7, "row {row}: {} {expected}", report.tau[row]);
    }
    let greatest = report.tau.iter().fold(0.0_f64, |a, b| if b.abs() > a.abs() { *b } else { a });
    assert_eq!(report.dofs[0].greatest.to_bits(), greatest.to_bits());
    assert!(report.dofs[0].rms > 0.0 && report.dofs[0].rms < greatest.abs());
}

/// A body that tumbles freely needs nothing; held up by its weight at its centre of mass it falls like one without gravity.
#[test]
fn a_thrown_body_needs_nothing() {
    let inertia =
        solaris_model::Inertia::Tensor(solaris_model::Matrix3::from_diagonal(&Vector3::new(0.4, 0.4, 0.7)));
    let figure = build([LinkSpec::root("body", Joint::free("root")).mass(3.0).inertia(inertia)]);
    // Torque-free symmetric top: L along the axis, precession = L/I₁, spin = L·cosθ·(1/I₃ − 1/I₁), with cosθ = 0.8.
    let (axis, momentum) = (Vector3::new(0.36, 0.48, 0.8), 1.2);
    let spin = momentum * 0.8 * (1.0 / 0.7 - 1.0 / 0.4);
    let record = positions(&figure, equally(300, 200.0), |t| {
        let turn =
            UnitQuaternion::new(axis * (momentum / 0.4 * t)) * UnitQuaternion::new(Vector3::z() * (spin * t));
        let place = Vector3::new(1.0, 2.0, -1.0) * t + GRAVITY * (t * t / 2.0);
        [place.as_slice(), turn.coords.as_slice()].concat()
    });
    let motion = complete(&figure, &record, None).expect("slow enough");
    let report = inverse_motion(&figure, GRAVITY, &motion, &[], InverseOptions::default()).expect("finite");
    let inside = &report.tau[40 * 6..260 * 6];
    assert!(
        inside.iter().all(|tau| tau.abs() < 1e-6),
        "{:?}",
        inside.iter().fold(0.0_f64, |a, b| a.max(b.abs()))
    );
    // At rest it needs its weight, and that is the residual.
    let still = positions(&figure, equally(3, 1.0), |_| vec![5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0]);
    let motion = complete(&figure, &still, None).expect("a record");
    let report = inverse_motion(&figure, GRAVITY, &motion, &[], InverseOptions::default()).expect("finite");
    assert!((report.residual.force_rms - 3.0 * 9.80665).abs() < 1e-12 && report.residual.moment < 1e-12);
    let held: Vec<(f64, Contact)> =
        (0..3).map(|i| (f64::from(i), push([0.0, 3.0 * 9.80665, 0.0], [5.2, 0.0, 0.0]))).collect();
    let options = InverseOptions::default();
    let report =
        inverse_motion(&figure, GRAVITY, &motion, &[forces(&["body"], &held)], options).expect("finite");
    assert!(report.residual.force < 1e-12 && (report.residual.moment - 0.2 * 3.0 * 9.80665).abs() < 1e-12);
}

/// Stands on both feet and shifts its weight.
struct Standing;

impl SupportLaw for Standing {
    fn support(&self, t: f64) -> Support {
        let share = 0.5 + 0.4 * (4.0 * t).sin();
        let foot = |share, x| FootSupport::level(share, Vector3::new(x, 0.0, 0.12 + 0.1 * (9.0 * t).sin()));
        Support { feet: [foot(share, 0.1), foot(1.0 - share, -0.1)], pivot: 1.4, force: None }
    }
}

fn swaying() -> (Figure, Motion) {
    let figure = human(1.75, 73.0).expect("an ordinary human");
    let (nq, time) = (figure.layout().nq(), equally(300, 100.0));
    let height = 0.95;
    let (mut q, mut v, mut a) = (Vec::new(), Vec::new(), Vec::new());
    for t in &time {
        for i in 0..nq {
            let (sine, cosine) = (3.0 * t + i as f64).sin_cos();
            q.push(0.02 * sine + if i == 1 { height } else { 0.0 });
            v.push(0.06 * cosine);
            // Forwards and back it sways more: the centre of pressure runs over the balls of the feet.
            a.push(if i == 2 { -2.0 * sine } else { -0.18 * sine });
        }
    }
    let motion = Motion::new(&figure, MotionInfo::on_earth(&figure, 100.0), time, [q, v, a]).expect("finite");
    (figure, motion)
}

fn completed(motion: &Motion) -> States {
    let rows = || 0..motion.len();
    States {
        time: motion.time().to_vec(),
        q: rows().flat_map(|row| motion.q(row).to_vec()).collect(),
        v: rows().flat_map(|row| motion.v(row).to_vec()).collect(),
        a: rows().flat_map(|row| motion.a(row).to_vec()).collect(),
        ..States::default()
    }
}

/// What `ground_reactions` has written to a motion comes back from its columns: feet and toes take over from each other
/// at the same frames.
#[test]
fn a_motion_with_its_contacts_gives_its_forces_back() {
    let (figure, mut motion) = swaying();
    ground_reactions(&figure, &mut motion, ["left_foot", "right_foot"], &Standing).expect("it stands");
    let record = |side: &str| MeasuredForce {
        links: vec![format!("{side}_foot"), format!("{side}_toes")],
        ball_and_tip: None,
        time: motion.time().to_vec(),
        samples: motion.contact(&format!("{side}_foot")).expect("written").samples.clone(),
    };
    let loads = ["left", "right"].map(record);
    let mut reports = Vec::new();
    let options = InverseOptions { passive: true, progress: Some(&mut |done| reports.push(done)) };
    let report = inverse_motion(&figure, GRAVITY, &completed(&motion), &loads, options).expect("finite");
    assert_eq!(reports, [300]);
    let scale = report.tau.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    let expected = (0..motion.len()).flat_map(|row| motion.tau(row).expect("written").to_vec());
    for (i, (ours, theirs)) in report.tau.iter().zip(expected).enumerate() {
        assert!((ours - theirs).abs() < 1e-12 * scale, "entry {i}: {ours} {theirs}");
    }
    assert!(report.residual.force < 1e-9 && report.residual.moment < 1e-9, "{:?}", report.residual);
    // The toes did take over, and the feet had it before.
    let toes = figure.layout().dof_index("left_toes.rx").expect("a toe joint");
    let felt: Vec<bool> = report.tau.iter().skip(toes).step_by(66).map(|tau| tau.abs() > 2.0).collect();
    assert!(felt.contains(&true) && felt.contains(&false), "{:?}", report.dofs[toes]);
}

#[test]
fn the_results_do_not_depend_on_the_number_of_threads() {
    let (figure, motion) = swaying();
    let motion = completed(&motion);
    let solve = || inverse_motion(&figure, GRAVITY, &motion, &[], InverseOptions::default()).expect("finite");
    let once = solve();
    assert_eq!(once, solve());
    let bits =
        |report: &solaris_analysis::InverseReport| report.tau.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
    let single = {
        // Row by row, each by itself.
        let rows = (0..motion.time.len()).flat_map(|row| {
            let cut = |column: &[f64]| column[row * 66..][..66].to_vec();
            let one = States {
                time: vec![motion.time[row]],
                q: cut(&motion.q),
                v: cut(&motion.v),
                a: cut(&motion.a),
                ..States::default()
            };
            bits(&inverse_motion(&figure, GRAVITY, &one, &[], InverseOptions::default()).expect("finite"))
        });
        rows.collect::<Vec<_>>()
    };
    assert_eq!(bits(&once), single);
}

#[test]
fn long_motions_report_progress_and_the_first_bad_row() {
    let figure = pendulum();
    let rows = 5000;
    let mut motion = States {
        time: equally(rows, 100.0),
        q: vec![0.5; rows],
        v: vec![0.0; rows],
        a: vec![0.0; rows],
        ..States::default()
    };
    let mut done = Vec::new();
    let options = InverseOptions { passive: true, progress: Some(&mut |frames| done.push(frames)) };
    inverse_motion(&figure, GRAVITY, &motion, &[], options).expect("finite");
    assert!(done.is_sorted() && done.len() > 1 && done.last() == Some(&rows), "{done:?}");
    motion.a[4000] = f64::NAN;
    motion.a[3000] = f64::INFINITY;
    let error =
        inverse_motion(&figure, GRAVITY, &motion, &[], InverseOptions::default()).expect_err("not finite");
    assert_eq!(error.to_string(), "a of 'pivot.rx' at 30 s is inf; it must be a finite number");
    motion.a.pop();
    let error = inverse_motion(&figure, GRAVITY, &motion, &[], InverseOptions::default());
    assert_eq!(error.expect_err("short").to_string(), "a has 4999 numbers; 5000 samples of 1 make 5000");
    let still = body(LinkSpec::root("rock", Joint::new("glued")));
    let empty = States { time: vec![0.0; 3], ..States::default() };
    let report =
        inverse_motion(&build([still]), GRAVITY, &empty, &[], InverseOptions::default()).expect("no dofs");
    assert!(report.tau.is_empty() && (report.residual.force - 3.0 * 9.80665).abs() < 1e-12);
}

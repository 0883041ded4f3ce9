//! A subject's walk, measured, and what another program makes of it; skipped where the data is not at hand.

use crate::pinned::{Pinned, file, numbers, say};
use crate::states::{States, inverse_motion};
use solaris_analysis::{Filter, InverseOptions, differentiate};
use solaris_io::{Table, record, sto};
use solaris_model::MeasuredForce;

fn worst(ours: &[f64], theirs: &[f64]) -> f64 {
    assert_eq!(ours.len(), theirs.len());
    ours.iter().zip(theirs).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Same tree, same states, same wrenches, twice other programs' torques.
#[test]
fn pinned_trees_need_the_torques_that_others_find() {
    for (name, tolerance) in [("gait10dof_pinned.json", 1e-6), ("gait2354_pinned.json", 1e-5)] {
        let Some(pinned) = Pinned::read(name) else { return };
        let found = |loads: &[MeasuredForce]| {
            let options = InverseOptions::default();
            let motion = pinned.motion();
            inverse_motion(&pinned.figure, pinned.gravity(), &motion, loads, options)
                .expect("finite states")
                .tau
        };
        let loaded = worst(&found(&pinned.wrenches()), &numbers(&pinned.json["tau_with_grf"]));
        let free = worst(&found(&[]), &numbers(&pinned.json["tau_no_external"]));
        say(&format!("{name}: {loaded:e} with, {free:e} N m without ground forces"));
        assert!(loaded < tolerance && free < tolerance, "{name}: {loaded:e} {free:e}");
    }
}

fn table(name: &str) -> Option<Table> {
    Some(sto::read(&file(name)?).expect("a table"))
}

fn filtered(pinned: &Pinned, motion: &Table, order: usize) -> States {
    let recorded = record::read(&pinned.figure, pinned.gravity(), motion).expect("all coordinates");
    let filter = Filter { cutoff: 6.0, order };
    States::of(&differentiate(&pinned.figure, &recorded.motion, Some(filter)).expect("equal steps").motion)
}

/// Greatest differences in the rows of a window (s).
fn within(time: &[f64], window: (f64, f64), ours: &[f64], theirs: &[f64]) -> f64 {
    let width = ours.len() / time.len();
    let rows = time.iter().enumerate().filter(|(_, t)| (window.0..=window.1).contains(*t));
    rows.map(|(row, _)| worst(&ours[row * width..][..width], &theirs[row * width..][..width]))
        .fold(0.0, f64::max)
}

/// The trees' own states: `scipy`'s filter of order 2 with 30 samples of padding and a spline with other ends. Inside,
/// ends do not matter.
#[test]
fn filter_and_spline_give_the_states_of_another_chain() {
    let cases = [
        ("gait10dof_pinned.json", "subject01_walk_ik_planar10.mot", (0.3, 2.2), [1e-7, 1e-5, 5e-5]),
        ("gait2354_pinned.json", "subject01_walk_ik_3d23.mot", (0.6, 1.4), [1e-7, 1e-5, 1e-3]),
    ];
    for (tree, motion, window, tolerances) in cases {
        let (Some(pinned), Some(motion)) = (Pinned::read(tree), table(motion)) else { return };
        let (ours, theirs) = (filtered(&pinned, &motion, 2), pinned.motion());
        let pairs = [(&ours.q, &theirs.q), (&ours.v, &theirs.v), (&ours.a, &theirs.a)];
        for (i, (ours, theirs)) in pairs.into_iter().enumerate() {
            let (inside, whole) = (within(&theirs_time(&pinned), window, ours, theirs), worst(ours, theirs));
            say(&format!("{tree}, derivative {i}: {inside:e} in {window:?} s, {whole:e} to the ends"));
            assert!(inside < tolerances[i], "{tree}, derivative {i}: {inside:e}");
        }
    }
}

fn theirs_time(pinned: &Pinned) -> Vec<f64> {
    numbers(&pinned.json["time"])
}

/// What the trunk needs does not depend on the knees: it tells whether filter and spline are `OpenSim`'s, to the ends of
/// the record.
#[test]
fn the_lumbar_moment_is_that_of_opensim() {
    let cases = [
        (
            "gait10dof_pinned.json",
            "subject01_walk_ik_planar10.mot",
            "opensim46_id_planar10.sto",
            3.5e-4,
            &["lumbar_extension"][..],
        ),
        (
            "gait2354_pinned.json",
            "subject01_walk_ik_3d23.mot",
            "opensim46_id_3d23.sto",
            3e-3,
            &["lumbar_extension", "lumbar_bending", "lumbar_rotation"],
        ),
    ];
    for (tree, motion, reference, tolerance, joints) in cases {
        let (Some(pinned), Some(motion), Some(grf)) =
            (Pinned::read(tree), table(motion), table("subject01_walk_grf.mot"))
        else {
            return;
        };
        let Some(reference) = table(reference) else { return };
        let loads = [("calcn_r", ""), ("calcn_l", "1_")].map(|(body, prefix)| {
            record::forces(&grf, &[pinned.carrier(body)], prefix).expect("its columns")
        });
        let motion = filtered(&pinned, &motion, 3);
        let options = InverseOptions::default();
        let report = inverse_motion(&pinned.figure, pinned.gravity(), &motion, &loads, options)
            .expect("finite states");
        let nv = pinned.figure.layout().nv();
        for (dof, name) in pinned.figure.layout().v_names().iter().enumerate() {
            let heading = [format!("{name}_moment"), format!("{name}_force")];
            let Some(column) = heading.iter().find_map(|name| reference.column(name)) else { continue };
            let ours: Vec<f64> = report.tau.iter().skip(dof).step_by(nv).copied().collect();
            let theirs: Vec<f64> = reference.values_of(column).collect();
            let squares: f64 = ours.iter().zip(&theirs).map(|(a, b)| (a - b).powi(2)).sum();
            let (rms, worst) = ((squares / ours.len() as f64).sqrt(), worst(&ours, &theirs));
            say(&format!("{tree} {name}: rms {rms:.2e}, greatest {worst:.2e}"));
            assert!(!joints.contains(&name.as_str()) || worst < tolerance, "{name}: {worst:e}");
        }
    }
}

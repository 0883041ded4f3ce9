//! Figures that sway and hop impossibly, shifted, and judged by inverse dynamics from their new states.

use crate::consistency::support::{GRAVITY, beyond, hull, say};
use crate::states::{Record, States, complete, ground_forces, make_consistent, shift_root};
use nalgebra::Vector3;
use solaris_analysis::ground::{BalanceFrame, ConsistencyOptions, ConsistencyOutcome, consistent};
use solaris_dynamics::Wrench;
use solaris_dynamics::{Tree, Workspace, center_of_mass, inverse_dynamics};
use solaris_model::{Base, Figure, FigureBuilder, Inertia, Joint, LinkSpec, human};
use std::f64::consts::PI;

/// Points of soles (m) in their links' frames.
type Soles = Vec<(usize, Vector3<f64>)>;

/// The balance of every frame, and the hull of its soles.
fn judge(figure: &Figure, states: &States, soles: &Soles) -> (Vec<BalanceFrame>, Vec<Vec<Vector3<f64>>>) {
    let tree = Tree::<f64>::new(figure, GRAVITY).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    let mut tau = vec![0.0; tree.nv()];
    let frame = |frame: usize| {
        let q = &states.q[frame * tree.nq()..][..tree.nq()];
        let (v, a) =
            (&states.v[frame * tree.nv()..][..tree.nv()], &states.a[frame * tree.nv()..][..tree.nv()]);
        inverse_dynamics(&tree, &mut workspace, q, v, a, &[], &mut tau).expect("a state");
        let wrench = workspace.base_wrench();
        let com = center_of_mass(&tree, &mut workspace, q).expect("a state");
        let place = |(link, point): &(usize, Vector3<f64>)| {
            let pose = workspace.pose(*link);
            pose.rotation * point + pose.translation
        };
        let outline = hull(&soles.iter().map(place).collect::<Vec<_>>());
        (BalanceFrame { force: wrench.force, moment: wrench.moment, com, ..BalanceFrame::default() }, outline)
    };
    (0..states.time.len()).map(frame).unzip()
}

/// What is impossible: how far (m) outside at worst, and the least normal force (N).
fn worst(balances: &[BalanceFrame], outlines: &[Vec<Vector3<f64>>], level: f64) -> (f64, f64) {
    let mut worst = (f64::NEG_INFINITY, f64::INFINITY);
    for (balance, outline) in balances.iter().zip(outlines) {
        worst.1 = worst.1.min(balance.force.y);
        let wrench = Wrench { force: balance.force, moment: balance.moment };
        let cop = wrench.center_of_pressure(&Vector3::y(), level);
        worst.0 = worst.0.max(cop.map_or(f64::INFINITY, |cop| beyond(outline, &cop)));
    }
    worst
}

fn moving(figure: &Figure, rate: f64, frames: usize, q: impl Fn(f64) -> Vec<f64>) -> States {
    let nv = figure.layout().nv();
    let time: Vec<f64> = (0..frames).map(|k| k as f64 / rate).collect();
    let record = Record {
        q: time.iter().flat_map(|&t| q(t)).collect(),
        v: vec![0.0; frames * nv],
        a: vec![0.0; frames * nv],
        known_v: vec![false; nv],
        known_a: vec![false; nv],
        time,
    };
    complete(figure, &record, None).expect("a motion")
}

fn becomes_possible(name: &str, figure: &Figure, rate: f64, mut states: States, soles: &Soles) {
    let level = judge(figure, &states, soles).1[0].iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
    let mass = figure.links().iter().map(solaris_model::Link::mass).sum::<f64>();
    let (balances, outlines) = judge(figure, &states, soles);
    let options = ConsistencyOptions { limit: f64::INFINITY, margin: 0.0, ..Default::default() };
    let found = consistent(rate, mass, &GRAVITY, level, &balances, &outlines, &options).expect("solved");
    let before = worst(&balances, &outlines, level);
    assert!(before.1 < -1.0 && found.before.pull > 1.0 && found.before.frames > 50, "{before:?}");
    let old = states.clone();
    shift_root(figure, &mut states, &found).expect("shifted");
    let (balances, outlines) = judge(figure, &states, soles);
    let after = worst(&balances, &outlines, level);
    say(&format!(
        "{name}: {} of {} frames at fault, outside {:.3} m, pull {:.0} N; after: outside {:.1e} m, least force {:.3} of the \
         weight; greatest shift {:.1} mm, {} iterations",
        found.before.frames,
        found.shift.len(),
        found.before.outside,
        found.before.pull,
        after.0,
        after.1 / (mass * 9.81),
        1e3 * found.greatest,
        found.iterations
    ));
    assert_eq!((found.outcome, found.after.frames), (ConsistencyOutcome::Reached, 0));
    assert!(after.0 < 1e-6, "outside by {}", after.0);
    assert!(after.1 > (0.01 - 1e-6) * mass * 9.81, "pressed with {}", after.1);
    // The centre of mass went with the root, and nothing else did anything.
    let moved = judge(figure, &old, soles).0.into_iter().zip(&balances).zip(&found.shift);
    for ((old, new), shift) in moved {
        assert!((new.com - old.com - shift).norm() < 1e-12);
    }
    let (nq, first) = (figure.layout().nq(), figure.layout().joints()[1].q);
    for (old, new) in old.q.chunks(nq).zip(states.q.chunks(nq)) {
        assert_eq!(old[first..], new[first..]);
    }
}

#[test]
fn a_person_that_sways_and_hops() {
    let figure = human(1.75, 73.0).expect("a person");
    let soles = figure.links().iter().enumerate().flat_map(|(link, of)| {
        let around = [Vector3::x(), -Vector3::x(), Vector3::z(), -Vector3::z()].map(|way| way * 0.04);
        of.sole().iter().flat_map(move |point| around.map(|way| (link, point.position + way)))
    });
    let slides: Vec<usize> = ["root.tx", "root.ty", "root.tz"]
        .map(|name| figure.layout().v_names().iter().position(|n| n == name).expect("a slide"))
        .to_vec();
    let nq = figure.layout().nq();
    let states = moving(&figure, 120.0, 400, |t| {
        let mut q: Vec<f64> = (0..nq).map(|k| 0.06 * (2.0 * PI * 1.1 * t + k as f64).sin()).collect();
        q[slides[0]] = 0.08 * (2.0 * PI * 0.9 * t).sin();
        q[slides[1]] = 1.0 + 0.03 * (2.0 * PI * 3.2 * t).sin();
        q[slides[2]] = 0.05 * (2.0 * PI * 0.6 * t).cos() + 0.5 * t;
        q
    });
    becomes_possible("person", &figure, 120.0, states, &soles.collect());
}

#[test]
fn a_free_body_with_an_arm() {
    let inertia = |x, y, z| Inertia::Tensor(solaris_model::Matrix3::from_diagonal(&Vector3::new(x, y, z)));
    let body = LinkSpec::root("body", Joint::new("root")).mass(20.0).inertia(inertia(0.6, 0.3, 0.5));
    let arm = LinkSpec::child("arm", "body", Joint::new("shoulder").rx().at(Vector3::new(0.2, 0.3, 0.0)))
        .mass(2.0)
        .com(Vector3::new(0.0, -0.3, 0.0))
        .inertia(inertia(0.02, 0.002, 0.02));
    let figure = FigureBuilder::new("buoy").link(body).link(arm).build().expect("valid");
    let figure = figure.on_base(Base::Free).expect("free");
    let corners = [[1.0, 1.0], [1.0, -1.0], [-1.0, -1.0], [-1.0, 1.0]];
    let soles = corners.map(|[x, z]: [f64; 2]| (0, Vector3::new(0.15 * x, -0.8, 0.1 * z))).to_vec();
    let states = moving(&figure, 100.0, 300, |t| {
        let turn = Vector3::new(0.1 * (5.0 * t).sin(), 0.8 * t, 0.12 * (4.0 * t).cos());
        let turn = solaris_model::UnitQuaternion::from_scaled_axis(turn);
        let mut q = vec![0.1 * (5.0 * t).sin(), 0.9 + 0.03 * (19.0 * t).cos(), 0.07 * (6.0 * t).cos()];
        q.extend(turn.coords.iter());
        q.push(0.7 * (7.0 * t).sin());
        q
    });
    becomes_possible("free body", &figure, 100.0, states, &soles);
}

#[test]
fn a_person_who_leans_too_far_is_moved_until_the_soles_bear() {
    use solaris_analysis::ground::{GroundOptions, Stance, Stances, soles};
    let (figure, gravity) =
        (solaris_model::human(1.75, 73.0).expect("a person"), Vector3::new(0.0, -9.80665, 0.0));
    let (rate, count, nv) = (100.0, 201, figure.layout().nv());
    // The whole body goes forwards and back at 2 Hz by 8 cm, the feet with it: 12 m/s² at the ends.
    let z = figure.layout().dof_index("root.tz").expect("a slide");
    let (mut q, mut v, mut a) = (vec![0.0; count * nv], vec![0.0; count * nv], vec![0.0; count * nv]);
    let time: Vec<f64> = (0..count).map(|k| k as f64 / rate).collect();
    let w = 4.0 * PI;
    for (k, t) in time.iter().enumerate() {
        q[k * nv + 1] = 0.98;
        (q[k * nv + z], v[k * nv + z]) = (0.08 * (w * t).sin(), 0.08 * w * (w * t).cos());
        a[k * nv + z] = -0.08 * w * w * (w * t).sin();
    }
    let mut states = States { time, q, v, a, ..States::default() };
    let soles = soles(&figure);
    let standing = (0..2).map(|foot| Stance { foot, start: 0.0, end: 2.0 }).collect();
    let stances =
        Stances { list: standing, belt: Vector3::zeros(), level: 0.0, footings: Vec::new(), method: "given" };
    let options = ConsistencyOptions { limit: f64::INFINITY, ..ConsistencyOptions::default() };
    let found = make_consistent(&figure, gravity, &mut states, &soles, &stances, &options).expect("moved");
    assert!(found.before.outside > 0.5 && found.before.frames > 50, "{:?}", found.before);
    assert!(
        found.after.outside < 1e-9 && found.after.pull == 0.0 && found.outcome == ConsistencyOutcome::Reached
    );
    assert!(found.greatest > 0.01 && found.greatest < 0.1, "{}", found.greatest);
    // What is found from the moved motion agrees, foot by foot.
    let options = GroundOptions { stances: Some(stances.clone()), ..GroundOptions::default() };
    let forces = ground_forces(&figure, gravity, &states, &soles, &options).expect("forces");
    assert!(forces.total.iter().all(|frame| frame.force.y > 0.0));
    // Nothing is left to do.
    let again = make_consistent(
        &figure,
        gravity,
        &mut states,
        &soles,
        &stances,
        &ConsistencyOptions { margin: 0.0, ..Default::default() },
    );
    assert!(again.expect("possible").greatest < 1e-12);
    let bare: Vec<_> =
        soles.iter().map(|sole| solaris_analysis::ground::Sole { width: None, ..sole.clone() }).collect();
    let refused =
        make_consistent(&figure, gravity, &mut states, &bare, &stances, &ConsistencyOptions::default());
    assert_eq!(
        refused.expect_err("no outline").to_string(),
        "sole 'left_foot' has no breadth, so it is not known what it stands on; give it a width"
    );
}

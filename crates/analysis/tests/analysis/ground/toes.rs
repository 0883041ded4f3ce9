//! Which link bears what acts on a sole that the figure itself does not have.

use crate::ground::support::{GRAVITY, person, steps, swaying};
use solaris_analysis::ground::{GroundForces, GroundOptions, Sole, ground_forces, soles};
use solaris_analysis::{Completed, InverseError, InverseOptions, LoadError, inverse_motion};
use solaris_dynamics::{Tree, Workspace, velocities};
use solaris_model::{Figure, ForceRecord, SolePart, Vector3};

fn forces(figure: &Figure, states: &Completed, soles: &[Sole]) -> GroundForces {
    let options = GroundOptions { stances: Some(steps()), ..GroundOptions::default() };
    ground_forces(figure, GRAVITY, states, soles, &options).expect("forces")
}

fn torques(figure: &Figure, states: &Completed, loads: &[ForceRecord]) -> Vec<f64> {
    inverse_motion(figure, GRAVITY, states, loads, InverseOptions::default()).expect("torques").tau
}

/// The figure's own soles under names that it does not give them: as if they came from a file.
fn told(figure: &Figure) -> Vec<Sole> {
    let named = |sole: Sole| Sole { name: format!("told {}", sole.name), ..sole };
    soles(figure).into_iter().map(named).collect()
}

/// The person's feet have the ball of their toes, with all joints at zero.
#[test]
fn soles_that_are_told_carry_as_the_figures_own() {
    let figure = person();
    let states = swaying(&figure, 101, 0.1);
    let (own, told) = (forces(&figure, &states, &soles(&figure)), forces(&figure, &states, &told(&figure)));
    let (one, other) = (own.records(), told.records());
    assert_eq!((one[0].links.len(), one[0].ball_and_tip, &one[0].links), (2, None, &other[0].links));
    let [ball, _] = other[0].ball_and_tip.expect("told");
    let toes = figure.link_index(&one[0].links[1]).expect("toes");
    let theirs = figure.links()[toes].sole_point(SolePart::Ball).expect("a ball");
    assert!((ball - theirs).norm() < 1e-15, "{ball} {theirs}");
    let (one, other) = (torques(&figure, &states, &one), torques(&figure, &states, &other));
    assert!(one.iter().zip(&other).all(|(one, other)| (one - other).abs() < 1e-9));
}

/// Beside the foot alone: the toes' joint does the work of the whole wrench where the centre of pressure has passed the ball, and
/// no other joint knows.
#[test]
fn what_the_links_of_a_foot_bear_is_the_whole() {
    let figure = person();
    let states = swaying(&figure, 101, 0.1);
    let told = told(&figure);
    let found = forces(&figure, &states, &told);
    let records = found.records();
    let foot = |record: &ForceRecord| ForceRecord { links: record.links[..1].to_vec(), ..record.clone() };
    let feet: Vec<_> = records.iter().map(foot).collect();
    let (with, without) = (torques(&figure, &states, &records), torques(&figure, &states, &feet));
    let tree = Tree::<f64>::new(&figure, GRAVITY).expect("a tree");
    let (mut workspace, nv) = (Workspace::new(&tree), tree.nv());
    let mut counts = [0, 0];
    for row in 0..states.time.len() {
        let [q, v] = [&states.q, &states.v].map(|column| &column[row * nv..][..nv]);
        velocities(&tree, &mut workspace, q, v).expect("a state");
        let mut change: Vec<f64> =
            with[row * nv..].iter().zip(&without[row * nv..]).take(nv).map(|(w, o)| w - o).collect();
        for (sole, track) in told.iter().zip(&found.contacts) {
            let (toes, contact) = (sole.toes.expect("toes"), &track.samples[row]);
            let pose = workspace.pose(toes);
            let ball = figure.links()[toes].sole_point(SolePart::Ball).expect("a ball");
            let [ball, tip] = [ball, &sole.tip].map(|point| pose.transform(point));
            let past = contact.force != Vector3::zeros() && (contact.cop - ball).dot(&(tip - ball)) > 0.0;
            let moment = contact.moment - pose.translation.cross(&contact.force);
            let turning = workspace.velocity(toes).angular - workspace.velocity(sole.foot).angular;
            let at = figure.layout().joints()[toes];
            let own = &mut change[at.v..at.v + at.nv];
            let power: f64 = own.iter().zip(&v[at.v..]).map(|(tau, v)| tau * v).sum();
            let expected = if past { -moment.dot(&turning) } else { 0.0 };
            assert!((power - expected).abs() < 1e-9, "row {row}: {power} W, {expected} W");
            own.fill(0.0);
            counts[usize::from(past)] += 1;
        }
        assert!(change.iter().all(|change| change.abs() < 1e-9), "row {row}: {change:?}");
    }
    assert!(counts.iter().all(|count| *count > 5), "{counts:?} behind the ball and past it");
}

#[test]
fn points_that_say_nothing_are_refused() {
    let figure = person();
    let states = swaying(&figure, 11, 0.1);
    let record = forces(&figure, &states, &told(&figure)).records().swap_remove(0);
    for points in [[Vector3::zeros(); 2], [Vector3::zeros(), Vector3::repeat(f64::NAN)]] {
        let load = ForceRecord { ball_and_tip: Some(points), ..record.clone() };
        let refused = inverse_motion(&figure, GRAVITY, &states, &[load], InverseOptions::default());
        let error = refused.expect_err("no direction");
        assert!(
            matches!(&error, InverseError::Load(LoadError::Points { toes, .. }) if toes == "left_toes"),
            "{error}"
        );
    }
    // Toes that end where they begin leave all to the foot.
    let mut soles = told(&figure);
    soles[0].tip = record.ball_and_tip.expect("told")[0];
    assert_eq!(forces(&figure, &states, &soles).records()[0].links, ["left_foot"]);
}

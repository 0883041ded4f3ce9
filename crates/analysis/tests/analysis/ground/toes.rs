//! Which link bears what acts on a sole that the figure itself does not have.

use crate::ground::support::{GRAVITY, person, steps, swaying};
use crate::states::{States, ground_forces, inverse_loaded, inverse_motion};
use solaris_analysis::ground::{GroundForces, GroundOptions, Sole, soles};
use solaris_analysis::{InverseOptions, LoadError};
use solaris_dynamics::{Tree, Workspace, forward_kinematics, velocities};
use solaris_model::{ContactTrack, Figure, MeasuredForce, SolePart, Vector3};

fn forces(figure: &Figure, states: &States, soles: &[Sole]) -> GroundForces {
    let options = GroundOptions { stances: Some(steps()), ..GroundOptions::default() };
    ground_forces(figure, GRAVITY, states, soles, &options).expect("forces")
}

fn torques(figure: &Figure, states: &States, loads: &[MeasuredForce]) -> Vec<f64> {
    inverse_motion(figure, GRAVITY, states, loads, InverseOptions::default()).expect("torques").tau
}

/// What was found, on the feet's links alone.
fn on_feet(figure: &Figure, soles: &[Sole], found: &GroundForces) -> Vec<MeasuredForce> {
    let record = |(sole, track): (&Sole, &ContactTrack)| MeasuredForce {
        links: vec![figure.links()[sole.foot].name().to_owned()],
        ball_and_tip: None,
        time: found.total.iter().map(|frame| frame.time).collect(),
        samples: track.samples.clone(),
    };
    soles.iter().zip(&found.contacts).map(record).collect()
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
    let torques = |found: &GroundForces| inverse_loaded(&figure, GRAVITY, &states, &found.loads()).tau;
    let (one, other) = (torques(&own), torques(&told));
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
    let with = inverse_loaded(&figure, GRAVITY, &states, &found.loads()).tau;
    let without = torques(&figure, &states, &on_feet(&figure, &told, &found));
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
    let soles = told(&figure);
    let found = forces(&figure, &states, &soles);
    let mut record = on_feet(&figure, &soles, &found).swap_remove(0);
    record.links.push("left_toes".to_owned());
    for points in [[Vector3::zeros(); 2], [Vector3::zeros(), Vector3::repeat(f64::NAN)]] {
        let load = MeasuredForce { ball_and_tip: Some(points), ..record.clone() };
        let refused = inverse_motion(&figure, GRAVITY, &states, &[load], InverseOptions::default());
        let error = refused.expect_err("no direction");
        let is_named =
            matches!(error.downcast_ref(), Some(LoadError::Points { toes, .. }) if toes == "left_toes");
        assert!(is_named, "{error}");
    }
}

#[test]
fn toes_that_end_where_they_begin_leave_all_to_the_foot() {
    let figure = person();
    let states = swaying(&figure, 101, 0.1);
    let mut soles = told(&figure);
    let tree = Tree::<f64>::new(&figure, GRAVITY).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    forward_kinematics(&tree, &mut workspace, &vec![0.0; tree.nq()]).expect("a state");
    for sole in &mut soles {
        // The ball as the toes' link sees it, to the last digit.
        let (ball, toes) =
            (workspace.pose(sole.foot).transform(&sole.ball), workspace.pose(sole.toes.expect("toes")));
        sole.tip = toes.rotation.transpose() * (ball - toes.translation);
    }
    let found = forces(&figure, &states, &soles);
    let with = inverse_loaded(&figure, GRAVITY, &states, &found.loads()).tau;
    let feet = torques(&figure, &states, &on_feet(&figure, &soles, &found));
    assert!(with == feet, "toes bear something");
}

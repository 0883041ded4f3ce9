//! The law that leaving out changes nothing but by rounding.

use super::{Scene, curve, largest, rate};
use crate::body::random::Random;
use crate::drive::path::Path;
use crate::element::{Anchor, PointSpring};
use crate::failure::SetupError;
use crate::phase::{Phase, Role, Watched};
use crate::simulation::Simulation;
use crate::time::System;
use approx::assert_relative_eq;
use nalgebra::Vector3;
use solaris_dynamics::DynamicsError;
use solaris_model::{Curve, Figure, FigureBuilder, FuseError, Joint, LinkSpec, human};
use solaris_profiles::Clip;

#[test]
fn leaving_out_changes_no_result_beyond_rounding() {
    let (mut dropped, mut fused) = (0, 0);
    for seed in 0..200 {
        let scene = Scene::random(&mut Random(1000 + seed));
        let (mut whole, mut reduced) = (scene.phase(false), scene.phase(true));
        let y = whole.pack(&scene.q, &scene.v, 0.0, 0.0);
        let (mut expected, mut found) = (rate(&mut whole, 0.3, &y), rate(&mut reduced, 0.3, &y));
        // Work and heat are those of what is left.
        let end = whole.accounts();
        expected.truncate(end);
        found.truncate(end);
        let scale = 1.0 + largest(&expected);
        for (found, expected) in found.iter().zip(&expected) {
            assert_relative_eq!(found, expected, epsilon = 1e-12 * scale);
        }
        let n = scene.roles.len();
        let (mut a, mut full) = (vec![f64::NAN; n], vec![f64::NAN; n]);
        reduced.accelerations(0.3, &y, &mut a).expect("a state with inertia");
        whole.accelerations(0.3, &y, &mut full).expect("a state with inertia");
        for (found, expected) in a.iter().zip(&full) {
            assert_relative_eq!(found, expected, epsilon = 1e-12 * scale);
        }
        assert!(whole.report.dropped.is_empty() && whole.report.fused.is_empty());
        let links = scene.simulation.figure.links().len();
        dropped += usize::from(!reduced.report.dropped.is_empty() && reduced.report.dropped.len() < links);
        fused += usize::from(!reduced.report.fused.is_empty());
    }
    assert!(dropped >= 30 && fused >= 100, "{dropped} scenes with dropped links, {fused} with fused ones");
}

/// The force that holds a degree of freedom is right though links that it carries would be left out.
#[test]
fn the_force_that_holds_something_needs_all_that_it_carries() {
    let mut seen = 0;
    for seed in 0..200 {
        let scene = Scene::random(&mut Random(2000 + seed));
        let layout = scene.simulation.figure.layout();
        let held = (0..scene.roles.len())
            .filter(|dof| scene.roles[*dof] == Role::Prescribed && layout.coordinate(*dof).is_some());
        let watched: Vec<Watched> = held.map(|dof| Watched::Hold { dof }).collect();
        let (mut whole, mut reduced) = (scene.phase(false), scene.phase(true));
        let before = reduced.report.dropped.len();
        let y = whole.pack(&scene.q, &scene.v, 0.0, 0.0);
        let mut values = [vec![f64::NAN; watched.len()], vec![f64::NAN; watched.len()]];
        for (phase, values) in [&mut whole, &mut reduced].into_iter().zip(&mut values) {
            phase.watch(watched.clone(), Vec::new()).expect("valid");
            phase.event_values(0.3, &y, values);
        }
        let [expected, found] = values;
        let scale = 1.0 + largest(&expected);
        for (found, expected) in found.iter().zip(&expected) {
            assert_relative_eq!(found, expected, epsilon = 1e-12 * scale);
        }
        assert_eq!(reduced.is_dynamic(), !watched.is_empty() || scene.roles.contains(&Role::Dynamic));
        seen += usize::from(reduced.report.dropped.len() < before);
    }
    assert!(seen >= 20, "{seen} scenes had to take links back");
}

fn ann() -> Figure {
    human(1.65, 58.0).expect("a valid human")
}

/// One arm is loose, everything else follows curves: legs, head and the other arm are dropped.
#[test]
fn a_loose_arm_needs_only_what_carries_it() {
    let figure = ann();
    let names = figure.layout().v_names();
    let role = |name: &String| if name.starts_with("left_elbow") { Role::Dynamic } else { Role::Prescribed };
    let roles: Vec<Role> = names.iter().map(role).collect();
    let simulation = Simulation::new(&figure, Vector3::new(0.0, -9.81, 0.0));
    let phase = Phase::with(&simulation, &roles, &simulation.q, true).expect("valid");
    let report = &phase.report;
    assert!(report.dynamic.iter().all(|name| name.starts_with("left_elbow")));
    for link in ["left_foot", "right_thigh", "head", "right_hand"] {
        assert!(report.dropped.iter().any(|name| name == link), "{link} in {:?}", report.dropped);
    }
    assert!(!report.dropped.iter().any(|name| name == "left_hand" || name == "left_upper_arm"));
    let total =
        |operations: &solaris_dynamics::scalar::Operations| operations.multiplications + operations.additions;
    let (full, left) = (&report.operations_of_all, &report.operations);
    assert!(total(left) > 0 && 2 * total(left) < total(full), "{full:?} {left:?}");
    assert!(report.fused.is_empty() && report.omitted.iter().any(|text| text.starts_with("contact")));
}

#[test]
fn without_anything_to_move_nothing_is_computed() {
    let figure = ann();
    let simulation = Simulation::new(&figure, Vector3::new(0.0, -9.81, 0.0));
    let roles = vec![Role::Prescribed; figure.layout().nv()];
    let mut phase = Phase::with(&simulation, &roles, &simulation.q, true).expect("valid");
    assert!(!phase.is_dynamic() && phase.len() == 2);
    assert_eq!(phase.report.dropped.len(), figure.links().len());
    assert_eq!(phase.report.operations, solaris_dynamics::scalar::Operations::default());
    assert!(rate(&mut phase, 0.0, &[1.0, 2.0]).iter().all(|rate| *rate == 0.0));
    assert_eq!(phase.condition_beyond(0.0, &[1.0, 2.0], 0.0).expect("nothing to fail"), None);
    assert!(phase.energy(0.0, &[1.0, 2.0]).expect("nothing to fail").total() == 0.0);
}

/// A spring from a loose arm to a foot keeps the leg; one between two dropped links does not keep them.
#[test]
fn springs_keep_what_they_hang_from() {
    let figure = ann();
    let mut simulation = Simulation::new(&figure, Vector3::zeros());
    let end = |name: &str| Anchor { link: figure.link_index(name), point: Vector3::zeros() };
    let spring = |a: &str, b: &str| PointSpring {
        between: [end(a), end(b)],
        stiffness: 10.0,
        damping: 0.0,
        rest: 0.1,
    };
    simulation.add_spring(spring("left_hand", "left_foot")).expect("valid");
    simulation.add_spring(spring("right_hand", "head")).expect("valid");
    let names = figure.layout().v_names();
    let role = |name: &String| if name.starts_with("left_elbow") { Role::Dynamic } else { Role::Prescribed };
    let roles: Vec<Role> = names.iter().map(role).collect();
    let phase = Phase::with(&simulation, &roles, &simulation.q, true).expect("valid");
    let dropped = |link: &str| phase.report.dropped.iter().any(|name| name == link);
    assert!(!dropped("left_foot") && dropped("right_hand") && dropped("head"));
    let omitted = &phase.report.omitted;
    assert!(omitted.iter().any(|text| text.starts_with("springs between points: 1 of 2")), "{omitted:?}");
}

/// `rail`, with `a` sliding on it; `b` slides on `a` and follows it: y = x²; `c` swings from `b`.
fn followers() -> Figure {
    let curve = Curve::Polynomial(vec![0.0, 0.0, 1.0]);
    FigureBuilder::new("followers")
        .link(LinkSpec::root("a", Joint::new("x").tx()).mass(1.0))
        .link(LinkSpec::child("b", "a", Joint::new("y").ty().following("x", curve)).mass(1.0))
        .link(LinkSpec::child("c", "b", Joint::new("swing").rz()).mass(1.0).com(Vector3::new(0.0, -1.0, 0.0)))
        .build()
        .expect("valid")
}

#[test]
fn followers_follow_the_curves_of_their_leaders() {
    let figure = followers();
    let simulation = Simulation::new(&figure, Vector3::zeros());
    // The role of the follower does not count.
    let roles = [Role::Prescribed, Role::Still, Role::Dynamic];
    let mut phase = Phase::with(&simulation, &roles, &[0.5, 0.0, 0.0], true).expect("valid");
    let path = Path::Along(Clip::new(curve(1.0, [0.5, 2.0, 3.0], [0.0; 3])));
    phase.set_path(0, path.clone());
    phase.set_path(1, path);
    let y = [0.0, 0.0, 0.0, 0.0];
    let (mut q, mut v, mut a) = ([0.0; 3], [0.0; 3], [0.0; 3]);
    phase.unpack(0.0, &y, &mut q, &mut v);
    phase.accelerations(0.0, &y, &mut a).expect("finite");
    assert_relative_eq!(q[1], 0.25, epsilon = 1e-15);
    assert_relative_eq!(v[1], 2.0, epsilon = 1e-14);
    // 2·x·ẍ + 2·ẋ²
    assert_relative_eq!(a[1], 11.0, epsilon = 1e-13);
    // Hanging 1 m below, the bob is left behind: 3 m/s² along x, seen from the end of a thread of 1 m.
    assert_relative_eq!(a[2], -3.0, epsilon = 1e-13);
}

#[test]
fn what_cannot_be_computed_is_refused() {
    let simulation = Simulation::new(&followers(), Vector3::zeros());
    let follower = Phase::with(&simulation, &[Role::Dynamic; 3], &[0.0; 3], true).err();
    assert!(matches!(follower, Some(SetupError::Dynamics(DynamicsError::Follower { .. }))), "{follower:?}");
    let ball = LinkSpec::root("top", Joint::ball("pivot")).mass(1.0);
    let figure = FigureBuilder::new("top").link(ball).build().expect("valid");
    let simulation = Simulation::new(&figure, Vector3::zeros());
    let roles = [Role::Dynamic, Role::Dynamic, Role::Still];
    let part = Phase::with(&simulation, &roles, &simulation.q, true).err();
    assert!(
        matches!(part, Some(SetupError::Fuse(FuseError::PartOfJoint { count: 1, all: 3, .. }))),
        "{part:?}"
    );
    assert!(Phase::with(&simulation, &roles[..2], &simulation.q, true).is_err());
}

//! What a walker asks of the ground and of its joints, against the momentum of its links by differences of frames.

use crate::driven::{Driver, person};
use nalgebra::Vector3;
use solaris_dynamics::{Tree, Workspace, Wrench, inverse_dynamics};
use solaris_gait::{Command, LiveError, Walker};
use solaris_model::Contact;

const RATE: f64 = 1000.0;

/// Of a script: the forces of every frame, and what differences of the frames before and after say.
fn asked(script: &[(Command, f64)]) -> Vec<([Contact; 2], Vector3<f64>)> {
    let figure = person(1.75);
    let weight = figure.mass() * 9.80665;
    let mut driver = Driver::new(&figure, RATE).keeping();
    let (mut tau, mut all, mut held) = (vec![0.0; figure.layout().nv()], Vec::new(), 0);
    for (command, time) in script {
        for _ in 0..(time * RATE) as usize {
            driver.go(command, 1.0 / RATE);
            let contacts = driver.walker.forces(&mut tau).expect("forces");
            let root = tau[..6].iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            if contacts.iter().all(|foot| foot.force.y <= 0.0) {
                // The ground would have to pull, as a leg that is nearly straight jerks.
                held += 1;
            } else {
                assert!(root < 1e-9 * weight, "{root} at {}", driver.time());
            }
            all.push(contacts);
        }
    }
    assert!(held * 300 < all.len(), "{held} of {} frames would have to be held down", all.len());
    // Differences about the middle of three frames; those of a frame reach back by three milliseconds.
    let forces = driver.pressures().into_iter().map(|(_, force, _)| force * weight);
    all.into_iter().skip(1).zip(forces).collect()
}

#[test]
fn the_feet_bear_what_the_motion_asks_for() {
    let weight = person(1.75).mass() * 9.80665;
    for (name, script) in [
        ("a walk and a stop", vec![(Command::velocity(0.0, 1.2), 4.0), (Command::stop(), 3.0)]),
        ("a bend", vec![(Command::velocity(0.0, 1.0), 2.0), (Command::velocity(1.0, 0.2), 3.0)]),
    ] {
        let all = asked(&script);
        let mut apart: Vec<f64> = all
            .iter()
            .map(|(contacts, force)| (contacts[0].force + contacts[1].force - force).norm() / weight)
            .collect();
        apart.sort_by(f64::total_cmp);
        let [median, nearly_all] = [0.5, 0.98].map(|part| apart[(part * (apart.len() - 1) as f64) as usize]);
        println!("{name}: off by {median:.1e} of the weight, 98 % of frames by less than {nearly_all:.1e}");
        // The motion's own second derivatives jump where pieces meet.
        assert!(median < 1e-3 && nearly_all < 0.1, "{name}: {median} {nearly_all}");
        // No foot pulls, one that is in the air bears nothing, and whoever stands bears the weight.
        assert!(all.iter().all(|(contacts, _)| contacts.iter().all(|foot| foot.force.y >= 0.0)));
        let single =
            all.iter().filter(|(contacts, _)| contacts.iter().any(|foot| foot.force.y == 0.0)).count();
        assert!(single * 3 > all.len(), "{name}: {single} of {}", all.len());
    }
    let all = asked(&[(Command::stop(), 1.0)]);
    for (contacts, _) in &all {
        for foot in contacts {
            assert!((foot.force.y - 0.5 * weight).abs() < 0.02 * weight, "{foot:?}");
        }
    }
}

/// A push is one more force of the world: the ground gives the rest, and joints of another code of the same frame agree.
#[test]
fn a_push_is_borne_by_the_feet_and_the_joints() {
    let figure = person(1.75);
    let mut walker = Walker::new(&figure).expect("a walker");
    let tree: Tree<f64> = Tree::new(&figure, Vector3::new(0.0, -9.80665, 0.0)).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    let n = figure.layout().nv();
    let [mut tau, mut other, mut v, mut a] = [(); 4].map(|()| vec![0.0; n]);
    walker.push("thorax", Vector3::new(0.0, 0.1, 0.0), Vector3::new(40.0, 0.0, -30.0)).expect("a push");
    for _ in 0..200 {
        walker.step(1.0 / 60.0, &Command::velocity(0.0, 1.0)).expect("a frame");
    }
    let contacts = walker.forces(&mut tau).expect("forces");
    walker.derivatives(&mut v, &mut a).expect("slices");
    let push = walker.push_felt().expect("pushed");
    let q = walker.configuration();
    // Without the ground the root bears what the feet bear.
    inverse_dynamics(&tree, &mut workspace, q, &v, &a, &[push], &mut other).expect("a state");
    let base: Wrench<f64> = workspace.base_wrench();
    let sum = contacts[0].force + contacts[1].force;
    let moment = contacts[0].moment + contacts[1].moment;
    assert!((sum - base.force).norm() < 1e-9 * base.force.norm(), "{sum} {}", base.force);
    assert!((moment - base.moment).norm() < 1e-9 * base.moment.norm(), "{moment} {}", base.moment);
    // What hangs on the trunk does not know of the ground.
    let dof = |name: &str| figure.layout().dof_index(name).expect("a dof");
    for name in ["left_shoulder.rx", "neck.rx", "right_elbow.rx"] {
        assert!((tau[dof(name)] - other[dof(name)]).abs() < 1e-9, "{name}");
    }
    assert!((tau[dof("left_hip.rx")] - other[dof("left_hip.rx")]).abs() > 1.0);
    assert_eq!(walker.forces(&mut tau[1..]), Err(LiveError::Length { given: n - 1, wanted: n }));
}

//! Walkers that are pushed: they give way, step along and come to rest, and keep what every walk keeps.

use crate::driven::{Driver, person};
use crate::live_random::{command, holds};
use crate::random::Random;
use crate::support::Walked;
use nalgebra::Vector3;
use solaris_dynamics::{Tree, Workspace, potential_energy};
use solaris_gait::{Command, Walker};
use solaris_model::Figure;

const FRAME: f64 = 1.0 / 60.0;

/// Frames under a command, and the configuration after them.
fn go(walker: &mut Walker, command: &Command, seconds: f64) -> Vec<f64> {
    for _ in 0..(seconds / FRAME).round() as usize {
        walker.step(FRAME, command).expect("a frame");
    }
    walker.configuration().to_vec()
}

/// Where a point of a link is.
fn place(figure: &Figure, q: &[f64], link: &str, at: Vector3<f64>) -> Vector3<f64> {
    let (place, turn) = Walked::poses(figure, q)[figure.link_index(link).expect("a link")];
    place + turn * at
}

/// What a force on a point does about a coordinate: by differences of the point's place.
fn moment(
    figure: &Figure,
    q: &[f64],
    (link, at): (&str, Vector3<f64>),
    k: usize,
    force: Vector3<f64>,
) -> f64 {
    let h = 1e-6;
    let [before, after] = [-h, h].map(|h| {
        let mut q = q.to_vec();
        q[k] += h;
        place(figure, &q, link, at)
    });
    force.dot(&(after - before)) / (2.0 * h)
}

#[test]
fn who_stands_sways_under_a_little_push_and_steps_along_with_a_large_one() {
    let figure = person(1.75);
    let chest = Vector3::new(0.0, 0.1, 0.0);
    for (force, steps) in [
        (Vector3::z() * 8.0, false),
        (Vector3::x() * -7.0, false),
        (Vector3::z() * 60.0, true),
        (Vector3::z() * -60.0, true),
        (Vector3::x() * 80.0, true),
        (Vector3::new(-70.0, 0.0, 50.0), true),
    ] {
        let mut driver = Driver::new(&figure, 60.0);
        driver.go(&Command::stop(), 1.0);
        let before = driver.walker.place();
        driver.walker.push("thorax", chest, force).expect("a push");
        driver.go(&Command::stop(), 0.6);
        driver.walker.let_go();
        driver.go(&Command::stop(), 6.0);
        let after = driver.walker.place();
        let way = [after[0] - before[0], after[1] - before[1]];
        let along = (way[0] * force.x + way[1] * force.z) / force.norm();
        assert!(driver.walker.is_standing(), "{force:?}");
        if steps {
            assert!(along > 0.05 && along < 1.5, "{force:?}: {along} m");
            // Nobody turns to where he is pushed.
            assert!(driver.walker.heading().abs() < 1e-9, "{}", driver.walker.heading());
        } else {
            assert!(along.abs() < 1e-9, "{force:?}: {along} m");
        }
        holds(&driver.found, 1.75, &format!("{force:?}"));
    }
}

#[test]
fn who_walks_is_driven_aside_and_goes_on_as_told() {
    let figure = person(1.75);
    let walk = Command::velocity(0.0, 1.2);
    let mut walker = Walker::new(&figure).expect("a walker");
    go(&mut walker, &walk, 4.0);
    let mut alone = walker.clone();
    walker.push("thorax", Vector3::zeros(), Vector3::new(90.0, 0.0, 0.0)).expect("a push");
    go(&mut walker, &walk, 1.0);
    walker.let_go();
    go(&mut walker, &walk, 6.0);
    go(&mut alone, &walk, 7.0);
    let aside = walker.place()[0] - alone.place()[0];
    assert!(aside > 0.1 && aside < 0.6, "{aside}");
    let [x, z] = walker.velocity();
    assert!(x.abs() < 0.02 && (z - 1.2).abs() < 0.02, "{x} {z}");
    // From behind it is faster for a while, and no command asks for it.
    walker.push("pelvis", Vector3::zeros(), Vector3::new(0.0, 0.0, 50.0)).expect("a push");
    go(&mut walker, &walk, 2.0);
    assert!(walker.velocity()[1] > 1.4, "{:?}", walker.velocity());
}

/// Held long, every joint of the trunk has given as far as its own moment bends it, and those of the head hardly where the chest is pushed.
#[test]
fn joints_give_by_the_moments_of_the_force_and_never_far() {
    let figure = person(1.75);
    let names = figure.layout().q_names();
    let still = {
        let mut walker = Walker::new(&figure).expect("a walker");
        go(&mut walker, &Command::stop(), 1.0)
    };
    let (at, force) = (Vector3::new(0.02, 0.2, 0.1), Vector3::new(-3.0, 1.0, 5.0));
    let mut walker = Walker::new(&figure).expect("a walker");
    go(&mut walker, &Command::stop(), 1.0);
    walker.push("thorax", at, force).expect("a push");
    let bent = go(&mut walker, &Command::stop(), 3.0);
    let mut compliance = None;
    for (k, name) in names.iter().enumerate() {
        let given = bent[k] - still[k];
        let known = ["lumbar", "thorax", "abdomen"].iter().any(|joint| name.starts_with(joint));
        if !known {
            assert!(given.abs() < 1e-12, "{name}: {given}");
            continue;
        }
        let moment = moment(&figure, &bent, ("thorax", at), k, force);
        if moment.abs() < 1e-3 {
            continue;
        }
        let one = given / moment;
        let first = *compliance.get_or_insert(one);
        // 12 N bend a trunk in proportion.
        assert!(one > 0.0 && (one / first - 1.0).abs() < 2e-3, "{name}: {one} {first}");
    }
    assert!(compliance.is_some());
    // 700 N bend it no farther than 10° a joint, and let go it stands as before.
    walker.push("head", Vector3::new(0.0, 0.2, 0.0), Vector3::new(0.0, 0.0, 700.0)).expect("a push");
    let bent = go(&mut walker, &Command::stop(), 0.5);
    for (k, name) in
        names.iter().enumerate().filter(|(_, name)| name.starts_with("neck") || name.starts_with("head"))
    {
        assert!((bent[k] - still[k]).abs() < 0.35, "{name}");
    }
    walker.let_go();
    let after = go(&mut walker, &Command::stop(), 12.0);
    let upper = |name: &str| {
        ["lumbar", "thorax", "abdomen", "neck", "head"].iter().any(|joint| name.starts_with(joint))
    };
    for (k, name) in names.iter().enumerate().filter(|(_, name)| upper(name)) {
        assert!((after[k] - still[k]).abs() < 1e-3, "{name}: {} {}", after[k], still[k]);
    }
}

/// An arm that hangs loose is drawn to where its weight and the pull are in balance, and the walker comes along.
#[test]
fn a_hand_that_hangs_is_drawn_along() {
    let figure = person(1.75);
    let names = figure.layout().q_names();
    let tree: Tree<f64> = Tree::new(&figure, Vector3::new(0.0, -9.80665, 0.0)).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    let mut walker = Walker::new(&figure).expect("a walker");
    for joint in ["left_shoulder", "left_elbow", "left_wrist"] {
        walker.loosen(joint).expect("a joint");
    }
    go(&mut walker, &Command::stop(), 6.0);
    let (at, force) = (Vector3::new(0.0, -0.05, 0.0), Vector3::new(2.0, 0.0, 6.0));
    let before = place(&figure, walker.configuration(), "left_hand", at);
    walker.push("left_hand", at, force).expect("a push");
    let q = go(&mut walker, &Command::stop(), 25.0);
    let moved = place(&figure, &q, "left_hand", at) - before;
    assert!(moved.z > 0.1, "{moved:?}");
    for (k, name) in names.iter().enumerate().filter(|(_, name)| name.starts_with("left_shoulder")) {
        let h = 1e-5;
        let [low, high] = [-h, h].map(|h| {
            let mut q = q.clone();
            q[k] += h;
            potential_energy(&tree, &mut workspace, &q).expect("a state")
        });
        let (weight, pull) = ((high - low) / (2.0 * h), moment(&figure, &q, ("left_hand", at), k, force));
        assert!((weight - pull).abs() < 0.05, "{name}: {weight} N m of weight, {pull} N m of the pull");
    }
    // A stronger pull takes the walker along.
    let place = walker.place();
    walker.push("left_hand", at, Vector3::new(0.0, 0.0, 40.0)).expect("a push");
    go(&mut walker, &Command::stop(), 4.0);
    assert!(walker.place()[1] - place[1] > 0.5, "{:?}", walker.place());
}

#[test]
fn a_push_is_told_with_its_moment_and_a_clone_goes_on_to_the_same_bits() {
    let figure = person(1.75);
    let mut walker = Walker::new(&figure).expect("a walker");
    assert!(walker.push_felt().is_none());
    let (at, force) = (Vector3::new(0.01, 0.1, 0.05), Vector3::new(20.0, 5.0, 30.0));
    walker.push("head", at, force).expect("a push");
    let before = walker.configuration().to_vec();
    go(&mut walker, &Command::stop(), FRAME);
    let (link, wrench) = walker.push_felt().expect("a push");
    assert_eq!(figure.links()[link].name(), "head");
    let arm = place(&figure, &before, "head", at);
    assert!((wrench.force - force).norm() < 1e-12 && (wrench.moment - arm.cross(&force)).norm() < 1e-9);
    let mut other = walker.clone();
    let walk = Command::velocity(0.3, 0.8);
    let (one, two) = (go(&mut walker, &walk, 3.0), go(&mut other, &walk, 3.0));
    assert!(one.iter().zip(&two).all(|(a, b)| a.to_bits() == b.to_bits()));
    walker.let_go();
    go(&mut walker, &walk, FRAME);
    assert!(walker.push_felt().is_none());
}

#[test]
fn what_is_no_push_is_refused_and_changes_nothing() {
    let figure = person(1.75);
    let mut walker = Walker::new(&figure).expect("a walker");
    walker.push("head", Vector3::zeros(), Vector3::x() * 20.0).expect("a push");
    for (link, at, force, said) in [
        ("hed", Vector3::zeros(), Vector3::x(), "did you mean 'head'"),
        ("head", Vector3::zeros(), Vector3::x() * 716.0, "at most the weight, 715 N"),
        ("head", Vector3::zeros(), Vector3::x() * f64::NAN, "NaN N"),
        ("head", Vector3::x() * f64::INFINITY, Vector3::x(), "place of a push inf"),
    ] {
        let error = walker.push(link, at, force).expect_err("no push").to_string();
        assert!(error.contains(said), "{error}");
    }
    go(&mut walker, &Command::stop(), FRAME);
    assert_eq!(walker.push_felt().map(|(_, wrench)| wrench.force), Some(Vector3::x() * 20.0));
}

/// Any commands and any pushes, with limbs that hang or not.
pub(crate) fn pushed_at_random(height: f64, seed: u64, rate: f64, time: f64) {
    let figure = person(height);
    let weight = figure.mass() * 9.80665;
    let mut driver = Driver::new(&figure, rate);
    let mut random = Random(seed);
    while driver.time() < time {
        let (command, lasts) = command(&mut random);
        if random.often(0.25) {
            driver.walker.let_go();
        } else {
            let link = figure.links()[random.pick(figure.links().len())].name();
            let direction = Vector3::from_fn(|_, _| random.within(-1.0, 1.0));
            let most = if random.often(0.1) { 1.0 } else { 0.15 };
            let force = direction * (random.within(0.0, most) * weight / 3.0_f64.sqrt());
            let at = Vector3::from_fn(|_, _| random.within(-0.1, 0.1));
            driver.walker.push(link, at, force).expect("a push");
        }
        if random.often(0.3) {
            let joint = ["left_shoulder", "left_elbow", "left_wrist", "neck", "head"][random.pick(5)];
            if random.often(0.5) { driver.walker.loosen(joint) } else { driver.walker.tighten(joint) }
                .expect("a joint");
        }
        driver.go(&command, lasts.min(1.5));
    }
    holds(&driver.found, height, &format!("{height} m, seed {seed}"));
}

#[test]
fn two_minutes_of_any_pushes_hold() {
    for (height, seed, rate) in [(1.75, 31, 240.0), (1.5, 32, 120.0), (1.95, 33, 60.0), (1.2, 34, 144.0)] {
        pushed_at_random(height, seed, rate, 30.0);
    }
}

#[test]
#[ignore = "half an hour of pushes"]
fn half_an_hour_of_any_pushes_holds() {
    for k in 0..30 {
        pushed_at_random(
            [1.75, 1.5, 1.95, 1.65, 1.85][k % 5],
            300 + k as u64,
            [240.0, 60.0, 120.0][k % 3],
            60.0,
        );
    }
}

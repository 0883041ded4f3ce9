//! Forces that keep what stands on rigid ground, and impulses, are two ways to the same thing: what both can say they say alike, to a millionth of the weight.

use super::planted::{forces, ground};
use crate::contact::{G, at, fixed, simulation};
use solaris_model::{Figure, FigureBuilder, Inertia, Joint, LinkSpec, Vector3};
use solaris_modes::{Aim, ContactPoint, Drive, Method, Push, PushLaw, Servo, Settings, Simulation};
use solaris_profiles::Profile;

/// Of a link the force in every frame, by impulses as it is where steps are nothing: those are of order one.
///
/// ```text
/// F = F(h/4)·8/3 − F(h/2)·2 + F(h)/3
/// ```
fn by_impulses(simulation: &Simulation, duration: f64, links: &[&str]) -> Vec<Vec<Vector3<f64>>> {
    let runs = [1.0, 0.5, 0.25].map(|part| {
        let method = Method::Impulses { step: part * 1e-4 };
        let settings = Settings { method, estimate: false, ..Settings::new(duration, 100.0) };
        simulation.run(&settings).expect("runs").motion
    });
    let of = |link: &&str| {
        let [coarse, middle, fine] = [0, 1, 2].map(|i| forces(&runs[i], link));
        let pairs = coarse.iter().zip(&middle).zip(&fine);
        pairs.map(|((a, b), c)| c * (8.0 / 3.0) - b * 2.0 + a / 3.0).collect()
    };
    links.iter().map(of).collect()
}

/// The greatest difference between both over some frames, as a part of the weight.
fn apart(simulation: &Simulation, links: &[&str], frames: std::ops::Range<usize>) -> f64 {
    let duration = (frames.end - 1) as f64 / 100.0;
    let run = simulation.run(&fixed(duration, 100.0, 1e-3)).expect("runs");
    let impulses = by_impulses(simulation, duration, links);
    let weight = simulation.figure().mass() * G;
    let mut worst = 0.0_f64;
    for (link, by_impulses) in links.iter().zip(&impulses) {
        let by_forces = forces(&run.motion, link);
        for frame in frames.clone() {
            worst = worst.max((by_forces[frame] - by_impulses[frame]).norm() / weight);
        }
    }
    println!("{links:?}: {worst:.1e} of the weight apart");
    worst
}

fn block(half: [f64; 2], mass: f64) -> (Figure, Vec<ContactPoint>) {
    let [b, h] = half;
    let inertia = mass / 3.0 * (b * b + h * h);
    let joint = Joint::new("slide").tx().ty().rz();
    let link = LinkSpec::root("body", joint).mass(mass).inertia(Inertia::diagonal(inertia, inertia, inertia));
    let figure = FigureBuilder::new("body").link(link).build().expect("valid");
    (figure, vec![at(Vector3::new(-b, -h, 0.0), 0.0), at(Vector3::new(b, -h, 0.0), 0.0)])
}

fn push(simulation: &mut Simulation, at: Vector3<f64>, force: Vector3<f64>, along: Option<Profile>) {
    let law = match along {
        None => PushLaw::Force { force, over: f64::INFINITY },
        Some(curve) => PushLaw::Along { force, profile: curve },
    };
    simulation.add_push(Push { link: 0, point: at, from: 0.0, law }).expect("valid");
}

/// What stands bears its weight, and what is pushed against it.
#[test]
fn what_stands_is_borne_alike() {
    let (figure, corners) = block([0.2, 0.3], 3.0);
    let mut standing = simulation(&figure, G, ground(0.8), corners);
    standing.set_start(&[0.0, 0.3, 0.0], &[0.0; 3]).expect("valid");
    push(&mut standing, Vector3::new(0.0, 0.1, 0.0), Vector3::new(6.0, -4.0, 0.0), None);
    assert!(apart(&standing, &["body"], 2..31) < 1e-6);
}

/// A push at the top tips it over its edge.
#[test]
fn what_tips_over_an_edge_presses_alike() {
    let (figure, corners) = block([0.1, 0.3], 3.0);
    let mut tipping = simulation(&figure, G, ground(2.0), corners);
    tipping.set_start(&[0.0, 0.3, 0.0], &[0.0; 3]).expect("valid");
    push(&mut tipping, Vector3::new(0.0, 0.3, 0.0), Vector3::new(9.0, 0.0, 0.0), None);
    assert!(apart(&tipping, &["body"], 2..26) < 1e-6);
}

/// A pull upwards that grows lets it go where it is the weight.
#[test]
fn what_is_lifted_lets_go_alike() {
    let (figure, corners) = block([0.1, 0.1], 2.0);
    let mut lifted = simulation(&figure, G, ground(0.5), corners);
    lifted.set_start(&[0.0, 0.1, 0.0], &[0.0; 3]).expect("valid");
    let grows = Profile::Line { from: 0.0, to: 1.0, duration: 0.5 };
    push(&mut lifted, Vector3::zeros(), Vector3::new(0.0, 1.6 * 2.0 * G, 0.0), Some(grows));
    // 0.3125 s: before, and after.
    assert!(apart(&lifted, &["body"], 2..31) < 1e-6);
    assert!(apart(&lifted, &["body"], 33..40) < 1e-12);
}

/// Legs that bear more than once what stands on them: knees on springs, which say how much each foot bears.
#[test]
fn two_feet_bear_alike_what_their_springs_say() {
    let small = Inertia::diagonal(0.01, 0.01, 0.01);
    let trunk = LinkSpec::root("trunk", Joint::new("root").tx().ty().rz()).mass(8.0);
    let trunk = trunk.com(Vector3::new(0.07, 0.0, 0.0)).inertia(Inertia::diagonal(0.4, 0.4, 0.4));
    let foot = |name: &str, x: f64| {
        let joint = Joint::new(name).at(Vector3::new(x, 0.0, 0.0)).ty();
        LinkSpec::child(name, "trunk", joint).mass(1.0).inertia(small)
    };
    let figure = FigureBuilder::new("stool").link(trunk).link(foot("left", -0.3)).link(foot("right", 0.3));
    let figure = figure.build().expect("valid");
    let points =
        |link| [-0.08, 0.08].map(|x| ContactPoint { link, center: Vector3::new(x, -0.5, 0.0), radius: 0.0 });
    let mut stool = simulation(&figure, G, ground(0.9), [points(1), points(2)].concat());
    for (name, stiffness) in [("left.ty", 4000.0), ("right.ty", 9000.0)] {
        stool
            .drive(name, [Drive::Servo(Servo { aim: Aim::At(0.0), stiffness, damping: 60.0, limit: None })])
            .expect("valid");
    }
    stool.set_start(&[0.0, 0.5, 0.0, 0.0, 0.0], &[0.0; 5]).expect("valid");
    assert!(apart(&stool, &["left", "right"], 2..41) < 1e-6);
}

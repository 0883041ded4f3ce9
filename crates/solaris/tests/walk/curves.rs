//! Walks round bends: Newton and Euler on the whole body, and a BVH file that gives the same places again.

use crate::cases::{RATE, walked};
use crate::newton::newton;
use crate::worst::Worst;
use solaris::dynamics::{Tree, Workspace, forward_kinematics};
use solaris::gait::{Extent, WalkPath, WalkRequest};
use solaris::io::bvh::{self, ReadOptions, Unit};
use solaris::model::{Figure, Human, Link, Motion, RootOrder, Vector3};
use std::f64::consts::TAU;

fn walker() -> Figure {
    Human::new(1.75, 73.0).root(RootOrder::Yzx).build().expect("a person")
}

fn circle() -> WalkRequest {
    let points: Vec<[f64; 2]> =
        (1..=48).map(|k| f64::from(k) * TAU / 48.0).map(|angle| [1.0 - angle.cos(), angle.sin()]).collect();
    let path = WalkPath::through(&points).expect("a way");
    WalkRequest { step_frequency: Some(95.0), left_first: true, path: Some(path), ..WalkRequest::default() }
}

fn on_the_spot() -> WalkRequest {
    WalkRequest {
        step_frequency: Some(90.0),
        step_length: Some(0.0),
        turn: 30_f64.to_radians(),
        extent: Extent::Steps(12),
        left_first: true,
        ..WalkRequest::default()
    }
}

#[test]
fn forces_and_moments_are_the_rates_of_momentum_round_bends() {
    let figure = walker();
    let mut worst = Worst::default();
    for (case, request) in [("a circle of 1 m", circle()), ("a turn on the spot", on_the_spot())] {
        let (_, motion) = walked(&figure, &request, RATE);
        worst.merge(case, &newton(&figure, &motion));
    }
    worst.assert_all("Newton and Euler round bends");
}

/// The origins of the links with these names in all frames.
fn places(figure: &Figure, motion: &Motion, names: &[&str]) -> Vec<Vector3<f64>> {
    let links: Vec<usize> = names.iter().map(|name| figure.link_index(name).expect("a link")).collect();
    let tree = Tree::<f64>::new(figure, motion.info.gravity).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    let mut places = Vec::new();
    for i in 0..motion.len() {
        forward_kinematics(&tree, &mut workspace, motion.q(i)).expect("a posture");
        places.extend(links.iter().map(|&link| workspace.pose(link).translation));
    }
    places
}

#[test]
fn a_bvh_file_of_a_circle_gives_the_same_places_again() {
    let figure = walker();
    let (_, motion) = walked(&figure, &circle(), 60.0);
    let mut bytes = Vec::new();
    bvh::write(&figure, &motion, Unit::Centimetres, &mut bytes).expect("a human fits");
    let text = String::from_utf8(bytes).expect("text");
    assert!(text.contains("Yrotation Zrotation Xrotation"));
    let clip = bvh::read(&text, &ReadOptions::default()).expect("a clip");
    assert_eq!(clip.motion.len(), motion.len());
    // A file has its links child by child.
    let names: Vec<&str> = figure.links().iter().map(Link::name).collect();
    let (written, read) = (places(&figure, &motion, &names), places(&clip.figure, &clip.motion, &names));
    assert_eq!(written.len(), read.len());
    let apart = written.iter().zip(&read).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
    assert!(apart < 1e-6);
}

//! How a walker turns: the head before the body, the trunk into the bend, and no thigh through the other.

use crate::driven::{Driver, person};
use crate::live::circle;
use crate::support::Walked;
use nalgebra::Vector3;
use solaris_analysis::nearness;
use solaris_gait::Command;
use solaris_model::{Figure, Motion, MotionInfo};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

const RATE: f64 = 120.0;

/// Which way the head and the body face (rad, not wrapped) in every frame of a script.
fn headings(figure: &Figure, script: &[(Command, f64)]) -> [Vec<f64>; 2] {
    let head = figure.link_index("head").expect("a head");
    let mut driver = Driver::new(figure, RATE);
    let mut found = [Vec::new(), Vec::new()];
    for (command, time) in script {
        for _ in 0..(time * RATE) as usize {
            driver.go(command, 1.0 / RATE);
            let (_, turn) = Walked::poses(figure, driver.walker.configuration())[head];
            let ahead = turn * Vector3::z();
            let (heading, last) = (ahead.x.atan2(ahead.z), found[0].last().copied().unwrap_or(0.0));
            found[0].push(last + (heading - last + PI).rem_euclid(TAU) - PI);
            found[1].push(driver.walker.heading());
        }
    }
    found
}

/// By how much time the one goes before the other where that serves best (s): least squares over shifts of frames.
fn lead([head, body]: &[Vec<f64>; 2]) -> f64 {
    let off = |shift: usize| -> f64 {
        let pairs = head.iter().zip(&body[shift..]);
        pairs.map(|(a, b)| (a - b) * (a - b)).sum::<f64>() / (body.len() - shift) as f64
    };
    let best = (0..90).min_by(|a, b| off(*a).total_cmp(&off(*b))).expect("shifts");
    best as f64 / RATE
}

#[test]
fn the_head_turns_a_quarter_of_a_second_before_the_body() {
    for height in [1.6, 1.75, 1.9] {
        let figure = person(height);
        let walk = |heading: f64, speed: f64| Command::velocity(speed * heading.sin(), speed * heading.cos());
        for (name, script) in [
            ("a corner", vec![(walk(0.0, 1.1), 3.0), (walk(FRAC_PI_2, 1.1), 3.0)]),
            ("a bend of 45°", vec![(walk(0.0, 0.9), 3.0), (walk(-0.25 * PI, 0.9), 3.0)]),
            ("a U-turn", vec![(walk(0.0, 1.0), 3.0), (walk(PI - 0.01, 1.0), 5.0)]),
            ("a circle of 1 m", circle(1.0, 0.8)),
            ("a circle of 2 m", circle(2.0, 1.0)),
            ("on the spot", vec![(Command::stop(), 1.0), (Command::stop().facing(PI), 6.0)]),
        ] {
            let lead = lead(&headings(&figure, &script));
            println!("{height} m, {name}: {lead:.3} s");
            assert!((0.18..0.3).contains(&lead), "{height} m, {name}: {lead} s");
        }
    }
}

/// `tan x = v ω/g` is in balance, for the speed and the turning that come of what is told.
#[test]
fn the_trunk_leans_into_a_circle() {
    let figure = person(1.75);
    let thorax = figure.link_index("thorax").expect("a thorax");
    for (radius, speed) in [(2.0, 1.0), (1.0, 0.8), (3.0, 1.3)] {
        let mut driver = Driver::new(&figure, RATE);
        let (mut sum, mut way, mut count) = (0.0, 0.0, 0.0);
        let (mut from, mut last) = (0.0, Vector3::zeros());
        for (k, (command, time)) in circle(radius, speed).iter().enumerate() {
            for _ in 0..(time * RATE) as usize {
                driver.go(command, 1.0 / RATE);
                let walker = &driver.walker;
                let (_, turn) = Walked::poses(&figure, walker.configuration())[thorax];
                let (sin, cos) = walker.heading().sin_cos();
                if k <= 20 {
                    (from, last) = (walker.heading(), walker.com());
                    continue;
                }
                sum += (turn * Vector3::y()).dot(&Vector3::new(cos, 0.0, -sin));
                way += (walker.com() - last).xz().norm();
                last = walker.com();
                count += 1.0;
            }
        }
        let time = count / RATE;
        let (lean, balanced) =
            (sum / count, way * (driver.walker.heading() - from) / (time * time * 9.80665));
        println!("a circle of {radius} m at {speed} m/s: {:.2} of what is in balance", lean / balanced);
        assert!((0.4..0.8).contains(&(lean / balanced)), "{lean} {balanced}");
    }
}

/// Capsules of the limbs, which are wider than people where they taper.
#[test]
fn limbs_do_not_go_through_each_other() {
    for height in [1.6, 1.75, 1.9] {
        let figure = person(height);
        for (name, script) in [
            ("a circle of 1 m", circle(1.0, 0.8)),
            ("a circle of 0.5 m", circle(0.5, 0.5)),
            ("on the spot", vec![(Command::stop().facing(PI), 6.0)]),
            ("aside", vec![(Command::own_velocity(0.2, 0.0), 6.0)]),
            (
                "aside about a point",
                (0..60).map(|_| (Command::own_velocity(0.2, 0.0).facing_point(0.0, 1.5), 0.2)).collect(),
            ),
            ("backward", vec![(Command::own_velocity(0.0, -0.4), 6.0)]),
        ] {
            let mut driver = Driver::new(&figure, RATE);
            let mut q = Vec::new();
            for (command, time) in &script {
                for _ in 0..(time * RATE) as usize {
                    driver.go(command, 1.0 / RATE);
                    q.extend_from_slice(driver.walker.configuration());
                }
            }
            let frames = q.len() / figure.layout().nq();
            let time = (0..frames).map(|k| k as f64 / RATE).collect();
            let rest = vec![0.0; q.len()];
            let info = MotionInfo::on_earth(&figure, RATE);
            let motion = Motion::new(&figure, info, time, [q, rest.clone(), rest]).expect("a motion");
            let near = nearness(&figure, &motion).expect("measured").expect("limbs");
            let near = near.limbs(&figure, motion.time());
            println!("{height} m, {name}: {:.1} mm, {:?}", 1e3 * near.distance, near.links);
            // A hand passes its own thigh.
            let most = if near.links.iter().any(|link| link.ends_with("_hand")) { 0.012 } else { 0.0 };
            assert!(near.distance > -most, "{height} m, {name}: {:?} {}", near.links, near.distance);
        }
    }
}

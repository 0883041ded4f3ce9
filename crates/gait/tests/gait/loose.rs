//! Joints that hang loose from a walker: they swing and settle, come back without a jump, and change nothing else.

use crate::driven::{Driver, person};
use crate::live_random::{command, holds};
use crate::random::Random;
use nalgebra::Vector3;
use solaris_dynamics::{Tree, Workspace, kinetic_energy, potential_energy};
use solaris_gait::{Command, Walker};
use solaris_model::Figure;

const ARM: [&str; 3] = ["left_shoulder", "left_elbow", "left_wrist"];

fn walk() -> Command {
    Command::velocity(0.0, 1.2)
}

fn index(figure: &Figure, name: &str) -> usize {
    figure.layout().q_names().iter().position(|known| known == name).expect("a coordinate")
}

#[test]
fn an_arm_let_loose_swings_as_one_walks_and_settles_as_one_stands() {
    let figure = person(1.75);
    let shoulder = index(&figure, "left_shoulder.rx");
    let mut walker = Walker::new(&figure).expect("a walker");
    let go = |walker: &mut Walker, command: &Command, seconds: f64| -> Vec<f64> {
        let frames = 0..(60.0 * seconds) as usize;
        frames.map(|_| walker.step(1.0 / 60.0, command).expect("a frame")[shoulder]).collect()
    };
    go(&mut walker, &walk(), 3.0);
    let mut tight = walker.clone();
    for joint in ARM {
        walker.loosen(joint).expect("a joint");
    }
    let (loose, held) = (go(&mut walker, &walk(), 4.0), go(&mut tight, &walk(), 4.0));
    let range = |all: &[f64]| {
        all.iter().copied().fold(f64::MIN, f64::max) - all.iter().copied().fold(f64::MAX, f64::min)
    };
    let apart = loose.iter().zip(&held).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(range(&loose) > 0.1 && apart > 0.05, "{} {apart}", range(&loose));
    go(&mut walker, &Command::stop(), 14.0);
    assert!(walker.is_standing());
    let still = go(&mut walker, &Command::stop(), 1.0);
    assert!(range(&still) < 2e-3, "{}", range(&still));
}

/// The walker stands still: nothing moves the arm but its weight.
#[test]
fn an_arm_that_falls_loses_energy_to_its_damping_alone() {
    let figure = person(1.75);
    let tree: Tree<f64> = Tree::new(&figure, Vector3::new(0.0, -9.80665, 0.0)).expect("a tree");
    let mut workspace = Workspace::new(&tree);
    let mut walker = Walker::new(&figure).expect("a walker");
    walker.free("left_shoulder.rx").expect("a coordinate");
    walker.set_freed("left_shoulder.rx", -1.3).expect("a coordinate");
    for _ in 0..60 {
        walker.step(1.0 / 60.0, &Command::stop()).expect("a frame");
    }
    let nv = figure.layout().nv();
    let (mut v, mut a) = (vec![0.0; nv], vec![0.0; nv]);
    let mut energy = |walker: &mut Walker| {
        walker.derivatives(&mut v, &mut a).expect("slices");
        kinetic_energy(&tree, &mut workspace, walker.configuration(), &v).expect("a state")
            + potential_energy(&tree, &mut workspace, walker.configuration()).expect("a state")
    };
    let start = energy(&mut walker);
    for joint in ARM {
        walker.loosen(joint).expect("a joint");
    }
    let mut last = start;
    for frame in 0..600 {
        walker.step(1.0 / 60.0, &Command::stop()).expect("a frame");
        let now = energy(&mut walker);
        assert!(now < last + 0.05, "{frame}: {now} J after {last} J");
        last = now;
    }
    // An arm of 3.6 kg has come down by some 20 cm.
    assert!(start - last > 4.0, "{start} to {last}");
}

#[test]
fn what_is_loosened_and_tightened_does_not_jump_and_comes_back_to_the_walk() {
    let figure = person(1.75);
    let rate = 240.0;
    for (joints, at) in [(&ARM[..], 3.0), (&ARM[1..2], 3.3), (&["head", "neck"][..], 2.7)] {
        let mut walker = Walker::new(&figure).expect("a walker");
        let mut tight = walker.clone();
        let mut all: Vec<Vec<f64>> = Vec::new();
        for frame in 0..(rate * 8.0) as usize {
            let time = frame as f64 / rate;
            if (time - at).abs() < 0.5 / rate {
                for joint in joints {
                    walker.loosen(joint).expect("a joint");
                }
            }
            if (time - at - 2.0).abs() < 0.5 / rate {
                for joint in joints {
                    walker.tighten(joint).expect("a joint");
                }
            }
            let walked = tight.step(1.0 / rate, &walk()).expect("a frame").to_vec();
            all.push(walker.step(1.0 / rate, &walk()).expect("a frame").to_vec());
            // All else is the walk, and so is all of it before and after.
            for (k, name) in figure.layout().q_names().iter().enumerate() {
                let hangs = joints.iter().any(|joint| name.starts_with(joint)) && time > at - 0.01;
                if !hangs || time > at + 2.6 {
                    assert_eq!(all[frame][k].to_bits(), walked[k].to_bits(), "{name} at {time}");
                }
            }
        }
        for (frame, window) in all.windows(3).enumerate() {
            let time = frame as f64 / rate;
            for k in 0..window[0].len() {
                let [before, after] = [0, 1].map(|i| (window[i + 1][k] - window[i][k]) * rate);
                let name = &figure.layout().q_names()[k];
                if joints.iter().any(|joint| name.starts_with(joint)) {
                    // Limits brake at 1500 rad/s².
                    assert!((after - before).abs() * rate < 1510.0, "{name} at {time}: {before} to {after}");
                }
            }
        }
    }
}

#[test]
fn what_is_no_joint_that_hangs_is_refused() {
    let mut walker = Walker::new(&person(1.75)).expect("a walker");
    for joint in ["left_knee", "root", "left_shoulder.rx", "nobody"] {
        let error = walker.loosen(joint).expect_err("not loose").to_string();
        assert!(error.contains(joint), "{error}");
        assert!(walker.tighten(joint).is_err());
    }
    assert!(walker.tighten("head").is_ok());
}

/// Any commands, while joints are loosened and tightened.
#[test]
fn minutes_of_loosening_and_tightening_hold() {
    let joints = [
        "left_shoulder",
        "left_elbow",
        "left_wrist",
        "right_shoulder",
        "right_elbow",
        "right_wrist",
        "neck",
        "head",
        "left_clavicle",
        "thorax",
    ];
    for (height, seed, rate) in [(1.75, 21, 240.0), (1.5, 22, 60.0)] {
        let figure = person(height);
        let mut driver = Driver::new(&figure, rate);
        let mut random = Random(seed);
        while driver.time() < 90.0 {
            let (command, time) = command(&mut random);
            for _ in 0..random.pick(4) {
                let joint = joints[random.pick(joints.len())];
                if random.often(0.6) {
                    driver.walker.loosen(joint).expect("a joint");
                } else {
                    driver.walker.tighten(joint).expect("a joint");
                }
            }
            driver.go(&command, time.min(1.5));
        }
        holds(&driver.found, height, &format!("{height} m, seed {seed}"));
    }
}

/// What a frame costs with an arm that hangs: `cargo test --release -p solaris-gait --test gait -- costs_a_frame --ignored --nocapture`.
#[test]
#[ignore = "prints times"]
fn what_an_arm_costs_a_frame() {
    let figure = person(1.75);
    let mut walker = Walker::new(&figure).expect("a walker");
    let mut times = [0.0; 2];
    for time in &mut times {
        let began = std::time::Instant::now();
        for _ in 0..6000 {
            walker.step(1.0 / 60.0, &walk()).expect("a frame");
        }
        *time = began.elapsed().as_secs_f64() / 6000.0 * 1e6;
        for joint in ARM {
            walker.loosen(joint).expect("a joint");
        }
    }
    println!("{:.1} µs a frame, {:.1} µs with an arm that hangs", times[0], times[1]);
}

//! A walker that is told anything, in frames of any length: it refuses, or stands in a pose of finite numbers.
#![no_main]

use solaris_fuzz::{Chosen, refused, target};
use solaris_gait::{Command, Walker};
use solaris_model::{Human, RootOrder};
use std::sync::LazyLock;

static WALKER: LazyLock<Walker> = LazyLock::new(|| {
    let figure = Human::new(1.75, 73.0).root(RootOrder::Yzx).build().expect("a person");
    Walker::new(&figure).expect("a walker")
});

/// The most frames of an input.
const MOST: usize = 400;

target!(|bytes: &[u8]| {
    let (mut chosen, mut walker) = (Chosen(bytes), WALKER.clone());
    let nv = walker.configuration().len();
    let (mut v, mut a) = (vec![0.0; nv], vec![0.0; nv]);
    for _ in 0..MOST {
        if chosen.is_over() {
            break;
        }
        let command = match chosen.below(4) {
            0 => Command::stop(),
            1 => Command::velocity(chosen.any(), chosen.any()),
            2 => Command::own_velocity(chosen.any(), chosen.any()),
            _ => Command::to_point(chosen.any(), chosen.any(), chosen.any()),
        };
        let command = match chosen.below(3) {
            0 => command,
            1 => command.facing(chosen.any()),
            _ => command.facing_point(chosen.any(), chosen.any()),
        };
        let dt = if chosen.below(4) == 0 { chosen.any() } else { 0.2 * f64::from(chosen.byte()) / 255.0 };
        let before = walker.configuration().to_vec();
        let frames = 1 + chosen.below(8);
        for _ in 0..frames {
            match walker.step(dt, &command) {
                Ok(pose) => {
                    assert!(pose.iter().all(|x| x.is_finite()), "{pose:?} after {dt} s of {command:?}")
                }
                Err(error) => {
                    refused(&error);
                    assert_eq!(
                        walker.configuration(),
                        before,
                        "what is refused leaves the walker where it is"
                    );
                    break;
                }
            }
        }
        match walker.derivatives(&mut v, &mut a) {
            Ok(()) => assert!(v.iter().chain(&a).all(|x| x.is_finite()), "{v:?} {a:?} under {command:?}"),
            Err(error) => refused(&error),
        }
        let own = [walker.place(), walker.velocity(), walker.pressure()].concat();
        assert!(own.iter().all(|x| x.is_finite()) && walker.heading().is_finite(), "{own:?}");
    }
});

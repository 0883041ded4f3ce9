//! A walker that is told anything, in frames of any length: it refuses, or stands in a pose of finite numbers.
#![no_main]

use solaris_analysis::Goal;
use solaris_fuzz::{Chosen, refused, target};
use solaris_gait::{Command, Walker};
use solaris_model::{Human, RootOrder, UnitQuaternion, Vector3};
use std::sync::LazyLock;

static WALKER: LazyLock<Walker> = LazyLock::new(|| {
    let figure = Human::new(1.75, 73.0).root(RootOrder::Yzx).build().expect("a person");
    Walker::new(&figure).expect("a walker")
});

/// The most frames of an input.
const MOST: usize = 400;

const LINKS: [&str; 5] = ["right_hand", "left_hand", "head", "thorax", "right_foot"];
const JOINTS: [&str; 6] = ["right_shoulder", "right_elbow", "left_elbow.rx", "neck", "head", "left_knee"];

/// Something that limbs are told.
fn tell(walker: &mut Walker, chosen: &mut Chosen<'_>) {
    let vector = |chosen: &mut Chosen<'_>| Vector3::new(chosen.any(), chosen.any(), chosen.any());
    let (link, joint) = (LINKS[chosen.below(5)], JOINTS[chosen.below(6)]);
    let told = match chosen.below(12) {
        0 => {
            let by = [joint];
            let by: &[&str] = if chosen.below(2) == 0 { &[] } else { &by };
            let (point, at) = (vector(chosen), vector(chosen));
            let goal = match chosen.below(3) {
                0 => Goal::Place(at),
                1 => Goal::Look { axis: Vector3::z_axis(), at },
                _ => Goal::Turned(UnitQuaternion::from_scaled_axis(at)),
            };
            walker.reach(link, point, by, goal)
        }
        1 => {
            let near = walker.com() + Vector3::new(0.3, 0.2, 0.4);
            walker.reach(link, Vector3::zeros(), &[], Goal::Place(near))
        }
        2 => walker.withdraw(link),
        3 => walker.set_freed(joint, chosen.any()).and_then(|()| walker.free(joint)),
        4 => walker.hold(joint),
        5 => walker.push(link, vector(chosen), vector(chosen)),
        6 => {
            walker.let_go();
            Ok(())
        }
        7 => walker.loosen(joint),
        8 => walker.tighten(joint),
        _ => Ok(()),
    };
    if let Err(error) = told {
        refused(&error);
    }
}

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
        tell(&mut walker, &mut chosen);
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
        match walker.forces(&mut v) {
            Ok(feet) => {
                let feet =
                    feet.iter().flat_map(|foot| foot.force.iter().chain(&foot.moment).chain(&foot.cop));
                assert!(v.iter().chain(feet).all(|x| x.is_finite()), "{v:?} under {command:?}");
            }
            Err(error) => refused(&error),
        }
        let own = [walker.place(), walker.velocity(), walker.pressure()].concat();
        assert!(own.iter().all(|x| x.is_finite()) && walker.heading().is_finite(), "{own:?}");
    }
});

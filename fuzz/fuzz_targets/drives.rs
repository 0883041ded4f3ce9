//! Small figures of any joints, driven by anything from any state, for a moment: a motion of finite numbers, or a refusal.
#![no_main]

use solaris_fuzz::{Chosen, refused, target};
use solaris_model::{
    Figure, FigureBuilder, Inertia, Joint, LinkSpec, Placement, Shape as Solid, ShapeKind, Vector3,
};
use solaris_modes::{
    Aim, ContactLaw, Course, Drive, EndCondition, GroundPlane, Guard, Law, LimitLaw, Method, Rule, Servo,
    Settings, Shape, Simulation, Step, Target, contact_points,
};
use solaris_profiles::Profile;

/// A joint of any kind.
fn joint(chosen: &mut Chosen<'_>, name: &str) -> Joint {
    let kind = chosen.below(8);
    let joint = match kind {
        0 => return Joint::free(name),
        1 => return Joint::ball(name),
        2 => Joint::new(name),
        3 => Joint::new(name).rx().ry(),
        4 => Joint::new(name).ty(),
        5 => Joint::new(name).rz().limited(-1.0, 1.0),
        6 => Joint::new(name).tx().limited(-0.5, 0.5),
        _ => Joint::new(name).rx(),
    };
    joint.at(Vector3::new(chosen.number(), chosen.number(), chosen.number()) / 8.0)
}

/// A figure of one to four links.
fn figure(chosen: &mut Chosen<'_>) -> Option<Figure> {
    let mut builder = FigureBuilder::new("f");
    let count = 1 + chosen.below(4);
    for i in 0..count {
        let (name, joint) = (format!("l{i}"), joint(chosen, &format!("j{i}")));
        let link = if i == 0 {
            LinkSpec::root(name, joint)
        } else {
            LinkSpec::child(name, format!("l{}", chosen.below(i)), joint)
        };
        let solid = Solid { kind: ShapeKind::Sphere { radius: 0.1 }, placement: Placement::identity() };
        let mass = [1.0, 0.0, 1e-6, 100.0][chosen.below(4)];
        let link = link.mass(mass).com(Vector3::new(0.0, chosen.number() / 8.0, 0.1));
        builder =
            builder.link(if chosen.below(2) == 0 { link.inertia(Inertia::Uniform(solid)) } else { link });
    }
    builder.build().ok()
}

fn target_of(chosen: &mut Chosen<'_>) -> Target {
    Target { position: chosen.any(), velocity: chosen.any(), acceleration: chosen.any() }
}

fn profile(chosen: &mut Chosen<'_>) -> Profile {
    match chosen.below(3) {
        0 => Profile::MinimumJerk { from: chosen.any(), to: chosen.any(), duration: chosen.any() },
        1 => Profile::Line { from: chosen.any(), to: chosen.any(), duration: chosen.any() },
        _ => Profile::Sine {
            amplitude: chosen.any(),
            period: chosen.any(),
            cycles: chosen.any(),
            phase: chosen.any(),
            offset: chosen.any(),
        },
    }
}

fn drive(chosen: &mut Chosen<'_>, depth: usize) -> Drive {
    match chosen.below(if depth > 2 { 8 } else { 9 }) {
        0 => Drive::Free,
        1 => Drive::Frozen,
        2 => Drive::Kinematic(profile(chosen)),
        3 => Drive::Move {
            to: chosen.any(),
            over: chosen.any(),
            along: if chosen.below(2) == 0 { Shape::Cubic } else { Shape::MinimumJerk },
        },
        4 => Drive::Torque(profile(chosen)),
        5 => Drive::Simple {
            target: target_of(chosen),
            course: match chosen.below(5) {
                0 => Course::TargetAngle,
                1 => Course::TimeOriented { duration: chosen.any() },
                2 => Course::BangBang,
                3 => Course::HalfCosine,
                _ => Course::FullSine,
            },
        },
        6 => Drive::Intensive {
            target: target_of(chosen),
            duration: chosen.any(),
            law: [Law::Literal, Law::Cubic, Law::Quintic][chosen.below(3)],
            limit: (chosen.below(2) == 0).then(|| chosen.any()),
        },
        7 => Drive::Servo(Servo {
            aim: if chosen.below(2) == 0 { Aim::At(chosen.any()) } else { Aim::Along(profile(chosen)) },
            stiffness: 100.0 * chosen.any(),
            damping: chosen.any(),
            limit: (chosen.below(2) == 0).then(|| chosen.any()),
        }),
        _ => Drive::Sum((0..chosen.below(3)).map(|_| drive(chosen, depth + 1)).collect()),
    }
}

target!(|bytes: &[u8]| {
    let mut chosen = Chosen(bytes);
    let Some(figure) = figure(&mut chosen) else { return };
    let mut simulation = Simulation::new(&figure, Vector3::new(0.0, -9.806_65, 0.0));
    let layout = figure.layout();
    let mut q = vec![0.0; layout.nq()];
    figure.neutral(&mut q).expect("the figure's own length");
    for x in &mut q {
        *x += if chosen.below(2) == 0 { chosen.any() } else { 0.0 };
    }
    let v: Vec<f64> = (0..layout.nv()).map(|_| chosen.any()).collect();
    if let Err(error) = simulation.set_start(&q, &v) {
        refused(&error);
    }
    for name in layout.v_names() {
        let drives: Vec<Step> = (0..chosen.below(3))
            .map(|_| {
                let drive = drive(&mut chosen, 0);
                match chosen.below(2) {
                    0 => Step { drive, until: EndCondition::Lasting(chosen.any()) },
                    _ => drive.into(),
                }
            })
            .collect();
        if let Err(error) = simulation.drive(name, drives) {
            refused(&error);
        }
    }
    if chosen.below(3) == 0 {
        let law = LimitLaw::Spring { stiffness: 1000.0 * chosen.any(), damping: chosen.any() };
        simulation.set_limits(law).unwrap_or_else(|error| refused(&error));
    }
    if chosen.below(3) == 0 {
        let law = if chosen.below(2) == 0 {
            ContactLaw::Rigid
        } else {
            ContactLaw::Compliant { stiffness: 1e4 * chosen.any(), damping: chosen.any(), slip: chosen.any() }
        };
        let plane = GroundPlane { up: Vector3::y_axis(), height: chosen.any(), friction: chosen.any(), law };
        simulation.set_ground(plane, contact_points(&figure)).unwrap_or_else(|error| refused(&error));
    }
    let method = match chosen.below(4) {
        0 => Method::Adaptive { tolerance: 1e-3 },
        1 => Method::Impulses { step: 5e-3 },
        2 => Method::Automatic { tolerance: 1e-2 },
        _ => Method::Fixed { rule: Rule::ALL[chosen.below(4)], step: 5e-3 },
    };
    let guard = Guard { evaluations: 3000, ..Guard::default() };
    let settings = Settings { method, estimate: false, guard, ..Settings::new(0.1, 50.0) };
    match simulation.run(&settings) {
        Ok(run) => {
            let numbers = run.motion.columns().concat();
            assert!(numbers.iter().all(|x| x.is_finite()), "a motion with {numbers:?}");
        }
        Err(error) => refused(&error),
    }
});

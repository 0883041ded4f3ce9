//! The scenes on a ground whose motion is known in closed form.

use super::{Scene, answers, over, springs, touches};
use crate::report::simulation::figures::{Faulty, G, built};
use solaris_model::{Figure, FigureError, Inertia, Joint, LinkSpec};
use solaris_modes::{ContactLaw, Simulation};

/// A mass (kg) in a plane with a moment of inertia (kg m²): along, up, and turning.
fn flat(mass: f64, inertia: f64) -> Result<Figure, FigureError> {
    let joint = Joint::new("root").tx().ty().rz();
    built(
        "body",
        [LinkSpec::root("body", joint).mass(mass).inertia(Inertia::diagonal(inertia, inertia, inertia))],
    )
}

/// All of them, those on springs first.
pub(in crate::report::simulation) fn all() -> Result<Vec<Scene>, Faulty> {
    let scene = |name: &str, duration, simulation, solution| Scene {
        name: name.to_owned(),
        simulation,
        duration,
        solution,
    };
    let slip = ContactLaw::SLIP;
    Ok(vec![
        scene(
            "springs: a block slides to rest",
            0.6,
            block()?,
            answers::sliding(2.0, 0.4 * G, slip, -G / STIFFNESS),
        ),
        scene(
            "springs: a ball slides until it rolls",
            0.3,
            ball()?,
            answers::rolling(2.0, 0.3 * G, slip, RADIUS, RADIUS - G / STIFFNESS),
        ),
        scene("springs: a mass bounces", 0.4, bouncing()?, answers::springing(HEIGHT, STIFFNESS.sqrt(), G)),
        scene("Rigid: a box drops", 0.4, dropped()?, answers::dropping(0.5, 0.1, G)),
        scene("Rigid: a rod tips over", 0.4, rod()?, answers::tipping(0.5, 0.2, G)),
        scene("Rigid: a block rocks", 0.8, rocking()?, answers::rocking(BLOCK[0], BLOCK[1], TILT, G)),
    ])
}

/// Of springs (N/m), under 1 kg.
const STIFFNESS: f64 = 1e4;
/// Of the ball (m).
const RADIUS: f64 = 0.1;
/// From which the bouncing mass falls (m).
const HEIGHT: f64 = 0.05;
/// Half width and half height of the block that rocks (m), and how far it is tilted to begin with (rad).
const BLOCK: [f64; 2] = [0.1, 0.3];
const TILT: f64 = 0.16;

/// 1 kg, as deep as its weight presses it, at 2 m/s.
fn block() -> Result<Simulation, Faulty> {
    let figure = built("block", [LinkSpec::root("block", Joint::new("root").tx().ty()).mass(1.0)])?;
    let law = (springs(STIFFNESS, ContactLaw::DAMPING), 0.4);
    over(&figure, law, touches(0, &[[0.0; 2]], 0.0), (&[0.0, -G / STIFFNESS], &[2.0, 0.0]))
}

/// The same for a solid ball that does not turn to begin with.
fn ball() -> Result<Simulation, Faulty> {
    let figure = flat(1.0, 0.4 * RADIUS * RADIUS)?;
    let law = (springs(STIFFNESS, ContactLaw::DAMPING), 0.3);
    let start = [0.0, RADIUS - G / STIFFNESS, 0.0];
    over(&figure, law, touches(0, &[[0.0; 2]], RADIUS), (&start, &[2.0, 0.0, 0.0]))
}

/// 1 kg that falls on springs without damping.
fn bouncing() -> Result<Simulation, Faulty> {
    let figure = built("mass", [LinkSpec::root("mass", Joint::new("fall").ty()).mass(1.0)])?;
    over(&figure, (springs(STIFFNESS, 0.0), 0.0), touches(0, &[[0.0; 2]], 0.0), (&[HEIGHT], &[0.0]))
}

fn dropped() -> Result<Simulation, Faulty> {
    let corners = touches(0, &[[-0.2, -0.1], [0.2, -0.1]], 0.0);
    over(&flat(3.0, 0.05)?, (ContactLaw::Rigid, 0.5), corners, (&[0.0, 0.6, 0.0], &[0.0; 3]))
}

/// A slim rod of 1 m on its lower end.
fn rod() -> Result<Simulation, Faulty> {
    let (l, tilt) = (0.5, 0.2_f64);
    let start = [l * tilt.sin(), l * tilt.cos(), -tilt];
    over(
        &flat(1.5, 1.5 * l * l / 3.0)?,
        (ContactLaw::Rigid, 0.5),
        touches(0, &[[0.0, -l]], 0.0),
        (&start, &[0.0; 3]),
    )
}

/// A uniform block on its right corner, to the right.
fn rocking() -> Result<Simulation, Faulty> {
    let [b, h] = BLOCK;
    let (alpha, r) = (b.atan2(h), b.hypot(h));
    let start = [-r * (alpha - TILT).sin(), r * (alpha - TILT).cos(), -TILT];
    let corners = touches(0, &[[-b, -h], [b, -h]], 0.0);
    over(&flat(2.0, 2.0 / 3.0 * r * r)?, (ContactLaw::Rigid, 1.0), corners, (&start, &[0.0; 3]))
}
